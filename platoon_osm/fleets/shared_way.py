"""The cheapest way of some trucks that merge at one node, drive on together, part at one.

With the ways of each truck to a node of which none is both earlier and cheaper, trucks that merge
at x at an instant have paid the sum of their cheapest ways there by then. Together k of them pay
k member + extra for each lane that all may enter then, without a stop; and they part at y if each
still has a way in time, the cheapest that is. All labels (instant, cost) are kept of which none
dominates another, so the plan is the cheapest with such a stretch, whatever it costs more than
driving alone. Waiting is free.

Others may be on the roads already. Then k trucks enter a lane as they arrive, or wait until others
enter it, and pay what that company pays more with k more.
"""

from __future__ import annotations

import heapq
from collections import defaultdict
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from types import MappingProxyType

import numpy as np
from numpy.typing import NDArray

from .instance import Instance
from .labels import Labels, labels_of
from .plan.schedules import company_cost

__all__ = ["NOBODY", "Others", "SharedWays"]

Ints = NDArray[np.int64]
Ways = tuple[list[Ints], list[Ints]]
Others = Mapping[int, Mapping[int, int]]
"""How many enter a lane at an instant, by lane and instant."""

NOBODY: Others = MappingProxyType({})


@dataclass(frozen=True, slots=True)
class _Spot:
    """A node that all have reached together: where from, and how the first one was reached."""

    node: int
    at: int
    before: int
    lane: int
    entered: int
    labels: tuple[int, ...]


class SharedWays:
    """Ways with a stretch in common.

    Parameters
    ----------
    instance : Instance
        The problem; waiting must be free.
    """

    def __init__(self, instance: Instance) -> None:
        self.instance = instance
        self._there = labels_of(instance, True)
        self._onward = labels_of(instance, False)

    def of(
        self, trucks: Sequence[int], whole: bool = False, others: Others = NOBODY
    ) -> Ways | None:
        """Return the cheapest ways of some trucks with a stretch on which all are together.

        Parameters
        ----------
        trucks : sequence of int
            Two or more.
        whole : bool
            Whether they drive together from start to end; they have one origin and destination.
        others : mapping of int to mapping of int to int
            How many others enter a lane at an instant, by lane and instant [ticks].

        Returns
        -------
        lanes, departs : list of ndarray of int64
            Of each truck in their order, and when it enters them [ticks].

        Notes
        -----
        None is returned if no stretch is in the windows of all.
        """
        instance, size = self.instance, len(trucks)
        there = [_by_node(self._there, k) for k in trucks]
        onward = [_by_node(self._onward, k) for k in trucks]
        out = self._lanes(trucks)
        spots: list[_Spot] = []
        # Cost is second, so that of labels of one instant the cheapest comes first.
        heap: list[tuple[int, int, int, int, int, int, tuple[int, ...]]] = []
        for node in set.intersection(*(set(own) for own in there)):
            if whole and node != instance.origin[trucks[0]]:
                continue
            for at in {at for own in there for at, *_ in own[node]}:
                found = [_cheapest(own[node], at, 1) for own in there]
                if all(found):
                    cost = sum(one[1] for one in found if one)
                    labels = tuple(one[2] for one in found if one)
                    heapq.heappush(heap, (at, cost, node, -1, -1, at, labels))
        cheapest: dict[tuple[int, bool], int] = {}
        best: tuple[int, int, tuple[int, ...]] | None = None
        while heap:
            at, paid, node, before, lane, entered, labels = heapq.heappop(heap)
            # Who has merged here has no stretch yet, and is not as good as who comes with one.
            known = (node, lane >= 0)
            if known in cheapest and paid >= cheapest[known]:
                continue
            cheapest[known] = paid
            own = len(spots)
            spots.append(_Spot(node, at, before, lane, entered, labels))
            if lane >= 0 and not (whole and node != instance.destination[trucks[0]]):
                ends = [_cheapest(ways.get(node, []), at, -1) for ways in onward]
                if all(ends):
                    total = paid + sum(one[1] for one in ends if one)
                    if best is None or total < best[0]:
                        best = (total, own, tuple(one[2] for one in ends if one))
            for one, opens, closes in out.get(node, ()):
                there_now = others.get(one, {})
                for enters in {at, *(then for then in there_now if at < then)}:
                    if not opens <= enters <= closes:
                        continue
                    cost = paid + self._more(one, size, there_now.get(enters, 0))
                    then, head = enters + int(instance.drive[one]), int(instance.head[one])
                    heapq.heappush(heap, (then, cost, head, own, one, enters, labels))
        return None if best is None else self._ways(trucks, spots, best[1], best[2])

    def _more(self, lane: int, size: int, there: int) -> int:
        """Return what a company pays more with some trucks more."""
        instance, one = self.instance, np.array([lane])
        table = (instance.alone[one], instance.member[one], instance.extra[one], instance.largest)
        before = int(company_cost(there, *table)[0]) if there else 0
        return int(company_cost(there + size, *table)[0]) - before

    def _lanes(self, trucks: Sequence[int]) -> dict[int, list[tuple[int, int, int]]]:
        """Return lanes that all may enter at some instant, by tail, and from when to when."""
        instance = self.instance
        windows: dict[int, list[tuple[int, int]]] = defaultdict(list)
        for k in trucks:
            for p in range(int(instance.first_pair[k]), int(instance.first_pair[k + 1])):
                windows[int(instance.pair_lane[p])].append(
                    (int(instance.opens[p]), int(instance.closes[p]))
                )
        out: dict[int, list[tuple[int, int, int]]] = defaultdict(list)
        for lane, own in sorted(windows.items()):
            opens, closes = max(first for first, _ in own), min(last for _, last in own)
            if len(own) == len(trucks) and opens <= closes:
                out[int(instance.tail[lane])].append((lane, opens, closes))
        return out

    def _ways(
        self, trucks: Sequence[int], spots: list[_Spot], last: int, ends: tuple[int, ...]
    ) -> Ways:
        instance = self.instance
        shared: list[int] = []
        enters: list[int] = []
        at = last
        while spots[at].before >= 0:
            shared.insert(0, spots[at].lane)
            enters.insert(0, spots[at].entered)
            at = spots[at].before
        lanes, departs = [], []
        for place, k in enumerate(trucks):
            before = self._there.way(spots[last].labels[place])[::-1]
            after = self._onward.way(ends[place])
            early = _times(instance, before, int(instance.earliest[k]))
            late = _times(instance, after, spots[last].at)
            lanes.append(np.array([*before, *shared, *after], np.int64))
            departs.append(np.array([*early, *enters, *late], np.int64))
        return lanes, departs


def _times(instance: Instance, lanes: Sequence[int], at: int) -> list[int]:
    found = []
    for lane in lanes:
        found.append(at)
        at += int(instance.drive[lane])
    return found


def _by_node(labels: Labels, truck: int) -> dict[int, list[tuple[int, int, int]]]:
    """Return instant, cost and number of a truck's labels at each node."""
    found: dict[int, list[tuple[int, int, int]]] = defaultdict(list)
    for x in range(int(labels.first[truck]), int(labels.first[truck + 1])):
        found[int(labels.node[x])].append((int(labels.at[x]), int(labels.cost[x]), x))
    return dict(found)


def _cheapest(
    labels: Sequence[tuple[int, int, int]], at: int, sign: int
) -> tuple[int, int, int] | None:
    """Return the cheapest label there by an instant (1), or that still may leave then (-1)."""
    fits = [one for one in labels if sign * one[0] <= sign * at]
    return min(fits, key=lambda one: (one[1], one[2])) if fits else None
