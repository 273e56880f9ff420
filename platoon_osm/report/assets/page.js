/* The live map of a plan. It reads one JSON document (docs/report.md) and a Leaflet map named
 * map_plan that the lines above have made; the scripts before it hold what it is put together from.
 * Text reaches the page through textContent alone. */
(() => {
"use strict";

const plan = JSON.parse(document.getElementById("plan-data").textContent);
const map = window.map_plan;
const frame = map.getContainer();
const BASEMAP_STEPS = 1e4;
const ROUTE_STEPS = 1e5;
const calm = window.matchMedia("(prefers-reduced-motion: reduce)");

const { element, drawn, isolated } = pageElements;
const { decoded, decodedLines, laid } = planLines;
const lanes = planLanes(map);
const { fine, lineStep, bandWidth, bandAside, soloStep, soloAside } = lanes;

/* Lines of more vehicles than this are too thin for dashes: their band is a plain ribbon. */
const CROWD = 8;
const DOTS = "0.1 8";

document.documentElement.classList.add("live");

// -- panes, bottom to top -------------------------------------------------------------------------

const panes = ["network", "junctions", "routes", "platoons", "names", "ties", "callouts"];
panes.forEach((name, i) => {
  map.createPane(name).style.zIndex = 300 + 20 * i;
});
for (const name of ["names", "ties", "callouts"]) map.getPane(name).classList.add("leaflet-zoom-hide");
for (const name of ["network", "names", "ties", "callouts"]) {
  map.getPane(name).style.pointerEvents = "none";
}

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
      paddingBottomRight: [right, edge + (small && plan.journey ? 66 : 14)],
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
    const near = map.getZoom() >= planLabels.NEAR_ZOOM;
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

// -- controls -------------------------------------------------------------------------------------

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
  marks.eventMarks.forEach((made, index) => {
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
const marks = planMarks({ plan, map, hidden, tooltip });
const labels = planLabels({ plan, map, lanes, solos, platoons, marks, hidden });

/* Bring all that the legend has a say in up to date. */
function settle() {
  showBands();
  marks.show();
  restack();
  labels.arrange();
}

wireLegend({ map, groups, hidden, settle });
wireEvents();
redraw();
restack();
marks.show();
playJourney({ plan, map, solos, platoons, calm, drawn, isolated, hidden });
labels.arrange();

let width = frame.clientWidth;
map.on("zoomend", () => {
  redraw();
  marks.show();
  labels.arrange();
});
map.on("resize", () => {
  // Below 600 px lines are finer: crossing that width redraws them.
  if ((width < 600) !== (frame.clientWidth < 600)) showPlan();
  width = frame.clientWidth;
  redraw();
  marks.show();
  labels.arrange();
});
frame.dataset.ready = "true";
})();
