"""The map of a document: lines of the routes, events, names, and the background."""

from __future__ import annotations

from dataclasses import dataclass
from typing import NamedTuple

from ..drawing.lines import Line, Lines

__all__ = [
    "BandPart",
    "Basemap",
    "EventMark",
    "JunctionLabel",
    "LanePart",
    "PlatoonLine",
    "SharedCost",
    "SoloLine",
    "StopLabel",
    "Tip",
    "TownLabel",
    "Traffic",
    "TrafficRoads",
]


@dataclass(frozen=True, slots=True)
class Tip:
    """What a line tells when it is pointed at.

    Attributes
    ----------
    head : str
        Its heading.
    lines : tuple of str
        One or two below it.
    columns : tuple of str
        Heads of a table; empty if there is none.
    rows : tuple of tuple of str
        Of the table.
    more : str
        How many rows were left out; empty if none.
    """

    head: str
    lines: tuple[str, ...]
    columns: tuple[str, ...] = ()
    rows: tuple[tuple[str, ...], ...] = ()
    more: str = ""


@dataclass(frozen=True, slots=True)
class SharedCost:
    """What a stretch in company costs one vehicle, in the plan's unit.

    Attributes
    ----------
    vehicle : int
        Its position in the document.
    cost_alone, cost_platoon : float or None
        Alone and in platoon; None where the plan does not tell.
    fuel_l : float
        Of this vehicle.
    """

    vehicle: int
    cost_alone: float | None
    cost_platoon: float | None
    fuel_l: float


@dataclass(frozen=True, slots=True)
class BandPart:
    """A part of a platoon's line along which the same bands lie on the road.

    Attributes
    ----------
    line : Line
        Where it runs.
    beside : tuple of int
        Vehicles of each band on the road, from the left.
    place : int
        Which of them is this one.
    opposite_m : int or None
        How far away others drive the other way; None if none do.
    """

    line: Line
    beside: tuple[int, ...]
    place: int
    opposite_m: int | None


@dataclass(frozen=True, slots=True)
class PlatoonLine:
    """A stretch of one company.

    Attributes
    ----------
    vehicles : tuple of int
        Positions in the document.
    length_m : float
        Of the road.
    costs : tuple of SharedCost
        Of each vehicle.
    parts : tuple of BandPart
        In driving order.
    tip : Tip
        What it tells when pointed at.
    drive_s, inferred_m : float
        How long it is driven, and how much of it the loader inferred.
    roads : str
        Road numbers in driving order.
    """

    vehicles: tuple[int, ...]
    length_m: float
    costs: tuple[SharedCost, ...]
    parts: tuple[BandPart, ...]
    tip: Tip
    drive_s: float
    inferred_m: float
    roads: str


@dataclass(frozen=True, slots=True)
class LanePart:
    """A part of a solo line that keeps its lane in the drawing.

    Attributes
    ----------
    line : Line
        Where it runs.
    slot, slots : int
        This vehicle's place among those alone on the road, and their number.
    bands : tuple of int
        Vehicles of each platoon on the same road.
    opposite_m : int or None
        How far away others drive the other way; None if none do.
    """

    line: Line
    slot: int
    slots: int
    bands: tuple[int, ...]
    opposite_m: int | None


@dataclass(frozen=True, slots=True)
class SoloLine:
    """A stretch that one vehicle drives alone.

    Attributes
    ----------
    vehicle : int
        Its position in the document.
    length_m, cost : float
        Of the stretch; the cost in the plan's unit.
    parts : tuple of LanePart
        In driving order.
    tip : Tip
        What it tells when pointed at.
    access : bool
        Whether it is a way between the road and a place beside it, drawn dotted.
    drive_s, inferred_m, fuel_l : float
        How long it is driven, how much of it the loader inferred, and on what fuel.
    roads : str
        Road numbers in driving order.
    """

    vehicle: int
    length_m: float
    cost: float
    parts: tuple[LanePart, ...]
    tip: Tip
    access: bool
    drive_s: float
    inferred_m: float
    fuel_l: float
    roads: str


