/* The slider that moves the vehicles along their ways: by the clock if the plan has times, else by
 * distance. A moment on its scale is in seconds or metres. */
// oxlint-disable-next-line no-unused-vars -- page.js calls it; the page holds both.
function playJourney({ plan, map, solos, platoons, calm, drawn, isolated, hidden }) {

const box = document.querySelector(".journey");
if (!box) return null;
const slider = box.querySelector("input");
const button = box.querySelector("button");
const output = box.querySelector("output");
const states = box.querySelector(".states");

/* A crowd on one spot becomes one disc that counts it. */
const MOST_TOGETHER = 6;
const PLAY_MS = 24000;
const MOMENTS_TRIED = 60;

// -- where a vehicle is ---------------------------------------------------------------------------

/* Points of a piece with the share of its length that lies before each. */
function measured(points) {
  const reached = [0];
  for (let i = 1; i < points.length; i++) {
    reached.push(reached[i - 1] + map.distance(points[i - 1], points[i]));
  }
  const whole = reached[reached.length - 1] || 1;
  return { points, shares: reached.map((metres) => metres / whole) };
}

const lines = {
  solo: solos.map((solo) => measured(solo.parts.flatMap((part) => part.points))),
  platoon: platoons.map((one) => measured(one.points)),
};

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
  let i = 1;
  while (i < shares.length - 1 && shares[i] < share) i++;
  const span = shares[i] - shares[i - 1] || 1;
  const part = Math.min(Math.max((share - shares[i - 1]) / span, 0), 1);
  const [a, b] = [points[i - 1], points[i]];
  return { latlng: L.latLng(a[0] + (b[0] - a[0]) * part, a[1] + (b[1] - a[1]) * part), from: a, to: b };
}

