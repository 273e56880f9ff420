"""Solo routes by the two named methods: Dijkstra, and the paper's inflated A*."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Literal

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..costs.fatigue import fatigue_heuristic
from ..network.geodesy import distance_m
from ..network.road_network import RoadNetwork
from ..search.dijkstra import ReferenceEngine, Tree, astar

__all__ = ["AstarRouter", "DijkstraRouter", "Method", "Router"]

Method = Literal["dijkstra", "astar"]
Edges = NDArray[np.int64]
Floats = NDArray[np.float64]


@dataclass(slots=True)
class DijkstraRouter:
    """Exact routes and costs alone; trees are kept, for a plan asks for the same ones again."""

    engine: ReferenceEngine
    _trees: dict[tuple[int, bool], Tree] = field(default_factory=dict)

    def tree(self, node: int, forward: bool) -> Tree:
        """Return the tree of least-cost paths from a node, or to it."""
        key = (int(node), forward)
        if key not in self._trees:
            self._trees[key] = self.engine.tree(*key)
        return self._trees[key]

    def distances(self, nodes: ArrayLike, forward: bool = True) -> Floats:
        """Return costs (k, n), as `ReferenceEngine.distances`."""
        return self.engine.distances(nodes, forward)

    def route(self, origin: int, destination: int, backward: bool = False) -> Edges:
        """Return the edges of a least-cost route.

        Parameters
        ----------
        backward : take it from the tree to the destination instead of that from the origin; of
            equal routes the two may differ.
        """
        if backward:
            return self.tree(destination, forward=False).path(origin)
        return self.tree(origin, forward=True).path(destination)

    def cost(self, origin: int, destination: int) -> float:
        """Return the least cost; inf if there is no route."""
        return float(self.tree(origin, forward=True).dist[destination])


class AstarRouter:
    """Routes by the paper's inflated A*; costs are those of the routes it finds.

    Parameters
    ----------
    master_cost : travel cost of the master, which scales the heuristic.
    speed_mps : cruising speed of the estimated time to the goal.
    """

    def __init__(
        self,
        net: RoadNetwork,
        weight: NDArray[np.float64],
        master_cost: float,
        speed_mps: float,
    ) -> None:
        self._net = net
        self._weight = weight
        self._master_cost = master_cost
        self._speed_mps = speed_mps
        self._heuristics: dict[int, Floats] = {}
        self._found: dict[tuple[int, int], tuple[float, Edges]] = {}

    def _search(self, origin: int, destination: int) -> tuple[float, Edges]:
        key = (int(origin), int(destination))
        if key not in self._found:
            goal = key[1]
            if goal not in self._heuristics:
                net = self._net
                away = distance_m(net.lon, net.lat, net.lon[goal], net.lat[goal])
                self._heuristics[goal] = fatigue_heuristic(away, self._master_cost, self._speed_mps)
            self._found[key] = astar(self._net, self._weight, *key, self._heuristics[goal])
        return self._found[key]

    def route(self, origin: int, destination: int, backward: bool = False) -> Edges:
        """Return the edges of the route A* finds; `backward` changes nothing here."""
        del backward
        return self._search(origin, destination)[1]

    def cost(self, origin: int, destination: int) -> float:
        """Return the cost of the route A* finds; inf if there is none."""
        return self._search(origin, destination)[0]


Router = DijkstraRouter | AstarRouter
