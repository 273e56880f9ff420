/* What every script of the live map works on: the plan, the Leaflet map, its panes and layers. */
// oxlint-disable-next-line no-unused-vars -- page.js calls it; the page holds both.
const planScene = () => {

const { decoded } = planLines;
/* Places, which a page holds as one line of points and one text of names, as the document has them. */
const places = ({ at, names, ranks, told }) => {
  const named = names.split("\n");
  let last;
  // An empty line is like the one before it.
  const more = told?.split("\n").map((one) => (last = one || last)) ?? Array.from(ranks, Number);
  return decoded(at, 1).map(([lat, lon], i) => [lon, lat, named[i], ...more.slice(i, i + 1)]);
};
const data = unpacked(JSON.parse(document.getElementById("plan-data").textContent));
const plan = { ...data, towns: places(data.towns), junctions: places(data.junctions),
  stops: places(data.stops) };
const map = window.map_plan;
const frame = map.getContainer();
const calm = window.matchMedia("(prefers-reduced-motion: reduce)");
const ROUTE_STEPS = 1e5;

document.documentElement.classList.add("live");
// folium gives these to tiles alone; beyond them a view is nothing but work.
map.setMinZoom(3).setMaxZoom(18);
// Until now the page was laid out to be read without a script, and the map was measured in it.
map.invalidateSize({ pan: false });

// Panes, bottom to top.
const panes = ["network", "junctions", "routes", "platoons", "lifted", "names", "ties", "callouts"];
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

const points = (parts) =>
  parts.map((part) => ({ ...part, points: decoded(part.line, ROUTE_STEPS) }));
const solos = plan.solos.map((solo) => ({ ...solo, parts: points(solo.parts) }));
const platoons = plan.platoons.map((one) => {
  const parts = points(one.parts);
  return { ...one, parts, points: parts.flatMap((part) => part.points) };
});

const selection = planSelection(plan);

return { plan, map, frame, calm, hidden, groups, group, selection, solos, platoons, ROUTE_STEPS };
};
