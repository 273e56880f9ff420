"""Ways of one truck in its window: alone, to every node, and from every node onward.

Of the ways of a truck to a node those are kept of which none is both earlier and cheaper; of those
from a node to its destination, of which none may leave later and is cheaper.
"""

from __future__ import annotations

import heapq
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..search.hierarchy.runtime.jit import compiled
from .instance import Instance

__all__ = ["Labels", "alone_ways", "labels_of"]

Ints = NDArray[np.int64]


def alone_ways(instance: Instance) -> tuple[list[Ints], list[Ints]]:
    """Return each truck's cheapest way alone, begun as early as it may.

    Parameters
    ----------
    instance : Instance
        The problem.

    Returns
    -------
    lanes, departs : list of ndarray of int64, (N, ...)
        In driving order.
    """
    lanes, departs = [], []
    for k in range(instance.trucks):
        own = slice(int(instance.first_pair[k]), int(instance.first_pair[k + 1]))
        route = instance.pair_lane[own][instance.on_alone[own]]
        onward = {int(instance.tail[lane]): int(lane) for lane in route}
        way, node = [], int(instance.origin[k])
        while node != instance.destination[k]:
            way.append(onward[node])
            node = int(instance.head[way[-1]])
        lanes.append(np.array(way, np.int64))
        drive = instance.drive[lanes[-1]]
        departs.append(instance.earliest[k] + np.concatenate([[0], np.cumsum(drive)[:-1]]))
    return lanes, departs


@dataclass(frozen=True, slots=True, eq=False)
class Labels:
    """Ways of all trucks from their origins, or to their destinations, none of them dominated.

    Attributes
    ----------
    first : ndarray of int64, (N + 1,)
        Where those of each truck begin; in order of time, and those onward the other way round.
    node : ndarray of int64
        Where the way leads, or begins.
    at : ndarray of int64
        The earliest arrival of a way there, or the latest departure of a way onward [ticks].
    cost : ndarray of int64
        What it costs alone [grains].
    parent, lane : ndarray of int64
        The label before, -1 for none, and the lane between.
    """

    first: Ints
    node: Ints
    at: Ints
    cost: Ints
    parent: Ints
    lane: Ints

    def way(self, label: int) -> list[int]:
        """Return the lanes from a label back to where its way begins.

        Parameters
        ----------
        label : int
            Its number.

        Returns
        -------
        list of int
            The one next to the label first.
        """
        found = []
        while self.parent[label] >= 0:
            found.append(int(self.lane[label]))
            label = int(self.parent[label])
        return found


def labels_of(instance: Instance, forward: bool) -> Labels:
    """Return the ways of all trucks.

    Parameters
    ----------
    instance : Instance
        The problem.
    forward : bool
        Whether from their origins; else to their destinations.

    Returns
    -------
    Labels
        None of them dominated.
    """
    return Labels(
        *_all_labels(
            forward, instance.first_pair, instance.pair_lane, instance.opens, instance.closes,
            instance.tail, instance.head, instance.drive, instance.alone, instance.origin,
            instance.destination, instance.earliest, instance.latest,
        )
    )  # fmt: skip


@compiled
def _all_labels(
    forward: bool,
    first_pair: Ints,
    pair_lane: Ints,
    opens: Ints,
    closes: Ints,
    tail: Ints,
    head: Ints,
    drive: Ints,
    alone: Ints,
    origin: Ints,
    destination: Ints,
    earliest: Ints,
    latest: Ints,
) -> tuple[Ints, Ints, Ints, Ints, Ints, Ints]:
    """Return all labels; those onward count time backward while they are made."""
    nodes: list[Any] = [np.int64(0) for _ in range(0)]
    ats: list[Any] = [np.int64(0) for _ in range(0)]
    costs: list[Any] = [np.int64(0) for _ in range(0)]
    parents: list[Any] = [np.int64(0) for _ in range(0)]
    lanes: list[Any] = [np.int64(0) for _ in range(0)]
    first = np.zeros(len(origin) + 1, np.int64)
    for k in range(len(origin)):
        base = len(nodes)
        start = origin[k] if forward else destination[k]
        at = earliest[k] if forward else -latest[k]
        best = {start: np.int64(1 << 60)}
        heap: list[Any] = [(at, np.int64(0), start, np.int64(-1), np.int64(-1))]
        while len(heap) > 0:
            now, paid, node, parent, lane = heapq.heappop(heap)
            if node in best and paid >= best[node] and len(nodes) > base:
                continue
            best[node] = paid
            own = len(nodes)
            nodes.append(node)
            ats.append(now if forward else -now)
            costs.append(paid)
            parents.append(parent)
            lanes.append(lane)
            for p in range(first_pair[k], first_pair[k + 1]):
                one = pair_lane[p]
                if forward:
                    if tail[one] != node:
                        continue
                    enters = max(now, opens[p])
                    if enters > closes[p]:
                        continue
                    heapq.heappush(
                        heap, (enters + drive[one], paid + alone[one], head[one], own, one)
                    )
                else:
                    if head[one] != node:
                        continue
                    enters = min(-now - drive[one], closes[p])
                    if enters < opens[p]:
                        continue
                    heapq.heappush(heap, (-enters, paid + alone[one], tail[one], own, one))
        first[k + 1] = len(nodes)
    count = len(nodes)
    out = np.empty((5, count), np.int64)
    for i in range(count):
        out[0, i], out[1, i], out[2, i] = nodes[i], ats[i], costs[i]
        out[3, i], out[4, i] = parents[i], lanes[i]
    return first, out[0], out[1], out[2], out[3], out[4]
