/* One vehicle is lifted out of the others, wherever it shows: whatever bears `data-vehicle`, the
 * positions of one or more vehicles, is `lifted` or `faded`. `hinted` is what a pointer previews. */
// oxlint-disable-next-line no-unused-vars -- page.js calls it; the page holds both.
function planSelection(plan) {

const root = document.documentElement;
const listeners = [];
let chosen = null;
let hinted = null;

const whose = (found) => (found.dataset.vehicle ?? "").split(" ").filter(Boolean).map(Number);

function paint(found) {
  const mine = chosen !== null && whose(found).includes(chosen);
  found.classList.toggle("lifted", mine);
  found.classList.toggle("faded", chosen !== null && !mine);
  const button = found.querySelector("[aria-pressed]");
  if (button) button.setAttribute("aria-pressed", String(mine));
}

/* Say whose an element is; it looks as the selection wants it from then on. */
function tag(found, who) {
  found.dataset.vehicle = [who].flat().join(" ");
  paint(found);
}

/* Listeners hear who is chosen, who is previewed, and whether the former has changed. */
function tell(changed) {
  for (const listener of listeners) listener(chosen, hinted, changed);
}

/* Lift a vehicle out; the same again, or null, lets go. */
function choose(index) {
  const next = index === chosen || !plan.vehicles[index] ? null : index;
  if (next === chosen) return;
  chosen = next;
  root.classList.toggle("lifting", chosen !== null);
  for (const found of document.querySelectorAll("[data-vehicle]")) paint(found);
  tell(true);
}

function hint(index) {
  if (index === hinted) return;
  for (const found of document.querySelectorAll(".hinted")) found.classList.remove("hinted");
  hinted = index;
  if (hinted !== null) {
    for (const found of document.querySelectorAll(`[data-vehicle~="${hinted}"]`)) found.classList.add("hinted");
  }
  tell(false);
}

/* The vehicle that something on the page stands for; none if it stands for several. */
function pointedAt(target) {
  const found = target.closest?.("[data-vehicle]");
  const who = found ? whose(found) : [];
  return who.length === 1 ? who[0] : null;
}

const ACTIVE = "button, a, input, summary, label, select, textarea, .leaflet-container";

document.addEventListener("click", (event) => {
  const index = pointedAt(event.target);
  // The map has clicks of its own, which know a click from a drag; who marks text wants the text.
  if (index === null || event.target.closest(ACTIVE) || String(window.getSelection())) return;
  choose(index);
});
document.addEventListener("keydown", (event) => {
  if (event.key === "Escape" && !event.defaultPrevented) choose(null);
});
if (window.matchMedia("(hover: hover) and (pointer: fine)").matches) {
  document.addEventListener("pointerover", (event) => hint(pointedAt(event.target)));
}

/* A row of a table is chosen by its head, by keyboard too. */
for (const head of document.querySelectorAll("tr[data-vehicle] .who")) {
  head.setAttribute("role", "button");
  head.setAttribute("tabindex", "0");
  head.setAttribute("aria-pressed", "false");
  head.addEventListener("keydown", (event) => {
    if (event.key !== "Enter" && event.key !== " ") return;
    event.preventDefault();
    choose(pointedAt(head));
  });
}

return {
  get chosen() {
    return chosen;
  },
  choose,
  tag,
  on: (listener) => listeners.push(listener),
};
}
