/* Callouts of merges and separations, and names of places, where they cover least. */
// oxlint-disable-next-line no-unused-vars -- page.js calls it; the page holds both.
function planLabels({ plan, map, lanes, solos, platoons, routes, marks, hidden }) {

const { element } = pageElements;
const { Cover, SOLID, TEXT } = planCover;
const frame = map.getContainer();
const STEPS = 1e4;

/* Of many callouts, those without a good place are left out: the list has them all. */
const MANY_EVENTS = 8;
const WORST = plan.events.length > MANY_EVENTS ? 60 : SOLID;

const texts = element("canvas").getContext("2d");
const family = getComputedStyle(document.body).fontFamily;

function textWidth(text, font) {
  texts.font = `${font} ${family}`;
  return texts.measureText(text).width;
}

let settled = null;

/* Lay out callouts, then names, for this zoom. Both hold while the map is only moved a little. */
function arrange() {
  const view = map.getBounds().pad(0.75);
  settled = { zoom: map.getZoom(), view, size: map.getSize() };
  const cover = new Cover();
  const origin = map.getPixelOrigin();
  const inLayer = (line) => line.map(({ x, y }) => ({ x: x - origin.x, y: y - origin.y }));
  for (const solo of solos) {
    if (plan.traffic && !solo.access) continue;
    if (hidden.has(`vehicle-${solo.vehicle}`)) continue;
    for (const line of lanes.along(solo.parts, lanes.soloAside)) cover.addLine(inLayer(line), 2);
  }
  for (const points of routes.ribbonLines()) cover.addLine(points, 3);
  for (const one of platoons) {
    if (plan.traffic?.bundled) break;
    if (one.vehicles.every((index) => hidden.has(`vehicle-${index}`))) continue;
    const half = lanes.bandWidth(one.vehicles.length) / 2;
    const across = [-1, -0.5, 0, 0.5, 1].map((share) => share * half);
    for (const line of lanes.along(one.parts, lanes.bandAside, across)) cover.addLine(inLayer(line), 4);
  }
  for (const box of marks.boxes()) cover.addBox(box, SOLID);
  const base = frame.getBoundingClientRect();
  for (const part of document.querySelectorAll(".map .legend-box, .leaflet-control, .map .credit, .journey")) {
    const box = part.getBoundingClientRect();
    const at = map.containerPointToLayerPoint([box.left - base.left, box.top - base.top]);
    cover.addBox({ x: at.x - 4, y: at.y - 4, w: box.width + 8, h: box.height + 8 }, SOLID);
  }
  arrangeCallouts(cover);
  arrangeNames(cover, view);
}

/* Boxes all round a point, near ones first; `own` is what a place costs before it covers anything. */
function* around(at, w, h) {
  for (const away of [16, 24, 34, 46, 62, 84, 112]) {
    const own = away * 0.9;
    for (const share of [-1, -0.85, -0.65, -0.5, -0.35, -0.15, 0]) {
      const x = at.x + share * w + (share === 0 ? 0.4 : share === -1 ? -0.4 : 0) * away;
      yield { x, y: at.y - h - away, w, h, own };
      yield { x, y: at.y + away, w, h, own: own + 1 };
    }
    yield { x: at.x + away, y: at.y - h / 2, w, h, own };
    yield { x: at.x - away - w, y: at.y - h / 2, w, h, own };
  }
}

/* Would a text whose point is in view run out of it? */
function leavesView(at, box) {
  const low = map.containerPointToLayerPoint([0, 0]);
  const high = low.add(map.getSize());
  const seen = at.x > low.x && at.y > low.y && at.x < high.x && at.y < high.y;
  return seen && (box.x < low.x || box.y < low.y || box.x + box.w > high.x || box.y + box.h > high.y);
}

function arrangeCallouts(cover) {
  const pane = map.getPane("callouts");
  pane.replaceChildren();
  // A small screen has no room for them: there the list below the map says the same.
  if (frame.clientWidth < 600) return;
  const callouts = [];
  plan.events.forEach((event, index) => {
    if (!marks.tells(index)) return;
    const at = marks.eventAt(index);
    const box = element("div", "callout");
    const head = element("b", "", event.kind === "merge" ? "Merge: " : "Separation: ");
    head.append(element("bdi", "", event.name));
    box.append(head, element("span", "", event.text));
    pane.append(box);
    const [w, h] = [box.offsetWidth, box.offsetHeight];
    const choices = [...around(at, w, h)].filter((one) => !leavesView(at, one));
    callouts.push({ box, at, w, h, choices, place: cover.place(choices, WORST) });
  });
  // The first to choose may stand in the way of the others: let each choose again, twice.
  for (let round = 0; round < 2; round++) {
    for (const one of callouts) {
      if (one.place) cover.addBox(one.place, -TEXT);
      one.place = cover.place(one.choices, WORST);
    }
  }
  for (const { box, at, w, h, place } of callouts) {
    if (!place) {
      box.remove();
      continue;
    }
    L.DomUtil.setPosition(box, L.point(place.x, place.y).round());
    const near = L.point(
      Math.min(Math.max(at.x, place.x + 6), place.x + w - 6),
      Math.min(Math.max(at.y, place.y), place.y + h),
    );
    if (near.distanceTo(at) > 22) pane.prepend(marks.tie(at, near, false));
  }
}

function* namesHere() {
  const zoom = map.getZoom();
  const least = [0, 6.5, 9.5];
  // From afar a few names orient better than many.
  const room = zoom < planLabels.NEAR_ZOOM ? [10, 32, 0] : [4, 8, 8];
  for (const [lon, lat, name, rank] of plan.towns) {
    if (zoom >= least[rank]) {
      yield { lon, lat, name, room: room[rank], kind: rank ? "town" : "city" };
    }
  }
  if (zoom < planLabels.NEAR_ZOOM) return;
  for (const [lon, lat, name] of plan.junctions) yield { lon, lat, name, room: 4, kind: "junction" };
}

const LONGEST_NAME_PX = 150;

function arrangeNames(cover, view) {
  const pane = map.getPane("names");
  pane.replaceChildren();
  if (hidden.has("names")) return;
  const made = document.createDocumentFragment();
  // Names may touch a line where the map is small, or hardly any would find a place.
  const most = frame.clientWidth < 600 ? 14 : 6;
  for (const { lon, lat, name, room, kind } of namesHere()) {
    const latlng = L.latLng(lat / STEPS, lon / STEPS);
    if (!view.contains(latlng)) continue;
    const at = map.latLngToLayerPoint(latlng);
    const font = kind === "junction" ? "11px" : "12.5px";
    const w = Math.min(Math.ceil(textWidth(name, font)) + 2, LONGEST_NAME_PX) + 6;
    const h = 17;
    const choices = [
      { x: at.x - w / 2, y: at.y - h - 5, w, h, own: 0 },
      { x: at.x - w / 2, y: at.y + 5, w, h, own: 0.3 },
      { x: at.x + 6, y: at.y - h / 2, w, h, own: 0.4 },
      { x: at.x - w - 6, y: at.y - h / 2, w, h, own: 0.5 },
      { x: at.x + 4, y: at.y - h - 4, w, h, own: 0.6 },
      { x: at.x - w - 4, y: at.y + 4, w, h, own: 0.7 },
      { x: at.x - w / 2, y: at.y - h - 14, w, h, own: 1.4 },
      { x: at.x - w / 2, y: at.y + 14, w, h, own: 1.5 },
    ].filter((one) => !leavesView(at, one)).map((one) => ({ ...one, room }));
    const place = cover.place(choices, most);
    if (!place) continue;
    const label = element("div", `name ${kind}`);
    label.append(element("bdi", "", name));
    label.style.width = `${w}px`;
    L.DomUtil.setPosition(label, L.point(place.x, place.y).round());
    made.append(label);
  }
  pane.append(made);
}

map.on("moveend", () => {
  const still = settled && settled.zoom === map.getZoom() && settled.view.contains(map.getBounds());
  if (!still) arrange();
});

return { arrange };
}

/* From this zoom on, junctions show. */
planLabels.NEAR_ZOOM = 8.75;
