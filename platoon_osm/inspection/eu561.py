"""Regulation (EC) 561/2006 and Directive 2002/15/EC, as those who check a driver's card read them.

The parts stand in files of their own: breaks, daily rests and driving, driving by week, weekly
rests, breaks in work. Article 12 lets a driver, where nobody is put in danger and against a note in
its record, exceed arts. 6(1), 6(2) and 8(2) by 1 h to reach the place of a weekly rest, and by 2 h,
right after a pause of 30 min, to reach that of a regular one. It is no plan's to use; whoever asks
is told which violations it would excuse.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from .activities import HOUR, MINUTE, Record
from .breaks import break_violations
from .daily import Day, days_of
from .directive_2002_15 import work_violations
from .driver_start import RESTED, DriverStart
from .driving_by_week import weekly_driving
from .pauses import Pause, drives_and_pauses
from .violation import Violation, in_order
from .weekly_rest import REDUCED_S, REGULAR_S, weekly_rests

__all__ = ["eu561_violations"]

EXCUSED = ("561/2006 Art. 6(1)", "561/2006 Art. 6(2)", "561/2006 Art. 8(2)")
BEFORE_WEEKLY_S = 1 * HOUR
BEFORE_REGULAR_S = 2 * HOUR
PAUSE_S = 30 * MINUTE


def eu561_violations(
    record: Record, start: DriverStart = RESTED, *, article_12: bool = False
) -> list[Violation]:
    """Return what a driver's record breaks.

    Parameters
    ----------
    record : tuple of Activity
        What it does, without gaps.
    start : DriverStart
        What it has behind it.
    article_12 : bool
        Whether to mark what article 12 would excuse.

    Returns
    -------
    list of Violation
        In order of time.
    """
    if not record:
        return []
    days, found = days_of(record, start)
    violations = in_order(
        (
            *found,
            *break_violations(record, start),
            *weekly_driving(record, start),
            *weekly_rests(record, start),
            *work_violations(record, days, start),
        )
    )
    if not article_12:
        return violations
    pauses = [step for step in drives_and_pauses(record) if isinstance(step, Pause)]
    return [
        replace(one, excusable=True) if _is_excused(one, days, pauses) else one
        for one in violations
    ]


def _is_excused(violation: Violation, days: Sequence[Day], pauses: Sequence[Pause]) -> bool:
    if violation.article not in EXCUSED:
        return False
    rested_s = next(
        (day.next_s - day.end_s for day in days if day.start_s <= violation.at_s <= day.end_s), 0
    )
    if rested_s >= REDUCED_S and violation.over_s <= BEFORE_WEEKLY_S:
        return True
    paused = any(
        pause.end_s == violation.at_s and pause.end_s - pause.start_s >= PAUSE_S for pause in pauses
    )
    return rested_s >= REGULAR_S and violation.over_s <= BEFORE_REGULAR_S and paused
