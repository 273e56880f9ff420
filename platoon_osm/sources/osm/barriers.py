"""Barriers on roads: what a gate, a bollard or a height restrictor does to who drives past it.

A barrier closes the segments that leave its node, so nobody passes it; who starts or ends there
does. Where more than two roads meet at its node the map does not say which of them it stands on,
and it is counted instead.
"""

from __future__ import annotations

from collections import Counter

import numpy as np
from numpy.typing import NDArray

from ...network.restrictions import Layer
from ...vehicles.access import BARRIERS, CHAIN, Way, barrier_way
from ..restricting_tags import is_restriction, restricting
from .raw_map import RawMap, TagReader

__all__ = ["barrier_layers"]

Index = NDArray[np.int64]

BARRIER_TAGS = ("barrier", "locked")


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
    read_tags = TagReader(lambda key: key in BARRIER_TAGS or is_restriction(key))
    found: dict[int, Layer] = {}
    known: dict[str, Layer] = {}
    some = [(node, text) for node, text, _, _ in raw.nodes if "barrier=" in text]
    places = np.searchsorted(node_ids, np.array([node for node, _ in some], np.int64)).tolist()
    for (node, text), at in zip(some, places, strict=True):
        tags = read_tags(text)
        if at >= len(node_ids) or node_ids[at] != node or "barrier" not in tags:
            continue
        counts["barriers on roads read"] += 1
        kind = tags["barrier"].strip().lower()
        if kind not in BARRIERS:
            counts["barriers of a kind not in the table, taken as open"] += 1
        if text not in known:
            known[text] = _layer(tags)
        if not known[text]:
            counts["barriers that close nothing"] += 1
        elif _meeting(at, tail, head) > 2:
            counts["barriers where roads meet, not obeyed"] += 1
        else:
            counts["barriers obeyed"] += 1
            found[at] = known[text]
    return found


def _layer(tags: dict[str, str]) -> Layer:
    restricted = restricting(tags, Counter())
    if not restricted and barrier_way(tags) == Way.OPEN:
        return {}
    own = {key: tags[key].strip() for key in (*CHAIN, *BARRIER_TAGS) if key in tags}
    return {**own, **restricted}


def _meeting(node: int, tail: Index, head: Index) -> int:
    """Return how many nodes are next to a node."""
    return len({*head[tail == node].tolist(), *tail[head == node].tolist()})
