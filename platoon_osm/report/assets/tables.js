/* Long tables sort by their heads, and a row of the overview leads to its group. */
// oxlint-disable-next-line no-unused-vars -- page.js calls it; the page holds both.
function wireTables({ plan, calm }) {

const { element, language } = pageElements;

/* Tables of more rows than this are worth sorting. */
const FEW = 8;
const names = new Intl.Collator(language, { numeric: true });
const groups = [...document.querySelectorAll(".group")];

const sum = (who, key) => who.reduce((all, index) => all + plan.vehicles[index][key], 0);

/* What a row is sorted by, of a vehicle or of a group of them. */
function valueOf(row, key) {
  const { vehicle, group } = row.dataset;
  const who = group === undefined ? [Number(vehicle)] : plan.groups[group].vehicles;
  if (key !== "name") return sum(who, key);
  const { name, letter } = plan.vehicles[who[0]];
  return group === undefined ? name || letter : plan.groups[group].name;
}

function sortable(table) {
  const body = table.tBodies[0];
  const rows = [...body.rows];
  if (rows.length <= FEW) return;
  const heads = [...table.tHead.querySelectorAll("[data-sort]")];
  for (const head of heads) {
    const key = head.dataset.sort;
    const button = element("button", "sort");
    button.type = "button";
    button.append(...head.childNodes);
    head.append(button);
    button.addEventListener("click", () => {
      const now = head.getAttribute("aria-sort");
      // Numbers are most wanted from the largest down, names from the first on.
      const descending = now ? now === "ascending" : key !== "name";
      const sign = descending ? -1 : 1;
      const valued = rows.map((row, place) => ({ row, place, value: valueOf(row, key) }));
      valued.sort((a, b) => sign * (key === "name" ? names.compare(a.value, b.value) : a.value - b.value)
        || a.place - b.place);
      body.append(...valued.map(({ row }) => row));
      for (const other of heads) other.removeAttribute("aria-sort");
      head.setAttribute("aria-sort", descending ? "descending" : "ascending");
    });
  }
}

function leadsTo(row) {
  const block = groups[Number(row.dataset.group)];
  const name = row.querySelector("th b");
  if (!block || !name) return;
  name.setAttribute("role", "button");
  const open = () => {
    block.open = true;
    block.scrollIntoView({ block: "start", behavior: calm.matches ? "auto" : "smooth" });
    block.querySelector("summary").focus({ preventScroll: true });
  };
  name.addEventListener("click", open);
  name.addEventListener("keydown", (event) => {
    if (event.key !== "Enter" && event.key !== " ") return;
    event.preventDefault();
    open();
  });
}

document.querySelectorAll(".costs").forEach(sortable);
document.querySelectorAll(".overview tr[data-group]").forEach(leadsTo);
}
