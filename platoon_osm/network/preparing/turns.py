"""Forbidden turns are obeyed by splitting nodes: who may not turn arrives at a copy of the node.

A turn restriction is a sequence of directed segments that may not be driven in full: from, perhaps
some between, to. For each of them, whoever drives the first arrives at a copy of the node at its
end, from which copies of all segments lead on; along the sequence they lead to further copies, and
at the last node the forbidden segment is missing, or is a copy that carries the restriction if it
binds some vehicles only. So any search that knows nothing of turns obeys them.

Sequences are worked off one after another on the graph as it has become; a segment that has copies
is the beginning of the sequence in each of them. A copy that only one segment leads to is changed
in place. (Villeneuve and Desaulniers, "The shortest path problem with forbidden paths", European
Journal of Operational Research 165, 2005.)
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ..restrictions import Layer

__all__ = ["ForbiddenTurn", "SplitSegments", "split_turns"]

Index = NDArray[np.int64]


@dataclass(frozen=True, slots=True)
class ForbiddenTurn:
    """A sequence of segments that may not be driven.

    Attributes
    ----------
    segments : tuple of int
        Two or more directed segments, each beginning where the one before it ends.
    layer : mapping of str to str or None
        Whom it binds, as tags of access; None for everybody.
    """

    segments: tuple[int, ...]
    layer: Layer | None = None


@dataclass(frozen=True, slots=True, eq=False)
class SplitSegments:
    """Directed segments that obey turn restrictions.

    Attributes
    ----------
    tail, head : ndarray of int64, (s,)
        Node positions; copies come behind the nodes there were.
    origin : ndarray of int64, (s,)
        The segment that each one is, or is a copy of.
    node_origin : ndarray of int64, (n,)
        The node that each one is, or is a copy of.
    layers : dict of int to tuple of Layer
        By segment, whom the turn onto it is forbidden to; those of no entry are open to all.
    """

    tail: Index
    head: Index
    origin: Index
    node_origin: Index
    layers: dict[int, tuple[Layer, ...]]


def split_turns(
    tail: Index, head: Index, node_count: int, turns: Sequence[ForbiddenTurn]
) -> SplitSegments:
    """Split nodes so that no forbidden sequence is left.

    Parameters
    ----------
    tail, head : ndarray of int64, (s,)
        Node positions of directed segments.
    node_count : int
        Number of nodes.
    turns : sequence of ForbiddenTurn
        What may not be driven.

    Returns
    -------
    SplitSegments
        The first s segments are those given, though some lead to copies of their nodes.
    """
    if not turns:
        every = np.arange(len(tail), dtype=np.int64)
        return SplitSegments(tail, head, every, np.arange(node_count, dtype=np.int64), {})
    graph = _Graph(tail, head, node_count, turns)
    for turn in turns:
        for first in list(graph.copies.get(turn.segments[0], ())):
            graph.forbid(first, turn)
    return graph.result()


class _Graph:
    """The segments near restrictions, as lists that grow."""

    def __init__(
        self, tail: Index, head: Index, node_count: int, turns: Sequence[ForbiddenTurn]
    ) -> None:
        self.tail: list[int] = tail.tolist()
        self.head: list[int] = head.tolist()
        self.origin = list(range(len(self.tail)))
        self.node_origin = list(range(node_count))
        self.node_count = node_count
        self.layers: dict[int, tuple[Layer, ...]] = {}
        self.gone: set[int] = set()
        touched = {self.head[one] for turn in turns for one in turn.segments}
        touched |= {self.tail[one] for turn in turns for one in turn.segments}
        # Only nodes that restrictions pass, and those that copied segments lead to, are looked at.
        self.out: dict[int, list[int]] = {node: [] for node in touched}
        self.arrivals = [0] * node_count
        for segment, (start, end) in enumerate(zip(self.tail, self.head, strict=True)):
            if start in self.out:
                self.out[start].append(segment)
            self.arrivals[end] += 1
        self.copies: dict[int, list[int]] = {turn.segments[0]: [turn.segments[0]] for turn in turns}

    def forbid(self, first: int, turn: ForbiddenTurn) -> None:
        """Forbid a sequence to whoever begins it by one segment or copy."""
        path = self._path(first, turn.segments)
        if path is None:
            return
        arriving = path[0]
        for place, onward in enumerate(path[1:], 1):
            node = self._own(arriving)
            here = next(one for one in self.out[node] if self.origin[one] == self.origin[onward])
            if place < len(path) - 1:
                arriving = here
            elif turn.layer is None:
                self._remove(here)
            elif turn.layer not in self.layers.get(here, ()):
                self.layers[here] = (*self.layers.get(here, ()), turn.layer)

    def _path(self, first: int, segments: tuple[int, ...]) -> list[int] | None:
        """Return the sequence as it stands from one of its beginnings; None if it is gone."""
        path = [first]
        for wanted in segments[1:]:
            here = self.out.get(self.head[path[-1]], [])
            found = [one for one in here if self.origin[one] == wanted]
            if not found:
                return None
            path.append(found[0])
        return path

    def _own(self, arriving: int) -> int:
        """Return the node that a segment leads to, a copy that no other one leads to."""
        node = self.head[arriving]
        if node >= self.node_count and self.arrivals[node] == 1:
            return node
        copy = len(self.node_origin)
        self.node_origin.append(self.node_origin[node])
        self.arrivals.append(1)
        self.arrivals[node] -= 1
        self.head[arriving] = copy
        self.out[copy] = []
        for one in self.out[node]:
            self._copied(one, copy)
        return copy

    def _copied(self, segment: int, tail: int) -> None:
        own = len(self.tail)
        self.tail.append(tail)
        self.head.append(self.head[segment])
        self.origin.append(self.origin[segment])
        self.arrivals[self.head[segment]] += 1
        self.out[tail].append(own)
        if segment in self.layers:
            self.layers[own] = self.layers[segment]
        if self.origin[segment] in self.copies:
            self.copies[self.origin[segment]].append(own)

    def _remove(self, segment: int) -> None:
        self.out[self.tail[segment]].remove(segment)
        self.arrivals[self.head[segment]] -= 1
        self.gone.add(segment)
        if self.origin[segment] in self.copies:
            self.copies[self.origin[segment]].remove(segment)

    def result(self) -> SplitSegments:
        kept = [one for one in range(len(self.tail)) if one not in self.gone]
        place = {one: k for k, one in enumerate(kept)}
        tail, head, origin = (
            np.array([values[one] for one in kept], np.int64)
            for values in (self.tail, self.head, self.origin)
        )
        return SplitSegments(
            tail,
            head,
            origin,
            np.array(self.node_origin, np.int64),
            {place[one]: layers for one, layers in self.layers.items() if one in place},
        )
