"""A stop beside the road as people ask for it: what is there, and where the road is left for it."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

__all__ = ["RoadStop", "StopAccess"]


@dataclass(frozen=True, slots=True)
class StopAccess:
    """Where a truck leaves the road for a stop.

    Attributes
    ----------
    edge : int
        The edge that it drives before.
    share : float
        How much of that edge, by length, it has driven then.
    beside_m : float
        How far the stop is from there [m]: along a ramp as far as there is one, then straight.
    side : {"right", "left"}
        On which side of its direction the stop lies.
    by_link : bool
        Whether a ramp leads to it.
    """

    edge: int
    share: float
    beside_m: float
    side: Literal["right", "left"]
    by_link: bool = False


@dataclass(frozen=True, slots=True)
class RoadStop:
    """A place beside the road where trucks stop, or a tunnel on it.

    Attributes
    ----------
    name : str
        Empty if the map has none.
    kind : str
        Of `STOP_KINDS`, the one that says most; or "tunnel".
    lon, lat : float
        Degrees.
    offers : tuple of str
        Of "parking", "fuel" and "charging".
    capacity : int or None
        Spaces for trucks; None where not known.
    fuels : tuple of str
        What the map says is sold, as "diesel" or "lng".
    power_kw : float or None
        Of the strongest charger [kW]; None where not known.
    fee : bool or None
        Whether parking costs money; None where not known.
    max_stay_s : float or None
        How long a truck may stay [s]; None where nothing limits it.
    accesses : tuple of StopAccess
        Where the road is left for it; none where no road is within 1 km.
    tags : str
        What the map says of its parts, in the form of `network.restrictions`.
    """

    name: str
    kind: str
    lon: float
    lat: float
    offers: tuple[str, ...]
    capacity: int | None
    fuels: tuple[str, ...]
    power_kw: float | None
    fee: bool | None
    max_stay_s: float | None
    accesses: tuple[StopAccess, ...]
    tags: str

    @property
    def access_edge(self) -> int | None:
        """The edge before which the road is left first of all; None without access."""
        return self.accesses[0].edge if self.accesses else None

    @property
    def share(self) -> float | None:
        """How much of that edge lies before it; None without access."""
        return self.accesses[0].share if self.accesses else None

    @property
    def beside_m(self) -> float | None:
        """How far from the road it is [m]; None without access."""
        return self.accesses[0].beside_m if self.accesses else None

    @property
    def side(self) -> str | None:
        """On which side of the direction of travel it lies; None without access."""
        return self.accesses[0].side if self.accesses else None
