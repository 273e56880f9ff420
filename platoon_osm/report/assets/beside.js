/* Lines beside roads, in pixels: parallel curves that neither jag nor loop where a road bends more
 * tightly than the lines are wide. maps/beside.py tells how, and does the same for still maps. */
// oxlint-disable-next-line no-unused-vars -- other scripts of the page use it.
const planBeside = (() => {

const TOLERANCE = 0.6;
const ROUNDING = 2;
const STEP = 2;
const [RAMP, LEAST_RAMP] = [2.5, 12];
const [LOOP, LEAST_LOOP] = [10, 24];
const SHARP = 0.6;
const FINE = 0.2;

const apart = (a, b) => Math.hypot(b.x - a.x, b.y - a.y);

/* A line without points that move it by less than `tolerance`. */
function thinned(line, tolerance) {
  if (line.length < 3) return line;
  const kept = new Uint8Array(line.length);
  kept[0] = kept[line.length - 1] = 1;
  const open = [[0, line.length - 1]];
  while (open.length) {
    const [a, b] = open.pop();
    const { x, y } = line[a];
    const [dx, dy] = [line[b].x - x, line[b].y - y];
    const square = dx * dx + dy * dy;
    let [far, most] = [-1, tolerance * tolerance];
    for (let i = a + 1; i < b; i++) {
      const [px, py] = [line[i].x - x, line[i].y - y];
      const share = square ? Math.min(Math.max((px * dx + py * dy) / square, 0), 1) : 0;
      const away = (px - share * dx) ** 2 + (py - share * dy) ** 2;
      if (away > most) [far, most] = [i, away];
    }
    if (far < 0) continue;
    kept[far] = 1;
    open.push([a, far], [far, b]);
  }
  return line.filter((_, i) => kept[i]);
}

const greatest = (numbers) => numbers.reduce((most, one) => Math.max(most, one), 0);

function arcsOf(line) {
  const arcs = [0];
  for (let i = 1; i < line.length; i++) arcs.push(arcs[i - 1] + apart(line[i - 1], line[i]));
  return arcs;
}

/* Roads as one line, and which of its points are the borders between them. */
function joined(roads) {
  const line = [];
  const borders = [];
  for (const points of roads) {
    if (line.length) borders.push(line.length - 1);
    for (const p of thinned(points, TOLERANCE)) {
      const last = line[line.length - 1];
      if (!last || last.x !== p.x || last.y !== p.y) line.push(p);
    }
  }
  return { line, borders };
}

/* What changes from road to road, with gentle ramps between. */
function rampsOf(borders, asides) {
  const halves = borders.map((_, i) => Math.max(LEAST_RAMP, RAMP * Math.abs(asides[i + 1] - asides[i])));
  const along = (at, values) => {
    let found = values[0];
    for (let i = 0; i < borders.length; i++) {
      const step = values[i + 1] - values[i];
      if (!step) continue;
      const t = Math.min(Math.max((at - borders[i]) / halves[i], -1), 1);
      found += step * (t < 0 ? (1 + t) ** 2 / 2 : 1 - (1 - t) ** 2 / 2);
    }
    return found;
  };
  const spans = borders.flatMap((at, i) =>
    asides[i] === asides[i + 1] ? [] : [[at - halves[i] - STEP, at + halves[i] + STEP]]);
  return { along, spans };
}

/* Where points of the rounded road are needed: near its bends, and on ramps. */
function samples(arcs, ramps, rounding) {
  const length = arcs[arcs.length - 1];
  const half = (at) => ramps.along(at, rounding);
  const wide = greatest(rounding) + STEP;
  const found = [0, length];
  const near = [...arcs.map((at) => [at - wide, at + wide]), ...ramps.spans];
  near.sort((a, b) => a[0] - b[0]);
  let next = 1;
  let k = 1;
  for (const [from, to] of near) {
    next = Math.max(next, Math.ceil(from / STEP));
    for (; next * STEP < Math.min(to, length); next++) {
      const at = next * STEP;
      while (k < arcs.length - 1 && arcs[k] < at) k++;
      const nearest = Math.min(at - arcs[k - 1], arcs[k] - at);
      const h = half(at);
      if ((nearest < h + STEP && h >= STEP / 2) ||
          ramps.spans.some((span) => at > span[0] && at < span[1])) found.push(at);
    }
  }
  for (const at of arcs) if (half(at) < STEP / 2) found.push(at);
  found.sort((a, b) => a - b);
  return found.filter((at, i) => !i || at !== found[i - 1]);
}

/* A line that goes on beyond its ends, mirrored in them, so that these stay where they are. */
function mirrored(line, arcs, reach) {
  const last = arcs.length - 1;
  const [points, places] = [[...line], [...arcs]];
  const mirror = (i, end) => ({ x: 2 * line[end].x - line[i].x, y: 2 * line[end].y - line[i].y });
  for (let i = 1; i <= last && arcs[i - 1] <= reach; i++) {
    points.unshift(mirror(i, 0));
    places.unshift(-arcs[i]);
  }
  for (let i = last - 1; i >= 0 && arcs[last] - arcs[i + 1] <= reach; i--) {
    points.push(mirror(i, last));
    places.push(2 * arcs[last] - arcs[i]);
  }
  return { points, places };
}

/* The mean of a line round each place, with weights that fall off evenly to `half`. */
function rounded(line, arcs, at, half) {
  const { points, places } = mirrored(line, arcs, greatest(half) + STEP);
  let k = 0;
  return at.map((s, number) => {
    const h = half[number];
    const exact = h < STEP / 2;
    const from = exact ? s : s - h;
    while (k > 0 && places[k] > from) k--;
    while (k < places.length - 2 && places[k + 1] <= from) k++;
    let [x, y] = [0, 0];
    for (let i = k; i < places.length - 1 && (exact ? i === k : places[i] < s + h); i++) {
      const span = places[i + 1] - places[i];
      const [mx, my] = [(points[i + 1].x - points[i].x) / span, (points[i + 1].y - points[i].y) / span];
      const [x0, y0] = [points[i].x + mx * (s - places[i]), points[i].y + my * (s - places[i])];
      if (exact) return { x: x0, y: y0 };
      // Left and right of the place the weights fall off either way.
      for (const side of [-1, 1]) {
        const a = Math.max(places[i] - s, side < 0 ? -h : 0);
        const b = Math.min(places[i + 1] - s, side < 0 ? 0 : h);
        if (b <= a) continue;
        const area = b - a - (side * (b * b - a * a)) / (2 * h);
        const lever = (b * b - a * a) / 2 - (side * (b ** 3 - a ** 3)) / (3 * h);
        x += x0 * area + mx * lever;
        y += y0 * area + my * lever;
      }
    }
    return { x: x / h, y: y / h };
  });
}

const turned = (from, to) => {
  const turn = to - from;
  return turn - 2 * Math.PI * Math.round(turn / (2 * Math.PI));
};

const headings = (line) =>
  line.slice(1).map((p, i) => Math.atan2(p.y - line[i].y, p.x - line[i].x));

/* Points of a rounded road, each with what is right of it: several at a sharp corner. */
function withNormals(line, asides) {
  const distinct = [];
  const aside = [];
  line.forEach((p, i) => {
    const last = distinct[distinct.length - 1];
    if (last && apart(last, p) <= 1e-9) return;
    distinct.push(p);
    aside.push(asides[i]);
  });
  const heading = headings(distinct);
  const found = [];
  distinct.forEach((p, i) => {
    const before = heading[Math.max(i - 1, 0)] ?? 0;
    const turn = turned(before, heading[Math.min(i, heading.length - 1)] ?? 0);
    const fan = Math.abs(turn) > SHARP ? Math.ceil(Math.abs(turn) / (SHARP / 2)) : 0;
    for (let j = 0; j <= fan; j++) {
      const angle = before + turn * (fan ? j / fan : 0.5);
      found.push({ x: p.x, y: p.y, nx: -Math.sin(angle), ny: Math.cos(angle), aside: aside[i] });
    }
  });
  return found;
}

/* The line `offset` beside that, without the loops of bends tighter than it is aside. */
function beside(road, offset) {
  const line = road.map(({ x, y, nx, ny, aside }) => ({ x: x + nx * (aside + offset), y: y + ny * (aside + offset) }));
  const most = greatest(road.map(({ aside }) => Math.abs(aside + offset)));
  if (line.length < 3 || !most) return thinned(line, FINE);
  // Where it runs backwards it is on the far side of the bend's centre.
  const forward = line.slice(1).map((p, i) =>
    (p.x - line[i].x) * (road[i].ny + road[i + 1].ny) - (p.y - line[i].y) * (road[i].nx + road[i + 1].nx) >= 0);
  const ahead = line.filter((_, i) => i === 0 || i === line.length - 1 || forward[i - 1] || forward[i]);
  let found = withoutLoops(ahead, Math.max(LEAST_LOOP, LOOP * most));
  const heading = headings(found);
  if (heading.some((one, i) => i && Math.abs(turned(heading[i - 1], one)) > SHARP)) {
    const arcs = arcsOf(found);
    const length = arcs[arcs.length - 1];
    const at = [];
    for (let s = 0; s < length; s += STEP) at.push(s);
    at.push(length);
    const half = Math.min(length, 4 + most / 3);
    found = rounded(found, arcs, at, at.map(() => half));
  }
  return thinned(found, FINE);
}

/* Cut a line short where it crosses itself within some length. */
function withoutLoops(points, most) {
  const line = points.filter((p, i) => !i || apart(points[i - 1], p) > 1e-9);
  const arcs = arcsOf(line);
  const out = [];
  let at = 0;
  while (at < line.length) {
    out.push(line[at]);
    let [end, share] = [0, 0];
    for (let j = at + 2; j < line.length - 1 && arcs[j] - arcs[at + 1] <= most; j++) {
      const found = crossing(line[at], line[at + 1], line[j], line[j + 1]);
      if (found !== null) [end, share] = [j, found];
    }
    if (end) {
      const [a, b] = [line[at], line[at + 1]];
      out.push({ x: a.x + (b.x - a.x) * share, y: a.y + (b.y - a.y) * share });
    }
    at = end ? end + 1 : at + 1;
  }
  return out;
}

/* Which share of the way from a to b the way from c to d crosses it at; null if it does not. */
function crossing(a, b, c, d) {
  const [px, py, qx, qy] = [b.x - a.x, b.y - a.y, d.x - c.x, d.y - c.y];
  const [gx, gy] = [c.x - a.x, c.y - a.y];
  // Most are too far from each other.
  if (Math.abs(gx) > Math.abs(px) + Math.abs(qx) || Math.abs(gy) > Math.abs(py) + Math.abs(qy)) return null;
  const area = px * qy - py * qx;
  if (!area) return null;
  const [s, t] = [(gx * qy - gy * qx) / area, (gx * py - gy * px) / area];
  return s >= 0 && s <= 1 && t >= 0 && t <= 1 ? s : null;
}

/* Lines beside one another along the same roads: for each road its points and how far right of it
 * the middle of the lines lies; for each line how far right of that middle it lies. */
function laidBeside(roads, offsets) {
  const { line, borders } = joined(roads.map(({ points }) => points));
  const asides = roads.map(({ aside }) => aside);
  const reaches = asides.map((aside) => greatest(offsets.map((offset) => Math.abs(aside + offset))));
  const reach = greatest(reaches);
  if (line.length < 2 || !reach) return offsets.map(() => line);
  const arcs = arcsOf(line);
  const ramps = rampsOf(borders.map((i) => arcs[i]), asides);
  const share = Math.min(ROUNDING, arcs[arcs.length - 1] / reach);
  const rounding = reaches.map((one) => share * one);
  const at = samples(arcs, ramps, rounding);
  const half = at.map((s) => ramps.along(s, rounding));
  const road = withNormals(rounded(line, arcs, at, half), at.map((s) => ramps.along(s, asides)));
  return offsets.map((offset) => beside(road, offset));
}

const laid = (roads) => laidBeside(roads, [0])[0];

return { laid, laidBeside };
})();
