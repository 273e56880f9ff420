"""Two trucks with windows, exactly: where they merge, what they drive together, where they part.

With (t, c) the ways of a truck to a node of which none is both earlier and cheaper, two trucks that
merge at x leave it at max(t_1, t_2), having paid c_1 + c_2; together they pay 2 member + extra for
each lane that both may enter then; and they part at y if each still has a way in time, the cheapest
that is. All such labels (instant, cost) are kept of which none dominates another, so the plan is
the best of all with one stretch together, whatever detours it takes. Waiting is free.

Which pairs may save at all: those with a lane in common whose windows overlap. Pairs of a truck and
a lane that no best plan needs were dropped before (`windows`), and none that could save is lost.
"""

from __future__ import annotations

import heapq
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..errors import ScenarioError
from ..search.hierarchy.runtime.jit import compiled
from .instance import Instance
from .labels import Labels, labels_of

__all__ = ["PairOffer", "candidate_pairs", "pair_offers"]

Ints = NDArray[np.int64]

FAR = 1 << 60


@dataclass(frozen=True, slots=True, eq=False)
class PairOffer:
    """The best plan of two trucks with one stretch together.

    Attributes
    ----------
    first, second : int
        The trucks, the lower number first.
    saving : int
        What it saves against both alone [grains]; above 0.
    lanes, departs : tuple of ndarray of int64, (2, ...)
        Lanes of each in driving order, and when it enters them [ticks].
    """

    first: int
    second: int
    saving: int
    lanes: tuple[Ints, Ints]
    departs: tuple[Ints, Ints]


