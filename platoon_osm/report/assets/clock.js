/* The day by the clock, for plans with times: where each vehicle is at a moment, and what it does. */
// oxlint-disable-next-line no-unused-vars -- journey.js uses it.
const dayByClock = (plan) => {

const { begin_s: begin, end_s: end, since_midnight_s: midnight } = plan.schedule;
const DAY_MIN = 24 * 60;

function text(seconds) {
  const minutes = Math.round((midnight + seconds) / 60);
  const days = Math.floor(minutes / DAY_MIN);
  const minute = minutes - days * DAY_MIN;
  const two = (number) => String(number).padStart(2, "0");
  return `${two(Math.floor(minute / 60))}:${two(minute % 60)}${days ? ` ${days > 0 ? "+" : ""}${days} d` : ""}`;
}

/* Times of the document are rounded to a tenth of a second. */
const NEAR = 0.06;

/* The piece a vehicle is on, as its number in the way, the share of it that is driven, and what the
 * vehicle does. Who waits stands where its next piece begins. */
function place(index, at) {
  const { departure_s: departure, arrival_s: arrival, spans } = plan.vehicles[index].times;
  if (at < departure - NEAR) return { number: 0, share: 0, state: "not yet left" };
  if (at >= arrival - NEAR) return { number: spans.length - 1, share: 1, state: "arrived" };
  const next = spans.findIndex(([, last]) => at < last - NEAR);
  const [first, last] = spans[next];
  if (at < first - NEAR) return { number: next, share: 0, state: "waiting" };
  const share = Math.min(Math.max((at - first) / (last - first || 1), 0), 1);
  const [kind] = plan.vehicles[index].way[next];
  return { number: next, share, state: kind === "platoon" ? "in platoon" : "alone" };
}

const LISTED = 8;
const STATES = ["in platoon", "alone", "waiting", "not yet left", "arrived"];

/* What all do, such as "A, B in platoon; C waiting"; a crowd is counted. */
function doing(at) {
  const found = new Map();
  plan.vehicles.forEach((vehicle, index) => {
    const { state, number } = place(index, at);
    const key = state === "in platoon" ? `${state} ${vehicle.way[number][1]}` : state;
    found.set(key, { state, letters: [...(found.get(key)?.letters ?? []), vehicle.letter] });
  });
  const many = plan.vehicles.length > LISTED;
  const all = [...found.values()].sort((a, b) => STATES.indexOf(a.state) - STATES.indexOf(b.state));
  if (!many) return all.map(({ state, letters }) => `${letters.join(", ")} ${state}`).join("; ");
  return STATES.map((state) => {
    const count = all.reduce((sum, one) => sum + (one.state === state ? one.letters.length : 0), 0);
    return count ? `${count} ${state}` : "";
  }).filter(Boolean).join("; ");
}

return { begin, end, step: 60, text, place, doing };
};
