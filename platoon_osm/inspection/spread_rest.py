"""The paper's rest: 45 min for every 9 h of driving, spread over the way of who drives alone.

It is a factor 1 + 2700 s / 32400 s of the time alone in the costs (method.md of the docs), and
stands at no place and no moment. So a timetable cannot break it, and the checker finds nothing.
"""

from __future__ import annotations

from .activities import Record
from .driver_start import RESTED, DriverStart
from .violation import Violation

__all__ = ["spread_rest_violations"]


def spread_rest_violations(record: Record, start: DriverStart = RESTED) -> list[Violation]:
    """Return nothing: rest that is spread over the way is none that could be missing.

    Parameters
    ----------
    record : tuple of Activity
        Not looked at.
    start : DriverStart
        Not looked at.

    Returns
    -------
    list of Violation
        Empty.
    """
    del record, start
    return []
