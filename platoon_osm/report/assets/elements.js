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

/* Texts of the page's language; one with plural forms is chosen by `n`. */
const { texts, language, clock } = JSON.parse(document.getElementById("page-texts").textContent);
const plurals = new Intl.PluralRules(language);

/* To make one takes longer than to use it a hundred times. */
const formats = new Map();

function number(value, decimals = 0) {
  let format = formats.get(decimals);
  if (!format) {
    format = new Intl.NumberFormat(language, {
      minimumFractionDigits: decimals, maximumFractionDigits: decimals, useGrouping: "always",
    });
    formats.set(decimals, format);
  }
  return format.format(value);
}

function say(key, fields = {}) {
  const entry = texts[key];
  const text = typeof entry === "string" ? entry : entry[plurals.select(fields.n)] ?? entry.other;
  const shown = typeof fields.n === "number" ? { ...fields, n: number(fields.n) } : fields;
  return text.replace(/\{(\w+)\}/g, (_, name) => shown[name]);
}

/* The type size at which a letter, or a count, fits its disc; drawing/vehicle_styles.py has the same. */
function letterSize(letter) {
  const size = [11.5, 9, 8][Math.min(letter.length, 3) - 1];
  const wide = letter.length > 1 ? letter.replace(/[^MWmw]/g, "").length : 0;
  return size * (1 - 0.09 * wide);
}

return { element, drawn, isolated, letterSize, say, number, language, clock };
})();
