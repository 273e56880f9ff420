"""A forbidden turn is not evaded by turning round behind it.

Where no turn is forbidden a shortest way never turns round. Where one is, the way past it and back
again would be a loophole: twenty metres down the road, at a mere point of its line, or at the next
junction, where a truck of 16 m cannot turn either. So whoever has come by the road with the
restriction may not turn round before the next junction, nor at it. Dead ends are no junctions:
there a truck has to turn, and may.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np
from numpy.typing import NDArray

from .turns import ForbiddenTurn

__all__ = ["no_turning_round"]

Index = NDArray[np.int64]


def no_turning_round(
    tail: Index, head: Index, node_count: int, turns: Sequence[ForbiddenTurn]
) -> list[ForbiddenTurn]:
    """Return the turns that would evade forbidden ones.

    Parameters
    ----------
    tail, head : ndarray of int64, (s,)
        Node positions of directed segments, all of them.
    node_count : int
        Number of nodes.
    turns : sequence of ForbiddenTurn
        What may not be driven.

    Returns
    -------
    list of ForbiddenTurn
        Each goes along a restriction but for its last turn, on by another road, and ends with
        turning round; it binds whom the restriction binds.
    """
    if not turns:
        return []
    roads = _Roads(tail, head, node_count)
    last: dict[tuple[tuple[int, ...], str], set[int]] = {}
    layers = {}
    for turn in turns:
        beginning = (turn.segments[:-1], repr(turn.layer))
        last.setdefault(beginning, set()).add(turn.segments[-1])
        layers[beginning] = turn.layer
    found = []
    for beginning, forbidden in last.items():
        before, layer = beginning[0], layers[beginning]
        for first in roads.leaving(int(head[before[-1]])):
            if first not in forbidden and int(head[first]) != int(tail[before[-1]]):
                ways = roads.turns_after(before[-1], first)
                found += [ForbiddenTurn((*before[:-1], *way), layer) for way in ways]
    return found


class _Roads:
    """Which segments leave a node, and how many roads meet there."""

    def __init__(self, tail: Index, head: Index, node_count: int) -> None:
        self.head = head
        self.tail = tail
        self.order = np.argsort(tail, kind="stable")
        self.first = np.searchsorted(tail[self.order], np.arange(node_count + 1))
        pairs = np.unique(np.sort(np.stack([tail, head]), axis=0), axis=1)
        self.neighbours = np.bincount(pairs[:, pairs[0] != pairs[1]].ravel(), minlength=node_count)

    def leaving(self, node: int) -> list[int]:
        """Return the segments that leave a node."""
        found: list[int] = self.order[self.first[node] : self.first[node + 1]].tolist()
        return found

    def turns_after(self, arriving: int, first: int) -> Iterator[tuple[int, ...]]:
        """Return the ways over two segments to the next junction that end with turning round."""
        driven = [arriving, first]
        while True:
            here, before = int(self.head[driven[-1]]), int(self.tail[driven[-1]])
            if self.neighbours[here] < 2:
                return
            onward = self.leaving(here)
            for back in onward:
                if int(self.head[back]) == before:
                    yield (*driven, back)
            along = [one for one in onward if int(self.head[one]) not in (before, here)]
            # A ring without a junction would never end.
            if self.neighbours[here] > 2 or len(along) != 1 or along[0] in driven:
                return
            driven.append(along[0])
