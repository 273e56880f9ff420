"""When each vehicle of a plan is where: immutable records in seconds from one start."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

from ..errors import ScenarioError
from ..kinds import is_number
from .clock import Clock, Offsets
from .pauses import DriverDay, Pause, driver_from_dict, pause_from_dict

__all__ = ["LATE_S", "Timetable", "VehicleTimes"]

LATE_S = 0.01
"""Less than this is neither lateness nor waiting, but the last digits of a sum [s]."""

Span = tuple[float, float]


@dataclass(frozen=True, slots=True)
class VehicleTimes:
    """One vehicle's times, all in seconds from the start of the timetable.

    Attributes
    ----------
    vehicle : str
        Its name.
    departure_s : float
        When it leaves its origin.
    legs : tuple of tuple of float
        Start and end of each stretch of its way. Between the end of one and the start of the next
        it waits for others; before the first it waits if it has to leave its origin but merges
        right there.
    earliest_departure_s, latest_departure_s, latest_arrival_s : float or None
        What its trip asked for.
    pauses : tuple of Pause
        Why and where it stands in the gaps between legs, in order of time. A gap without one is a
        wait for others.
    drivers : tuple of DriverDay
        Who drives, under driving rules; none without.
    """

    vehicle: str
    departure_s: float
    legs: tuple[Span, ...]
    earliest_departure_s: float | None = None
    latest_departure_s: float | None = None
    latest_arrival_s: float | None = None
    pauses: tuple[Pause, ...] = ()
    drivers: tuple[DriverDay, ...] = ()

    def __post_init__(self) -> None:
        where = f"plan: times of {self.vehicle!r}"
        if not self.legs:
            raise ScenarioError(f"{where} name no legs; plan again")
        asked = (self.earliest_departure_s, self.latest_departure_s, self.latest_arrival_s)
        moments = (self.departure_s, *(at for span in self.legs for at in span))
        if not all(map(_is_moment, (*moments, *(at for at in asked if at is not None)))):
            raise ScenarioError(f"{where} must be finite numbers of seconds; plan again")
        if list(moments) != sorted(moments):
            raise ScenarioError(f"{where} run backwards; plan again")
        ends = (self.departure_s, *(end for _, end in self.legs))
        for pause in self.pauses:
            fits = pause.before < len(self.legs) and (
                ends[pause.before] - LATE_S <= pause.start_s
                and pause.end_s <= self.legs[pause.before][0] + LATE_S
            )
            if not fits:
                raise ScenarioError(f"{where} have a pause while it drives; plan again")
        for driver in self.drivers:
            if any(not 0 <= leg < len(self.legs) for leg in driver.drives or ()):
                raise ScenarioError(f"{where} have a driver on no leg of it; plan again")

    @property
    def arrival_s(self) -> float:
        """When it reaches its destination."""
        return self.legs[-1][1]

    @property
    def moments(self) -> tuple[float, ...]:
        """All moments that are shown of it: driven, and asked for [s]."""
        asked = (self.earliest_departure_s, self.latest_departure_s, self.latest_arrival_s)
        driven = (self.departure_s, *(at for span in self.legs for at in span))
        return (*driven, *(at for at in asked if at is not None))

    @property
    def waits(self) -> tuple[float, ...]:
        """How long it waits on the road before each leg [s]."""
        ends = (self.departure_s, *(end for _, end in self.legs[:-1]))
        gaps = (start - end for (start, _), end in zip(self.legs, ends, strict=True))
        return tuple(gap if gap > LATE_S else 0.0 for gap in gaps)

    @property
    def waiting_s(self) -> float:
        """How long it waits on the road in all."""
        return sum(self.waits)

    @property
    def held_s(self) -> float:
        """How long after its earliest departure it leaves; 0 if it named none."""
        return 0.0 if self.earliest_departure_s is None else (
            self.departure_s - self.earliest_departure_s
        )  # fmt: skip

    @property
    def late_s(self) -> float:
        """How long after its latest arrival it arrives; 0 if it is in time or named none."""
        late = 0.0 if self.latest_arrival_s is None else self.arrival_s - self.latest_arrival_s
        return late if late > LATE_S else 0.0


@dataclass(frozen=True, slots=True)
class Timetable:
    """When each vehicle of a plan is where.

    Attributes
    ----------
    start : str
        ISO 8601 moment from which all seconds count, with an offset from UTC or without a zone, as
        the trips were.
    feasible : bool
        Whether all arrive in time.
    vehicles : tuple of VehicleTimes
        In the order of the plan's.
    zone : str
        Name of the zone in which times are shown, such as "Europe/Rome"; empty if it has none.
    offsets : tuple of (float, float)
        From when on [s] clocks go by which offset from UTC [s], if they change; see `Clock`.
    patience_s : float or None
        How far company was allowed to move a vehicle that names no window [s]; None if that was
        not limited, or is not known.
    rules : str
        Name of the driving rules by which breaks and rests were planned, or rest was spread over
        the driving; empty if there were none.
    task_relief : float
        How much a follower's driving clock slows under them, [0, 1].
    """

    start: str
    feasible: bool
    vehicles: tuple[VehicleTimes, ...]
    zone: str = ""
    offsets: Offsets = ()
    patience_s: float | None = None
    rules: str = ""
    task_relief: float = 0.0

    def __post_init__(self) -> None:
        clock = self.clock
        try:
            for times in self.vehicles:
                clock.moment(times.departure_s - 60)
                clock.moment(times.arrival_s + 60)
        except OverflowError:
            raise ScenarioError("plan: its times lie beyond the calendar; plan again") from None
        patience = self.patience_s
        if patience is not None and not (_is_moment(patience) and patience >= 0):
            raise ScenarioError("plan: patience_s must be seconds, 0 or more, or null; plan again")
        if not (_is_moment(self.task_relief) and 0 <= self.task_relief <= 1):
            raise ScenarioError("plan: task_relief must be a number in [0, 1]; plan again")
        if self.feasible is not (not any(times.late_s for times in self.vehicles)):
            raise ScenarioError("plan: feasible does not fit the arrival times; plan again")

    @property
    def clock(self) -> Clock:
        """What turns seconds into times of day."""
        return Clock.from_text(self.start, self.zone, self.offsets)

    def patient_until_s(self, vehicle: int, alone_s: float) -> float | None:
        """Return when a vehicle without a latest arrival is there at the latest.

        Parameters
        ----------
        vehicle : int
            Its position.
        alone_s : float
            Its driving time alone [s].

        Returns
        -------
        float or None
            How far company was allowed to move it; None if that was not limited.
        """
        times = self.vehicles[vehicle]
        leaves = times.latest_departure_s
        leaves = times.earliest_departure_s if leaves is None else leaves
        if self.patience_s is None or leaves is None:
            return None
        return leaves + alone_s + self.patience_s

    @property
    def waiting_s(self) -> float:
        """How long all vehicles together wait on the road."""
        return sum(times.waiting_s for times in self.vehicles)

    @classmethod
    def from_dict(cls, data: Mapping[str, Any]) -> Timetable:
        """Rebuild a timetable from plain JSON types.

        Parameters
        ----------
        data : mapping
            As `dataclasses.asdict` gives it.

        Returns
        -------
        Timetable
            The same.

        Raises
        ------
        ScenarioError
            Times that cannot be.
        """
        vehicles = (
            VehicleTimes(
                **{
                    **item,
                    "legs": tuple((start, end) for start, end in item["legs"]),
                    "pauses": tuple(map(pause_from_dict, item.get("pauses", ()))),
                    "drivers": tuple(map(driver_from_dict, item.get("drivers", ()))),
                }
            )
            for item in data["vehicles"]
        )
        offsets = tuple((at, offset) for at, offset in data.get("offsets", ()))
        return cls(**{**data, "vehicles": tuple(vehicles), "offsets": offsets})


def _is_moment(value: Any) -> bool:
    return is_number(value) and math.isfinite(value) and abs(value) < 1e10
