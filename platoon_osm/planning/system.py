"""The system objective: members choose for everyone, since the master saves where it has company.

The master saves on an edge once, however many members are there. So members' choices hang
together, and the plan is found by turns; a Lagrangian bound says how good it is.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ..search.tie_rule import TIE
from .member_plans import MemberPlans

__all__ = ["SystemChoice", "choose_for_system", "lower_bound"]

Floats = NDArray[np.float64]
Choose = Callable[[Floats, NDArray[np.int64]], MemberPlans]

ROUNDS = 60


@dataclass(frozen=True, slots=True, eq=False)
class SystemChoice:
    """Members' points, and what is proved about their total.

    Attributes
    ----------
    members : MemberPlans
        The chosen points.
    cost : float
        Of the members, less what the master saves.
    bound : float
        No choice costs less.
    price : ndarray of float, (K,)
        The prices that prove it.
    """

    members: MemberPlans
    cost: float
    bound: float
    price: Floats


def choose_for_system(choose: Choose, gain: Floats, members: int) -> SystemChoice:
    """Choose merging and separation points for members and master together.

    For one member the answer is exact. For more, each takes its best turn while the others hold
    theirs, from several starts. The lower bound is Lagrangian: the master saves on an edge only
    if some member is there; at a price p in [0, gain] for that condition each member may count p
    on every edge it uses, however many others do, and gain - p is granted in advance. This makes
    members independent, and prices fall where many members crowd and rise where none is. What
    company costs the master counts in the choice; the bound leaves it out, unless there is one
    member alone.

    Parameters
    ----------
    choose : callable
        Plans some members, given what each gains for others on each edge (k, K) and which they
        are (k,).
    gain : ndarray of float, (K,)
        What the master saves on each edge of its route if it has company there; below 0 where
        company costs it more than driving alone, as behind a slower vehicle.
    members : int
        How many there are.

    Returns
    -------
    SystemChoice
        The best points found, and a bound.
    """
    everyone = np.arange(members)

    def choose_all(gains: Floats) -> MemberPlans:
        return choose(np.broadcast_to(gains, (members, len(gain))), everyone)

    best = _by_turns(choose, choose_all(np.zeros_like(gain)), gain)
    best_cost, bound = _cost(best, gain), -np.inf
    granted = np.maximum(gain, 0.0)
    price, scale = (gain if members == 1 else granted).copy(), 1.0
    if members == 1:
        granted = gain
    proving = price
    seen: set[bytes] = set()
    for _ in range(ROUNDS):
        relaxed = choose_all(price)
        users = relaxed.covered(len(gain)).sum(axis=0)
        value = lower_bound(relaxed, price, granted)
        scale = scale if value > bound else scale / 2
        if value > bound:
            bound, proving = value, price
        points = relaxed.merge_index.tobytes() + relaxed.separation_index.tobytes()
        if points not in seen:
            seen.add(points)
            improved = _by_turns(choose, relaxed, gain)
            if (cost := _cost(improved, gain)) < best_cost:
                best, best_cost = improved, cost
        slope = np.where((price >= granted) & (users < 1), 0.0, 1.0 - users)
        slope[(price <= 0) & (users > 1)] = 0.0
        if best_cost - bound <= 1e-9 * abs(best_cost) or not slope.any():
            break
        step = scale * (best_cost - value) / float((slope**2).sum())
        price = np.clip(price + step * slope, np.minimum(granted, 0.0), granted)
    return SystemChoice(best, best_cost, min(bound, best_cost), proving)


def lower_bound(relaxed: MemberPlans, price: Floats, gain: Floats) -> float:
    """Return the bound that prices prove, given the members' best choices at them.

    Parameters
    ----------
    relaxed : MemberPlans
        Best plans if each member gains the price on every edge it uses.
    price : ndarray of float, (K,)
        Between 0 and the gain.
    gain : ndarray of float, (K,)
        What the master saves on each edge if it has company there.

    Returns
    -------
    float
        No choice of points costs less.
    """
    users = relaxed.covered(len(gain)).sum(axis=0)
    # The kernel calls costs equal that differ by a hair; the bound allows for it.
    hair = TIE * float(relaxed.solo_cost.sum())
    return float(relaxed.cost.sum() - (price * users).sum() - (gain - price).sum()) - hair


def _cost(plans: MemberPlans, gain: Floats) -> float:
    return float(plans.cost.sum() - gain[plans.covered(len(gain)).any(axis=0)].sum())


def _by_turns(choose: Choose, plans: MemberPlans, gain: Floats) -> MemberPlans:
    """Let one member after another improve its choice until nobody can."""
    cost = _cost(plans, gain)
    for _ in range(20):
        before = cost
        for member in range(len(plans.cost)):
            company = plans.covered(len(gain))
            company[member] = False
            alone_there = np.where(company.any(axis=0), 0.0, gain)
            turn = choose(alone_there[None, :], np.array([member]))
            candidate = plans.with_row(member, turn)
            if (new := _cost(candidate, gain)) < cost - 1e-12 * abs(cost):
                plans, cost = candidate, new
        if cost >= before:
            break
    return plans
