/* The live map of a plan. It reads one JSON document (docs/report.md) and a Leaflet map named
 * map_plan that the lines above have made; the scripts before it hold what it is put together from.
 * Text reaches the page through textContent alone. */
(() => {
"use strict";

const scene = planScene();
const { plan, map, frame, calm, hidden, groups, solos, platoons } = scene;
const { drawn, isolated } = pageElements;
const lanes = planLanes(map);
const fit = planFit(scene);

addControls(scene, fit);
fit.showPlan();
drawGround(scene);
const routes = planRoutes(scene, lanes);
const marks = planMarks({ plan, map, hidden, tooltip: planTips.tooltip });
const labels = planLabels({ plan, map, lanes, solos, platoons, marks, hidden });

/* Bring all that the legend has a say in up to date. */
function settle() {
  routes.showBands();
  marks.show();
  routes.restack();
  labels.arrange();
}

wireLegend({ map, groups, hidden, settle });
wireEvents(scene, marks);
routes.redraw();
routes.restack();
marks.show();
playJourney({ plan, map, solos, platoons, calm, drawn, isolated, hidden });
labels.arrange();

let width = frame.clientWidth;
map.on("zoomend", () => {
  routes.redraw();
  marks.show();
  labels.arrange();
});
map.on("resize", () => {
  // Below 600 px lines are finer: crossing that width redraws them.
  if ((width < 600) !== (frame.clientWidth < 600)) fit.showPlan();
  width = frame.clientWidth;
  routes.redraw();
  marks.show();
  labels.arrange();
});
frame.dataset.ready = "true";
})();
