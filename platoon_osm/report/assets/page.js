/* The live map of a plan. It reads one JSON document (docs/report.md) and a Leaflet map named
 * map_plan that the lines above have made; the scripts before it hold what it is put together from.
 * Text reaches the page through textContent alone. */
(() => {
"use strict";

const scene = planScene();
const { plan, map, frame, calm, hidden, groups, solos, platoons } = scene;
const { drawn, isolated } = pageElements;
const lanes = planLanes(map);
const routes = planRoutes(scene, lanes);
const marks = planMarks({ plan, map, hidden, tooltip: planTips.tooltip });
const labels = planLabels({ plan, map, lanes, solos, platoons, marks, hidden });

/* Draw what depends on the zoom, and what stands beside it. */
function redraw() {
  routes.redraw();
  marks.show();
  labels.arrange();
}

/* Bring all that the legend has a say in up to date. */
function settle() {
  routes.showBands();
  marks.show();
  routes.restack();
  labels.arrange();
}

// What covers the map is there before the plan is fitted into what it leaves.
const journey = playJourney({ plan, map, solos, platoons, calm, drawn, isolated, hidden });
const fit = planFit(scene, { marks, journey, redraw });
addControls(scene, fit);
fit.showPlan();
drawGround(scene);
routes.restack();
wireLegend({ map, groups, hidden, settle });
wireEvents(scene, marks);
map.on("zoomend", () => {
  if (!fit.isWorking()) redraw();
});
fit.watch();
wireTouch(scene);
const view = planView(map);
view.part(...planView.ofMap(map, fit));
if (journey) view.part(...planView.ofMoment(journey));
view.restore();
view.watch();
frame.dataset.ready = "true";
})();
