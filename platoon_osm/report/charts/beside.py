"""Lines of a time-distance diagram side by side: trucks drive alike, so their true lines coincide.

Every line keeps its true points and is only moved as a whole, square to its direction: in a platoon
into its lane, alone by the least that keeps it off platoons and other lines. Where nothing is in
the way nothing is moved.
"""

from __future__ import annotations

import itertools
import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass

from ..drawing.lines import Point

__all__ = ["Moved", "Ribbon", "aside_of", "normal"]

STEP, FARTHEST = 5.0, 60.0
"""How far lines are moved: in steps of the first, up to the second, in pixels."""

BLANK = 3.6
"""Least distance between the middle of a line and what it is kept off."""

SAMPLE = 6.0
"""Lines are compared at heights so far apart."""

TOUCH = 3
"""Where fewer heights in a row are too near, lines cross or meet, and may."""


@dataclass(frozen=True, slots=True)
class Ribbon:
    """What is drawn already.

    Attributes
    ----------
    points : tuple of tuple of float
        Its true line, downwards, in pixels.
    aside : float
        How far it is moved.
    half : float
        Half its width.
    """

    points: tuple[Point, ...]
    aside: float
    half: float


@dataclass(frozen=True, slots=True)
class Moved:
    """A piece of a vehicle's line.

    Attributes
    ----------
    points : tuple of tuple of float
        The true line, in pixels.
    by : tuple of float
        How it is moved, in pixels.
    """

    points: tuple[Point, ...]
    by: Point

    @property
    def first(self) -> Point:
        """Where it begins in the drawing."""
        return self.points[0][0] + self.by[0], self.points[0][1] + self.by[1]

    @property
    def last(self) -> Point:
        """Where it ends in the drawing."""
        return self.points[-1][0] + self.by[0], self.points[-1][1] + self.by[1]


def normal(points: Sequence[Point]) -> Point:
    """Return the direction square to a line, of length 1: up and to the right.

    Parameters
    ----------
    points : sequence of tuple of float
        Of the line, which runs down and to the right.

    Returns
    -------
    tuple of float
        In pixels.
    """
    (x1, y1), (x2, y2) = points[0], points[-1]
    length = math.hypot(x2 - x1, y2 - y1)
    return ((y2 - y1) / length, -(x2 - x1) / length) if length else (1.0, 0.0)


def aside_of(points: Sequence[Point], drawn: Sequence[Ribbon]) -> float:
    """Return by how little a line may be moved to keep off all that is drawn.

    Parameters
    ----------
    points : sequence of tuple of float
        Of the line, in pixels.
    drawn : sequence of Ribbon
        What it is kept off.

    Returns
    -------
    float
        In pixels, to the upper right if positive; 0 if there is no room.
    """
    across = normal(points)[0]
    near = [list(_gaps(points, one, across)) for one in drawn]
    steps = int(FARTHEST / STEP)
    tries = (0.0, *(k * STEP * sign for k in range(1, steps + 1) for sign in (1, -1)))
    return next(
        (
            aside
            for aside in tries
            if all(
                sum(abs(gap + aside) < one.half + BLANK for gap in gaps) < TOUCH
                for gaps, one in zip(near, drawn, strict=True)
            )
        ),
        0.0,
    )


def _gaps(points: Sequence[Point], other: Ribbon, across: float) -> Iterator[float]:
    """Yield how far a line is from another, square to it, at all heights that both have."""
    top = max(points[0][1], other.points[0][1])
    bottom = min(points[-1][1], other.points[-1][1])
    for k in range(int((bottom - top) / SAMPLE) + 1 if bottom >= top else 0):
        y = top + k * SAMPLE
        yield (_x_at(points, y) - _x_at(other.points, y)) * across - other.aside


def _x_at(points: Sequence[Point], y: float) -> float:
    for (x1, y1), (x2, y2) in itertools.pairwise(points):
        if y <= y2:
            return x1 + (x2 - x1) * (y - y1) / (y2 - y1) if y2 > y1 else x1
    return points[-1][0]
