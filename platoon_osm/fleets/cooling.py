"""How hot the search for a plan is at a share of its course: hot, it takes dearer plans too."""

from __future__ import annotations

from .phases import Phases
from .plan.habits import LARGE

__all__ = ["heat_at"]

COLD = 0.15
"""The last part of a cooling accepts no plan that costs more."""


def heat_at(phases: Phases, number: int, begun: float, share: float, trucks: int) -> float:
    """Return how hot it is, from 1 at first to 0.

    Small fleets cool in each phase of the plan, for what is proved in the first need not wait for
    the second. Large ones cool once: a second heat would undo what the first found
    (docs/fleets-plan.md, "Cooling").

    Parameters
    ----------
    phases : tuple of (str, float)
        Who works until which share of the course.
    number : int
        Of the phase, one of the plan's.
    begun : float
        Share at which it began.
    share : float
        Share now.
    trucks : int
        How many there are.

    Returns
    -------
    float
        In [0, 1].
    """
    until = phases[number][1]
    left, whole = until - share, until - begun
    if trucks >= LARGE:
        begins = (0.0, *(end for _, end in phases))
        spans = [
            end - begin if who == "plan" else 0.0
            for begin, (who, end) in zip(begins, phases, strict=False)
        ]
        left, whole = left + sum(spans[number + 1 :]), sum(spans)
    return min(1.0, max(0.0, (left / max(whole, 1e-9) - COLD) / (1 - COLD)))
