"""The moments of a trip whose pauses are chosen: as late as possible, then as early as that allows.

Backwards from the arrival each point is left as late as its windows and the pauses allow. Forwards
from the departure, rests are prolonged up to that, so that duty periods begin late. Breaks are not:
a wait that is left is where it has to be, for a longer break would make the duty period longer.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from .label import CLOSES, DUTY_MOST, GONE, GONE_MOST, INFO, KIND, LASTS, OPENS, PARENT, TIME
from .numbers import (
    APART,
    BREAK,
    CHANGE,
    CHANGE_RESTED,
    DAILY,
    FIRST,
    NONE,
    PIECE,
    REDUCED,
    SECOND,
    WEEKLY,
)
from .road import FREE, NO_LIMIT, IntArray, LegalTrip, PlannedPause, Road

__all__ = ["Choice", "chosen", "timed"]

PURPOSE = {
    FIRST: "first_part", SECOND: "second_part", BREAK: "break", REDUCED: "reduced_daily_rest",
    DAILY: "daily_rest", WEEKLY: "weekly_rest", PIECE: "break",
}  # fmt: skip


@dataclass(frozen=True, slots=True, eq=False)
class Choice:
    """What a trip does at each point but the last.

    Attributes
    ----------
    kinds : int64 array, (n,)
        The kind of its pause.
    lasts_s : int64 array, (n,)
        How long that is at least [s].
    opens_s, closes_s : int64 array, (n,)
        Within which moments it leaves [s].
    rested_s : int64 array, (n,)
        When it leaves at the latest where it rests [s].
    departure_s : int
        When it leaves the origin at the latest [s].
    """

    kinds: IntArray
    lasts_s: IntArray
    opens_s: IntArray
    closes_s: IntArray
    rested_s: IntArray
    departure_s: int


RESTS = (REDUCED, DAILY, WEEKLY)


def chosen(labels: IntArray, info: IntArray, label: int, hops: int, arrival_s: int) -> Choice:
    """Return the choices that led to a label.

    Parameters
    ----------
    labels : int64 array, (m, COLUMNS)
        Of the search.
    info : int64 array, (m, INFO)
        Of the search.
    label : int
        One of the destination's.
    hops : int
        Of the road.
    arrival_s : int
        When it has to arrive [s].

    Returns
    -------
    Choice
        Of the points before.
    """
    rows = np.zeros((hops, INFO), dtype=np.int64)
    rested = np.full(hops, NO_LIMIT, dtype=np.int64)
    end = labels[label]
    leaves = min(end[GONE_MOST], end[TIME] - end[GONE] + arrival_s - end[TIME])
    most = int(end[DUTY_MOST])
    for hop in range(hops - 1, -1, -1):
        rows[hop] = info[label]
        label = int(info[label, PARENT])
        if APART[rows[hop, KIND]] in RESTS:
            rested[hop] = most
            most = int(labels[label, DUTY_MOST])
    return Choice(
        rows[:, KIND], rows[:, LASTS], rows[:, OPENS], rows[:, CLOSES], rested, int(leaves)
    )


def timed(
    road: Road, choice: Choice, numbers: IntArray, arrival_s: int, shortest: bool
) -> LegalTrip | None:
    """Return the trip that arrives by a moment and leaves as late as possible.

    Parameters
    ----------
    road : Road
        What is driven.
    choice : Choice
        Its pauses.
    numbers : int64 array
        Of the limits.
    arrival_s : int
        When it has to arrive [s].
    shortest : bool
        Whether it arrives earlier if that is possible with the same departure.

    Returns
    -------
    LegalTrip or None
        None if the choices do not go together with that arrival.
    """
    n = road.hops
    lengths = choice.lasts_s
    latest = _latest(road, choice, lengths, arrival_s)
    leaves = latest[0] = min(int(latest[0]), choice.departure_s)
    if shortest:
        at = leaves
        for hop in range(n):
            if hop:
                at = max(at + int(lengths[hop]), int(choice.opens_s[hop]))
            at += int(road.drive_s[hop])
        arrival_s = min(arrival_s, at)
        latest = np.minimum(latest, _latest(road, choice, lengths, arrival_s))
    if latest[0] < max(leaves, choice.opens_s[0]):
        return None
    pauses = []
    at = leaves + int(road.drive_s[0]) if n else leaves
    seat, drives = 0, [0] * n
    for hop in range(1, n):
        kind = int(choice.kinds[hop])
        leave = max(at + int(lengths[hop]), int(choice.opens_s[hop]))
        if APART[kind] in RESTS:
            last = min(int(latest[hop]), int(choice.rested_s[hop]))
            leave = max(leave, min(last, at + int(road.stay_s[hop])))
        if leave > choice.closes_s[hop]:
            return None
        if leave > at:
            forced = leave > at + int(lengths[hop]) and leave == choice.opens_s[hop]
            appointed = road.leave_s[hop] != FREE
            least = int(lengths[hop])
            pauses.append(_pause(hop, at, leave, kind, least, numbers, forced, appointed))
        if kind >= CHANGE:
            seat = 1 - seat
        drives[hop] = seat
        at = leave + int(road.drive_s[hop])
    two = numbers[CHANGE] < numbers[WEEKLY] and numbers[CHANGE] < NO_LIMIT
    return LegalTrip(leaves, at, tuple(pauses), tuple(drives) if two else ())


def _latest(road: Road, choice: Choice, lengths: IntArray, arrival_s: int) -> IntArray:
    """Return when each point is left at the latest."""
    latest = np.zeros(max(1, road.hops), dtype=np.int64)
    at = arrival_s
    for hop in range(road.hops - 1, -1, -1):
        latest[hop] = min(at - int(road.drive_s[hop]), int(choice.closes_s[hop]))
        at = int(latest[hop]) - int(lengths[hop])
    return latest


def _pause(
    point: int, start: int, end: int, kind: int, least: int, numbers: IntArray, forced: bool,
    appointed: bool,
) -> PlannedPause:  # fmt: skip
    stands = end - start
    purposes = []
    pause = BREAK if kind == CHANGE_RESTED else APART[kind]
    if pause == REDUCED and stands >= numbers[DAILY]:
        pause = DAILY
    if pause != NONE:
        purposes.append(PURPOSE[pause])
    if kind >= CHANGE:
        purposes.append("change")
    if forced or not purposes:
        purposes.append("company" if appointed else "ban")
    return PlannedPause(point, start, end, tuple(purposes), least)
