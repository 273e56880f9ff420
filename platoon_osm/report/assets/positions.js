/* Where each vehicle is at a moment of the slider, and what it does there. */
// oxlint-disable-next-line no-unused-vars -- journey.js uses it.
function planPositions({ plan, map, solos, platoons }) {

const { number, say } = pageElements;

/* Points of a piece with the share of its length that lies before each. */
function measured(points) {
  const reached = [0];
  for (let i = 1; i < points.length; i++) {
    reached.push(reached[i - 1] + map.distance(points[i - 1], points[i]));
  }
  const whole = reached[reached.length - 1] || 1;
  return { points, shares: reached.map((metres) => metres / whole) };
}

/* A piece is measured when it is first driven. */
const known = { solo: [], platoon: [] };
const points = {
  solo: (at) => solos[at].parts.flatMap((part) => part.points),
  platoon: (at) => platoons[at].points,
};
const line = (kind, at) => (known[kind][at] ??= measured(points[kind](at)));

/* Each vehicle's pieces, with the metres driven before each. */
const ways = plan.vehicles.map((vehicle) => {
  let before = 0;
  return vehicle.way.map(([kind, at]) => {
    const piece = { kind, at, before, length: (kind === "solo" ? solos : platoons)[at].length_m };
    before += piece.length;
    return piece;
  });
});

function along({ points, shares }, share) {
  let [low, i] = [1, shares.length - 1];
  while (low < i) {
    const middle = (low + i) >> 1;
    if (shares[middle] < share) low = middle + 1;
    else i = middle;
  }
  const span = shares[i] - shares[i - 1] || 1;
  const part = Math.min(Math.max((share - shares[i - 1]) / span, 0), 1);
  const [a, b] = [points[i - 1], points[i]];
  return { latlng: L.latLng(a[0] + (b[0] - a[0]) * part, a[1] + (b[1] - a[1]) * part), from: a, to: b };
}

/* The scale of distance: all vehicles of a platoon count the same kilometres. */
function byDistance() {
  const { length_m: length, starts_m: starts, guide } = plan.journey;
  const text = (metres) => {
    const told = (key, far) => say(key, { km: number(far / 1000), who: plan.vehicles[guide]?.letter });
    if (guide === null) return told("driven", metres);
    const last = plan.vehicles[guide].length_m;
    const driven = metres - starts[guide];
    if (driven < -500) return told("before-start", -driven);
    if (driven > last + 500) return told("after-arrival", driven - last);
    return told("at-km", Math.min(Math.max(driven, 0), last));
  };
  /* Null before a vehicle starts and once it has arrived. */
  const place = (index, metres) => {
    const driven = metres - starts[index];
    if (driven < 1 || driven > plan.vehicles[index].length_m - 1) return null;
    const way = ways[index];
    // At a merge a vehicle counts as there already, at a separation as still there.
    const near = 1;
    const found = way.findIndex(
      (one) => driven <= one.before + one.length + (one.kind === "solo" ? -near : near),
    );
    const number = found < 0 ? way.length - 1 : found;
    const share = (driven - way[number].before) / (way[number].length || 1);
    const state = way[number].kind === "platoon" ? "state-together" : "state-alone";
    return { number, share: Math.min(Math.max(share, 0), 1), state };
  };
  return { begin: 0, end: length, step: 1000, text, place, doing: null };
}

const scale = plan.schedule ? dayByClock(plan) : byDistance();

function whereIs(index, at) {
  // Before the day begins all are where their marks stand.
  const found = at > scale.begin ? scale.place(index, at) : null;
  if (!found) return null;
  const piece = ways[index][found.number];
  return { piece, state: found.state, ...along(line(piece.kind, piece.at), found.share) };
}

return { scale, whereIs };
}
