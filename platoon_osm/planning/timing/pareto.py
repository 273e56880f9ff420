"""Ways of one vehicle between an end of its trip and the routes of others, cheap or quick.

Where the cheapest way to every node is also the quickest, it is the only one that counts. This is
so iff every node has an edge by which it is reached at least cost and in least time at once, for
then such edges lead back to the root. One search by time tells. Else all ways are found of which
none is both cheaper and quicker (`pareto_kernel.py`), as far as they can pay and be in time.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ...network.road_network import RoadNetwork
from ...search.tie_rule import TIE
from .kernels import PARETO_LABELS

__all__ = ["Budget", "Labels", "Reach", "is_cheap_quick", "labels_of"]

Floats = NDArray[np.float64]
Longs = NDArray[np.int64]
Marks = NDArray[np.bool_]
Ends = NDArray[np.int32]

SAME_S = 1e-6
"""Driving times that differ by less are equal [s]."""

MOST_LABELS = 1_000_000
"""Labels of one search after which it gives up; the ways found till then are used."""

LABEL_S = 2e-5
"""About what a label takes as the kernel stands [s]."""

AT_LEAST = 1 - 1e-9
"""Lower bounds are lowered by this, so that last digits of sums forbid nothing."""


@dataclass(frozen=True, slots=True, eq=False)
class Reach:
    """Least costs and times between one node and all others.

    Attributes
    ----------
    root : int
        The node.
    cost, time_s : ndarray of float, (n,)
        From the root to each node, or from each to the root; inf where there is no way.
    """

    root: int
    cost: Floats
    time_s: Floats


@dataclass(frozen=True, slots=True, eq=False)
class Budget:
    """What a way may cost and take in all, with what must follow it at least.

    Attributes
    ----------
    cost, time_s : float
        Of the whole.
    cost_left, time_left : ndarray of float, (n,)
        What remains from each node at least.
    """

    cost: float
    time_s: float
    cost_left: Floats
    time_left: Floats

    @classmethod
    def of(cls, cost: float, time_s: float, rest: Reach, least_share: float) -> Budget:
        """Return the budget of a trip, from what remains to its other end.

        Parameters
        ----------
        cost, time_s : float
            What it may cost and take.
        rest : Reach
            Of the other end, alone.
        least_share : float
            The least share of the cost alone at which an edge can be driven; 0 if not known.

        Returns
        -------
        Budget
            What remains costs at least that share of the least cost alone.
        """
        left = rest.cost.copy()
        left[np.isfinite(left)] *= least_share * AT_LEAST
        return cls(cost, time_s, left, rest.time_s)

    def within(self, reach: Reach) -> Marks:
        """Mark the nodes by which a trip can pay and be in time.

        Parameters
        ----------
        reach : Reach
            Of the end from which ways are looked for.

        Returns
        -------
        ndarray of bool, (n,)
            Others are of no interest.
        """
        found: Marks = (
            (reach.cost + self.cost_left <= self.cost)
            & (reach.time_s + self.time_left <= self.time_s + SAME_S)
            & np.isfinite(reach.cost)
        )
        return found


def is_cheap_quick(
    net: RoadNetwork, weight: Floats, drive_s: Floats, reach: Reach, some: Marks, forward: bool
) -> bool:
    """Tell whether a cheapest way to each of some nodes is also a quickest.

    Parameters
    ----------
    net : RoadNetwork
        The network.
    weight, drive_s : ndarray of float, (m,)
        Cost, inf where closed, and driving time [s] of each edge.
    reach : Reach
        Least costs and times.
    some : ndarray of bool, (n,)
        The nodes; with each also those on its cheapest ways.
    forward : bool
        Whether ways lead from the root.

    Returns
    -------
    bool
        False also where edges of no length leave it open.
    """
    start, stop = (net.tail, net.head) if forward else (net.head, net.tail)
    good = _both_least(weight, drive_s, reach, start, stop)
    reached = np.zeros(net.n, bool)
    reached[stop[good]] = True
    reached[reach.root] = True
    return bool(reached[some].all())


def _both_least(weight: Floats, drive_s: Floats, reach: Reach, start: Ends, stop: Ends) -> Marks:
    """Mark edges by which a node is reached at least cost and in least time."""
    with np.errstate(invalid="ignore"):
        cheap = reach.cost[start] + weight <= reach.cost[stop] * (1 + TIE)
        quick = reach.time_s[start] + drive_s <= reach.time_s[stop] + SAME_S / 10
    found: Marks = cheap & quick & np.isfinite(weight) & (weight > 0) & (drive_s > 0)
    return found


@dataclass(frozen=True, slots=True, eq=False)
class Labels:
    """Ways from a root, or to it, of which none is both cheaper and quicker.

    Attributes
    ----------
    node : ndarray of int, (L,)
        Where each ends, or starts; ascending, and those of one node by rising cost.
    cost, time_s : ndarray of float, (L,)
        What each costs and takes [s].
    before, by : ndarray of int, (L,)
        The label that each came from, and the edge; -1 at the root.
    forward : bool
        Whether ways lead from the root.
    complete : bool
        Whether these are all that can pay and be in time.
    """

    node: Longs
    cost: Floats
    time_s: Floats
    before: Longs
    by: Longs
    forward: bool
    complete: bool

    def at(self, nodes: Longs) -> tuple[Longs, Floats, Floats]:
        """Return the ways to some nodes.

        Parameters
        ----------
        nodes : ndarray of int, (k,)
            Nodes, in any order.

        Returns
        -------
        position : ndarray of int, (W,)
            In `nodes`, ascending.
        cost, time_s : ndarray of float, (W,)
            Costs and times.
        """
        low = np.searchsorted(self.node, nodes, "left")
        count = np.searchsorted(self.node, nodes, "right") - low
        position = np.repeat(np.arange(len(nodes)), count)
        begin = np.repeat(low - np.concatenate([[0], np.cumsum(count)[:-1]]), count)
        rows = begin + np.arange(len(position))
        return position, self.cost[rows], self.time_s[rows]

    def route(self, node: int, time_s: float) -> Longs:
        """Return the cheapest way that takes no longer.

        Parameters
        ----------
        node : int
            Where it ends, or starts.
        time_s : float
            How long it may take [s]; that of one of the ways.

        Returns
        -------
        ndarray of int, (k,)
            Edge ids in driving order.
        """
        low, high = np.searchsorted(self.node, [node, node + 1])
        quick = np.flatnonzero(self.time_s[low:high] <= time_s + SAME_S)
        label = int(low + quick[0])
        found: list[int] = []
        while self.before[label] >= 0:
            found.append(int(self.by[label]))
            label = int(self.before[label])
        return np.array(found[::-1] if self.forward else found, np.int64)


def labels_of(
    net: RoadNetwork, weight: Floats, drive_s: Floats, reach: Reach, budget: Budget, forward: bool
) -> Labels:
    """Return all ways from a node, or to it, that can pay and be in time.

    Parameters
    ----------
    net : RoadNetwork
        The network.
    weight, drive_s : ndarray of float, (m,)
        Cost, inf where closed, and driving time [s] of each edge.
    reach : Reach
        Of the root.
    budget : Budget
        What trips may cost and take.
    forward : bool
        Whether ways lead from the root.

    Returns
    -------
    Labels
        None of them both cheaper and quicker than another to the same node.
    """
    edges, first = (np.arange(net.m), net.first_out) if forward else net.incoming()
    other = net.head if forward else net.tail
    kernel = PARETO_LABELS.ready(int(budget.within(reach).sum()) * LABEL_S)
    node, cost, time_s, before, by, complete = kernel(
        np.asarray(first, np.int64), np.asarray(edges, np.int64), np.asarray(other, np.int64),
        np.asarray(weight, np.float64), np.asarray(drive_s, np.float64), int(reach.root),
        budget.cost_left, budget.time_left, float(budget.cost), float(budget.time_s + SAME_S),
        MOST_LABELS,
    )  # fmt: skip
    order = np.argsort(node, kind="stable")
    place = np.empty(len(order), np.int64)
    place[order] = np.arange(len(order))
    came = before[order]
    return Labels(
        node[order], cost[order], time_s[order],
        np.where(came >= 0, place[came], -1) if len(order) else came,
        by[order], forward, bool(complete),
    )  # fmt: skip
