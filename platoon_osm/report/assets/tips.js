/* What marks and lines say when they are pointed at. */
// oxlint-disable-next-line no-unused-vars -- other scripts of the page use it.
const planTips = (() => {

const { element, isolated } = pageElements;

/* What a mark or line says when it is pointed at: a head, lines, and perhaps a table. */
function tooltip({ head, lines, columns = [], rows = [], more = "" }) {
  const box = element("div", "tip");
  box.append(element("bdi", "head", head));
  for (const line of lines) if (line) box.append(element("bdi", "line", line));
  if (rows.length) {
    const table = element("table");
    for (const [kind, cells] of [["th", columns], ...rows.map((row) => ["td", row])]) {
      const row = element("tr");
      cells.forEach((text, i) => row.append(element(i ? kind : "th", "", text)));
      table.append(row);
    }
    box.append(table);
  }
  if (more) box.append(element("bdi", "line", more));
  return box;
}

/* Let a line be reached by keyboard; Leaflet shows its tooltip while it has the focus. */
function reachable(line, tip) {
  line.on("add", () => {
    const path = line.getElement();
    path.setAttribute("tabindex", "0");
    path.setAttribute("role", "img");
    path.setAttribute("aria-label", isolated([tip.head, ...tip.lines].join(", ")));
  });
  return line.bindTooltip(tooltip(tip), { sticky: true, opacity: 1 });
}

return { tooltip, reachable };
})();
