"""Why vehicles stand between two legs: what of each gap is a rest, a break, a ban or a wait.

A gap without a record of a pause, or what a pause leaves of it, is a wait for others.
"""

from __future__ import annotations

from collections.abc import Collection

from ...plans.pauses import Pause, is_break, is_rest
from ...plans.standing import standing
from ...plans.timetable import Timetable, VehicleTimes
from .model_law import Standing

__all__ = ["all_waited_s", "kind_of", "stands_of", "waited_s"]


def kind_of(purposes: Collection[str]) -> str:
    """Return what a pause is drawn as.

    Parameters
    ----------
    purposes : collection of str
        Of a `Pause`.

    Returns
    -------
    str
        As the kind of a `Standing`: that of the purpose which asks for most.
    """
    if is_rest(purposes):
        return "rest"
    if is_break(purposes):
        return "break"
    return next((kind for kind in ("ban", "change") if kind in purposes), "wait")


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
    return tuple(
        Standing(kind_of(pause.purposes), pause.start_s, pause.end_s, _restarts(pause))
        for pause in standing(times)
    )


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
