/* The slider that moves the vehicles along their ways, by distance: a plan has no times. */
// oxlint-disable-next-line no-unused-vars -- page.js calls it; the page holds both.
function playJourney({ plan, map, solos, platoons, calm, drawn, isolated, hidden }) {

const box = document.querySelector(".journey");
if (!plan.journey || !box) return;
const slider = box.querySelector("input");
const button = box.querySelector("button");
const output = box.querySelector("output");
const { length_m: length, starts_m: starts, guide } = plan.journey;

/* A crowd on one spot becomes one disc that counts it. */
const MOST_TOGETHER = 6;
const PLAY_MS = 24000;

// -- where a vehicle is ---------------------------------------------------------------------------

/* Points of a piece with the share of its length that lies before each. */
function measured(points) {
  const reached = [0];
  for (let i = 1; i < points.length; i++) {
    reached.push(reached[i - 1] + map.distance(points[i - 1], points[i]));
  }
  const whole = reached[reached.length - 1] || 1;
  return { points, shares: reached.map((metres) => metres / whole) };
}

const lines = {
  solo: solos.map((solo) => measured(solo.parts.flatMap((part) => part.points))),
  platoon: platoons.map((one) => measured(one.points)),
};

/* Each vehicle's pieces, with the metres driven before each. */
const ways = plan.vehicles.map((vehicle) => {
  let before = 0;
  return vehicle.way.map(([kind, at]) => {
    const piece = { kind, at, before, length: (kind === "solo" ? solos : platoons)[at].length_m };
    before += piece.length;
    return piece;
  });
});

function along({ points, shares }, share) {
  let i = 1;
  while (i < shares.length - 1 && shares[i] < share) i++;
  const span = shares[i] - shares[i - 1] || 1;
  const part = Math.min(Math.max((share - shares[i - 1]) / span, 0), 1);
  const [a, b] = [points[i - 1], points[i]];
  return { latlng: L.latLng(a[0] + (b[0] - a[0]) * part, a[1] + (b[1] - a[1]) * part), from: a, to: b };
}

/* Null before a vehicle starts and once it has arrived. */
function whereIs(index, metres) {
  const driven = metres - starts[index];
  if (driven < 1 || driven > plan.vehicles[index].length_m - 1) return null;
  const way = ways[index];
  // At a merge a vehicle counts as there already, at a separation as still there.
  const near = 1;
  const piece = way.find((one) => driven <= one.before + one.length + (one.kind === "solo" ? -near : near))
    ?? way[way.length - 1];
  const share = Math.min(Math.max((driven - piece.before) / (piece.length || 1), 0), 1);
  return { piece, ...along(lines[piece.kind][piece.at], share) };
}

// -- discs ----------------------------------------------------------------------------------------

map.createPane("vehicles").style.zIndex = 650;
const layer = L.layerGroup().addTo(map);

function disc(vehicle) {
  const text = drawn("text", {
    y: 3.9, "text-anchor": "middle", "font-size": vehicle.letter.length > 1 ? 9 : 11.5,
    "font-weight": 700, fill: "#fff",
  });
  text.textContent = vehicle.letter;
  return drawn("svg", { viewBox: "-13 -13 26 26", width: 26, height: 26 },
    drawn("circle", { r: 12, fill: "#17202b" }),
    drawn("circle", { r: 10.6, fill: "#ffd54a" }),
    drawn("circle", { r: 9, fill: vehicle.colour }), text);
}

function put(latlng, face, label, move) {
  const icon = L.divIcon({
    html: disc(face), className: "mark moving", iconSize: [26, 26],
    iconAnchor: [13 - move.x, 13 - move.y],
  });
  const made = L.marker(latlng, { icon, pane: "vehicles", keyboard: false, interactive: false });
  made.addTo(layer);
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

function show(metres) {
  layer.clearLayers();
  const columns = new Map();
  plan.vehicles.forEach((vehicle, index) => {
    if (hidden.has(`vehicle-${index}`)) return;
    const place = whereIs(index, metres);
    if (!place) return;
    const { kind, at } = place.piece;
    // Vehicles alone may still be at one spot, as some start together.
    const spot = `${place.latlng.lat.toFixed(3)} ${place.latlng.lng.toFixed(3)}`;
    const key = kind === "platoon" ? `platoon ${at}` : spot;
    columns.set(key, [...(columns.get(key) ?? []), { index, vehicle, place }]);
  });
  for (const column of columns.values()) {
    const names = column.map(({ vehicle }) => vehicle.letter);
    const together = column[0].place.piece.kind === "platoon";
    const label = `${names.join(", ")} ${together ? "in platoon" : "alone"}`;
    if (column.length > MOST_TOGETHER) {
      const face = { letter: `${column.length}\u00d7`, colour: "#4d5560" };
      put(column[0].place.latlng, face, label, L.point(0, 0));
      continue;
    }
    column.forEach(({ vehicle, place }, rank) => {
      put(place.latlng, vehicle, label, behind(place, rank));
    });
  }
}

// -- the slider -----------------------------------------------------------------------------------

const km = (metres) => `${Math.round(metres / 1000).toLocaleString("en")} km`;

function reading(metres) {
  if (guide === null) return km(metres);
  const { letter, length_m: end } = plan.vehicles[guide];
  const driven = metres - starts[guide];
  if (driven < -500) return `${km(-driven)} before ${letter} starts`;
  if (driven > end + 500) return `${km(driven - end)} after ${letter} arrives`;
  return `${letter} at km ${Math.round(Math.min(Math.max(driven, 0), end) / 1000)}`;
}

let metres = 0;

function moveTo(to) {
  metres = Math.min(Math.max(to, 0), length);
  show(metres);
  slider.value = metres / 1000;
  slider.setAttribute("aria-valuetext", reading(metres));
  output.textContent = reading(metres);
  for (const chart of document.querySelectorAll("svg.along")) {
    const line = chart.querySelector(".cursor");
    const x = Number(chart.dataset.zero) + metres * Number(chart.dataset.perMetre);
    line.setAttribute("x1", x);
    line.setAttribute("x2", x);
    line.classList.toggle("on", metres > 0 && x <= Number(chart.dataset.end));
  }
}

let playing = 0;

function stop() {
  cancelAnimationFrame(playing);
  playing = 0;
  button.classList.remove("playing");
  button.setAttribute("aria-label", "Play the journey");
}

function play() {
  if (metres >= length) moveTo(0);
  let last = performance.now();
  button.classList.add("playing");
  button.setAttribute("aria-label", "Pause the journey");
  const frame = (now) => {
    // Who asks for calm sees few steps instead of a glide.
    if (!calm.matches || now - last > 700) {
      moveTo(metres + (length * (now - last)) / PLAY_MS);
      last = now;
    }
    if (metres >= length) stop();
    else playing = requestAnimationFrame(frame);
  };
  playing = requestAnimationFrame(frame);
}

button.addEventListener("click", () => (playing ? stop() : play()));
slider.addEventListener("input", () => {
  stop();
  moveTo(Number(slider.value) * 1000);
});
map.on("zoomend", () => show(metres));
document.querySelector(".legend").addEventListener("change", () => show(metres));
L.DomEvent.disableClickPropagation(box);
box.hidden = false;
moveTo(0);
}
