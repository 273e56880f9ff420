"""Driving bans as data: one file a country, each rule with its source.

A rule says on which days and hours which vehicles may not be driven on which roads:

- `days`: "Mo" to "Su", "daily", "PH" for holidays, "last PH" for those that no further day of rest
  follows, "05-03", "2025-07-05", "easter-2"; `day_before` means the evening before such a day;
- `hours`: "15:00-24:00" by the clocks of the country; "22:00-05:00" ends on the next day;
- `season`: first and last day of it, "07-01", or "Fr from 06-21" (the first Friday then or later),
  "last Su to 08-31" (the last Sunday then or earlier);
- `over_t`: permitted mass above which it holds [t]; `with_trailer_over_t` the same for vehicles
  with a trailer; `over_m` a length above which it holds too [m];
- `roads`: "all", "main" (motorways, trunk and primary roads), or numbers of roads.

What a country's file leaves out, it says.
"""

from __future__ import annotations

import tomllib
from dataclasses import dataclass
from functools import cache
from importlib.resources import files
from typing import Any

from ...network.columns import ROAD_CLASSES
from ...network.road_network import RoadNetwork
from ...vehicles.profile import Vehicle

__all__ = ["BANNED_COUNTRIES", "MAIN", "CountryBans", "Road", "Rule", "bans_of"]

BANNED_COUNTRIES = ("AT", "CH", "CZ", "DE", "ES", "FR", "HR", "HU", "IT", "PL", "SI", "SK")
"""Countries whose bans are known here."""

MAIN = frozenset({"motorway", "motorway_link", "trunk", "trunk_link", "primary", "primary_link"})
"""Classes of what laws call motorways, expressways and roads of the first class."""


@dataclass(frozen=True, slots=True)
class Road:
    """What a ban asks about a road.

    Attributes
    ----------
    road_class : str
        As on the map, such as "motorway".
    ref : str
        Its number, several divided by semicolons.
    """

    road_class: str = "motorway"
    ref: str = ""

    @classmethod
    def of_edge(cls, net: RoadNetwork, edge: int) -> Road:
        """Return the road of an edge.

        Parameters
        ----------
        net : RoadNetwork
            The network.
        edge : int
            Its position.

        Returns
        -------
        Road
            Class and number.
        """
        return cls(ROAD_CLASSES[int(net.road_class[edge])], net.edge_ref(edge))

    def numbers(self) -> frozenset[str]:
        """Return its numbers, without spaces and with one letter for Croatia's state roads."""
        parts = (part.replace(" ", "").upper() for part in self.ref.split(";"))
        return frozenset(f"D{part[2:]}" if part.startswith("DC") else part for part in parts)


@dataclass(frozen=True, slots=True)
class Rule:
    """One rule of a country.

    Attributes
    ----------
    name : str
        What it is called in a plan.
    days, hours : tuple of str
        When, as the module's text says.
    over_t : float
        Permitted mass above which it holds [t].
    source, page, exceptions : str
        The law, where it was looked up, and whom it exempts, in words.
    with_trailer_over_t, over_m : float or None
        Further bounds [t, m].
    season : tuple of str
        First and last day; empty for the whole year.
    day_before : bool
        Whether the evening before is meant.
    roads : tuple of str
        "all", "main", or numbers.
    load : str
        "dangerous" if it is for dangerous goods only.
    unless : str
        "quiet" if it does not hold for vehicles that are certified so.
    """

    name: str
    days: tuple[str, ...]
    hours: tuple[str, ...]
    over_t: float
    source: str
    page: str
    exceptions: str
    with_trailer_over_t: float | None = None
    over_m: float | None = None
    season: tuple[str, ...] = ()
    day_before: bool = False
    roads: tuple[str, ...] = ("all",)
    load: str = ""
    unless: str = ""

    def concerns(self, vehicle: Vehicle, road: Road, quiet: bool = True) -> bool:
        """Tell whether it is made for a vehicle and a road.

        Parameters
        ----------
        vehicle : Vehicle
            Who drives.
        road : Road
            Where.
        quiet : bool
            Whether the vehicle is certified as quiet.

        Returns
        -------
        bool
            Whatever the hour.
        """
        if self.load and not vehicle.hazardous:
            return False
        if self.unless and quiet:
            return False
        return self._meant(vehicle) and self._on(road)

    def _meant(self, vehicle: Vehicle) -> bool:
        mass = vehicle.permitted_t
        trailer = self.with_trailer_over_t
        return (
            mass > self.over_t
            or (trailer is not None and vehicle.trailer and mass > trailer)
            or (self.over_m is not None and vehicle.length_m > self.over_m)
        )

    def _on(self, road: Road) -> bool:
        if self.roads == ("all",):
            return True
        if self.roads == ("main",):
            return road.road_class in MAIN
        own = {ref.replace(" ", "") for ref in self.roads}
        return not own.isdisjoint(road.numbers())


@dataclass(frozen=True, slots=True)
class CountryBans:
    """The bans of one country.

    Attributes
    ----------
    country : str
        Two letters.
    zone : str
        Its time zone.
    holidays : str or tuple of str
        In words where they are those that the library holidays knows; else the days themselves.
    rules : tuple of Rule
        In the order of the file.
    holidays_in_part : tuple of str
        Those of `holidays` that only some regions keep.
    left_out : tuple of str
        What is not included, in words.
    """

    country: str
    zone: str
    holidays: str | tuple[str, ...]
    rules: tuple[Rule, ...]
    holidays_in_part: tuple[str, ...] = ()
    left_out: tuple[str, ...] = ()


@cache
def bans_of(country: str) -> CountryBans | None:
    """Return the bans of a country.

    Parameters
    ----------
    country : str
        Two letters.

    Returns
    -------
    CountryBans or None
        None where none are known here.
    """
    if country not in BANNED_COUNTRIES:
        return None
    file = files(__package__) / "countries" / f"{country.lower()}.toml"
    data = _tuples(tomllib.loads(file.read_text("utf-8")))
    rules = tuple(map(_rule, data.pop("rules")))
    return CountryBans(rules=rules, **data)


def _rule(data: dict[str, Any]) -> Rule:
    roads = data.get("roads", "all")
    return Rule(**{**data, "roads": (roads,) if isinstance(roads, str) else roads})


def _tuples(data: dict[str, Any]) -> dict[str, Any]:
    return {
        key: tuple(_tuples(one) if isinstance(one, dict) else one for one in value)
        if isinstance(value, list)
        else value
        for key, value in data.items()
    }
