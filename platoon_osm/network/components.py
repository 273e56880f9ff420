"""Strong components: parts of the network within which every node reaches every other."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from .topology import Graph

__all__ = ["MOSTLY_CONNECTED", "connected_share", "strong_components"]

MOSTLY_CONNECTED = 0.5
"""Share of the road that part 0 must hold to decide where trips may start and end."""


def strong_components(graph: Graph, among: NDArray[np.bool_] | None = None) -> NDArray[np.int32]:
    """Return the strongly connected part of each node; part 0 has the most road inside.

    Parameters
    ----------
    graph : Graph
        The network.
    among : ndarray of bool, (m,), optional
        Edges that there are; by default all.

    Returns
    -------
    ndarray of int32, (n,)
        Numbers of parts.
    """
    from scipy.sparse import csr_array
    from scipy.sparse.csgraph import connected_components

    tail, head, first, length_m = graph.tail, graph.head, graph.first_out, graph.length_m
    if among is not None:
        tail, head, length_m = tail[among], head[among], length_m[among]
        first = np.searchsorted(tail, np.arange(graph.n + 1)).astype(np.int32)
    matrix = csr_array((np.ones(len(head), np.int8), head, first), shape=(graph.n, graph.n))
    count, label = connected_components(matrix, directed=True, connection="strong")
    inside = label[tail] == label[head]
    km = np.bincount(label[tail[inside]], length_m[inside], minlength=count)
    rank = np.empty(count, np.int32)
    rank[np.argsort(-km, kind="stable")] = np.arange(count)
    part: NDArray[np.int32] = rank[label]
    part.flags.writeable = False
    return part


def connected_share(graph: Graph, part: NDArray[np.int32], counted: NDArray[np.bool_]) -> float:
    """Return the share of road, by length, that lies inside part 0.

    Parameters
    ----------
    graph : Graph
        The network.
    part : ndarray of int32, (n,)
        The part of each node.
    counted : ndarray of bool, (m,)
        Edges that count as road.

    Returns
    -------
    float
        Between 0 and 1; 0 where there is no road.
    """
    main = part == 0
    inside = counted & main[graph.tail] & main[graph.head]
    return float(graph.length_m[inside].sum() / max(graph.length_m[counted].sum(), 1e-9))
