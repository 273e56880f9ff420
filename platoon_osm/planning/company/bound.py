"""What no plan can undercut, whatever its routes, masters and companies.

No vehicle pays less on an edge than w = min(w_I, w_P, w_master), so each pays at least its least
cost under w. A plan no dearer than the one at hand leaves each vehicle little room for detours:
u can be on edge e only if its least cost under w by way of e, with the least costs of all others,
does not exceed that plan. Where nobody else can be, a vehicle pays w_I. With these weights the
least costs rise, and the room shrinks; twice is enough. Clocks, largest platoons and the condition
that nobody may lose only forbid plans, so the bound holds with them.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from ...costs.weights import EdgeWeights
from ...network.road_network import RoadNetwork
from ...search.changing_weights import ChangingWeights

__all__ = ["least_total"]

Floats = NDArray[np.float64]

ROUNDS = 2
MOST_ROWS = 200_000
"""Nodes times vehicles up to which the room for detours is looked at; beyond it is not."""

HAIR = 1e-11
"""Share of the total that sums of the same edges may differ by; the bound allows for it."""


def least_total(
    net: RoadNetwork,
    weights: EdgeWeights,
    ends: Sequence[tuple[int, int]],
    alone: Floats,
    cost: float,
) -> float:
    """Return a lower bound of the total cost of every plan for some trips.

    Parameters
    ----------
    net : RoadNetwork
        The network.
    weights : EdgeWeights
        What edges cost.
    ends : sequence of tuple of int, (N, 2)
        Nodes where each starts and ends.
    alone : ndarray of float, (N,)
        Least cost of each alone.
    cost : float
        Of a plan that is known.

    Returns
    -------
    float
        At most `cost`.
    """
    if len(ends) < 2:
        return float(alone.sum())
    least = np.minimum(weights.solo, np.minimum(weights.platoon, weights.master))
    with np.errstate(invalid="ignore", divide="ignore"):
        ratio = np.where(weights.solo > 0, least / weights.solo, 1.0).min(initial=1.0)
    bounds = alone * float(ratio)
    if len(ends) * net.n <= MOST_ROWS:
        own = [least] * len(ends)
        for _ in range(ROUNDS):
            there, onward = _both_ways(net, own, ends)
            bounds = np.maximum(
                bounds, [row[end] for row, (_, end) in zip(there, ends, strict=True)]
            )
            room = cost - float(bounds.sum()) + HAIR * abs(cost)
            can_be = np.array(
                [
                    row[net.tail] + weight + back[net.head] <= bound + room
                    for row, back, weight, bound in zip(there, onward, own, bounds, strict=True)
                ]
            )
            users = can_be.sum(axis=0)
            own = [np.where(users - mine > 0, least, weights.solo) for mine in can_be]
        search = net.attached(ChangingWeights).search
        there = [search(weight, start).dist for weight, (start, _) in zip(own, ends, strict=True)]
        bounds = np.maximum(bounds, [row[end] for row, (_, end) in zip(there, ends, strict=True)])
    return min(float(bounds.sum()) * (1 - HAIR), cost)


def _both_ways(
    net: RoadNetwork, own: Sequence[Floats], ends: Sequence[tuple[int, int]]
) -> tuple[list[Floats], list[Floats]]:
    """Return least costs from each origin, and to each destination, under each one's weight."""
    search = net.attached(ChangingWeights).search
    pairs = list(zip(own, ends, strict=True))
    there = [search(weight, start).dist for weight, (start, _) in pairs]
    onward = [search(weight, end, forward=False).dist for weight, (_, end) in pairs]
    return there, onward
