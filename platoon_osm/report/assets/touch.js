/* By touch: one finger scrolls the page where a page lies under the map, two move and zoom the map;
 * and a mark is hit by whoever taps near it. */
// oxlint-disable-next-line no-unused-vars -- page.js calls it; the page holds both.
function wireTouch({ map, frame }) {

const { element, say } = pageElements;

/* Half of 44 px, which a finger hits. */
const NEAR_PX = 22;
const MEANT_PX = 10;
const HINT_MS = 1600;

// -- who gets a finger ----------------------------------------------------------------------------

const narrow = window.matchMedia("(max-width: 899.9px)");
const framed = window.parent !== window;
/* Is there a page to scroll, so that the map leaves it a single finger? */
const yields = () => framed || narrow.matches;

const mark = () => frame.classList.toggle("yields", yields());
narrow.addEventListener("change", mark);
mark();

let kind = "mouse";
// Before Leaflet hears of it: a mouse drags the map anyhow, on a tablet with both too.
frame.addEventListener("pointerdown", (event) => {
  kind = event.pointerType;
  if (kind === "touch" && yields()) map.dragging.disable();
  else map.dragging.enable();
}, true);

const hint = element("div", "touch-hint", say("two-fingers"));
hint.setAttribute("aria-hidden", "true");
frame.after(hint);
let start = null;
let fading = 0;

/* Who draws a finger sideways means to move the map. */
frame.addEventListener("touchstart", ({ touches }) => {
  start = touches.length === 1 ? touches[0] : null;
  if (!start) hint.classList.remove("on");
}, { passive: true });
frame.addEventListener("touchmove", ({ touches }) => {
  if (!start || touches.length !== 1 || !yields()) return;
  const [x, y] = [Math.abs(touches[0].clientX - start.clientX), Math.abs(touches[0].clientY - start.clientY)];
  if (x < MEANT_PX || x < y) return;
  start = null;
  hint.classList.add("on");
  clearTimeout(fading);
  fading = setTimeout(() => hint.classList.remove("on"), HINT_MS);
}, { passive: true });

// -- taps -----------------------------------------------------------------------------------------

/* The mark nearest to a place, if a finger there may mean it. */
function nearest(x, y) {
  let best = null;
  let least = NEAR_PX;
  for (const icon of frame.querySelectorAll(".leaflet-marker-icon.mark:not(.moving)")) {
    const box = icon.getBoundingClientRect();
    const far = Math.max(Math.abs(box.left + box.width / 2 - x), Math.abs(box.top + box.height / 2 - y));
    if (far <= least) [best, least] = [icon, far];
  }
  return best;
}

frame.addEventListener("click", (event) => {
  if (!event.isTrusted || kind !== "touch" || event.target.closest(".mark, .leaflet-control")) return;
  const icon = nearest(event.clientX, event.clientY);
  map.eachLayer((layer) => {
    if (layer instanceof L.Tooltip) layer.close();
  });
  if (!icon) return;
  event.stopPropagation();
  icon.focus({ preventScroll: true });
  icon.click();
}, true);
}
