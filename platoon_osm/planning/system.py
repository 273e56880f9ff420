"""The system objective: members choose for everyone, since the master saves where it has company.

The master saves on an edge once, however many members are there. So members' choices hang
together, and the plan is found by turns; a bound from shared-out gains says how good it is.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from .cases import MemberPlans

__all__ = ["SystemChoice", "choose_for_system"]

Floats = NDArray[np.float64]
Choose = Callable[[Floats], MemberPlans]

ROUNDS = 60


@dataclass(frozen=True, slots=True, eq=False)
class SystemChoice:
    """Members' points, and what is proved about their total.

    Attributes
    ----------
    members : the chosen points.
    cost : of the members, less what the master saves.
    bound : no choice costs less.
    """

    members: MemberPlans
    cost: float
    bound: float


def choose_for_system(choose: Choose, gain: Floats, members: int) -> SystemChoice:
    """Choose merging and separation points for members and master together.

    For one member the answer is exact. For more, each takes its best turn while the others hold
    theirs, from several starts. The lower bound is Lagrangian: the master's gain on each edge is
    shared out among members (shares that add up to one), which makes them independent; the shares
    move towards the members that use the edge.

    Parameters
    ----------
    choose : plans all members, given (N, K) what each gains for others on each edge.
    gain : (K,) what the master saves on each edge of its route if it has company there.
    members : N.
    """
    share = np.full((members, len(gain)), 1.0 / max(members, 1))
    best: MemberPlans | None = None
    best_cost, bound = np.inf, -np.inf
    for step in range(1 if members < 2 else ROUNDS):
        relaxed = choose(share * gain)
        bound = max(bound, _relaxed_cost(relaxed, share * gain))
        improved = _by_turns(choose, relaxed, gain)
        cost = _cost(improved, gain)
        if cost < best_cost:
            best, best_cost = improved, cost
        if best_cost - bound <= 1e-9 * abs(best_cost):
            break
        used = _covered(relaxed, len(gain)).astype(np.float64)
        users = used.sum(axis=0)
        wanted = np.where(users > 0, used / np.maximum(users, 1), share)
        share += (wanted - share) / (step + 2)
    assert best is not None
    return SystemChoice(best, best_cost, min(bound, best_cost))


def _covered(plans: MemberPlans, edges: int) -> NDArray[np.bool_]:
    """Mark the route's edges (N, K) that each member drives in the platoon."""
    at = np.arange(edges)
    joined = plans.merge_index >= 0
    return (
        joined[:, None]
        & (at >= plans.merge_index[:, None])
        & (at < plans.separation_index[:, None])
    )


def _cost(plans: MemberPlans, gain: Floats) -> float:
    return float(plans.cost.sum() - gain[_covered(plans, len(gain)).any(axis=0)].sum())


def _relaxed_cost(plans: MemberPlans, gains: Floats) -> float:
    return float(plans.cost.sum() - gains[_covered(plans, gains.shape[1])].sum())


def _by_turns(choose: Choose, plans: MemberPlans, gain: Floats) -> MemberPlans:
    """Let one member after another improve its choice until nobody can."""
    members = len(plans.cost)
    cost = _cost(plans, gain)
    for _ in range(20):
        before = cost
        for member in range(members):
            covered = _covered(plans, len(gain))
            others = np.delete(covered, member, axis=0).any(axis=0)
            wanted = np.zeros(covered.shape)
            wanted[member] = np.where(others, 0.0, gain)
            candidate = _with_row(plans, choose(wanted), member)
            if (new := _cost(candidate, gain)) < cost - 1e-12 * abs(cost):
                plans, cost = candidate, new
        if cost >= before:
            break
    return plans


def _with_row(plans: MemberPlans, other: MemberPlans, row: int) -> MemberPlans:
    columns = []
    for name in MemberPlans.__slots__:
        column = getattr(plans, name).copy()
        column[row] = getattr(other, name)[row]
        columns.append(column)
    return MemberPlans(*columns)
