"""What a stretch of road would cost a vehicle alone, where that is known and not guessed."""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from ...costs.weights import EdgeWeights, paper_weights
from ...errors import ScenarioError
from ...network.road_network import RoadNetwork
from ...plans.records import JointPlan

__all__ = ["known_weights", "sum_over"]

SAME_COST = 1e-6


def known_weights(
    plan: JointPlan, net: RoadNetwork, weights: EdgeWeights | None = None
) -> EdgeWeights | None:
    """Return the edge weights that a plan was made with.

    The paper's preset is made again from the parameters in the plan; other weights must be handed
    in. Either is believed only if it gives back the costs in the plan.

    Parameters
    ----------
    plan : JointPlan
        The plan.
    net : RoadNetwork
        The network it was made on.
    weights : EdgeWeights or None
        Those it was made with, if at hand.

    Returns
    -------
    EdgeWeights or None
        None if they cannot be told.

    Raises
    ------
    ScenarioError
        What is handed in are no weights, or do not give the costs of the plan.
    """
    if weights is not None:
        if not isinstance(weights, EdgeWeights):
            raise ScenarioError(
                "report: the weights are none; hand in those the plan was made with, or None"
            )
        if not _gives_the_costs(weights, plan, net):
            raise ScenarioError(
                "report: the weights do not give the costs in the plan; hand in those it was "
                "made with, or none"
            )
        return weights
    params = dict(plan.params)
    if params.pop("preset", None) != "paper":
        return None
    try:
        made = paper_weights(net, **params)
    except (ScenarioError, TypeError):
        return None
    return made if _gives_the_costs(made, plan, net) else None


def _gives_the_costs(weights: EdgeWeights, plan: JointPlan, net: RoadNetwork) -> bool:
    if weights.unit != plan.unit or len(weights.solo) != net.m:
        return False
    return all(
        math.isclose(sum_over(weights.solo, leg.edges), leg.cost, rel_tol=SAME_COST, abs_tol=1e-9)
        for vehicle in plan.vehicles
        for leg in (vehicle.alone, *(leg for leg in vehicle.legs if leg.role != "platoon"))
    )


def sum_over(values: NDArray[np.float64], edges: tuple[int, ...]) -> float:
    """Return the sum of an edge array over a path.

    Parameters
    ----------
    values : array of float, (m,)
        One for each edge.
    edges : tuple of int
        The path.

    Returns
    -------
    float
        In the unit of the array; 0 without edges.
    """
    return float(values[np.asarray(edges, np.int64)].sum()) if edges else 0.0
