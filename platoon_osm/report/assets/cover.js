/* What of the map is taken, as a grid of small cells. */
// oxlint-disable-next-line no-unused-vars -- other scripts of the page use it.
const planCover = (() => {

const CELL = 5;
/* A line may be covered at need, marks and texts never; texts also want room between them. */
const SOLID = 1e3;
const TEXT = 1e6;

class Cover {
  /* Of a part of the plane; what lies outside it counts for nothing. */
  constructor({ x, y, w, h }) {
    this.part = L.bounds([x, y], [x + w, y + h]);
    [this.left, this.top] = [Math.floor(x / CELL), Math.floor(y / CELL)];
    [this.wide, this.tall] = [Math.ceil(w / CELL) + 1, Math.ceil(h / CELL) + 1];
    this.weights = new Float64Array(this.wide * this.tall);
  }

  addLine(points, weight) {
    for (let i = 1; i < points.length; i++) {
      const ends = L.LineUtil.clipSegment(points[i - 1], points[i], this.part);
      if (!ends) continue;
      const [a, b] = ends;
      const steps = Math.max(1, Math.ceil(Math.hypot(b.x - a.x, b.y - a.y) / CELL));
      for (let s = 0; s <= steps; s++) {
        const [x, y] = [a.x + ((b.x - a.x) * s) / steps, a.y + ((b.y - a.y) * s) / steps];
        const key = (Math.floor(y / CELL) - this.top) * this.wide + Math.floor(x / CELL) - this.left;
        this.weights[key] = Math.max(this.weights[key], weight);
      }
    }
  }

  addBox(box, weight) {
    this.cost(box, Infinity, weight);
  }

  /* What a box covers, or some of it that is `most` or more; `weight` is added to all of it. */
  cost({ x, y, w, h }, most = Infinity, weight = 0) {
    let sum = 0;
    const { left, top, wide, tall, weights } = this;
    const first = Math.max(Math.floor(x / CELL) - left, 0);
    const last = Math.min(Math.floor((x + w) / CELL) - left, wide - 1);
    const end = Math.min(Math.floor((y + h) / CELL) - top, tall - 1);
    for (let row = Math.max(Math.floor(y / CELL) - top, 0); row <= end && sum < most; row++) {
      for (let key = row * wide + first; key <= row * wide + last; key++) {
        sum += weights[key];
        weights[key] += weight;
      }
    }
    return sum;
  }

  /* Does another text lie within some room round a box? */
  isCrowded({ x, y, w, h }, room) {
    return this.cost({ x: x - room, y: y - room / 2, w: w + 2 * room, h: h + room }, TEXT) >= TEXT;
  }

  /* The candidate that covers least, taken; null if each would cover `most` or more. `more` is what
   * a place costs besides. */
  place(candidates, most, more = () => 0) {
    let best = null;
    let least = most;
    for (const box of candidates) {
      if (box.own >= least) continue;
      let cost = this.cost(box, least) + box.own;
      if (cost < least) cost += more(box);
      if (cost < least) [best, least] = [box, cost];
    }
    if (best) this.addBox(best, TEXT);
    return best;
  }
}

/* Do the ways from a to b and from c to d cross? */
function segmentsCross(a, b, c, d) {
  const side = (p, q, r) => (q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x);
  return side(a, b, c) * side(a, b, d) < 0 && side(c, d, a) * side(c, d, b) < 0;
}

function crossesBox([a, b], { x, y, w, h }) {
  const inside = (p) => p.x >= x && p.x <= x + w && p.y >= y && p.y <= y + h;
  if (inside(a) || inside(b)) return true;
  const [p, q] = [{ x, y }, { x: x + w, y: y + h }];
  const [r, s] = [{ x: x + w, y }, { x, y: y + h }];
  return segmentsCross(a, b, p, q) || segmentsCross(a, b, r, s);
}

/* What covers a map now, in pixels of its frame. */
const PARTS = ".map .legend-box, .map .leaflet-control, .map .credit, .map .journey, .map .chosen";

function covers(frame) {
  const base = frame.getBoundingClientRect();
  return [...document.querySelectorAll(PARTS)]
    .map((part) => part.getBoundingClientRect())
    .filter((box) => box.width && box.height)
    .map((box) => ({ x: box.left - base.left, y: box.top - base.top, w: box.width, h: box.height }));
}

return { Cover, SOLID, TEXT, PARTS, covers, crossesBox, segmentsCross };
})();
