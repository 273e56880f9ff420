"""What the exact model tells a search, where the fleet is small enough for it."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

from .exact import Ways
from .exact_process import exact_fleet
from .instance import Instance
from .plan.schedules import Schedules

__all__ = ["ExactTold", "exact_told"]

SMALL = 60_000
"""The exact model is tried with at most so many entries of a truck into a lane at an instant."""


@dataclass(frozen=True, slots=True, eq=False)
class ExactTold:
    """A plan that was made at once, and the least that any costs.

    Attributes
    ----------
    ways : Ways
        The plan.
    cost : int
        What it costs [grains].
    least : int
        What no plan undercuts [grains].
    """

    ways: Ways
    cost: int
    least: int


def exact_told(
    instance: Instance, time_s: float | None, stop: Callable[[], bool]
) -> ExactTold | None:
    """Solve the exact model, if it is small.

    Parameters
    ----------
    instance : Instance
        The problem; waiting must be free.
    time_s : float or None
        How long it may take [s]; None for a number of nodes of the solver.
    stop : callable
        Asked now and then whether to give up.

    Returns
    -------
    ExactTold or None
        None if it is too large or nothing was found.
    """
    found = exact_fleet(instance, time_s, most=SMALL, stop=stop)
    if found is None:
        return None
    # The solver's sums are rounded in their last digits; the certificate's are not.
    cost = Schedules.of(*found.ways).cost(instance)
    return ExactTold(found.ways, cost, min(cost, int(instance.alone_cost.sum()) - found.bound))
