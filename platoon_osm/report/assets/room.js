/* Where a plan has room: the largest view of it in which no mark lies under what covers the map.
 *
 * At one zoom a view is a shift of the plan. A mark and a cover exclude a rectangle of shifts; all
 * shifts that keep the plan in the frame are looked at on a grid, on which these rectangles are
 * added up by their corners. Lines may be covered at need, which counts against a view. */
// oxlint-disable-next-line no-unused-vars -- fit.js calls it; the page holds both.
const planRoom = (() => {

const CELL_PX = 3;
/* So much smaller a plan may get, in zoom levels, to free itself. */
const MOST_LEVELS = 3;
const ZOOM_STEP = 0.05;
/* What a view loses, in zoom levels, for lines all covered, and for each mark that is. */
const LINES_COVERED = 4;
const MARK_COVERED = 10;

/* Shifts from `low` to `high` as a grid, and how many of the `boxes` a shift brings under a cover. */
function covered(boxes, covers, low, high) {
  const wide = Math.floor((high.x - low.x) / CELL_PX) + 1;
  const tall = Math.floor((high.y - low.y) / CELL_PX) + 1;
  const sums = new Float32Array((wide + 1) * (tall + 1));
  const from = (at, start, most) => Math.min(Math.max(Math.ceil((at - start) / CELL_PX), 0), most);
  for (const box of boxes) {
    for (const cover of covers) {
      const x0 = from(cover.x - box.x - box.w, low.x, wide);
      const x1 = from(cover.x + cover.w - box.x, low.x, wide);
      const y0 = from(cover.y - box.y - box.h, low.y, tall);
      const y1 = from(cover.y + cover.h - box.y, low.y, tall);
      if (x0 >= x1 || y0 >= y1) continue;
      sums[y0 * (wide + 1) + x0] += 1;
      sums[y0 * (wide + 1) + x1] -= 1;
      sums[y1 * (wide + 1) + x0] -= 1;
      sums[y1 * (wide + 1) + x1] += 1;
    }
  }
  for (let y = 0; y < tall; y++) {
    for (let x = 0; x < wide; x++) {
      const at = y * (wide + 1) + x;
      if (x) sums[at] += sums[at - 1];
    }
  }
  for (let y = 1; y < tall; y++) {
    for (let x = 0; x < wide; x++) sums[y * (wide + 1) + x] += sums[(y - 1) * (wide + 1) + x];
  }
  return { wide, tall, at: (x, y) => sums[y * (wide + 1) + x] };
}

/* The best shift at one zoom, and what it loses; null if the plan is larger than the frame. */
function bestShift(boxes, points, covers, size, edge) {
  const [low, high] = [{ x: -Infinity, y: -Infinity }, { x: Infinity, y: Infinity }];
  for (const { x, y, w, h } of [...boxes, ...points]) {
    low.x = Math.max(low.x, edge - x);
    low.y = Math.max(low.y, edge - y);
    high.x = Math.min(high.x, size.x - edge - x - w);
    high.y = Math.min(high.y, size.y - edge - y - h);
  }
  if (low.x > high.x || low.y > high.y) return null;
  const marks = covered(boxes, covers, low, high);
  const lines = covered(points, covers, low, high);
  const middle = { x: (high.x - low.x) / 2 / CELL_PX, y: (high.y - low.y) / 2 / CELL_PX };
  let best = null;
  for (let y = 0; y < marks.tall; y++) {
    for (let x = 0; x < marks.wide; x++) {
      const hidden = marks.at(x, y);
      const loss = MARK_COVERED * hidden + (LINES_COVERED * lines.at(x, y)) / (points.length || 1);
      if (best && loss > best.loss) continue;
      const aside = Math.hypot(x - middle.x, y - middle.y);
      if (best && loss === best.loss && aside >= best.aside) continue;
      best = { x: low.x + x * CELL_PX, y: low.y + y * CELL_PX, loss, aside, hidden };
    }
  }
  return best;
}

/* Zoom, shift and score of the best view. `boxesAt(zoom)` are the marks and `pointsAt(zoom)` points
 * along the lines, in pixels of the world at that zoom; `covers` and `size` in those of the frame. */
function bestView({ boxesAt, roughAt, pointsAt, covers, size, edge, most, least }) {
  let best = null;
  const top = Math.floor(most / ZOOM_STEP);
  for (let step = top; step * ZOOM_STEP > Math.max(most - MOST_LEVELS, least - ZOOM_STEP); step--) {
    const zoom = Math.max(Number((step * ZOOM_STEP).toFixed(2)), least);
    if (best && zoom <= best.score) break;
    const points = pointsAt(zoom);
    const promise = bestShift(roughAt(zoom), points, covers, size, edge);
    if (!promise || (best && zoom - promise.loss <= best.score)) continue;
    const found = bestShift(boxesAt(zoom), points, covers, size, edge);
    if (!found) continue;
    const score = zoom - found.loss;
    if (!best || score > best.score) best = { zoom, score, ...found };
  }
  return best;
}

return { bestView };
})();
