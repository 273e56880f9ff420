/* Sorts and filters the list of platoons, and shows a platoon's road on the map. */
(() => {
const table = document.querySelector(".list");
const body = table.tBodies[0];
const rows = [...body.rows];
const form = document.querySelector(".filter");
const heads = [...table.querySelectorAll("th[data-sort]")];

function sortBy(head, descending) {
  const key = head.dataset.sort;
  const sign = descending ? -1 : 1;
  rows.sort((a, b) => sign * (a.dataset[key] - b.dataset[key]) || a.dataset.number - b.dataset.number);
  body.append(...rows);
  for (const other of heads) other.removeAttribute("aria-sort");
  head.setAttribute("aria-sort", descending ? "descending" : "ascending");
}

for (const head of heads) {
  const button = document.createElement("button");
  button.type = "button";
  button.textContent = head.textContent;
  head.replaceChildren(button);
  button.addEventListener("click", () => {
    const now = head.getAttribute("aria-sort");
    // Numbers are most wanted from the largest down, platoons from the first on.
    sortBy(head, now ? now === "ascending" : head.dataset.sort !== "number");
  });
}

function filter() {
  const wanted = form.elements.text.value.trim().toLowerCase();
  const least = Number(form.elements.least.value) || 0;
  let shown = 0;
  for (const row of rows) {
    const fits = row.dataset.count >= least && row.textContent.toLowerCase().includes(wanted);
    row.hidden = !fits;
    shown += fits ? 1 : 0;
  }
  form.querySelector("output").textContent =
    pageElements.say("platoons-shown", { shown: pageElements.number(shown), all: pageElements.number(rows.length) });
}

form.addEventListener("input", filter);
form.addEventListener("submit", (event) => event.preventDefault());
form.hidden = false;
filter();

function choose(number) {
  for (const row of rows) row.classList.toggle("on", row.dataset.number === number);
  for (const road of document.querySelectorAll(".platoon-road")) {
    road.classList.toggle("on", road.dataset.platoon === number);
  }
}

for (const row of rows) {
  for (const kind of ["pointerenter", "focusin"]) {
    row.addEventListener(kind, () => choose(row.dataset.number));
  }
}
document.documentElement.dataset.ready = "true";
})();