@dataclass(frozen=True, slots=True)
class TrafficRoads:
    """The roads that carry the same traffic, in the direction in which they are driven.

    Attributes
    ----------
    alone : int
        Vehicles alone on them.
    bands : tuple of int
        Vehicles of each platoon on them; of bundled traffic, of all platoons together.
    opposite_m : int or None
        How far away others drive the other way; None if none do, or if it makes no difference.
    lines : Lines
        Where they run, at the steps of the background.
    """

    alone: int
    bands: tuple[int, ...]
    opposite_m: int | None
    lines: Lines


@dataclass(frozen=True, slots=True)
class Traffic:
    """What a crowd is drawn as: ribbons by number of vehicles in place of a line each.

    Attributes
    ----------
    bundled : bool
        Whether platoons, too, are ribbons, as too many of them share a road for a band each.
    most : int
        Most vehicles of one kind, alone or in platoon, on one road.
    roads : tuple of TrafficRoads
        From little traffic to much.
    """

    bundled: bool
    most: int
    roads: tuple[TrafficRoads, ...]


@dataclass(frozen=True, slots=True)
class EventMark:
    """A merge or a separation, or a while in which vehicles stand.

    Attributes
    ----------
    kind : str
        "merge" or "separation"; or "rest", "break", "ban", "change" or "wait".
    lon, lat : float
        Degrees, to 1e-6.
    name : str
        Of the place.
    vehicles : tuple of int
        Who join or leave, or stand.
    others : tuple of int
        Who are there, or stay.
    at_m : float or None
        Where on the common scale of distance; None if there is none.
    at_s : float or None
        When, in seconds from the start of the day; None without times.
    text, detail : str
        What happens, and where and after how long.
    until_s : float or None
        Until when vehicles stand; None for what is but a moment.
    has_parking : bool
        Whether trucks are known to park there; True for what is but a moment.
    """

    kind: str
    lon: float
    lat: float
    name: str
    vehicles: tuple[int, ...]
    others: tuple[int, ...]
    at_m: float | None
    at_s: float | None
    text: str
    detail: str
    until_s: float | None = None
    has_parking: bool = True

    @property
    def stands(self) -> bool:
        """Whether vehicles stand for a while, rather than merge or separate."""
        return self.until_s is not None

    def concerns(self, members: frozenset[int]) -> bool:
        """Return whether one of some vehicles joins or leaves here.

        Parameters
        ----------
        members : frozenset of int
            Positions in the document.

        Returns
        -------
        bool
            Whether it does.
        """
        return not members.isdisjoint(self.vehicles)


class TownLabel(NamedTuple):
    """The name of a city, town or village.

    Attributes
    ----------
    lon, lat : int
        In 1e-4 degrees.
    name : str
        Of the place.
    rank : int
        0 city, 1 town, 2 village.
    """

    lon: int
    lat: int
    name: str
    rank: int


class JunctionLabel(NamedTuple):
    """The name of a signed junction.

    Attributes
    ----------
    lon, lat : int
        In 1e-4 degrees.
    name : str
        Its name, or its exit number.
    """

    lon: int
    lat: int
    name: str


class StopLabel(NamedTuple):
    """A stop for trucks on the way of a vehicle.

    Attributes
    ----------
    lon, lat : int
        In 1e-4 degrees.
    name : str
        Its name, or what it is.
    told : str
        What there is: kind, spaces for trucks, fuels, charging.
    """

    lon: int
    lat: int
    name: str
    told: str


@dataclass(frozen=True, slots=True)
class Basemap:
    """The network in the background.

    Attributes
    ----------
    known : Lines
        Roads of the map.
    inferred : Lines
        Roads that the loader inferred.
    """

    known: Lines
    inferred: Lines
