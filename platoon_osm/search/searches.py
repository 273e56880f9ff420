"""The owner of a network's searches: an engine a weight, made once and handed down."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..errors import SearchError
from ..network.road_network import RoadNetwork
from .arguments import checked_network, checked_weight, described
from .dijkstra import ReferenceEngine
from .price import faster
from .protocol import Engine, EngineName

__all__ = ["KEPT_WEIGHTS", "Searches", "engine_for"]

Floats = NDArray[np.float64]

KEPT_WEIGHTS = 2
"""Engines kept with a network: a plan of two vehicles needs two weights in turns."""


class Searches:
    """All searches of one network.

    `net.attached(Searches)` makes one and keeps it as long as the network. It keeps the engines of
    the last weights; the hierarchy's order and arcs, which serve every weight, lie beside it in
    `KeptTopology`.

    Parameters
    ----------
    net : RoadNetwork
        The network searched.
    """

    def __init__(self, net: RoadNetwork) -> None:
        self.net = checked_network(net)
        self._engines: list[tuple[Floats, Engine]] = []
        self._arrays = net.tail, net.head

    def under(self, weight: ArrayLike, expected: float = 1, engine: EngineName = "auto") -> Engine:
        """Return an engine for a weight; the last two are kept.

        Parameters
        ----------
        weight : array_like of float, (m,)
            Cost of each edge, 0 or more; inf where closed. A kept engine is used again only if
            every cost is the same.
        expected : float
            Single searches the reference would need; "auto" decides by it.
        engine : {"auto", "reference", "hierarchy"}
            Which engine; "auto" is the one that is likely faster.

        Returns
        -------
        Engine
            Searches under this weight.

        Raises
        ------
        SearchError
            A weight that is negative, NaN or of the wrong shape, or an engine that is none.
        """
        if not isinstance(engine, str) or engine not in ("auto", "reference", "hierarchy"):
            raise SearchError(
                f'engine {described(engine)} is unknown; use "auto", "reference" or "hierarchy"'
            )
        if not _counts(expected):
            raise SearchError(f"expected is {described(expected)}; give the number of searches")
        values = checked_weight(self.net, weight)
        if self._arrays[0] is not self.net.tail or self._arrays[1] is not self.net.head:
            self.forget()
        ready = {
            item.name: item
            for own, item in list(self._engines)
            if own is values or np.array_equal(own, values)
        }
        chosen = engine if engine != "auto" else faster(self.net, expected, ready)
        if chosen in ready:
            return ready[chosen]
        # Kept with a copy: an array changed in place must not find the engine of its old values.
        made: Engine
        if chosen == "reference":
            made = ReferenceEngine(self.net, values)
        else:
            from .hierarchy.engine import HierarchyEngine

            made = HierarchyEngine(self.net, values)
        self._engines.append((made.weight, made))
        del self._engines[:-KEPT_WEIGHTS]
        return made

    def forget(self) -> None:
        """Let go of the kept engines; the hierarchy's order stays."""
        self._engines.clear()
        self._arrays = self.net.tail, self.net.head


def engine_for(
    net: RoadNetwork, weight: ArrayLike, engine: EngineName = "auto", searches: float = 1
) -> Engine:
    """Return an engine for a weight; see `Searches.under`.

    Parameters
    ----------
    net : RoadNetwork
        The network searched.
    weight : array_like of float, (m,)
        Cost of each edge, 0 or more; inf where closed.
    engine : {"auto", "reference", "hierarchy"}
        Which engine; "auto" is the one that is likely faster.
    searches : float
        Single searches the reference would need; "auto" decides by it.

    Returns
    -------
    Engine
        Searches under this weight, kept with the network.
    """
    return checked_network(net).attached(Searches).under(weight, searches, engine)


def _counts(number: Any) -> bool:
    real = isinstance(number, int | float | np.integer | np.floating)
    return real and not isinstance(number, bool) and not math.isnan(number) and number >= 0
