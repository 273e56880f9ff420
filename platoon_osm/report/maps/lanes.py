"""Which lane of its road a line is drawn in, so that all lines and bands on it show."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

from ..document.model import Document
from ..document.model_map import BandPart, LanePart
from .map_view import MapView

__all__ = [
    "Strip",
    "apart",
    "band_aside",
    "band_lines",
    "band_strips",
    "band_width",
    "bands_width",
    "solo_aside",
    "solo_step",
    "solo_strips",
]

SOLO_CASING = 7.0
"""Width of a solo line with its white casing."""


def band_lines(vehicles: int) -> tuple[float, float]:
    """Return how the lines of a platoon lie in its band.

    Parameters
    ----------
    vehicles : int
        How many there are.

    Returns
    -------
    tuple of float
        The distance between lines and their width, in pixels.
    """
    step = min(6.0, 36.0 / vehicles)
    return step, min(4.0, step * 0.68)


def band_width(vehicles: int) -> float:
    """Return the width of a platoon's band.

    Parameters
    ----------
    vehicles : int
        How many lines lie in it.

    Returns
    -------
    float
        In pixels.
    """
    return 6 + band_lines(vehicles)[0] * vehicles


def bands_width(beside: Sequence[int]) -> float:
    """Return the width of several bands side by side, casings included.

    Parameters
    ----------
    beside : sequence of int
        Vehicles in each.

    Returns
    -------
    float
        In pixels.
    """
    return sum(band_width(count) + 2 for count in beside)


def band_aside(part: BandPart, view: MapView) -> float:
    """Return how far right of the road a band's middle lies, so that all bands on it show.

    Parameters
    ----------
    part : BandPart
        Of a platoon's line.
    view : MapView
        Where on the drawing things lie.

    Returns
    -------
    float
        In pixels.
    """
    before = bands_width(part.beside[: part.place])
    own = bands_width(part.beside[part.place :][:1])
    whole = bands_width(part.beside)
    return before + own / 2 - whole / 2 + apart(part.opposite_m, whole, view)


def apart(opposite_m: int | None, width: float, view: MapView) -> float:
    """Return how far right of its road a strip of lines goes, to let the other way pass it.

    Parameters
    ----------
    opposite_m : int or None
        How far away others drive the other way [m]; None if none do.
    width : float
        Of the strip in pixels.
    view : MapView
        Where on the drawing things lie.

    Returns
    -------
    float
        In pixels.
    """
    if opposite_m is None:
        return 0.0
    return float(max(0.0, width / 2 + 0.5 - opposite_m / view.metres_per_pixel / 2))


def solo_step(slots: int) -> float:
    """Return the distance between vehicles alone on one road.

    Parameters
    ----------
    slots : int
        How many there are.

    Returns
    -------
    float
        In pixels.
    """
    return min(7.0, 26.0 / max(slots - 1, 1))


def solo_aside(part: LanePart, view: MapView) -> float:
    """Return how far right of the road a vehicle alone is drawn, clear of any bands on it.

    Parameters
    ----------
    part : LanePart
        Of its line.
    view : MapView
        Where on the drawing things lie.

    Returns
    -------
    float
        In pixels.
    """
    step = solo_step(part.slots)
    if part.bands:
        width = bands_width(part.bands)
        return float(width / 2 + 4 + step * part.slot + apart(part.opposite_m, width, view))
    across = step * (part.slots - 1)
    return float(step * part.slot - across / 2 + apart(part.opposite_m, across + SOLO_CASING, view))


class Strip(NamedTuple):
    """Where the lines of one stretch lie beside its roads, in pixels.

    Attributes
    ----------
    asides : list of float
        How far right of each road their middle lies.
    offsets : list of float
        How far right of that middle each line lies.
    width : float
        Of a line.
    inner : float
        Width of the band they lie in; 0 without one.
    """

    asides: list[float]
    offsets: list[float]
    width: float
    inner: float


def solo_strips(document: Document, view: MapView) -> list[Strip]:
    """Return where the line of each vehicle alone lies.

    Parameters
    ----------
    document : Document
        What is drawn.
    view : MapView
        Where on the drawing things lie.

    Returns
    -------
    list of Strip
        In the order of the document's solos.
    """
    found: list[Strip] = []
    for solo in document.solos:
        slots = max((part.slots for part in solo.parts), default=1)
        width = min(3.6, max(1.3, solo_step(slots) * 0.8))
        found.append(Strip([solo_aside(part, view) for part in solo.parts], [0.0], width, 0.0))
    return found


def band_strips(document: Document, view: MapView) -> list[Strip]:
    """Return where the lines of each platoon lie in its band, and the band's middle before them.

    Parameters
    ----------
    document : Document
        What is drawn.
    view : MapView
        Where on the drawing things lie.

    Returns
    -------
    list of Strip
        In the order of the document's platoons.
    """
    found: list[Strip] = []
    for section in document.platoons:
        count = len(section.vehicles)
        step, width = band_lines(count)
        lanes = ((place - (count - 1) / 2) * step for place in range(count))
        asides = [band_aside(part, view) for part in section.parts]
        found.append(Strip(asides, [0.0, *lanes], width, band_width(count)))
    return found
