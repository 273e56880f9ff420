/* Buttons on the map and its scale. */
// oxlint-disable-next-line no-unused-vars -- page.js calls it; the page holds both.
function addControls({ map }, { showPlan }) {

const { element, drawn, say } = pageElements;

/* Back to the whole plan: a button beside the zoom buttons. */
const Whole = L.Control.extend({
  options: { position: "topleft" },
  onAdd() {
    const bar = element("div", "leaflet-bar leaflet-control");
    const button = element("a", "whole");
    button.href = "#";
    button.setAttribute("role", "button");
    button.title = say("whole");
    button.setAttribute("aria-label", button.title);
    button.append(drawn("svg", { viewBox: "0 0 16 16", width: 16, height: 16, "aria-hidden": true },
      drawn("path", {
        d: "M2 6V2H6M10 2H14V6M14 10V14H10M6 14H2V10", fill: "none", stroke: "#17202b",
        "stroke-width": 2,
      })));
    L.DomEvent.disableClickPropagation(bar);
    button.addEventListener("click", (event) => {
      event.preventDefault();
      showPlan();
    });
    bar.append(button);
    return bar;
  },
});

L.control.zoom({ position: "topleft", zoomInTitle: say("zoom-in"), zoomOutTitle: say("zoom-out") }).addTo(map);
new Whole().addTo(map);
L.control.scale({ position: "bottomleft", metric: true, imperial: false, maxWidth: 100 }).addTo(map);
}
