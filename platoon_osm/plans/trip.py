"""What is asked: a vehicle that wants to go from one place to another, and perhaps when."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from datetime import datetime
from typing import Any

import numpy as np

from ..chance.delays import MOST_MIN
from ..driving.state import RESTED, DriverState, state_of
from ..errors import NetworkError, ScenarioError, brief
from ..kinds import is_number
from ..network.location import PlaceLike, plain_place
from ..vehicles.profile import Vehicle, vehicle_of
from .zones import in_order

__all__ = ["TIMES", "Trip", "check_one_clock"]

FIRST_YEAR, LAST_YEAR = 1900, 9000
"""Beyond these, sums of times may run out of the calendar."""

LONGEST_MIN = 366 * 24 * 60
"""A trip that may take longer by a year names its time in another unit by mistake."""

TIMES = ("earliest_departure", "latest_departure", "latest_arrival")


@dataclass(frozen=True, slots=True)
class Trip:
    """One vehicle's journey.

    A trip without times is flexible: it leaves whenever suits those it drives with.

    Attributes
    ----------
    vehicle : str
        Its name, shown in every table and map.
    origin, destination : str or tuple of float or int or Location or Place
        Places: a name, (lon, lat) in degrees, a node position, what `net.locate` found, or a
        `Place` with an OpenStreetMap id or a label. They are looked for on the network of the plan.
    earliest_departure, latest_departure, latest_arrival : datetime or None
        When. In one plan all have a time zone or none has.
    flexibility_min : float or None
        How much longer than alone it may take [min]: the latest arrival is the earliest departure,
        the driving time alone and this. Instead of `latest_arrival`.
    profile : Vehicle or str or mapping or None
        Size, mass and load of the vehicle: one of `VEHICLES` by name, or fields of `Vehicle` by
        name with `base`; None for that of the plan.
    driver : DriverState or mapping
        What its driver has behind it, or its two; fields of `DriverState` by name will do. By
        default one driver after a weekly rest.
    delay_spread_min : float or None
        Standard deviation of its delay [min], where delays count; None for that of the problem.

    Raises
    ------
    ScenarioError
        A name, place or time that is none, or times that contradict each other.
    """

    vehicle: str
    origin: PlaceLike
    destination: PlaceLike
    earliest_departure: datetime | None = None
    latest_departure: datetime | None = None
    latest_arrival: datetime | None = None
    flexibility_min: float | None = None
    profile: Vehicle | None = None
    driver: DriverState = RESTED
    delay_spread_min: float | None = None

    def __post_init__(self) -> None:
        if not isinstance(self.vehicle, str) or not self.vehicle.strip():
            raise ScenarioError(
                f"trip: vehicle name {brief(self.vehicle)} must be a non-empty text"
            )
        for end in ("origin", "destination"):
            object.__setattr__(self, end, _place(self.vehicle, end, getattr(self, end)))
        if self.profile is not None:
            where = f"trip {self.vehicle!r}"
            object.__setattr__(self, "profile", vehicle_of(self.profile, where))
        object.__setattr__(self, "driver", state_of(self.driver, f"trip {self.vehicle!r}"))
        self._check_times()
        self._check_flexibility()
        spread = self.delay_spread_min
        if spread is not None and not (is_number(spread) and 0 <= spread <= MOST_MIN):
            raise ScenarioError(
                f"trip {self.vehicle!r}: delay_spread_min {brief(spread)} must be minutes from 0 "
                f"to {MOST_MIN:.0f}"
            )

    @property
    def times(self) -> dict[str, datetime]:
        """The times that are named, by the name of their field."""
        return {name: at for name in TIMES if (at := getattr(self, name)) is not None}

    def _check_times(self) -> None:
        where = f"trip {self.vehicle!r}"
        for name, at in self.times.items():
            if not isinstance(at, datetime):
                raise ScenarioError(
                    f"{where}: {name} {brief(at)} must be a day and a time, such as "
                    "2026-03-02T06:00:00"
                )
            if at != at:  # such as pandas' NaT, which counts as a datetime
                raise ScenarioError(f"{where}: {name} is {at}, no moment; give one or None")
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
            if (
                first
                and last
                and (
                    in_order(last) < in_order(first)
                    or (name == TIMES[2] and in_order(last) == in_order(first))
                )
            ):
                raise ScenarioError(
                    f"{where}: {name} {last.isoformat()} is not after earliest_departure "
                    f"{first.isoformat()}; give a later {name}"
                )

    def _check_flexibility(self) -> None:
        if self.flexibility_min is None:
            return
        where, minutes = f"trip {self.vehicle!r}: flexibility_min", self.flexibility_min
        is_real = isinstance(minutes, int | float | np.integer | np.floating)
        if not is_real or isinstance(minutes, bool) or not 0 <= minutes <= LONGEST_MIN:
            raise ScenarioError(
                f"{where} {brief(minutes)} must be a number of minutes from 0 to {LONGEST_MIN}"
            )
        if self.earliest_departure is None:
            raise ScenarioError(f"{where} counts from earliest_departure; give that too")
        if self.latest_arrival is not None:
            raise ScenarioError(
                f"{where} and latest_arrival both say when it must be there; give one of them"
            )
        object.__setattr__(self, "flexibility_min", float(minutes))


def _place(vehicle: str, end: str, value: Any) -> PlaceLike:
    try:
        return plain_place(value)
    except NetworkError as error:
        raise ScenarioError(f"trip {vehicle!r}: {end} {error}") from None


def check_one_clock(trips: Sequence[Trip]) -> None:
    """Check that all times of some trips have a zone, or none has.

    Parameters
    ----------
    trips : sequence of Trip
        Of one plan.

    Raises
    ------
    ScenarioError
        Some have and others have not.
    """
    found: dict[bool, str] = {}
    for trip in trips:
        for name, at in trip.times.items():
            found.setdefault(at.utcoffset() is not None, f"{trip.vehicle!r}, {name}")
    if len(found) == 2:
        raise ScenarioError(
            f"trip {found[True]} has a time zone, trip {found[False]} has none; "
            "give all times of a plan with their zone or none"
        )
