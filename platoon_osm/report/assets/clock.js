/* The day by the clock, for plans with times: where each vehicle is at a moment, and what it does. */
// oxlint-disable-next-line no-unused-vars -- journey.js uses it.
const dayByClock = (plan) => {

const { begin_s: begin, end_s: end, since_midnight_s: midnight, offsets } = plan.schedule;
const { clock, say } = pageElements;
const DAY_MIN = 24 * 60;

/* Times of the document are rounded to a tenth of a second. */
const NEAR = 0.06;

/* Who is held back for less is as good as gone. */
const WORTH_SAYING = 30;

/* The offset from UTC that holds at a moment; 0 where clocks do not change, for then none is needed. */
const offset = (at) => (offsets.filter(([from]) => from <= at + NEAR).pop() ?? offsets[0] ?? [0, 0])[1];

/* As a short name, for an hour that clocks show twice. */
function named(found) {
  const minutes = Math.round(Math.abs(found) / 60);
  const rest = minutes % 60;
  const part = rest ? ":" + String(rest).padStart(2, "0") : "";
  return `UTC${found < 0 ? "-" : "+"}${Math.floor(minutes / 60)}${part}`;
}

function text(seconds) {
  const shown = Math.round((midnight + seconds) / 60);
  const at = shown * 60 - midnight;
  const here = offset(at);
  const twice = offsets.some(([, other]) => other !== here && offset(at + here - other) === other);
  const minutes = shown + Math.round((here - offset(0)) / 60);
  const days = Math.floor(minutes / DAY_MIN);
  const minute = minutes - days * DAY_MIN;
  const two = (number) => String(number).padStart(2, "0");
  const hour = Math.floor(minute / 60);
  const time = clock === 12
    ? `${((hour + 11) % 12) + 1}:${two(minute % 60)}\u00a0${say(hour >= 12 ? "pm" : "am")}`
    : `${two(hour)}:${two(minute % 60)}`;
  const later = days ? ` ${days > 0 ? "+" : ""}${days} ${say("day")}` : "";
  return time + later + (twice ? " " + named(here) : "");
}

/* The piece a vehicle is on, as its number in the way, the share of it that is driven, and what the
 * vehicle does. Who waits stands where its next piece begins; who is held back, or has not left, at its
 * start. */
function place(index, at) {
  const { departure_s: departure, arrival_s: arrival, earliest_departure_s: ready, spans } = plan.vehicles[index].times;
  if (at < departure - NEAR) {
    const held = ready !== null && ready <= at + NEAR && departure - ready > WORTH_SAYING;
    return { number: 0, share: 0, state: held ? "state-held" : "state-not-left" };
  }
  if (at >= arrival - NEAR) return { number: spans.length - 1, share: 1, state: "state-arrived" };
  const next = spans.findIndex(([, last]) => at < last - NEAR);
  const [first, last] = spans[next];
  if (at < first - NEAR) {
    const why = plan.events.find(({ at_s: from, until_s: until, vehicles }) =>
      until && from <= at + NEAR && at < until && vehicles.includes(index));
    return { number: next, share: 0, state: why && why.kind !== "wait" ? `state-${why.kind}` : "state-waiting" };
  }
  const share = Math.min(Math.max((at - first) / (last - first || 1), 0), 1);
  const [kind] = plan.vehicles[index].way[next];
  return { number: next, share, state: kind === "platoon" ? "state-together" : "state-alone" };
}

const LISTED = 8;
const STATES = ["state-together", "state-alone", "state-break", "state-rest", "state-ban", "state-change", "state-waiting", "state-held", "state-not-left", "state-arrived"];

/* What all do, such as "A, B in platoon; C waiting"; a crowd is counted. */
function doing(at) {
  const found = new Map();
  plan.vehicles.forEach((vehicle, index) => {
    const { state, number } = place(index, at);
    const key = state === "state-together" ? `${state} ${vehicle.way[number][1]}` : state;
    found.set(key, { state, letters: [...(found.get(key)?.letters ?? []), vehicle.letter] });
  });
  const many = plan.vehicles.length > LISTED;
  const all = [...found.values()].sort((a, b) => STATES.indexOf(a.state) - STATES.indexOf(b.state));
  if (!many) return all.map(({ state, letters }) => `${letters.join(", ")} ${say(state)}`).join("; ");
  return STATES.map((state) => {
    const count = all.reduce((sum, one) => sum + (one.state === state ? one.letters.length : 0), 0);
    return count ? `${count} ${say(state)}` : "";
  }).filter(Boolean).join("; ");
}

return { begin, end, step: 60, text, place, doing };
};
