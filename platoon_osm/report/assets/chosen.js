/* Which vehicle is lifted out, said on the map, with a button that lets it go. */
// oxlint-disable-next-line no-unused-vars -- page.js calls it; the page holds both.
function sayChosen({ plan, selection }) {

const { element, isolated, say } = pageElements;
const place = document.querySelector(".chosen");

selection.on((chosen) => {
  if (chosen === null) {
    place.replaceChildren();
    return;
  }
  const { letter, name, colour, origin, destination } = plan.vehicles[chosen];
  const disc = element("b", "disc", letter);
  disc.style.background = colour;
  const ends = element("span", "", `${isolated(origin.name)} \u2192 ${isolated(destination.name)}`);
  const button = element("button", "", "\u00d7");
  button.type = "button";
  button.setAttribute("aria-label", say("let-go", { who: isolated(name || letter) }));
  button.addEventListener("click", () => {
    selection.choose(null);
    document.querySelector(`tr[data-vehicle="${chosen}"] .who`)?.focus();
  });
  place.replaceChildren(disc, ...(name ? [element("bdi", "name-of", name)] : []), ends, button);
});
L.DomEvent.disableClickPropagation(place);
}
