"""What a driver does, from when until when: the only thing that the checker looks at.

Moments are whole seconds after a Monday 0:00 UTC, whichever, so that calendar weeks are counted by
division. Time of which nothing is known counts as rest, as in Regulation (EU) 2016/799, Annex IC,
Appendix 14, Addendum, point 1.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass

from ..errors import ScenarioError, brief
from ..kinds import is_whole

__all__ = [
    "DAY", "FOREVER", "HOUR", "KINDS", "MINUTE", "WEEK", "Activity", "Record", "clock_span",
    "crossing", "record_of",
]  # fmt: skip

MINUTE = 60
HOUR = 3600
DAY = 24 * HOUR
WEEK = 7 * DAY

FOREVER = 10**12
"""Later than any moment: after the end of a record its driver rests [s]."""

KINDS = ("drive", "work", "available", "passenger", "rest", "ferry")
"""What a driver may do. "passenger" is available in a moving vehicle beside the one who drives;
"ferry" is rest with a bunk on a ferry or a train."""


@dataclass(frozen=True, slots=True)
class Activity:
    """One thing that a driver does.

    Attributes
    ----------
    kind : str
        Of `KINDS`.
    start_s, end_s : int
        When, in seconds after a Monday 0:00 UTC.
    relieved_s : int
        Of a drive: how much of it does not count as driving, because the driver was relieved of
        its task; the driver was available meanwhile [s].

    Raises
    ------
    ScenarioError
        No such kind, or times that cannot be.
    """

    kind: str
    start_s: int
    end_s: int
    relieved_s: int = 0

    def __post_init__(self) -> None:
        if self.kind not in KINDS:
            known = ", ".join(KINDS)
            raise ScenarioError(f"activity: kind is {brief(self.kind)}; give one of {known}")
        if not all(map(is_whole, (self.start_s, self.end_s, self.relieved_s))):
            raise ScenarioError("activity: times must be whole numbers of seconds")
        if not self.start_s <= self.end_s:
            raise ScenarioError("activity: it ends before it begins; give its times in order")
        if not 0 <= self.relieved_s <= self.span_s:
            raise ScenarioError("activity: relieved_s is longer than it lasts; give less")

    @property
    def span_s(self) -> int:
        """How long it lasts [s]."""
        return self.end_s - self.start_s

    @property
    def driven_s(self) -> int:
        """How much driving it counts for [s]."""
        return self.span_s - self.relieved_s if self.kind == "drive" else 0

    @property
    def worked_s(self) -> int:
        """How much work it counts for, driving included [s]."""
        return self.span_s if self.kind == "work" else self.driven_s

    @property
    def is_rest(self) -> bool:
        """Whether the driver may dispose of its time freely."""
        return self.kind in ("rest", "ferry")


Record = tuple[Activity, ...]
"""What one driver does, without gaps, in order of time."""


def record_of(activities: Iterable[Activity], start_s: int, end_s: int) -> Record:
    """Return a driver's record without gaps: what is not known is rest.

    Parameters
    ----------
    activities : iterable of Activity
        In order of time.
    start_s, end_s : int
        From when to when the record runs [s].

    Returns
    -------
    tuple of Activity
        Without those that last no time.

    Raises
    ------
    ScenarioError
        Activities that overlap, or lie outside.
    """
    found: list[Activity] = []
    now = start_s
    for activity in activities:
        if activity.start_s < now or activity.end_s > end_s:
            raise ScenarioError("activities overlap, or lie outside their record; put them right")
        if activity.span_s:
            found += _unknown(now, activity.start_s)
            found.append(activity)
            now = activity.end_s
    return (*found, *_unknown(now, end_s))


def _unknown(start_s: int, end_s: int) -> Iterator[Activity]:
    if start_s < end_s:
        yield Activity("rest", start_s, end_s)


def crossing(activity: Activity, after_s: int) -> int:
    """Return when a drive has counted for so much driving.

    Relief is spread evenly over the drive.

    Parameters
    ----------
    activity : Activity
        A drive.
    after_s : int
        Driving [s]; at most what it counts for.

    Returns
    -------
    int
        The moment [s].
    """
    if not activity.relieved_s:
        return activity.start_s + after_s
    return activity.start_s + after_s * activity.span_s // activity.driven_s


def clock_span(seconds: int) -> str:
    """Return a time span as texts tell it: "4 h 30", "9 h", "20 min".

    Parameters
    ----------
    seconds : int
        The span [s]; less than a minute is told in seconds.

    Returns
    -------
    str
        Hours and minutes.
    """
    minutes, rest = divmod(seconds, MINUTE)
    if rest:
        told = (f"{minutes // 60} h" * (minutes >= 60), f"{minutes % 60} min" * (minutes > 0))
        return " ".join((*filter(None, told), f"{rest} s"))
    hours, minutes = divmod(minutes, 60)
    if not hours:
        return f"{minutes} min"
    return f"{hours} h {minutes:02d}" if minutes else f"{hours} h"
