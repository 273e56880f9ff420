"""Finding room for texts on a drawing: boxes go where they cover least of what is there."""

from __future__ import annotations

import math
from collections import defaultdict
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from itertools import pairwise

from ..drawing.lines import Point

__all__ = ["SOLID", "Box", "Cover", "crosses"]

CELL = 5.0
SOLID = 1_000
"""Weight of what must not be covered at all: marks and texts."""

LINE = 1


@dataclass(frozen=True, slots=True)
class Box:
    """A rectangle in pixels, y downwards.

    Attributes
    ----------
    left, top : float
        Its upper left corner.
    width, height : float
        Its size.
    """

    left: float
    top: float
    width: float
    height: float

    @property
    def right(self) -> float:
        """The right edge."""
        return self.left + self.width

    @property
    def bottom(self) -> float:
        """The lower edge."""
        return self.top + self.height

    def is_crossed(self, start: Point, end: Point) -> bool:
        """Return whether a straight line runs through it.

        Parameters
        ----------
        start, end : tuple of float
            Pixels.

        Returns
        -------
        bool
            Whether it does, or begins or ends there.
        """
        if any(
            self.left <= x <= self.right and self.top <= y <= self.bottom for x, y in (start, end)
        ):
            return True
        falling = (self.left, self.top), (self.right, self.bottom)
        rising = (self.left, self.bottom), (self.right, self.top)
        return crosses(start, end, *falling) or crosses(start, end, *rising)


def crosses(a: Point, b: Point, c: Point, d: Point) -> bool:
    """Return whether the way from a to b crosses that from c to d.

    Parameters
    ----------
    a, b, c, d : tuple of float
        Pixels.

    Returns
    -------
    bool
        Whether they have a point inside both in common.
    """

    def side(p: Point, q: Point, r: Point) -> float:
        return (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0])

    return side(a, b, c) * side(a, b, d) < 0 and side(c, d, a) * side(c, d, b) < 0


class Cover:
    """What of a drawing is taken, on a grid of cells of `CELL` pixels.

    Parameters
    ----------
    width, height : float
        Of the drawing.
    """

    def __init__(self, width: float, height: float) -> None:
        self.width = width
        self.height = height
        self._weight: dict[tuple[int, int], int] = defaultdict(int)

    def copy(self) -> Cover:
        """Return another that has the same taken so far.

        Returns
        -------
        Cover
            What is taken of it later is not taken of this.
        """
        made = Cover(self.width, self.height)
        made._weight.update(self._weight)
        return made

    def add_line(self, points: Sequence[tuple[float, float]], weight: int = LINE) -> None:
        """Mark the cells that a line passes.

        Parameters
        ----------
        points : sequence of tuple of float
            Pixels.
        weight : int
            How much each cell counts when it is covered.
        """
        for (x0, y0), (x1, y1) in pairwise(points):
            steps = max(1, math.ceil(math.hypot(x1 - x0, y1 - y0) / CELL))
            for step in range(steps + 1):
                share = step / steps
                cell = self._cell(x0 + (x1 - x0) * share, y0 + (y1 - y0) * share)
                self._weight[cell] = max(self._weight[cell], weight)

    def add_lines(self, lines: Iterable[Sequence[tuple[float, float]]], weight: int = LINE) -> None:
        """Mark the cells that lines pass.

        Parameters
        ----------
        lines : iterable of sequence
            The pixels of each.
        weight : int
            How much each cell counts when it is covered.
        """
        for points in lines:
            self.add_line(points, weight)

    def add_boxes(self, boxes: Iterable[Box]) -> None:
        """Mark boxes as taken by marks or texts.

        Parameters
        ----------
        boxes : iterable of Box
            What is taken.
        """
        for box in boxes:
            self.add_box(box)

    def add_box(self, box: Box) -> None:
        """Mark a box as taken by a mark or text.

        Parameters
        ----------
        box : Box
            What is taken.
        """
        for cell in self._cells(box):
            self._weight[cell] += SOLID

    def free_box(self, box: Box) -> None:
        """Give back a box that was taken.

        Parameters
        ----------
        box : Box
            Of `add_box`.
        """
        for cell in self._cells(box):
            self._weight[cell] -= SOLID

    def cost(self, box: Box) -> float:
        """Return how much a box would cover.

        Parameters
        ----------
        box : Box
            Where something may go.

        Returns
        -------
        float
            The sum over its cells; infinite outside the drawing.
        """
        if box.left < 0 or box.top < 0 or box.right > self.width or box.bottom > self.height:
            return math.inf
        return float(sum(self._weight.get(cell, 0) for cell in self._cells(box)))

    def place(
        self,
        candidates: Iterable[tuple[Box, float]],
        most: float,
        more: Callable[[Box], float] = lambda _: 0.0,
    ) -> Box | None:
        """Take the candidate of least cost.

        Parameters
        ----------
        candidates : iterable of tuple of Box and float
            Where something may go, and what that place costs by itself.
        most : float
            What it must cost less than.
        more : callable
            What a place costs besides.

        Returns
        -------
        Box or None
            Its place, which is taken now; None if all cost `most` or more.
        """
        best: Box | None = None
        least = most
        for box, own in candidates:
            cost = self.cost(box) + own
            if cost < least:
                cost += more(box)
            if cost < least:
                best, least = box, cost
        if best is not None:
            self.add_box(best)
        return best

    @staticmethod
    def _cell(x: float, y: float) -> tuple[int, int]:
        return int(x // CELL), int(y // CELL)

    def _cells(self, box: Box) -> Iterable[tuple[int, int]]:
        left, top = self._cell(box.left, box.top)
        right, bottom = self._cell(box.right, box.bottom)
        return ((x, y) for x in range(left, right + 1) for y in range(top, bottom + 1))
