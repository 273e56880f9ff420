"""Lines of a drawing: points rounded once, drawn as they are, and written as short text.

They stay arrays until a page's JSON is written, so that nothing is decoded that was encoded in the
same breath. What is drawn is what a reader of the text would draw.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from typing import Self

import numpy as np
from numpy.typing import ArrayLike, NDArray

from .polyline import encode_steps, rounded_steps
from .trails import trails

__all__ = ["Line", "Lines", "Point", "Undirected"]

Point = tuple[float, float]

ROWS_PER_DEGREE = 8


@dataclass(frozen=True, slots=True, eq=False)
class Line:
    """One line of rounded points.

    Attributes
    ----------
    points : array of int, (k, 2)
        Longitude and latitude in steps, read-only.
    steps_per_degree : int
        How many steps make a degree.
    """

    points: NDArray[np.int64]
    steps_per_degree: int

    @classmethod
    def rounded(cls, lonlat: ArrayLike, steps_per_degree: int) -> Line:
        """Return a line of points, each rounded; those that round to the one before are left out.

        Parameters
        ----------
        lonlat : array_like of float, (k, 2)
            Longitude and latitude in degrees.
        steps_per_degree : int
            What they are rounded to.

        Returns
        -------
        Line
            At least two points, if there were as many.
        """
        points = rounded_steps(lonlat, steps_per_degree)
        points.flags.writeable = False
        return cls(points, steps_per_degree)

    def degrees(self) -> list[Point]:
        """Return its points in degrees.

        Returns
        -------
        list of tuple of float
            Longitude and latitude of each.
        """
        return [(lon, lat) for lon, lat in (self.points / self.steps_per_degree).tolist()]

    def encoded(self) -> str:
        """Return it as short text.

        Returns
        -------
        str
            An encoded polyline; empty without points.
        """
        return encode_steps(self.points)


@dataclass(frozen=True, slots=True, eq=False)
class Lines:
    """Many lines that are written as one text.

    Attributes
    ----------
    lines : tuple of Line
        In rows from south to north, so that the steps from one to the next are short.
    """

    lines: tuple[Line, ...]

    @classmethod
    def rounded(cls, lines: Iterable[ArrayLike], steps_per_degree: int) -> Self:
        """Return lines whose points are rounded, in the order in which they are written.

        Parameters
        ----------
        lines : iterable of array_like of float, (k, 2)
            Longitude and latitude in degrees.
        steps_per_degree : int
            What they are rounded to.

        Returns
        -------
        Lines
            All of them.
        """
        flat = sorted(
            (np.asarray(line, np.float64) for line in lines),
            key=lambda line: _row_order(line, steps_per_degree),
        )
        return cls(tuple(Line.rounded(line, steps_per_degree) for line in flat))

    def __iter__(self) -> Iterator[Line]:
        return iter(self.lines)

    def __len__(self) -> int:
        return len(self.lines)

    def encoded(self) -> str:
        """Return them as one text.

        Returns
        -------
        str
            Encoded polylines with blanks between them, each counted from the first point of the
            one before.
        """
        out: list[str] = []
        origin = (0, 0)
        for line in self.lines:
            out.append(encode_steps(line.points, origin))
            lon, lat = line.points[0].tolist()
            origin = (lon, lat)
        return " ".join(out)


@dataclass(frozen=True, slots=True, eq=False)
class Undirected(Lines):
    """Lines whose direction says nothing, so that those which meet may be written as one."""

    def encoded(self) -> str:
        """Return them as one text.

        Returns
        -------
        str
            As of `Lines`, with fewer and longer lines in which all points are as they are here.
        """
        if not self.lines:
            return ""
        steps = self.lines[0].steps_per_degree
        joined = trails([line.points for line in self.lines])
        # Not through `rounded`, which might round otherwise what is rounded already.
        found = [Line(points, steps) for points in joined]
        found.sort(key=lambda line: _row_order(line.points / steps, steps))
        return Lines(tuple(found)).encoded()


def _row_order(line: NDArray[np.float64], steps_per_degree: int) -> tuple[int, int, int, bytes]:
    """Return in which row a line begins and where; its bytes where two begin at one point."""
    lon, lat = np.rint(line[0] * steps_per_degree).astype(int).tolist()
    return lat * ROWS_PER_DEGREE // steps_per_degree, lon, lat, line.tobytes()
