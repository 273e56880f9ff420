/* A crowd's traffic as ribbons, as wide as the number of vehicles, each direction right of its road;
 * maps/ribbons.py draws the same on the still map. */
// oxlint-disable-next-line no-unused-vars -- page.js calls it; the page holds both.
function drawRibbons({ plan, map, group }, lanes) {

const { traffic } = plan;
if (!traffic) return { redraw() {}, lines: () => [] };

const { decodedLines } = planLines;
const STEPS = 1e4;
const THINNEST = 1.8;
const WIDEST = 9;
const LEAST_MOST = 9;
const BETWEEN = 1.2;

/* Asked for once a drawing: it has the page laid out. */
let fine = 1;
const width = (vehicles) =>
  (THINNEST + (WIDEST - THINNEST) * Math.sqrt(vehicles / Math.max(traffic.most, LEAST_MOST))) * fine;

/* Ribbons on some roads: of whom, and where they lie at this zoom. Of bundled traffic platoons are
 * ribbons too, next to the middle of the road. */
function strips({ alone, bands, opposite_m: opposite, lines }) {
  const roads = decodedLines(lines, STEPS);
  const together = traffic.bundled ? bands.reduce((sum, count) => sum + count, 0) : 0;
  const found = [];
  if (together) {
    found.push({ roads, name: "platoon", count: together, aside: () => BETWEEN / 2 + width(together) / 2 });
  }
  if (alone) {
    const inner = () => {
      if (together) return 1.5 * BETWEEN + width(together);
      return bands.length ? lanes.besideBands(bands, opposite, roads[0][0]) + BETWEEN : BETWEEN / 2;
    };
    found.push({ roads, name: "lone", count: alone, aside: () => inner() + width(alone) / 2 });
  }
  return found;
}

const renderers = { lone: L.svg({ pane: "routes", padding: 0.5 }), platoon: L.svg({ pane: "platoons", padding: 0.5 }) };
const COLOURS = { lone: ["#fff", "#5b97cf"], platoon: ["#8a6a00", "#ffd54a"] };
const PANES = { lone: "routes", platoon: "platoons" };

function drawn({ name }, colour) {
  return L.polyline([], {
    pane: PANES[name], renderer: renderers[name], color: colour, opacity: 1, lineCap: "butt",
    lineJoin: "round", smoothFactor: 0, interactive: false, className: "ribbon",
  }).addTo(group(name));
}

// All casings lie under all ribbons, and wide ribbons over narrow ones where roads meet.
const every = traffic.roads.flatMap(strips).sort((a, b) => a.count - b.count);
const casings = every.map((strip) => drawn(strip, COLOURS[strip.name][0]));
const ribbons = every.map((strip) => drawn(strip, COLOURS[strip.name][1]));

function redraw() {
  fine = lanes.fine();
  every.forEach(({ roads, count, aside }, i) => {
    const lines = roads.map((points) =>
      lanes.along([{ points }], aside)[0].map((p) => map.unproject(p)));
    casings[i].setStyle({ weight: width(count) + 2 }).setLatLngs(lines);
    ribbons[i].setStyle({ weight: width(count) }).setLatLngs(lines);
  });
}

/* Where they run, in pixels of the layer. */
const lines = () => ribbons.filter((one) => map.hasLayer(one)).flatMap((one) =>
  one.getLatLngs().map((line) => line.map((at) => map.latLngToLayerPoint(at))));

return { redraw, lines };
}
