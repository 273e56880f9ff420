/* The legend is the layer control: a box for each layer and vehicle, and one for each group. */
// oxlint-disable-next-line no-unused-vars -- page.js calls it; the page holds both.
function wireLegend({ map, groups, hidden, settle }) {

const legend = document.getElementById("legend");
const boxes = [...legend.querySelectorAll("[data-layer]")];
const vehicles = boxes.filter((box) => box.dataset.layer.startsWith("vehicle-"));

/* Boxes that stand for many: those of a group, and that of all vehicles. */
const heads = [...legend.querySelectorAll("[data-group]")].map((head) => ({
  head,
  own: vehicles.filter((box) => box.closest(".legend-group") === head.closest(".legend-group")),
}));
const all = legend.querySelector("[data-all-vehicles]");
if (all) heads.push({ head: all, own: vehicles });

function apply(box) {
  const layers = groups[box.dataset.layer];
  if (box.checked) hidden.delete(box.dataset.layer);
  else hidden.add(box.dataset.layer);
  if (layers && box.checked) map.addLayer(layers);
  else if (layers) map.removeLayer(layers);
}

/* A head is checked if all it stands for are, and undecided if some are. */
function tellHeads() {
  for (const { head, own } of heads) {
    const shown = own.filter((box) => box.checked).length;
    head.checked = shown > 0;
    head.indeterminate = shown > 0 && shown < own.length;
  }
}

function changed() {
  tellHeads();
  settle();
}

for (const layer of boxes) {
  layer.addEventListener("change", () => {
    apply(layer);
    changed();
  });
}
for (const { head, own } of heads) {
  head.addEventListener("change", () => {
    for (const box of own) {
      box.checked = head.checked;
      apply(box);
    }
    changed();
  });
}

const box = document.querySelector(".legend-box");
const button = box.querySelector(".legend-button");
button.addEventListener("click", () => {
  const open = button.getAttribute("aria-expanded") !== "true";
  button.setAttribute("aria-expanded", String(open));
  box.classList.toggle("open", open);
});
box.addEventListener("keydown", (event) => {
  if (event.key !== "Escape" || button.getAttribute("aria-expanded") !== "true") return;
  event.preventDefault();
  button.click();
  button.focus();
});

const settled = planRovers.rove(legend, () => [...legend.querySelectorAll("input, summary")]);
legend.addEventListener("toggle", settled, true);
new ResizeObserver(settled).observe(legend);
L.DomEvent.disableClickPropagation(box);
L.DomEvent.disableScrollPropagation(box);
}
