"""The report of a plan as one HTML file that needs nothing else, now or in years."""

from __future__ import annotations

import os
from dataclasses import replace
from typing import TYPE_CHECKING, Any

from ...atomic_file import whole_file
from ...costs.weights import EdgeWeights
from ...errors import ScenarioError, brief
from ...kinds import is_number
from ...network.road_network import RoadNetwork
from ...output_paths import PAGES
from ...plans.curves import DelayFrontier, DepartureCurve
from ...plans.plan import Plan
from ..document.checks import check_path
from ..document.document import document_of
from ..document.model import Document
from ..markup.leaflet import load_leaflet
from .online_map import Tiles, online_map
from .page_parts import PageParts

if TYPE_CHECKING:
    import folium

__all__ = ["explore", "plan_map", "write_html"]


def write_html(
    plan: Plan,
    net: RoadNetwork,
    path: str | os.PathLike[str],
    *,
    title: str | None = None,
    tiles: str | None = None,
    leaflet_dir: str | os.PathLike[str] | None = None,
    weights: EdgeWeights | None = None,
    language: str | None = None,
    clock: int | None = None,
    curve: DepartureCurve | None = None,
    frontier: DelayFrontier | None = None,
) -> None:
    """Write a plan's report: map, figures, table, points and provenance in one file.

    The same plan on the same network gives the same bytes. The file appears whole or not at all.

    Parameters
    ----------
    plan : Plan
        What is told.
    net : RoadNetwork
        The network the plan was made on.
    path : path-like
        Of the file; missing folders are made.
    title : str or None
        Heads the page; by default made from the first vehicle's journey.
    tiles : str or None
        None for a page that never asks the network for anything; or the name of an online map
        ("OpenStreetMap") or an https address with {z}, {x} and {y}, drawn underneath.
    leaflet_dir : path-like or None
        Another copy of Leaflet 1.9.3; by default that of package XStatic-Leaflet.
    weights : EdgeWeights or None
        Those the plan was made with; see `report_document`.
    language : str or None
        That the texts are in, such as "de"; by default English.
    clock : int or None
        24 or 12 hours; by default as the language has it.
    curve : DepartureCurve or None
        What is saved by when the master leaves, for a section of the page.
    frontier : DelayFrontier or None
        What is saved by how late all may arrive, likewise.

    Raises
    ------
    ScenarioError
        A plan that does not fit the network, an unknown map, no Leaflet, or a file that cannot be
        written.
    """
    path = check_path(path)
    made = plan_map(
        plan,
        net,
        title=title,
        tiles=tiles,
        leaflet_dir=leaflet_dir,
        weights=weights,
        language=language,
        clock=clock,
        curve=curve,
        frontier=frontier,
    )
    text = made.get_root().render()
    with whole_file(path, suffixes=PAGES) as draft:
        draft.write_text(text, encoding="utf-8", newline="\n")


def plan_map(
    plan: Plan,
    net: RoadNetwork,
    *,
    title: str | None = None,
    tiles: str | None = None,
    leaflet_dir: str | os.PathLike[str] | None = None,
    weights: EdgeWeights | None = None,
    language: str | None = None,
    clock: int | None = None,
    curve: DepartureCurve | None = None,
    frontier: DelayFrontier | None = None,
) -> folium.Map:
    """Return a plan's report as a `folium.Map`, whose page is that of `write_html`.

    What a caller adds to it is folium's own, and rendered as folium does: add no names from a map
    to it.

    Parameters
    ----------
    plan : Plan
        What is told.
    net : RoadNetwork
        The network the plan was made on.
    title : str or None
        Heads the page.
    tiles : str or None
        An online map drawn underneath; see `write_html`.
    leaflet_dir : path-like or None
        Another copy of Leaflet 1.9.3.
    weights : EdgeWeights or None
        Those the plan was made with; see `report_document`.
    language : str or None
        That the texts are in, such as "de"; by default English.
    clock : int or None
        24 or 12 hours; by default as the language has it.
    curve : DepartureCurve or None
        What is saved by when the master leaves, for a section of the page.
    frontier : DelayFrontier or None
        What is saved by how late all may arrive, likewise.

    Returns
    -------
    folium.Map
        The map.

    Raises
    ------
    ScenarioError
        As in `write_html`.
    """
    from .folium_map import PlanMap

    document = document_of(plan, net, title=title, weights=weights, language=language, clock=clock)
    layer = None if tiles is None else online_map(tiles)
    if layer is not None:
        document = _crediting(document, layer)
    return PlanMap(PageParts(document, load_leaflet(leaflet_dir), layer, (), curve, frontier))


def _crediting(document: Document, tiles: Tiles) -> Document:
    named = document.provenance
    return replace(document, provenance=replace(named, credits=(*named.credits, tiles.credit)))


def explore(plan: Plan, net: RoadNetwork, *, height: int = 640, **options: Any) -> folium.Map:
    """Return the report of a plan for a notebook, which shows it as it is.

    Parameters
    ----------
    plan : Plan
        What is told.
    net : RoadNetwork
        The network the plan was made on.
    height : int
        Of the frame in the notebook, in pixels.
    **options : dict
        As of `plan_map`.

    Returns
    -------
    folium.Map
        The map.

    Raises
    ------
    ScenarioError
        As in `write_html`, or a height that is none.
    """
    if not is_number(height) or not 0 < height < 1e5:
        raise ScenarioError(
            f"explore: height {brief(height)} must be a number of pixels, such as 640"
        )
    made = plan_map(plan, net, **options)
    figure: Any = made.get_root()
    figure.width, figure.height, figure.ratio = "100%", f"{height}px", None
    return made
