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

from .preparing.symbolic import Topology
from .runtime.jit import compiled
from .runtime.lent import lent
from .runtime.threads import run_all

__all__ = ["Metric", "customize"]

Ints = NDArray[np.int32]
Longs = NDArray[np.int64]
Floats = NDArray[np.float64]
Number = int | np.int64

WORTH_A_THREAD = 500_000
"""Triangles from which on several threads pay; fewer take a millisecond or two."""
U = np.uint64
"""Unsigned, an index needs no look at its sign."""


@dataclass(frozen=True, slots=True, eq=False)
class Metric:
    """The hierarchy under one weight.

    Attributes
    ----------
    topology : Topology
        Order, arcs and triangles.
    up : ndarray of float, (a,)
        Cost of each arc from its lower to its upper end.
    down : ndarray of float, (a,)
        Cost of each arc back.
    """

    topology: Topology
    up: Floats
    down: Floats

    def towards(self, forward: bool) -> tuple[Floats, Floats]:
        """Return the costs a search climbs by and those its sweep descends by.

        Parameters
        ----------
        forward : bool
            Whether the search starts at its node; else it ends there.

        Returns
        -------
        climb : ndarray of float, (a,)
            Costs of arcs upward.
        descend : ndarray of float, (a,)
            Costs of arcs downward.
        """
        return (self.up, self.down) if forward else (self.down, self.up)


def customize(topology: Topology, weight: Floats, threads: int = 1) -> Metric:
    """Return the costs of all arcs under a weight.

    Parameters
    ----------
    topology : Topology
        Order, arcs and triangles.
    weight : ndarray of float, (m + 1,)
        Cost of each edge, 0 or more; inf where closed. The last is inf, for arcs that no edge goes
        along.
    threads : int
        With more than one, subtrees are worked on side by side. Sums are formed alike and a
        minimum does not depend on its order, so the result is the same to the last bit.

    Returns
    -------
    Metric
        Costs of all arcs.
    """
    t = topology
    arcs = len(t.head)
    edges = (t.forth, t.back, t.spare, t.spare_place, weight)
    triangles = (t.run, t.first, t.triangle_first, t.triangle)
    if threads <= 1 or len(t.triangle) < WORTH_A_THREAD or len(t.subtree) <= 2:
        up, down = lent(arcs), lent(arcs)
        _work(0, t.n, 0, *edges, *triangles, up, down, arcs)
        return Metric(t, up, down)
    # Arcs of the top belong to all subtrees; each offers its sums in a copy of its own.
    parts, top_arc = t.parts(), int(t.first[t.top])
    copy = arcs - top_arc
    size = arcs + len(parts) * copy
    up, down = lent(size), lent(size)

    def work(k: int) -> None:
        own = slice(arcs + k * copy, arcs + (k + 1) * copy)
        up[own] = down[own] = np.inf
        low, high = parts[k]
        _work(low, high, own.start - top_arc, *edges, *triangles, up, down, top_arc)

    run_all(work, range(len(parts)), threads)
    _load(top_arc, arcs, *edges, up, down)
    for cost in (up, down):
        np.minimum.reduce(cost[top_arc:].reshape(-1, copy), axis=0, out=cost[top_arc:arcs])
    _relax(t.top, t.n, 0, *triangles, up, down, arcs)
    return Metric(t, up[:arcs], down[:arcs])


@compiled
def _work(
    low: int, high: int, shift: int, forth: Ints, back: Ints, spare: Ints, spare_place: Ints,
    weight: Floats, run: Ints, first: Ints, triangle_first: Longs, triangle: Ints, up: Floats,
    down: Floats, top_arc: int,
) -> None:  # fmt: skip
    """Customize the nodes of ranks low to high; arcs from `top_arc` on lie at a + shift."""
    begin, end = np.int64(first[low]), np.int64(first[high])
    _load(begin, end, forth, back, spare, spare_place, weight, up, down)
    _relax(low, high, shift, run, first, triangle_first, triangle, up, down, top_arc)


@compiled
def _load(
    begin: Number, end: Number, forth: Ints, back: Ints, spare: Ints, spare_place: Ints,
    weight: Floats, up: Floats, down: Floats,
) -> None:  # fmt: skip
    """Give the arcs from `begin` to `end` the weight of their lightest edges."""
    for a in range(U(begin), U(end)):
        up[a] = weight[U(forth[a])]
        down[a] = weight[U(back[a])]
    if not len(spare):
        return
    low, high = np.searchsorted(spare_place, 2 * begin), np.searchsorted(spare_place, 2 * end)
    for k in range(low, high):
        i, w = spare_place[k] >> 1, weight[spare[k]]
        if spare_place[k] & 1:
            down[i] = min(down[i], w)
        else:
            up[i] = min(up[i], w)


@compiled
def _relax(
    low: int, high: int, shift: int, run: Ints, first: Ints, triangle_first: Longs,
    triangle: Ints, up: Floats, down: Floats, top_arc: int,
) -> None:  # fmt: skip
    """Offer the sums of the nodes of ranks low to high; from arc `top_arc` on to a + shift.

    Whether a sum is less cannot be foreseen: a choice is cheaper than a jump.
    """
    r = np.searchsorted(run, low, side="right") - 1
    while low < high:
        end = min(high, run[r + 1])
        arcs = first[low + 1] - first[low]
        t = U(triangle_first[low])
        r += 1
        if arcs == 2:  # three nodes of five
            b = U(first[low])
            for _ in range(low, end):
                a = U(triangle[t])
                t += U(1)
                a = a + U(shift) if a >= U(top_arc) else a
                there, back = down[b] + up[b + U(1)], down[b + U(1)] + up[b]
                before, other = up[a], down[a]
                up[a] = there if there < before else before
                down[a] = back if back < other else other
                b += U(2)
        elif arcs > 2:
            for v in range(low, end):
                for i in range(first[v], first[v + 1] - 1):
                    to_low, from_low = down[U(i)], up[U(i)]
                    for j in range(i + 1, first[v + 1]):
                        a = U(triangle[t])
                        t += U(1)
                        a = a + U(shift) if a >= U(top_arc) else a
                        there, back = to_low + up[U(j)], down[U(j)] + from_low
                        before, other = up[a], down[a]
                        up[a] = there if there < before else before
                        down[a] = back if back < other else other
        low = end
