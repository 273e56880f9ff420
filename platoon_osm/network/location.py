"""A place on the network, as `locate` finds it."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

__all__ = ["Location", "Role", "format_position"]

Role = Literal["origin", "destination", "any"]


@dataclass(frozen=True, slots=True)
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
    """

    node: int
    name: str
    lon: float
    lat: float
    distance_m: float
    candidates: tuple[tuple[int, float], ...]


def format_position(lon: float, lat: float) -> str:
    """Return coordinates as people write them: 45.070 N 7.690 E.

    Parameters
    ----------
    lon, lat : float
        Degrees, east and north positive.

    Returns
    -------
    str
        Latitude first, three decimals, about 100 m.
    """
    north, east = "N" if lat >= 0 else "S", "E" if lon >= 0 else "W"
    return f"{abs(lat):.3f} {north} {abs(lon):.3f} {east}"
