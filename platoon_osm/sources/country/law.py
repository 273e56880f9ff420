"""What the law of a country says of speeds where no sign does: `speed_limits.csv`.

A road is of one of four kinds: a motorway, a road for motor vehicles only or with a barrier in its
middle ("dual"), another road in the country, or one in a town. For each kind there is a limit for
cars and, where the law has one, a limit for an articulated truck of 40 t. A sign that allows more
does not lift the truck's own limit; a limit for everybody is replaced by what the sign says.
"""

from __future__ import annotations

import csv
from collections.abc import Mapping
from dataclasses import dataclass
from functools import cache
from importlib.resources import files
from math import inf

__all__ = ["FREE", "KINDS", "MPH_IN_KMH", "Law", "kmh_of", "law_of", "laws"]

KINDS = ("motorway", "dual", "rural", "urban")
MPH_IN_KMH = 1.609344


@dataclass(frozen=True, slots=True)
class Law:
    """The limits of one country or state [km/h].

    Attributes
    ----------
    code : str
        "IT", "US-CA"; empty if nothing is known.
    cars, trucks : mapping of str to float
        By kind of road; infinite where there is no limit, and no entry where it is not known or,
        for trucks, where they have none of their own.
    limiter_kmh : float or None
        What limiters of trucks are set to there; infinite where they need none, None if not known.
    sources : str
        Initials of the sources, which the table names.
    """

    code: str
    cars: Mapping[str, float]
    trucks: Mapping[str, float]
    limiter_kmh: float | None
    sources: str

    def truck_kmh(self, kind: str) -> float:
        """Return a truck's own limit on a kind of road.

        Parameters
        ----------
        kind : str
            One of `KINDS`.

        Returns
        -------
        float
            km/h; infinite if the table has none.
        """
        return self.trucks.get(kind, inf)

    def car_kmh(self, kind: str) -> float:
        """Return everybody's limit on a kind of road without signs.

        Parameters
        ----------
        kind : str
            One of `KINDS`.

        Returns
        -------
        float
            km/h; infinite if there is none or none is known.
        """
        return self.cars.get(kind, inf)


FREE = Law("", {}, {}, None, "")
"""Where nobody knows which country it is."""


def kmh_of(text: str) -> float | None:
    """Return a cell of the table in km/h.

    Parameters
    ----------
    text : str
        "80", "55 mph", "none" or nothing.

    Returns
    -------
    float or None
        km/h; infinite for "none", None for an empty cell.
    """
    number = text.strip().removesuffix("mph")
    if not number:
        return None
    if number == "none":
        return inf
    return float(number) * (MPH_IN_KMH if number != text.strip() else 1.0)


@cache
def laws() -> Mapping[str, Law]:
    """Return the table.

    Returns
    -------
    mapping of str to Law
        By code.
    """
    text = (files(__package__) / "speed_limits.csv").read_text("utf-8")
    lines = [line for line in text.splitlines() if not line.startswith("#")]
    return {row["code"]: _law(row) for row in csv.DictReader(lines)}


def _law(row: Mapping[str, str]) -> Law:
    def by_kind(prefix: str) -> dict[str, float]:
        cells = {kind: kmh_of(row[prefix + kind]) for kind in KINDS}
        return {kind: value for kind, value in cells.items() if value is not None}

    return Law(row["code"], by_kind(""), by_kind("truck_"), kmh_of(row["limiter"]), row["sources"])


def law_of(code: str | None) -> Law:
    """Return the law of a country or state.

    Parameters
    ----------
    code : str or None
        "IT", "US-CA", "BE-VLG" in any case; a state that is not in the table has its country's.

    Returns
    -------
    Law
        `FREE` if the table has neither.
    """
    wanted = (code or "").upper()
    table = laws()
    return table.get(wanted) or table.get(wanted.partition("-")[0]) or FREE
