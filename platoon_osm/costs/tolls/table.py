"""The table of tolls by country: `tolls.toml`.

A country charges by the kilometre, for a time, by the section, or not at all; what the map marks as
tolled is due everywhere. A rate is given where a source was found that names the tariff, and for
one vehicle alone: 40 t, 5 axles, Euro VI, CO2 class 1. What is not known stays empty.
"""

from __future__ import annotations

import datetime
import tomllib
from collections.abc import Mapping
from dataclasses import dataclass
from functools import cache
from importlib.resources import files
from typing import Any, Literal

from ...vehicles.profile import Vehicle

__all__ = ["ROADS", "Toll", "TollKind", "looked_up", "toll_of", "tolls"]

TollKind = Literal["distance", "time", "sections", "none"]

ROADS = {
    "mapped": (),
    "motorway": ("motorway", "motorway_link"),
    "trunk": ("motorway", "motorway_link", "trunk", "trunk_link"),
    "primary": (
        "motorway", "motorway_link", "trunk", "trunk_link", "primary", "primary_link",
    ),
    "all": (
        "motorway", "motorway_link", "trunk", "trunk_link", "primary", "primary_link",
        "secondary", "secondary_link", "tertiary", "tertiary_link", "other",
    ),
}  # fmt: skip
"""Classes of roads on which a national charge is due, by the word in the table."""


@dataclass(frozen=True, slots=True)
class Toll:
    """What a country charges heavy goods vehicles for its roads.

    Attributes
    ----------
    code : str
        ISO 3166 code, "AT".
    kind : {"distance", "time", "sections", "none"}
        How it charges.
    roads : str
        On which roads, a key of `ROADS`; besides on all that the map marks.
    currency : str
        ISO 4217 code of rate and price.
    source : str
        Whose tariff it is.
    limit_t : float
        Permitted mass from which on it is due [t].
    inclusive : bool
        Whether it is due at that mass too.
    rate : float or None
        Per kilometre; None if it is not known.
    per_day : float or None
        Price for a day; None if it is not known.
    rate_over_t : float
        Permitted mass above which rate and price hold [t].
    emission_class : str
        Of the vehicles for which they hold.
    year : int or None
        Of rate or price.
    page : str
        Where it was looked up.
    note : str
        What it leaves out.
    """

    code: str
    kind: TollKind
    roads: str
    currency: str
    source: str
    limit_t: float = 0.0
    inclusive: bool = False
    rate: float | None = None
    per_day: float | None = None
    rate_over_t: float = 0.0
    emission_class: str = "euro6"
    year: int | None = None
    page: str = ""
    note: str = ""

    def concerns(self, vehicle: Vehicle) -> bool:
        """Say whether the national charge is due for a vehicle.

        Parameters
        ----------
        vehicle : Vehicle
            Who drives.

        Returns
        -------
        bool
            By its permitted mass.
        """
        mass = vehicle.permitted_t
        return mass > self.limit_t or (self.inclusive and mass == self.limit_t)

    def priced_for(self, vehicle: Vehicle) -> bool:
        """Say whether rate and price of the table are those of a vehicle.

        Parameters
        ----------
        vehicle : Vehicle
            Who drives.

        Returns
        -------
        bool
            By its permitted mass and emission class.
        """
        return (
            vehicle.permitted_t > self.rate_over_t and vehicle.emission_class == self.emission_class
        )


@cache
def _data() -> dict[str, Any]:
    return tomllib.loads((files(__package__) / "tolls.toml").read_text("utf-8"))


@cache
def tolls() -> Mapping[str, Toll]:
    """Return the table.

    Returns
    -------
    mapping of str to Toll
        By code.
    """
    emission_class = _data()["rated"]["emission_class"]
    return {row["code"]: _toll(dict(row), emission_class) for row in _data()["countries"]}


def _toll(row: dict[str, Any], emission_class: str) -> Toll:
    inclusive = "from_t" in row
    limit = row.pop("from_t", 0.0) if inclusive else row.pop("over_t", 0.0)
    return Toll(limit_t=float(limit), inclusive=inclusive, emission_class=emission_class, **row)


def looked_up() -> datetime.date:
    """Return the day on which the table was last compared with its sources.

    Returns
    -------
    datetime.date
        A day.
    """
    day: datetime.date = _data()["looked_up"]
    return day


def toll_of(country: str) -> Toll | None:
    """Return what a country charges.

    Parameters
    ----------
    country : str
        "IT", "US-CA" in any case; a state has its country's.

    Returns
    -------
    Toll or None
        None if the table has no such country.
    """
    return tolls().get(country.upper().partition("-")[0])
