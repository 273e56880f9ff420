/* The document of a page as docs/report.md has it; pages/packing.py says how it is written short. */
// oxlint-disable-next-line no-unused-vars -- scene.js calls it; the page holds both.
function unpacked(value) {
  if (Array.isArray(value)) return value.map(unpacked);
  if (value === null || typeof value !== "object") return value;
  if ("*" in value) return Array(value.n).fill(unpacked(value["*"]));
  if ("|" in value) {
    const few = unpacked(value["|"]);
    return value.i.map((at) => few[at]);
  }
  if ("#" in value) {
    const every = unpacked(value.of);
    let at = 0;
    return unpacked(value["#"]).map((size) => every.slice(at, (at += size)));
  }
  const fields = Object.entries(value["="] ?? value).map(([name, one]) => [name, unpacked(one)]);
  if (!("=" in value)) return Object.fromEntries(fields);
  return fields[0][1].map((_, i) => Object.fromEntries(fields.map(([name, own]) => [name, own[i]])));
}
