/* A merge or separation is one thing in the list and on the map: choosing it here chooses it there. */
// oxlint-disable-next-line no-unused-vars -- page.js calls it; the page holds both.
function wireEvents({ plan, map, frame, calm }, marks) {
const buttons = [...document.querySelectorAll("button[data-event]")];
const choose = (index) => {
  buttons.forEach((button) => {
    if (Number(button.dataset.event) === index) button.setAttribute("aria-current", "true");
    else button.removeAttribute("aria-current");
  });
};
/* Scroll the panel, where it scrolls by itself, to a row; below the map the page stays where it is. */
const panel = document.getElementById("panel");
const reveal = (row) => {
  const [inner, outer] = [row.getBoundingClientRect(), panel.getBoundingClientRect()];
  if (inner.top < outer.top) panel.scrollTop += inner.top - outer.top;
  else if (inner.bottom > outer.bottom) panel.scrollTop += inner.bottom - outer.bottom;
};
/* Show an event on the map, and which it is in the list. */
function open(index) {
  const event = plan.events[index];
  choose(index);
  map.setView([event.lat, event.lon], Math.max(map.getZoom(), 10.5), { animate: !calm.matches });
  if (frame.getBoundingClientRect().bottom < 120) {
    frame.scrollIntoView({ block: "start", behavior: calm.matches ? "auto" : "smooth" });
  }
}
for (const button of buttons) {
  button.addEventListener("click", () => open(Number(button.dataset.event)));
}
marks.onEvent((index) => {
  choose(index);
  const button = buttons.find((one) => Number(one.dataset.event) === index);
  if (button) reveal(button);
});

return { open };
}
