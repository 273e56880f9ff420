/* Buttons that save what the page holds as files, made here: nothing is asked of anybody. */
// oxlint-disable-next-line no-unused-vars -- page.js calls it; the page holds both.
function wireData(scene) {

const TYPES = {
  csv: "text/csv", geojson: "application/geo+json", gpx: "application/gpx+xml",
  ics: "text/calendar", json: "application/json",
};

const { plan } = scene;
const { element, say } = pageElements;
const section = document.querySelector(".data");
const choice = section.querySelector("select");
const status = section.querySelector("[role='status']");
const legs = planLegs(scene);
const files = planFiles({ plan, ...legs });

for (const [index, vehicle] of plan.vehicles.entries()) {
  const { letter, name } = vehicle;
  const option = element("option", "", name && name !== letter ? `${letter} (${name.slice(0, 60)})` : letter);
  option.value = String(index);
  choice.append(option);
}

const made = {
  ...files,
  ics: planCalendar({ ...scene, ...legs }),
  json: () => JSON.stringify(plan, null, 1),
};

function save(kind) {
  const one = choice.value !== "" && kind !== "json";
  const chosen = one ? [Number(choice.value)] : [...plan.vehicles.keys()];
  const stem = files.fileStem(one ? legs.nameOf(plan.vehicles[chosen[0]]) : plan.title);
  const link = element("a");
  link.download = `${stem}.${kind}`;
  link.href = URL.createObjectURL(new Blob([made[kind](chosen)], { type: TYPES[kind] }));
  link.click();
  // Not at once: some browsers read it only after the click is done.
  setTimeout(() => URL.revokeObjectURL(link.href), 60_000);
  status.textContent = say("saved", { file: link.download });
}

for (const button of section.querySelectorAll("[data-file]")) {
  if (button.dataset.file === "ics" && !plan.schedule) button.remove();
  else button.addEventListener("click", () => save(button.dataset.file));
}
section.hidden = false;
}
