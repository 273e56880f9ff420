/* What lies under the plan: the network, an online map if asked for, and the junctions. */
// oxlint-disable-next-line no-unused-vars -- page.js calls it; the page holds both.
function drawGround({ plan, map, group }) {

const { element } = pageElements;
const { decodedLines } = planLines;
const BASEMAP_STEPS = 1e4;

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

function drawBackground() {
  const renderer = L.canvas({ pane: "network", padding: 0.3 });
  const known = decodedLines(plan.basemap.known, BASEMAP_STEPS);
  const inferred = decodedLines(plan.basemap.inferred, BASEMAP_STEPS);
  const style = { pane: "network", renderer, interactive: false, smoothFactor: 1.2, opacity: 1 };
  const line = (points, more, token) => paint(L.polyline(points, { ...style, ...more }), { color: token });
  line(known, { weight: 3.8 }, "road").addTo(group("network"));
  line(known, { weight: 1.8 }, "road-core").addTo(group("network"));
  line(inferred, { weight: 2, dashArray: "5 4" }, "inferred").addTo(group("inferred"));
  if (plan.tiles) {
    L.tileLayer(plan.tiles.url, { maxNativeZoom: plan.tiles.max_zoom, maxZoom: 18 }).addTo(map);
  }
}

function drawJunctions() {
  const renderer = L.canvas({ pane: "junctions", padding: 0.3 });
  const dots = L.layerGroup();
  for (const [lon, lat, name] of plan.junctions) {
    const dot = L.circleMarker([lat / BASEMAP_STEPS, lon / BASEMAP_STEPS], {
      pane: "junctions", renderer, radius: 3.2, weight: 1.4, opacity: 1, fillOpacity: 1,
    });
    paint(dot, { color: "muted", fillColor: "paper" })
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

drawBackground();
drawJunctions();
}
