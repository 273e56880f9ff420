"""The fast engine: the searches of `ReferenceEngine`, on a contraction hierarchy."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ...network.road_network import RoadNetwork
from ..arguments import checked_labels, checked_nodes, checked_weight, no_route
from ..joining import Found, Positions
from .customization import Metric, customize
from .fused.members import best_on_route
from .fused.selection import selected_table
from .fused.shared_stretch import SharedStretch, shared_stretch
from .paths import ascended, path_between, path_from_labels
from .preparing.storage import topology_of
from .runtime.threads import cores
from .sweeping.batches import from_many
from .sweeping.sweeps import from_labels, from_one

__all__ = ["HierarchyEngine", "HierarchySeeded", "HierarchyTree"]

Floats = NDArray[np.float64]
Edges = NDArray[np.int64]


@dataclass(frozen=True, slots=True, eq=False)
class HierarchyTree:
    """Least costs between one place and all nodes; a path is found when it is asked for.

    Attributes
    ----------
    dist : (n,) cost from the root (forward) or to it (backward); inf if unreachable.
    """

    engine: HierarchyEngine
    root: int
    dist: Floats
    forward: bool

    @property
    def net(self) -> RoadNetwork:
        """The network searched."""
        return self.engine.net

    def path(self, node: int) -> Edges:
        """Return edge ids, in driving order, of the least-cost path to (or from) a node.

        Raises
        ------
        NoRouteError
            If the node cannot be reached.
        """
        ends = (self.root, node) if self.forward else (node, self.root)
        edges = self.engine._path(*ends)
        if edges is None:
            raise no_route(self.net, node, self.forward)
        return edges


@dataclass(slots=True, eq=False)
class HierarchySeeded:
    """Least costs from labelled nodes to all; paths are found when they are asked for.

    Attributes
    ----------
    dist : (n,) least label plus cost; inf if unreachable.
    """

    engine: HierarchyEngine
    labels: Floats
    dist: Floats
    forward: bool = True
    _climbed: tuple[Floats, NDArray[np.int32]] | None = field(default=None, repr=False)

    @property
    def net(self) -> RoadNetwork:
        """The network searched."""
        return self.engine.net

    def path(self, node: int) -> Edges:
        """Return edge ids, in driving order, of the best path to a node from any start.

        Raises
        ------
        NoRouteError
            If the node cannot be reached.
        """
        if not np.isfinite(self.dist[node]):
            raise no_route(self.net, node, True)
        if self._climbed is None:
            self._climbed = ascended(self.engine.metric, self.labels)
        return path_from_labels(
            self.net, self.engine.weight, self.engine.metric, self._climbed, node
        )


class HierarchyEngine:
    """Searches of one network under one weight, after some preparation.

    The order and the arcs of the hierarchy belong to the network and are kept with it; only the
    costs of the arcs are made anew for each weight. Edges of infinite weight are closed.

    Parameters
    ----------
    weight : (m,) costs, not negative and not NaN.
    threads : cores to use; by default all. Results do not depend on it.

    Raises
    ------
    ValueError
        A weight that is negative, NaN or of the wrong shape.
    """

    name = "hierarchy"

    def __init__(self, net: RoadNetwork, weight: ArrayLike, threads: int | None = None) -> None:
        # A copy, for paths are looked up under the weight that the arcs were made from.
        padded = np.empty(net.m + 1)
        padded[:-1] = checked_weight(net, weight)
        padded[-1] = np.inf
        self.weight = padded[:-1]
        self.net = net
        self.threads = cores() if threads is None else threads
        self.metric: Metric = customize(topology_of(net, self.threads), padded, self.threads)

    def distances(self, nodes: ArrayLike, forward: bool = True) -> Floats:
        """Return costs (k, n) from each of k nodes to all, or from all to each if not forward."""
        wanted = checked_nodes(self.net, nodes)
        if not len(wanted):
            return np.zeros((0, self.net.n))
        if len(wanted) == 1:
            return from_one(self.metric, int(wanted[0]), forward, self.threads)[None, :]
        return from_many(self.metric, wanted, forward, self.threads)

    def tree(self, node: int, forward: bool = True) -> HierarchyTree:
        """Return least costs from a node to all, or to it if not forward, with their paths."""
        root = int(checked_nodes(self.net, node)[0])
        dist = from_one(self.metric, root, forward, self.threads)
        return HierarchyTree(self, root, dist, forward)

    def trees(self, nodes: ArrayLike, forward: bool = True) -> list[HierarchyTree]:
        """Return the trees of several nodes, searched together."""
        wanted = checked_nodes(self.net, nodes).tolist()
        rows = self.distances(wanted, forward)
        return [
            HierarchyTree(self, node, row, forward) for node, row in zip(wanted, rows, strict=True)
        ]

    def seeded(self, labels: ArrayLike) -> HierarchySeeded:
        """Search forward from all nodes at once, node x starting at cost `labels[x]`.

        Parameters
        ----------
        labels : (n,) starting costs; inf where no path may start.
        """
        seeds = checked_labels(self.net, labels)
        return HierarchySeeded(self, seeds, from_labels(self.metric, seeds, self.threads))

    def many_to_many(self, sources: ArrayLike, targets: ArrayLike) -> Floats:
        """Return least costs (S, T) between sources and targets; inf where there is no way."""
        start, end = checked_nodes(self.net, sources), checked_nodes(self.net, targets)
        return selected_table(self.metric, start, end, True, self.threads)

    def one_to_many(self, source: int, targets: ArrayLike) -> Floats:
        """Return least costs (T,) from a source to targets."""
        row: Floats = self.many_to_many(source, targets)[0]
        return row

    def path(self, source: int, target: int) -> Edges:
        """Return the edges of a least-cost path.

        Raises
        ------
        NoRouteError
            If there is none.
        """
        start, end = (int(checked_nodes(self.net, node)[0]) for node in (source, target))
        edges = self._path(start, end)
        if edges is None:
            raise no_route(self.net, end, True)
        return edges

    def _path(self, source: int, target: int) -> Edges | None:
        return path_between(self.net, self.weight, self.metric, source, target)

    def shared_stretch(
        self,
        pair: ArrayLike,
        there: Sequence[Floats],
        onward: Sequence[Floats],
        limit: float,
        slack: float = 0.0,
    ) -> SharedStretch | HierarchySeeded:
        """Return the least costs of two that drive together; see `ReferenceEngine`."""
        weight = checked_weight(self.net, pair)
        found = shared_stretch(self.net, self.weight, weight, there, onward, limit, slack)
        if found is not None:
            return found
        return HierarchyEngine(self.net, weight, self.threads).seeded(there[0] + there[1])

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
        """Return where N members best join and leave a route; see `members.best_on_route`."""
        nodes, start, end = (
            checked_nodes(self.net, item) for item in (route, origins, destinations)
        )
        return best_on_route(
            self.metric, nodes, start, end, platoon, length_m, entries, exits, self.threads
        )
