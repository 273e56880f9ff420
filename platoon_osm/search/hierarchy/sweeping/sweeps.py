"""Searches from one node or from labelled nodes: climb the elimination tree, then sweep down once.

A search needs no queue: the nodes it climbs are the ancestors of its source. A sweep from the
highest rank to the lowest then gives every node its distance. Distances are kept in the order of
the network's own nodes throughout, so that nothing need be copied at the end.

References
----------
.. [1] Delling, Goldberg, Nowatzyk, Werneck, "PHAST: hardware-accelerated shortest path trees",
   IPDPS 2011.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from ..customization import Metric
from ..preparing.ranks import MANY
from ..runtime.jit import compiled
from ..runtime.lent import lent
from ..runtime.threads import run_all

__all__ = ["ancestors", "climb", "from_labels", "from_one"]

Ints = NDArray[np.int32]
Floats = NDArray[np.float64]
Number = int | np.int64

WORTH_A_THREAD = 400_000
"""Arcs from which on one sweep is shared among threads."""
U = np.uint64
"""Unsigned, an index needs no look at its sign: a third of the time of a sweep."""


def from_one(
    metric: Metric, node: int, forward: bool = True, threads: int = 1, found: Floats | None = None
) -> Floats:
    """Return costs (n,) from a node to all, or from all to it if not forward.

    Parameters
    ----------
    metric : Metric
        The hierarchy under one weight.
    node : int
        Node searched from.
    forward : bool
        Whether paths start at the node; else they end there.
    threads : int
        Cores to use; results do not depend on it.
    found : ndarray of float, (n,), optional
        Where to write the costs.

    Returns
    -------
    ndarray of float, (n,)
        Costs; inf where there is no way.
    """
    t = metric.topology
    ascend, descend = metric.towards(forward)
    if found is None:
        found = lent(t.n)
    together = threads > 1 and len(t.head) >= WORTH_A_THREAD
    climbed = _one(
        int(t.rank[node]), t.top if together else 0, t.parent, t.run, t.first, t.upper, ascend,
        descend, t.node, found,
    )  # fmt: skip

    def sweep(part: tuple[int, int]) -> None:
        _sweep(*part, climbed, t.run, t.first, t.upper, descend, t.node, found)

    if together:
        run_all(sweep, t.parts(), threads)
    return found


def from_labels(metric: Metric, labels: Floats, threads: int = 1) -> Floats:
    """Return for each node the least cost (n,) of a path that starts at any x with cost labels[x].

    Every node may be a start, so all are climbed from, in order of rank.

    Parameters
    ----------
    metric : Metric
        The hierarchy under one weight.
    labels : ndarray of float, (n,)
        Starting costs; inf where no path may start.
    threads : int
        Cores to use; results do not depend on it.

    Returns
    -------
    ndarray of float, (n,)
        Costs; inf where there is no way.
    """
    t = metric.topology
    found = lent(t.n)
    found[:] = labels
    if threads <= 1 or len(t.head) < WORTH_A_THREAD:
        _labels(t.run, t.first, t.head, t.upper, metric.up, metric.down, t.node, found)
        return found

    def ascend(low: int, high: int, top: int, top_found: Floats) -> None:
        _ascend(
            low, high, t.run, t.first, t.head, t.upper, metric.up, t.node, found, top, top_found
        )

    def ascend_part(part: tuple[int, int]) -> Floats:
        # The top belongs to all subtrees; each offers its sums in a copy of its own.
        own = np.full(t.n - t.top, np.inf)
        ascend(*part, t.top, own)
        return own

    def descend(part: tuple[int, int]) -> None:
        _descend(*part, True, t.run, t.first, t.upper, metric.down, t.node, found)

    top = t.node[t.top :]
    for own in run_all(ascend_part, t.parts(), threads):
        found[top] = np.minimum(found[top], own)
    ascend(t.top, t.n, t.n, found[:0])
    descend((t.top, t.n))
    run_all(descend, t.parts(), threads)
    return found


@compiled
def _labels(
    run: Ints, first: Ints, head: Ints, upper: Ints, climb: Floats, descend: Floats, node: Ints,
    found: Floats,
) -> None:  # fmt: skip
    # Plain numbers: for a literal the kernel would be compiled once more.
    low, n = np.int64(0), len(node)
    _ascend(low, n, run, first, head, upper, climb, node, found, n, found[:0])
    _descend(low, n, True, run, first, upper, descend, node, found)


@compiled
def ancestors(start: int, parent: Ints) -> Ints:
    """Return a rank and all above it in the elimination tree, ascending.

    Parameters
    ----------
    start : int
        The rank.
    parent : ndarray of int, (n,)
        Rank of the lowest upper neighbour; -1 for roots.

    Returns
    -------
    ndarray of int, (k,)
        Ranks.
    """
    length, v = 0, start
    while v >= 0:
        length += 1
        v = parent[v]
    chain = np.empty(length, np.int32)
    v = start
    for k in range(length):
        chain[k] = v
        v = parent[v]
    return chain


@compiled
def _one(
    start: int, low: int, parent: Ints, run: Ints, first: Ints, upper: Ints, ascend: Floats,
    descend: Floats, node: Ints, found: Floats,
) -> Ints:  # fmt: skip
    """Climb from a rank and sweep down to rank `low`; return the ranks climbed."""
    climbed = ancestors(start, parent)
    for v in climbed:
        found[node[v]] = np.inf
    climb(climbed, first, upper, ascend, node, found)
    _sweep(low, len(node), climbed, run, first, upper, descend, node, found)
    return climbed


@compiled
def climb(climbed: Ints, first: Ints, upper: Ints, cost: Floats, node: Ints, found: Floats) -> None:
    """Climb from the first of some ranks, a node's ancestors, where `found` is inf.

    Parameters
    ----------
    climbed : ndarray of int, (k,)
        The rank to start from and its ancestors.
    first : ndarray of int, (n + 1,)
        Where the arcs of each rank begin.
    upper : ndarray of int, (a,)
        The network's node at the upper end of each arc.
    cost : ndarray of float, (a,)
        Cost of each arc upward.
    node : ndarray of int, (n,)
        The network's node of each rank.
    found : ndarray of float, (n,)
        Costs of the network's nodes, written here.
    """
    found[node[climbed[0]]] = 0.0
    for v in climbed:
        d = found[node[v]]
        for a in range(first[v], first[v + 1]):
            u, new = upper[a], d + cost[a]
            if new < found[u]:
                found[u] = new


@compiled
def _sweep(
    low: int, high: int, climbed: Ints, run: Ints, first: Ints, upper: Ints, descend: Floats,
    node: Ints, found: Floats,
) -> None:  # fmt: skip
    """Sweep from rank `high` down to `low`; only the climbed nodes hold a cost before."""
    for k in range(np.searchsorted(climbed, high) - 1, -1, -1):
        v = climbed[k]
        if v < low:
            break
        _descend(v + 1, high, False, run, first, upper, descend, node, found)
        _descend(v, v + 1, True, run, first, upper, descend, node, found)
        high = v
    _descend(low, high, False, run, first, upper, descend, node, found)


@compiled
def _descend(
    low: Number, high: int, known: bool, run: Ints, first: Ints, upper: Ints, descend: Floats,
    node: Ints, found: Floats,
) -> None:  # fmt: skip
    """Give nodes, from rank `high` down to `low`, the least of what their upper ends offer.

    If they are `known`, they keep what they hold where that is less. One class after the other:
    within a run, nothing has to be guessed.
    """
    r = np.searchsorted(run, high) - 1
    while high > low:
        begin = max(low, run[r])
        arcs = first[begin + 1] - first[begin]
        a = U(first[high])
        if arcs == 2:  # three nodes of five
            for v in range(high - 1, begin - 1, -1):
                a -= U(2)
                one = found[U(upper[a])] + descend[a]
                other = found[U(upper[a + U(1)])] + descend[a + U(1)]
                best = one if one < other else other
                if known:
                    before = found[U(node[v])]
                    best = best if best < before else before
                found[U(node[v])] = best
        else:
            for v in range(high - 1, begin - 1, -1):
                best = found[U(node[v])] if known else np.inf
                last = U(first[v]) if arcs >= MANY else a - U(arcs)
                while a > last:
                    a -= U(1)
                    new = found[U(upper[a])] + descend[a]
                    best = new if new < best else best
                found[U(node[v])] = best
        high = begin
        r -= 1


@compiled
def _ascend(
    low: Number, high: int, run: Ints, first: Ints, head: Ints, upper: Ints, climb: Floats,
    node: Ints, found: Floats, top: int, top_found: Floats,
) -> None:  # fmt: skip
    r = np.searchsorted(run, low, side="right") - 1
    while low < high:
        end = min(high, run[r + 1])
        arcs = first[low + 1] - first[low]
        a = U(first[low])
        for v in range(low, end):
            d = found[U(node[v])]
            stop = U(first[v + 1]) if arcs >= MANY else a + U(arcs)
            while a < stop:
                new = d + climb[a]
                if head[a] < top:
                    u = U(upper[a])
                    before = found[u]
                    found[u] = new if new < before else before
                elif new < top_found[head[a] - top]:
                    top_found[head[a] - top] = new
                a += U(1)
        low = end
        r += 1
