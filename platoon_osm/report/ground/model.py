"""The ground as a document holds it."""

from __future__ import annotations

from dataclasses import dataclass

from ..drawing.lines import Lines
from .clipping import Frame

__all__ = ["Ground", "GroundPatch"]


@dataclass(frozen=True, slots=True, eq=False)
class GroundPatch:
    """Land and borders of a part of the world.

    Attributes
    ----------
    frame : Frame
        Which part, in degrees; longitudes may lie beyond 180.
    steps : int
        Steps to a degree in which its lines are rounded.
    land : Lines
        Rings around land, clockwise, and around water in it, the other way, without the last point,
        which is the first; what is in none of them is sea.
    borders : Lines
        Between countries.
    """

    frame: Frame
    steps: int
    land: Lines
    borders: Lines


@dataclass(frozen=True, slots=True, eq=False)
class Ground:
    """What lies under a map.

    Attributes
    ----------
    patches : tuple of GroundPatch
        Each covers what those before it say of its part of the world.
    """

    patches: tuple[GroundPatch, ...]
