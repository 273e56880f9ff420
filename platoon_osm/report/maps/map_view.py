"""The part of the world on a still drawing, and its pixels."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Sequence

import numpy as np

from ..document.model import Document
from ..drawing.lines import Line, Point
from .pixels import path_data, simplified

__all__ = ["MapView"]

WIDTH = 960.0
LEAST_HEIGHT, MOST_HEIGHT = 690.0, 980.0
MARGIN = 60.0
MOST_NETWORK_DATA = 80_000
"""Characters of path data that the still map spends on the background."""


def mercator(lon: float, lat: float) -> Point:
    """Return Web Mercator coordinates of a point.

    Parameters
    ----------
    lon, lat : float
        Degrees.

    Returns
    -------
    tuple of float
        In degrees at the equator; y grows south.
    """
    lat = max(-85.0, min(85.0, lat))
    return lon, -math.degrees(math.asinh(math.tan(math.radians(lat))))


class MapView:
    """The part of the world drawn, and its pixels.

    Parameters
    ----------
    documents : sequence of Document
        Whose routes all lie in it.
    width : float
        Of the drawing in pixels.
    heights : tuple of float
        Its least and greatest height.
    margin : float
        Kept free around the routes.
    """

    def __init__(
        self,
        documents: Sequence[Document],
        width: float = WIDTH,
        heights: tuple[float, float] = (LEAST_HEIGHT, MOST_HEIGHT),
        margin: float = MARGIN,
    ) -> None:
        self.width = width
        stops = [stop for document in documents for stop in _stops(document)]
        points = [
            mercator(*at)
            for document in documents
            for line in _plan_lines(document)
            for at in line.degrees()
        ]
        xs, ys = np.array(points + [mercator(*stop) for stop in stops]).T
        # A plan of one place still gets a drawing some 10 km wide.
        span_x, span_y = max(float(np.ptp(xs)), 0.1), max(float(np.ptp(ys)), 0.05)
        room = width - 2 * margin
        self.per_degree = min(room / span_x, (heights[1] - 2 * margin) / span_y)
        tall = span_y * self.per_degree + 2 * margin
        self.height = float(round(min(max(tall, heights[0]), heights[1])))
        self._x = width / 2 - self.per_degree * float(xs.min() + xs.max()) / 2
        self._y = self.height / 2 - self.per_degree * float(ys.min() + ys.max()) / 2
        self.latitude = float(np.mean([lat for _, lat in stops]))
        degree_m = 111_320 * math.cos(math.radians(self.latitude))
        self.metres_per_pixel = degree_m / max(self.per_degree, 1e-9)

    def at(self, lon: float, lat: float) -> Point:
        """Return the pixel of a point.

        Parameters
        ----------
        lon, lat : float
            Degrees.

        Returns
        -------
        tuple of float
            Right and down from the upper left corner.
        """
        x, y = mercator(lon, lat)
        return x * self.per_degree + self._x, y * self.per_degree + self._y

    def pixels(self, line: Line) -> list[Point]:
        """Return a line in pixels, without points that make no difference.

        Parameters
        ----------
        line : Line
            Of the document.

        Returns
        -------
        list of tuple of float
            Its pixels.
        """
        return simplified([self.at(lon, lat) for lon, lat in line.degrees()], 0.6)

    def path(self, lines: Iterable[Line]) -> str:
        """Return those lines that come near the drawing.

        Parameters
        ----------
        lines : iterable of Line
            Of the document.

        Returns
        -------
        str
            SVG path data.
        """
        kept = (self.pixels(line) for line in lines)
        return "".join(path_data(points) for points in kept if self._near(points))

    def network_path(self, lines: Iterable[Line], most: int = MOST_NETWORK_DATA) -> str:
        """Return the background: to half a pixel, twin carriageways once.

        Parameters
        ----------
        lines : iterable of Line
            Of the network.
        most : int
            About how many characters it may take.

        Returns
        -------
        str
            SVG path data.
        """
        kept: dict[tuple[Point, ...], list[Point]] = {}
        for line in lines:
            points = [(round(x * 2) / 2, round(y * 2) / 2) for x, y in self.pixels(line)]
            if not self._near(points) or max(np.ptp(np.asarray(points), axis=0)) < 1.5:
                continue
            # The other carriageway has nearly the same ends, a pixel or two apart.
            ends = tuple(sorted((round(x / 3), round(y / 3)) for x, y in (points[0], points[-1])))
            kept.setdefault(ends, points)
        # A dense network would outweigh all the rest of the page: its shortest lines stay out.
        longest = sorted(kept.values(), key=lambda line: -float(np.ptp(line, axis=0).sum()))
        room = most
        parts: list[str] = []
        for points in longest:
            parts.append(path_data(points))
            room -= len(parts[-1])
            if room < 0:
                break
        return "".join(parts)

    def _near(self, points: Sequence[Point]) -> bool:
        xs, ys = zip(*points, strict=True)
        return bool(max(xs) > 0 and min(xs) < self.width and max(ys) > 0 and min(ys) < self.height)


def _plan_lines(document: Document) -> Iterator[Line]:
    for section in document.platoons:
        yield from (part.line for part in section.parts)
    for solo in document.solos:
        yield from (part.line for part in solo.parts)


def _stops(document: Document) -> list[Point]:
    return [
        (stop.lon, stop.lat)
        for vehicle in document.vehicles
        for stop in (vehicle.origin, vehicle.destination)
    ]
