/* The live map of a plan. It reads one JSON document (docs/report.md) and a Leaflet map named
 * map_plan that the lines above have made; the scripts before it hold what it is put together from.
 * Text reaches the page through textContent alone. */
(() => {
"use strict";

const scene = planScene();
const { plan, map, frame, hidden, groups, selection, solos, platoons } = scene;
const lanes = planLanes(map);
const routes = planRoutes(scene, lanes);
const marks = planMarks({ plan, map, hidden, selection, tooltip: planTips.tooltip });
const labels = planLabels({ plan, map, lanes, solos, platoons, routes, marks, hidden });

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
const journey = playJourney(scene);
const fit = planFit(scene, { marks, journey, redraw });
addControls(scene, fit);
fit.showPlan();
drawGround(scene);
routes.restack();
wireLegend({ map, groups, hidden, settle });
const events = wireEvents(scene, marks);
wireFind(scene, events.open, fit.showWay);
sayChosen(scene);
selection.on((_chosen, _hinted, changed) => {
  if (!changed) return;
  if (plan.traffic) marks.show();
  labels.arrange();
});
wireTables(scene);
wireData(scene);
rovePage(map, frame, document.getElementById("panel"));
map.on("zoomend", () => {
  if (!fit.isWorking()) redraw();
});
fit.watch();
wireTouch(scene);
const view = planView(map);
view.part(...planView.ofLanguage());
view.part(...planView.ofMap(map, fit));
view.part(...planView.ofVehicle(map, plan, selection));
if (journey) view.part(...planView.ofMoment(journey));
view.restore();
view.watch();
frame.dataset.ready = "true";
})();
