/* The legs of the vehicles as rows of a table, from the document alone: the columns and values of
 * `to_geodataframe` (exports/legs.py), with the lines that the map draws. */
// oxlint-disable-next-line no-unused-vars -- data.js calls it; the page holds both.
const planLegs = ({ plan, solos, platoons }) => {

const { schedule } = plan;
const credits = plan.provenance.credits.join(" \u00b7 ");
const nameOf = ({ name, letter }) => name || letter;

/* The clock of the document: moments in UTC, and as ISO 8601 in the offset that holds then. */
function clockOf({ start, offsets }) {
  const [, face, sign, hours, minutes] = /^(.{19})(?:\.\d+)?(?:([+-])(\d\d):(\d\d).*)?$/.exec(start);
  const zoned = sign !== undefined;
  const own = zoned ? (sign === "-" ? -60 : 60) * (Number(hours) * 60 + Number(minutes)) : 0;
  const first = Date.parse(`${face}Z`) - own * 1000;
  const moment = (at) => new Date(first + Math.round(at) * 1000);
  function iso(at) {
    const found = offsets.filter(([from]) => from <= Math.round(at)).pop() ?? offsets[0];
    const offset = found ? found[1] : own;
    const text = new Date(moment(at).getTime() + offset * 1000).toISOString().slice(0, 19);
    if (!zoned) return text;
    const size = Math.round(Math.abs(offset) / 60);
    const two = (number) => String(number).padStart(2, "0");
    return `${text}${offset < 0 ? "-" : "+"}${two(Math.floor(size / 60))}:${two(size % 60)}`;
  }
  return { zoned, iso, utc: (at) => `${moment(at).toISOString().slice(0, 19)}Z` };
}

const clock = schedule ? clockOf(schedule) : null;

/* Parts of a stretch meet in a point that both have. */
function lineOf(parts) {
  const points = parts.flatMap((part) => part.points);
  return points.filter(([lat, lon], i) =>
    i === 0 || lat !== points[i - 1][0] || lon !== points[i - 1][1]);
}

/* Minutes of breaks and rests in a gap between two legs. */
function breaksOf(index, begin, end) {
  const within = plan.events.filter((one) => (one.kind === "break" || one.kind === "rest")
    && one.vehicles.includes(index) && one.at_s > begin - 0.2 && one.until_s < end + 0.2);
  return within.reduce((sum, one) => sum + (one.until_s - one.at_s) / 60, 0);
}

function legsOf(index) {
  const vehicle = plan.vehicles[index];
  return vehicle.way.map(([kind, at], number) => {
    const together = kind === "platoon";
    const stretch = (together ? platoons : solos)[at];
    const share = together ? stretch.costs.find((one) => one.vehicle === index) : stretch;
    const others = together ? stretch.vehicles.filter((one) => one !== index) : [];
    const span = vehicle.times?.spans[number];
    const before = number ? vehicle.times?.spans[number - 1][1] : vehicle.times?.departure_s;
    return {
      span,
      line: lineOf(stretch.parts),
      row: {
        vehicle: nameOf(vehicle),
        vehicle_role: vehicle.role,
        leg: number + 1,
        role: stretch.access ? "access" : kind,
        partners: others.map((one) => nameOf(plan.vehicles[one])).sort().join(", "),
        origin: vehicle.origin.name,
        destination: vehicle.destination.name,
        roads: stretch.roads,
        length_m: stretch.length_m,
        time_s: stretch.drive_s,
        fuel_l: share.fuel_l,
        cost: together ? share.cost_platoon : share.cost,
        cost_unit: plan.cost_unit.name,
        inferred_m: stretch.inferred_m,
        attribution: credits,
        ...(span && {
          start_time: clock.iso(span[0]), end_time: clock.iso(span[1]), waiting_s: span[0] - before,
          break_before_min: breaksOf(index, before, span[0]),
        }),
      },
    };
  }).filter(({ line }) => line.length > 1);
}

return { clock, credits, nameOf, legsOf };
};
