/* A vehicle, place, junction, merge or separation by its name: choosing one lifts the vehicle out, or
 * shows the place on the map. */
// oxlint-disable-next-line no-unused-vars -- page.js calls it; the page holds both.
function wireFind({ plan, map, frame, calm, group, selection, solos, platoons }, openEvent, showWay) {

const { element, say } = pageElements;
const box = document.querySelector(".find");
const field = box.querySelector("input");
const list = box.querySelector("[role='listbox']");
const told = box.querySelector("[role='status']");
const STEPS = 1e4;
const MOST = 8;
const NEAR_ZOOM = 11;

const KINDS = {
  vehicle: "find-vehicle", place: "find-place", junction: "find-junction",
};

/* What is typed finds what is written, with accents or without. */
const plain = (text) => text.normalize("NFD").replace(/\p{M}/gu, "").toLowerCase();

let entries = null;

function everything() {
  const vehicles = plan.vehicles.map((vehicle, index) => ({
    kind: "vehicle", name: vehicle.name || vehicle.letter,
    more: (vehicle.name ? vehicle.letter + ", " : "") +
      `${vehicle.origin.name} \u2192 ${vehicle.destination.name}`,
    choose: () => showVehicle(index),
  }));
  const events = plan.events.map((event, index) => ({
    kind: event.kind, name: event.name, more: event.text, choose: () => openEvent(index),
  }));
  const places = [["place", plan.towns], ["junction", plan.junctions]].flatMap(([kind, found]) =>
    found.map(([lon, lat, name]) => ({
      kind, name, more: "", choose: () => showPlace([lat / STEPS, lon / STEPS], name),
    })));
  return [...vehicles, ...events, ...places].map((entry) => ({
    ...entry, key: plain(entry.name), all: plain(`${entry.name} ${entry.more}`),
  }));
}

/* Names that are what is sought first, then those that begin so, then words that do. */
function rank({ key, all }, sought) {
  if (key === sought) return 0;
  if (key.startsWith(sought)) return 1;
  if (` ${all}`.includes(` ${sought}`)) return 2;
  return all.includes(sought) ? 3 : 4;
}

function found(text) {
  entries ??= everything();
  const sought = plain(text.trim());
  if (!sought) return [];
  return entries.map((entry) => ({ entry, rank: rank(entry, sought) }))
    .filter((one) => one.rank < 4).sort((a, b) => a.rank - b.rank).map((one) => one.entry);
}

// -- where it leads -------------------------------------------------------------------------------

function mapInView() {
  if (frame.getBoundingClientRect().bottom > 120) return;
  frame.scrollIntoView({ block: "start", behavior: calm.matches ? "auto" : "smooth" });
}

const wayOf = (index) => plan.vehicles[index].way.flatMap(([kind, at]) =>
  (kind === "solo" ? solos : platoons)[at].parts.flatMap((part) => part.points));

function showAll(index) {
  const { origin, destination } = plan.vehicles[index];
  showWay([origin, destination].map(({ lat, lon }) => [lat, lon]), wayOf(index));
}

function showVehicle(index) {
  if (selection.chosen !== index) selection.choose(index);
  showAll(index);
}

const ring = group("found");
const renderer = L.svg({ pane: "lifted" });

function showPlace(latlng, name) {
  ring.clearLayers();
  L.circleMarker(latlng, {
    pane: "lifted", renderer, radius: 11, color: "#17202b", weight: 3, fill: false, interactive: false, className: "found-ring",
  }).bindTooltip(element("bdi", "", name), { permanent: true, direction: "top", offset: [0, -10], opacity: 1 })
    .addTo(ring);
  map.setView(latlng, Math.max(map.getZoom(), NEAR_ZOOM), { animate: !calm.matches });
}

// A vehicle that is chosen elsewhere shows in its table, and on the map if it lay outside.
selection.on((chosen, _, changed) => {
  if (chosen === null || !changed) return;
  const row = document.querySelector(`tr[data-vehicle="${chosen}"]`);
  const folded = row?.closest("details");
  if (folded) folded.open = true;
  if (getComputedStyle(document.getElementById("panel")).overflowY === "auto" && window.innerWidth >= 900) {
    row?.scrollIntoView({ block: "nearest" });
  }
  if (!map.getBounds().intersects(L.latLngBounds(wayOf(chosen)))) showAll(chosen);
});

// -- the field and its list -----------------------------------------------------------------------

let shown = [];
let active = -1;

function close() {
  list.hidden = true;
  active = -1;
  field.setAttribute("aria-expanded", "false");
  field.removeAttribute("aria-activedescendant");
}

function point(index) {
  active = index;
  [...list.children].forEach((option, i) => option.setAttribute("aria-selected", String(i === index)));
  if (index < 0) field.removeAttribute("aria-activedescendant");
  else {
    field.setAttribute("aria-activedescendant", list.children[index].id);
    list.children[index].scrollIntoView({ block: "nearest" });
  }
}

function optionOf(entry, index) {
  const option = element("li");
  option.id = `found-${index}`;
  option.setAttribute("role", "option");
  option.setAttribute("aria-selected", "false");
  option.append(element("small", "", say(KINDS[entry.kind] ?? `mark-${entry.kind}`)), " ", element("bdi", "", entry.name));
  if (entry.more) option.append(" ", element("small", "more", entry.more));
  option.addEventListener("click", () => take(entry));
  return option;
}

function take(entry) {
  field.value = entry.name;
  close();
  ring.clearLayers();
  mapInView();
  entry.choose();
}

function search() {
  const all = found(field.value);
  shown = all.slice(0, MOST);
  list.replaceChildren(...shown.map(optionOf));
  const wanted = field.value.trim() !== "";
  told.textContent = wanted ? say("found", { n: all.length }) : "";
  if (!shown.length) close();
  else {
    list.hidden = false;
    field.setAttribute("aria-expanded", "true");
    point(-1);
  }
}

field.addEventListener("input", search);
field.addEventListener("blur", close);
// A press on the list leaves the focus, and with it the list, where it is.
list.addEventListener("pointerdown", (event) => event.preventDefault());
list.addEventListener("mousedown", (event) => event.preventDefault());
field.addEventListener("keydown", (event) => {
  const { key } = event;
  if (key === "ArrowDown" || key === "ArrowUp") {
    event.preventDefault();
    if (list.hidden) search();
    else point((active + (key === "ArrowDown" ? 1 : shown.length + (active < 0 ? 0 : -1))) % shown.length);
  } else if (key === "Enter" && !list.hidden) {
    event.preventDefault();
    take(shown[Math.max(active, 0)]);
  } else if (key === "Escape" && (!list.hidden || field.value)) {
    event.preventDefault();
    if (list.hidden) {
      field.value = "";
      told.textContent = "";
      ring.clearLayers();
    }
    close();
  }
});
document.addEventListener("keydown", (event) => {
  if (event.key === "Escape") ring.clearLayers();
});
box.hidden = false;
}
