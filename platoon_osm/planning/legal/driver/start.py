"""The labels with which a driver may leave the origin.

Its state holds at a moment from which on it stands at the origin and is at rest: to leave later may
be a break, or a daily rest. If no moment is named, the state holds whenever it leaves.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from ....driving.state import DriverState
from .label import (
    BESIDE,
    BROKEN,
    CLOSES,
    COLUMNS,
    DUTY,
    DUTY_MOST,
    DUTY_WEEK,
    GONE,
    GONE_MOST,
    INFO,
    KIND,
    LAST_WEEK,
    LASTS,
    LONG_DAYS,
    OPENS,
    OTHER_BROKEN,
    OTHER_LAST_WEEK,
    OTHER_LONG_DAYS,
    OTHER_TODAY,
    OTHER_WEEK,
    PARENT,
    PART,
    REDUCED_USED,
    TIME,
    TODAY,
    WEEK,
    WEEK_DRIVEN,
    WEEK_S,
    WEEKLY_END,
    WORKED,
)
from .numbers import (
    BESIDE_LENGTH,
    CALENDAR,
    CHANGE,
    DAY,
    DUE,
    FORTNIGHT,
    LONG_WINDOW,
    MOST_WEEK,
    NONE,
    POOLED,
)
from .pausing import allowed, leave
from .road import NO_LIMIT, IntArray

WEEKS = 3
"""How many weeks ahead the driver may wait for a new one."""

__all__ = ["Start", "starts_of"]


@dataclass(frozen=True, slots=True, eq=False)
class Start:
    """How a trip may begin.

    Attributes
    ----------
    labels : int64 array, (k, COLUMNS)
        Those that leave the origin.
    info : int64 array, (k, INFO)
        With which pause, and when it is left.
    fixed_weekly_end_s : int
        The end of the last weekly rest if it does not move with the departure [s]; -`NO_LIMIT` if
        it does.
    """

    labels: IntArray
    info: IntArray
    fixed_weekly_end_s: int


def starts_of(
    state: DriverState,
    state_at_s: int | None,
    earliest_s: int,
    latest_s: int,
    windows: IntArray,
    numbers: IntArray,
    kinds: IntArray,
    monday_s: int,
    weeks: int,
) -> Start:  # fmt: skip
    """Return the labels that leave the origin.

    Parameters
    ----------
    state : DriverState
        Of the driver, or of both alike.
    state_at_s : int or None
        When it holds [s]; None if whenever it leaves.
    earliest_s, latest_s : int
        When the origin may be left [s].
    windows : int64 array, (k, 2)
        When else it may be left [s]; empty if at any time.
    numbers, kinds : int64 array
        The limits, and the kinds of pause that they know.
    monday_s : int
        A Monday 0:00 UTC [s].
    weeks : int
        1 where driving in a week can be too much: then waiting for Monday may be a way.

    Returns
    -------
    Start
        None of its labels arrived anywhere yet.
    """
    spans = [(-NO_LIMIT, NO_LIMIT)] if len(windows) == 0 else [(int(a), int(b)) for a, b in windows]
    spans = [(max(a, earliest_s), min(b, latest_s)) for a, b in spans]
    if weeks and numbers[CALENDAR]:
        waits = _sundays(state, state_at_s, earliest_s, numbers, monday_s)
        spans += [(max(a, at), b) for at in waits for a, b in spans if at > a]
    spans = [(a, b) for a, b in spans if a <= b]
    since = math.ceil(state.since_weekly_rest_s)
    resting = state.duty_s is None
    moves = state_at_s is None or (resting and since == 0)
    labels, infos = [], []
    for opens, closes in spans:
        begins = opens if state_at_s is None else min(state_at_s, opens)
        label = _as_of(state, begins, numbers, monday_s)
        label[WEEKLY_END] = begins - since
        for kind in [NONE] if state_at_s is None else kinds:
            if kind >= CHANGE or not allowed(kind, label, numbers):
                continue
            out = np.zeros(COLUMNS, dtype=np.int64)
            done = leave(
                int(kind), begins, opens, closes, NO_LIMIT, 0, label, numbers, monday_s,
                NO_LIMIT, out,
            )  # fmt: skip
            if not done:
                continue
            left = int(out[TIME])
            out[GONE], out[GONE_MOST] = 0, closes
            if resting:
                out[DUTY], out[DUTY_MOST] = 0, closes
                out[DUTY_WEEK] = (left - monday_s) // WEEK_S
            elif state_at_s is None:
                out[DUTY_MOST] = min(NO_LIMIT, closes - out[DUTY]) if closes < NO_LIMIT else closes
            if moves and out[WEEKLY_END] <= begins:
                out[WEEKLY_END] = left - since
            labels.append(out)
            info = np.zeros(INFO, dtype=np.int64)
            info[[PARENT, KIND, OPENS, CLOSES, LASTS]] = -1, kind, opens, closes, numbers[kind]
            infos.append(info)
    fixed = -NO_LIMIT if moves or state_at_s is None else state_at_s - since
    return Start(
        np.array(labels, dtype=np.int64).reshape(-1, COLUMNS),
        np.array(infos, dtype=np.int64).reshape(-1, INFO),
        fixed,
    )


def _sundays(
    state: DriverState, state_at_s: int | None, earliest_s: int, numbers: IntArray, monday_s: int
) -> list[int]:
    """Return when to leave so that what is left of a week lasts till Monday, for some weeks."""
    at = earliest_s if state_at_s is None else state_at_s
    week = (at - monday_s) // WEEK_S
    both = 2 if numbers[POOLED] else 1
    driven = both * math.ceil(state.driven_this_week_s)
    last = both * math.ceil(state.driven_last_week_s)
    found = []
    for later in range(WEEKS):
        begins = monday_s + (week + later + 1) * WEEK_S
        most = min(int(numbers[MOST_WEEK]) - driven, int(numbers[FORTNIGHT]) - driven - last)
        found += [begins, begins - max(0, most)]
        driven, last = 0, driven
    return found


def _as_of(state: DriverState, at_s: int, numbers: IntArray, monday_s: int) -> IntArray:
    """Return the label of a driver who stands at the origin at a moment."""
    label = np.zeros(COLUMNS, dtype=np.int64)
    duty = math.ceil(state.duty_s or 0.0)
    if not numbers[DUE]:
        # Nobody drives after the window, however long it has been over; a rest may begin.
        duty = min(duty, int(numbers[LONG_WINDOW]))
    broken = math.ceil(state.driven_since_break_s)
    label[TIME] = label[GONE_MOST] = at_s
    label[BROKEN] = label[WORKED] = broken
    label[PART] = state.first_part_taken and state.drivers == 1
    label[OTHER_BROKEN] = broken if state.drivers == 2 else 0
    label[TODAY] = math.ceil(state.driven_today_s)
    label[DUTY] = duty
    label[DUTY_MOST] = at_s - duty
    label[LONG_DAYS] = state.long_days_used + (label[TODAY] > numbers[DAY])
    label[REDUCED_USED] = state.reduced_rests_used
    label[WEEK_DRIVEN] = math.ceil(state.driven_this_week_s)
    label[LAST_WEEK] = math.ceil(state.driven_last_week_s)
    if state.drivers == 2 and numbers[POOLED]:
        label[[TODAY, WEEK_DRIVEN, LAST_WEEK]] *= 2
        label[LONG_DAYS] = 2 * state.long_days_used + (label[TODAY] > numbers[DAY])
    elif state.drivers == 2:
        others = [OTHER_TODAY, OTHER_LONG_DAYS, OTHER_WEEK, OTHER_LAST_WEEK]
        label[others] = label[[TODAY, LONG_DAYS, WEEK_DRIVEN, LAST_WEEK]]
    # Long days are told of the week in which that holds, though today may have begun before it.
    label[WEEK] = label[DUTY_WEEK] = (at_s - monday_s) // WEEK_S
    label[BESIDE] = 0 if label[OTHER_BROKEN] else numbers[BESIDE_LENGTH]
    return label
