"""What a page is put together from: document, styles, scripts and policy."""

from __future__ import annotations

from typing import Any

from ..markup.fragments import Markup, asset, compact_asset, fill, fill_page
from ..markup.leaflet import Leaflet
from ..markup.security import json_for_html, policy
from .panel import page_body

__all__ = ["SCRIPTS", "PageParts"]

LEAFLET_LICENCE = "leaflet-licence.txt"

SCRIPTS = (
    "elements.js", "lines.js", "lanes.js", "cover.js", "marks.js", "labels.js", "legend.js",
    "clock.js", "journey.js", "page.js",
)  # fmt: skip
"""The page's own scripts, in their order: each may use those before it."""


class PageParts:
    """What a page is put together from, apart from what folium contributes."""

    def __init__(self, document: dict[str, Any], leaflet: Leaflet) -> None:
        self.document = document
        self.leaflet = leaflet

    def html(self, map_id: str, *, header: str, extra: str, script: str) -> str:
        """Return the whole page.

        Parameters
        ----------
        map_id : of the element that holds the map.
        header, extra : markup for the head and the end of the body, from folium.
        script : from folium, creates the map; the page's own script follows it.
        """
        own = "".join(compact_asset(name) for name in SCRIPTS)
        scripts = [self.leaflet.script, f"{script.strip()}\n{own}"]
        own_style = "".join(compact_asset(name) for name in ("page.css", "schedule.css"))
        styles = [self.leaflet.style, own_style]
        body = page_body(self.document, fill("live-map", id=map_id))
        tiles = self.document["tiles"]
        return fill_page(
            "page.html",
            policy=policy(scripts, styles, tiles["origin"] if tiles else ""),
            title=self.document["title"],
            licences=asset(LEAFLET_LICENCE).strip(),
            leaflet_style=styles[0],
            page_style=styles[1],
            header=header.strip(),
            body=Markup(f"{body}\n{extra.strip()}".strip()),
            data=json_for_html(self.document),
            leaflet_script=scripts[0],
            script=scripts[1],
        )
