/* The live map of a plan. It reads one JSON document (docs/report.md) and a Leaflet map named
 * map_plan that the lines above have made. Text reaches the page through textContent alone. */
(() => {
"use strict";

const plan = JSON.parse(document.getElementById("plan-data").textContent);
const map = window.map_plan;
const frame = map.getContainer();
const SVG = "http://www.w3.org/2000/svg";
const BASEMAP_STEPS = 1e4;
const ROUTE_STEPS = 1e5;
const calm = window.matchMedia("(prefers-reduced-motion: reduce)");

document.documentElement.classList.add("live");

// -- small makers ---------------------------------------------------------------------------------

function element(tag, name, text) {
  const made = document.createElement(tag);
  if (name) made.className = name;
  if (text !== undefined) made.textContent = text;
  return made;
}

function drawn(tag, attributes, ...children) {
  const made = document.createElementNS(SVG, tag);
  for (const [key, value] of Object.entries(attributes)) made.setAttribute(key, value);
  made.append(...children);
  return made;
}

/* A name between a first strong isolate and its end, for places that take no elements. */
const isolated = (text) => `\u2068${text}\u2069`;

// -- lines ----------------------------------------------------------------------------------------

function decoded(text, steps) {
  const points = [];
  let at = 0;
  let lat = 0;
  let lon = 0;
  const next = () => {
    let value = 0;
    let shift = 0;
    let bits;
    do {
      bits = text.charCodeAt(at++) - 63;
      value |= (bits & 31) << shift;
      shift += 5;
    } while (bits >= 32);
    return value & 1 ? ~(value >> 1) : value >> 1;
  };
  while (at < text.length) {
    lat += next();
    lon += next();
    points.push([lat / steps, lon / steps]);
  }
  return points;
}

/* Many lines in one text, each counted from the first point of the one before. */
function decodedLines(text, steps) {
  let start = [0, 0];
  return text.split(" ").filter(Boolean).map((line) => {
    const points = decoded(line, steps).map(([lat, lon]) => [lat + start[0], lon + start[1]]);
    start = points[0];
    return points;
  });
}

/* The line `aside` pixels to the right of a line of pixels; corners are mitred within limits. */
function shifted(points, aside) {
  const line = points.filter((p, i) => i === 0 || !p.equals(points[i - 1]));
  if (!aside || line.length < 2) return line;
  const normals = [];
  for (let i = 1; i < line.length; i++) {
    const step = line[i].subtract(line[i - 1]);
    const length = Math.hypot(step.x, step.y);
    normals.push(L.point(-step.y / length, step.x / length));
  }
  return line.map((p, i) => {
    const mitre = normals[Math.max(i - 1, 0)].add(normals[Math.min(i, normals.length - 1)]);
    // |mitre| is 2 cos(half the turn): beyond 120 degrees it would run away.
    const square = Math.max(mitre.x ** 2 + mitre.y ** 2, 1);
    return p.add(mitre.multiplyBy((2 * aside) / square));
  });
}

/* Lines of more vehicles than this are too thin for dashes: their band is a plain ribbon. */
const CROWD = 8;

/* On a small screen the band would hide the country, so all lines of a platoon are finer. */
const fine = () => (frame.clientWidth < 600 ? 0.62 : 1);

function lineStep(vehicles) {
  return Math.min(6, 36 / vehicles) * fine();
}

const bandWidth = (vehicles) => 6 * fine() + lineStep(vehicles) * vehicles;

/* Several bands side by side, casings included. */
const bandsWidth = (beside) => beside.reduce((sum, count) => sum + bandWidth(count) + 2, 0);

/* How far right of the road a band's middle lies, so that all bands on it show. */
function bandAside(part) {
  const own = bandsWidth(part.beside.slice(part.place, part.place + 1));
  return bandsWidth(part.beside.slice(0, part.place)) + own / 2 - bandsWidth(part.beside) / 2;
}

/* Vehicles alone on one road lie side by side, the finer the more they are. */
const soloStep = (slots) => Math.min(7, 26 / Math.max(slots - 1, 1)) * fine();

function soloAside(part) {
  const step = soloStep(part.slots);
  if (part.bands.length) return bandsWidth(part.bands) / 2 + 4 + step * part.slot;
  return (part.slot - (part.slots - 1) / 2) * step;
}

// -- panes, bottom to top -------------------------------------------------------------------------

const panes = ["network", "junctions", "routes", "platoons", "names", "callouts"];
panes.forEach((name, i) => {
  map.createPane(name).style.zIndex = 300 + 20 * i;
});
map.getPane("names").classList.add("leaflet-zoom-hide");
map.getPane("callouts").classList.add("leaflet-zoom-hide");
for (const name of ["network", "names", "callouts"]) map.getPane(name).style.pointerEvents = "none";

/* Names of the layers that the legend has switched off. */
const hidden = new Set();

const groups = {};
const group = (name) => (groups[name] ??= L.layerGroup().addTo(map));

/* What a mark or line says when it is pointed at: a head, lines, and perhaps a table. */
function tooltip({ head, lines, columns = [], rows = [], more = "" }) {
  const box = element("div", "tip");
  box.append(element("bdi", "head", head));
  for (const line of lines) if (line) box.append(element("bdi", "line", line));
  if (rows.length) {
    const table = element("table");
    for (const [kind, cells] of [["th", columns], ...rows.map((row) => ["td", row])]) {
      const row = element("tr");
      cells.forEach((text, i) => row.append(element(i ? kind : "th", "", text)));
      table.append(row);
    }
    box.append(table);
  }
  if (more) box.append(element("bdi", "line", more));
  return box;
}

/* Let a line be reached by keyboard; Leaflet shows its tooltip while it has the focus. */
function reachable(line, tip) {
  line.on("add", () => {
    const path = line.getElement();
    path.setAttribute("tabindex", "0");
    path.setAttribute("role", "img");
    path.setAttribute("aria-label", isolated([tip.head, ...tip.lines].join(", ")));
  });
  return line.bindTooltip(tooltip(tip), { sticky: true, opacity: 1 });
}

// -- the view -------------------------------------------------------------------------------------

const solos = plan.solos.map((solo) => ({
  ...solo,
  parts: solo.parts.map((part) => ({ ...part, points: decoded(part.line, ROUTE_STEPS) })),
}));
const platoons = plan.platoons.map((one) => {
  const parts = one.parts.map((part) => ({ ...part, points: decoded(part.line, ROUTE_STEPS) }));
  return { ...one, parts, points: parts.flatMap((part) => part.points) };
});

const planBounds = L.latLngBounds([]);
for (const solo of solos) for (const part of solo.parts) planBounds.extend(part.points);
for (const one of platoons) planBounds.extend(one.points);
for (const vehicle of plan.vehicles) {
  for (const stop of [vehicle.origin, vehicle.destination]) planBounds.extend([stop.lat, stop.lon]);
}

/* Show the whole plan: as large as may be, but moved aside if it would lie under the legend. */
function showPlan() {
  const small = frame.clientWidth < 600;
  const edge = small ? 26 : 44;
  const legend = document.getElementById("legend");
  const taken = small ? 0 : legend.offsetWidth;
  const choices = [[edge, edge], [edge, taken + edge]];
  for (const [left, right] of choices) {
    map.fitBounds(planBounds, {
      paddingTopLeft: [left, small ? edge + 34 : edge],
      paddingBottomRight: [right, edge + (small ? 14 : 6)],
      maxZoom: 13,
      animate: false,
    });
    if (!taken || !underLegend(legend)) break;
  }
}

function underLegend(legend) {
  const base = frame.getBoundingClientRect();
  const box = legend.getBoundingClientRect();
  const inside = (latlng) => {
    const p = map.latLngToContainerPoint(latlng);
    return (
      p.x > box.left - base.left - 16 && p.x < box.right - base.left + 16 &&
      p.y > box.top - base.top - 16 && p.y < box.bottom - base.top + 16
    );
  };
  return (
    platoons.some((one) => one.points.some(inside)) ||
    solos.some((solo) => solo.parts.some((part) => part.points.some(inside)))
  );
}

// -- background -----------------------------------------------------------------------------------

function drawBackground() {
  const renderer = L.canvas({ pane: "network", padding: 0.3 });
  const known = decodedLines(plan.basemap.known, BASEMAP_STEPS);
  const inferred = decodedLines(plan.basemap.inferred, BASEMAP_STEPS);
  const style = { pane: "network", renderer, interactive: false, smoothFactor: 1.2 };
  L.polyline(known, { ...style, color: "#b3bcc8", weight: 3.8, opacity: 1 }).addTo(group("network"));
  L.polyline(known, { ...style, color: "#fff", weight: 1.8, opacity: 1 }).addTo(group("network"));
  L.polyline(inferred, { ...style, color: "#8a5a83", weight: 2, opacity: 1, dashArray: "5 4" })
    .addTo(group("inferred"));
  if (plan.tiles) {
    L.tileLayer(plan.tiles.url, { maxNativeZoom: plan.tiles.max_zoom, maxZoom: 18 }).addTo(map);
  }
}

const NEAR_ZOOM = 8.75;

function drawJunctions() {
  const renderer = L.canvas({ pane: "junctions", padding: 0.3 });
  const dots = L.layerGroup();
  for (const [lon, lat, name] of plan.junctions) {
    L.circleMarker([lat / BASEMAP_STEPS, lon / BASEMAP_STEPS], {
      pane: "junctions", renderer, radius: 3.2, color: "#5a6675", weight: 1.4, opacity: 1,
      fillColor: "#fff", fillOpacity: 1,
    })
      .bindTooltip(element("bdi", "", name), { direction: "top", opacity: 1 })
      .addTo(dots);
  }
  const byZoom = () => {
    const near = map.getZoom() >= NEAR_ZOOM;
    if (near !== group("junctions").hasLayer(dots)) {
      if (near) group("junctions").addLayer(dots);
      else group("junctions").removeLayer(dots);
    }
  };
  map.on("zoomend", byZoom);
  byZoom();
}

// -- routes ---------------------------------------------------------------------------------------

const svg = {
  routes: L.svg({ pane: "routes", padding: 0.5 }),
  platoons: L.svg({ pane: "platoons", padding: 0.5 }),
};
const redraws = [];

function routeLine(pane, name, style, tip) {
  const made = L.polyline([], {
    pane, renderer: svg[pane], lineCap: "butt", lineJoin: "round", opacity: 1, smoothFactor: 0,
    interactive: Boolean(tip), className: tip ? "route" : "", ...style,
  });
  if (tip) reachable(made, tip);
  return made.addTo(group(name));
}

/* Pixels of this zoom, without points that make no difference to the eye. */
function pixels(points, tolerance) {
  return L.LineUtil.simplify(points.map((at) => map.project(at)), tolerance);
}

const back = (points) => points.map((p) => map.unproject(p));

/* One weight along the whole stretch: that of its most crowded part. */
function soloWeight(solo) {
  const slots = Math.max(...solo.parts.map((part) => part.slots));
  return Math.max(1.4, Math.min(4, soloStep(slots) * 0.8 / fine()));
}

function drawSolos() {
  // All casings lie under all lines, or one vehicle's casing would cut another's line.
  const casings = solos.map((solo) =>
    routeLine("routes", `vehicle-${solo.vehicle}`, { color: "#fff", weight: soloWeight(solo) + 4 }));
  for (const text of plan.inferred_routes) {
    L.polyline(decoded(text, ROUTE_STEPS), {
      pane: "routes", renderer: svg.routes, color: "#8a5a83", weight: 14, opacity: 1,
      dashArray: "6 4", lineCap: "butt", interactive: false,
    }).addTo(group("inferred"));
  }
  solos.forEach((solo, i) => {
    const vehicle = plan.vehicles[solo.vehicle];
    const line = routeLine("routes", `vehicle-${solo.vehicle}`, {
      color: vehicle.colour, weight: soloWeight(solo), dashArray: vehicle.dash || null,
      lineCap: vehicle.cap,
    }, solo.tip);
    redraws.push(() => {
      const points = back(solo.parts.flatMap((part) => shifted(pixels(part.points, 0.7), soloAside(part))));
      casings[i].setLatLngs(points);
      line.setLatLngs(points);
    });
  });
}

function drawPlatoons() {
  // The order of making is the order of drawing: all bands, then all lines over them.
  const bands = platoons.map((one) => ({
    casing: routeLine("platoons", "platoon", { color: "#8a6a00" }),
    band: routeLine("platoons", "platoon", { color: "#ffd54a" }, one.tip),
  }));
  platoons.forEach((one, i) => {
    const count = one.vehicles.length;
    const lines = one.vehicles.map((index) => {
      const vehicle = plan.vehicles[index];
      return routeLine("platoons", `vehicle-${index}`, {
        color: vehicle.colour, lineCap: vehicle.cap,
        dashArray: (count <= CROWD && vehicle.dash) || null,
      });
    });
    redraws.push(() => {
      // A line beside another needs gentle corners, so it follows the road less closely.
      const roads = one.parts.map((part) => [pixels(part.points, 1.6), bandAside(part)]);
      const beside = (aside) => back(roads.flatMap(([road, band]) => shifted(road, band + aside)));
      const width = bandWidth(count);
      const step = lineStep(count);
      bands[i].band.setStyle({ weight: width }).setLatLngs(beside(0));
      bands[i].casing.setStyle({ weight: width + 2 }).setLatLngs(beside(0));
      lines.forEach((line, place) => {
        line.setStyle({ weight: Math.min(4, step * 0.68) });
        line.setLatLngs(beside((place - (count - 1) / 2) * step));
      });
    });
  });
}

const redraw = () => redraws.forEach((each) => each());

// -- marks ----------------------------------------------------------------------------------------

function mark(latlng, picture, size, label, name, options) {
  const icon = L.divIcon({ html: picture, className: `mark ${name}`, iconSize: [size, size] });
  const made = L.marker(latlng, { icon, title: "", riseOnHover: true, ...options });
  made.on("add", () => {
    made.getElement().setAttribute("role", "button");
    made.getElement().setAttribute("aria-label", isolated(label));
  });
  return made;
}

function endPicture(vehicle, square) {
  const shape = square
    ? drawn("rect", { x: -9.5, y: -9.5, width: 19, height: 19, rx: 3, fill: vehicle.colour })
    : drawn("circle", { r: 10, fill: vehicle.colour });
  const text = drawn("text", {
    y: 3.9, "text-anchor": "middle", "font-size": vehicle.letter.length > 1 ? 9 : 11.5,
    "font-weight": 700, fill: "#fff",
  });
  text.textContent = vehicle.letter;
  shape.setAttribute("stroke", "#fff");
  shape.setAttribute("stroke-width", 2);
  return drawn("svg", { viewBox: "-12 -12 24 24", width: 24, height: 24 }, shape, text);
}

function eventPicture(event) {
  const use = drawn("use", { href: `#icon-${event.kind}` });
  return drawn("svg", { viewBox: "-13 -13 26 26", width: 28, height: 28 }, use);
}

const marks = [];
const eventMarks = [];

/* More ends on one spot than this become one mark that counts them. */
const MOST_ENDS = 3;

function drawEnds(stopOf, word, square) {
  const spots = new Map();
  plan.vehicles.forEach((vehicle, index) => {
    const stop = stopOf(vehicle);
    const key = `${stop.lat} ${stop.lon}`;
    spots.set(key, [...(spots.get(key) ?? []), index]);
  });
  for (const indexes of spots.values()) {
    const together = indexes.length > MOST_ENDS ? [indexes] : indexes.map((index) => [index]);
    for (const who of together) {
      const vehicles = who.map((index) => plan.vehicles[index]);
      const stop = stopOf(vehicles[0]);
      const face = who.length > 1 ? { colour: "#4d5560", letter: `${who.length}\u00d7` } : vehicles[0];
      const letters = vehicles.map((vehicle) => vehicle.letter).join(", ");
      const label = `${letters} ${who.length > 1 ? word.replace("s ", " ") : word} ${isolated(stop.name)}`;
      const made = mark([stop.lat, stop.lon], endPicture(face, square), 24, label, "end", {
        zIndexOffset: 200,
      });
      made.bindTooltip(element("bdi", "", label), { direction: "top", offset: [0, -10], opacity: 1 });
      marks.push({ made, layer: "ends", who, size: 24 });
    }
  }
}

function drawMarks() {
  drawEnds((vehicle) => vehicle.origin, "starts at", false);
  drawEnds((vehicle) => vehicle.destination, "arrives at", true);
  plan.events.forEach((event) => {
    const head = `${event.kind === "merge" ? "Merge" : "Separation"}: ${event.name}`;
    const made = mark([event.lat, event.lon], eventPicture(event), 28, `${head}, ${event.text}`,
      "event-mark", { zIndexOffset: 400 });
    const tip = tooltip({ head, lines: [event.text, event.detail] });
    made.bindTooltip(tip, { direction: "top", offset: [0, -12], opacity: 1 });
    eventMarks.push(made);
    marks.push({ made, layer: event.kind, who: event.vehicles, size: 28 });
  });
  showMarks();
}

/* A mark is there while its layer is, and any of its vehicles. */
function showMarks() {
  for (const { made, layer, who } of marks) {
    const wanted = !hidden.has(layer) && who.some((index) => !hidden.has(`vehicle-${index}`));
    if (wanted) made.addTo(map);
    else made.remove();
  }
}

/* Places round a spot, near ones first; sideways before up and down. */
const fan = [];
for (let x = -3; x <= 3; x++) for (let y = -3; y <= 3; y++) fan.push([x, y]);
fan.sort((a, b) => Math.hypot(a[0], 1.3 * a[1]) - Math.hypot(b[0], 1.3 * b[1]) || b[0] - a[0] || a[1] - b[1]);

/* Marks on one spot are fanned out, so that every letter can be read; a crowd may still touch. */
function spreadMarks() {
  const taken = [];
  for (const { made, size } of marks) {
    if (!map.hasLayer(made)) continue;
    const at = map.latLngToLayerPoint(made.getLatLng());
    const places = fan.map(([x, y]) => at.add([x * (size - 3), y * (size - 3)]));
    const free = (one) =>
      taken.every((p) => Math.abs(p.x - one.x) > size - 5 || Math.abs(p.y - one.y) > size - 5);
    const place = places.find(free) ?? at;
    taken.push(place);
    const icon = made.getElement();
    if (!icon) continue;
    icon.style.marginLeft = `${place.x - at.x - size / 2}px`;
    icon.style.marginTop = `${place.y - at.y - size / 2}px`;
  }
}

// -- what is taken: a grid of small cells ---------------------------------------------------------

const CELL = 5;
/* A line may be covered at need, marks and texts never; texts also want room between them. */
const SOLID = 1e3;
const TEXT = 1e6;

class Cover {
  constructor() {
    this.weights = new Map();
  }

  key(x, y) {
    return Math.floor(x / CELL) * 1048576 + Math.floor(y / CELL);
  }

  addLine(points, weight) {
    for (let i = 1; i < points.length; i++) {
      const [a, b] = [points[i - 1], points[i]];
      const steps = Math.max(1, Math.ceil(Math.hypot(b.x - a.x, b.y - a.y) / CELL));
      for (let s = 0; s <= steps; s++) {
        const key = this.key(a.x + ((b.x - a.x) * s) / steps, a.y + ((b.y - a.y) * s) / steps);
        this.weights.set(key, Math.max(this.weights.get(key) ?? 0, weight));
      }
    }
  }

  addBox(box, weight) {
    this.over(box, (key, old) => this.weights.set(key, old + weight));
  }

  cost(box) {
    let sum = 0;
    this.over(box, (_, weight) => {
      sum += weight;
    });
    return sum;
  }

  /* Infinite if another text lies within the room that a box wants round itself. */
  crowding({ x, y, w, h, room }) {
    const wide = { x: x - room, y: y - room / 2, w: w + 2 * room, h: h + room };
    return this.cost(wide) >= TEXT ? Infinity : 0;
  }

  over(box, visit) {
    for (let x = Math.floor(box.x / CELL); x <= Math.floor((box.x + box.w) / CELL); x++) {
      for (let y = Math.floor(box.y / CELL); y <= Math.floor((box.y + box.h) / CELL); y++) {
        const key = x * 1048576 + y;
        visit(key, this.weights.get(key) ?? 0);
      }
    }
  }

  /* The candidate that covers least, taken; null if each would cover `most` or more. */
  place(candidates, most) {
    let best = null;
    let least = most;
    for (const box of candidates) {
      if (box.own >= least) continue;
      const cost = this.cost(box) + box.own + (box.room ? this.crowding(box) : 0);
      if (cost < least) [best, least] = [box, cost];
    }
    if (best) this.addBox(best, TEXT);
    return best;
  }
}

// -- callouts and names ---------------------------------------------------------------------------

const texts = element("canvas").getContext("2d");
const family = getComputedStyle(document.body).fontFamily;

function textWidth(text, font) {
  texts.font = `${font} ${family}`;
  return texts.measureText(text).width;
}

let settled = null;

/* Lay out callouts, then names, for this zoom. Both hold while the map is only moved a little. */
function arrange() {
  const view = map.getBounds().pad(0.75);
  settled = { zoom: map.getZoom(), view, size: map.getSize() };
  const cover = new Cover();
  const inLayer = (points) => points.map((at) => map.latLngToLayerPoint(at));
  for (const solo of solos) {
    if (hidden.has(`vehicle-${solo.vehicle}`)) continue;
    for (const part of solo.parts) cover.addLine(inLayer(part.points), 2);
  }
  for (const one of platoons) {
    const half = bandWidth(one.vehicles.length) / 2;
    for (const part of one.parts) {
      const road = pixels(part.points, 1.6);
      for (const share of [-1, -0.5, 0, 0.5, 1]) {
        cover.addLine(inLayer(back(shifted(road, bandAside(part) + share * half))), 4);
      }
    }
  }
  for (const { made, size } of marks) {
    const icon = made.getElement();
    if (!icon) continue;
    const at = map.latLngToLayerPoint(made.getLatLng());
    const left = at.x + parseFloat(icon.style.marginLeft || -size / 2);
    const top = at.y + parseFloat(icon.style.marginTop || -size / 2);
    cover.addBox({ x: left, y: top, w: size, h: size }, SOLID);
  }
  const base = frame.getBoundingClientRect();
  for (const part of document.querySelectorAll(".map .legend-box, .leaflet-control, .map .credit, .journey")) {
    const box = part.getBoundingClientRect();
    const at = map.containerPointToLayerPoint([box.left - base.left, box.top - base.top]);
    cover.addBox({ x: at.x - 4, y: at.y - 4, w: box.width + 8, h: box.height + 8 }, SOLID);
  }
  arrangeCallouts(cover);
  arrangeNames(cover, view);
}

/* Boxes all round a point, near ones first; `own` is what a place costs before it covers anything. */
function* around(at, w, h) {
  for (const away of [16, 24, 34, 46, 62, 84, 112]) {
    const own = away * 0.9;
    for (const share of [-1, -0.85, -0.65, -0.5, -0.35, -0.15, 0]) {
      const x = at.x + share * w + (share === 0 ? 0.4 : share === -1 ? -0.4 : 0) * away;
      yield { x, y: at.y - h - away, w, h, own };
      yield { x, y: at.y + away, w, h, own: own + 1 };
    }
    yield { x: at.x + away, y: at.y - h / 2, w, h, own };
    yield { x: at.x - away - w, y: at.y - h / 2, w, h, own };
  }
}

/* Would a text whose point is in view run out of it? */
function leavesView(at, box) {
  const low = map.containerPointToLayerPoint([0, 0]);
  const high = low.add(map.getSize());
  const seen = at.x > low.x && at.y > low.y && at.x < high.x && at.y < high.y;
  return seen && (box.x < low.x || box.y < low.y || box.x + box.w > high.x || box.y + box.h > high.y);
}

function arrangeCallouts(cover) {
  const pane = map.getPane("callouts");
  pane.replaceChildren();
  // A small screen has no room for them: there the list below the map says the same.
  if (frame.clientWidth < 600) return;
  const callouts = [];
  plan.events.forEach((event, index) => {
    if (!map.hasLayer(eventMarks[index])) return;
    const at = map.latLngToLayerPoint([event.lat, event.lon]);
    const box = element("div", "callout");
    const head = element("b", "", event.kind === "merge" ? "Merge: " : "Separation: ");
    head.append(element("bdi", "", event.name));
    box.append(head, element("span", "", event.text));
    pane.append(box);
    const [w, h] = [box.offsetWidth, box.offsetHeight];
    const choices = [...around(at, w, h)].filter((one) => !leavesView(at, one));
    callouts.push({ box, at, w, h, choices, place: cover.place(choices, SOLID) });
  });
  // The first to choose may stand in the way of the others: let each choose again, twice.
  for (let round = 0; round < 2; round++) {
    for (const one of callouts) {
      if (one.place) cover.addBox(one.place, -TEXT);
      one.place = cover.place(one.choices, SOLID);
    }
  }
  for (const { box, at, w, h, place } of callouts) {
    if (!place) {
      box.remove();
      continue;
    }
    L.DomUtil.setPosition(box, L.point(place.x, place.y).round());
    const near = L.point(
      Math.min(Math.max(at.x, place.x + 6), place.x + w - 6),
      Math.min(Math.max(at.y, place.y), place.y + h),
    );
    if (near.distanceTo(at) > 22) pane.prepend(leader(at, near));
  }
}

function leader(from, to) {
  const low = L.point(Math.min(from.x, to.x) - 2, Math.min(from.y, to.y) - 2).round();
  const [a, b] = [from.subtract(low), to.subtract(low)];
  const made = drawn("svg", {
    class: "leader", width: Math.abs(from.x - to.x) + 4, height: Math.abs(from.y - to.y) + 4,
  }, drawn("line", { x1: a.x, y1: a.y, x2: b.x, y2: b.y, stroke: "#5a6675" }));
  L.DomUtil.setPosition(made, low);
  return made;
}

function* namesHere() {
  const zoom = map.getZoom();
  const least = [0, 6.5, 9.5];
  // From afar a few names orient better than many.
  const room = zoom < NEAR_ZOOM ? [8, 26, 0] : [4, 8, 8];
  for (const [lon, lat, name, rank] of plan.towns) {
    if (zoom >= least[rank]) {
      yield { lon, lat, name, room: room[rank], kind: rank ? "town" : "city" };
    }
  }
  if (zoom < NEAR_ZOOM) return;
  for (const [lon, lat, name] of plan.junctions) yield { lon, lat, name, room: 4, kind: "junction" };
}

const LONGEST_NAME_PX = 150;

function arrangeNames(cover, view) {
  const pane = map.getPane("names");
  pane.replaceChildren();
  if (hidden.has("names")) return;
  const made = document.createDocumentFragment();
  // Names may touch a line where the map is small, or hardly any would find a place.
  const most = frame.clientWidth < 600 ? 14 : 6;
  for (const { lon, lat, name, room, kind } of namesHere()) {
    const latlng = L.latLng(lat / BASEMAP_STEPS, lon / BASEMAP_STEPS);
    if (!view.contains(latlng)) continue;
    const at = map.latLngToLayerPoint(latlng);
    const font = kind === "junction" ? "11px" : "12.5px";
    const w = Math.min(Math.ceil(textWidth(name, font)) + 2, LONGEST_NAME_PX) + 6;
    const h = 17;
    const choices = [
      { x: at.x - w / 2, y: at.y - h - 5, w, h, own: 0 },
      { x: at.x - w / 2, y: at.y + 5, w, h, own: 0.3 },
      { x: at.x + 6, y: at.y - h / 2, w, h, own: 0.4 },
      { x: at.x - w - 6, y: at.y - h / 2, w, h, own: 0.5 },
      { x: at.x + 4, y: at.y - h - 4, w, h, own: 0.6 },
      { x: at.x - w - 4, y: at.y + 4, w, h, own: 0.7 },
      { x: at.x - w / 2, y: at.y - h - 14, w, h, own: 1.4 },
      { x: at.x - w / 2, y: at.y + 14, w, h, own: 1.5 },
    ].filter((one) => !leavesView(at, one)).map((one) => ({ ...one, room }));
    const place = cover.place(choices, most);
    if (!place) continue;
    const label = element("div", `name ${kind}`);
    label.append(element("bdi", "", name));
    label.style.width = `${w}px`;
    L.DomUtil.setPosition(label, L.point(place.x, place.y).round());
    made.append(label);
  }
  pane.append(made);
}

// -- controls -------------------------------------------------------------------------------------

function wireLegend() {
  const boxes = [...document.querySelectorAll("[data-layer]")];
  const apply = (box) => {
    const layers = groups[box.dataset.layer];
    if (box.checked) hidden.delete(box.dataset.layer);
    else hidden.add(box.dataset.layer);
    if (layers && box.checked) map.addLayer(layers);
    else if (layers) map.removeLayer(layers);
  };
  const settle = () => {
    showMarks();
    restack();
    spreadMarks();
    arrange();
  };
  for (const box of boxes) {
    box.addEventListener("change", () => {
      apply(box);
      settle();
    });
  }
  const all = document.querySelector("[data-all-vehicles]");
  all?.addEventListener("change", () => {
    for (const box of boxes.filter((one) => one.dataset.layer.startsWith("vehicle-"))) {
      box.checked = all.checked;
      apply(box);
    }
    settle();
  });
  const button = document.querySelector(".legend-button");
  button.addEventListener("click", () => {
    const open = button.getAttribute("aria-expanded") !== "true";
    button.setAttribute("aria-expanded", String(open));
    document.querySelector(".legend-box").classList.toggle("open", open);
  });
  button.addEventListener("keydown", (event) => {
    if (event.key === "Escape" && button.getAttribute("aria-expanded") === "true") button.click();
  });
  L.DomEvent.disableClickPropagation(document.querySelector(".legend-box"));
}

/* Layers shown again come last in the drawing, so lines are raised above the bands, in order. */
function restack() {
  plan.vehicles.forEach((_, index) => {
    const layers = groups[`vehicle-${index}`];
    if (!layers || !map.hasLayer(layers)) return;
    layers.eachLayer((line) => {
      if (line.options.pane === "platoons") line.bringToFront();
      else if (line.options.color === "#fff") line.bringToBack();
    });
  });
  groups.inferred?.eachLayer((line) => {
    if (line.options.pane === "routes" && map.hasLayer(line)) line.bringToBack();
  });
}

function wireEvents() {
  const buttons = [...document.querySelectorAll("button[data-event]")];
  const choose = (index) => {
    buttons.forEach((button, i) => {
      if (i === index) button.setAttribute("aria-current", "true");
      else button.removeAttribute("aria-current");
    });
  };
  buttons.forEach((button, index) => {
    button.addEventListener("click", () => {
      const event = plan.events[index];
      choose(index);
      map.setView([event.lat, event.lon], Math.max(map.getZoom(), 10.5), { animate: !calm.matches });
      if (frame.getBoundingClientRect().bottom < 120) {
        frame.scrollIntoView({ block: "start", behavior: calm.matches ? "auto" : "smooth" });
      }
    });
  });
  eventMarks.forEach((made, index) => {
    const open = () => {
      choose(index);
      buttons[index]?.scrollIntoView({ block: "nearest" });
    };
    made.on("click", open);
    made.on("keypress", (event) => {
      if (event.originalEvent.key === "Enter") open();
    });
  });
}

/* Back to the whole plan: a button beside the zoom buttons. */
const Whole = L.Control.extend({
  options: { position: "topleft" },
  onAdd() {
    const bar = element("div", "leaflet-bar leaflet-control");
    const button = element("a", "whole");
    button.href = "#";
    button.setAttribute("role", "button");
    button.title = "Show the whole plan";
    button.setAttribute("aria-label", button.title);
    button.append(drawn("svg", { viewBox: "0 0 16 16", width: 16, height: 16, "aria-hidden": true },
      drawn("path", {
        d: "M2 6V2H6M10 2H14V6M14 10V14H10M6 14H2V10", fill: "none", stroke: "#17202b",
        "stroke-width": 2,
      })));
    L.DomEvent.disableClickPropagation(bar);
    button.addEventListener("click", (event) => {
      event.preventDefault();
      showPlan();
    });
    bar.append(button);
    return bar;
  },
});

// -- start ----------------------------------------------------------------------------------------

L.control.zoom({ position: "topleft" }).addTo(map);
new Whole().addTo(map);
L.control.scale({ position: "bottomleft", metric: true, imperial: false, maxWidth: 100 }).addTo(map);
showPlan();
drawBackground();
drawSolos();
drawPlatoons();
drawJunctions();
drawMarks();
wireLegend();
wireEvents();
redraw();
restack();
spreadMarks();
playJourney({ plan, map, solos, platoons, calm, drawn, isolated, hidden });
arrange();

let width = frame.clientWidth;
map.on("zoomend", () => {
  redraw();
  spreadMarks();
  arrange();
});
map.on("moveend", () => {
  const still = settled && settled.zoom === map.getZoom() && settled.view.contains(map.getBounds());
  if (!still) arrange();
});
map.on("resize", () => {
  // Below 600 px lines are finer: crossing that width redraws them.
  if ((width < 600) !== (frame.clientWidth < 600)) showPlan();
  width = frame.clientWidth;
  redraw();
  spreadMarks();
  arrange();
});
frame.dataset.ready = "true";
})();
