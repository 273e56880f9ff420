"""The fast engine: the searches of `ReferenceEngine`, on a contraction hierarchy."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ...errors import SearchError
from ...network.road_network import RoadNetwork
from ..arguments import (
    checked_along,
    checked_labels,
    checked_network,
    checked_node,
    checked_nodes,
    checked_pairs,
    checked_positions,
    checked_two,
    checked_weight,
    described,
)  # fmt: skip
from ..joining import Found, Positions
from ..least_paths import LeastCosts
from .customization import Metric, customize
from .fused.members import best_on_route
from .fused.selection import selected_table
from .fused.shared_stretch import shared_stretch
from .preparing.storage import topology_of
from .runtime.threads import cores
from .sweeping.batches import from_many
from .sweeping.sweeps import from_labels, from_one

__all__ = ["HierarchyEngine"]

Floats = NDArray[np.float64]
Edges = NDArray[np.int64]


class HierarchyEngine:
    """Searches of one network under one weight, after some preparation.

    The order and the arcs of the hierarchy belong to the network and are kept with it; only the
    costs of the arcs are made anew for each weight. Edges of infinite weight are closed.

    Parameters
    ----------
    net : RoadNetwork
        The network searched.
    weight : array_like of float, (m,)
        Cost of each edge, 0 or more; inf where closed.
    threads : int, optional
        Cores to use; by default all. Results do not depend on it.

    Attributes
    ----------
    net : RoadNetwork
        The network searched.
    weight : ndarray of float, (m,)
        A copy of the costs.
    threads : int
        Cores used.
    metric : Metric
        The costs of the arcs.

    Raises
    ------
    SearchError
        A weight that is negative, NaN or of the wrong shape.
    """

    name = "hierarchy"

    def __init__(self, net: RoadNetwork, weight: ArrayLike, threads: int | None = None) -> None:
        self.net = checked_network(net)
        # A copy, for paths are chosen under the weight that the arcs were made from.
        padded = np.empty(net.m + 1)
        padded[:-1] = checked_weight(net, weight)
        padded[-1] = np.inf
        self.weight: Floats = padded[:-1]
        if threads is not None and not (isinstance(threads, int) and threads >= 1):
            raise SearchError(f"threads is {described(threads)}; give 1 or more, or None for all")
        self.threads = cores() if threads is None else threads
        self.metric: Metric = customize(topology_of(net, self.threads), padded, self.threads)

    def distances(self, nodes: ArrayLike, forward: bool = True) -> Floats:
        """Return least costs from some nodes to all, or from all to these.

        Parameters
        ----------
        nodes : array_like of int, (k,)
            Nodes searched from.
        forward : bool
            Whether paths start at the nodes; else they end there.

        Returns
        -------
        ndarray of float, (k, n)
            Costs; inf where there is no way.
        """
        wanted = checked_nodes(self.net, nodes)
        if not len(wanted):
            return np.zeros((0, self.net.n))
        if len(wanted) == 1:
            return from_one(self.metric, int(wanted[0]), forward, self.threads)[None, :]
        return from_many(self.metric, wanted, forward, self.threads)

    def tree(self, node: int, forward: bool = True) -> LeastCosts:
        """Return least costs from a node to all, or to it if not forward, and their paths.

        Parameters
        ----------
        node : int
            Node searched from.
        forward : bool
            Whether paths start at the node; else they end there.

        Returns
        -------
        LeastCosts
            Costs of all nodes; paths are found when they are asked for.
        """
        root = checked_node(self.net, node)
        dist = from_one(self.metric, root, forward, self.threads)
        return LeastCosts(self.net, self.weight, dist, root, forward=bool(forward))

    def trees(self, nodes: ArrayLike, forward: bool = True) -> list[LeastCosts]:
        """Return the trees of several nodes, searched together.

        Parameters
        ----------
        nodes : array_like of int, (k,)
            Nodes searched from.
        forward : bool
            Whether paths start at the nodes; else they end there.

        Returns
        -------
        list of LeastCosts
            One a node.
        """
        wanted = checked_nodes(self.net, nodes)
        rows = self.distances(wanted, forward)
        return [
            LeastCosts(self.net, self.weight, row, node, forward=bool(forward))
            for node, row in zip(wanted.tolist(), rows, strict=True)
        ]

    def seeded(self, labels: ArrayLike) -> LeastCosts:
        """Search forward from all nodes at once, each starting at a cost of its own.

        Parameters
        ----------
        labels : array_like of float, (n,)
            Starting costs; inf where no path may start.

        Returns
        -------
        LeastCosts
            Costs of all nodes; a path is empty where it is best to start at the node itself.
        """
        seeds = checked_labels(self.net, labels).copy()
        dist = from_labels(self.metric, seeds, self.threads)
        return LeastCosts(self.net, self.weight, dist, labels=(seeds,))

    def many_to_many(self, sources: ArrayLike, targets: ArrayLike) -> Floats:
        """Return least costs between sources and targets.

        Parameters
        ----------
        sources : array_like of int, (S,)
            Nodes where paths start.
        targets : array_like of int, (T,)
            Nodes where they end.

        Returns
        -------
        ndarray of float, (S, T)
            Costs; inf where there is no way.
        """
        start, end = checked_nodes(self.net, sources), checked_nodes(self.net, targets)
        return selected_table(self.metric, start, end, True, self.threads)

    def one_to_many(self, source: int, targets: ArrayLike) -> Floats:
        """Return least costs from a source to targets.

        Parameters
        ----------
        source : int
            Node where paths start.
        targets : array_like of int, (T,)
            Nodes where they end.

        Returns
        -------
        ndarray of float, (T,)
            Costs; inf where there is no way.
        """
        row: Floats = self.many_to_many(checked_node(self.net, source), targets)[0]
        return row

    def path(self, source: int, target: int) -> Edges:
        """Return the edges of the least-cost path, chosen as `least_paths` says.

        Parameters
        ----------
        source : int
            Node where the path starts.
        target : int
            Node where it ends.

        Returns
        -------
        ndarray of int, (k,)
            Edge ids in driving order.

        Raises
        ------
        NoRouteError
            If there is none.
        """
        return self.tree(source).path(target)

    def shared_stretch(
        self,
        pair: ArrayLike,
        there: Sequence[Floats],
        onward: Sequence[Floats],
        limit: float,
        slack: float = 0.0,
    ) -> LeastCosts:
        """Return least costs of two vehicles that meet, and drive together, up to each node.

        Parameters
        ----------
        pair : array_like of float, (m,)
            Cost of each edge for both together.
        there : sequence of array_like of float, (n,)
            Of either vehicle the costs alone, under this engine's weight, from its origin.
        onward : sequence of array_like of float, (n,)
            Of either vehicle the costs alone to its destination.
        limit : float
            Costs are exact at every node that a plan passes or parts at which costs at most this;
            elsewhere they may be inf.
        slack : float
            The same of plans that cost at most so much more than the best.

        Returns
        -------
        LeastCosts
            Costs of both; a path is what they drive together.
        """
        weight = checked_weight(self.net, pair, "pair")
        start = checked_two(self.net, there, "there", values=False)
        rest = checked_two(self.net, onward, "onward", values=False)
        dist = shared_stretch(self.net, self.weight, weight, start, rest, limit, slack)
        if dist is not None:
            return LeastCosts(self.net, weight, dist, labels=tuple(start))
        return HierarchyEngine(self.net, weight, self.threads).seeded(start[0] + start[1])

    def best_on_route(
        self,
        route: Edges,
        origins: Edges,
        destinations: Edges,
        platoon: Floats,
        length_m: Floats,
        entries: Positions | None = None,
        exits: Positions | None = None,
    ) -> Found:
        """Return for N members the best positions i < j on a route, and what they cost.

        Parameters
        ----------
        route : array_like of int, (K + 1,)
            Nodes of the route.
        origins : array_like of int, (N,)
            Nodes where members start.
        destinations : array_like of int, (N,)
            Nodes where they go.
        platoon : array_like of float, (K + 1,)
            Platoon weight along the route up to each node.
        length_m : array_like of float, (K + 1,)
            Metres along the route up to each node.
        entries : tuple of array_like of int, optional
            Positions where each member may join, as first (N + 1,) and positions; by default all.
        exits : tuple of array_like of int, optional
            Positions where each member may leave, likewise.

        Returns
        -------
        i : ndarray of int, (N,)
            Positions where they join; -1 where staying alone is cheaper.
        j : ndarray of int, (N,)
            Positions where they leave; -1 likewise.
        cost : ndarray of float, (N,)
            What each pays.
        solo : ndarray of float, (N,)
            What each pays alone.
        """
        nodes = checked_nodes(self.net, route)
        start, end = checked_pairs(self.net, origins, destinations)
        along = checked_along(nodes, platoon, "platoon")
        metres = checked_along(nodes, length_m, "length_m")
        join = checked_positions(nodes, len(start), entries, "entries")
        part = checked_positions(nodes, len(start), exits, "exits")
        return best_on_route(
            self.metric, nodes, start, end, along, metres, join, part, self.threads
        )
