"""What the checker finds: something that an article forbids, when, and by how much."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass

__all__ = ["Violation", "badness", "in_order"]


@dataclass(frozen=True, slots=True)
class Violation:
    """Something in a finished timetable that must not be.

    Attributes
    ----------
    article : str
        What forbids it, such as "561/2006 Art. 7"; "plan" if the timetable contradicts itself,
        "window" if it leaves the window of a trip.
    at_s : float
        When it begins [s]: in a driver's record after its Monday 0:00 UTC, in a plan after the
        start of its timetable.
    over_s : float
        By how much: too much driving or work, or too little rest [s].
    text : str
        What is wrong, in a few words.
    excusable : bool
        Whether article 12 would excuse it, where that was asked for.
    """

    article: str
    at_s: float
    over_s: float
    text: str
    excusable: bool = False

    @property
    def minutes_over(self) -> float:
        """By how much [min]."""
        return self.over_s / 60


def badness(violations: Iterable[Violation]) -> tuple[float, int]:
    """Return how bad violations are together: by how much in all, then how many.

    Parameters
    ----------
    violations : iterable of Violation
        Any.

    Returns
    -------
    (float, int)
        The smaller, the better [s].
    """
    spans = [one.over_s for one in violations]
    return sum(spans), len(spans)


def in_order(violations: Iterable[Violation]) -> list[Violation]:
    """Return violations in order of time, those of one moment by article.

    Parameters
    ----------
    violations : iterable of Violation
        In any order.

    Returns
    -------
    list of Violation
        The same.
    """
    return sorted(violations, key=lambda one: (one.at_s, one.article, one.over_s))
