/* What of the map is taken, as a grid of small cells. */
// oxlint-disable-next-line no-unused-vars -- other scripts of the page use it.
const planCover = (() => {

const CELL = 5;
/* A line may be covered at need, marks and texts never; texts also want room between them. */
const SOLID = 1e3;
const TEXT = 1e6;

class Cover {
  constructor() {
    this.weights = new Map();
  }

  key(x, y) {
    return Math.floor(x / CELL) * 1048576 + Math.floor(y / CELL);
  }

  addLine(points, weight) {
    for (let i = 1; i < points.length; i++) {
      const [a, b] = [points[i - 1], points[i]];
      const steps = Math.max(1, Math.ceil(Math.hypot(b.x - a.x, b.y - a.y) / CELL));
      for (let s = 0; s <= steps; s++) {
        const key = this.key(a.x + ((b.x - a.x) * s) / steps, a.y + ((b.y - a.y) * s) / steps);
        this.weights.set(key, Math.max(this.weights.get(key) ?? 0, weight));
      }
    }
  }

  addBox(box, weight) {
    this.over(box, (key, old) => this.weights.set(key, old + weight));
  }

  cost(box) {
    let sum = 0;
    this.over(box, (_, weight) => {
      sum += weight;
    });
    return sum;
  }

  /* Infinite if another text lies within the room that a box wants round itself. */
  crowding({ x, y, w, h, room }) {
    const wide = { x: x - room, y: y - room / 2, w: w + 2 * room, h: h + room };
    return this.cost(wide) >= TEXT ? Infinity : 0;
  }

  over(box, visit) {
    for (let x = Math.floor(box.x / CELL); x <= Math.floor((box.x + box.w) / CELL); x++) {
      for (let y = Math.floor(box.y / CELL); y <= Math.floor((box.y + box.h) / CELL); y++) {
        const key = x * 1048576 + y;
        visit(key, this.weights.get(key) ?? 0);
      }
    }
  }

  /* The candidate that covers least, taken; null if each would cover `most` or more. `more` is what
   * a place costs besides. */
  place(candidates, most, more = () => 0) {
    let best = null;
    let least = most;
    for (const box of candidates) {
      if (box.own >= least) continue;
      let cost = this.cost(box) + box.own;
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

return { Cover, SOLID, TEXT, crossesBox, segmentsCross };
})();
