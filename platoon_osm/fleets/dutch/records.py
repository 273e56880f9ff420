"""What the published instances say: cities, links, trucks, and the savings that were reported."""

from __future__ import annotations

from dataclasses import dataclass

__all__ = ["SETS", "DutchData", "DutchInstance", "DutchTruck", "Published"]

SETS = ("UNIFORM", "ONEORIG", "ONEDEST")
"""Origins and destinations at random, one origin for all, one destination for all."""


@dataclass(frozen=True, slots=True)
class DutchTruck:
    """A truck of an instance.

    Attributes
    ----------
    origin, destination : int
        Numbers of cities.
    departure_min : float
        Earliest departure [min].
    """

    origin: int
    destination: int
    departure_min: float


@dataclass(frozen=True, slots=True)
class DutchInstance:
    """A group of trucks.

    Attributes
    ----------
    name : str
        The set it is of.
    number : int
        Which one of those with as many trucks.
    trucks : tuple of DutchTruck
        Who drives.
    """

    name: str
    number: int
    trucks: tuple[DutchTruck, ...]


@dataclass(frozen=True, slots=True)
class Published:
    """What was reported of a set, a number of trucks, a flexibility and a kind of platoons.

    Attributes
    ----------
    saving_pct : float
        Fuel saved against all alone on shortest paths, the mean over the instances [%].
    platoon_km_pct : float
        Kilometres in platoons, of all [%].
    in_platoons_pct : float
        Trucks that drive in any platoon [%].
    """

    saving_pct: float
    platoon_km_pct: float
    in_platoons_pct: float


@dataclass(frozen=True, slots=True)
class DutchData:
    """All that is read.

    Attributes
    ----------
    links : tuple of (int, int, float)
        Two cities and the kilometres between them, in both directions.
    instances : tuple of DutchInstance
        By set, trucks and number.
    published : mapping of tuple to Published
        By set, trucks, flexibility [min], largest platoon, and platoons a trip (0 for any number).
    """

    links: tuple[tuple[int, int, float], ...]
    instances: tuple[DutchInstance, ...]
    published: dict[tuple[str, int, int, int, int], Published]
