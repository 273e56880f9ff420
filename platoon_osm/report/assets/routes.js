/* Lines of vehicles that drive alone, and bands of platoons with a line a vehicle. */
// oxlint-disable-next-line no-unused-vars -- page.js calls it; the page holds both.
function planRoutes(scene, lanes) {

const { plan, map, hidden, groups, group, selection, solos, platoons, ROUTE_STEPS } = scene;

const { decoded } = planLines;
const { reachable } = planTips;
const { fine, lineStep, bandWidth, bandAside, soloStep, soloAside, along } = lanes;

/* Lines of more vehicles than this are too thin for dashes: their band is a plain ribbon. */
const CROWD = 8;
const DOTS = "0.1 8";

const svg = {};
for (const pane of ["routes", "platoons", "lifted"]) svg[pane] = L.svg({ pane, padding: 0.5 });
const ribbons = drawRibbons(scene, lanes);
const redraws = [ribbons.redraw];

/* A crowd shows as ribbons, and its vehicles' own lines only where one is lifted out. */
const { traffic } = plan;
const ribboned = (solo) => Boolean(traffic) && !solo.access;

function routeLine(pane, name, who, style, tip) {
  const made = L.polyline([], {
    pane, renderer: svg[pane], lineCap: "butt", lineJoin: "round", opacity: 1, smoothFactor: 0,
    interactive: Boolean(tip), className: tip ? "route" : "", ...style,
    // Leaflet would cut it at the edge of the view, and dashes begin where a line does.
    noClip: Boolean(style.dashArray),
  });
  if (who !== null) made.on("add", () => selection.tag(made.getElement(), who));
  if (tip) reachable(made, tip);
  if (tip && typeof who === "number") choosable(made, who);
  return made.addTo(group(name));
}

/* A line of one vehicle lifts it out. */
function choosable(made, index) {
  planMarks.act(made, () => selection.choose(index));
  made.on("add", () => made.getElement().setAttribute("role", "button"));
}

/* How far along a line the place nearest to a point is. */
function arcNear(line, point) {
  let [arc, found, least] = [0, 0, Infinity];
  line.reduce((a, b) => {
    const near = L.LineUtil.closestPointOnSegment(point, a, b);
    const away = near.distanceTo(point);
    if (away < least) [least, found] = [away, arc + near.distanceTo(a)];
    arc += a.distanceTo(b);
    return b;
  });
  return found;
}

/* Lay a line along points of the world at this zoom. Where it has been laid at the same zoom, for
 * another part of its road, its dashes stay as they are in the middle of the view. */
function lay(line, exact) {
  // As Leaflet draws them.
  const points = exact.map(({ x, y }) => L.point(x, y, true));
  if (line.options.dashArray) {
    const [zoom, middle, old] = [map.getZoom(), map.getPixelBounds().getCenter(), line.laid];
    const start = old?.zoom === zoom && old.start + arcNear(old.points, middle) - arcNear(points, middle);
    line.laid = { zoom, points, start };
    line.setStyle({ dashOffset: start });
  }
  line.setLatLngs(points.map((p) => map.unproject(p)));
}

/* One weight along the whole stretch: that of its most crowded part. */
function soloWeight(solo) {
  const slots = Math.max(...solo.parts.map((part) => part.slots));
  return Math.max(1.4, Math.min(4, soloStep(slots) * 0.8 / fine()));
}

/* A vehicle alone: its casing at once, and the line over it when that is asked for. */
function soloLine(solo, pane, name, aside, weight) {
  const vehicle = plan.vehicles[solo.vehicle];
  const casing = routeLine(pane, name, solo.vehicle, { color: "#fff", weight: weight + 4 });
  return () => {
    const drawnLine = routeLine(pane, name, solo.vehicle, {
      color: vehicle.colour, weight,
      // A way beside the road is dotted: its line is straight, the road is not known.
      dashArray: solo.access ? DOTS : vehicle.dash || null,
      lineCap: solo.access ? "round" : vehicle.cap,
    }, solo.tip);
    return () => {
      const [points] = along(solo.parts, aside);
      lay(casing, points);
      lay(drawnLine, points);
    };
  };
}

function drawSolos() {
  // All casings lie under all lines, or one vehicle's casing would cut another's line.
  const alone = solos.filter((solo) => !ribboned(solo)).map((solo) =>
    soloLine(solo, "routes", `vehicle-${solo.vehicle}`, soloAside, soloWeight(solo)));
  for (const text of plan.inferred_routes) {
    const parts = [{ points: decoded(text, ROUTE_STEPS) }];
    const line = routeLine("routes", "inferred", null, { color: "#8a5a83", weight: 14, dashArray: "6 4" });
    redraws.push(() => lay(line, along(parts, () => 0)[0]));
  }
  redraws.push(...alone.map((over) => over()));
}

const bandsOf = [];

const samePlace = ([lat, lon], [otherLat, otherLon]) => lat === otherLat && lon === otherLon;

/* Stretches of one company that follow each other, cut where it stands or hands on the lead, are one
 * band, or its lines would not meet where the road bends. */
const follows = (one, next) => one.points.length && next.points.length
  && String(one.vehicles) === String(next.vehicles)
  && samePlace(one.points[one.points.length - 1], next.points[0]);
const runs = [];
for (const one of platoons) {
  const last = runs[runs.length - 1];
  if (last && follows(last[last.length - 1], one)) last.push(one);
  else runs.push([one]);
}

/* A band is there while its layer is, and any of its vehicles. */
function showBands() {
  bandsOf.forEach(({ casing, band, pieces }, i) => {
    const wanted = runs[i][0].vehicles.some((index) => !hidden.has(`vehicle-${index}`));
    for (const line of [casing, band, ...pieces]) {
      if (wanted) group("platoon").addLayer(line);
      else group("platoon").removeLayer(line);
    }
  });
}

/* The order of making is the order of drawing: all bands, then all lines over them. */
function bandOf(run, pane, name) {
  const { vehicles, tip } = run[0];
  const parts = run.flatMap((one) => one.parts);
  const made = {
    casing: routeLine(pane, name, vehicles, { color: "#8a6a00" }),
    band: routeLine(pane, name, vehicles, { color: "#ffd54a" }, run.length < 2 ? tip : undefined),
    // Each stretch of a longer band tells of itself, unseen over it.
    pieces: run.length < 2 ? [] : run.map((one) => routeLine(pane, name, vehicles, { opacity: 0 }, one.tip)),
  };
  const linesOver = (nameOf, aside) => {
    const count = vehicles.length;
    const members = vehicles.map((index) => {
      const vehicle = plan.vehicles[index];
      return routeLine(pane, nameOf(index), index, {
        color: vehicle.colour, lineCap: vehicle.cap,
        dashArray: (count <= CROWD && vehicle.dash) || null,
      });
    });
    return () => {
      const width = bandWidth(count);
      const step = lineStep(count);
      const offsets = members.map((_, place) => (place - (count - 1) / 2) * step);
      const [middle, ...beside] = along(parts, aside, [0, ...offsets]);
      lay(made.band.setStyle({ weight: width }), middle);
      lay(made.casing.setStyle({ weight: width + 2 }), middle);
      made.pieces.forEach((piece, i) => lay(piece.setStyle({ weight: width }), along(run[i].parts, aside)[0]));
      members.forEach((own, place) => lay(own.setStyle({ weight: Math.min(4, step * 0.68) }), beside[place]));
    };
  };
  return { made, linesOver };
}

function drawPlatoons() {
  if (traffic?.bundled) return;
  const bands = runs.map((run) => bandOf(run, "platoons", "platoon"));
  bandsOf.push(...bands.map(({ made }) => made));
  for (const { linesOver } of bands) redraws.push(linesOver((index) => `vehicle-${index}`, bandAside));
}

// -- the vehicle that is lifted out of a crowd ------------------------------------------------------

let lifted = [];

/* Over its ribbon, or beside the bands on its road. */
const liftedAside = (part) =>
  part.bands.length && !traffic.bundled ? soloAside({ ...part, slot: 0, slots: 1 }) : 3;

function lift(chosen, hinted) {
  const index = chosen ?? hinted;
  group("lifted").clearLayers();
  lifted = [];
  if (!traffic || index === null) return;
  const pieces = plan.vehicles[index].way;
  const bands = pieces.filter(([kind]) => kind === "platoon" && traffic.bundled)
    .map(([, at]) => bandOf([platoons[at]], "lifted", "lifted"));
  const alone = pieces.filter(([kind, at]) => kind === "solo" && ribboned(solos[at]))
    .map(([, at]) => soloLine(solos[at], "lifted", "lifted", liftedAside, 4));
  const middle = (part) => bandAside({ ...part, beside: [part.beside[part.place]], place: 0 });
  lifted = [...bands.map(({ linesOver }) => linesOver(() => "lifted", middle)), ...alone.map((over) => over())];
  for (const each of lifted) each();
}
selection.on(lift);

const redraw = () => [...redraws, ...lifted].forEach((each) => each());

/* Layers shown again come last in the drawing, so lines are raised above the bands, in order. */
function restack() {
  for (const { casing, band, pieces } of [...bandsOf].reverse()) {
    for (const line of [...pieces, band, casing]) if (map.hasLayer(line)) line.bringToBack();
  }
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

drawSolos();
drawPlatoons();
lanes.redrawWith(redraw);
return { redraw, showBands, restack, ribbonLines: ribbons.lines };
}
