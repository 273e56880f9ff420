/* A merge or separation is one thing in the list and on the map: choosing it here chooses it there. */
// oxlint-disable-next-line no-unused-vars -- page.js calls it; the page holds both.
function wireEvents({ plan, map, frame, calm }, marks) {
const buttons = [...document.querySelectorAll("button[data-event]")];
const choose = (index) => {
  buttons.forEach((button, i) => {
    if (i === index) button.setAttribute("aria-current", "true");
    else button.removeAttribute("aria-current");
  });
};
buttons.forEach((button, index) => {
  button.addEventListener("click", () => {
    const event = plan.events[index];
    choose(index);
    map.setView([event.lat, event.lon], Math.max(map.getZoom(), 10.5), { animate: !calm.matches });
    if (frame.getBoundingClientRect().bottom < 120) {
      frame.scrollIntoView({ block: "start", behavior: calm.matches ? "auto" : "smooth" });
    }
  });
});
/* Scroll the panel, where it scrolls by itself, to a row; below the map the page stays where it is. */
const panel = document.getElementById("panel");
const reveal = (row) => {
  const [inner, outer] = [row.getBoundingClientRect(), panel.getBoundingClientRect()];
  if (inner.top < outer.top) panel.scrollTop += inner.top - outer.top;
  else if (inner.bottom > outer.bottom) panel.scrollTop += inner.bottom - outer.bottom;
};
marks.eventMarks.forEach((made, index) => {
  const open = () => {
    choose(index);
    if (buttons[index]) reveal(buttons[index]);
  };
  made.on("click", open);
  made.on("keypress", (event) => {
    if (event.originalEvent.key === "Enter") open();
  });
});
}
