"""Solo routes by the named methods: Dijkstra, and the paper's inflated A* in two readings."""

from __future__ import annotations

from typing import Literal, Protocol

import numpy as np
from numpy.typing import NDArray

from ..costs.fatigue import fatigue_heuristic
from ..errors import ScenarioError, brief
from ..network.geodesy import distance_m
from ..network.road_network import RoadNetwork
from ..search.astar import astar
from ..search.trees import Trees

__all__ = ["AstarRouter", "DijkstraRouter", "Method", "Router"]

Method = Literal["dijkstra", "astar", "astar-closed-once"]
"""Dijkstra; the paper's A* as printed, which opens a node again once a cheaper way to it is found;
and A* with each node explored once, as often programmed."""

Edges = NDArray[np.int64]
Floats = NDArray[np.float64]


class Router(Protocol):
    """What the planner asks of a method: routes alone, and what they cost."""

    def route(self, origin: int, destination: int) -> Edges:
        """Return the edges of the route between two nodes.

        Parameters
        ----------
        origin, destination : int
            Nodes.

        Returns
        -------
        ndarray of int, (k,)
            Edge ids in driving order.
        """
        ...

    def table(self, origins: Edges, destinations: Edges) -> Floats:
        """Return the costs of routes between nodes.

        Parameters
        ----------
        origins, destinations : ndarray of int, (S,), (T,)
            Nodes.

        Returns
        -------
        ndarray of float, (S, T)
            Costs; inf where there is no route.
        """
        ...


class DijkstraRouter:
    """Exact routes and costs alone.

    Parameters
    ----------
    trees : Trees
        Searches under the solo weight; each is made once, whoever asks.
    """

    def __init__(self, trees: Trees) -> None:
        self.trees = trees

    def route(self, origin: int, destination: int) -> Edges:
        """Return the edges of the least-cost route between two nodes.

        Parameters
        ----------
        origin, destination : int
            Nodes.

        Returns
        -------
        ndarray of int, (k,)
            Edge ids in driving order; which of equal routes, says `search.least_paths`.
        """
        return self.trees.path(origin, destination)

    def table(self, origins: Edges, destinations: Edges) -> Floats:
        """Return the least costs between nodes.

        Parameters
        ----------
        origins, destinations : ndarray of int, (S,), (T,)
            Nodes.

        Returns
        -------
        ndarray of float, (S, T)
            Costs; inf where there is no route.
        """
        return self.trees.table(origins, destinations)


class AstarRouter:
    """Routes by the paper's inflated A*; costs are those of the routes it finds.

    Parameters
    ----------
    net : RoadNetwork
        The network.
    weight : ndarray of float, (m,)
        Cost of each edge alone.
    master_cost : float
        Travel cost of the master, which scales the heuristic.
    speed_mps : float
        Cruising speed of the estimated time to the goal [m/s].
    method : {"astar", "astar-closed-once"}
        Whether a node is opened again once a cheaper way to it is found, as the paper has it, or
        is explored once.

    Raises
    ------
    ScenarioError
        No method by A*.
    """

    def __init__(
        self,
        net: RoadNetwork,
        weight: Floats,
        master_cost: float,
        speed_mps: float,
        method: Method = "astar",
    ) -> None:
        if method not in ("astar", "astar-closed-once"):
            raise ScenarioError(f"method {brief(method)} is no A*; use astar or astar-closed-once")
        self._reopen = method == "astar"
        self._net = net
        self._weight = weight
        self._master_cost = master_cost
        self._speed_mps = speed_mps
        self._heuristics: dict[int, Floats] = {}
        self._found: dict[tuple[int, int], tuple[float, Edges]] = {}

    def _search(self, origin: int, destination: int) -> tuple[float, Edges]:
        key = (int(origin), int(destination))
        if key not in self._found:
            net, goal = self._net, key[1]
            if goal not in self._heuristics:
                away = distance_m(net.lon, net.lat, net.lon[goal], net.lat[goal])
                self._heuristics[goal] = fatigue_heuristic(away, self._master_cost, self._speed_mps)
            heuristic = self._heuristics[goal]
            self._found[key] = astar(net, self._weight, *key, heuristic, self._reopen)
        return self._found[key]

    def route(self, origin: int, destination: int) -> Edges:
        """Return the edges of the route A* finds.

        Parameters
        ----------
        origin, destination : int
            Nodes.

        Returns
        -------
        ndarray of int, (k,)
            Edge ids in driving order.
        """
        return self._search(origin, destination)[1]

    def cost(self, origin: int, destination: int) -> float:
        """Return the cost of the route A* finds.

        Parameters
        ----------
        origin, destination : int
            Nodes.

        Returns
        -------
        float
            Its cost; inf if there is none.
        """
        return self._search(origin, destination)[0]

    def table(self, origins: Edges, destinations: Edges) -> Floats:
        """Return the costs of the routes A* finds between nodes.

        Parameters
        ----------
        origins, destinations : ndarray of int, (S,), (T,)
            Nodes.

        Returns
        -------
        ndarray of float, (S, T)
            Costs; inf where there is none.
        """
        rows = [[self.cost(o, d) for d in destinations] for o in origins]
        return np.array(rows, np.float64).reshape(len(origins), len(destinations))
