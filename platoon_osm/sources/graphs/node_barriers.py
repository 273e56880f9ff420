"""Barriers on the nodes of OSMnx's graphs, as far as the graph has kept them.

OSMnx keeps the tags of nodes that `settings.useful_tags_node` names, by default without `barrier`,
and its simplification keeps a node between two edges only if `node_attrs_include` names a tag of
it. What the graph has is read as in OpenStreetMap's own files: a barrier closes the edges that
leave its node, unless more than two roads meet there.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Hashable, Sequence
from functools import partial

import numpy as np
from numpy.typing import NDArray

from ...network.restrictions import decode, encode
from ..barrier_reading import barrier_layer, is_barrier_tag, is_obeyed
from .graph_arrays import Attributes
from .graph_values import parts, tag_text

__all__ = ["behind_barriers"]

Ints = NDArray[np.integer]


def behind_barriers(
    nodes: Sequence[tuple[Hashable, Attributes]],
    tail: Ints,
    head: Ints,
    restrictions: Sequence[str],
    counts: Counter[str],
) -> list[str]:
    """Return the restrictions of edges, with those of the barriers that they begin at.

    Parameters
    ----------
    nodes : sequence of (Hashable, Attributes)
        All nodes of the graph, in the order of their positions.
    tail, head : ndarray of int, (m,)
        Node positions of the edges that are kept.
    restrictions : sequence of str, (m,)
        Of the edges themselves, in the form of `network.restrictions`.
    counts : Counter
        Counts barriers read, and what became of them.

    Returns
    -------
    list of str
        As many.
    """
    told = list(restrictions)
    touched = np.zeros(len(nodes), bool)
    touched[tail] = touched[head] = True
    for at in np.flatnonzero(touched).tolist():
        tags = _barrier_tags(nodes[at][1])
        if not tags.get("barrier"):
            continue
        layer = barrier_layer(tags)
        if is_obeyed(tags["barrier"], layer, partial(_meeting, at, tail, head), counts):
            for edge in np.flatnonzero(tail == at).tolist():
                told[edge] = encode((*decode(told[edge]), layer))
    return told


def _barrier_tags(attributes: Attributes) -> dict[str, str]:
    """Return the tags of a barrier; empty for nodes without one."""
    if not parts(attributes.get("barrier")):
        return {}
    tags = {
        key: ";".join(text for text in map(tag_text, parts(value)) if text)
        for key, value in attributes.items()
        if is_barrier_tag(key)
    }
    return {key: text for key, text in tags.items() if text}


def _meeting(node: int, tail: Ints, head: Ints) -> int:
    """Return how many roads meet at a node; two edges of one direction are two roads."""
    out, into = head[tail == node], tail[head == node]
    neighbours = len({*out.tolist(), *into.tolist()})
    return max(len(out), len(into), neighbours)
