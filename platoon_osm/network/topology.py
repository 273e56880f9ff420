"""What follows from the edges alone: which arrive at a node, and a short name for the whole."""

from __future__ import annotations

import hashlib
from typing import Protocol

import numpy as np
from numpy.typing import NDArray

__all__ = ["Graph", "identity_of", "incoming_edges"]


class Graph(Protocol):
    """A directed graph as arrays, edges sorted by tail; `RoadNetwork` is one."""

    @property
    def n(self) -> int:
        """Number of nodes."""

    @property
    def m(self) -> int:
        """Number of edges."""

    @property
    def first_out(self) -> NDArray[np.int32]:
        """Where the edges of each node begin, (n + 1,)."""

    @property
    def tail(self) -> NDArray[np.int32]:
        """Node that each edge leaves, (m,)."""

    @property
    def head(self) -> NDArray[np.int32]:
        """Node that each edge leads to, (m,)."""

    @property
    def length_m(self) -> NDArray[np.float64]:
        """Length of each edge [m], (m,)."""

    @property
    def speed_mps(self) -> NDArray[np.float64]:
        """Speed on each edge [m/s], (m,)."""

    @property
    def posted_mps(self) -> NDArray[np.float64]:
        """Speed of light vehicles on each edge [m/s], (m,)."""

    @property
    def restriction(self) -> NDArray[np.int32]:
        """Code of what is restricted on each edge, (m,)."""

    @property
    def node_id(self) -> NDArray[np.int64]:
        """OpenStreetMap id of each node, (n,)."""


def incoming_edges(graph: Graph) -> tuple[NDArray[np.int64], NDArray[np.int64]]:
    """Sort the edges by head.

    Parameters
    ----------
    graph : Graph
        Whose edges.

    Returns
    -------
    edges : ndarray of int64, (m,)
        Edge ids sorted by head.
    first : ndarray of int64, (n + 1,)
        Where those that arrive at each node begin.
    """
    order = np.argsort(graph.head, kind="stable")
    first = np.zeros(graph.n + 1, np.int64)
    np.cumsum(np.bincount(graph.head, minlength=graph.n), out=first[1:])
    order.flags.writeable = first.flags.writeable = False
    return order, first


def identity_of(graph: Graph) -> str:
    """Hash the graph itself: nodes, edges, lengths, speeds and where restrictions are.

    Parameters
    ----------
    graph : Graph
        What to tell from others.

    Returns
    -------
    str
        16 hex digits.
    """
    digest = hashlib.sha256()
    for array in (graph.tail, graph.head, graph.length_m, graph.speed_mps, graph.node_id):
        digest.update(array.tobytes())
    for extra in (graph.restriction, graph.posted_mps - graph.speed_mps):
        # Where nothing is restricted the hash is that of the bare graph.
        if extra.any():
            digest.update(extra.tobytes())
    return digest.hexdigest()[:16]
