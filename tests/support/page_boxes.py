"""Boxes of a page in a browser: what is covered, what is cut, what runs over."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import Any

from plan_kinds import plan_kind

from platoon_osm.report import write_html

SIZES = ((320, 640), (390, 844), (844, 390), (600, 900), (900, 1000), (1440, 900), (2560, 1440))

MAP_FAULTS = """() => {
  const view = document.querySelector('#map_plan').getBoundingClientRect();
  const boxes = (names) => [...document.querySelectorAll(names)]
    .map((e) => [e.getAttribute('aria-label') || e.className, e.getBoundingClientRect()])
    .filter(([, b]) => b.width && b.height);
  const covers = boxes(
    '.map .legend-button, .map .legend, .map .leaflet-control, .map .credit, .map .journey, '
    + '.map .chosen');
  const found = [];
  for (const [name, b] of boxes('.mark.end, .mark.event-mark')) {
    if (b.left < view.left || b.top < view.top || b.right > view.right || b.bottom > view.bottom) {
      found.push(`${name} is outside`);
    }
    for (const [cover, c] of covers) {
      if (b.left < c.right && c.left < b.right && b.top < c.bottom && c.top < b.bottom) {
        found.push(`${name} lies under ${cover}`);
      }
    }
  }
  return found;
}"""
"""Starts, destinations and events that lie outside the map or under what covers it."""

TEXT_FAULTS = """() => {
  const view = document.querySelector('#map_plan').getBoundingClientRect();
  const boxes = (names) => [...document.querySelectorAll(names)]
    .map((e) => [e.textContent || e.getAttribute('aria-label'), e.getBoundingClientRect()])
    .filter(([, b]) => b.width && b.height && b.right > view.left && b.left < view.right
      && b.bottom > view.top && b.top < view.bottom);
  const over = (a, b) => a.left < b.right - 1 && b.left < a.right - 1
    && a.top < b.bottom - 1 && b.top < a.bottom - 1;
  const texts = boxes('.name, .callout, .tag');
  const solid = boxes('.mark.end, .mark.event-mark, .legend-button, .live .legend, '
    + '.leaflet-control, .map .credit, .map .journey');
  const found = [];
  texts.forEach(([name, b], i) => {
    for (const [other, c] of [...texts.slice(0, i), ...solid]) {
      if (over(b, c)) found.push(`${name} covers ${other}`);
    }
    const inside = b.left >= view.left - 1 && b.right <= view.right + 1
      && b.top >= view.top - 1 && b.bottom <= view.bottom + 1;
    if (!inside) found.push(`${name} is cut by the edge of the map`);
  });
  return found;
}"""
"""Names, callouts and numbers over one another or over marks, or cut by the edge of the map."""

PANEL_FAULTS = """() => {
  const found = [];
  const wide = document.documentElement.scrollWidth - document.documentElement.clientWidth;
  if (wide > 0) found.push(`the page runs over by ${wide} px`);
  const panel = document.getElementById('panel');
  const room = panel.getBoundingClientRect();
  const shown = (e) => e.getClientRects().length && getComputedStyle(e).visibility !== 'hidden';
  const told = (e) => `${e.tagName.toLowerCase()}.${e.getAttribute('class') || ''} `
    + `"${e.textContent.trim().slice(0, 40)}"`;
  for (const table of panel.querySelectorAll('table')) {
    const b = table.getBoundingClientRect();
    if (shown(table) && b.right > room.right + 1) {
      found.push(`${told(table)} is wider than the panel`);
    }
  }
  // Who clips on purpose says so, in lines or by an ellipsis.
  const clips = (e) => {
    const style = getComputedStyle(e);
    return style.textOverflow === 'ellipsis' || style.webkitLineClamp !== 'none'
      || style.clipPath !== 'none';
  };
  for (const e of panel.querySelectorAll('*')) {
    if (!shown(e) || e.closest('svg') || !e.textContent.trim() || clips(e)) continue;
    const style = getComputedStyle(e);
    const hides = style.overflowX === 'hidden' || style.overflowX === 'clip';
    if (hides && e.scrollWidth > e.clientWidth + 1) found.push(`${told(e)} is cut`);
    if (style.display.startsWith('inline') || e.children.length) continue;
    if (e.scrollWidth > e.clientWidth + 1) found.push(`${told(e)} runs over`);
  }
  for (const svg of panel.querySelectorAll('svg')) {
    if (!shown(svg) || svg.closest('.badge, .icon, .swatch')) continue;
    const frame = svg.getBoundingClientRect();
    for (const text of svg.querySelectorAll('text')) {
      const b = text.getBoundingClientRect();
      if (!b.width) continue;
      if (b.left < frame.left - 1 || b.right > frame.right + 1 || b.bottom > frame.bottom + 1.5) {
        found.push(`"${text.textContent}" leaves the drawing ${svg.getAttribute('class') || ''}`);
      }
    }
  }
  return found;
}"""
"""What of the panel runs over or is cut, and texts outside their drawing."""


class Pages:
    """Pages of plan kinds, written once, in one browser page that is resized.

    Parameters
    ----------
    page : playwright.sync_api.Page
        To look at them in.
    folder : Path
        For the files.
    """

    def __init__(self, page: Any, folder: Path) -> None:
        self.page = page
        self.folder = folder
        self.complaints: list[str] = []
        page.on("pageerror", lambda error: self.complaints.append(str(error)))

    def open(self, kind: str, size: tuple[int, int], fragment: str = "") -> Any:
        """Show a plan of some kind in a window of some size; the page is made anew."""
        path = self.folder / f"{kind.replace(' ', '-')}.html"
        if not path.exists():
            write_html(*plan_kind(kind), path)
        self.page.set_viewport_size({"width": size[0], "height": size[1]})
        # Another fragment alone would not load the page again.
        self.page.goto("about:blank")
        self.page.goto(path.as_uri() + fragment)
        self.page.wait_for_selector("#map_plan[data-ready]")
        return self.page

    def resize(self, size: tuple[int, int]) -> None:
        """Resize the window, and wait until the page has answered."""
        self.page.set_viewport_size({"width": size[0], "height": size[1]})
        self.page.evaluate(
            "() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)))"
        )

    def faults(
        self, kind: str, sizes: Sequence[tuple[int, int]], scripts: Sequence[str]
    ) -> list[str]:
        """Return what scripts find in a plan, opened at one size and resized to the others."""
        page = self.open(kind, sizes[0])
        found = []
        for size in sizes:
            if size != sizes[0]:
                self.resize(size)
            where = f"{kind}, {size[0]}x{size[1]}: "
            found += [where + text for script in scripts for text in page.evaluate(script)]
        return found + [f"{kind}: {text}" for text in self.complaints]
