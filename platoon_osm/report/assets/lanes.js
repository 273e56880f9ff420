/* How wide bands and lines are, and how far right of its road each is drawn. */
// oxlint-disable-next-line no-unused-vars -- page.js calls it; the page holds both.
function planLanes(map) {

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

return { fine, lineStep, bandWidth, bandAside, soloStep, soloAside, besideBands };
}
