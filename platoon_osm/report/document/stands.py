"""Why vehicles stand between two legs: what of each gap is a rest, a break, a ban or a wait.

A gap without a record of a pause, or what a pause leaves of it, is a wait for others.
"""

from __future__ import annotations

from ...plans.pauses import Pause
from ...plans.timetable import LATE_S, Timetable, VehicleTimes
from .model_law import Standing

__all__ = ["all_waited_s", "kind_of", "stands_of", "waited_s"]


def kind_of(pause: Pause) -> str:
    """Return what a pause is drawn as.

    Parameters
    ----------
    pause : Pause
        Of a plan.

    Returns
    -------
    str
        As the kind of a `Standing`: that of the purpose which asks for most.
    """
    if pause.is_rest:
        return "rest"
    if pause.is_break:
        return "break"
    return next((kind for kind in ("ban", "change") if kind in pause.purposes), "wait")


def _restarts(pause: Pause) -> bool:
    """Return whether driving counts from 0 again: not after the first of two parts."""
    return pause.is_rest or bool({"break", "second_part"} & set(pause.purposes))


def stands_of(times: VehicleTimes) -> tuple[Standing, ...]:
    """Return when a vehicle stands on its way, and why.

    Parameters
    ----------
    times : VehicleTimes
        Of a timetable.

    Returns
    -------
    tuple of Standing
        In order of time; together they are its gaps between legs.
    """
    found: list[Standing] = []
    ends = (times.departure_s, *(end for _, end in times.legs))
    for leg, (begin, _) in enumerate(times.legs):
        at = ends[leg]
        for pause in times.pauses:
            if pause.before == leg and pause.end_s > at:
                start = max(pause.start_s, at)
                stands = Standing(kind_of(pause), start, pause.end_s, _restarts(pause))
                found += [Standing("wait", at, start), stands]
                at = pause.end_s
        found.append(Standing("wait", at, begin))
    return tuple(one for one in found if one.lasts_s > LATE_S)


def waited_s(times: VehicleTimes) -> float:
    """Return how long a vehicle waits for others on its way.

    Parameters
    ----------
    times : VehicleTimes
        Of a timetable.

    Returns
    -------
    float
        Without breaks, rests, bans and changes of drivers [s].
    """
    return sum(one.lasts_s for one in stands_of(times) if one.kind == "wait")


def all_waited_s(table: Timetable) -> float:
    """Return how long all vehicles together wait for others on their way.

    Parameters
    ----------
    table : Timetable
        Of a plan.

    Returns
    -------
    float
        As `waited_s` [s].
    """
    return sum(map(waited_s, table.vehicles))
