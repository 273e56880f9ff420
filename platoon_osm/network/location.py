"""A place as people give it, and as `locate` finds it on the network."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import KW_ONLY, dataclass
from typing import Any, Literal

import numpy as np

from ..errors import NetworkError, brief
from .antimeridian import wrapped_deg

__all__ = ["Location", "Place", "PlaceLike", "RoadPoint", "Role", "format_position", "plain_place"]

Role = Literal["origin", "destination", "any"]


@dataclass(frozen=True, slots=True)
class RoadPoint:
    """A point on an edge.

    Attributes
    ----------
    edge : int
        Edge id.
    share : float
        How much of the edge, by length, lies before it; between 0 and 1.
    distance_m : float
        From the place to it [m].
    """

    edge: int
    share: float
    distance_m: float


@dataclass(frozen=True, slots=True, repr=False)
class Location:
    """A place on the network.

    Attributes
    ----------
    node : int
        The nearest node that fits the role.
    name : str
        The name it is known by.
    lon, lat : float
        The place asked for [deg].
    distance_m : float
        From the place to the nearest road [m].
    candidates : tuple of (int, float)
        Nodes a trip may start or end at with their distance [m], nearest first: both
        carriageways and all ramps near the place. A trip takes the pair that suits its direction.
    note : str
        What the text was taken for, where that is more than its own words say; else empty.
    on_road : tuple of RoadPoint
        Points of the road that the place lies on, one for each carriageway, nearest first; trips
        start and end there. Empty for a name or a node, and for a place beside the road.
    enters : tuple of RoadPoint
        Of a place beside the road: points between junctions where one gets onto the road.
    beside_road : bool
        Whether the place lies beside the road, so that the way to it counts: to one of the
        `candidates`, or to a point where it `enters`.
    from_geonames : bool
        Whether the place, or a town in its name, is from GeoNames, who are to be credited.
    """

    node: int
    name: str
    lon: float
    lat: float
    distance_m: float
    candidates: tuple[tuple[int, float], ...]
    note: str = ""
    on_road: tuple[RoadPoint, ...] = ()
    enters: tuple[RoadPoint, ...] = ()
    beside_road: bool = False
    from_geonames: bool = False

    def __repr__(self) -> str:
        beside = ", beside the road" if self.beside_road else ""
        near = f"{len(self.candidates)} nodes near" if self.candidates else "no node near"
        return (
            f"<Location {self.name[:60]!r} at {format_position(self.lon, self.lat)}: node "
            f"{self.node}, {near}{beside}>"
        )


@dataclass(frozen=True, slots=True)
class Place:
    """A place that is given by more than one value: an OpenStreetMap id, or a label of one's own.

    Attributes
    ----------
    at : str or tuple of float or int or Location, optional
        A name, (lon, lat) in degrees, a node position, or what `net.locate` found.
    osmid : int, optional
        Id of an OpenStreetMap node, instead of `at`.
    label : str, optional
        What the place is called in the plan and in everything made from it; by default the name
        that is found for it.

    Raises
    ------
    NetworkError
        Not exactly one of `at` and `osmid`, or a value of another kind.
    """

    at: str | tuple[float, float] | int | Location | None = None
    _: KW_ONLY
    osmid: int | None = None
    label: str | None = None

    def __post_init__(self) -> None:
        at: Any = self.at
        osmid, label = self.osmid, self.label
        if (at is None) == (osmid is None):
            given = "both" if at is not None else "neither"
            raise NetworkError(
                f"place: {given} of at and osmid given; give a name, (lon, lat) or node as at, or "
                "an OpenStreetMap id as osmid"
            )
        if at is not None:
            at = plain_place(at)
            if isinstance(at, Place):
                raise NetworkError("place: at is itself a Place; give what that one was made of")
        if osmid is not None:
            osmid = _whole(osmid)
            if osmid is None:
                raise NetworkError(
                    "place: osmid must be a whole number, the id of an OpenStreetMap node"
                )
        if label is not None and not (isinstance(label, str) and label.strip()):
            raise NetworkError(f"place: label {brief(label)} must be a non-empty text")
        object.__setattr__(self, "at", at)
        object.__setattr__(self, "osmid", osmid)


PlaceLike = str | tuple[float, float] | int | Location | Place
"""A name, (lon, lat) in degrees, a node, what `net.locate` found, or a `Place`."""


def plain_place(value: Any) -> PlaceLike:
    """Return a place as plain Python types, not yet looked for on a network.

    Parameters
    ----------
    value : object
        What somebody gave.

    Returns
    -------
    PlaceLike
        The same place.

    Raises
    ------
    NetworkError
        It is none.
    """
    if isinstance(value, Location | Place) or (isinstance(value, str) and value.strip()):
        return value
    if (node := _whole(value)) is not None:
        return node
    pair = isinstance(value, Sequence | np.ndarray) and not isinstance(value, str | bytes)
    if pair and len(value) == 2 and all(_is_number(part) for part in value):
        return float(value[0]), float(value[1])
    raise NetworkError(
        f"{brief(value)} must be a name, a (lon, lat) pair in degrees, a node, a Place, or come "
        "from net.locate"
    )


def _whole(value: Any) -> int | None:
    whole = isinstance(value, int | np.integer) and not isinstance(value, bool)
    return int(value) if whole else None


def _is_number(value: Any) -> bool:
    return isinstance(value, int | float | np.integer | np.floating) and not isinstance(value, bool)


def format_position(lon: float, lat: float) -> str:
    """Return coordinates as people write them: 45.070 N 7.690 E.

    Parameters
    ----------
    lon, lat : float
        Degrees, east and north positive; longitudes beyond 180 are counted on.

    Returns
    -------
    str
        Latitude first, three decimals, about 100 m.
    """
    lon = float(wrapped_deg(lon))
    north, east = "N" if lat >= 0 else "S", "E" if lon >= 0 else "W"
    return f"{abs(lat):.3f} {north} {abs(lon):.3f} {east}"
