"""The country, or in the United States the state, of points: by a small table of outlines.

The table is made by `maps/build_countries.py` from Natural Earth and the US Census Bureau, both in
the public domain; borders are a kilometre off at most. A point off every coast, as on a bridge or a
ferry, is that of the nearest country within 20 km.
"""

from __future__ import annotations

import functools
import math
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ...network.geodesy import metres_per_degree

__all__ = ["FILE", "Outlines", "country_of"]

FILE = Path(__file__).with_name("outlines.npz")
UNIT_DEG = 0.005
"""Coordinates are kept as whole numbers of this, half a kilometre."""

ROW = 1_000_000
"""More than there are such squares between the poles."""

NEAR_M = 20_000.0


class Outlines:
    """Polygons of countries.

    Parameters
    ----------
    codes : sequence of str, (p,)
        ISO 3166 code of each polygon, "IT" or "US-CA".
    polygons : ndarray of shapely geometries, (p,)
        In degrees.
    """

    def __init__(self, codes: list[str], polygons: NDArray[Any]) -> None:
        import shapely

        self.codes = codes
        shapely.prepare(polygons)
        self._polygons = polygons
        self._tree = shapely.STRtree(polygons)

    @classmethod
    def read(cls, file: Path = FILE) -> Outlines:
        """Read the table that comes with the package.

        Parameters
        ----------
        file : Path
            As `maps/build_countries.py` writes it.

        Returns
        -------
        Outlines
            All countries.
        """
        import shapely

        with np.load(file) as table:
            steps, first, ring_of = table["steps"], table["first"], table["polygon"]
            codes = [str(code) for code in table["codes"]]
        rings = [
            shapely.linearrings(np.cumsum(part.astype(np.int64), axis=0) * UNIT_DEG)
            for part in np.split(steps, first[1:-1])
        ]
        polygons = np.array(
            [
                shapely.Polygon(rings[own[0]], [rings[k] for k in own[1:]])
                for number in range(len(codes))
                for own in [np.flatnonzero(ring_of == number).tolist()]
            ],
            object,
        )
        return cls(codes, polygons)

    def at(self, lon: ArrayLike, lat: ArrayLike) -> NDArray[Any]:
        """Return the country of each point.

        Parameters
        ----------
        lon, lat : array_like of float, (k,)
            Degrees; NaN where a place is not known.

        Returns
        -------
        ndarray of str, (k,)
            Codes; empty on the high seas and where a coordinate is missing.
        """
        import shapely

        x, y = np.atleast_1d(np.asarray(lon, float)), np.atleast_1d(np.asarray(lat, float))
        names: NDArray[Any] = np.array([*self.codes, ""], object)
        known = np.isfinite(x) & np.isfinite(y)
        result = np.full(len(x), "", object)
        if not known.any():
            return result
        # Borders are no more exact than this, and many roads begin in one such square.
        squares = np.rint(np.column_stack([x[known], y[known]]) / UNIT_DEG).astype(np.int64)
        # One number for each is told apart much faster than a pair.
        _, first, back = np.unique(squares @ (ROW, 1), return_index=True, return_inverse=True)
        distinct = squares[first]
        found = np.full(len(distinct), -1)
        row, polygon = self._tree.query(shapely.points(distinct * UNIT_DEG), predicate="intersects")
        found[row] = polygon
        # At sea: few points, each looked at by itself.
        for k in np.flatnonzero(found < 0).tolist():
            found[k] = self._near(*(distinct[k] * UNIT_DEG).tolist())
        result[known] = names[found][back.ravel()]
        return result

    def _near(self, lon: float, lat: float) -> int:
        import shapely

        per_lon, per_lat = (float(value) for value in metres_per_degree(lat))
        reach = NEAR_M / min(per_lon, per_lat)
        best, least = -1, NEAR_M
        # Outlines end at the antimeridian: land on its other side is looked for from there.
        for x in (lon, lon - math.copysign(360.0, lon)):
            area = shapely.box(x - reach, lat - reach, x + reach, lat + reach)
            for k in self._tree.query(area).tolist():
                near = shapely.get_coordinates(
                    shapely.shortest_line(shapely.points(x, lat), self._polygons[k])
                )
                metres = float(np.hypot(*((near[1] - near[0]) * (per_lon, per_lat))))
                if metres < least:
                    best, least = k, metres
        return best


@functools.cache
def _known() -> Outlines:
    return Outlines.read()


def country_of(lon: ArrayLike, lat: ArrayLike) -> NDArray[Any]:
    """Return the country of each point; see `Outlines.at`.

    Parameters
    ----------
    lon, lat : array_like of float, (k,)
        Degrees.

    Returns
    -------
    ndarray of str, (k,)
        "IT", "US-CA"; empty where there is none.
    """
    return _known().at(lon, lat)
