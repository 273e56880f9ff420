"""What the drivers of a plan do, read off its timetable and nothing else.

Legs are driving, gaps between them are rest; of two drivers the one who does not drive sits beside
the other. A follower who is relieved of a share of its task drives for the rest of the time.
Times are whole seconds: driving begins with the first whole second in it and ends with the last, so
less than two seconds between two pauses are not seen. A start without an offset from UTC is taken
as UTC.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass
from datetime import UTC, datetime

from ..plans.pauses import DriverDay
from ..plans.plan import Plan
from ..plans.timetable import Timetable, VehicleTimes
from .activities import DAY, HOUR, MINUTE, Activity, Record, record_of
from .driver_start import RESTED, DriverStart

__all__ = ["DriverRecord", "driver_records"]


@dataclass(frozen=True, slots=True)
class DriverRecord:
    """One driver of a plan.

    Attributes
    ----------
    vehicle : int
        Position in the plan.
    driver : int
        Its number in the vehicle, from 1.
    record : tuple of Activity
        What it does.
    start : DriverStart
        What it has behind it.
    monday_s : float
        When the Monday from which the record counts begins, on the clock of the timetable [s].
    clock_s : int
        How far the clocks of the plan's zone are ahead of UTC when it begins [s].
    """

    vehicle: int
    driver: int
    record: Record
    start: DriverStart
    monday_s: float
    clock_s: int


def driver_records(plan: Plan) -> Iterator[DriverRecord]:
    """Yield what each driver of a plan does.

    Parameters
    ----------
    plan : Plan
        With a timetable; nothing comes of one without.

    Yields
    ------
    DriverRecord
        Vehicle by vehicle.
    """
    timetable = plan.timetable
    if timetable is None:
        return
    start = timetable.clock.start
    offset = start.utcoffset()
    monday_s = -_since_monday(
        start.replace(tzinfo=UTC) if offset is None else start.astimezone(UTC)
    )
    clock_s = 0 if offset is None else round(offset.total_seconds())
    for vehicle, times in enumerate(timetable.vehicles):
        follows = [plan.stretches[stretch].vehicles[0] != vehicle for stretch in plan.ways[vehicle]]
        for number, driver in enumerate(times.drivers or (None,), 1):
            record = _record(timetable, times, follows, driver, monday_s)
            yield DriverRecord(vehicle, number, record, _start(driver), monday_s, clock_s)


def _since_monday(moment: datetime) -> float:
    clock_s = moment.hour * HOUR + moment.minute * MINUTE + moment.second
    return moment.weekday() * DAY + clock_s + moment.microsecond / 1e6


def _record(
    timetable: Timetable,
    times: VehicleTimes,
    follows: list[bool],
    driver: DriverDay | None,
    monday_s: float,
) -> Record:
    begin_s = times.departure_s if driver is None else min(driver.state_at_s, times.departure_s)
    done: list[Activity] = []
    for number, (leg, follower) in enumerate(zip(times.legs, follows, strict=True)):
        start_s = math.ceil(round(leg[0] - monday_s, 3))
        if number and leg[0] - times.legs[number - 1][1] < 1:
            start_s = done[-1].end_s  # it drives on
        end_s = max(start_s, math.floor(round(leg[1] - monday_s, 3)))
        if driver is None or driver.drives is None or number in driver.drives:
            relief = timetable.task_relief if follower else 0.0
            relieved_s = math.floor(relief * (end_s - start_s))
            done.append(Activity("drive", start_s, end_s, relieved_s))
        else:
            done.append(Activity("passenger", start_s, end_s))
    until_s = math.ceil(round(times.arrival_s - monday_s, 3))
    return record_of(done, math.floor(round(begin_s - monday_s, 3)), until_s)


def _start(driver: DriverDay | None) -> DriverStart:
    if driver is None:
        return RESTED
    state = driver.state
    return DriverStart(
        driven_since_break_s=round(state.driven_since_break_s),
        first_part_taken=state.first_part_taken,
        driven_today_s=round(state.driven_today_s),
        duty_s=None if state.duty_s is None else round(state.duty_s),
        driven_this_week_s=round(state.driven_this_week_s),
        driven_last_week_s=round(state.driven_last_week_s),
        long_days_used=state.long_days_used,
        reduced_rests_used=state.reduced_rests_used,
        since_weekly_rest_s=round(state.since_weekly_rest_s),
        drivers=state.drivers,
    )
