/* The slider that moves the vehicles along their ways: by the clock if the plan has times, else by
 * distance. A moment on its scale is in seconds or metres. */
// oxlint-disable-next-line no-unused-vars -- page.js calls it; the page holds both.
function playJourney(scene) {

const { plan, map, calm, hidden, selection } = scene;
const { drawn, isolated, letterSize, say } = pageElements;
const box = document.querySelector(".journey");
if (!box) return null;
const { scale, whereIs } = planPositions(scene);
const slider = box.querySelector("input");
const button = box.querySelector("button");
const output = box.querySelector("output");
const states = box.querySelector(".states");

/* More than so many on one spot, and of a crowd all who do the same near one another, become one
 * disc that counts them. */
const MOST_TOGETHER = 6;
const crowd = plan.vehicles.length > 8;
const NEAR_PX = 20;
const PLAY_MS = 24000;
const MOMENTS_TRIED = 60;

// -- discs ----------------------------------------------------------------------------------------

map.createPane("vehicles").style.zIndex = 650;
const layer = L.layerGroup().addTo(map);

/* What a disc wears when its vehicle does not drive: bars of a pause, or a tick. */
const PAUSE = "M-1.7 -2.4V2.4M1.7 -2.4V2.4";
const BADGES = { waiting: PAUSE, held: PAUSE, break: PAUSE, rest: PAUSE, change: PAUSE, ban: "M-3 0H3", arrived: "M-2.6 0.2L-0.7 2.2L2.8 -2" };

function disc(vehicle, state) {
  const away = state === "state-not-left" || state === "state-held";
  const text = drawn("text", {
    y: 3.9, "text-anchor": "middle", "font-size": letterSize(vehicle.letter),
    "font-weight": 700, fill: away ? vehicle.colour : "#fff",
  });
  text.textContent = vehicle.letter;
  const rings = away
    ? [drawn("circle", { r: 11, fill: "#fff", stroke: vehicle.colour, "stroke-width": 2, "stroke-dasharray": "3.5 2.6" })]
    : [
      drawn("circle", { r: 12, fill: "#17202b" }), drawn("circle", { r: 10.6, fill: "#ffd54a" }),
      drawn("circle", { r: 9, fill: vehicle.colour }),
    ];
  const wears = BADGES[state.slice(6)];
  const badge = wears
    ? [drawn("g", { transform: "translate(9 -9)" },
      drawn("circle", { r: 6, fill: "#fff", stroke: "#17202b", "stroke-width": 1.2 }),
      drawn("path", { d: wears, fill: "none", stroke: "#17202b", "stroke-width": 1.9 }))]
    : [];
  return drawn("svg", { viewBox: "-13 -13 26 26", width: 26, height: 26 }, ...rings, text, ...badge);
}

function put(latlng, face, label, move, state, who) {
  const icon = L.divIcon({
    html: disc(face, state), className: "mark moving", iconSize: [26, 26],
    iconAnchor: [13 - move.x, 13 - move.y],
  });
  const zIndexOffset = who.includes(selection.chosen) ? 10000 : 0;
  const made = L.marker(latlng, { icon, pane: "vehicles", keyboard: false, interactive: false, zIndexOffset });
  made.addTo(layer);
  selection.tag(made.getElement(), who);
  made.getElement().setAttribute("role", "img");
  made.getElement().setAttribute("aria-label", isolated(label));
}

/* Trucks of one platoon stand in a column behind the point where they are. */
function behind({ from, to }, rank) {
  const [a, b] = [map.project(from), map.project(to)];
  const step = b.subtract(a);
  const far = Math.hypot(step.x, step.y) || 1;
  return L.point((-step.x / far) * rank * 21, (-step.y / far) * rank * 21);
}

/* Vehicles that are shown together: a platoon, or who do the same on one spot; of a crowd, near one
 * another. Who is lifted out stands alone. */
function columnsAt(moment) {
  const columns = [];
  plan.vehicles.forEach((vehicle, index) => {
    if (hidden.has(`vehicle-${index}`)) return;
    const place = whereIs(index, moment);
    if (!place) return;
    const { state } = place;
    const at = map.project(place.latlng);
    const alike = (column) => {
      if (column.state !== state || column.own || index === selection.chosen) return false;
      if (crowd) return column.at.distanceTo(at) < NEAR_PX;
      if (state === "state-together") return column.piece === place.piece.at;
      return column.at.distanceTo(at) < 1;
    };
    const column = columns.find(alike);
    const found = { vehicle, index, place };
    if (column) column.found.push(found);
    else columns.push({ state, at, piece: place.piece.at, own: crowd && index === selection.chosen, found: [found] });
  });
  return columns;
}

function show(moment) {
  layer.clearLayers();
  for (const { state, found } of columnsAt(moment)) {
    const names = found.map(({ vehicle }) => vehicle.letter);
    const who = found.map(({ index }) => index);
    const label = `${names.join(", ")} ${say(state)}`;
    if (found.length > (crowd ? 1 : MOST_TOGETHER)) {
      const face = { letter: `${found.length}\u00d7`, colour: "#4d5560" };
      put(found[0].place.latlng, face, label, L.point(0, 0), state, who);
      continue;
    }
    found.forEach(({ vehicle, index, place }, rank) => {
      put(place.latlng, vehicle, label, behind(place, rank), state, [index]);
    });
  }
}

// -- the slider -----------------------------------------------------------------------------------

let at = scale.begin;

function moveTo(to) {
  at = Math.min(Math.max(to, scale.begin), scale.end);
  show(at);
  // The marks of a crowd make room for its discs.
  map.getContainer().classList.toggle("underway", crowd && at > scale.begin);
  const doing = scale.doing ? scale.doing(at) : "";
  slider.value = (at - scale.begin) / scale.step;
  slider.setAttribute("aria-valuetext", [scale.text(at), doing].filter(Boolean).join(", "));
  output.textContent = scale.text(at);
  if (states) states.textContent = doing;
  map.fire("viewchange");
  for (const chart of document.querySelectorAll("svg.along")) {
    const { zero, end, from = 0, perSecond, perMetre, down } = chart.dataset;
    const line = chart.querySelector(".cursor");
    const x = Number(zero) + (at - Number(from)) * Number(perSecond ?? perMetre);
    // Time runs to the right, or down in a diagram of time and distance.
    for (const side of down === undefined ? ["x1", "x2"] : ["y1", "y2"]) line.setAttribute(side, x);
    line.classList.toggle("on", at > scale.begin && x >= Number(zero) && x <= Number(end) + 0.1);
  }
}

let playing = 0;

function stop() {
  cancelAnimationFrame(playing);
  playing = 0;
  button.classList.remove("playing");
  button.setAttribute("aria-label", say("play"));
}

function play() {
  if (at >= scale.end) moveTo(scale.begin);
  let last = performance.now();
  button.classList.add("playing");
  button.setAttribute("aria-label", say("pause"));
  const frame = (now) => {
    // Who asks for calm sees few steps instead of a glide.
    if (!calm.matches || now - last > 700) {
      moveTo(at + ((scale.end - scale.begin) * (now - last)) / PLAY_MS);
      last = now;
    }
    if (at >= scale.end) stop();
    else playing = requestAnimationFrame(frame);
  };
  playing = requestAnimationFrame(frame);
}

button.addEventListener("click", () => (playing ? stop() : play()));
slider.addEventListener("input", () => {
  stop();
  moveTo(scale.begin + Number(slider.value) * scale.step);
});
map.on("zoomend", () => show(at));
document.querySelector(".legend").addEventListener("change", () => show(at));
L.DomEvent.disableClickPropagation(box);
selection.on((_chosen, _hinted, changed) => {
  if (changed) show(at);
});
box.hidden = false;
moveTo(scale.begin);

/* Keep room for what will stand below the slider, so that the box covers no more as it plays. */
function steady() {
  if (!states) return;
  const now = states.textContent;
  states.style.minHeight = "0";
  let most = 0;
  for (let part = 0; part <= MOMENTS_TRIED; part++) {
    states.textContent = scale.doing(scale.begin + ((scale.end - scale.begin) * part) / MOMENTS_TRIED);
    most = Math.max(most, states.offsetHeight);
  }
  states.textContent = now;
  states.style.minHeight = `${most}px`;
}

/* A moment is counted from the beginning, in seconds or metres. */
return { at: () => at - scale.begin, moveTo: (moment) => { stop(); moveTo(scale.begin + moment); }, steady };
}
