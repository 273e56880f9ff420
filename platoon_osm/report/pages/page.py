"""The report of a plan as one HTML file that needs nothing else, now or in years."""

from __future__ import annotations

import os
import re
from typing import TYPE_CHECKING, Any
from urllib.parse import urlsplit

from ...atomic_file import whole_file
from ...costs.weights import EdgeWeights
from ...errors import ScenarioError
from ...network.road_network import RoadNetwork
from ...plans.records import JointPlan
from ..document.document import report_document
from ..markup.leaflet import load_leaflet
from .page_parts import PageParts

if TYPE_CHECKING:
    import folium

__all__ = ["explore", "plan_map", "write_html"]


def write_html(
    plan: JointPlan,
    net: RoadNetwork,
    path: str | os.PathLike[str],
    *,
    title: str | None = None,
    tiles: str | None = None,
    leaflet_dir: str | os.PathLike[str] | None = None,
    weights: EdgeWeights | None = None,
) -> None:
    """Write a plan's report: map, figures, table, points and provenance in one file.

    The same plan on the same network gives the same bytes. The file appears whole or not at all.

    Parameters
    ----------
    net : the network the plan was made on.
    path : of the file; its folder must exist.
    title : heads the page.
    tiles : None for a page that never asks the network for anything; or the name of an online
        map ("OpenStreetMap") or an https address with {z}, {x} and {y}, drawn underneath.
    leaflet_dir : another copy of Leaflet 1.9.3; by default that of package XStatic-Leaflet.
    weights : see `report_document`.

    Raises
    ------
    ScenarioError
        A plan that does not fit the network, an unknown map, no Leaflet, or a file that cannot be
        written.
    """
    made = plan_map(
        plan, net, title=title, tiles=tiles, leaflet_dir=leaflet_dir, weights=weights
    )  # fmt: skip
    text = made.get_root().render()
    with whole_file(path) as draft:
        draft.write_text(text, encoding="utf-8", newline="\n")


def plan_map(
    plan: JointPlan,
    net: RoadNetwork,
    *,
    title: str | None = None,
    tiles: str | None = None,
    leaflet_dir: str | os.PathLike[str] | None = None,
    weights: EdgeWeights | None = None,
) -> folium.Map:
    """Return a plan's report as a `folium.Map`; parameters and errors as in `write_html`.

    Its page is that of `write_html`. What a caller adds to it is folium's own, and rendered as
    folium does: add no names from a map to it.
    """
    from .folium_map import PlanMap

    document = report_document(plan, net, title=title, weights=weights)
    document["tiles"] = None if tiles is None else _tile_layer(tiles)
    if document["tiles"]:
        document["provenance"]["credits"].append(document["tiles"]["credit"])
    return PlanMap(PageParts(document, load_leaflet(leaflet_dir)))


def explore(plan: JointPlan, net: RoadNetwork, *, height: int = 640, **options: Any) -> folium.Map:
    """Return the report of a plan for a notebook, which shows it as it is.

    Parameters
    ----------
    height : of the frame in the notebook, in pixels.
    options : as of `plan_map`.
    """
    made = plan_map(plan, net, **options)
    figure: Any = made.get_root()
    figure.width, figure.height, figure.ratio = "100%", f"{height}px", None
    return made


def _tile_layer(tiles: str) -> dict[str, Any]:
    """Return address, credit and origin of an online map."""
    if tiles.startswith("https://") and "{z}" in tiles and "{x}" in tiles and "{y}" in tiles:
        url, credit, zoom = tiles, f"Background map: {urlsplit(tiles).hostname}", 19
    else:
        # folium brings it along; it has no type hints.
        import xyzservices.providers as online_maps  # type: ignore[import-untyped]

        try:
            # The plain name stands for the standard style, as in folium.
            plain = tiles.casefold() == "openstreetmap"
            provider = online_maps.query_name("OpenStreetMap.Mapnik" if plain else tiles)
        except ValueError:
            raise ScenarioError(
                f'tiles {tiles!r}: no online map of that name; try "OpenStreetMap" or an '
                "https address with {z}, {x} and {y}"
            ) from None
        if provider.requires_token():
            raise ScenarioError(
                f"tiles {tiles!r}: needs a key; give its https address with {{z}}, {{x}}, {{y}}"
            )
        url = provider.build_url(x="{x}", y="{y}", z="{z}", scale_factor="")
        credit = re.sub(r"^\(C\)", "\u00a9", provider["attribution"])
        zoom = int(provider.get("max_zoom", 19))
    host = urlsplit(url).netloc
    wanted = host.replace("{s}", "*")
    if not re.fullmatch(r"(\*\.)?[A-Za-z0-9.-]+(:\d+)?", wanted):
        raise ScenarioError(f"tiles {tiles!r}: host {host!r} is not a plain host name")
    return {"url": url, "credit": credit, "max_zoom": zoom, "origin": f"https://{wanted}"}
