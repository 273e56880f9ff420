/* Elements made from texts: `textContent` alone, so that no text becomes markup. */
// oxlint-disable-next-line no-unused-vars -- other scripts of the page use it.
const pageElements = (() => {

const SVG = "http://www.w3.org/2000/svg";

function element(tag, name, text) {
  const made = document.createElement(tag);
  if (name) made.className = name;
  if (text !== undefined) made.textContent = text;
  return made;
}

function drawn(tag, attributes, ...children) {
  const made = document.createElementNS(SVG, tag);
  for (const [key, value] of Object.entries(attributes)) made.setAttribute(key, value);
  made.append(...children);
  return made;
}

/* A name between a first strong isolate and its end, for places that take no elements. */
const isolated = (text) => `\u2068${text}\u2069`;

return { element, drawn, isolated };
})();
