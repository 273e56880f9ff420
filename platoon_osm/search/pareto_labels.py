"""Ways of two sums, such as cost and time: all of which none is better in both.

A label (c, t) at a node is a way there that costs c and takes t. Labels are taken in the order of
c, then t; a label is of use iff it is quicker than all that were taken at its node before, for
those cost no more. Weights are not negative, so what is taken is final (Martins 1984).

A label that cannot be part of a way of interest is dropped: with r(v) a lower bound of what is left
to pay from node v, p a price of time and L the limit, it needs c + p t + r(v) <= L, and t at most
the latest moment of v. With all times 0 one label a node is left, that of the least cost.
"""

from __future__ import annotations

import heapq
from collections.abc import Callable
from dataclasses import dataclass
from functools import cache
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..network.road_network import RoadNetwork

__all__ = ["HAIR_S", "Labels", "Roads", "Seeds"]

Floats = NDArray[np.float64]
Longs = NDArray[np.int64]

HAIR_S = 1e-9
"""A way quicker by less is not quicker: sums of the same times in another order [s]."""

MANY = 20_000
"""On networks of more nodes the compiled kernel is worth loading; the other takes longer there."""


@dataclass(frozen=True, slots=True, eq=False)
class Roads:
    """Edges as a search goes along them: by the node it comes from.

    Attributes
    ----------
    first : ndarray of int, (n + 1,)
        Where the edges of each node begin in `edges`.
    edges : ndarray of int, (m,)
        Edge ids.
    ends : ndarray of int, (m,)
        The node to which each of `edges` leads.
    """

    first: Longs
    edges: Longs
    ends: Longs

    @classmethod
    def onward(cls, net: RoadNetwork) -> Roads:
        """Return the edges of a network as they are driven.

        Parameters
        ----------
        net : RoadNetwork
            The network.

        Returns
        -------
        Roads
            From tails to heads.
        """
        return cls(net.first_out.astype(np.int64), np.arange(net.m), net.head.astype(np.int64))

    @classmethod
    def back(cls, net: RoadNetwork) -> Roads:
        """Return the edges of a network against the direction in which they are driven.

        Parameters
        ----------
        net : RoadNetwork
            The network.

        Returns
        -------
        Roads
            From heads to tails.
        """
        edges, first = net.incoming()
        return cls(first.astype(np.int64), edges.astype(np.int64), net.tail[edges].astype(np.int64))


@dataclass(frozen=True, slots=True, eq=False)
class Seeds:
    """Where ways may begin.

    Attributes
    ----------
    node : ndarray of int, (s,)
        Nodes; several seeds may share one.
    cost, time : ndarray of float, (s,)
        What is paid and what has passed there already.
    """

    node: Longs
    cost: Floats
    time: Floats

    @classmethod
    def at(cls, costs: Floats) -> Seeds:
        """Return a seed at each node that has a cost, at no time.

        Parameters
        ----------
        costs : ndarray of float, (n,)
            Inf where no way begins.

        Returns
        -------
        Seeds
            In the order of nodes.
        """
        node = np.flatnonzero(np.isfinite(costs))
        return cls(node, costs[node], np.zeros(len(node)))

    @classmethod
    def one(cls, node: int) -> Seeds:
        """Return a single seed that has cost nothing yet.

        Parameters
        ----------
        node : int
            Where all ways begin.

        Returns
        -------
        Seeds
            Of one.
        """
        return cls(np.array([node], np.int64), np.zeros(1), np.zeros(1))


