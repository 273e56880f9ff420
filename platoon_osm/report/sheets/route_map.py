"""A small still map of one vehicle's own route: its lines, its points, and nobody else's."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from ...shown_text import fitted
from ..document.findings import Findings
from ..document.model import Document
from ..document.model_map import EventMark
from ..language.speech import say
from ..maps.background import Background
from ..maps.ground_paths import ground_piece
from ..maps.map_view import MapView
from ..maps.static_map import map_foreground
from ..markup.fragments import Piece
from .steps import Step

__all__ = ["own_document", "route_map"]

NETWORK_DATA = 14_000
"""Characters of the background: fifty such maps stand in one file."""

BEYOND_PX = 200.0
"""How far the ground reaches beyond the map, which has another shape than its frame on paper."""


def own_document(
    found: Findings, document: Document, index: int, steps: Sequence[Step]
) -> Document:
    """Return a document that knows one vehicle only, as if nobody else were on the road.

    Parameters
    ----------
    found : Findings
        Of the plan.
    document : Document
        Of the plan.
    index : int
        Position of the vehicle.
    steps : sequence of Step
        Its own; a place has one mark, whatever happens there.

    Returns
    -------
    Document
        Its lines lie in the middle of the road.
    """
    solos = tuple(
        replace(
            solo,
            vehicle=0,
            parts=tuple(
                replace(part, slot=0, slots=1, bands=(), opposite_m=None) for part in solo.parts
            ),
        )
        for solo in document.solos
        if solo.vehicle == index
    )
    platoons = tuple(
        replace(
            one,
            vehicles=(0,),
            costs=(),
            parts=tuple(replace(part, beside=(1,), place=0, opposite_m=None) for part in one.parts),
        )
        for one in document.platoons
        if index in one.vehicles
    )
    events = tuple(
        EventMark(
            kind=_kind(step),
            lon=found.longitude(step.place.lon),
            lat=step.place.lat,
            name=fitted(step.place.name),
            vehicles=(0,),
            others=(),
            at_m=None,
            at_s=None,
            text="",
            detail="",
            has_parking=not step.is_pause or step.pauses[0].has_parking,
        )
        for step in steps[1:-1]
        if step.joined or step.left or step.pauses
    )
    return replace(
        document,
        vehicles=(document.vehicles[index],),
        groups=(),
        platoons=platoons,
        solos=solos,
        events=events,
        traffic=None,
    )


def _kind(step: Step) -> str:
    if step.is_pause:
        return step.pauses[0].what
    return "merge" if step.joined else "separation"


def route_map(own: Document, key: str, size: tuple[float, float], background: Background) -> Piece:
    """Return the map of one vehicle's route.

    Parameters
    ----------
    own : Document
        Of `own_document`.
    key : str
        Parts its names from those of other maps on a page.
    size : tuple of float
        Its width, and about how high it is drawn, in its own pixels.
    background : Background
        Of the known roads of the plan's document.

    Returns
    -------
    Piece
        One SVG.
    """
    height = float(round(size[1]))
    view = MapView([own], size[0], (height, height), margin=34.0)
    vehicle = own.vehicles[0]
    return Piece(
        "sheet-map",
        {
            "key": key,
            "width": f"{view.width:g}",
            "height": f"{view.height:g}",
            "label": say(
                "sheet.map", origin=vehicle.origin.name, destination=vehicle.destination.name
            ),
            "ground": ground_piece(own, view, BEYOND_PX),
            "network": background.path(view, NETWORK_DATA),
            **map_foreground(own, view, 1.0, whole=False),
        },
    )
