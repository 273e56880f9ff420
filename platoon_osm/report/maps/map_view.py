"""The part of the world on a still drawing: pixels, lines moved aside, widths of bands."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Sequence
from itertools import pairwise

import numpy as np

from ..document.model import Document
from ..document.model_map import BandPart, LanePart
from ..drawing.lines import Line, Point

__all__ = [
    "MapView",
    "band_aside",
    "band_lines",
    "band_width",
    "bands_width",
    "laid",
    "path_data",
    "shifted",
    "solo_aside",
    "solo_step",
]

WIDTH = 960.0
LEAST_HEIGHT, MOST_HEIGHT = 690.0, 980.0
MARGIN = 60.0
MOST_NETWORK_DATA = 80_000
"""Characters of path data that the still map spends on the background."""

SHORT = 12.0
"""Pixels of road that are too short for a place of their own."""

SOLO_CASING = 7.0
"""Width of a solo line with its white casing."""


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
        return _simplified([self.at(lon, lat) for lon, lat in line.degrees()], 0.6)

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


def path_data(points: Sequence[Point]) -> str:
    """Return a line to a tenth of a pixel, each step from the point before.

    Parameters
    ----------
    points : sequence of tuple of float
        Pixels.

    Returns
    -------
    str
        SVG path data.
    """
    tenths = [(round(x * 10), round(y * 10)) for x, y in points]
    (x0, y0), *rest = tenths
    out = [f"M{x0 / 10:g} {y0 / 10:g}l"]
    for x, y in rest:
        out.append(f"{(x - x0) / 10:g} {(y - y0) / 10:g} ")
        x0, y0 = x, y
    return "".join(out).rstrip()


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


def _simplified(points: list[Point], tolerance: float) -> list[Point]:
    import shapely

    if len(points) < 3 or not tolerance:
        return points
    simple = shapely.simplify(shapely.linestrings(points), tolerance)
    return [(float(x), float(y)) for x, y in shapely.get_coordinates(simple)]


def shifted(points: Sequence[Point], aside: float) -> list[Point]:
    """Return a line moved to its right, corners mitred within limits.

    Parameters
    ----------
    points : sequence of tuple of float
        Pixels.
    aside : float
        How far, in pixels.

    Returns
    -------
    list of tuple of float
        The line moved.
    """
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
    """Return one line along roads, each moved to its right by its own measure.

    Roads too short to be seen follow their neighbour, or the line would start aside and back
    within a few pixels.

    Parameters
    ----------
    roads : sequence of tuple
        For each road its points in pixels, and how far aside the line lies.

    Returns
    -------
    list of tuple of float
        The line in pixels.
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
    return before + own / 2 - whole / 2 + _apart(part, whole, view)


def _apart(part: BandPart | LanePart, width: float, view: MapView) -> float:
    """Return how far right of its road a strip of lines goes, to let the other way pass it."""
    if part.opposite_m is None:
        return 0.0
    return float(max(0.0, width / 2 + 0.5 - part.opposite_m / view.metres_per_pixel / 2))


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
        return float(width / 2 + 4 + step * part.slot + _apart(part, width, view))
    across = step * (part.slots - 1)
    return float(step * part.slot - across / 2 + _apart(part, across + SOLO_CASING, view))
