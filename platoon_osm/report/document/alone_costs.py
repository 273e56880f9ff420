"""What vehicles would pay alone, for plans of older versions that do not tell it.

Plans of today hold it with each share. Those of older versions do where the paper's preset tells;
for other costs the weights that they were made with can be handed in.
"""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np

from ...costs.weights import EdgeWeights
from ...errors import ScenarioError
from ...network.road_network import RoadNetwork
from ...plans.plan import Plan
from ...plans.records import Span, Stretch

__all__ = ["with_alone_costs"]

SAME_COST = 1e-6


def with_alone_costs(plan: Plan, net: RoadNetwork, weights: EdgeWeights | None = None) -> Plan:
    """Return a plan that tells what its stretches would cost alone, as far as that is known.

    Parameters
    ----------
    plan : Plan
        The plan.
    net : RoadNetwork
        The network it was made on.
    weights : EdgeWeights or None
        Those it was made with, if at hand.

    Returns
    -------
    Plan
        The same plan if it tells already, or nothing is handed in.

    Raises
    ------
    ScenarioError
        What is handed in are no weights, or do not give the costs of the plan.
    """
    if weights is None:
        return plan
    if not isinstance(weights, EdgeWeights):
        raise ScenarioError(
            "report: the weights are none; hand in those the plan was made with, or None"
        )
    if not _gives_the_costs(weights, plan, net):
        raise ScenarioError(
            "report: the weights do not give the costs in the plan; hand in those it was "
            "made with, or none"
        )
    if all(share.alone_cost is not None for one in plan.stretches for share in one.shares):
        return plan
    return replace(plan, stretches=tuple(_told(one, weights) for one in plan.stretches))


def _told(stretch: Stretch, weights: EdgeWeights) -> Stretch:
    if stretch.access is not None:
        return stretch
    alone = _sum(weights, stretch.edges, stretch.span)
    shares = tuple(replace(share, alone_cost=alone) for share in stretch.shares)
    return replace(stretch, shares=shares)


def _gives_the_costs(weights: EdgeWeights, plan: Plan, net: RoadNetwork) -> bool:
    if weights.unit != plan.unit or len(weights.solo) != net.m:
        return False
    # What a way beside the road costs is not told by the weights of edges.
    told = [
        (alone.edges, alone.span, alone.cost)
        for alone in (trip.alone for trip in plan.trips)
        if not any(alone.access)
    ]
    told += [
        (one.edges, one.span, one.shares[0].cost)
        for one in plan.stretches
        if not one.together and one.access is None
    ]
    return all(
        math.isclose(_sum(weights, edges, span), cost, rel_tol=SAME_COST, abs_tol=1e-9)
        for edges, span, cost in told
    )


def _sum(weights: EdgeWeights, edges: tuple[int, ...], span: Span) -> float:
    costs = weights.solo[np.asarray(edges, np.int64)]
    whole = float(costs.sum())
    return whole - span[0] * float(costs[0]) - (1 - span[1]) * float(costs[-1])
