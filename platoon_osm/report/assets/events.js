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
marks.eventMarks.forEach((made, index) => {
  const open = () => {
    choose(index);
    buttons[index]?.scrollIntoView({ block: "nearest" });
  };
  made.on("click", open);
  made.on("keypress", (event) => {
    if (event.originalEvent.key === "Enter") open();
  });
});
}
