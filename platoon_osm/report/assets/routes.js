/* Lines of vehicles that drive alone, and bands of platoons with a line a vehicle. */
// oxlint-disable-next-line no-unused-vars -- page.js calls it; the page holds both.
function planRoutes({ plan, map, hidden, groups, group, solos, platoons, ROUTE_STEPS }, lanes) {

const { decoded, laid } = planLines;
const { reachable } = planTips;
const { fine, lineStep, bandWidth, bandAside, soloStep, soloAside } = lanes;

/* Lines of more vehicles than this are too thin for dashes: their band is a plain ribbon. */
const CROWD = 8;
const DOTS = "0.1 8";

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

/* A line along the parts of a way at this zoom, each as far aside as `aside` says. */
function line(parts, aside, tolerance) {
  const roads = parts.map((part) => ({
    points: part.points.map((at) => map.project(at)), aside: aside(part),
  }));
  return laid(roads, tolerance).map((p) => map.unproject(p));
}

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
    const drawnLine = routeLine("routes", `vehicle-${solo.vehicle}`, {
      color: vehicle.colour, weight: soloWeight(solo),
      // A way beside the road is dotted: its line is straight, the road is not known.
      dashArray: solo.access ? DOTS : vehicle.dash || null,
      lineCap: solo.access ? "round" : vehicle.cap,
    }, solo.tip);
    redraws.push(() => {
      const points = line(solo.parts, soloAside, 0.7);
      casings[i].setLatLngs(points);
      drawnLine.setLatLngs(points);
    });
  });
}

const bandsOf = [];

/* A band is there while its layer is, and any of its vehicles. */
function showBands() {
  platoons.forEach((one, i) => {
    const wanted = one.vehicles.some((index) => !hidden.has(`vehicle-${index}`));
    for (const line of [bandsOf[i].casing, bandsOf[i].band]) {
      if (wanted) group("platoon").addLayer(line);
      else group("platoon").removeLayer(line);
    }
  });
}

function drawPlatoons() {
  // The order of making is the order of drawing: all bands, then all lines over them.
  const bands = platoons.map((one) => ({
    casing: routeLine("platoons", "platoon", { color: "#8a6a00" }),
    band: routeLine("platoons", "platoon", { color: "#ffd54a" }, one.tip),
  }));
  bandsOf.push(...bands);
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
      const beside = (aside) => line(one.parts, (part) => bandAside(part) + aside, 1.6);
      const width = bandWidth(count);
      const step = lineStep(count);
      bands[i].band.setStyle({ weight: width }).setLatLngs(beside(0));
      bands[i].casing.setStyle({ weight: width + 2 }).setLatLngs(beside(0));
      lines.forEach((own, place) => {
        own.setStyle({ weight: Math.min(4, step * 0.68) });
        own.setLatLngs(beside((place - (count - 1) / 2) * step));
      });
    });
  });
}

const redraw = () => redraws.forEach((each) => each());

/* Layers shown again come last in the drawing, so lines are raised above the bands, in order. */
function restack() {
  for (const { casing, band } of [...bandsOf].reverse()) {
    for (const line of [band, casing]) if (map.hasLayer(line)) line.bringToBack();
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
return { redraw, showBands, restack };
}
