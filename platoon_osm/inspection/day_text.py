"""Days written by hand, for tests and trials: "11h rest, 4h30 drive, 45m rest, 4h30 drive".

Each item is a time and a kind of activity; "drive/50" is driven half relieved. "3 x (...)" stands
for the same three times over.
"""

from __future__ import annotations

import re
from collections.abc import Sequence

from ..errors import ScenarioError, brief
from .activities import DAY, HOUR, MINUTE, WEEK, Activity, Record, record_of

__all__ = ["day_of", "moment_of"]

DAYS = ("Mon", "Tue", "Wed", "Thu", "Fri", "Sat", "Sun")

_REPEATED = re.compile(r"(\d+) x \(([^()]*)\)")
_ITEM = re.compile(r"(?:(\d+)h)?(?:(\d+)(?:m|(?= )))?(?:(\d+)s)? ([a-z]+)(?:/(\d+))?")


def moment_of(text: str) -> int:
    """Return the moment of "Tue 06:30" in the first week, or of "2Tue 06:30" in the second.

    Parameters
    ----------
    text : str
        A day of the week and a time.

    Returns
    -------
    int
        After Monday 0:00 [s].
    """
    day, hour, minute = re.split("[ :]", text)
    weeks = int(day[:-3] or 1) - 1
    days = DAYS.index(day[-3:])
    return weeks * WEEK + days * DAY + int(hour) * HOUR + int(minute) * MINUTE


def day_of(text: str, start: str = "Mon 06:00") -> Record:
    """Return the record that a text describes.

    Parameters
    ----------
    text : str
        Items with commas between them.
    start : str
        When it begins, as for `moment_of`.

    Returns
    -------
    tuple of Activity
        Without gaps.

    Raises
    ------
    ScenarioError
        An item that is none.
    """
    while (repeated := _REPEATED.search(text)) is not None:
        times, inner = repeated.groups()
        text = _REPEATED.sub(", ".join([inner] * int(times)), text, count=1)
    now = moment_of(start)
    found: list[Activity] = []
    for item in text.split(","):
        match = _ITEM.fullmatch(item.strip())
        if match is None:
            raise ScenarioError(f"day: {brief(item.strip())} is no time and kind; give '2h rest'")
        *spans, kind, relief = match.groups()
        span_s = _seconds(spans)
        relieved_s = span_s * int(relief or 0) // 100
        found.append(Activity(kind, now, now + span_s, relieved_s))
        now += span_s
    return record_of(found, found[0].start_s, now)


def _seconds(spans: Sequence[str | None]) -> int:
    hours, minutes, seconds = (int(span or 0) for span in spans)
    return hours * HOUR + minutes * MINUTE + seconds
