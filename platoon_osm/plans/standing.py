"""When a vehicle stands on its way, what for, and when its driving days end.

The gaps between legs are pauses, each with its purpose; what no record of a pause explains is a
wait for others. Daily and weekly rests cut the way into days.
"""

from __future__ import annotations

from dataclasses import replace

from .pauses import Pause
from .timetable import LATE_S, VehicleTimes

__all__ = ["asked_by_rules", "day_ends_s", "driven_s", "rested_s", "standing", "waited_s"]


def standing(times: VehicleTimes) -> tuple[Pause, ...]:
    """Return all times that a vehicle stands on its way.

    Parameters
    ----------
    times : VehicleTimes
        Of a timetable.

    Returns
    -------
    tuple of Pause
        In order of time, without overlap; together they are the gaps between its legs. Those that
        the timetable does not explain are for "company" and name no place.
    """
    found: list[Pause] = []
    ends = (times.departure_s, *(end for _, end in times.legs))
    for leg, (begin, _) in enumerate(times.legs):
        at = ends[leg]
        for pause in times.pauses:
            if pause.before == leg and pause.end_s > at:
                start = max(pause.start_s, at)
                found += [_company(leg, at, start), replace(pause, start_s=start)]
                at = pause.end_s
        if begin > at:
            found.append(_company(leg, at, begin))
    return tuple(pause for pause in found if pause.duration_s > LATE_S)


def _company(leg: int, start_s: float, end_s: float) -> Pause:
    return Pause(leg, ("company",), start_s, end_s)


def asked_by_rules(pause: Pause) -> bool:
    """Return whether driving rules ask for a pause.

    Parameters
    ----------
    pause : Pause
        Of a plan.

    Returns
    -------
    bool
        True for breaks, rests and changes of drivers; False for waits and bans.
    """
    return pause.is_break or "change" in pause.purposes


def rested_s(times: VehicleTimes) -> float:
    """Return how long a vehicle stands because driving rules ask for it.

    Parameters
    ----------
    times : VehicleTimes
        Of a timetable.

    Returns
    -------
    float
        Breaks, rests and changes of drivers [s], waits that are breaks at once among them.
    """
    return sum(pause.duration_s for pause in standing(times) if asked_by_rules(pause))


def waited_s(times: VehicleTimes) -> float:
    """Return how long a vehicle stands for others, or for a ban to end.

    Parameters
    ----------
    times : VehicleTimes
        Of a timetable.

    Returns
    -------
    float
        Without what driving rules ask for [s].
    """
    return sum(pause.duration_s for pause in standing(times) if not asked_by_rules(pause))


def day_ends_s(times: VehicleTimes) -> tuple[float, ...]:
    """Return when driving ends before each daily or weekly rest, and at the destination.

    Parameters
    ----------
    times : VehicleTimes
        Of a timetable.

    Returns
    -------
    tuple of float
        One or more, from the start of the timetable [s].
    """
    ends = (times.departure_s, *(end for _, end in times.legs))
    rests = dict.fromkeys(pause.before for pause in standing(times) if pause.is_rest)
    return (*(ends[leg] for leg in rests if leg > 0), times.arrival_s)


def driven_s(times: VehicleTimes) -> tuple[float, ...]:
    """Return how long each driver of a vehicle drives.

    Parameters
    ----------
    times : VehicleTimes
        Of a timetable.

    Returns
    -------
    tuple of float
        One for each of its drivers, or one for the vehicle if it names none [s].
    """
    legs = [end - begin for begin, end in times.legs]
    return tuple(
        sum(legs if driver.drives is None else (legs[leg] for leg in driver.drives))
        for driver in times.drivers
    ) or (sum(legs),)
