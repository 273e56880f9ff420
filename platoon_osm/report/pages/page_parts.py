"""What a page is put together from: document, styles, scripts and policy."""

from __future__ import annotations

from typing import NamedTuple

from ...plans.curves import DelayFrontier, DepartureCurve
from ..document.model import Document
from ..language.speech import speaking
from ..markup.fragments import (
    NOTHING,
    Piece,
    Tree,
    asset,
    compact_asset,
    page_texts,
    written,
    written_page,
)
from ..markup.leaflet import Leaflet
from ..markup.security import policy
from ..markup.still_page import MONEY_STYLE, PAGE_STYLES
from ..markup.style_classes import with_style_classes
from .online_map import Tiles
from .page_data import page_data
from .panel import page_body

__all__ = ["SCRIPTS", "Another", "PageParts"]

LEAFLET_LICENCE = "leaflet-licence.txt"

SCRIPTS = (
    "elements.js",
    "lines.js",
    "beside.js",
    "rover.js",
    "selection.js",
    "unpacked.js",
    "scene.js",
    "tips.js",
    "room.js",
    "fit.js",
    "view.js",
    "touch.js",
    "controls.js",
    "background.js",
    "lanes.js",
    "ribbons.js",
    "routes.js",
    "cover.js",
    "marks.js",
    "labels.js",
    "legend.js",
    "events.js",
    "find.js",
    "chosen.js",
    "tables.js",
    "clock.js",
    "positions.js",
    "journey.js",
    "data_legs.js",
    "data_files.js",
    "data_calendar.js",
    "data.js",
    "page.js",
)
"""The page's own scripts, in their order: each may use those before it."""


class Another(NamedTuple):
    """The same page in a language: its code, what that calls itself, and the file beside."""

    code: str
    name: str
    file: str


class PageParts:
    """What a page is put together from, apart from what folium contributes.

    Parameters
    ----------
    document : Document
        What is shown.
    leaflet : Leaflet
        What draws the live map.
    tiles : Tiles or None
        An online map underneath; None for a page that never asks the network for anything.
    others : tuple of Another
        The page in all its languages, its own among them; empty for a page in one.
    curve : DepartureCurve or None
        What is saved by when the master leaves.
    frontier : DelayFrontier or None
        What is saved by how late all may arrive.
    """

    def __init__(
        self,
        document: Document,
        leaflet: Leaflet,
        tiles: Tiles | None = None,
        others: tuple[Another, ...] = (),
        curve: DepartureCurve | None = None,
        frontier: DelayFrontier | None = None,
    ) -> None:
        self.curve, self.frontier = curve, frontier
        self.document = document
        self.leaflet = leaflet
        self.tiles = tiles
        self.others = others

    def _languages(self) -> Tree:
        """Return links to the page in its other languages."""
        own = self.document.language
        rows = tuple(
            Piece("language-own", {"name": one.name, "code": one.code})
            if one.code == own
            else Piece("language", {"name": one.name, "code": one.code, "file": one.file})
            for one in self.others
        )
        return Piece("languages", {"rows": rows}) if len(rows) > 1 else NOTHING

    def html(self, map_id: str, *, header: str, extra: str, script: str) -> str:
        """Return the whole page.

        Parameters
        ----------
        map_id : str
            Of the element that holds the map.
        header, extra : str
            Markup for the head and the end of the body, from folium.
        script : str
            From folium, creates the map; the page's own script follows it.

        Returns
        -------
        str
            HTML.
        """
        with speaking(self.document.language, self.document.clock):
            return self._spoken(map_id, header, extra, script)

    def _spoken(self, map_id: str, header: str, extra: str, script: str) -> str:
        own = "".join(compact_asset(name) for name in SCRIPTS)
        scripts = [self.leaflet.script, f"{script.strip()}\n{own}"]
        names = [*PAGE_STYLES, "schedule.css", "selection.css"]
        if self.document.bill is not None or self.document.gain is not None:
            names.append(MONEY_STYLE)
        own_style = "".join(map(compact_asset, names))
        live_map = Piece("live-map", {"id": map_id})
        languages, times = self._languages(), (self.curve, self.frontier)
        drawn = written(page_body(self.document, live_map, languages, *times))
        body, style = with_style_classes(drawn, own_style)
        styles = [self.leaflet.style, style]
        tiles = self.tiles
        return written_page(
            "page.html",
            policy=policy(scripts, styles, tiles.origin if tiles else ""),
            title=self.document.title,
            licences=asset(LEAFLET_LICENCE).strip(),
            leaflet_style=styles[0],
            page_style=styles[1],
            header=header.strip(),
            body=body,
            extra=extra,
            texts=page_texts(),
            data=page_data(self.document, tiles),
            leaflet_script=scripts[0],
            script=scripts[1],
        )
