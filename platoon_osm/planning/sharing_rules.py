"""Rules by which a gain is shared, in whole cents, and the check of all coalitions.

"equal"
    On every stretch all bear the same part of the leader's loss (`platoon_osm.sharing.company`),
    and each pays its own way.
"shapley"
    The Shapley value of the game (`platoon_osm.sharing.shapley`). Beyond 12 linked vehicles that of
    each stretch by itself, in closed form, and each pays its own way.
"least-core"
    Whoever could gain most by itself gains least, and nobody is worse off
    (`platoon_osm.sharing.least_core`); of such shares those nearest to "equal". For at most 12
    linked vehicles; beyond, "equal" is taken and said.

Where a rule leaves somebody worse off, though all together gain, the nearest shares that leave
nobody worse off are taken, and said. Then every coalition is asked what it could gain by itself
beyond its shares; beyond 12 linked vehicles by a bound for all of them
(`platoon_osm.sharing.many`).
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ..plans.plan import Plan
from ..plans.text_table import listed
from ..sharing.cents import in_cents
from ..sharing.checked import checked
from ..sharing.coalitions import MOST_PLAYERS
from ..sharing.least_core import least_core
from ..sharing.many import most_to_gain
from ..sharing.nearest import none_worse_off
from ..sharing.rule_names import SharingRule
from ..sharing.shapley import shapley_value
from .road_game import RoadGame

__all__ = ["Shared", "equal_parts", "shared", "shared_on_road"]

Floats = NDArray[np.float64]

HALF_CENT = 0.5
"""Who would be worse off by less is not named: it is made good by rounding."""


@dataclass(frozen=True, slots=True, eq=False)
class Shared:
    """Shares of the vehicles of one game, and what coalitions could gain beyond them.

    Attributes
    ----------
    vehicles : tuple of int, (n,)
        Positions in the plan.
    shares : tuple of int, (n,)
        Cents.
    coalitions : int
        How many were tried one by one.
    worst : float or None
        The most that any coalition could gain [cents]; None if that was not worked out.
    remarks : tuple of str
        What a reader should know.
    """

    vehicles: tuple[int, ...]
    shares: tuple[int, ...]
    coalitions: int = 0
    worst: float | None = None
    remarks: tuple[str, ...] = ()


def shared_on_road(plan: Plan, game: RoadGame, rule: SharingRule, bounded: bool) -> Shared:
    """Share what one game saves by a rule, and ask all its coalitions on the planned roads.

    Parameters
    ----------
    plan : Plan
        For the names of its vehicles.
    game : RoadGame
        Vehicles that are linked by companies.
    rule : {"equal", "shapley", "least-core"}
        By what it is shared.
    bounded : bool
        Whether what coalitions of many vehicles could gain is bounded.

    Returns
    -------
    Shared
        In cents.
    """
    n = len(game.vehicles)
    if n <= MOST_PLAYERS:
        return shared(plan, game.vehicles, equal_parts(game), game.values(), rule)
    total = int(game.saved.sum())
    shares = _shapley_by_stretch(game) if rule == "shapley" else equal_parts(game)
    cents, remarks = _paid(plan, game.vehicles, shares, total)
    if rule == "least-core":
        many = f"{n} linked vehicles are too many for the least core; shared equally"
        remarks = (*remarks, many)
    if not bounded:
        unasked = f"what groups of {n} linked vehicles could gain was not worked out"
        return Shared(game.vehicles, cents, remarks=(*remarks, unasked))
    companies = [(game.players(company), company.best_game()) for company in game.companies]
    worst = most_to_gain(companies, game.own_ways, cents)
    told = f"a bound covers all groups of {n} linked vehicles; none was tried one by one"
    return Shared(game.vehicles, cents, 0, worst, (*remarks, told))


def shared(
    plan: Plan, vehicles: tuple[int, ...], equal: Floats, values: Floats, rule: SharingRule
) -> Shared:
    """Share what some vehicles save by a rule, and ask all their coalitions.

    Parameters
    ----------
    plan : Plan
        For the names of its vehicles.
    vehicles : tuple of int, (n,)
        Positions in the plan.
    equal : ndarray of float, (n,)
        Equal parts of the leader's loss.
    values : ndarray of float, (2^n,)
        What each coalition would save by itself; of everybody, whole cents as planned.
    rule : {"equal", "shapley", "least-core"}
        By what it is shared.

    Returns
    -------
    Shared
        In cents.
    """
    total = round(float(values[-1]))
    if len(vehicles) < 2:
        return Shared(vehicles, (total,) * len(vehicles))
    shares = equal
    if rule == "shapley":
        shares = shapley_value(values)
    elif rule == "least-core":
        shares = least_core(values, equal, nobody_worse_off=total >= 0).shares
    cents, remarks = _paid(plan, vehicles, shares, total)
    asked = checked(cents, values)
    return Shared(vehicles, cents, asked.coalitions, asked.worst, remarks)


def equal_parts(game: RoadGame) -> Floats:
    """Return equal parts of the leader's loss on every stretch, each paying its own way.

    Parameters
    ----------
    game : RoadGame
        On the planned roads.

    Returns
    -------
    ndarray of float, (n,)
        Cents; somebody may have less than nothing.
    """
    shares = -game.own_ways
    for company in game.companies:
        shares[game.players(company)] += company.game().equal_parts(leader=0)
    return shares


def _shapley_by_stretch(game: RoadGame) -> Floats:
    """Return the Shapley value of every stretch by itself, each paying its own way."""
    shares = -game.own_ways
    for company in game.companies:
        played = company.game()
        # The planned leader need not be the best; all bear the same part of what that costs.
        missed = (played.value(range(len(played))) - company.as_planned.sum()) / len(played)
        shares[game.players(company)] += played.shapley() - missed
    return shares


def _paid(
    plan: Plan, vehicles: Sequence[int], shares: Floats, total: int
) -> tuple[tuple[int, ...], tuple[str, ...]]:
    """Return shares in cents, of which none is negative if all together gain."""
    worse = [
        plan.trips[vehicle].vehicle
        for vehicle, own in zip(vehicles, shares, strict=True)
        if own < -HALF_CENT
    ]
    remarks: tuple[str, ...] = ()
    if total >= 0:
        shares = none_worse_off(shares)
        if worse:
            remarks = (
                f"by the rule alone {listed(worse)} would be worse off; these are the nearest "
                "shares that leave nobody worse off",
            )
    elif worse:
        remarks = (f"all together lose, so {listed(worse)} must be worse off",)
    return in_cents(shares, total), remarks
