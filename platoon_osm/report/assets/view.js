/* What is looked at, kept in the address behind `#`, so that a link, a bookmark or going back leads
 * there again: `#map=8.25/45.51/10.18&moment=3600`. Each part has a key, a text to write ("" for
 * nothing worth keeping) and a way to go there, which ignores what is no such place. */
// oxlint-disable-next-line no-unused-vars -- page.js calls it; the page holds both.
function planView(map) {

/* Browsers allow some hundred changes of the address in half a minute. */
const WAIT_MS = 500;
const LONGEST = 300;
const parts = new Map();

/* The parts that an address names, of those there are. */
function named(hash) {
  if (hash.length > LONGEST) return new Map();
  return new Map(
    hash.replace(/^#/, "").split("&").map((part) => part.split("=")).filter(([key]) => parts.has(key)),
  );
}

function restore() {
  const found = named(window.location.hash);
  for (const [key, { go }] of parts) {
    const text = found.get(key);
    if (text) go(text);
  }
}

let written = window.location.hash;
let waiting = 0;

function write() {
  waiting = 0;
  const texts = [...parts].map(([key, { text }]) => [key, text()]).filter(([, text]) => text);
  const hash = texts.map(([key, text]) => `${key}=${text}`).join("&");
  // An address that is none of ours, such as that of the skip link, is left until there is one.
  if ((hash && `#${hash}`) === written || (!hash && !named(written).size)) return;
  written = hash && `#${hash}`;
  try {
    window.history.replaceState(null, "", written || window.location.pathname + window.location.search);
  } catch {
    // A frame without an address of its own, as in a notebook, keeps nothing.
    parts.clear();
  }
}

/* Something changed: write it soon. */
function changed() {
  waiting ||= setTimeout(write, WAIT_MS);
}

/* From now on the address follows what is looked at, and this follows the address. */
function watch() {
  map.on("moveend viewchange", changed);
  window.addEventListener("hashchange", () => {
    written = window.location.hash;
    restore();
  });
}

return { part: (key, text, go) => parts.set(key, { text, go }), restore, watch };
}

/* Zoom and middle of the map, once the reader has moved it. */
planView.ofMap = (map, fit) => {
  const number = /^-?\d{1,3}(\.\d{1,6})?$/;
  const text = () => {
    if (!fit.isMoved()) return "";
    const { lat, lng } = map.getCenter();
    // Another world to the right or left is the same place.
    const lon = L.Util.wrapNum(lng, [-180, 180], true);
    return [map.getZoom().toFixed(2), lat.toFixed(5), lon.toFixed(5)].map((one) => String(Number(one))).join("/");
  };
  const go = (where) => {
    const found = where.split("/");
    if (found.length !== 3 || !found.every((one) => number.test(one))) return;
    const [zoom, lat, lon] = found.map(Number);
    if (zoom < map.getMinZoom() || zoom > map.getMaxZoom() || Math.abs(lat) > 85 || Math.abs(lon) > 180) return;
    fit.moveTo([lat, lon], zoom);
  };
  return ["map", text, go];
};

/* The language, of a page that is there in several: another one is the file beside, which is shown
 * what is looked at here. */
planView.ofLanguage = () => {
  const links = [...document.querySelectorAll(".languages a")];
  const own = document.documentElement.lang;
  const key = "language";
  const there = (link) => {
    const rest = window.location.hash.slice(1).split("&").filter((part) => part && !part.startsWith(`${key}=`));
    const url = new URL(link.href);
    url.hash = [...rest, `${key}=${link.hreflang}`].join("&");
    return url.href;
  };
  for (const link of links) {
    link.addEventListener("click", (event) => {
      if (event.button || event.metaKey || event.ctrlKey || event.shiftKey) return;
      event.preventDefault();
      window.location.assign(there(link));
    });
  }
  const go = (code) => {
    const link = links.find((one) => one.hreflang === code);
    if (link) window.location.replace(there(link));
  };
  return [key, () => (links.length ? own : ""), go];
};

/* The moment of the slider, in whole seconds or metres since the beginning. */
planView.ofMoment = (journey) => [
  "moment",
  () => String(Math.round(journey.at()) || ""),
  (text) => {
    if (/^\d{1,9}$/.test(text)) journey.moveTo(Number(text));
  },
];

/* The vehicle that is lifted out, by its letter. */
planView.ofVehicle = (map, plan, selection) => {
  selection.on((_chosen, _hinted, changed) => {
    if (changed) map.fire("viewchange");
  });
  const go = (letter) => {
    const index = plan.vehicles.findIndex((vehicle) => vehicle.letter === letter);
    if (index >= 0 && index !== selection.chosen) selection.choose(index);
  };
  return ["vehicle", () => plan.vehicles[selection.chosen]?.letter ?? "", go];
};
