"""Ribbons of traffic: as wide as the number of vehicles, each direction right of its road.

`assets/ribbons.js` draws the same on the live map.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import NamedTuple

from ..document.model import Document
from ..document.model_map import Traffic, TrafficRoads
from ..drawing.palette import CASING, PLATOON, PLATOON_CASING, TRAFFIC
from ..markup.fragments import Piece
from .lanes import apart, bands_width
from .map_view import MapView
from .pixels import DrawnLine, lines_along

__all__ = ["Ribbon", "ribbon_pieces", "ribbons"]

THINNEST, WIDEST = 1.8, 9.0

LEAST_MOST = 9
"""Of less traffic than this no road is drawn at full width."""

BETWEEN = 1.2
"""Pixels between ribbons, and between a ribbon and the middle of its road."""


class Ribbon(NamedTuple):
    """The roads of one traffic, drawn.

    Attributes
    ----------
    together : bool
        Whether they show platoons, or vehicles alone.
    width : float
        In pixels.
    lines : list of DrawnLine
        Where they run.
    """

    together: bool
    width: float
    lines: list[DrawnLine]


def ribbons(document: Document, view: MapView) -> list[Ribbon]:
    """Return the ribbons of a crowd: those of vehicles alone, then those of platoons if bundled.

    Parameters
    ----------
    document : Document
        What is drawn.
    view : MapView
        Where on the drawing things lie.

    Returns
    -------
    list of Ribbon
        Wide ones last; none of few vehicles.
    """
    if (traffic := document.traffic) is None:
        return []
    found: list[Ribbon] = []
    for roads in traffic.roads:
        lines = [view.pixels(line) for line in roads.lines]
        for together, width, aside in _strips(traffic, roads, view):
            drawn = [one for line in lines for one in lines_along([line], [aside])]
            found.append(Ribbon(together, width, drawn))
    return sorted(found, key=lambda ribbon: (ribbon.together, ribbon.width))


def _strips(
    traffic: Traffic, roads: TrafficRoads, view: MapView
) -> Iterator[tuple[bool, float, float]]:
    """Yield the ribbons on some roads: of whom, how wide, and how far right of the road."""
    free = BETWEEN / 2
    if traffic.bundled and roads.bands:
        width = _width(sum(roads.bands), traffic.most)
        yield True, width, free + width / 2
        free += width + BETWEEN
    elif roads.bands:
        whole = bands_width(roads.bands)
        free = whole / 2 + BETWEEN + apart(roads.opposite_m, whole, view)
    if roads.alone:
        width = _width(roads.alone, traffic.most)
        yield False, width, free + width / 2


def _width(vehicles: int, most: int) -> float:
    return THINNEST + (WIDEST - THINNEST) * math.sqrt(vehicles / max(most, LEAST_MOST))


def ribbon_pieces(found: list[Ribbon]) -> Iterator[Piece]:
    """Yield ribbons as SVG, those of platoons over the others, each over the casings of its kind.

    Parameters
    ----------
    found : list of Ribbon
        As `ribbons` returns them.

    Yields
    ------
    Piece
        A path for each.
    """
    for together, colour, casing in ((False, TRAFFIC, CASING), (True, PLATOON, PLATOON_CASING)):
        kind = [
            (ribbon.width, "".join(line.path for line in ribbon.lines))
            for ribbon in found
            if ribbon.together is together
        ]
        for stroke, more in ((casing, 2.0), (colour, 0.0)):
            for width, path in kind:
                yield Piece(
                    "static-line",
                    {
                        "path": path,
                        "colour": stroke,
                        "width": f"{width + more:.3g}",
                        "dash": "none",
                        "cap": "butt",
                    },
                )
