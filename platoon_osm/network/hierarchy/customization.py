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

WORTH_A_THREAD = 500_000
"""Triangles from which on several threads pay; fewer take a millisecond or two."""


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
    weight : (m + 1,) cost of each edge, 0 or more; inf where closed. The last is inf, for arcs
        that no edge goes along.
    threads : with more than one, subtrees are worked on side by side. Sums are formed alike and
        a minimum does not depend on its order, so the result is the same to the last bit.
    """
    t = topology
    up, down = np.empty(len(t.head)), np.empty(len(t.head))
    edges = (t.forth, t.back, t.spare, t.spare_place, weight, up, down)
    if threads <= 1 or len(t.triangle) < WORTH_A_THREAD or len(t.subtree) <= 2:
        _load(0, len(up), *edges)
        _relax(0, t.n, t.first, t.triangle_first, t.triangle, up, down, len(up), up, down)
        return Metric(t, up, down)
    top_arc = int(t.first[t.top])

    def work(part: tuple[int, int]) -> tuple[Floats, Floats]:
        # Arcs of the top belong to all subtrees; each offers its sums in a copy of its own.
        own = np.full((2, len(t.head) - top_arc), np.inf)
        _load(int(t.first[part[0]]), int(t.first[part[1]]), *edges)
        _relax(
            part[0], part[1], t.first, t.triangle_first, t.triangle, up, down, top_arc, own[0],
            own[1],
        )  # fmt: skip
        return own[0], own[1]

    found = run_all(work, t.parts(), threads)
    _load(top_arc, len(up), *edges)
    for own_up, own_down in found:
        np.minimum(up[top_arc:], own_up, out=up[top_arc:])
        np.minimum(down[top_arc:], own_down, out=down[top_arc:])
    _relax(t.top, t.n, t.first, t.triangle_first, t.triangle, up, down, len(up), up, down)
    return Metric(t, up, down)


@compiled
def _load(
    begin: int, end: int, forth: Ints, back: Ints, spare: Ints, spare_place: Ints,
    weight: Floats, up: Floats, down: Floats,
) -> None:  # fmt: skip
    """Give the arcs from `begin` to `end` the weight of their lightest edges."""
    for a in range(begin, end):
        up[a] = weight[forth[a]]
        down[a] = weight[back[a]]
    low, high = np.searchsorted(spare_place, 2 * begin), np.searchsorted(spare_place, 2 * end)
    for k in range(low, high):
        a, w = spare_place[k] >> 1, weight[spare[k]]
        if spare_place[k] & 1:
            down[a] = min(down[a], w)
        else:
            up[a] = min(up[a], w)


@compiled
def _relax(
    low: int, high: int, first: Ints, triangle_first: Longs, triangle: Ints,
    up: Floats, down: Floats, top_arc: int, top_up: Floats, top_down: Floats,
) -> None:  # fmt: skip
    """Offer the sums of the nodes of ranks low to high; arcs from `top_arc` on are kept apart."""
    for v in range(low, high):
        begin, end = first[v], first[v + 1]
        t = triangle_first[v]
        for i in range(begin, end - 1):
            to_low, from_low = down[i], up[i]
            for j in range(i + 1, end):
                a = triangle[t]
                t += 1
                there, back = to_low + up[j], down[j] + from_low
                # Whether a sum is less cannot be foreseen: a choice is cheaper than a jump.
                # Unsigned, an index needs no look at its sign.
                if a < top_arc:
                    at = np.uint64(a)
                    before, other = up[at], down[at]
                    up[at] = there if there < before else before
                    down[at] = back if back < other else other
                else:
                    at = np.uint64(a - top_arc)
                    before, other = top_up[at], top_down[at]
                    top_up[at] = there if there < before else before
                    top_down[at] = back if back < other else other