@dataclass(frozen=True, slots=True, eq=False)
class Labels:
    """What a search has taken, in the order of cost.

    Attributes
    ----------
    node : ndarray of int, (k,)
        Where each label is.
    cost, time : ndarray of float, (k,)
        Its two sums.
    before : ndarray of int, (k,)
        The label that it continues, or -1 - s if it is seed s.
    edge : ndarray of int, (k,)
        The edge between the two; -1 for seeds.
    """

    node: Longs
    cost: Floats
    time: Floats
    before: Longs
    edge: Longs

    @classmethod
    def of(
        cls,
        roads: Roads,
        weights: tuple[Floats, Floats],
        seeds: Seeds,
        rest: Floats,
        latest: Floats,
        limit: float,
        price: float = 0.0,
    ) -> Labels:
        """Search from some seeds.

        Parameters
        ----------
        roads : Roads
            Which way to go.
        weights : tuple of ndarray of float, (2, m)
            Cost and time of each edge, 0 or more; inf where it is closed.
        seeds : Seeds
            Where ways begin.
        rest : ndarray of float, (n,)
            What is left to pay from each node at least.
        latest : ndarray of float, (n,)
            Until when a way may be at each node.
        limit : float
            Ways that must cost more are of no interest.
        price : float
            What a unit of time costs beside `weights`, where limits are looked at.

        Returns
        -------
        Labels
            All of use.
        """
        cost, time = weights
        search = _kernel(len(rest) > MANY)
        found = search(
            roads.first, roads.edges, roads.ends, cost, time, seeds.node, seeds.cost, seeds.time,
            rest, latest, float(limit), float(price), HAIR_S,
        )  # fmt: skip
        return cls(*found)

    def __len__(self) -> int:
        return len(self.node)

    def least(self, n: int) -> Floats:
        """Return the least cost at each node.

        Parameters
        ----------
        n : int
            How many nodes there are.

        Returns
        -------
        ndarray of float, (n,)
            Inf where no label is.
        """
        least = np.full(n, np.inf)
        least[self.node[::-1]] = self.cost[::-1]
        return least

    def by_node(self) -> dict[int, list[int]]:
        """Return the labels of each node.

        Returns
        -------
        dict of int to list of int
            Positions, the cheapest and slowest first.
        """
        found: dict[int, list[int]] = {}
        for label, node in enumerate(self.node.tolist()):
            found.setdefault(node, []).append(label)
        return found

    def traced(self, label: int) -> tuple[list[int], int]:
        """Return the edges between a label and its seed.

        Parameters
        ----------
        label : int
            Position.

        Returns
        -------
        edges : list of int
            The last one first; searched against the driving direction, that is the driving order.
        seed : int
            Position of the seed.
        """
        edges = []
        while self.before[label] >= 0:
            edges.append(int(self.edge[label]))
            label = int(self.before[label])
        return edges, -1 - int(self.before[label])


def _kernel(many: bool) -> Callable[..., Any]:
    """Return the search: compiled where it is loaded, or on networks that are worth waiting for it.

    It is the same text either way, so the same labels come of it.
    """
    loaded = compiled_search.cache_info().currsize > 0
    return compiled_search() if loaded or many else _search


@cache
def compiled_search() -> Callable[..., Any]:
    """Return the search as a compiled kernel.

    Returns
    -------
    callable
        The same for the same arguments.
    """
    from .hierarchy.runtime.jit import compiled

    return compiled(_search)


def _search(
    first: Longs, edges: Longs, ends: Longs, cost: Floats, time: Floats,
    seed_node: Longs, seed_cost: Floats, seed_time: Floats,
    rest: Floats, latest: Floats, limit: float, price: float, hair: float,
) -> tuple[Longs, Floats, Floats, Longs, Longs]:  # fmt: skip
    """Return node, cost, time, predecessor and edge of all labels of use, as they are taken."""
    # Heap of (cost, time, node, label before, edge): what is equal has an order too.
    heap = [(0.0, 0.0, 0, 0, 0) for _ in range(0)]
    for s in range(len(seed_node)):
        c, t, v = seed_cost[s], seed_time[s], seed_node[s]
        if c + price * t + rest[v] <= limit and t <= latest[v]:
            heap.append((c, t, v, -1 - s, -1))
    heapq.heapify(heap)
    quickest = np.full(len(rest), np.inf)
    node, costs, times = [0 for _ in range(0)], [0.0 for _ in range(0)], [0.0 for _ in range(0)]
    before, by = [0 for _ in range(0)], [0 for _ in range(0)]
    while len(heap) > 0:
        c, t, v, last, edge = heapq.heappop(heap)
        if t > quickest[v] - hair:
            continue
        quickest[v] = t
        label = len(node)
        node.append(v)
        costs.append(c)
        times.append(t)
        before.append(last)
        by.append(edge)
        for k in range(first[v], first[v + 1]):
            e, w = edges[k], ends[k]
            c2, t2 = c + cost[e], t + time[e]
            if t2 <= latest[w] and t2 <= quickest[w] - hair and c2 + price * t2 + rest[w] <= limit:
                heapq.heappush(heap, (c2, t2, w, label, e))
    return (
        np.array(node, np.int64), np.array(costs, np.float64), np.array(times, np.float64),
        np.array(before, np.int64), np.array(by, np.int64),
    )  # fmt: skip
