"""Which edges a stretch drives on a network that has places between its junctions, and how much.

The record of a plan names edges of the network as it was loaded, and where the first begins and the
last ends; its costs are known on the network that is cut where places lie.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from ..network.placed import PlacedNetwork
from ..network.road_network import RoadNetwork
from ..plans.records import Stretch

__all__ = ["DrivenPieces"]

Index = NDArray[np.int64]
Floats = NDArray[np.float64]


class DrivenPieces:
    """Where stretches of a plan are on a network that has places between its junctions.

    Parameters
    ----------
    net : RoadNetwork
        With or without places.
    """

    def __init__(self, net: RoadNetwork) -> None:
        self.net = net
        if isinstance(net, PlacedNetwork) and net.below is not None:
            self._order = np.lexsort((net.begins, net.below_edge))
            self._sorted = net.below_edge[self._order]

    def of(self, stretch: Stretch) -> tuple[Index, Floats]:
        """Return the edges of a stretch, and how much of each is driven.

        Parameters
        ----------
        stretch : Stretch
            Of a plan, its edges those of the network below.

        Returns
        -------
        edges : ndarray of int, (k,)
            Edge ids of this network.
        driven : ndarray of float, (k,)
            How much of each is driven, as a share of its length.
        """
        net, (begin, end) = self.net, stretch.span
        if not isinstance(net, PlacedNetwork) or net.below is None:
            driven = np.ones(len(stretch.edges))
            if len(driven):
                driven[0] -= begin
                driven[-1] -= 1 - end
            return np.array(stretch.edges, np.int64), driven
        if stretch.access is not None:
            return self._access(net, stretch), np.ones(1)
        found: list[int] = []
        parts: list[float] = []
        last = len(stretch.edges) - 1
        for place, edge in enumerate(stretch.edges):
            low = begin if place == 0 else 0.0
            high = end if place == last else 1.0
            at, until = np.searchsorted(self._sorted, [edge, edge + 1])
            for piece in self._order[at:until].tolist():
                first, until_share = float(net.begins[piece]), float(net.ends[piece])
                on = min(high, until_share) - max(low, first)
                if on > 0 or first == until_share:
                    found.append(piece)
                    parts.append(on / (until_share - first) if on < until_share - first else 1.0)
        return np.array(found, np.int64), np.array(parts)

    def _access(self, net: PlacedNetwork, stretch: Stretch) -> Index:
        assert stretch.access is not None
        for way in np.flatnonzero(net.below_edge < 0).tolist():
            shape = net.shape(way)
            line = tuple(shape[0].tolist()), tuple(shape[-1].tolist())
            if line == stretch.access:
                return np.array([way], np.int64)
        raise AssertionError("a way of the plan is none of its places")
