/* Lines as short text. */
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

return { decoded, decodedLines };
})();
