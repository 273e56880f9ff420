"""How the search for a plan works on fleets of unlike size: see docs/fleets-plan.md."""

from __future__ import annotations

from typing import NamedTuple

__all__ = ["LARGE", "Habits", "habits_of"]

LARGE = 2000
"""From so many trucks on, a plan is begun with prepared lanes, and cools once."""

SATURATED = 8000
"""From so many trucks on, nearly all can platoon, and platoons are what has to change."""


class Habits(NamedTuple):
    """How a search works.

    Attributes
    ----------
    hot : float
        The highest temperature, as a part of what a mean trip could save.
    group_moves : float
        Share of moves that take a platoon elsewhere.
    neighbours : int
        Trucks of a neighbourhood at most.
    """

    hot: float
    group_moves: float
    neighbours: int


def habits_of(trucks: int) -> Habits:
    """Return how a fleet of some size is searched.

    Parameters
    ----------
    trucks : int
        How many there are.

    Returns
    -------
    Habits
        Tuned for its size.
    """
    if trucks >= SATURATED:
        return Habits(0.8, 0.9, 24)
    if trucks >= LARGE:
        return Habits(0.25, 0.05, 24)
    return Habits(0.07, 0.05, 20)
