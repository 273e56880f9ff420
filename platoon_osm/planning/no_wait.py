"""The departure at which a master that does not wait and its members pay least, exactly.

Under "member" each member pays least itself, at every departure; of all departures the one is taken
at which all together pay least, what the master gains included. Where waiting and delay are free
that is read off one curve.

Under "system" members and master together pay least. The master gains once an edge, so members
hang together. With prices p of that condition, as in `system.py`, they do not, and their curve is a
lower bound of the total at every departure. The departure at which the bound is least is planned;
its prices give a further bound; and so on until no departure can be better than the best plan, or
the work is done. Between a departure and the next moment at which anything opens the total never
falls, so a bound at the one holds up to the other.

If the master may wait, every member may be met at a departure of its own: the sum of what each pays
at best, less what the master gains, is a lower bound of that.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ..search.tie_rule import TIE
from .star import StarChoice
from .timed_star import TimedStar
from .timing.bound_curves import BoundCurves
from .timing.departure_curve import MemberSteps
from .timing.open_points import HAIR_S, OpenPoints

__all__ = ["NoWait", "best_without_waiting", "bound_if_waiting"]

Floats = NDArray[np.float64]

MOST_PLANNED = 40
"""Departures that are planned under "system", if members are few."""

MEMBER_PLANS = 2_000
"""Members planned in all: with many of them, fewer departures are."""

SHARES = (1.0, 0.5, 0.25, 0.0)
"""Prices to begin with, as shares of what the master gains."""


@dataclass(frozen=True, slots=True, eq=False)
class NoWait:
    """The best plan of a master that does not wait.

    Attributes
    ----------
    departure : float
        When it is at the begin of its route [s].
    choice : StarChoice
        Where members merge and separate; its bound holds for every departure.
    is_proved : bool
        Whether the bound holds at all: driving times are equal alone and together, and all ways
        that count are known.
    """

    departure: float
    choice: StarChoice
    is_proved: bool


def best_without_waiting(clocked: TimedStar, case: str) -> NoWait | None:
    """Return the best plan for a master that does not wait.

    Parameters
    ----------
    clocked : TimedStar
        The master and its members.
    case : {"A", "B", "C"}
        Which points are free.

    Returns
    -------
    NoWait or None
        None if the master cannot be in time with company at all.
    """
    points = clocked.points(case)
    if points.earliest > points.latest + HAIR_S or not len(clocked.star.route):
        return None
    if clocked.question.problem.optimum == "system":
        departure, choice, bound = _for_system(clocked, case, points)
    else:
        departure, choice, bound = _for_members(clocked, case, points)
    found = StarChoice(choice.case, choice.points, choice.cost, min(bound, choice.cost))
    return NoWait(departure, found, clocked.is_even and clocked.is_complete)


def _for_members(
    clocked: TimedStar, case: str, points: OpenPoints
) -> tuple[float, StarChoice, float]:
    curve = clocked.member_curve(points)[0]
    step, bound = curve.best(TIE * clocked.star.solo_cost)
    departure = curve.moment(step)
    return departure, clocked.chosen(case, points, departure), bound


def _relaxed(
    clocked: TimedStar, points: OpenPoints, price: Floats, latest: float | None
) -> MemberSteps:
    """Return the steps of members that count a price of the master's gain on every edge."""
    along = clocked.along.copy()
    along[:, 1:] -= np.cumsum(price)
    return clocked.steps(points, along, None, latest)


def _granted(clocked: TimedStar, price: Floats) -> float:
    """Return what the master pays if it is granted what the prices leave of its gain."""
    return clocked.star.master_alone - float((clocked.gains.gain - price).sum())


def _for_system(
    clocked: TimedStar, case: str, points: OpenPoints
) -> tuple[float, StarChoice, float]:
    gain = clocked.gains.gain
    bounds = BoundCurves(points)
    for share in SHARES:
        price = share * gain
        steps = _relaxed(clocked, points, price, None)
        bounds.add(clocked.summed(steps, _granted(clocked, price)))
    best: tuple[float, StarChoice] | None = None
    most = max(2, min(MOST_PLANNED, MEMBER_PLANS // max(len(clocked.solo), 1)))
    for _ in range(most):
        begin, departure, least = bounds.lowest()
        if best is not None and least >= best[1].cost - TIE * clocked.star.solo_cost:
            break
        found = clocked.chosen(case, points, departure)
        bounds.settle(begin, departure, found.bound)
        if best is None or found.cost < best[1].cost - TIE * clocked.star.solo_cost:
            best = departure, found
        if found.price is not None:
            steps = _relaxed(clocked, points, found.price, None)
            bounds.add(clocked.summed(steps, _granted(clocked, found.price)))
    assert best is not None
    return *best, bounds.lowest()[2]


def bound_if_waiting(clocked: TimedStar, case: str) -> float:
    """Return what no plan costs less than, whether the master waits or not.

    Parameters
    ----------
    clocked : TimedStar
        The master and its members.
    case : {"A", "B", "C"}
        Which points are free.

    Returns
    -------
    float
        For members that share one stretch each with the master.
    """
    gain = np.maximum(clocked.gains.gain, 0.0)
    points = clocked.points(case)
    members = max(len(clocked.solo), 1)
    found = -np.inf
    for price in (*(share * gain for share in SHARES), gain / members):
        least = _relaxed(clocked, points, price, points.latest_waiting).least()
        granted = clocked.star.master_alone - float((gain - price).sum())
        found = max(found, float(least.sum()) + granted)
    return found - TIE * clocked.star.solo_cost
