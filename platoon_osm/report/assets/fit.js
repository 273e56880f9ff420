/* Which part of the map is shown: all of the plan, as large as may be, clear of what covers the map.
 * It is shown anew whenever frame or covers change, until the reader moves the map. */
// oxlint-disable-next-line no-unused-vars -- page.js calls it; the page holds both.
function planFit({ plan, map, frame, solos, platoons }, { marks, journey, redraw }) {

const { bestView } = planRoom;
const { PARTS, covers } = planCover;
const NEAREST_ZOOM = 13;
const MOST_POINTS = 1200;
const MARK_PX = 26;
/* Between a mark and what must not cover it, and for a line with its casing. */
const GAP_PX = 5;
const LINE_PX = 12;
/* An open legend may cost so much of a plan's size, in zoom levels, before it starts closed. */
const LEGEND_LEVELS = 0.45;

const legendBox = document.querySelector(".legend-box");
const legendButton = legendBox.querySelector(".legend-button");

// -- what is shown, in pixels of the whole world at zoom 0 ----------------------------------------

const lines = [...platoons, ...solos].flatMap((one) => one.parts)
  .map((part) => part.points.map((at) => map.project(at, 0)));
const ends = [
  ...plan.vehicles.flatMap((vehicle) => [vehicle.origin, vehicle.destination]), ...plan.events,
].map(({ lat, lon }) => map.project([lat, lon], 0));

/* Points at even distances along all lines. */
const along = (() => {
  const far = (a, b) => Math.hypot(b.x - a.x, b.y - a.y);
  let length = 0;
  for (const line of lines) for (let i = 1; i < line.length; i++) length += far(line[i - 1], line[i]);
  const step = length / MOST_POINTS || 1;
  const found = [];
  for (const line of lines) {
    found.push(...line.slice(0, 1), ...line.slice(-1));
    let left = step;
    for (let i = 1; i < line.length; i++) {
      const [a, b] = [line[i - 1], line[i]];
      const whole = far(a, b);
      for (; left < whole; left += step) {
        found.push({ x: a.x + ((b.x - a.x) * left) / whole, y: a.y + ((b.y - a.y) * left) / whole });
      }
      left -= whole;
    }
  }
  return found;
})();

const bounds = L.bounds([...lines.flat(), ...ends].map(({ x, y }) => L.point(x, y)));

const boxAt = ({ x, y }, zoom, size) => {
  const scale = 2 ** zoom;
  return { x: x * scale - size / 2, y: y * scale - size / 2, w: size, h: size };
};
const grown = ({ x, y, w, h }) => ({ x: x - GAP_PX, y: y - GAP_PX, w: w + 2 * GAP_PX, h: h + 2 * GAP_PX });

/* Marks as they would stand at a zoom: beside one another, or as one that counts them. */
function marksAt(zoom) {
  const [was, origin] = [map._zoom, map._pixelOrigin];
  const centre = bounds.getCenter().multiplyBy(2 ** zoom)._round();
  [map._zoom, map._pixelOrigin] = [zoom, centre];
  marks.show();
  const boxes = marks.boxes().map((box) => grown({ ...box, x: box.x + centre.x, y: box.y + centre.y }));
  [map._zoom, map._pixelOrigin] = [was, origin];
  return boxes;
}

// -- the frame ------------------------------------------------------------------------------------

const whole = { plain: bounds.getSize(), stops: ends, points: along, boxesAt: marksAt };

function search({ plain, stops, points, boxesAt } = whole) {
  const size = map.getSize();
  const edge = Math.min(Math.max(Math.min(size.x, size.y) * 0.03, 6), 24);
  const room = size.subtract([2 * edge + MARK_PX, 2 * edge + MARK_PX]);
  const most = Math.log2(Math.min(
    Math.max(room.x, 1) / (plain.x || 1e-9), Math.max(room.y, 1) / (plain.y || 1e-9), 2 ** NEAREST_ZOOM,
  ));
  return bestView({
    covers: covers(frame), size, edge, most, least: map.getMinZoom(), boxesAt,
    roughAt: (zoom) => stops.map((at) => grown(boxAt(at, zoom, MARK_PX))),
    pointsAt: (zoom) => points.map((at) => boxAt(at, zoom, LINE_PX)),
  });
}

/* Are these boxes in the frame and clear of what covers it? */
function areClear(boxes) {
  const size = map.getSize();
  const over = covers(frame);
  return boxes.every(({ x, y, w, h }) => {
    if (x < 0 || y < 0 || x + w > size.x || y + h > size.y) return false;
    return over.every((cover) =>
      x + w <= cover.x || cover.x + cover.w <= x || y + h <= cover.y || cover.y + cover.h <= y);
  });
}

function isClear() {
  return areClear(marks.boxes().map((box) => ({ ...box, ...map.layerPointToContainerPoint([box.x, box.y]) })));
}

function openLegend(open) {
  legendBox.classList.toggle("open", open);
  legendButton.setAttribute("aria-expanded", String(open));
}

/* Beside a panel the legend is open if the plan stays about as large, unless the reader chose. */
let chosen = false;
function bestWithLegend() {
  if (chosen) return search();
  openLegend(false);
  const closed = search();
  if (!window.matchMedia("(min-width: 900px)").matches) return closed;
  openLegend(true);
  const open = search();
  if (open && open.score >= (closed?.score ?? -Infinity) - LEGEND_LEVELS) return open;
  openLegend(false);
  return closed;
}

// -- showing it -----------------------------------------------------------------------------------

let moved = false;
let working = false;

/* Do what moves the map without a reader having moved it. */
function quietly(change) {
  working = true;
  change();
  working = false;
}

/* Set the view exactly: buttons and wheel go by quarters of a level, a fit or a link need not. */
function setView(centre, zoom) {
  const snap = map.options.zoomSnap;
  map.options.zoomSnap = 0;
  map.setView(centre, zoom, { reset: true });
  map.options.zoomSnap = snap;
}

/* Show a part of the map, as if the reader had gone there. */
function moveTo(centre, zoom) {
  moved = true;
  quietly(() => setView(centre, zoom));
  redraw();
}

/* Show a way between two places clear of what covers the map, unless both are so already. */
function showWay(places, way) {
  if (areClear(places.map((at) => boxAt(map.latLngToContainerPoint(at), 0, MARK_PX)))) return;
  const stops = places.map((at) => map.project(at, 0));
  const every = way.map((at) => map.project(at, 0));
  const step = Math.ceil(every.length / MOST_POINTS);
  const best = search({
    stops, points: every.filter((_, i) => i % step === 0),
    plain: L.bounds([...stops, ...every]).getSize(),
    boxesAt: (zoom) => stops.map((at) => grown(boxAt(at, zoom, MARK_PX))),
  });
  if (best) moveTo(map.unproject(map.getSize().divideBy(2).subtract([best.x, best.y]), best.zoom), best.zoom);
}

/* Show the whole plan. */
function showPlan() {
  moved = false;
  quietly(() => {
    map.invalidateSize({ pan: false });
    journey?.steady();
    const best = bestWithLegend();
    // Nowhere in a frame of hardly any size: its middle is as good as any.
    const { zoom, x, y } = best ?? { zoom: map.getMinZoom(), x: 0, y: 0 };
    const middle = best ? map.getSize().divideBy(2).subtract([x, y]) : bounds.getCenter().multiplyBy(2 ** zoom);
    setView(map.unproject(middle, zoom), zoom);
  });
  redraw();
}

/* The frame has another size, or what covers it. */
function settle() {
  if (!frame.clientWidth || !frame.clientHeight) return;
  const old = map.getSize();
  const resized = old.x !== frame.clientWidth || old.y !== frame.clientHeight;
  if (moved) {
    quietly(() => map.invalidateSize({ animate: false }));
    if (resized) redraw();
  } else if (resized || !isClear()) {
    showPlan();
  }
}

function watch() {
  const watcher = new ResizeObserver(settle);
  for (const part of [frame, ...document.querySelectorAll(PARTS)]) watcher.observe(part);
  legendButton.addEventListener("click", () => {
    chosen = true;
    if (!moved) showPlan();
  });
  map.on("movestart zoomstart", () => {
    if (!working) moved = true;
  });
}

return { showPlan, showWay, moveTo, watch, isMoved: () => moved, isWorking: () => working };
}
