"""The day of a plan by the clock: when each vehicle drives each of its pieces, and when it waits.

Only plans with a timetable have one; nothing here invents a time.
"""

from __future__ import annotations

from ...plans.clock import MENTIONED_S, Clock, duration
from ...plans.lateness import late_alone_s
from ...plans.plan import Plan
from ...plans.records import Event
from ...plans.timetable import VehicleTimes
from ..language.speech import clock_time, day_and_date, late_by, zone_text
from .model_day import DaySchedule, DayTexts, VehicleDay, VehicleDayTexts
from .stands import all_waited_s, stands_of, waited_s

__all__ = ["timeline", "vehicle_day", "waits_at"]


def timeline(plan: Plan) -> DaySchedule | None:
    """Return what holds for the whole day.

    Parameters
    ----------
    plan : Plan
        Whose day it is.

    Returns
    -------
    DaySchedule or None
        None if the plan has no times.
    """
    table = plan.timetable
    if table is None:
        return None
    clock = table.clock
    begin = min(times.departure_s for times in table.vehicles)
    end = max(times.arrival_s for times in table.vehicles)
    waiting_s = all_waited_s(table)
    return DaySchedule(
        start=table.start,
        zone=zone_text(clock),
        since_midnight_s=round(clock.since_midnight_s, 1),
        offsets=clock.offsets,
        begin_s=round(begin, 1),
        end_s=round(end, 1),
        waiting_s=round(waiting_s, 1),
        feasible=table.feasible,
        text=DayTexts(day_and_date(clock.moment(begin)), duration(waiting_s)),
        zone_name=clock.name,
    )


def vehicle_day(plan: Plan, index: int) -> VehicleDay | None:
    """Return one vehicle's times.

    Parameters
    ----------
    plan : Plan
        Whose vehicle it is.
    index : int
        Its position in the plan.

    Returns
    -------
    VehicleDay or None
        None if the plan has no times.
    """
    table = plan.timetable
    if table is None:
        return None
    times = table.vehicles[index]
    late_alone = late_alone_s(times, plan.trips[index].alone.time_s)
    asked = (times.earliest_departure_s, times.latest_departure_s, times.latest_arrival_s)
    earliest, latest, arrival = (None if at is None else round(at, 1) for at in asked)
    return VehicleDay(
        departure_s=round(times.departure_s, 1),
        arrival_s=round(times.arrival_s, 1),
        earliest_departure_s=earliest,
        latest_departure_s=latest,
        latest_arrival_s=arrival,
        waiting_s=round(waited_s(times), 1),
        held_s=round(times.held_s, 1),
        # Never 0 of who is late, however little.
        late_s=max(round(times.late_s, 1), 0.1) if times.late_s else 0.0,
        late_alone_s=None if late_alone is None else round(late_alone, 1),
        # A tenth of a second is 2 m of road.
        spans=tuple((round(begin, 1), round(end, 1)) for begin, end in times.legs),
        text=_texts(times, table.clock),
        stands=stands_of(times),
    )


def _texts(times: VehicleTimes, clock: Clock) -> VehicleDayTexts:
    earliest, latest = times.earliest_departure_s, times.latest_arrival_s
    return VehicleDayTexts(
        departure=clock_time(clock, times.departure_s),
        arrival=clock_time(clock, times.arrival_s),
        earliest="" if earliest is None else clock_time(clock, earliest),
        latest="" if latest is None else clock_time(clock, latest),
        waiting=duration(waited_s(times)),
        held=duration(times.held_s) if times.held_s >= MENTIONED_S else "",
        late=late_by(times.late_s) if times.late_s else "",
    )


def waits_at(plan: Plan, event: Event, at: float | None) -> list[tuple[int, float]]:
    """Return who waits for others to join, as far as it is worth telling.

    Parameters
    ----------
    plan : Plan
        Whose vehicles they are.
    event : Event
        A merge; nobody waits for a separation.
    at : float or None
        When it is [s].

    Returns
    -------
    list of tuple of int and float
        The position of each vehicle, and how long it waits [s].
    """
    if plan.timetable is None or at is None or event.kind != "merge":
        return []
    found: list[tuple[int, float]] = []
    for index in sorted((*event.movers, *event.others)):
        times = plan.timetable.vehicles[index]
        found += (
            (index, one.lasts_s)
            for one in stands_of(times)
            if one.kind == "wait" and one.lasts_s >= MENTIONED_S and abs(one.end_s - at) < 1
        )
    return found
