"""What is asked: a vehicle that wants to go from one place to another, and perhaps when."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from datetime import datetime
from typing import Any

import numpy as np

from ..errors import ScenarioError
from ..network.location import Location

__all__ = ["TIMES", "Trip", "check_one_clock"]

FIRST_YEAR, LAST_YEAR = 1900, 9000
"""Beyond these, sums of times may run out of the calendar."""

TIMES = ("earliest_departure", "latest_departure", "latest_arrival")


@dataclass(frozen=True, slots=True)
class Trip:
    """One vehicle's journey.

    A trip without times is flexible: it leaves whenever suits those it drives with.

    Attributes
    ----------
    vehicle : its name, shown in every table and map.
    origin, destination : places found by `net.locate`, or node positions.
    earliest_departure, latest_departure, latest_arrival : when, each may be None. In one plan all
        have a time zone or none has.
    """

    vehicle: str
    origin: Location | int
    destination: Location | int
    earliest_departure: datetime | None = None
    latest_departure: datetime | None = None
    latest_arrival: datetime | None = None

    def __post_init__(self) -> None:
        if not isinstance(self.vehicle, str) or not self.vehicle.strip():
            raise ScenarioError(f"trip: vehicle name {self.vehicle!r} must be a non-empty text")
        for end in ("origin", "destination"):
            value: Any = getattr(self, end)
            if isinstance(value, np.integer):
                value = int(value)
                object.__setattr__(self, end, value)
            if isinstance(value, bool) or not isinstance(value, Location | int):
                raise ScenarioError(
                    f"trip {self.vehicle!r}: {end} {value!r} must be a node or come from net.locate"
                )
        self._check_times()

    @property
    def times(self) -> dict[str, datetime]:
        """The times that are named, by the name of their field."""
        return {name: at for name in TIMES if (at := getattr(self, name)) is not None}

    def _check_times(self) -> None:
        where = f"trip {self.vehicle!r}"
        for name, at in self.times.items():
            if not isinstance(at, datetime):
                raise ScenarioError(
                    f"{where}: {name} {at!r} must be a day and a time, such as 2026-03-02T06:00:00"
                )
            if not FIRST_YEAR <= at.year <= LAST_YEAR:
                raise ScenarioError(
                    f"{where}: {name} is in the year {at.year}; give one from {FIRST_YEAR} to "
                    f"{LAST_YEAR}"
                )
        check_one_clock([self])
        first = self.earliest_departure
        for name in TIMES[1:]:
            last = self.times.get(name)
            # Who leaves at the last moment may do so at the first; who arrives has driven.
            if first and last and (last < first or (name == TIMES[2] and last == first)):
                raise ScenarioError(
                    f"{where}: {name} {last.isoformat()} is not after earliest_departure "
                    f"{first.isoformat()}; give a later {name}"
                )


def check_one_clock(trips: Sequence[Trip]) -> None:
    """Raise `ScenarioError` if some times of the trips have a zone and others have none."""
    found: dict[bool, str] = {}
    for trip in trips:
        for name, at in trip.times.items():
            found.setdefault(at.utcoffset() is not None, f"{trip.vehicle!r}, {name}")
    if len(found) == 2:
        raise ScenarioError(
            f"trip {found[True]} has a time zone, trip {found[False]} has none; "
            "give all times of a plan with their zone or none"
        )
