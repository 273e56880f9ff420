/* Many things, one stop of the Tab key: arrow keys go on among them, Home and End to the ends. */
// oxlint-disable-next-line no-unused-vars -- page.js calls it; the page holds both.
const planRovers = (() => {

const STEPS = { ArrowRight: 1, ArrowDown: 1, ArrowLeft: -1, ArrowUp: -1 };

/* `find` returns what `box` holds now, in order. `observed` are places where that changes. */
function rove(box, find, observed = []) {
  let current = null;
  const usable = () => find().filter((item) => item.checkVisibility());
  const refresh = () => {
    const items = usable();
    if (!items.includes(current)) current = items[0] ?? null;
    for (const item of find()) {
      const index = item === current ? "0" : "-1";
      if (item.getAttribute("tabindex") !== index) item.setAttribute("tabindex", index);
    }
  };
  box.addEventListener("focusin", ({ target }) => {
    if (target === current || !find().includes(target)) return;
    current = target;
    refresh();
  });
  box.addEventListener("keydown", (event) => {
    const { target, key } = event;
    if (event.altKey || event.ctrlKey || event.metaKey) return;
    const items = usable();
    const at = items.indexOf(target);
    if (at < 0) return;
    const to = key === "Home" ? 0 : key === "End" ? items.length - 1 : at + (STEPS[key] ?? 0);
    if (to === at || !items[to]) return;
    event.preventDefault();
    event.stopPropagation();
    items[to].focus();
  });
  const watcher = new MutationObserver(refresh);
  for (const place of observed) watcher.observe(place, { childList: true, subtree: true });
  refresh();
  return refresh;
}

/* A box that scrolls is a stop of its own only if nothing in it is, and only while it scrolls. All are
 * measured before any is changed, or each would have the page laid out anew; what is folded away is
 * measured when it opens. */
function scrolling(boxes) {
  const stops = boxes.map((box) => !box.closest("details:not([open])") &&
    box.scrollHeight > box.clientHeight + 1 && !box.querySelector("[role='button'], button, a, input, summary"));
  boxes.forEach((box, i) => {
    if (stops[i]) box.setAttribute("tabindex", "0");
    else box.removeAttribute("tabindex");
  });
}

return { rove, scrolling };
})();

/* Of a page: marks and lines on the map, rows of each table, points of each list, heads of groups. */
// oxlint-disable-next-line no-unused-vars -- page.js calls it; the page holds both.
function rovePage(map, frame, panel) {
  const { rove, scrolling } = planRovers;
  const panes = ["markerPane", "routes", "platoons", "lifted"].map((name) => map.getPane(name));
  const within = (box, what) => () => [...box.querySelectorAll(what)];
  rove(frame, within(frame, ".leaflet-marker-pane .mark, path.route[aria-label]"), panes);
  for (const table of panel.querySelectorAll("table")) {
    if (table.tHead) rove(table.tHead, within(table.tHead, "button"), [table.tHead]);
    for (const body of table.tBodies) rove(body, within(body, "[role='button']"), [body]);
  }
  for (const list of panel.querySelectorAll(".events")) rove(list, within(list, "button"));
  rove(panel, within(panel, ".group > summary"));
  const settle = () => scrolling([...panel.querySelectorAll("[role='region']")]);
  panel.addEventListener("toggle", settle, true);
  window.addEventListener("resize", settle);
  settle();
}
