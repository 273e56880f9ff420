"""Strong components: parts of the network within which every node reaches every other."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from .topology import Graph

__all__ = ["connected_share", "strong_components"]


def strong_components(graph: Graph) -> NDArray[np.int32]:
    """Return the strongly connected part of each node; part 0 has the most road inside.

    Parameters
    ----------
    graph : Graph
        The network.

    Returns
    -------
    ndarray of int32, (n,)
        Numbers of parts.
    """
    from scipy.sparse import csr_array
    from scipy.sparse.csgraph import connected_components

    matrix = csr_array(
        (np.ones(graph.m, np.int8), graph.head, graph.first_out), shape=(graph.n, graph.n)
    )
    count, label = connected_components(matrix, directed=True, connection="strong")
    inside = label[graph.tail] == label[graph.head]
    km = np.bincount(label[graph.tail[inside]], graph.length_m[inside], minlength=count)
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
