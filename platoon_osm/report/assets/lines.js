/* Lines as short text, and lines moved aside. */
// oxlint-disable-next-line no-unused-vars -- other scripts of the page use it.
const planLines = (() => {

function decoded(text, steps) {
  const points = [];
  let at = 0;
  let lat = 0;
  let lon = 0;
  const next = () => {
    let value = 0;
    let shift = 0;
    let bits;
    do {
      bits = text.charCodeAt(at++) - 63;
      value |= (bits & 31) << shift;
      shift += 5;
    } while (bits >= 32);
    return value & 1 ? ~(value >> 1) : value >> 1;
  };
  while (at < text.length) {
    lat += next();
    lon += next();
    points.push([lat / steps, lon / steps]);
  }
  return points;
}

/* Many lines in one text, each counted from the first point of the one before. */
function decodedLines(text, steps) {
  let start = [0, 0];
  return text.split(" ").filter(Boolean).map((line) => {
    const points = decoded(line, steps).map(([lat, lon]) => [lat + start[0], lon + start[1]]);
    start = points[0];
    return points;
  });
}

/* The line `aside` pixels to the right of a line of pixels; corners are mitred within limits. */
function shifted(points, aside) {
  const line = points.filter((p, i) => i === 0 || !p.equals(points[i - 1]));
  if (!aside || line.length < 2) return line;
  const normals = [];
  for (let i = 1; i < line.length; i++) {
    const step = line[i].subtract(line[i - 1]);
    const length = Math.hypot(step.x, step.y);
    normals.push(L.point(-step.y / length, step.x / length));
  }
  return line.map((p, i) => {
    const mitre = normals[Math.max(i - 1, 0)].add(normals[Math.min(i, normals.length - 1)]);
    // |mitre| is 2 cos(half the turn): beyond 120 degrees it would run away.
    const square = Math.max(mitre.x ** 2 + mitre.y ** 2, 1);
    return p.add(mitre.multiplyBy((2 * aside) / square));
  });
}

const SHORT_PX = 12;

/* One line along roads that each lie aside in their own measure. Roads too short to be seen follow
 * their neighbour, or the line would start aside and back within a few pixels. */
function laid(roads, tolerance) {
  const runs = [];
  for (const { points, aside } of roads) {
    let length = 0;
    for (let i = 1; i < points.length; i++) length += points[i].distanceTo(points[i - 1]);
    const last = runs[runs.length - 1];
    if (last && (last.aside === aside || length < SHORT_PX || last.length < SHORT_PX)) {
      if (length > last.length) last.aside = aside;
      last.points = [...last.points, ...points];
      last.length += length;
    } else {
      runs.push({ points, aside, length });
    }
  }
  // Loops of a ramp, tighter than the line is aside, would become stars.
  return runs.flatMap(({ points, aside }) =>
    shifted(L.LineUtil.simplify(points, Math.max(tolerance, Math.abs(aside) / 5)), aside));
}

return { decoded, decodedLines, laid };
})();
