/* How wide bands and lines are, how far right of its road each is drawn, and where that is. */
// oxlint-disable-next-line no-unused-vars -- page.js calls it; the page holds both.
function planLanes(map) {

const { laidBeside } = planBeside;
const frame = map.getContainer();

/* On a small screen the band would hide the country, so all lines of a platoon are finer. */
const fine = () => (frame.clientWidth < 600 ? 0.62 : 1);

function lineStep(vehicles) {
  return Math.min(6, 36 / vehicles) * fine();
}

const bandWidth = (vehicles) => 6 * fine() + lineStep(vehicles) * vehicles;

/* Several bands side by side, casings included. */
const bandsWidth = (beside) => beside.reduce((sum, count) => sum + bandWidth(count) + 2, 0);

/* Where the road is driven the other way too, a strip of lines keeps right of the middle. The
 * carriageways of the map count: close up they are apart by themselves. */
function apart({ opposite_m: opposite, points }, width) {
  if (opposite === null) return 0;
  const [lat] = points[0];
  const metres = (40075016.7 * Math.cos((lat * Math.PI) / 180)) / (256 * 2 ** map.getZoom());
  return Math.max(0, width / 2 + 0.5 - opposite / metres / 2);
}

/* How far right of the road a band's middle lies, so that all bands on it show. */
function bandAside(part) {
  const own = bandsWidth(part.beside.slice(part.place, part.place + 1));
  const whole = bandsWidth(part.beside);
  return bandsWidth(part.beside.slice(0, part.place)) + own / 2 - whole / 2 + apart(part, whole);
}

/* Vehicles alone on one road lie side by side, the finer the more they are. */
const soloStep = (slots) => Math.min(7, 26 / Math.max(slots - 1, 1)) * fine();

function soloAside(part) {
  const step = soloStep(part.slots);
  if (part.bands.length) {
    const width = bandsWidth(part.bands);
    return width / 2 + 4 + step * part.slot + apart(part, width);
  }
  const across = step * (part.slots - 1);
  return step * part.slot - across / 2 + apart(part, across + 8);
}

/* How far right of the road the outer edge of its bands is. */
function besideBands(bands, opposite, at) {
  const width = bandsWidth(bands);
  return width / 2 + apart({ opposite_m: opposite, points: [at] }, width);
}

/* Lines are laid for one zoom and some screens around the view; who draws them is told when the
 * reader has moved on. */
let region = null;
const drawers = [];

function settle() {
  const view = map.getPixelBounds();
  const size = view.getSize();
  region = L.bounds(view.min.subtract(size.multiplyBy(1.5)), view.max.add(size.multiplyBy(1.5)));
  region.zoom = map.getZoom();
}

map.on("moveend", () => {
  if (!region || region.zoom !== map.getZoom() || region.contains(map.getPixelBounds())) return;
  settle();
  for (const draw of drawers) draw();
});

const outside = ({ x, y }) =>
  (x < region.min.x ? 1 : x > region.max.x ? 2 : 0) | (y < region.min.y ? 4 : y > region.max.y ? 8 : 0);

/* A line without the points that make no difference to what is inside the region. */
function cropped(points) {
  const codes = points.map(outside);
  const kept = [];
  let common = 0;
  points.forEach((p, i) => {
    if (common & codes[i]) {
      common &= codes[i];
      if (i < points.length - 1) return;
    } else if (i && kept[kept.length - 1] !== points[i - 1]) {
      kept.push(points[i - 1]);
    }
    kept.push(p);
    common = codes[i];
  });
  return kept;
}

/* Lines along the parts of a way at this zoom, in pixels of the world: for each offset one beside
 * a middle that lies as far aside of each part as `aside` says. */
function along(parts, aside, offsets = [0]) {
  if (!region || region.zoom !== map.getZoom()) settle();
  const roads = parts.map((part) => ({
    points: cropped(part.points.map((at) => map.project(at))), aside: aside(part),
  }));
  return laidBeside(roads, offsets);
}

/* Draw again with `draw` what `along` has laid, once the reader has moved out of it. */
const redrawWith = (draw) => drawers.push(draw);

return { fine, lineStep, bandWidth, bandAside, soloStep, soloAside, besideBands, along, redrawWith };
}
