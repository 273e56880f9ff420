"""Searches from two nodes in one sweep, as a pair of vehicles needs them.

Both costs of a node lie side by side, so each arc is looked at once: two searches take little more
than one.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from ..customization import Metric
from ..preparing.ranks import MANY
from ..runtime.jit import compiled
from ..runtime.lent import lent
from ..runtime.threads import run_all
from .sweeps import WORTH_A_THREAD, ancestors, climb

__all__ = ["from_two"]

Ints = NDArray[np.int32]
Longs = NDArray[np.int64]
Floats = NDArray[np.float64]
U = np.uint64


def from_two(metric: Metric, nodes: Longs, forward: bool = True, threads: int = 1) -> Floats:
    """Return costs (2, n) from each of two nodes to all, or from all to each if not forward.

    Parameters
    ----------
    metric : Metric
        The hierarchy under one weight.
    nodes : ndarray of int, (2,)
        Nodes searched from.
    forward : bool
        Whether paths start at the nodes; else they end there.
    threads : int
        Cores to use; results do not depend on it.

    Returns
    -------
    ndarray of float, (2, n)
        Costs; inf where there is no way.
    """
    t = metric.topology
    ascend, descend = metric.towards(forward)
    found = lent(t.n, 2)
    together = threads > 1 and len(t.head) >= WORTH_A_THREAD
    one, other = t.rank[nodes].tolist()
    climbed = _two(
        one, other, t.top if together else 0, t.parent, t.run, t.first, t.upper, ascend, descend,
        t.node, found,
    )  # fmt: skip

    def sweep(part: tuple[int, int]) -> None:
        _sweep(*part, climbed, t.run, t.first, t.upper, descend, t.node, found)

    if together:
        run_all(sweep, t.parts(), threads)
    return found.T


@compiled
def _two(
    one: int, other: int, low: int, parent: Ints, run: Ints, first: Ints, upper: Ints,
    ascend: Floats, descend: Floats, node: Ints, found: Floats,
) -> Ints:  # fmt: skip
    """Climb from two ranks and sweep down to rank `low`; return the ranks climbed."""
    chains = ancestors(one, parent), ancestors(other, parent)
    climbed = np.unique(np.concatenate(chains))
    for v in climbed:
        found[node[v]] = np.inf
    for k in range(2):
        climb(chains[k], first, upper, ascend, node, found[:, k])
    _sweep(low, len(node), climbed, run, first, upper, descend, node, found)
    return climbed


@compiled
def _sweep(
    low: int, high: int, climbed: Ints, run: Ints, first: Ints, upper: Ints, descend: Floats,
    node: Ints, found: Floats,
) -> None:  # fmt: skip
    """Sweep from rank `high` down to `low`; only the climbed nodes hold costs before."""
    for k in range(np.searchsorted(climbed, high) - 1, -1, -1):
        v = climbed[k]
        if v < low:
            break
        _descend(v + 1, high, run, first, upper, descend, node, found)
        i = node[v]
        for a in range(first[v], first[v + 1]):
            for lane in range(2):
                found[i, lane] = min(found[i, lane], found[upper[a], lane] + descend[a])
        high = v
    _descend(low, high, run, first, upper, descend, node, found)


@compiled
def _descend(
    low: int, high: int, run: Ints, first: Ints, upper: Ints, descend: Floats, node: Ints,
    found: Floats,
) -> None:  # fmt: skip
    """Give nodes, from rank `high` down to `low`, the least of what their upper ends offer."""
    r = np.searchsorted(run, high) - 1
    while high > low:
        begin = max(low, run[r])
        arcs = first[begin + 1] - first[begin]
        a = U(first[high])
        for v in range(high - 1, begin - 1, -1):
            one = other = np.inf
            last = U(first[v]) if arcs >= MANY else a - U(arcs)
            while a > last:
                a -= U(1)
                u, w = U(upper[a]), descend[a]
                new = found[u, 0] + w
                one = new if new < one else one
                new = found[u, 1] + w
                other = new if new < other else other
            found[U(node[v]), 0] = one
            found[U(node[v]), 1] = other
        high = begin
        r -= 1
