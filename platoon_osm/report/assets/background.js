/* What lies under the plan: land and sea or an online map, the network, towns and junctions. */
// oxlint-disable-next-line no-unused-vars -- page.js calls it; the page holds both.
function drawGround({ plan, map, group }) {

const { element } = pageElements;
const { decodedLines } = planLines;
const BASEMAP_STEPS = 1e4;
const NETWORK_STEPS = 5e3;
const frame = map.getContainer();

/* Canvases do not see style sheets: they are told the colours of theme.css, again when these change. */
const painted = [];

function paint(layer, inks) {
  painted.push([layer, inks]);
  return layer.setStyle(resolved(inks));
}

function resolved(inks) {
  const root = getComputedStyle(document.documentElement);
  return Object.fromEntries(
    Object.entries(inks).map(([key, token]) => [key, root.getPropertyValue(`--${token}`).trim()]));
}

for (const query of ["(prefers-color-scheme: dark)", "(forced-colors: active)"]) {
  window.matchMedia(query).addEventListener("change", () => {
    for (const [layer, inks] of painted) layer.setStyle(resolved(inks));
  });
}

const canvas = L.canvas({ pane: "network", padding: 0.3 });

/* Coarse patches first: each finer one lays sea over its part of the world, and its own land on it.
 * They are in no group: the legend has no say in them. */
function drawLand() {
  frame.classList.add("at-sea");
  const plain = { pane: "network", renderer: canvas, interactive: false };
  const filled = { ...plain, stroke: false, fillOpacity: 1 };
  for (const { frame: [west, south, east, north], steps, land, borders } of plan.ground.patches) {
    const part = L.rectangle([[south, west], [north, east]], filled);
    paint(part, { fillColor: "sea" }).addTo(map);
    const rings = decodedLines(land, steps).map((ring) => [ring]);
    // Water inside land runs the other way round than land does.
    const ground = L.polygon(rings, { ...filled, fillRule: "nonzero", smoothFactor: 0.8 });
    paint(ground, { fillColor: "land" }).addTo(map);
    const lines = L.polyline(decodedLines(borders, steps), {
      ...plain, weight: 1, opacity: 1, dashArray: "5 3", smoothFactor: 0.8,
    });
    paint(lines, { color: "border" }).addTo(map);
  }
}

/* From which zoom on towns have a dot, and how large it is: cities, towns, villages. */
const TOWN_ZOOM = [0, 7, 9.5];
const TOWN_RADIUS = [2.6, 2, 1.6];

function drawTowns() {
  const kinds = TOWN_ZOOM.map(() => L.layerGroup());
  for (const [lon, lat, , rank] of plan.towns) {
    const dot = L.circleMarker([lat / BASEMAP_STEPS, lon / BASEMAP_STEPS], {
      pane: "network", renderer: canvas, interactive: false, radius: TOWN_RADIUS[rank], stroke: false,
      fillOpacity: 1,
    });
    paint(dot, { fillColor: "town" }).addTo(kinds[rank]);
  }
  byZoom(group("names"), kinds, TOWN_ZOOM);
}

/* Show layers of a group from their zooms on. */
function byZoom(all, layers, least) {
  const settle = () => layers.forEach((layer, i) => {
    const near = map.getZoom() >= least[i];
    if (near === all.hasLayer(layer)) return;
    if (near) all.addLayer(layer);
    else all.removeLayer(layer);
  });
  map.on("zoomend", settle);
  settle();
}

function drawBackground() {
  const renderer = canvas;
  const known = decodedLines(plan.basemap.known, NETWORK_STEPS);
  const inferred = decodedLines(plan.basemap.inferred, NETWORK_STEPS);
  const style = { pane: "network", renderer, interactive: false, smoothFactor: 1.2, opacity: 1 };
  const line = (points, more, token) => paint(L.polyline(points, { ...style, ...more }), { color: token });
  line(known, { weight: 3.8 }, "road").addTo(group("network"));
  line(known, { weight: 1.8 }, "road-core").addTo(group("network"));
  line(inferred, { weight: 2, dashArray: "5 4" }, "inferred").addTo(group("inferred"));
  if (plan.tiles) {
    L.tileLayer(plan.tiles.url, { maxNativeZoom: plan.tiles.max_zoom, maxZoom: 18 }).addTo(map);
  }
}

/* Junctions, and stops for trucks on the way: dots that tell their names, on one canvas, for an
 * upper one would keep the pointer from the lower. */
const dotted = L.canvas({ pane: "junctions", padding: 0.3 });

function drawDots(layer, places, radius, inks, tipOf) {
  const dots = L.layerGroup();
  for (const place of places) {
    const [lon, lat] = place;
    const dot = L.circleMarker([lat / BASEMAP_STEPS, lon / BASEMAP_STEPS], {
      pane: "junctions", renderer: dotted, radius, weight: 1.4, opacity: 1, fillOpacity: 1,
    });
    paint(dot, inks).bindTooltip(tipOf(place), { direction: "top", opacity: 1 }).addTo(dots);
  }
  byZoom(group(layer), [dots], [planLabels.NEAR_ZOOM]);
}

if (plan.ground && !plan.tiles) drawLand();
drawBackground();
drawTowns();
drawDots("junctions", plan.junctions, 3.2, { color: "muted", fillColor: "paper" },
  ([, , name]) => element("bdi", "", name));
drawDots("stops", plan.stops, 4.4, { color: "paper", fillColor: "muted" },
  ([, , name, told]) => planTips.tooltip({ head: name, lines: [told] }));
}
