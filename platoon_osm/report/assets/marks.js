/* Starts, destinations, merges, separations and pauses: marks that keep clear of one another. */
// oxlint-disable-next-line no-unused-vars -- page.js calls it; the page holds both.
function planMarks({ plan, map, hidden, selection, tooltip }) {

const { element, drawn, isolated, letterSize, say } = pageElements;
const { act } = planMarks;
const frame = map.getContainer();

/* Many vehicles: starts near one another become one mark that counts them, until one zooms in. */
const crowd = plan.vehicles.length > 8;

/* Of few vehicles, only more ends on one spot than this are counted. */
const MOST_ENDS = 3;
const END_PX = 24;
const EVENT_PX = 28;
const FAR_PX = 15;
/* Of many who are late at one mark, so many are told. */
const MOST_TOLD = 6;

const marks = [];

/* The mark of each event; events of a crowd near one another share one. */
const eventMarks = [];
let openEvent = () => {};

function mark(latlng, picture, size, label, name, who, options) {
  const icon = L.divIcon({ html: picture, className: `mark ${name}`, iconSize: [size, size] });
  const made = L.marker(latlng, { icon, title: "", riseOnHover: true, ...options });
  made.on("add", () => {
    made.getElement().setAttribute("role", "button");
    made.getElement().setAttribute("aria-label", isolated(label));
    selection.tag(made.getElement(), who);
  });
  return made;
}

/* A badge at a corner of a mark: someone arrives too late. */
const lateBadge = () => {
  const text = drawn("text", { y: 3.4, "text-anchor": "middle", "font-size": 9.5, "font-weight": 800, fill: "#fff" });
  text.textContent = "!";
  return drawn("g", { class: "late-badge", transform: "translate(9.5 -9)" },
    drawn("circle", { r: 5.6, fill: "#a3260a", stroke: "#fff", "stroke-width": 1.2 }), text);
};

function endPicture(face, square, late) {
  const shape = square
    ? drawn("rect", { x: -9.5, y: -9.5, width: 19, height: 19, rx: 3, fill: face.colour })
    : drawn("circle", { r: 10, fill: face.colour });
  const text = drawn("text", {
    y: 3.9, "text-anchor": "middle", "font-size": letterSize(face.letter),
    "font-weight": 700, fill: "#fff",
  });
  text.textContent = face.letter;
  shape.setAttribute("stroke", "#fff");
  shape.setAttribute("stroke-width", 2);
  const badges = late ? [lateBadge()] : [];
  return drawn("svg", { viewBox: "-12 -12 24 24", width: 24, height: 24 }, shape, text, ...badges);
}

function eventPicture(kind, count, bare) {
  const made = drawn("svg", { viewBox: "-13 -13 26 26", width: 28, height: 28 },
    drawn("use", { href: `#icon-${kind}` }), ...(bare ? [drawn("use", { href: "#icon-unknown" })] : []));
  if (count > 1) {
    const text = drawn("text", {
      y: 3, "text-anchor": "middle", "font-size": 8.5, "font-weight": 700, fill: "#fff",
    });
    text.textContent = count;
    made.append(drawn("g", { transform: "translate(9 8.5)" },
      drawn("rect", { x: -8, y: -6, width: 16, height: 12, rx: 6, fill: "#4d5560", stroke: "#fff", "stroke-width": 1.2 }),
      text));
  }
  return made;
}

/* What lies on one spot, as positions; of a crowd, so near that marks would touch. What `apart` says
 * has a mark of its own. */
function spots(stops, apart) {
  const reach = crowd ? END_PX - 2 : 0.01;
  const found = [];
  stops.forEach((stop, index) => {
    if (!stop) return;
    const at = map.project([stop.lat, stop.lon]);
    const own = crowd && apart(index);
    const near = own ? null : found.find((spot) => !spot.own && spot.at.distanceTo(at) < reach);
    if (near) near.who.push(index);
    else found.push({ at, own, who: [index] });
  });
  return found.map((spot) => spot.who);
}

/* From a mark that counts to where one sees apart what it counts. */
const closer = (made) => map.setView(made.getLatLng(), map.getZoom() + 2);

/* How late those are who arrive too late, each named if they are several. */
const lateTexts = (vehicles) => vehicles.filter(({ times }) => times?.text.late).map(({ letter, times }) => {
  const late = say("mark-late", { time: times.text.late });
  return vehicles.length > 1 ? `${isolated(letter)}: ${late}` : late;
});

function drawEnds(stopOf, key, square) {
  const stops = plan.vehicles.map((vehicle, index) =>
    (crowd && hidden.has(`vehicle-${index}`) ? null : stopOf(vehicle)));
  for (const indexes of spots(stops, (index) => index === selection.chosen)) {
    const counted = indexes.length > (crowd ? 1 : MOST_ENDS);
    for (const who of counted ? [indexes] : indexes.map((index) => [index])) {
      const vehicles = who.map((index) => plan.vehicles[index]);
      const stop = stopOf(vehicles[0]);
      const face = counted ? { colour: "#4d5560", letter: `${who.length}\u00d7` } : vehicles[0];
      const letters = vehicles.map((vehicle) => vehicle.letter).join(", ");
      const names = [...new Set(vehicles.map((vehicle) => isolated(stopOf(vehicle).name)))];
      const late = square ? lateTexts(vehicles) : [];
      const what = say(key, { n: who.length, who: letters, place: names.join(", ") });
      const label = [what, ...late.slice(0, MOST_TOLD)].join(", ");
      const picture = endPicture(face, square, late.length > 0);
      const made = mark([stop.lat, stop.lon], picture, END_PX, label, "end", who, {
        zIndexOffset: 200,
      });
      act(made, counted ? () => closer(made) : () => selection.choose(who[0]));
      made.bindTooltip(element("bdi", "", label), { direction: "top", offset: [0, -10], opacity: 1 });
      marks.push({ made, layer: "ends", who, size: END_PX });
    }
  }
}

const concerned = ({ vehicles, others }) => [...vehicles, ...others];
const isHidden = ({ vehicles }) => vehicles.every((index) => hidden.has(`vehicle-${index}`));

/* Events that share a mark: each has its own, but in a crowd those of a kind near one another. */
function eventSpots() {
  if (!crowd) return plan.events.map((_, index) => [index]);
  const apart = (index) => concerned(plan.events[index]).includes(selection.chosen);
  return [...new Set(plan.events.map(({ kind }) => kind))].flatMap((kind) =>
    spots(plan.events.map((event) => (event.kind !== kind || isHidden(event) ? null : event)), apart));
}

function drawEvents() {
  for (const indexes of eventSpots()) {
    const events = indexes.map((index) => plan.events[index]);
    const [event] = events;
    const one = events.length === 1;
    const names = [...new Set(events.map(({ name }) => isolated(name)))].slice(0, 4).join(", ");
    const noun = say(`mark-${event.kind}${one ? "" : "s"}`, { n: events.length });
    const bare = events.some(({ has_parking: known }) => !known);
    const order = one ? `${indexes[0] + 1}. ` : "";
    const head = `${order}${noun}: ${one ? event.name : names}`;
    const lines = one ? [event.text, event.detail] : events.slice(0, 4).map(({ text }) => text);
    const made = mark([event.lat, event.lon], eventPicture(event.kind, events.length, bare), EVENT_PX,
      one ? `${head}, ${event.text}` : head, "event-mark",
      [...new Set(events.flatMap(concerned))], { zIndexOffset: 400 });
    made.bindTooltip(tooltip({ head, lines }), { direction: "top", offset: [0, -12], opacity: 1 });
    act(made, one ? () => openEvent(indexes[0]) : () => closer(made));
    const who = events.flatMap(({ vehicles }) => vehicles);
    const entry = { made, layer: event.kind, who, size: EVENT_PX, one };
    for (const index of indexes) eventMarks[index] = entry;
    marks.push(entry);
  }
}

function drawAllEnds() {
  drawEnds((vehicle) => vehicle.origin, "mark-start", false);
  drawEnds((vehicle) => vehicle.destination, "mark-end", true);
}

/* Put up the marks for this zoom. A mark is there while its layer is, and any of its vehicles. */
function show() {
  if (crowd) {
    for (const { made } of marks.splice(0)) made.remove();
    eventMarks.length = 0;
    drawEvents();
    drawAllEnds();
  }
  for (const { made, layer, who } of marks) {
    const wanted = !hidden.has(layer) && who.some((index) => !hidden.has(`vehicle-${index}`));
    if (wanted) made.addTo(map);
    else made.remove();
  }
  spread();
}

/* Places round a spot, near ones first; sideways before up and down. */
const fan = [];
for (let x = -3; x <= 3; x++) for (let y = -3; y <= 3; y++) fan.push([x, y]);
fan.sort((a, b) => Math.hypot(a[0], 1.3 * a[1]) - Math.hypot(b[0], 1.3 * b[1]) || b[0] - a[0] || a[1] - b[1]);

/* Marks on one spot are fanned out, so that each can be read; a crowd may still touch. Merges and
 * separations come first, so they stay where they are; what moves far is tied to its place. */
function spread() {
  const taken = [];
  const ties = map.getPane("ties");
  ties.replaceChildren();
  const [low, { x: wide, y: tall }] = [map.containerPointToLayerPoint([0, 0]), map.getSize()];
  const inside = ({ x, y }, edge) => x >= low.x + edge && y >= low.y + edge &&
    x <= low.x + wide - edge && y <= low.y + tall - edge;
  const shrink = crowd && frame.clientWidth < 600 ? 0.8 : 1;
  for (const one of marks) {
    const { made } = one;
    const icon = map.hasLayer(made) && made.getElement();
    if (!icon) continue;
    const size = (one.size === EVENT_PX ? EVENT_PX : END_PX) * shrink;
    const at = map.latLngToLayerPoint(made.getLatLng());
    const spot = ([x, y]) => at.add([x * (size - 3), y * (size - 3)]);
    const free = (p) =>
      taken.every((q) => Math.abs(q.x - p.x) > size - 5 || Math.abs(q.y - p.y) > size - 5);
    // What belongs into the view stays in it.
    const seen = inside(at, 0);
    const found = fan.find((one) => free(spot(one)) && (!seen || inside(spot(one), size / 2))) ??
      fan.find((one) => free(spot(one)));
    const place = found ? spot(found) : at;
    taken.push(place);
    one.box = { x: place.x - size / 2, y: place.y - size / 2, w: size, h: size };
    icon.style.width = `${size}px`;
    icon.style.height = `${size}px`;
    icon.style.marginLeft = `${place.x - at.x - size / 2}px`;
    icon.style.marginTop = `${place.y - at.y - size / 2}px`;
    if (place.distanceTo(at) > FAR_PX) ties.append(tie(at, place));
  }
}

/* A thin line from one point to another, and a dot where it starts if `dot`. */
function tie(from, to, dot = true) {
  const low = L.point(Math.min(from.x, to.x) - 4, Math.min(from.y, to.y) - 4).round();
  const [a, b] = [from.subtract(low), to.subtract(low)];
  const made = drawn("svg", {
    class: "leader", width: Math.abs(from.x - to.x) + 8, height: Math.abs(from.y - to.y) + 8,
  }, drawn("line", { x1: a.x, y1: a.y, x2: b.x, y2: b.y, stroke: "#17202b" }));
  if (dot) made.append(drawn("circle", { cx: a.x, cy: a.y, r: 2.6, fill: "#17202b" }));
  L.DomUtil.setPosition(made, low);
  return made;
}

if (!crowd) {
  drawEvents();
  drawAllEnds();
}

/* Boxes of all marks that show, in pixels of the layer. */
const boxes = () => marks.filter(({ made, box }) => box && map.hasLayer(made)).map(({ box }) => box);

/* Where the mark of an event stands, which may be beside its place, in pixels of the layer; null where
 * none shows. */
function eventAt(index) {
  const { made, box } = eventMarks[index] ?? {};
  return box && map.hasLayer(made) ? L.point(box.x + box.w / 2, box.y + box.h / 2) : null;
}

/* Whether an event has a mark of its own that shows, and concerns who is lifted out. */
function tells(index) {
  const { chosen } = selection;
  const wanted = chosen === null || concerned(plan.events[index]).includes(chosen);
  return Boolean(wanted && eventMarks[index]?.one && eventAt(index));
}

const onEvent = (open) => {
  openEvent = open;
};

return { show, tie, boxes, eventAt, tells, onEvent };
}

/* What a mark or line does when it is clicked, or Enter or the space bar pressed on it. */
planMarks.act = (made, action) => {
  made.on("click", action);
  made.on("keypress", ({ originalEvent: event }) => {
    if (event.key !== "Enter" && event.key !== " ") return;
    event.preventDefault();
    action();
  });
};
