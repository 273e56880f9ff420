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

// -- where a tip stands ---------------------------------------------------------------------------

const WIDEST_PX = 320;
const EDGE_PX = 5;
/* Between what is pointed at and the tip: its arrow. */
const ARROW_PX = 7;
const POINTER_PX = 8;
const SIDES = { top: ["top", "bottom", "right", "left"], auto: ["right", "left", "top", "bottom"] };

/* Tips stand over all that covers the map, which Leaflet's own place for them does not. */
function stage(map) {
  const frame = map.getContainer();
  const found = frame.parentElement.querySelector(":scope > .tips");
  if (found) return found;
  const made = element("div", "tips");
  frame.after(made);
  map.on("move", () => {
    map.eachLayer((layer) => {
      if (layer instanceof L.Tooltip) layer._updatePosition();
    });
  });
  return made;
}

/* What a tip belongs to, in pixels of the frame: a mark as it stands, or a place on a line. */
function pointedAt(tip, at) {
  const icon = tip._source?.getElement?.();
  if (!icon || !(tip._source instanceof L.Marker)) {
    return { x: at.x - POINTER_PX, y: at.y - POINTER_PX, w: 2 * POINTER_PX, h: 2 * POINTER_PX };
  }
  const base = tip._map.getContainer().getBoundingClientRect();
  const box = icon.getBoundingClientRect();
  return { x: box.left - base.left, y: box.top - base.top, w: box.width, h: box.height };
}

const within = (value, low, high) => Math.max(low, Math.min(value, high));

/* Where a tip of some size stands on a side of a box, pushed into the frame; `over` is how much of
 * the box it then hides, `aside` how far its middle is from the box's. */
function placed(side, box, w, h, size) {
  const [midX, midY] = [box.x + box.w / 2, box.y + box.h / 2];
  const free = {
    top: [midX - w / 2, box.y - h - ARROW_PX], bottom: [midX - w / 2, box.y + box.h + ARROW_PX],
    left: [box.x - w - ARROW_PX, midY - h / 2], right: [box.x + box.w + ARROW_PX, midY - h / 2],
  }[side];
  const x = within(free[0], EDGE_PX, Math.max(EDGE_PX, size.x - EDGE_PX - w));
  const y = within(free[1], EDGE_PX, Math.max(EDGE_PX, size.y - EDGE_PX - h));
  const upright = side === "top" || side === "bottom";
  return { side, x, y, over: upright ? Math.abs(y - free[1]) : Math.abs(x - free[0]),
    aside: upright ? free[0] - x : free[1] - y, half: (upright ? w : h) / 2 };
}

L.Tooltip.include({
  getPane() {
    return stage(this._map);
  },
  _updateLayout() {
    const size = this._map.getSize();
    this._container.style.maxWidth = `${Math.min(WIDEST_PX, size.x - 2 * EDGE_PX)}px`;
    this._container.style.maxHeight = `${size.y - 2 * EDGE_PX}px`;
  },
  _setPosition(layerPoint) {
    const box = this._container;
    const target = pointedAt(this, this._map.layerPointToContainerPoint(layerPoint));
    const sides = SIDES[this.options.direction] ?? SIDES.auto;
    const size = this._map.getSize();
    const places = sides.map((side) => placed(side, target, box.offsetWidth, box.offsetHeight, size));
    const place = places.find((one) => !one.over) ?? places.sort((a, b) => a.over - b.over)[0];
    for (const side of SIDES.top) box.classList.toggle(`leaflet-tooltip-${side}`, side === place.side && !place.over);
    box.style.setProperty("--aside", `${within(place.aside, 12 - place.half, place.half - 12)}px`);
    L.DomUtil.setPosition(box, L.point(place.x, place.y).round());
  },
});

return { tooltip, reachable };
})();
