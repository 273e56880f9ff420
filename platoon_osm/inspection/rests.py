"""The rests of a record, and what they make together where a ferry interrupts them.

A rest is any uninterrupted time in which the driver may dispose of its time. On a ferry or a train,
(EC) 561/2006 art. 9(1) lets a regular daily rest or a weekly rest be interrupted at most twice, for
one hour in all; which rests then belong together is told by Regulation (EU) 2016/799, Annex IC,
Appendix 14, Addendum, points 2 and 3: those before and after the crossing, as many as two
interruptions allow, over both parts of a split rest.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from .activities import FOREVER, HOUR, Record

__all__ = ["MOST_INTERRUPTED_S", "MOST_INTERRUPTIONS", "Rest", "RestTaken", "rests_of", "taken"]

MOST_INTERRUPTIONS = 2
MOST_INTERRUPTED_S = 1 * HOUR
"""Art. 9(1): of one daily rest, both parts of a split one together."""


@dataclass(frozen=True, slots=True)
class Rest:
    """An uninterrupted rest.

    Attributes
    ----------
    start_s, end_s : int
        When [s].
    on_ferry : bool
        Whether a ferry or train crossing lies in it.
    """

    start_s: int
    end_s: int
    on_ferry: bool = False

    @property
    def span_s(self) -> int:
        """How long it lasts [s]."""
        return self.end_s - self.start_s


@dataclass(frozen=True, slots=True)
class RestTaken:
    """Rests that count as one: a single one, or up to three around a crossing.

    Attributes
    ----------
    first, last : int
        Positions of the first and the last of them among all rests.
    rests : tuple of Rest
        The rests themselves.
    """

    first: int
    last: int
    rests: tuple[Rest, ...]

    @property
    def start_s(self) -> int:
        """When it begins [s]."""
        return self.rests[0].start_s

    @property
    def end_s(self) -> int:
        """When it ends [s]."""
        return self.rests[-1].end_s

    @property
    def interruptions(self) -> int:
        """How often it is interrupted."""
        return len(self.rests) - 1

    @property
    def interrupted_s(self) -> int:
        """For how long in all [s]."""
        return self.end_s - self.start_s - self.rest_s

    @property
    def rest_s(self) -> int:
        """How much rest it is [s]."""
        return sum(rest.span_s for rest in self.rests)

    def rest_before(self, moment_s: int) -> int:
        """Return how much of the rest lies before a moment.

        Parameters
        ----------
        moment_s : int
            The moment [s].

        Returns
        -------
        int
            Rest [s].
        """
        return sum(max(0, min(rest.end_s, moment_s) - rest.start_s) for rest in self.rests)


def rests_of(record: Record) -> list[Rest]:
    """Return all rests of a record; the last goes on after its end.

    Parameters
    ----------
    record : tuple of Activity
        Without gaps, and not empty.

    Returns
    -------
    list of Rest
        In order of time.
    """
    found: list[Rest] = []
    for activity in record:
        if not activity.is_rest:
            continue
        on_ferry = activity.kind == "ferry"
        if found and found[-1].end_s == activity.start_s:
            before = found.pop()
            found.append(Rest(before.start_s, activity.end_s, before.on_ferry or on_ferry))
        else:
            found.append(Rest(activity.start_s, activity.end_s, on_ferry))
    end_s = record[-1].end_s
    if found and found[-1].end_s == end_s:
        last = found.pop()
        return [*found, Rest(last.start_s, FOREVER, last.on_ferry)]
    return [*found, Rest(end_s, FOREVER)]


def taken(rests: Sequence[Rest], least_s: int) -> list[RestTaken]:
    """Return all ways to take a rest of some length, in one piece or around a crossing.

    Parameters
    ----------
    rests : sequence of Rest
        All of a record.
    least_s : int
        How long it must be in all [s].

    Returns
    -------
    list of RestTaken
        Each with at least so much rest.
    """
    found = []
    for first in range(len(rests)):
        for last in range(first, min(first + MOST_INTERRUPTIONS + 1, len(rests))):
            one = RestTaken(first, last, tuple(rests[first : last + 1]))
            crossed = any(rest.on_ferry for rest in one.rests)
            together = last == first or (crossed and one.interrupted_s <= MOST_INTERRUPTED_S)
            if together and one.rest_s >= least_s:
                found.append(one)
    return found
