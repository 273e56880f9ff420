"""Land, sea, borders and the dots of towns on a still drawing."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..document.model import Document
from ..document.surroundings import Surroundings
from ..drawing.basemap import BASEMAP_STEPS
from ..drawing.lines import Lines
from ..ground.clipping import Frame, cut_lines, cut_ring
from ..ground.model import GroundPatch
from ..markup.fragments import Piece, Tree
from .beside import TOLERANCE
from .map_view import MapView

__all__ = ["BEYOND", "ground_piece", "town_dots"]

Floats = NDArray[np.float64]

BEYOND = 330.0
"""So many pixels beyond its edge a map has ground that may be shown in a frame of another shape."""

EDGE = 6.0
"""And so many any other map, so that no line along a cut is seen."""

DOT_WIDTHS = {0: 4.4, 1: 3.0}
"""Of a town's dot by its rank, in pixels; villages have none."""

MOST_DOTS = 80
"""Of each rank."""


def ground_piece(document: Document | Surroundings, view: MapView, beyond: float = EDGE) -> Piece:
    """Return what lies under everything else on a still map, over all of it.

    Parameters
    ----------
    document : Document or Surroundings
        Whose ground is drawn.
    view : MapView
        The part of the world drawn.
    beyond : float
        How far beyond the edges of the view it reaches, in pixels.

    Returns
    -------
    Piece
        Sea, land and borders; without a ground, land alone.
    """
    if document.ground is None:
        return Piece("plain-ground", {"width": f"{view.width:g}", "height": f"{view.height:g}"})
    box = Frame(-beyond, -beyond, view.width + beyond, view.height + beyond)
    seen: list[GroundPatch] = []
    for patch in reversed(document.ground.patches):
        own = _frame(patch, view)
        if box.west < own.east and own.west < box.east:
            seen.insert(0, patch)
        if own.holds(box):
            break
    return Piece("ground", {"patches": tuple(_patch(patch, view, box) for patch in seen)})


def _frame(patch: GroundPatch, view: MapView) -> Frame:
    """Return a patch's part of the world in pixels, which grow from its upper side downwards."""
    left, bottom = view.at(patch.frame.west, patch.frame.south)
    right, top = view.at(patch.frame.east, patch.frame.north)
    return Frame(left, top, right, bottom)


def _patch(patch: GroundPatch, view: MapView, box: Frame) -> Piece:
    own = _frame(patch, view)
    cut = Frame(
        max(own.west, box.west),
        max(own.south, box.south),
        min(own.east, box.east),
        min(own.north, box.north),
    )
    closed = [np.vstack([line, line[:1]]) for line in _pixels(patch.land, view)]
    rings = [ring for line in closed if len(ring := cut_ring(line, cut))]
    lines = cut_lines(_pixels(patch.borders, view), cut)
    return Piece(
        "ground-patch",
        {
            "x": f"{cut.west:.1f}",
            "y": f"{cut.south:.1f}",
            "width": f"{cut.east - cut.west:.1f}",
            "height": f"{cut.north - cut.south:.1f}",
            "land": _path(rings, closed=True),
            "borders": _path(lines, closed=False),
        },
    )


def _pixels(lines: Lines, view: MapView) -> list[Floats]:
    return [np.array(view.pixels(line)) for line in lines]


def _path(lines: list[Floats], *, closed: bool) -> str:
    """Return SVG path data in halves of a pixel, so that it is whole numbers throughout."""
    import shapely

    if not lines:
        return ""
    owner = np.repeat(np.arange(len(lines)), [len(line) for line in lines])
    drawn: Any = shapely.linestrings(np.concatenate(lines), indices=owner)
    simple: Any = shapely.simplify(drawn, TOLERANCE, preserve_topology=False)
    out: list[str] = []
    for line in simple:
        points = np.rint(shapely.get_coordinates(line) * 2).astype(int)
        steps = np.diff(points, axis=0)
        steps = steps[(steps != 0).any(axis=1)]
        if closed:
            steps = steps[:-1]
        if len(steps) < 1 + closed:
            continue
        out.append(f"M{points[0, 0]} {points[0, 1]}l{_numbers(steps.ravel())}{'z' * closed}")
    return "".join(out)


def _numbers(values: Iterable[int]) -> str:
    """Return numbers with blanks where no sign parts them."""
    return "".join(f"{value}" if value < 0 else f" {value}" for value in values).lstrip()


def town_dots(document: Document | Surroundings, view: MapView) -> Tree:
    """Return the dots of the most important towns in view.

    Parameters
    ----------
    document : Document or Surroundings
        Whose towns they are.
    view : MapView
        The part of the world drawn.

    Returns
    -------
    Tree
        A dot for each.
    """
    rows: dict[int, list[str]] = {rank: [] for rank in DOT_WIDTHS}
    for town in document.towns:
        x, y = view.at(town.lon / BASEMAP_STEPS, town.lat / BASEMAP_STEPS)
        if town.rank in rows and 0 < x < view.width and 0 < y < view.height:
            rows[town.rank].append(f"M{x:.0f} {y:.0f}h0")
    # A line without length and with round ends is a dot.
    return tuple(
        Piece("town-dots", {"path": "".join(dots[:MOST_DOTS]), "width": f"{DOT_WIDTHS[rank]:g}"})
        for rank, dots in rows.items()
        if dots
    )
