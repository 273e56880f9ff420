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

from ...network.road_network import RoadNetwork
from ...search.changing_weights import ChangingWeights
from ..fleet import Fleet

__all__ = ["least_total"]

Floats = NDArray[np.float64]

ROUNDS = 2
MOST_ROWS = 200_000
"""Nodes times vehicles up to which the room for detours is looked at; beyond it is not."""

HAIR = 1e-11
"""Share of the total that sums of the same edges may differ by; the bound allows for it."""


def least_total(
    net: RoadNetwork,
    fleet: Fleet,
    ends: Sequence[tuple[int, int]],
    alone: Floats,
    cost: float,
) -> float:
    """Return a lower bound of the total cost of every plan for some trips.

    Parameters
    ----------
    net : RoadNetwork
        The network.
    fleet : Fleet
        What edges cost each vehicle, and where it may drive.
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
    known = {fleet.kind[k]: _least_of(fleet, k) for k in range(len(fleet))}
    least = [known[kind][0] for kind in fleet.kind]
    solo = [fleet.alone(k) for k in range(len(fleet))]
    bounds = alone * np.array([known[kind][1] for kind in fleet.kind])
    if len(ends) * net.n <= MOST_ROWS:
        own = list(least)
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
            own = [
                np.where(users - mine > 0, low, high)
                for mine, low, high in zip(can_be, least, solo, strict=True)
            ]
        search = net.attached(ChangingWeights).search
        there = [search(weight, start).dist for weight, (start, _) in zip(own, ends, strict=True)]
        bounds = np.maximum(bounds, [row[end] for row, (_, end) in zip(there, ends, strict=True)])
    return min(float(bounds.sum()) * (1 - HAIR), cost)


def _least_of(fleet: Fleet, vehicle: int) -> tuple[Floats, float]:
    """Return the least a vehicle may pay on each edge, and its least ratio to the cost alone."""
    weights = fleet[vehicle]
    least = np.minimum(weights.solo, np.minimum(weights.platoon, weights.master))
    with np.errstate(invalid="ignore", divide="ignore"):
        ratio = np.where(weights.solo > 0, least / weights.solo, 1.0).min(initial=1.0)
    return fleet.barred(vehicle, least), float(ratio)


def _both_ways(
    net: RoadNetwork, own: Sequence[Floats], ends: Sequence[tuple[int, int]]
) -> tuple[list[Floats], list[Floats]]:
    """Return least costs from each origin, and to each destination, under each one's weight."""
    search = net.attached(ChangingWeights).search
    pairs = list(zip(own, ends, strict=True))
    there = [search(weight, start).dist for weight, (start, _) in pairs]
    onward = [search(weight, end, forward=False).dist for weight, (_, end) in pairs]
    return there, onward
