"""The pauses of a record, as breaks see them: time in which a driver neither drives nor works.

Rest is a pause. So is the time beside the one who drives, if it is 45 min with the rest around it:
(EC) 561/2006 art. 7, third paragraph. Being available elsewhere is none.
"""

from __future__ import annotations

import itertools
from collections.abc import Iterator
from dataclasses import dataclass

from .activities import MINUTE, Activity, Record

__all__ = ["BESIDE_S", "Pause", "drives_and_pauses"]

BESIDE_S = 45 * MINUTE
"""Art. 7, third paragraph: less than this beside the one who drives is no break [s]."""


@dataclass(frozen=True, slots=True)
class Pause:
    """A pause.

    Attributes
    ----------
    start_s, end_s : int
        When [s].
    rest_s : int
        The longest rest in it, without time beside the one who drives [s].
    """

    start_s: int
    end_s: int
    rest_s: int

    @property
    def break_s(self) -> int:
        """For how much of a break it counts [s]."""
        span_s = self.end_s - self.start_s
        return span_s if span_s >= BESIDE_S else self.rest_s


def drives_and_pauses(record: Record) -> Iterator[Activity | Pause]:
    """Yield what a driver does, with each pause as one.

    Parameters
    ----------
    record : tuple of Activity
        Without gaps.

    Yields
    ------
    Activity or Pause
        In order of time.
    """
    parts: list[Activity] = []
    for activity in record:
        if activity.is_rest or activity.kind == "passenger":
            parts.append(activity)
            continue
        if parts:
            yield _pause(parts)
            parts = []
        yield activity
    if parts:
        yield _pause(parts)


def _pause(parts: list[Activity]) -> Pause:
    runs = itertools.groupby(parts, key=lambda part: part.is_rest)
    rests = [sum(part.span_s for part in run) for is_rest, run in runs if is_rest]
    return Pause(parts[0].start_s, parts[-1].end_s, max(rests, default=0))
