"""The part of the world on a still drawing, and its pixels."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from ..document.model import Document
from ..document.surroundings import Surroundings
from ..drawing.basemap import BASEMAP_STEPS
from ..drawing.lines import Line, Point

__all__ = ["MapView", "Places", "mercator"]

Floats = NDArray[np.float64]

WIDTH = 960.0
LEAST_HEIGHT, MOST_HEIGHT = 690.0, 980.0
MARGIN = 60.0


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


class Places(NamedTuple):
    """Where the points of a document lie on a drawing, in pixels and in the document's order.

    Attributes
    ----------
    events : list of tuple of float
        Where vehicles merge or separate.
    origins, destinations : list of tuple of float
        Where each vehicle starts and ends.
    towns : list of tuple of float
        Where the towns are.
    """

    events: list[Point]
    origins: list[Point]
    destinations: list[Point]
    towns: list[Point]


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
        stops = [stop for document in documents for stop in _stops(document)]
        points = [
            mercator(*at)
            for document in documents
            for line in _plan_lines(document)
            for at in line.degrees()
        ]
        points += [mercator(*stop) for stop in stops]
        self._fit(points, float(np.mean([lat for _, lat in stops])), width, heights, margin)

    @classmethod
    def around(
        cls,
        lonlat: Sequence[Point],
        width: float = WIDTH,
        heights: tuple[float, float] = (LEAST_HEIGHT, MOST_HEIGHT),
        margin: float = MARGIN,
    ) -> MapView:
        """Return the part of the world around some points.

        Parameters
        ----------
        lonlat : sequence of tuple of float
            Longitude and latitude of each [deg].
        width : float
            Of the drawing in pixels.
        heights : tuple of float
            Its least and greatest height.
        margin : float
            Kept free around the points.

        Returns
        -------
        MapView
            In which all of them lie.
        """
        view = cls.__new__(cls)
        latitude = float(np.mean([lat for _, lat in lonlat]))
        view._fit([mercator(*at) for at in lonlat], latitude, width, heights, margin)
        return view

    def _fit(
        self,
        points: Sequence[Point],
        latitude: float,
        width: float,
        heights: tuple[float, float],
        margin: float,
    ) -> None:
        self.width = width
        xs, ys = np.array(points).T
        # A plan of one place still gets a drawing some 10 km wide.
        span_x, span_y = max(float(np.ptp(xs)), 0.1), max(float(np.ptp(ys)), 0.05)
        room = width - 2 * margin
        self.per_degree = min(room / span_x, (heights[1] - 2 * margin) / span_y)
        tall = span_y * self.per_degree + 2 * margin
        self.height = float(round(min(max(tall, heights[0]), heights[1])))
        self._x = width / 2 - self.per_degree * float(xs.min() + xs.max()) / 2
        self._y = self.height / 2 - self.per_degree * float(ys.min() + ys.max()) / 2
        self.latitude = latitude
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

    def on_map(self, plane: Floats) -> Floats:
        """Return the pixels of points whose Web Mercator coordinates are known.

        Parameters
        ----------
        plane : ndarray of float, (P, 2)
            As `mercator` returns them.

        Returns
        -------
        ndarray of float, (P, 2)
            As `at` returns them.
        """
        pixels: Floats = plane * self.per_degree + np.array([self._x, self._y])
        return pixels

    def pixels(self, line: Line) -> list[Point]:
        """Return a line in pixels.

        Parameters
        ----------
        line : Line
            Of the document.

        Returns
        -------
        list of tuple of float
            Each of its points.
        """
        return [self.at(lon, lat) for lon, lat in line.degrees()]

    def places(self, document: Document) -> Places:
        """Return where the points of a document lie.

        Parameters
        ----------
        document : Document
            Whose events, ends and towns they are.

        Returns
        -------
        Places
            Their pixels.
        """
        vehicles = document.vehicles
        return Places(
            events=[self.at(event.lon, event.lat) for event in document.events],
            origins=[self.at(one.origin.lon, one.origin.lat) for one in vehicles],
            destinations=[self.at(one.destination.lon, one.destination.lat) for one in vehicles],
            towns=self.towns(document),
        )

    def towns(self, around: Document | Surroundings) -> list[Point]:
        """Return where towns lie.

        Parameters
        ----------
        around : Document or Surroundings
            Whose towns they are.

        Returns
        -------
        list of tuple of float
            Their pixels.
        """
        return [
            self.at(lon / BASEMAP_STEPS, lat / BASEMAP_STEPS) for lon, lat, _, _ in around.towns
        ]


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
