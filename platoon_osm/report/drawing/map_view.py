"""The part of the world on a still drawing: pixels, lines moved aside, widths of bands."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from itertools import pairwise
from typing import Any

import numpy as np

from .basemap import ROUTE_STEPS
from .polyline import decode_polyline

__all__ = [
    "MapView", "Point", "band_aside", "band_lines", "band_width", "bands_width", "laid",
    "path_data", "shifted", "solo_aside", "solo_step",
]  # fmt: skip

WIDTH = 960.0
LEAST_HEIGHT, MOST_HEIGHT = 690.0, 980.0
MARGIN = 60.0
MOST_NETWORK_DATA = 80_000
"""Characters of path data that the still map spends on the background."""

SHORT = 12.0
"""Pixels of road that are too short for a place of their own."""

SOLO_CASING = 7.0
"""Width of a solo line with its white casing."""

Point = tuple[float, float]


def mercator(lon: float, lat: float) -> Point:
    """Return Web Mercator coordinates of a point, in degrees at the equator; y grows south."""
    lat = max(-85.0, min(85.0, lat))
    return lon, -math.degrees(math.asinh(math.tan(math.radians(lat))))


class MapView:
    """The part of the world drawn, and its pixels."""

    def __init__(
        self,
        document: dict[str, Any],
        width: float = WIDTH,
        heights: tuple[float, float] = (LEAST_HEIGHT, MOST_HEIGHT),
        margin: float = MARGIN,
    ) -> None:
        self.width = width
        points = [mercator(*at) for line in _plan_lines(document) for at in line]
        for vehicle in document["vehicles"]:
            points += [
                mercator(stop["lon"], stop["lat"])
                for stop in (vehicle["origin"], vehicle["destination"])
            ]
        xs, ys = np.array(points).T
        # A plan of one place still gets a drawing some 10 km wide.
        span_x, span_y = max(float(np.ptp(xs)), 0.1), max(float(np.ptp(ys)), 0.05)
        room = width - 2 * margin
        self.per_degree = min(room / span_x, (heights[1] - 2 * margin) / span_y)
        tall = span_y * self.per_degree + 2 * margin
        self.height = float(round(min(max(tall, heights[0]), heights[1])))
        self._x = width / 2 - self.per_degree * float(xs.min() + xs.max()) / 2
        self._y = self.height / 2 - self.per_degree * float(ys.min() + ys.max()) / 2
        self.latitude = float(np.mean([stop[1] for stop in _stops(document)]))
        degree_m = 111_320 * math.cos(math.radians(self.latitude))
        self.metres_per_pixel = degree_m / max(self.per_degree, 1e-9)

    def at(self, lon: float, lat: float) -> Point:
        """Return the pixel of a point."""
        x, y = mercator(lon, lat)
        return x * self.per_degree + self._x, y * self.per_degree + self._y

    def pixels(self, line: Sequence[Point]) -> list[Point]:
        """Return a line of lon and lat in pixels, without points that make no difference."""
        return _simplified([self.at(lon, lat) for lon, lat in line], 0.6)

    def route(self, line: str) -> list[Point]:
        """Return an encoded route in pixels."""
        return self.pixels(decode_polyline(line, ROUTE_STEPS))

    def path(self, lines: Sequence[Sequence[Point]]) -> str:
        """Return SVG path data of those lines that come near the drawing."""
        kept = (self.pixels(line) for line in lines)
        return "".join(path_data(points) for points in kept if self._near(points))

    def network_path(self, lines: Sequence[Sequence[Point]], most: int = MOST_NETWORK_DATA) -> str:
        """Return SVG path data of the background: to half a pixel, twin carriageways once."""
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


def path_data(points: Sequence[Point]) -> str:
    """Return SVG path data of a line, to a tenth of a pixel, each step from the point before."""
    tenths = [(round(x * 10), round(y * 10)) for x, y in points]
    (x0, y0), *rest = tenths
    out = [f"M{x0 / 10:g} {y0 / 10:g}l"]
    for x, y in rest:
        out.append(f"{(x - x0) / 10:g} {(y - y0) / 10:g} ")
        x0, y0 = x, y
    return "".join(out).rstrip()


def _plan_lines(document: dict[str, Any]) -> Iterator[list[Point]]:
    for section in document["platoons"]:
        for part in section["parts"]:
            yield decode_polyline(part["line"], ROUTE_STEPS)
    for solo in document["solos"]:
        for part in solo["parts"]:
            yield decode_polyline(part["line"], ROUTE_STEPS)


def _stops(document: dict[str, Any]) -> list[Point]:
    return [
        (vehicle[end]["lon"], vehicle[end]["lat"])
        for vehicle in document["vehicles"]
        for end in ("origin", "destination")
    ]


def _simplified(points: list[Point], tolerance: float) -> list[Point]:
    import shapely

    if len(points) < 3 or not tolerance:
        return points
    simple = shapely.simplify(shapely.linestrings(points), tolerance)
    return [(float(x), float(y)) for x, y in shapely.get_coordinates(simple)]


def shifted(points: Sequence[Point], aside: float) -> list[Point]:
    """Return a line moved to its right by some pixels, corners mitred within limits."""
    if not aside or len(points) < 2:
        return list(points)
    flat = np.asarray(points)
    step = np.diff(flat, axis=0)
    step = step[np.hypot(*step.T) > 0]
    if not len(step):
        return list(points)
    keep = np.concatenate([[True], np.hypot(*np.diff(flat, axis=0).T) > 0])
    flat = flat[keep]
    normal = np.column_stack([-step[:, 1], step[:, 0]]) / np.hypot(*step.T)[:, None]
    before, after = np.vstack([normal[:1], normal]), np.vstack([normal, normal[-1:]])
    mitre = before + after
    # |mitre| = 2 cos(half the turn); beyond 120 degrees a mitre would run away.
    length = np.maximum((mitre**2).sum(axis=1), 1.0)
    moved = flat + aside * 2 * mitre / length[:, None]
    return [(float(x), float(y)) for x, y in moved]


def laid(roads: Sequence[tuple[Sequence[Point], float]]) -> list[Point]:
    """Return one line along roads in pixels, each moved to its right by its own measure.

    Roads too short to be seen follow their neighbour, or the line would start aside and back
    within a few pixels.
    """
    runs: list[tuple[list[Point], float, float]] = []
    for points, aside in roads:
        length = sum(math.dist(a, b) for a, b in pairwise(points))
        if runs:
            before, old, known = runs[-1]
            if aside == old or length < SHORT or known < SHORT:
                wider = aside if length > known else old
                runs[-1] = [*before, *points], wider, known + length
                continue
        runs.append((list(points), aside, length))
    # Loops of a ramp, tighter than the line is aside, would become stars.
    return [
        point
        for points, aside, _ in runs
        for point in shifted(_simplified(points, abs(aside) / 5), aside)
    ]


def band_lines(vehicles: int) -> tuple[float, float]:
    """Return the distance between lines in a platoon band and their width, in pixels."""
    step = min(6.0, 36.0 / vehicles)
    return step, min(4.0, step * 0.68)


def band_width(vehicles: int) -> float:
    """Return the width of a platoon band in pixels."""
    return 6 + band_lines(vehicles)[0] * vehicles


def bands_width(beside: Sequence[int]) -> float:
    """Return the width of several bands side by side, casings included."""
    return sum(band_width(count) + 2 for count in beside)


def band_aside(part: dict[str, Any], view: MapView) -> float:
    """Return how far right of the road a band's middle lies, so that all bands on it show."""
    before = bands_width(part["beside"][: part["place"]])
    own = bands_width(part["beside"][part["place"] :][:1])
    whole = bands_width(part["beside"])
    return before + own / 2 - whole / 2 + _apart(part, whole, view)


def _apart(part: dict[str, Any], width: float, view: MapView) -> float:
    """Return how far right of its road a strip of lines goes, to let the other way pass it."""
    if part["opposite_m"] is None:
        return 0.0
    return float(max(0.0, width / 2 + 0.5 - part["opposite_m"] / view.metres_per_pixel / 2))


def solo_step(slots: int) -> float:
    """Return the distance between vehicles alone on one road, in pixels."""
    return min(7.0, 26.0 / max(slots - 1, 1))


def solo_aside(part: dict[str, Any], view: MapView) -> float:
    """Return how far right of the road a vehicle alone is drawn, clear of any bands on it."""
    step = solo_step(part["slots"])
    if part["bands"]:
        width = bands_width(part["bands"])
        return float(width / 2 + 4 + step * part["slot"] + _apart(part, width, view))
    across = step * (part["slots"] - 1)
    return float(step * part["slot"] - across / 2 + _apart(part, across + SOLO_CASING, view))
