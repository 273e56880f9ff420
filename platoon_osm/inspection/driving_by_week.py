"""(EC) 561/2006 art. 6(2) and (3): 56 h of driving in a week, 90 h in two that follow each other.

A week runs from Monday 0:00 to Sunday 24:00 UTC (art. 4(i); Regulation (EU) 2016/799, Annex IC,
Appendix 14, Addendum, point 2(k)). Driving that interrupts a rest on a ferry counts here too.
"""

from __future__ import annotations

import itertools
from collections import defaultdict

from .activities import HOUR, WEEK, Activity, Record, clock_span, crossing
from .driver_start import DriverStart
from .violation import Violation

__all__ = ["weekly_driving"]

WEEK_DRIVING_S = 56 * HOUR
FORTNIGHT_DRIVING_S = 90 * HOUR


def weekly_driving(record: Record, start: DriverStart) -> list[Violation]:
    """Return in which weeks too much is driven.

    Parameters
    ----------
    record : tuple of Activity
        What a driver does.
    start : DriverStart
        What it has behind it.

    Returns
    -------
    list of Violation
        At most one a week, and one for two weeks.
    """
    first = record[0].start_s // WEEK
    driven: defaultdict[int, int] = defaultdict(int)
    driven[first - 1] = start.driven_last_week_s
    driven[first] = start.driven_this_week_s
    crossed: dict[tuple[str, int], int] = {}
    limits = (("6(2)", WEEK_DRIVING_S, 0), ("6(3)", FORTNIGHT_DRIVING_S, 1))
    for drive in record:
        for piece in _by_week(drive):
            week = piece.start_s // WEEK
            for number, most_s, back in limits:
                before_s = sum(driven[one] for one in range(week - back, week + 1))
                if before_s + piece.driven_s > most_s and piece.driven_s:
                    at_s = crossing(piece, max(0, most_s - before_s))
                    crossed.setdefault((number, week), at_s)
            driven[week] += piece.driven_s
    found = []
    for (number, week), at_s in crossed.items():
        _, most_s, back = next(limit for limit in limits if limit[0] == number)
        total_s = sum(driven[one] for one in range(week - back, week + 1))
        span = "two weeks" if back else "a week"
        text = f"{clock_span(total_s)} driven in {span}, {clock_span(most_s)} allowed"
        found.append(Violation(f"561/2006 Art. {number}", at_s, total_s - most_s, text))
    return found


def _by_week(drive: Activity) -> list[Activity]:
    """Return a drive cut at Sunday midnight; nothing of what is no drive."""
    if drive.kind != "drive":
        return []
    cuts = range((drive.start_s // WEEK + 1) * WEEK, drive.end_s, WEEK)
    moments = [drive.start_s, *cuts, drive.end_s]
    pieces = []
    for start_s, end_s in itertools.pairwise(moments):
        relieved = [
            drive.relieved_s * (at_s - drive.start_s) // drive.span_s for at_s in (start_s, end_s)
        ]
        pieces.append(Activity("drive", start_s, end_s, relieved[1] - relieved[0]))
    return pieces
