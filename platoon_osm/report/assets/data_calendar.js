/* A calendar (RFC 5545) with the entries, the moments and the names of sheets/calendar.py, so that
 * who takes both has each event once. */
// oxlint-disable-next-line no-unused-vars -- data.js calls it; the page holds both.
const planCalendar = ({ plan, solos, platoons, clock, credits, nameOf }) => {

const { say } = pageElements;
const bytes = new TextEncoder();
const escaped = (text) => text.replace(/[\\;,]/g, "\\$&").replaceAll("\n", "\\n");

/* A line of more than 75 octets goes on behind a line end and a blank. */
function folded(line) {
  let size = 0;
  let text = "";
  for (const character of line) {
    const more = bytes.encode(character).length;
    if (size + more > 75) {
      text += "\r\n ";
      size = 1;
    }
    text += character;
    size += more;
  }
  return `${text}\r\n`;
}

const stamp = (moment) => moment.replace(/[-:]/g, "");

/* FNV-1a in 64 bits: a secure hash is not to be had on every page. */
function named(text) {
  let hash = 0xcbf29ce484222325n;
  for (const byte of bytes.encode(text)) {
    hash = BigInt.asUintN(64, (hash ^ BigInt(byte)) * 0x100000001b3n);
  }
  return hash.toString(16).padStart(16, "0");
}

function journeyOf(index) {
  const vehicle = plan.vehicles[index];
  const name = nameOf(vehicle);
  const namesakes = plan.vehicles.slice(0, index).filter((one) => nameOf(one) === name).length;
  const day = clock.iso(vehicle.times.departure_s).slice(0, 10);
  return named([name, vehicle.origin.name, vehicle.destination.name, day, namesakes].join("\0"));
}

const long = (begin, end) => Math.round(end * 10) - Math.round(begin * 10) >= 300;

/* Breaks, rests, bans and changes of drivers in a gap between two stretches; what they leave of it
 * are waits. */
function standsOf(index, begin, end) {
  const found = [];
  let at = begin;
  const told = plan.events.filter((one) => one.until_s !== null && one.vehicles.includes(index)
    && one.at_s > begin - 0.2 && one.until_s < end + 0.2);
  if (!told.some((one) => one.kind !== "wait")) return found;
  const wait = (until) => {
    if (long(at, until)) found.push({ kind: "wait", title: say("waits"), at, end: until });
  };
  for (const one of told.sort((a, b) => a.at_s - b.at_s)) {
    wait(one.at_s);
    found.push({ ...one, title: say(`mark-${one.kind}`), at: one.at_s, end: one.until_s });
    at = one.until_s;
  }
  wait(end);
  return found;
}

/* What happens to a vehicle where one stretch of its way goes over into another. */
function entriesOf(index) {
  const { way, times, origin, destination } = plan.vehicles[index];
  const stretches = way.map(([kind, at]) => (kind === "platoon" ? platoons : solos)[at]);
  const company = [[index], ...stretches.map((one) => one.vehicles ?? [index]), [index]];
  const last = stretches.length;
  return company.slice(1).flatMap((goes, number) => {
    const came = company[number];
    const reached = number ? times.spans[number - 1][1] : times.departure_s;
    const at = number < last ? times.spans[number][0] : reached;
    const found = [];
    const joined = goes.some((one) => !came.includes(one));
    const left = came.some((one) => !goes.includes(one));
    if (number === 0) found.push({ kind: "start", title: say("depart"), at, ...origin });
    else if (number === last) found.push({ kind: "end", title: say("arrive"), at, ...destination });
    else if (joined || left) {
      const kind = joined ? "merge" : "separation";
      const when = joined ? at : reached;
      const event = plan.events.find((one) => one.kind === kind && Math.abs(one.at_s - when) < 0.2
        && (one.vehicles.includes(index) || one.others.includes(index)));
      const [lat, lon] = stretches[number].parts[0].points[0];
      found.push({ lat, lon, name: "", ...event, kind, title: say(`mark-${kind}`), at });
    }
    const stands = number < last ? standsOf(index, reached, at) : [];
    if (stands.length) return [...stands.map((one) => ({ lat: 0, lon: 0, name: "", ...found[0], ...one })), ...found];
    if (found.length && long(reached, at)) {
      found.unshift({ ...found[0], kind: "wait", title: say("waits"), at: reached, end: at });
    }
    return found;
  });
}

/* In UTC where the plan's times have a zone, else as the clocks there show it. */
const moment = (at) => stamp(clock.zoned ? clock.utc(at) : clock.iso(at));

return (chosen) => {
  const lines = ["BEGIN:VCALENDAR", "VERSION:2.0", "PRODID:-//platoon_osm//page//EN"];
  for (const index of chosen) {
    const journey = journeyOf(index);
    const seen = {};
    for (const { kind, title, name, at, end, lat, lon, text, detail } of entriesOf(index)) {
      seen[kind] = (seen[kind] ?? 0) + 1;
      const what = [title, name].filter(Boolean).join(", ");
      lines.push(
        "BEGIN:VEVENT",
        `UID:${journey}-${kind}-${seen[kind]}@platoon-osm`,
        `DTSTAMP:${stamp(clock.utc(0))}`,
        `DTSTART:${moment(at)}`,
        ...(end === undefined ? [] : [`DTEND:${moment(end)}`]),
        "SUMMARY:" + escaped(`${nameOf(plan.vehicles[index])}: ${what}`),
        `LOCATION:${escaped(name)}`,
        `GEO:${lat};${Math.abs(lon) > 180 ? Number((lon - 360 * Math.round(lon / 360)).toFixed(6)) : lon}`,
        `DESCRIPTION:${escaped([text, detail, credits].filter(Boolean).join("\n"))}`,
        "END:VEVENT",
      );
    }
  }
  return [...lines, "END:VCALENDAR"].map(folded).join("");
};
};
