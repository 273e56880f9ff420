/* Callouts of merges and separations, and names of places, where they cover least. */
// oxlint-disable-next-line no-unused-vars -- page.js calls it; the page holds both.
function planLabels({ plan, map, lanes, solos, platoons, routes, marks, hidden }) {

const { element, say } = pageElements;
const { Cover, SOLID, TEXT, covers, crossesBox, segmentsCross } = planCover;
const frame = map.getContainer();
const STEPS = 1e4;

/* Of many callouts, those without a good place are left out: their marks are tagged with their
 * numbers in the list, which has them all. */
const MANY_EVENTS = 8;
const WORST = plan.events.length > MANY_EVENTS ? 60 : SOLID;

const texts = element("canvas").getContext("2d");
const family = getComputedStyle(document.body).fontFamily;

function textWidth(text, font) {
  texts.font = `${font} ${family}`;
  return texts.measureText(text).width;
}

const put = (box, { x, y }) => L.DomUtil.setPosition(box, L.point(x, y, true));

/* Texts that had rather not be there than be cut by the edge of the view, and where they are. */
let small = [];
let settled = null;

/* Lay out callouts, then names, for this zoom. Both hold while the map is only moved a little. */
function arrange() {
  const view = map.getBounds().pad(0.75);
  settled = { zoom: map.getZoom(), view, size: map.getSize() };
  const { x: left, y: top, w: wide, h: tall } = viewBox();
  const reach = { x: left - 0.75 * wide, y: top - 0.75 * tall, w: 2.5 * wide, h: 2.5 * tall };
  const cover = new Cover(reach);
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
  for (const { x, y, w, h } of covers(frame)) {
    const at = map.containerPointToLayerPoint([x - 4, y - 4]);
    cover.addBox({ x: at.x, y: at.y, w: w + 8, h: h + 8 }, SOLID);
  }
  small = [];
  arrangeCallouts(cover, reach);
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

/* The view in pixels of the layer. */
function viewBox() {
  const low = map.containerPointToLayerPoint([0, 0]);
  const { x: w, y: h } = map.getSize();
  return { x: low.x, y: low.y, w, h };
}

const isWithin = ({ x, y, w, h }, view) =>
  x >= view.x && y >= view.y && x + w <= view.x + view.w && y + h <= view.y + view.h;

/* Does the edge of the view cut a box? One that lies outside altogether may come in later. */
function isCut(box, view) {
  const apart = box.x + box.w <= view.x || box.x >= view.x + view.w ||
    box.y + box.h <= view.y || box.y >= view.y + view.h;
  return !apart && !isWithin(box, view);
}

const NEAR_PX = 22;

/* The leader from a point to its box; null where the box is near enough to do without. */
function leaderOf(at, { x, y, w, h }) {
  // Not at a round corner, but not under the box either.
  const inset = at.y >= y && at.y <= y + h ? 0 : 6;
  const near = L.point(
    Math.min(Math.max(at.x, x + inset), x + w - inset), Math.min(Math.max(at.y, y), y + h));
  return near.distanceTo(at) > NEAR_PX ? [at, near] : null;
}

const CROSSED_BOX = 400;
const CROSSED_LEADER = 150;

/* What a place costs for the leaders that it crosses, or that cross it. */
function tangled(box, at, others) {
  const leader = leaderOf(at, box);
  let cost = 0;
  for (const { place, leader: other } of others) {
    if (!place) continue;
    if (leader && crossesBox(leader, place)) cost += CROSSED_BOX;
    if (other && crossesBox(other, box)) cost += CROSSED_BOX;
    if (leader && other && segmentsCross(...leader, ...other)) cost += CROSSED_LEADER;
  }
  return cost;
}

/* A number beside a mark: its height, and how far from the middle of the mark. */
const TAG_PX = 16;
const TAG_STEPS = [15, 16, 17, 18, 19, 24, 32, 42, 52];

function arrangeCallouts(cover, reach) {
  const pane = map.getPane("callouts");
  pane.replaceChildren();
  const view = viewBox();
  const callouts = [];
  const spots = plan.events.map((_, index) => marks.eventAt(index));
  plan.events.forEach((event, index) => {
    if (!marks.tells(index)) return;
    const at = spots[index];
    // One far outside the view is laid out when the reader gets there.
    if (!crossesBox([at, at], reach)) return;
    const box = element("div", "callout");
    const kind = say(`mark-${event.kind}`);
    const head = element("b", "", `${kind}: `);
    head.append(element("bdi", "", event.name));
    box.append(head, element("span", "", event.text));
    pane.append(box);
    callouts.push({ box, at, index, place: null });
  });
  for (const one of callouts) {
    const [w, h] = [one.box.offsetWidth, one.box.offsetHeight];
    // What is said of a mark that is seen is seen too. A small screen has no room for them.
    const seen = crossesBox([one.at, one.at], view);
    one.choices = frame.clientWidth < 600 ? [] : [...around(one.at, w, h)].filter((place) =>
      seen ? isWithin(place, view) : !isCut(place, view));
  }
  // The first to choose may stand in the way of the others: let each choose again, twice.
  for (let round = 0; round < 3; round++) {
    for (const one of callouts) {
      if (one.place) cover.addBox(one.place, -TEXT);
      const others = callouts.filter((other) => other !== one);
      one.place = cover.place(one.choices, WORST, (place) => tangled(place, one.at, others));
      one.leader = one.place && leaderOf(one.at, one.place);
    }
  }
  // A leader through a callout would be read as that one's: rather no callout.
  for (const one of callouts) {
    const others = callouts.filter((other) => other !== one);
    if (!one.place || tangled(one.place, one.at, others) < CROSSED_BOX) continue;
    cover.addBox(one.place, -TEXT);
    one.place = null;
  }
  for (const one of callouts) {
    const { box, at } = one;
    if (!one.place) {
      const number = String(one.index + 1);
      const w = 9 + 7 * number.length;
      // Nearer to its own mark than to any other.
      const choices = placesBeside(at, w, TAG_PX, TAG_STEPS).filter((place) => {
        const middle = L.point(place.x + w / 2, place.y + TAG_PX / 2);
        const far = middle.distanceTo(at);
        return !isCut(place, view) && spots.every((other) => !other || middle.distanceTo(other) >= far);
      });
      one.place = cover.place(choices, CROSSED_BOX, (place) => tangled(place, at, callouts));
      if (!one.place) {
        box.remove();
        continue;
      }
      one.leader = leaderOf(at, one.place);
      box.className = "tag";
      box.textContent = number;
      box.style.width = `${w}px`;
      small.push([box, one.place]);
      // The mark's own label says it too.
      box.setAttribute("aria-hidden", "true");
    }
    const { place, leader } = one;
    put(box, place);
    if (!leader) continue;
    pane.prepend(marks.tie(...leader, false));
    // No name lies on a leader.
    cover.addLine(leader, SOLID);
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
const DOT = 1;

/* Places for a text, best first: beside its dot or mark, then further from it. */
function placesBeside(at, w, h, steps) {
  const [left, right, middle] = [at.x - w - 4, at.x + 4, at.x - w / 2];
  return steps.flatMap((own) => {
    const [above, below, level] = [at.y - h - own, at.y + own, at.y - h / 2];
    return [
      [middle, above], [middle, below], [at.x + own + 2, level], [at.x - w - own - 2, level],
      [right, above], [left, below], [left, above], [right, below],
    ].map(([x, y]) => ({ x, y, w, h, own }));
  });
}

/* Names keep off all that is drawn of the plan: one that finds no free place is left out. */
function arrangeNames(cover, bounds) {
  const pane = map.getPane("names");
  pane.replaceChildren();
  if (hidden.has("names")) return;
  const made = document.createDocumentFragment();
  const view = viewBox();
  const found = [...namesHere()].map((one) => ({ ...one, latlng: L.latLng(one.lat / STEPS, one.lon / STEPS) }))
    .filter(({ latlng }) => bounds.contains(latlng))
    .map((one) => ({ ...one, at: map.latLngToLayerPoint(one.latlng) }));
  // A name may touch one dot, its own; but a town is worth more than the dots of junctions.
  const dots = (wanted) => {
    for (const { at, kind } of found) if (wanted === (kind === "junction")) cover.addLine([at, at], DOT);
  };
  dots(false);
  const junctions = found.findIndex(({ kind }) => kind === "junction");
  for (const [index, { at, name, room, kind }] of found.entries()) {
    if (index === junctions) dots(true);
    const font = kind === "junction" ? "11px" : "12.5px";
    const w = Math.min(Math.ceil(textWidth(name, font)) + 2, LONGEST_NAME_PX) + 6;
    const place = placesBeside(at, w, 17, [5, 13, 19]).find((one) =>
      !isCut(one, view) && cover.cost(one) <= DOT && !cover.isCrowded(one, room));
    if (!place) continue;
    cover.addBox(place, TEXT);
    const label = element("div", `name ${kind}`);
    label.append(element("bdi", "", name));
    label.style.width = `${w}px`;
    put(label, place);
    made.append(label);
    small.push([label, place]);
  }
  pane.append(made);
}

map.on("moveend", () => {
  const still = settled && settled.zoom === map.getZoom() && settled.view.contains(map.getBounds());
  if (!still) arrange();
  const view = viewBox();
  for (const [label, place] of small) label.style.visibility = isCut(place, view) ? "hidden" : "";
});

return { arrange };
}

/* From this zoom on, junctions show. */
planLabels.NEAR_ZOOM = 8.75;
