/* What lies under the plan: the network, an online map if asked for, and the junctions. */
// oxlint-disable-next-line no-unused-vars -- page.js calls it; the page holds both.
function drawGround({ plan, map, group }) {

const { element } = pageElements;
const { decodedLines } = planLines;
const BASEMAP_STEPS = 1e4;

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

drawBackground();
drawJunctions();
}
