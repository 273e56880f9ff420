"""One stop with several offers rather than a dot for each parking, pump and charger of it.

What lies inside a service or rest area belongs to it, and so does what is near to one that the map
has as a point, on the same side of the road. What is left belongs together in the same way: a
truck stop is a parking with its pumps and chargers. The order in which a file lists them makes no
difference.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from ...network.columns import STOP_KINDS
from ...network.geodesy import distance_m, metres_per_degree
from ...network.restrictions import encode
from .features import StopReading

__all__ = ["NEAR_M", "Stop", "StopPlace", "merged_stops"]

Floats = NDArray[np.float64]
Apart = Callable[[Floats], NDArray[np.bool_]]
"""Of lines (k, 4) lon, lat, lon, lat: which of them cross a road that has two sides."""

NEAR_M = 300.0
"""Things nearer to each other than this, on one side of the road, are one stop."""


@dataclass(frozen=True, slots=True, eq=False)
class StopPlace:
    """One thing of the map that is a stop or part of one.

    Attributes
    ----------
    reading : StopReading
        What its tags mean.
    lon, lat : float
        A place in it [deg].
    ring : ndarray of float, (k, 2)
        Its outline where it is an area, else empty.
    number : tuple of (str, int)
        Which object of the map it is.
    """

    reading: StopReading
    lon: float
    lat: float
    number: tuple[str, int]
    ring: Floats = field(default_factory=lambda: np.zeros((0, 2)))


@dataclass(frozen=True, slots=True)
class Stop:
    """A stop with all that it offers.

    Attributes
    ----------
    kind : str
        Of `STOP_KINDS`.
    lon, lat : float
        Degrees.
    name : str
        Its name, or else that of a part.
    capacity : int
        Spaces for trucks, -1 where not known.
    tags : str
        What the map says of its parts, in the form of `network.restrictions`.
    """

    kind: str
    lon: float
    lat: float
    name: str
    capacity: int
    tags: str


def merged_stops(places: Sequence[StopPlace], apart: Apart) -> list[Stop]:
    """Return stops, each with the parts that belong to it.

    Parameters
    ----------
    places : sequence of StopPlace
        In any order.
    apart : callable
        Tells of lines (k, 4) which of them cross a road.

    Returns
    -------
    list of Stop
        The most telling kinds first, then by their number in the map.
    """
    ranked = sorted(
        {place.number: place for place in places}.values(),
        key=lambda place: (STOP_KINDS.index(place.reading.kind), place.number),
    )
    host = _hosts(ranked, apart)
    parts: dict[int, list[StopPlace]] = {}
    for place, at in zip(ranked, host, strict=True):
        if at >= 0:
            parts.setdefault(at, []).append(place)
    return [_stop(ranked[at], parts[at]) for at in sorted(parts)]


def _hosts(ranked: Sequence[StopPlace], apart: Apart) -> list[int]:
    """Return for each place the one it belongs to, itself, or -1 for no stop at all."""
    if not ranked:
        return []
    host = list(range(len(ranked)))
    areas = sorted((_size(place.ring), -k) for k, place in enumerate(ranked) if _has_outline(place))
    for k, place in enumerate(ranked):
        # Of an area drawn twice the larger stays, so none ends up within itself.
        own = (_size(place.ring), -k) if _has_outline(place) else (-1.0, 0)
        host[k] = next(
            (
                -a
                for size, a in areas
                if (size, a) > own and _inside(ranked[-a].ring, place.lon, place.lat)
            ),
            k,
        )
    pairs = _near_pairs(ranked)
    if len(pairs):
        ends = np.array([[place.lon, place.lat] for place in ranked])
        pairs = pairs[~apart(np.hstack([ends[pairs[:, 0]], ends[pairs[:, 1]]]))]
    for a, k in pairs.tolist():
        if host[k] == k and host[a] == a and not _is_area(ranked[k]) and _takes(ranked[a]):
            host[k] = a
    for k, place in enumerate(ranked):
        while host[k] != host[host[k]]:
            host[k] = host[host[k]]
        if host[k] == k and not place.reading.trucks:
            host[k] = -1
    return host


def _is_area(place: StopPlace) -> bool:
    return place.reading.kind in ("services", "rest_area")


def _has_outline(place: StopPlace) -> bool:
    return _is_area(place) and len(place.ring) > 2


def _takes(place: StopPlace) -> bool:
    """Tell whether what is near belongs to it: an area with an outline says itself what is in."""
    return place.reading.trucks and not _has_outline(place)


def _near_pairs(ranked: Sequence[StopPlace]) -> NDArray[np.int64]:
    """Return pairs (a, k) of near places, a before k; the first kinds, then the nearest first."""
    lat = np.array([place.lat for place in ranked])
    lon = np.array([place.lon for place in ranked])
    order = np.argsort(lat, kind="stable")
    reach = NEAR_M / float(metres_per_degree(0.0)[1])
    last = np.searchsorted(lat[order], lat[order] + reach, "right")
    found: list[tuple[int, float, int, int]] = []
    for i, end in enumerate(last.tolist()):
        one, others = order[i], order[i + 1 : end]
        away = distance_m(lon[one], lat[one], lon[others], lat[others])
        for other, metres in zip(others.tolist(), away.tolist(), strict=True):
            if metres <= NEAR_M:
                a, k = sorted((int(one), other))
                rank = STOP_KINDS.index(ranked[a].reading.kind)
                found.append((rank, metres, a, k))
    return np.array([(a, k) for *_, a, k in sorted(found)], np.int64).reshape(-1, 2)


def _stop(own: StopPlace, parts: list[StopPlace]) -> Stop:
    reading = own.reading
    capacity = reading.capacity
    if capacity < 0:
        known = [
            part.reading.capacity
            for part in parts
            if part.reading.kind in ("parking", "services", "rest_area")
            and part.reading.capacity >= 0
        ]
        capacity = sum(known) if known else -1
    elif reading.kind == "parking":
        capacity = sum(
            max(part.reading.capacity, 0) for part in parts if part.reading.kind == "parking"
        )
    if reading.kind in ("fuel", "charging"):
        capacity = -1  # what fuel stations count are pumps
    name = next((part.reading.name for part in [own, *parts] if part.reading.name), "")
    tags = encode(part.reading.tags for part in parts)
    return Stop(reading.kind, own.lon, own.lat, name, capacity, tags)


def _size(ring: Floats) -> float:
    """Return twice the area of an outline [square degrees]; only ever compared."""
    x, y = (ring - ring[0]).T
    return abs(float(np.sum(x * np.roll(y, -1) - y * np.roll(x, -1))))


def _inside(ring: Floats, lon: float, lat: float) -> bool:
    """Tell whether a place is within an outline, by the crossings of a line to the east."""
    lon += 360.0 * round((float(ring[0, 0]) - lon) / 360.0)  # an outline may go on beyond 180
    x, y = ring[:, 0], ring[:, 1]
    x2, y2 = np.roll(x, -1), np.roll(y, -1)
    spans = (y > lat) != (y2 > lat)
    if not spans.any():
        return False
    at = x[spans] + (lat - y[spans]) / (y2[spans] - y[spans]) * (x2[spans] - x[spans])
    return bool((at > lon).sum() % 2)
