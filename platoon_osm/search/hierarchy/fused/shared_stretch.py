"""Where two vehicles drive together: a search that goes towards both destinations.

Every vehicle could also drive alone what they drive together, and if two together pay at least
2 f times what one pays alone on any road (f <= 1), a shared stretch through a node z costs both
at least f (u1 + u2 + v1 + v2)(z), with u the costs alone from the origins and v those to the
destinations. Driving alone costs S. So only nodes where this is at most S matter, most often few,
and f (v1 + v2) is a lower bound of what is left to pay: a search ordered by label plus bound meets
the best stretch before it has seen much else, and needs no hierarchy for the pair's weight.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from ....errors import SearchError
from ....network.road_network import RoadNetwork
from ..runtime.jit import compiled
from ..runtime.lent import lent

__all__ = ["shared_stretch"]

Ints = NDArray[np.int32]
Longs = NDArray[np.int64]
Floats = NDArray[np.float64]

FEW = 8
"""With at most one node in so many the search is shorter than customization and two sweeps."""


def shared_stretch(
    net: RoadNetwork,
    solo: Floats,
    pair: Floats,
    there: Sequence[Floats],
    onward: Sequence[Floats],
    limit: float,
    slack: float,
) -> Floats | None:
    """Return the least costs of both vehicles up to where they may part.

    Parameters
    ----------
    net : RoadNetwork
        The network searched.
    solo : ndarray of float, (m,)
        Cost of each edge for one vehicle alone.
    pair : ndarray of float, (m,)
        Cost of each edge for both together.
    there : sequence of ndarray of float, (n,)
        Of either vehicle the costs alone from its origin.
    onward : sequence of ndarray of float, (n,)
        Of either vehicle the costs alone to its destination.
    limit : float
        Costs of both above which no plan is of interest.
    slack : float
        Plans that cost so much more than the best are found too.

    Returns
    -------
    ndarray of float, (n,), or None
        Cost of both, having driven together up to the node or met there; inf where no plan within
        the limit would part or pass. None if too many nodes matter.

    Raises
    ------
    SearchError
        A cost that is negative or NaN.
    """
    share = _least_share(solo, pair)
    if share <= 0:
        return None
    found = lent(net.n)
    most = max(net.n // FEW, 64)
    (u1, u2), (v1, v2) = there, onward
    done = _search(u1, u2, v1, v2, share, limit, slack, net.first_out, net.head, pair, most, found)
    if done < 0:
        raise SearchError("there and onward: a cost is negative or NaN; give costs of 0 or more")
    return found if done else None


@compiled
def _least_share(solo: Floats, pair: Floats) -> float:
    """Return the least of pair / (2 solo) over all open edges, at most 1."""
    least = 1.0
    for e in range(len(pair)):
        if pair[e] < 2.0 * least * solo[e]:
            least = pair[e] / (2.0 * solo[e])
    return least


@compiled
def _search(
    u1: Floats, u2: Floats, v1: Floats, v2: Floats, share: float, limit: float, slack: float,
    first_out: Ints, head: Ints, weight: Floats, most: int, found: Floats,
) -> int:  # fmt: skip
    """Fill `found`; return 1, 0 if that took more than `most` nodes, -1 if a cost is none."""
    keys, nodes = np.empty(2 * most), np.empty(2 * most, np.int32)
    size = 0
    for x in range(len(found)):
        found[x] = np.inf
        label = u1[x] + u2[x]
        key = label + share * (v1[x] + v2[x])
        if not key >= 0:
            return -1
        if key <= limit:
            if size == most:
                return 0
            found[x] = label
            keys[size], nodes[size] = key, x
            size += 1
    for k in range(size // 2 - 1, -1, -1):
        _sink(keys, nodes, k, size)
    settled = np.zeros(len(found), np.bool_)
    count, bound = 0, limit
    while size:
        key, x = keys[0], nodes[0]
        if key > bound:
            break
        size -= 1
        keys[0], nodes[0] = keys[size], nodes[size]
        _sink(keys, nodes, 0, size)
        label, rest = found[x], v1[x] + v2[x]
        if key != label + share * rest:
            continue  # found a better way since
        if not settled[x]:
            settled[x] = True
            count += 1
            if count > most:
                return 0
        bound = min(bound, label + rest + slack)
        for e in range(first_out[x], first_out[x + 1]):
            h, new = head[e], label + weight[e]
            if new < found[h]:
                key = new + share * (v1[h] + v2[h])
                if key <= bound:
                    found[h] = new
                    if size == len(keys):
                        keys = np.concatenate((keys, np.empty_like(keys)))
                        nodes = np.concatenate((nodes, np.empty_like(nodes)))
                    _rise(keys, nodes, size, key, h)
                    size += 1
    # What was not settled may still have a better way.
    for k in range(size):
        if not settled[nodes[k]]:
            found[nodes[k]] = np.inf
    return 1


@compiled
def _sink(keys: Floats, nodes: Ints, k: int, size: int) -> None:
    """Move an entry of a heap down to where neither child is less."""
    key, node = keys[k], nodes[k]
    while 2 * k + 1 < size:
        child = 2 * k + 1
        if child + 1 < size and keys[child + 1] < keys[child]:
            child += 1
        if keys[child] >= key:
            break
        keys[k], nodes[k] = keys[child], nodes[child]
        k = child
    keys[k], nodes[k] = key, node


@compiled
def _rise(keys: Floats, nodes: Ints, k: int, key: float, node: int) -> None:
    """Put an entry into place k of a heap and move it up to where its parent is not more."""
    while k > 0 and keys[(k - 1) // 2] > key:
        keys[k], nodes[k] = keys[(k - 1) // 2], nodes[(k - 1) // 2]
        k = (k - 1) // 2
    keys[k], nodes[k] = key, node
