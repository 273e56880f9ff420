/* Which part of the map is shown: all of the plan, as large as may be. */
// oxlint-disable-next-line no-unused-vars -- page.js calls it; the page holds both.
function planFit({ plan, map, frame, solos, platoons }) {

const planBounds = L.latLngBounds([]);
for (const solo of solos) for (const part of solo.parts) planBounds.extend(part.points);
for (const one of platoons) planBounds.extend(one.points);
for (const vehicle of plan.vehicles) {
  for (const stop of [vehicle.origin, vehicle.destination]) planBounds.extend([stop.lat, stop.lon]);
}

/* Show the whole plan: as large as may be, but moved aside if it would lie under the legend. */
function showPlan() {
  const small = frame.clientWidth < 600;
  const edge = small ? 26 : 44;
  const legend = document.getElementById("legend");
  const taken = small ? 0 : legend.offsetWidth;
  const choices = [[edge, edge], [edge, taken + edge]];
  for (const [left, right] of choices) {
    map.fitBounds(planBounds, {
      paddingTopLeft: [left, small ? edge + 34 : edge],
      paddingBottomRight: [right, edge + (small && plan.journey ? 66 : 14)],
      maxZoom: 13,
      animate: false,
    });
    if (!taken || !underLegend(legend)) break;
  }
}

function underLegend(legend) {
  const base = frame.getBoundingClientRect();
  const box = legend.getBoundingClientRect();
  const inside = (latlng) => {
    const p = map.latLngToContainerPoint(latlng);
    return (
      p.x > box.left - base.left - 16 && p.x < box.right - base.left + 16 &&
      p.y > box.top - base.top - 16 && p.y < box.bottom - base.top + 16
    );
  };
  return (
    platoons.some((one) => one.points.some(inside)) ||
    solos.some((solo) => solo.parts.some((part) => part.points.some(inside)))
  );
}

return { showPlan };
}
