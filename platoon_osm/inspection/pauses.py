"""The pauses of a record, as breaks see them: time in which a driver neither drives nor works.

Rest is a pause. So is the time beside the one who drives, if it is 45 min with the rest around it:
(EC) 561/2006 art. 7, third paragraph. Being available elsewhere is none.
"""

from __future__ import annotations

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
    pause: Pause | None = None
    resting_since_s = 0
    for activity in record:
        beside = activity.kind == "passenger"
        if not (activity.is_rest or beside):
            if pause is not None:
                yield pause
            pause = None
            yield activity
            continue
        if pause is None:
            pause = Pause(activity.start_s, activity.start_s, 0)
            resting_since_s = activity.start_s
        if beside:
            resting_since_s = activity.end_s
        rest_s = max(pause.rest_s, activity.end_s - resting_since_s)
        pause = Pause(pause.start_s, activity.end_s, rest_s)
    if pause is not None:
        yield pause
