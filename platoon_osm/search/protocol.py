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
        """Return costs (k, n) from each of k nodes to all, or from all to each."""
        ...

    def tree(self, node: int, forward: bool = True) -> LeastCosts:
        """Return least costs and paths from a node to all, or from all to it."""
        ...

    def trees(self, nodes: ArrayLike, forward: bool = True) -> Sequence[LeastCosts]:
        """Return the trees of several nodes, searched together where that is faster."""
        ...

    def seeded(self, labels: ArrayLike) -> LeastCosts:
        """Return least costs and paths where each node may start at a cost of its own."""
        ...

    def shared_stretch(
        self,
        pair: ArrayLike,
        there: Sequence[Floats],
        onward: Sequence[Floats],
        limit: float,
        slack: float = 0.0,
    ) -> LeastCosts:
        """Return least costs of two that meet and drive together, as far as a limit needs them."""
        ...

    def many_to_many(self, sources: ArrayLike, targets: ArrayLike) -> Floats:
        """Return least costs (S, T)."""
        ...

    def one_to_many(self, source: int, targets: ArrayLike) -> Floats:
        """Return least costs (T,)."""
        ...

    def path(self, source: int, target: int) -> Longs:
        """Return the edges of a least-cost path; raise NoRouteError if there is none."""
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
        """Return where N members best join a route and leave it."""
        ...
