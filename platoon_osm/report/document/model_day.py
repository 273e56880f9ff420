"""The day of a document: the clock, the scale of distance, and the fatigue of drivers."""

from __future__ import annotations

from dataclasses import dataclass, field

from ...plans.clock import Clock, Offsets
from ..language.speech import zone_text
from .model_law import Standing

__all__ = [
    "DaySchedule",
    "DayTexts",
    "Fatigue",
    "FatigueCurve",
    "JourneyScale",
    "LongDrive",
    "VehicleDay",
    "VehicleDayTexts",
]


@dataclass(frozen=True, slots=True)
class JourneyScale:
    """The common scale of distance, on which vehicles of a platoon are always level.

    Attributes
    ----------
    length_m : float
        From where the first vehicle starts to where the last arrives.
    starts_m : tuple of float
        Where on the scale each vehicle starts.
    guide : int or None
        The vehicle by whose kilometres it is read; None if there is no single one.
    """

    length_m: float
    starts_m: tuple[float, ...]
    guide: int | None


@dataclass(frozen=True, slots=True)
class DayTexts:
    """The day as it is printed.

    Attributes
    ----------
    day : str
        Of the first departure.
    waiting : str
        How long all vehicles wait on the road.
    """

    day: str
    waiting: str


@dataclass(frozen=True, slots=True)
class DaySchedule:
    """What holds for the whole day.

    Attributes
    ----------
    start : str
        ISO 8601 moment that all seconds count from.
    zone : str
        Of all times.
    since_midnight_s : float
        From midnight to `start`.
    offsets : tuple of (float, float)
        From when on [s] clocks go by which offset from UTC [s], the first also before; empty if
        clocks do not change.
    begin_s, end_s : float
        First departure and last arrival.
    waiting_s : float
        Of all vehicles, on the road.
    feasible : bool
        Whether all arrive in time.
    text : DayTexts
        The same for reading.
    zone_name : str
        Of the zone alone, such as "Europe/Rome"; empty if it has none.
    """

    start: str
    zone: str
    since_midnight_s: float
    offsets: Offsets
    begin_s: float
    end_s: float
    waiting_s: float
    feasible: bool
    text: DayTexts
    zone_name: str = field(metadata={"json": False})

    @property
    def clock(self) -> Clock:
        """What turns seconds into times of day."""
        return Clock.from_text(self.start, self.zone_name, self.offsets)

    def zone_of(self, begin_s: float, end_s: float) -> str:
        """Return the zone by which times of a span are told, with the offsets that hold in it.

        Parameters
        ----------
        begin_s, end_s : float
            The span.

        Returns
        -------
        str
            As `zone` where clocks change within the span, else with one offset.
        """
        clock = self.clock
        if len(clock.spells(begin_s, end_s)) > 1:
            return self.zone
        return zone_text(Clock(clock.moment(begin_s), self.zone_name))


@dataclass(frozen=True, slots=True)
class VehicleDayTexts:
    """The times of a vehicle as they are printed; empty where there is nothing to tell.

    Attributes
    ----------
    departure, arrival : str
        Times of day.
    earliest, latest : str
        Earliest departure and latest arrival asked for.
    waiting, held, late : str
        How long it waits on the road, at its origin, and arrives too late.
    """

    departure: str
    arrival: str
    earliest: str
    latest: str
    waiting: str
    held: str
    late: str


@dataclass(frozen=True, slots=True)
class VehicleDay:
    """When a vehicle drives, in seconds from `start` of the day.

    Attributes
    ----------
    departure_s, arrival_s : float
        When it leaves its origin and reaches its destination.
    earliest_departure_s, latest_departure_s, latest_arrival_s : float or None
        As asked for.
    waiting_s, held_s, late_s : float
        How long it waits on the road, at its origin, and arrives too late.
    late_alone_s : float or None
        How late it would be if it left as early as it may and drove alone; None if it named no
        earliest departure or no latest arrival.
    spans : tuple of tuple of float
        Begin and end of each piece of its way; between two it waits.
    text : VehicleDayTexts
        The same for reading.
    """

    departure_s: float
    arrival_s: float
    earliest_departure_s: float | None
    latest_departure_s: float | None
    latest_arrival_s: float | None
    waiting_s: float
    held_s: float
    late_s: float
    late_alone_s: float | None
    spans: tuple[tuple[float, float], ...]
    text: VehicleDayTexts
    stands: tuple[Standing, ...] = field(default=(), metadata={"json": False})

    @property
    def is_late(self) -> bool:
        """Whether it arrives too late by as much as is told."""
        return bool(self.text.late)


@dataclass(frozen=True, slots=True)
class FatigueCurve:
    """Fatigue along a journey.

    Attributes
    ----------
    hours : tuple of float
        Since the departure.
    values : tuple of float
        Fatigue at each.
    beyond : bool
        Whether the driver drives beyond the range of the curves, where the last value is held.
    """

    hours: tuple[float, ...]
    values: tuple[float, ...]
    beyond: bool


@dataclass(frozen=True, slots=True)
class Fatigue:
    """Fatigue of a driver, alone and as planned.

    Attributes
    ----------
    alone, joint : FatigueCurve
        Along the journey alone and as planned.
    alone_peak, joint_peak : float
        The highest of each.
    """

    alone: FatigueCurve
    joint: FatigueCurve
    alone_peak: float
    joint_peak: float

    @property
    def curves(self) -> tuple[FatigueCurve, FatigueCurve]:
        """Both curves."""
        return self.alone, self.joint


@dataclass(frozen=True, slots=True)
class LongDrive:
    """Driving beyond 4 h 30 without a break.

    Attributes
    ----------
    vehicle : int
        Position in the document.
    drive_s : float
        How long it drives at a stretch.
    at_m : float
        Where 4 h 30 are reached, from its start.
    at_s : float or None
        When, on the clock of the plan; None without times.
    place : str
        The junction nearest to it; empty if there is none.
    """

    vehicle: int
    drive_s: float
    at_m: float
    at_s: float | None
    place: str
