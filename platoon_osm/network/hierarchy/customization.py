"""Customization: the cost of every arc, both ways, under one weight.

Each arc starts with the lightest edge it stands for. Then nodes are taken from the lowest rank up,
and each pair of a node's arcs offers its sum to the arc between their upper ends. Closed edges have
infinite weight and need no further care.

References
----------
.. [1] Dibbelt, Strasser, Wagner, "Customizable contraction hierarchies", JEA 21 (2016), section 7.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from .jit import compiled
from .symbolic import Topology
from .threads import run_all

__all__ = ["Metric", "customize"]

Ints = NDArray[np.int32]
Longs = NDArray[np.int64]
Floats = NDArray[np.float64]

WORTH_A_THREAD = 100_000
"""Triangles from which on waking another thread (50 microseconds) pays."""


@dataclass(frozen=True, slots=True, eq=False)
class Metric:
    """The hierarchy under one weight.

    Attributes
    ----------
    up, down : (a,) cost of each arc from its lower to its upper end, and back.
    """

    topology: Topology
    up: Floats
    down: Floats

    def towards(self, forward: bool) -> tuple[Floats, Floats]:
        """Return the costs a search climbs by and those its sweep descends by."""
        return (self.up, self.down) if forward else (self.down, self.up)


def customize(topology: Topology, weight: Floats, threads: int = 1) -> Metric:
    """Return the costs of all arcs under a weight.

    Parameters
    ----------
    weight : (m,) cost of each edge, 0 or more; inf where closed.
    threads : with more than one, subtrees are worked on side by side. Sums are formed alike and
        a minimum does not depend on its order, so the result is the same to the last bit.
    """
    t = topology
    up, down = _load(t.place, weight, len(t.head))
    arcs = (t.first, t.triangle_first, t.triangle, up, down)
    if threads <= 1 or len(t.triangle) < WORTH_A_THREAD or len(t.subtree) <= 2:
        _relax(0, t.n, *arcs, len(t.head), up[:0], down[:0])
        return Metric(t, up, down)
    top = t.top
    top_arc = int(t.first[top])

    def relax(part: tuple[int, int]) -> tuple[Floats, Floats]:
        # Arcs of the top belong to all subtrees; each offers its sums in a copy of its own.
        own = np.full((2, len(t.head) - top_arc), np.inf)
        _relax(part[0], part[1], *arcs, top_arc, own[0], own[1])
        return own[0], own[1]

    for own_up, own_down in run_all(relax, t.parts(), threads):
        np.minimum(up[top_arc:], own_up, out=up[top_arc:])
        np.minimum(down[top_arc:], own_down, out=down[top_arc:])
    _relax(top, t.n, *arcs, len(t.head), up[:0], down[:0])
    return Metric(t, up, down)


@compiled
def _load(place: Ints, weight: Floats, arcs: int) -> tuple[Floats, Floats]:
    up, down = np.full(arcs, np.inf), np.full(arcs, np.inf)
    for e in range(len(place)):
        a = place[e] >> 1
        if place[e] < 0:
            continue
        if place[e] & 1:
            down[a] = min(down[a], weight[e])
        else:
            up[a] = min(up[a], weight[e])
    return up, down


@compiled
def _relax(
    low: int, high: int, first: Ints, triangle_first: Longs, triangle: Ints,
    up: Floats, down: Floats, top_arc: int, top_up: Floats, top_down: Floats,
) -> None:  # fmt: skip
    """Offer the sums of the nodes of ranks low to high; arcs from `top_arc` on are kept apart."""
    for v in range(low, high):
        t = triangle_first[v]
        for i in range(first[v], first[v + 1]):
            to_low, from_low = down[i], up[i]
            for j in range(i + 1, first[v + 1]):
                a = triangle[t]
                t += 1
                there, back = to_low + up[j], down[j] + from_low
                if a < top_arc:
                    if there < up[a]:
                        up[a] = there
                    if back < down[a]:
                        down[a] = back
                else:
                    a -= top_arc
                    if there < top_up[a]:
                        top_up[a] = there
                    if back < top_down[a]:
                        top_down[a] = back
