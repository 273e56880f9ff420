"""Barriers on roads: what a gate, a bollard or a height restrictor does to who drives past it.

A barrier closes the segments that leave its node, so nobody passes it; who starts or ends there
does. Where more than two roads meet at its node the map does not say which of them it stands on,
and it is counted instead.
"""

from __future__ import annotations

from collections import Counter
from functools import partial

import numpy as np
from numpy.typing import NDArray

from ...network.restrictions import Layer
from ..barrier_reading import barrier_layer, is_barrier_tag, is_obeyed
from .raw_map import RawMap, TagReader

__all__ = ["barrier_layers"]

Index = NDArray[np.int64]


def barrier_layers(
    raw: RawMap, node_ids: Index, tail: Index, head: Index, counts: Counter[str]
) -> dict[int, Layer]:
    """Return what barriers close, by the node they stand on.

    Parameters
    ----------
    raw : RawMap
        The file.
    node_ids : ndarray of int64, (n,)
        OpenStreetMap ids of the nodes of kept roads, rising.
    tail, head : ndarray of int64, (s,)
        Node positions of directed segments.
    counts : Counter
        Counts barriers read, and what became of them.

    Returns
    -------
    dict of int to Layer
        By node position; barriers that everybody passes are not in it.
    """
    read_tags = TagReader(is_barrier_tag)
    found: dict[int, Layer] = {}
    known: dict[str, Layer] = {}
    some = [(node, text) for node, text, _, _ in raw.nodes if "barrier=" in text]
    places = np.searchsorted(node_ids, np.array([node for node, _ in some], np.int64)).tolist()
    for (node, text), at in zip(some, places, strict=True):
        tags = read_tags(text)
        if at >= len(node_ids) or node_ids[at] != node or "barrier" not in tags:
            continue
        if text not in known:
            known[text] = barrier_layer(tags)
        if is_obeyed(tags["barrier"], known[text], partial(_meeting, at, tail, head), counts):
            found[at] = known[text]
    return found


def _meeting(node: int, tail: Index, head: Index) -> int:
    """Return how many nodes are next to a node."""
    return len({*head[tail == node].tolist(), *tail[head == node].tolist()})
