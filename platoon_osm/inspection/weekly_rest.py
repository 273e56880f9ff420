"""(EC) 561/2006 art. 8(6), (6b), (7) and (9): weekly rests, and what makes up for reduced ones.

A weekly rest begins no later than six times 24 h after the end of the one before. In two weeks that
follow each other there are two regular ones (45 h), or a regular and a reduced one (24 h). What a
reduced one lacks is taken in one block before the end of the third week after its week, attached
to another rest of 9 h or more. A weekly rest that falls in two weeks counts in either, not in
both.

The reading: the weeks are allowed if some choice makes them so, of rests of 24 to 45 h that count
as weekly ones, and of the weeks in which rests across Sunday midnight count. Two weeks are judged
if the record holds both whole. That two reduced weekly rests may follow each other outside the
country of establishment (art. 8(6), third subparagraph) is not taken into account.
"""

from __future__ import annotations

import itertools
from collections.abc import Iterator, Sequence

from .activities import DAY, HOUR, WEEK, Record, clock_span
from .driver_start import DriverStart
from .rests import RestTaken, rests_of, taken
from .violation import Violation, badness

__all__ = ["weekly_rests"]

REGULAR_S = 45 * HOUR
REDUCED_S = 24 * HOUR
AFTER_S = 6 * DAY
ATTACHED_S = 9 * HOUR
WEEKS_TO_MAKE_UP = 3

MOST_CHOICES = 8
"""Of more rests than this all count as weekly, and in the week in which they begin."""


def weekly_rests(record: Record, start: DriverStart) -> list[Violation]:
    """Return which weekly rests come too late, are missing, or are not made up for.

    Parameters
    ----------
    record : tuple of Activity
        What a driver does.
    start : DriverStart
        What it has behind it.

    Returns
    -------
    list of Violation
        Those of the choice of weekly rests with the least too much.
    """
    if not any(activity.worked_s for activity in record):
        return []
    rests = rests_of(record)
    began_s = record[0].start_s
    ended_s = began_s - start.since_weekly_rest_s
    if not start.since_weekly_rest_s and rests[0].start_s == began_s:
        ended_s = rests.pop(0).end_s
    long = _longest(taken(rests, REDUCED_S))
    surely = [rest for rest in long if rest.rest_s >= REGULAR_S]
    perhaps = [rest for rest in long if rest.rest_s < REGULAR_S]
    if len(perhaps) > MOST_CHOICES:
        chosen: Iterator[Sequence[RestTaken]] = iter([perhaps])
    else:
        sizes = range(len(perhaps), -1, -1)
        chosen = (some for size in sizes for some in itertools.combinations(perhaps, size))
    singles = taken(rests, ATTACHED_S)
    best: list[Violation] | None = None
    for some in chosen:
        weekly = sorted([*surely, *some], key=lambda rest: rest.start_s)
        found = [
            *_late(weekly, ended_s),
            *_missing(weekly, began_s, record[-1].end_s),
            *_not_made_up(weekly, [rest for rest in singles if rest not in weekly]),
        ]
        if best is None or badness(found) < badness(best):
            best = found
    return best or []


def _longest(rests: Sequence[RestTaken]) -> list[RestTaken]:
    """Return rests that do not overlap: of those around one crossing the one with most rest."""
    kept: list[RestTaken] = []
    for rest in sorted(rests, key=lambda one: (-one.rest_s, one.interruptions)):
        if all(rest.end_s <= one.start_s or one.end_s <= rest.start_s for one in kept):
            kept.append(rest)
    return sorted(kept, key=lambda one: one.start_s)


def _late(weekly: Sequence[RestTaken], before_s: int) -> Iterator[Violation]:
    for rest in weekly:
        late_s = rest.start_s - (before_s + AFTER_S)
        if late_s > 0:
            text = f"{clock_span(rest.start_s - before_s)} since the last weekly rest, "
            text += f"{clock_span(AFTER_S)} allowed"
            yield Violation("561/2006 Art. 8(6)", before_s + AFTER_S, late_s, text)
        before_s = rest.end_s


def _missing(weekly: Sequence[RestTaken], began_s: int, end_s: int) -> list[Violation]:
    """Return which two weeks lack a weekly rest, with rests counted in the weeks that fit best."""
    first = -(-began_s // WEEK)
    pairs = [(week, week + 1) for week in range(first, end_s // WEEK - 1)]
    if not pairs:
        return []
    weeks = [_weeks_of(rest, end_s) for rest in weekly]
    if sum(len(own) > 1 for own in weeks) > MOST_CHOICES:
        weeks = [own[:1] for own in weeks]
    choices = (_lacking(weekly, in_week, pairs) for in_week in itertools.product(*weeks))
    return min(choices, key=badness)


def _weeks_of(rest: RestTaken, end_s: int) -> list[tuple[int, ...]]:
    """Return the weeks in which a rest may count: one, or all that hold a regular one of it."""
    last_s = max(rest.start_s, min(rest.end_s, end_s) - 1)
    weeks = range(rest.start_s // WEEK, last_s // WEEK + 1)
    whole = tuple(
        week
        for week in weeks
        if rest.rest_before((week + 1) * WEEK) - rest.rest_before(week * WEEK) >= REGULAR_S
    )
    return [whole] if len(whole) > 1 else [(week,) for week in weeks]


def _lacking(
    weekly: Sequence[RestTaken],
    in_weeks: Sequence[tuple[int, ...]],
    pairs: Sequence[tuple[int, int]],
) -> list[Violation]:
    found = []
    for pair in pairs:
        spans = [
            rest.rest_s
            for rest, weeks in zip(weekly, in_weeks, strict=True)
            for week in weeks
            if week in pair
        ]
        regular = sum(span >= REGULAR_S for span in spans)
        if regular and len(spans) > 1:
            continue
        lacking_s = REDUCED_S if regular else REGULAR_S
        text = f"{len(spans)} weekly rests in two weeks, {regular} of them of "
        text += f"{clock_span(REGULAR_S)}; two are needed, one of them so long"
        found.append(Violation("561/2006 Art. 8(6)", (pair[1] + 1) * WEEK, lacking_s, text))
    return found


def _not_made_up(weekly: Sequence[RestTaken], others: Sequence[RestTaken]) -> Iterator[Violation]:
    """Yield what reduced weekly rests lack and no later rest makes up for, the oldest first."""
    spare = {
        **{rest: rest.rest_s - REGULAR_S for rest in weekly if rest.rest_s >= REGULAR_S},
        **{rest: rest.rest_s - ATTACHED_S for rest in others if not rest.interruptions},
    }
    for rest in (one for one in weekly if one.rest_s < REGULAR_S):
        lacking_s = REGULAR_S - rest.rest_s
        until_s = ((rest.end_s - 1) // WEEK + 1 + WEEKS_TO_MAKE_UP) * WEEK
        fitting = [
            one
            for one, spare_s in spare.items()
            if one.start_s >= rest.end_s and spare_s - max(0, one.end_s - until_s) >= lacking_s
        ]
        if fitting:
            best = min(fitting, key=lambda one: (spare[one], one.start_s))
            spare[best] -= lacking_s
        else:
            text = f"{clock_span(lacking_s)} less weekly rest are not made up for in time"
            yield Violation("561/2006 Art. 8(6b)", until_s, lacking_s, text)
