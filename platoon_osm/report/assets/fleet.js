/* Sorts and filters the platoons of a fleet; all of them stand in the page's data, best first. */
(() => {
const { element, number, say } = pageElements;
const { rows, names } = JSON.parse(document.getElementById("fleet-data").textContent);
const table = document.querySelector(".fleet-list");
const body = table.tBodies[0];
const form = document.querySelector(".filter");
const more = document.querySelector(".fleet-more");
const heads = [...table.querySelectorAll("th[data-sort]")];
const labels = heads.map((head) => head.textContent);
const PAGE = matchMedia("(max-width: 599.9px)").matches ? 20 : 60;
const TOLD = 12;
const sizes = (row) => row[2].length;
const keys = [(row) => row[5], (row) => row[6], sizes, (row) => row[7], (row) => row[8]];

for (const [place, row] of rows.entries()) {
  row.place = place;
  row.text = [row[0], row[1], ...row[2].map((index) => names[index])].join("\n").toLowerCase();
}

let order = rows;
let most = PAGE;

function cell(tag, place, ...parts) {
  const made = element(tag);
  made.setAttribute("role", tag === "th" ? "rowheader" : "cell");
  if (tag === "th") made.scope = "row";
  else made.dataset.label = labels[place];
  for (const [at, part] of parts.entries()) {
    if (at) made.append(" ");
    made.append(part);
  }
  return made;
}

function lineOf(row) {
  const line = element("tr");
  line.setAttribute("role", "row");
  line.dataset.row = row.place;
  const company = row[2].slice(0, TOLD).map((index) => names[index]).join(", ");
  const left = sizes(row) - TOLD;
  const told = left > 0 ? `${company} +${number(left)}` : company;
  const who = cell("td", 2, element("b", "", number(sizes(row))), element("bdi", "", told));
  who.className = "fleet-who";
  const km = cell("td", 3, row[9]);
  km.className = "number";
  const saved = cell("td", 4, element("b", "", row[10]));
  saved.className = `number ${row[8] > 0 ? "gain" : row[8] < 0 ? "loss" : "even"}`;
  line.append(
    cell("th", 0, element("bdi", "", row[0]), element("small", "", row[3])),
    cell("td", 1, element("bdi", "", row[1]), element("small", "", row[4])),
    who, km, saved,
  );
  return line;
}

function choose(target) {
  const line = target instanceof Element ? target.closest("tr") : null;
  for (const other of body.rows) other.classList.toggle("on", other === line);
  for (const road of document.querySelectorAll(".platoon-road")) {
    road.classList.toggle("on", line !== null && road.dataset.platoon === line.dataset.row);
  }
}

function show() {
  const wanted = form.elements.text.value.trim().toLowerCase();
  const least = Number(form.elements.least.value) || 0;
  const fits = order.filter((row) => sizes(row) >= least && row.text.includes(wanted));
  body.replaceChildren(...fits.slice(0, most).map(lineOf));
  more.hidden = fits.length <= most;
  form.querySelector("output").textContent =
    say("platoons-shown", { shown: number(fits.length), all: number(rows.length) });
}

for (const head of heads) {
  const button = document.createElement("button");
  button.type = "button";
  button.textContent = head.textContent;
  head.replaceChildren(button);
  button.addEventListener("click", () => {
    const now = head.getAttribute("aria-sort");
    const key = keys[Number(head.dataset.sort)];
    // Times are wanted from the first on, everything else from the largest down.
    const falls = now ? now === "ascending" : Number(head.dataset.sort) > 1;
    order = [...rows].sort((a, b) => (falls ? -1 : 1) * (key(a) - key(b)) || a.place - b.place);
    for (const other of heads) other.removeAttribute("aria-sort");
    head.setAttribute("aria-sort", falls ? "descending" : "ascending");
    show();
  });
}

form.addEventListener("input", () => {
  most = PAGE;
  show();
});
form.addEventListener("submit", (event) => event.preventDefault());
more.querySelector("button").addEventListener("click", () => {
  most += PAGE;
  show();
});
for (const kind of ["pointerover", "focusin"]) {
  body.addEventListener(kind, (event) => choose(event.target));
}
form.hidden = false;
show();
document.documentElement.dataset.ready = "true";
})();