/* The scale of distance: all vehicles of a platoon count the same kilometres. */
function byDistance() {
  const { length_m: length, starts_m: starts, guide } = plan.journey;
  const km = (metres) => `${Math.round(metres / 1000).toLocaleString("en")} km`;
  const text = (metres) => {
    if (guide === null) return km(metres);
    const { letter, length_m: last } = plan.vehicles[guide];
    const driven = metres - starts[guide];
    if (driven < -500) return `${km(-driven)} before ${letter} starts`;
    if (driven > last + 500) return `${km(driven - last)} after ${letter} arrives`;
    return `${letter} at km ${Math.round(Math.min(Math.max(driven, 0), last) / 1000)}`;
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
    const state = way[number].kind === "platoon" ? "in platoon" : "alone";
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
  return { piece, state: found.state, ...along(lines[piece.kind][piece.at], found.share) };
}

// -- discs ----------------------------------------------------------------------------------------

map.createPane("vehicles").style.zIndex = 650;
const layer = L.layerGroup().addTo(map);

/* What a disc wears when its vehicle does not drive: bars of a pause, or a tick. */
const BADGES = { waiting: "M-1.7 -2.4V2.4M1.7 -2.4V2.4", arrived: "M-2.6 0.2L-0.7 2.2L2.8 -2" };

function disc(vehicle, state) {
  const away = state === "not yet left";
  const text = drawn("text", {
    y: 3.9, "text-anchor": "middle", "font-size": vehicle.letter.length > 1 ? 9 : 11.5,
    "font-weight": 700, fill: away ? vehicle.colour : "#fff",
  });
  text.textContent = vehicle.letter;
  const rings = away
    ? [drawn("circle", { r: 11, fill: "#fff", stroke: vehicle.colour, "stroke-width": 2, "stroke-dasharray": "3.5 2.6" })]
    : [
      drawn("circle", { r: 12, fill: "#17202b" }), drawn("circle", { r: 10.6, fill: "#ffd54a" }),
      drawn("circle", { r: 9, fill: vehicle.colour }),
    ];
  const badge = BADGES[state]
    ? [drawn("g", { transform: "translate(9 -9)" },
      drawn("circle", { r: 6, fill: "#fff", stroke: "#17202b", "stroke-width": 1.2 }),
      drawn("path", { d: BADGES[state], fill: "none", stroke: "#17202b", "stroke-width": 1.9 }))]
    : [];
  return drawn("svg", { viewBox: "-13 -13 26 26", width: 26, height: 26 }, ...rings, text, ...badge);
}

function put(latlng, face, label, move, state) {
  const icon = L.divIcon({
    html: disc(face, state), className: "mark moving", iconSize: [26, 26],
    iconAnchor: [13 - move.x, 13 - move.y],
  });
  const made = L.marker(latlng, { icon, pane: "vehicles", keyboard: false, interactive: false });
  made.addTo(layer);
  made.getElement().setAttribute("role", "img");
  made.getElement().setAttribute("aria-label", isolated(label));
}

/* Trucks of one platoon stand in a column behind the point where they are. */
function behind({ from, to }, rank) {
  const [a, b] = [map.project(from), map.project(to)];
  const step = b.subtract(a);
  const far = Math.hypot(step.x, step.y) || 1;
  return L.point((-step.x / far) * rank * 21, (-step.y / far) * rank * 21);
}

function show(moment) {
  layer.clearLayers();
  const columns = new Map();
  plan.vehicles.forEach((vehicle, index) => {
    if (hidden.has(`vehicle-${index}`)) return;
    const place = whereIs(index, moment);
    if (!place) return;
    // Vehicles alone may still be at one spot, as some start together.
    const spot = `${place.latlng.lat.toFixed(3)} ${place.latlng.lng.toFixed(3)} ${place.state}`;
    const key = place.state === "in platoon" ? `platoon ${place.piece.at}` : spot;
    columns.set(key, [...(columns.get(key) ?? []), { vehicle, place }]);
  });
  for (const column of columns.values()) {
    const names = column.map(({ vehicle }) => vehicle.letter);
    const { state } = column[0].place;
    const label = `${names.join(", ")} ${state}`;
    if (column.length > MOST_TOGETHER) {
      const face = { letter: `${column.length}\u00d7`, colour: "#4d5560" };
      put(column[0].place.latlng, face, label, L.point(0, 0), state);
      continue;
    }
    column.forEach(({ vehicle, place }, rank) => {
      put(place.latlng, vehicle, label, behind(place, rank), state);
    });
  }
}

// -- the slider -----------------------------------------------------------------------------------

let at = scale.begin;

function moveTo(to) {
  at = Math.min(Math.max(to, scale.begin), scale.end);
  show(at);
  const doing = scale.doing ? scale.doing(at) : "";
  slider.value = (at - scale.begin) / scale.step;
  slider.setAttribute("aria-valuetext", [scale.text(at), doing].filter(Boolean).join(", "));
  output.textContent = scale.text(at);
  if (states) states.textContent = doing;
  map.fire("viewchange");
  for (const chart of document.querySelectorAll("svg.along")) {
    const { zero, end, from = 0, perSecond, perMetre, down } = chart.dataset;
    const line = chart.querySelector(".cursor");
    const x = Number(zero) + (at - Number(from)) * Number(perSecond ?? perMetre);
    // Time runs to the right, or down in a diagram of time and distance.
    for (const side of down === undefined ? ["x1", "x2"] : ["y1", "y2"]) line.setAttribute(side, x);
    line.classList.toggle("on", at > scale.begin && x >= Number(zero) && x <= Number(end) + 0.1);
  }
}

let playing = 0;

function stop() {
  cancelAnimationFrame(playing);
  playing = 0;
  button.classList.remove("playing");
  button.setAttribute("aria-label", "Play the journey");
}

function play() {
  if (at >= scale.end) moveTo(scale.begin);
  let last = performance.now();
  button.classList.add("playing");
  button.setAttribute("aria-label", "Pause the journey");
  const frame = (now) => {
    // Who asks for calm sees few steps instead of a glide.
    if (!calm.matches || now - last > 700) {
      moveTo(at + ((scale.end - scale.begin) * (now - last)) / PLAY_MS);
      last = now;
    }
    if (at >= scale.end) stop();
    else playing = requestAnimationFrame(frame);
  };
  playing = requestAnimationFrame(frame);
}

button.addEventListener("click", () => (playing ? stop() : play()));
slider.addEventListener("input", () => {
  stop();
  moveTo(scale.begin + Number(slider.value) * scale.step);
});
map.on("zoomend", () => show(at));
document.querySelector(".legend").addEventListener("change", () => show(at));
L.DomEvent.disableClickPropagation(box);
box.hidden = false;
moveTo(scale.begin);

/* Keep room for what will stand below the slider, so that the box covers no more as it plays. */
function steady() {
  if (!states) return;
  const now = states.textContent;
  states.style.minHeight = "0";
  let most = 0;
  for (let part = 0; part <= MOMENTS_TRIED; part++) {
    states.textContent = scale.doing(scale.begin + ((scale.end - scale.begin) * part) / MOMENTS_TRIED);
    most = Math.max(most, states.offsetHeight);
  }
  states.textContent = now;
  states.style.minHeight = `${most}px`;
}

/* A moment is counted from the beginning, in seconds or metres. */
return { at: () => at - scale.begin, moveTo: (moment) => { stop(); moveTo(scale.begin + moment); }, steady };
}