def candidate_pairs(instance: Instance) -> Ints:
    """Return the pairs of trucks that may save something together.

    Parameters
    ----------
    instance : Instance
        The problem.

    Returns
    -------
    ndarray of int64, (c, 2)
        The lower number first, sorted, each once.
    """
    order = np.lexsort((instance.opens, instance.pair_lane))
    helps = 2 * instance.member + instance.extra < 2 * instance.alone
    order = order[helps[instance.pair_lane[order]]]
    found = _overlapping(
        instance.pair_lane[order], instance.pair_truck[order], instance.opens[order],
        instance.closes[order],
    )  # fmt: skip
    low, high = found.min(axis=1), found.max(axis=1)
    unique = np.unique(low * instance.trucks + high)
    return np.stack([unique // instance.trucks, unique % instance.trucks], axis=1)


def pair_offers(instance: Instance) -> list[PairOffer]:
    """Return the best plan of every two trucks that save something together.

    Parameters
    ----------
    instance : Instance
        The problem; waiting must be free.

    Returns
    -------
    list of PairOffer
        By their trucks.

    Raises
    ------
    ScenarioError
        Waiting has a price.
    """
    if instance.waiting:
        raise ScenarioError("fleet: pairs are planned with free waiting; give waiting no price")
    there = labels_of(instance, True)
    onward = labels_of(instance, False)
    found = []
    for first, second in candidate_pairs(instance).tolist():
        offer = _offer(instance, there, onward, first, second)
        if offer is not None:
            found.append(offer)
    return found


@compiled
def _overlapping(lane: Ints, truck: Ints, opens: Ints, closes: Ints) -> Ints:
    """Return pairs of trucks with overlapping windows; sorted by lane and opening."""
    count = 0
    found = np.empty((1024, 2), np.int64)
    for i in range(len(lane)):
        for j in range(i + 1, len(lane)):
            if lane[j] != lane[i] or opens[j] > closes[i]:
                break
            if count == len(found):
                more = np.empty((2 * count, 2), np.int64)
                more[:count] = found
                found = more
            found[count, 0], found[count, 1] = truck[i], truck[j]
            count += 1
    return found[:count]


# -- two trucks ------------------------------------------------------------------------------------


def _offer(
    instance: Instance, there: Labels, onward: Labels, first: int, second: int
) -> PairOffer | None:
    both = int(instance.alone_cost[first] + instance.alone_cost[second])
    found = _best_pair(
        first, second, both, there.first, there.node, there.at, there.cost, onward.first,
        onward.node, onward.at, onward.cost, instance.first_pair, instance.pair_lane,
        instance.opens, instance.closes, instance.tail, instance.head, instance.drive,
        instance.member, instance.extra,
    )  # fmt: skip
    cost, merge, ends, together, enters = found
    if cost >= both:
        return None
    lanes, departs = [], []
    for place, k in enumerate((first, second)):
        before = there.way(int(merge[place]))[::-1]
        after = onward.way(int(ends[place]))
        at = int(instance.earliest[k])
        times = []
        for lane in before:
            times.append(at)
            at += int(instance.drive[lane])
        times += enters.tolist()
        at = int(enters[-1] + instance.drive[together[-1]])
        for lane in after:
            times.append(at)
            at += int(instance.drive[lane])
        lanes.append(np.array([*before, *together.tolist(), *after], np.int64))
        departs.append(np.array(times, np.int64))
    return PairOffer(
        first, second, both - int(cost), (lanes[0], lanes[1]), (departs[0], departs[1])
    )


@compiled
def _best_pair(
    i: int,
    j: int,
    both: int,
    first_there: Ints,
    there_node: Ints,
    there_at: Ints,
    there_cost: Ints,
    first_onward: Ints,
    onward_node: Ints,
    onward_at: Ints,
    onward_cost: Ints,
    first_pair: Ints,
    pair_lane: Ints,
    opens: Ints,
    closes: Ints,
    tail: Ints,
    head: Ints,
    drive: Ints,
    member: Ints,
    extra: Ints,
) -> tuple[int, Ints, Ints, Ints, Ints]:
    """Return cost, labels before the merge and after the separation, and the lanes between."""
    lane: list[Any] = [np.int64(0) for _ in range(0)]
    closed: list[Any] = [np.int64(0) for _ in range(0)]
    for p in range(first_pair[i], first_pair[i + 1]):
        for q in range(first_pair[j], first_pair[j + 1]):
            same = pair_lane[p] == pair_lane[q]
            if same and max(opens[p], opens[q]) <= min(closes[p], closes[q]):
                lane.append(pair_lane[p])
                closed.append(min(closes[p], closes[q]))
    node: list[Any] = [np.int64(0) for _ in range(0)]
    parent: list[Any] = [np.int64(0) for _ in range(0)]
    by: list[Any] = [np.int64(0) for _ in range(0)]
    entered: list[Any] = [np.int64(0) for _ in range(0)]
    of_i: list[Any] = [np.int64(0) for _ in range(0)]
    of_j: list[Any] = [np.int64(0) for _ in range(0)]
    none = np.int64(0)
    heap: list[Any] = [(none, none, none, none, none, none, none) for _ in range(0)]
    for x in range(first_there[i], first_there[i + 1]):
        for y in range(first_there[j], first_there[j + 1]):
            if there_node[x] != there_node[y]:
                continue
            at = max(there_at[x], there_at[y])
            # Instant, cost, node, parent, lane, and the labels that meet.
            heapq.heappush(
                heap,
                (at, there_cost[x] + there_cost[y], there_node[x], np.int64(-1), np.int64(-1),
                 np.int64(x), np.int64(y)),
            )  # fmt: skip
    best: Any = np.int64(both)
    best_label: Any = np.int64(-1)
    end_i, end_j = np.int64(-1), np.int64(-1)
    cheapest = {np.int64(-1): np.int64(0)}
    while len(heap) > 0:
        at, paid, here, before, last, x, y = heapq.heappop(heap)
        if here in cheapest and paid >= cheapest[here]:
            continue
        if paid >= best:
            continue
        cheapest[here] = paid
        own = len(node)
        node.append(here)
        parent.append(before)
        by.append(last)
        of_i.append(x)
        of_j.append(y)
        entered.append(at - drive[last] if last >= 0 else np.int64(0))
        if last >= 0:
            left_i, left_j = np.int64(1 << 60), np.int64(1 << 60)
            at_i, at_j = np.int64(-1), np.int64(-1)
            for z in range(first_onward[i], first_onward[i + 1]):
                if onward_node[z] == here and onward_at[z] >= at and onward_cost[z] < left_i:
                    left_i, at_i = onward_cost[z], np.int64(z)
            for z in range(first_onward[j], first_onward[j + 1]):
                if onward_node[z] == here and onward_at[z] >= at and onward_cost[z] < left_j:
                    left_j, at_j = onward_cost[z], np.int64(z)
            if at_i >= 0 and at_j >= 0 and paid + left_i + left_j < best:
                best = paid + left_i + left_j
                best_label, end_i, end_j = np.int64(own), at_i, at_j
        for z in range(len(lane)):
            one = lane[z]
            if tail[one] == here and at <= closed[z]:
                heapq.heappush(
                    heap,
                    (at + drive[one], paid + 2 * member[one] + extra[one], head[one],
                     np.int64(own), one, x, y),
                )  # fmt: skip
    merge = np.full(2, -1, np.int64)
    ends = np.array([end_i, end_j])
    count = 0
    label = best_label
    while label >= 0 and parent[label] >= 0:
        count += 1
        label = parent[label]
    together = np.empty(count, np.int64)
    enters = np.empty(count, np.int64)
    if best_label >= 0:
        label = best_label
        for z in range(count - 1, -1, -1):
            together[z], enters[z] = by[label], entered[label]
            label = parent[label]
        merge[0], merge[1] = of_i[best_label], of_j[best_label]
    return best, merge, ends, together, enters
