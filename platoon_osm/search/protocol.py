"""What a search engine does, whichever it is: the contract of both."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Literal, Protocol

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..network.road_network import RoadNetwork
from .joining import Found, Positions
from .least_paths import LeastCosts

__all__ = ["Engine", "EngineName", "LeastCosts"]

Floats = NDArray[np.float64]
Longs = NDArray[np.int64]
EngineName = Literal["auto", "reference", "hierarchy"]


class Engine(Protocol):
    """Searches of one network under one weight; see `ReferenceEngine` for each method."""

    net: RoadNetwork
    weight: Floats

    @property
    def name(self) -> str:
        """Either "reference" or "hierarchy"."""
        ...

    def distances(self, nodes: ArrayLike, forward: bool = True) -> Floats:
        """Return costs (k, n) from each of k nodes to all, or from all to each.

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
        ...

    def tree(self, node: int, forward: bool = True) -> LeastCosts:
        """Return least costs and paths from a node to all, or from all to it.

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
        ...

    def trees(self, nodes: ArrayLike, forward: bool = True) -> Sequence[LeastCosts]:
        """Return the trees of several nodes, searched together where that is faster.

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
        ...

    def seeded(self, labels: ArrayLike) -> LeastCosts:
        """Return least costs and paths where each node may start at a cost of its own.

        Parameters
        ----------
        labels : array_like of float, (n,)
            Starting costs; inf where no path may start.

        Returns
        -------
        LeastCosts
            Costs of all nodes; a path is empty where it is best to start at the node itself.
        """
        ...

    def shared_stretch(
        self,
        pair: ArrayLike,
        there: Sequence[Floats],
        onward: Sequence[Floats],
        limit: float,
        slack: float = 0.0,
    ) -> LeastCosts:
        """Return least costs of two that meet and drive together, as far as a limit needs them.

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
        ...

    def many_to_many(self, sources: ArrayLike, targets: ArrayLike) -> Floats:
        """Return least costs (S, T).

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
        ...

    def one_to_many(self, source: int, targets: ArrayLike) -> Floats:
        """Return least costs (T,).

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
        ...

    def path(self, source: int, target: int) -> Longs:
        """Return the edges of a least-cost path; raise NoRouteError if there is none.

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
        ...

    def best_on_route(
        self,
        route: Longs,
        origins: Longs,
        destinations: Longs,
        platoon: Floats,
        length_m: Floats,
        entries: Positions | None = None,
        exits: Positions | None = None,
    ) -> Found:
        """Return where N members best join a route and leave it.

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
        ...
