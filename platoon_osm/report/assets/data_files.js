/* Files of some vehicles as text: CSV, GeoJSON and GPX. Other people's names are
 * escaped as each format has it; what a spreadsheet would run gets an apostrophe (csv_tables.py). */
// oxlint-disable-next-line no-unused-vars -- data.js calls it; the page holds both.
const planFiles = ({ plan, clock, credits, nameOf, legsOf }) => {

const { say, number } = pageElements;
const ends = (vehicle) => `${vehicle.origin.name} \u2013 ${vehicle.destination.name}`;

/* What happens to a vehicle, and when: places of the document's events, in driving order. */
function pointsOf(index) {
  const { origin, destination, times } = plan.vehicles[index];
  const events = plan.events
    .filter((one) => one.vehicles.includes(index) || one.others.includes(index))
    .map((one) => ({ ...one, own: one.vehicles.includes(index), title: say(`mark-${one.kind}`) }));
  return [
    { kind: "start", title: say("depart"), own: true, at_s: times?.departure_s, ...origin },
    ...events,
    { kind: "destination", title: say("arrive"), own: true, at_s: times?.arrival_s, ...destination },
  ];
}

// -- CSV ----------------------------------------------------------------------------------------

const PARTS = ";|\\t\\n\\v\\f\\r\\x85\\u2028\\u2029";
const SIGNS = "=+\\-@\\uff1d\\uff0b\\uff0d\\uff20\\ufe66\\ufe62\\ufe63\\ufe6b";
const UNSEEN = "\\x00-\\x08\\x0e-\\x20\"\\x7f-\\x84\\x86-\\xa0\\xad\\u034f\\u061c\\u115f\\u1160\\u1680" +
  "\\u17b4\\u17b5\\u180b-\\u180f\\u2000-\\u200f\\u202a-\\u202f\\u205f-\\u206f\\u2800\\u3000\\u3164" +
  "\\ufe00-\\ufe0f\\ufeff\\uffa0\\ufff0-\\ufffd\\u{1d173}-\\u{1d17a}\\u{e0000}-\\u{e0fff}";
const FORMULA = new RegExp(
  `^(?=[${PARTS}${UNSEEN}]*[${SIGNS}])|(?<=[${PARTS}])(?=[${UNSEEN}]*[${SIGNS}])`, "gu");

function cell(value) {
  if (typeof value === "number") return String(Number(value.toPrecision(6)));
  const safe = String(value).replace(FORMULA, "'");
  return /[",\n\r]/.test(safe) ? `"${safe.replaceAll('"', '""')}"` : safe;
}

function csv(chosen) {
  const rows = chosen.flatMap(legsOf).map(({ row }) => row);
  return [Object.keys(rows[0] ?? {}), ...rows.map((row) => Object.values(row))]
    .map((row) => `${row.map(cell).join(",")}\n`).join("");
}

// -- GeoJSON ------------------------------------------------------------------------------------

/* A line is cut where it crosses the antimeridian, as RFC 7946 asks for (network/antimeridian.py). */
function geometryOf(line) {
  const pieces = [[]];
  const put = (lon, lat) => pieces.at(-1).push([lon, lat]);
  const turnOf = (lon) => Math.floor((lon + 180) / 360);
  const outside = line.some(([, lon]) => Math.abs(lon) > 180);
  let turn = outside ? turnOf(line[0][1]) : 0;
  line.forEach(([lat, lon], i) => {
    while (outside && turn !== turnOf(lon)) {
      const [south, west] = line[i - 1];
      const side = Math.sign(turnOf(lon) - turn);
      const share = (360 * turn + 180 * side - west) / (lon - west);
      const at = Number((south + share * (lat - south)).toFixed(6));
      put(180 * side, at);
      turn += side;
      pieces.push([]);
      put(-180 * side, at);
    }
    put(turn ? Number((lon - 360 * turn).toFixed(6)) : lon, lat);
  });
  const lines = pieces.filter((piece) => new Set(piece.map(String)).size > 1);
  if (lines.length > 1) return { type: "MultiLineString", coordinates: lines };
  return { type: "LineString", coordinates: lines[0] ?? pieces[0] };
}

function geojson(chosen) {
  const features = chosen.flatMap(legsOf).map(({ row, line }) => ({
    type: "Feature",
    properties: row,
    geometry: geometryOf(line),
  }));
  return JSON.stringify({ type: "FeatureCollection", attribution: credits, features });
}

// -- GPX ----------------------------------------------------------------------------------------

const GPX = "http://www.topografix.com/GPX/1/1";

/* A moment for each point of a line, in proportion to the distance. */
function along(line, [begin, end]) {
  let driven = 0;
  const reached = line.map(([lat, lon], i) => {
    const [south, west] = line[Math.max(i - 1, 0)];
    driven += Math.hypot((lon - west) * Math.cos((south * Math.PI) / 180), lat - south);
    return driven;
  });
  return reached.map((one) => begin + ((end - begin) * one) / (driven || 1));
}

function gpx(chosen) {
  const file = document.implementation.createDocument(GPX, "gpx");
  const add = (parent, name, text, attributes = {}) => {
    const made = file.createElementNS(GPX, name);
    for (const [key, value] of Object.entries(attributes)) made.setAttribute(key, value);
    if (text !== undefined) made.textContent = text;
    parent.append(made);
    return made;
  };
  const degrees = (lat, lon) => ({ lat: lat.toFixed(6), lon: (lon - 360 * Math.round(lon / 360)).toFixed(6) });
  const stamped = (parent, at) => {
    if (clock?.zoned && typeof at === "number") add(parent, "time", clock.utc(at));
  };
  const root = file.documentElement;
  root.setAttribute("version", "1.1");
  root.setAttribute("creator", "platoon_osm");
  const about = add(root, "metadata");
  add(about, "name", plan.title);
  add(about, "desc", credits);
  add(about, "copyright", undefined, { author: credits });
  for (const index of chosen) {
    for (const { lat, lon, at_s: at, title, name, kind, own } of pointsOf(index)) {
      if (!own) continue;
      const point = add(root, "wpt", undefined, degrees(lat, lon));
      stamped(point, at);
      add(point, "name", `${title}: ${name}`);
      add(point, "type", kind);
    }
  }
  for (const index of chosen) {
    const vehicle = plan.vehicles[index];
    const track = add(root, "trk");
    add(track, "name", `${nameOf(vehicle)}: ${ends(vehicle)}`);
    const legs = legsOf(index);
    add(track, "desc", legs.map(({ row }) => {
      const km = say("driven", { km: number(row.length_m / 1000, row.length_m < 9950 ? 1 : 0) });
      return `${km} ${say(row.role === "platoon" ? "state-together" : "state-alone")}`;
    }).join("; "));
    for (const { line, span } of legs) {
      const segment = add(track, "trkseg");
      const moments = span ? along(line, span) : [];
      line.forEach(([lat, lon], i) => {
        stamped(add(segment, "trkpt", undefined, degrees(lat, lon)), moments[i]);
      });
    }
  }
  return `<?xml version="1.0" encoding="UTF-8"?>\n${new XMLSerializer().serializeToString(file)}\n`;
}

// -- names of files -----------------------------------------------------------------------------

const DEVICES = /^(con|prn|aux|nul|conin\$|conout\$|clock\$|(com|lpt)\d)$/;
const MOST_BYTES = 120;

/* Letters and digits of any script, in lower case; all else becomes a hyphen (file_names.py). */
function fileStem(name) {
  const words = name.normalize("NFKC").toLowerCase().split(/[^\p{L}\p{N}\p{M}]+/u)
    .map((word) => word.replace(/^\p{M}+/u, "")).filter(Boolean);
  let stem = words.join("-");
  while (new TextEncoder().encode(stem).length > MOST_BYTES) stem = [...stem].slice(0, -1).join("");
  stem = stem.normalize("NFC").replace(/^-+|-+$/g, "");
  if (!stem) return "vehicle";
  return DEVICES.test(stem) ? `vehicle-${stem}` : stem;
}

return { csv, geojson, gpx, fileStem };
};
