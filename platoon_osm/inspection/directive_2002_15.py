"""Directive 2002/15/EC art. 5(1): breaks in a day of work, driving and other work together.

Nobody works more than 6 h without a break. A day of more than 6 and up to 9 h of work has 30 min of
breaks, one of more than 9 h has 45; pieces are of 15 min or more. Time of being available is not
work, and no break either. A day is that of `daily`: from one daily rest to the next.
"""

from __future__ import annotations

from collections.abc import Sequence

from .activities import HOUR, MINUTE, Activity, Record, clock_span, crossing
from .daily import Day
from .driver_start import DriverStart
from .pauses import Pause, drives_and_pauses
from .violation import Violation

__all__ = ["ARTICLE", "work_violations"]

ARTICLE = "2002/15 Art. 5(1)"

SPELL_S = 6 * HOUR
PIECE_S = 15 * MINUTE
BREAKS = ((6 * HOUR, 30 * MINUTE), (9 * HOUR, 45 * MINUTE))
"""Beyond so much work in a day so much of breaks [s]."""

WHOLE_BREAK_S = 45 * MINUTE
"""What a driver had who has driven more today than since its last break [s]."""


def work_violations(record: Record, days: Sequence[Day], start: DriverStart) -> list[Violation]:
    """Return where a driver works without the breaks that the directive asks for.

    Parameters
    ----------
    record : tuple of Activity
        What it does.
    days : sequence of Day
        Of the record.
    start : DriverStart
        What it has behind it; whatever it drove is all that it worked.

    Returns
    -------
    list of Violation
        At most one a spell of work, and one a day.
    """
    found = []
    for number, day in enumerate(days):
        inside = [one for one in record if day.start_s <= one.start_s < day.end_s]
        before = start if number == 0 else DriverStart()
        found += _of_day(tuple(inside), before)
    return found


def _of_day(record: Record, start: DriverStart) -> list[Violation]:
    spell_s = start.driven_since_break_s
    worked_s = start.driven_today_s
    breaks_s = PIECE_S if start.first_part_taken else 0
    if worked_s > spell_s:
        breaks_s += WHOLE_BREAK_S
    found: list[Violation] = []
    crossed_s: int | None = None
    passed: dict[int, int] = {}
    pending_s = 0
    for step in drives_and_pauses(record):
        if isinstance(step, Pause):
            if step.break_s >= PIECE_S:
                pending_s += step.break_s
                found += _too_long(spell_s, crossed_s)
                spell_s, crossed_s = 0, None
            continue
        if not step.worked_s:
            continue
        breaks_s += pending_s
        pending_s = 0
        if spell_s + step.worked_s > SPELL_S and crossed_s is None:
            crossed_s = _when(step, max(0, SPELL_S - spell_s))
        for beyond_s, _ in BREAKS:
            if worked_s <= beyond_s < worked_s + step.worked_s:
                passed[beyond_s] = _when(step, beyond_s - worked_s)
        spell_s += step.worked_s
        worked_s += step.worked_s
    found += _too_long(spell_s, crossed_s)
    for beyond_s, least_s in reversed(BREAKS):
        if worked_s > beyond_s and breaks_s < least_s:
            text = f"{clock_span(breaks_s)} of breaks in {clock_span(worked_s)} of work, "
            text += f"{clock_span(least_s)} needed"
            at_s = passed.get(beyond_s, record[0].start_s)
            return [*found, Violation(ARTICLE, at_s, least_s - breaks_s, text)]
    return found


def _when(step: Activity, after_s: int) -> int:
    """Return when so much was worked of an activity."""
    return crossing(step, after_s) if step.kind == "drive" else step.start_s + after_s


def _too_long(spell_s: int, crossed_s: int | None) -> list[Violation]:
    if crossed_s is None:
        return []
    text = f"{clock_span(spell_s)} of work without a break, {clock_span(SPELL_S)} allowed"
    return [Violation(ARTICLE, crossed_s, spell_s - SPELL_S, text)]
