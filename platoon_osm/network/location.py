"""A place on the network, as `locate` finds it."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

__all__ = ["Location", "Role"]

Role = Literal["origin", "destination", "any"]


@dataclass(frozen=True, slots=True)
class Location:
    """A place on the network.

    Attributes
    ----------
    node : the nearest node that fits the role.
    name : the name it is known by.
    lon, lat : the place asked for [deg].
    distance_m : from the place to the nearest road.
    candidates : nodes a trip may start or end at with their distance [m], nearest first: both
        carriageways and all ramps near the place. A trip takes the pair that suits its direction.
    """

    node: int
    name: str
    lon: float
    lat: float
    distance_m: float
    candidates: tuple[tuple[int, float], ...]
