"""What is believed of a fleet file once everything in it was worked out anew."""

from __future__ import annotations

import os
from dataclasses import dataclass
from decimal import Decimal

import numpy as np

from ...plans.plan import Plan
from .beside import check_plan
from .cheapest import cheapest_alone, cheapest_under
from .companies import companies_of, cost_of
from .dropping import needed_pairs
from .faults import FaultError
from .sharing import listed_shares
from .told import Told, read_told
from .ways import alone_costs, check_schedules
from .windows import all_pairs

__all__ = ["Belief", "certified", "certified_with_plan", "certify"]


@dataclass(frozen=True, slots=True)
class Belief:
    """What was found to be so.

    Attributes
    ----------
    trucks, lanes, pairs, shares : int
        How much there was to check.
    alone, cost, least : int
        What all ways alone cost, what the plan costs, and what no plan undercuts [grains].
    dearer : int
        How much less the ways alone could cost within the windows [grains].
    grain : Decimal
        A grain, in the unit of costs.
    conditions : tuple of str
        For which plans the bound holds.
    """

    trucks: int
    lanes: int
    pairs: int
    shares: int
    alone: int
    cost: int
    least: int
    dearer: int
    grain: Decimal
    conditions: tuple[str, ...]

    @property
    def saving(self) -> Decimal:
        """What the plan saves, in the unit of costs."""
        return (self.alone - self.cost) * self.grain

    @property
    def bound(self) -> Decimal:
        """What no plan can save more than, in the unit of costs."""
        return (self.alone - self.least) * self.grain

    @property
    def gap(self) -> float:
        """By what share of the bound more could be saved at most; 0 if nothing can be saved."""
        room = self.alone - self.least
        return (self.cost - self.least) / room if room > 0 else 0.0


def certify(path: str | os.PathLike[str]) -> tuple[Belief, Plan]:
    """Check a fleet file with its plan.

    Parameters
    ----------
    path : str or path
        Of the file.

    Returns
    -------
    belief : Belief
        What is so.
    plan : Plan
        The plan beside it.

    Raises
    ------
    ScenarioError
        The file says nothing that could be checked.
    FaultError
        Something that it says is not so.
    """
    return certified_with_plan(read_told(path))


def certified_with_plan(told: Told) -> tuple[Belief, Plan]:
    """Check what a file says, with the plan beside it.

    Parameters
    ----------
    told : Told
        What it says.

    Returns
    -------
    belief : Belief
        What is so.
    plan : Plan
        The plan beside it.

    Raises
    ------
    ScenarioError
        What stands beside it is no plan.
    FaultError
        Something that it says is not so.
    """
    belief = certified(told)
    return belief, check_plan(told, companies_of(told), belief.alone, belief.cost, belief.least)


def certified(told: Told) -> Belief:
    """Check what a file says, but for the plan beside it.

    Parameters
    ----------
    told : Told
        What it says.

    Returns
    -------
    Belief
        What is so.

    Raises
    ------
    FaultError
        Something that it says is not so.
    """
    alone_cost = alone_costs(told)
    check_schedules(told)
    cost = cost_of(told, companies_of(told))
    pairs = all_pairs(told)
    if not told.given:
        pairs = needed_pairs(told, pairs, alone_cost)
    least = cheapest_under(told, pairs, listed_shares(told, pairs), alone_cost)
    alone, bound = int(alone_cost.sum()), int(least.sum())
    dearer = 0
    if not told.given:
        own = alone_cost - cheapest_alone(told, pairs, alone_cost)
        # Lanes were rounded to grains one by one: that is no other way.
        dearer = int(own[own > np.diff(told.first_route) + told.nodes].sum())
    claims = told.claims
    for name, says, proved, wrong in (
        ("alone", claims["alone"], alone, claims["alone"] != alone),
        ("cost", claims["cost"], cost, claims["cost"] < cost),
        ("bound", claims["bound"], bound, claims["bound"] > bound),
    ):
        if wrong:
            raise FaultError(f"claims a figure of {says} grains for {name}; it is {proved}")
    if bound > cost:
        raise FaultError("the bound is above the cost of the plan; one of both is wrong")
    return Belief(
        trucks=told.trucks, lanes=told.lanes, pairs=len(pairs.lane), shares=len(told.share),
        alone=alone, cost=cost, least=bound, dearer=dearer, grain=told.grain,
        conditions=_conditions(told),
    )  # fmt: skip


def _conditions(told: Told) -> tuple[str, ...]:
    """Return for which plans the bound holds."""
    found = [
        "each truck keeps its route" if told.given else "any route in time, for every truck",
        "together are those who enter a lane at one instant",
        "all drive as fast as told, in company and alone",
        "waiting costs nothing"
        if told.waiting == 0
        else "waiting costs its price on the road, and nothing before leaving",
    ]
    if told.largest:
        found.append(f"no platoon of more than {told.largest} vehicles")
    if len(np.unique(told.kind)) > 1:
        found.append("a platoon is of one kind of vehicles")
    return tuple(found)
