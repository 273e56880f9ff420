"""Where everything stands on the map of a figure: nothing that is read covers anything else.

Marks come first, then the credit takes the corner where it covers least, then callouts, then names
of towns. A callout or name that finds no free place is left out; its mark stays.
"""

from __future__ import annotations

from dataclasses import dataclass

from ..document.model import Document
from ..drawing.lines import Point
from ..maps.beside import laid_beside
from ..maps.lanes import band_aside, band_lines, solo_aside
from ..maps.map_texts import Callout, clipped, placed_callouts, placed_names, text_width
from ..maps.map_view import MapView
from ..maps.placement import SOLID, Box, Cover
from ..maps.static_marks import Mark, placed_marks

__all__ = ["CREDIT_SIZE", "Layout", "layout_of"]

CREDIT_SIZE = 9.25
"""Of the credit's type, in pixels: 5 points on paper."""

CREDIT_HEIGHT, CREDIT_MARGIN = 15.0, 4.0


@dataclass(frozen=True, slots=True)
class Band:
    """The road of a platoon.

    Attributes
    ----------
    middle : list of tuple of float
        Along the middle of the band, in pixels.
    lanes : list of list of tuple of float
        Of each vehicle.
    """

    middle: list[Point]
    lanes: list[list[Point]]


@dataclass(frozen=True, slots=True)
class Layout:
    """A map in pixels.

    Attributes
    ----------
    view : MapView
        The part of the world that is drawn.
    solos : list of list of tuple of float
        Roads that vehicles drive alone, in the document's order.
    bands : list of Band
        Roads of platoons, in the document's order.
    marks : list of Mark
        Starts, destinations, merges and separations.
    callouts : list of Callout
        Of the events that found room.
    names : list of tuple of str and Box
        Of towns.
    credit : tuple of str and Box
        Whose map it is.
    """

    view: MapView
    solos: list[list[Point]]
    bands: list[Band]
    marks: list[Mark]
    callouts: list[Callout]
    names: list[tuple[str, Box]]
    credit: tuple[str, Box]


def layout_of(document: Document) -> Layout:
    """Lay out the map of a plan.

    Parameters
    ----------
    document : Document
        What is drawn.

    Returns
    -------
    Layout
        Everything in its place.
    """
    view = MapView([document], heights=(320.0, 980.0), margin=44.0)
    cover = Cover(view.width, view.height)
    solos = [
        laid_beside(
            [(view.pixels(part.line), solo_aside(part, view)) for part in solo.parts], (0.0,)
        )[0]
        for solo in document.solos
    ]
    cover.add_lines(solos, weight=3)
    bands: list[Band] = []
    for section in document.platoons:
        count = len(section.vehicles)
        step, _ = band_lines(count)
        roads = [(view.pixels(part.line), band_aside(part, view)) for part in section.parts]
        asides = (0.0, *((place - (count - 1) / 2) * step for place in range(count)))
        middle, *lanes = laid_beside(roads, asides)
        cover.add_lines(lanes, weight=6)
        bands.append(Band(middle, lanes))
    marks = placed_marks(document, view)
    cover.add_boxes(mark.box for mark in marks)
    credit = _credit(document, cover)
    cover.add_box(credit[1])
    events = [(mark.x, mark.y) for mark in marks if mark.is_event]
    callouts = list(placed_callouts(document, events, cover))
    names = list(placed_names(document, view.places(document).towns, cover))
    return Layout(view, solos, bands, marks, callouts, names, credit)


def _credit(document: Document, cover: Cover) -> tuple[str, Box]:
    """Return the credit in the corner where it covers least, below before above."""
    room = cover.width - 2 * CREDIT_MARGIN
    text = clipped(" \u00b7 ".join(document.provenance.credits), CREDIT_SIZE, widest=room)
    width = min(text_width(text, CREDIT_SIZE), room)
    corners = [
        Box(left, top, width, CREDIT_HEIGHT)
        for top in (cover.height - CREDIT_HEIGHT - CREDIT_MARGIN, CREDIT_MARGIN)
        for left in (cover.width - width - CREDIT_MARGIN, CREDIT_MARGIN)
    ]
    return text, min(corners, key=lambda box: cover.cost(box) // SOLID)
