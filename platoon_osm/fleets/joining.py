"""How one truck best joins a platoon that drives already: where, how far, and how much later.

The platoon keeps its roads and the times between them, and may leave later as a whole, by no more
than its members' windows allow. The truck drives alone to some lane of it, in company over lanes
that follow each other without a stop, and alone onward. It may also join a member before or after
that one's company, as long as the member is then in company without a break. Of all such ways the
cheapest is found: for each lane to join at and each way there that no other beats, the lanes ahead
are tried in order of time.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from ..search.hierarchy.runtime.jit import compiled
from .instance import Instance
from .labels import Labels, labels_of
from .one_group import Group, Windows, group_of, passes_twice

__all__ = ["Joining"]

Ints = NDArray[np.int64]


class Joining:
    """How trucks of a fleet join platoons.

    Parameters
    ----------
    instance : Instance
        The problem; waiting must be free.
    """

    def __init__(self, instance: Instance) -> None:
        self.instance = instance
        self.windows = Windows(instance)
        self._there: Labels = labels_of(instance, True)
        self._onward: Labels = labels_of(instance, False)

    def gains(self, group: Group, trucks: Sequence[int]) -> Ints:
        """Return what a platoon saves more with each of some trucks.

        Parameters
        ----------
        group : Group
            The platoon.
        trucks : sequence of int
            None of them in it.

        Returns
        -------
        ndarray of int64
            What it saves more [grains]; 0 if it saves nothing.
        """
        return self._tried(group, trucks)[0][:, 0]

    def joined(self, group: Group, truck: int) -> Group | None:
        """Return a platoon with one truck more.

        Parameters
        ----------
        group : Group
            The platoon.
        truck : int
            Not in it.

        Returns
        -------
        Group or None
            None if it saves nothing more, or only by passing a place twice.
        """
        table, chain = self._tried(group, [truck])
        gain, later, there, onward, count = table[0].tolist()
        if gain <= 0:
            return None
        instance = self.instance
        lane = np.concatenate(group.lanes)[chain[:count]]
        at = np.concatenate(group.departs)[chain[:count]] + later
        before = np.array(self._there.way(there)[::-1], np.int64)
        after = np.array(self._onward.way(onward), np.int64)
        driven = np.concatenate([before, lane, after])
        if passes_twice(instance, driven):
            return None
        early = int(instance.earliest[truck]) + _sums(instance, before)[:-1]
        late = int(at[-1] + instance.drive[lane[-1]]) + _sums(instance, after)[:-1]
        return group_of(
            instance, self.windows, [*group.trucks, truck],
            [*group.lanes, driven],
            [*(own + later for own in group.departs), np.concatenate([early, at, late])],
        )  # fmt: skip

    def without(self, group: Group, truck: int) -> Group | None:
        """Return a platoon with one truck less.

        Parameters
        ----------
        group : Group
            The platoon.
        truck : int
            One of it.

        Returns
        -------
        Group or None
            None if the others are no platoon then.
        """
        stay = [place for place, k in enumerate(group.trucks) if k != truck]
        return group_of(
            self.instance, self.windows, [group.trucks[place] for place in stay],
            [group.lanes[place] for place in stay], [group.departs[place] for place in stay],
        )  # fmt: skip

    def _tried(self, group: Group, trucks: Sequence[int]) -> tuple[Ints, Ints]:
        instance, there, onward = self.instance, self._there, self._onward
        sizes = np.array([len(own) for own in group.lanes])
        first = np.concatenate([[0], np.cumsum(sizes)])
        return _joins(
            np.array(trucks, np.int64), np.concatenate(group.lanes), np.concatenate(group.departs),
            first, first[:-1] + np.array(group.begins), first[:-1] + np.array(group.ends),
            group.slack, instance.nodes, instance.first_pair, instance.pair_lane, instance.closes,
            instance.tail, instance.head, instance.drive, instance.alone, instance.member,
            instance.extra, instance.alone_cost, there.first, there.node, there.at, there.cost,
            onward.first, onward.node, onward.at, onward.cost,
        )  # fmt: skip


def _sums(instance: Instance, lanes: Ints) -> Ints:
    return np.concatenate([[0], np.cumsum(instance.drive[lanes])]).astype(np.int64)


@compiled
def _joins(
    trucks: Ints,
    lane: Ints,
    at: Ints,
    first: Ints,
    begins: Ints,
    ends: Ints,
    slack: int,
    nodes: int,
    first_pair: Ints,
    pair_lane: Ints,
    closes: Ints,
    tail: Ints,
    head: Ints,
    drive: Ints,
    alone: Ints,
    member: Ints,
    extra: Ints,
    alone_cost: Ints,
    first_there: Ints,
    there_node: Ints,
    there_at: Ints,
    there_cost: Ints,
    first_onward: Ints,
    onward_node: Ints,
    onward_at: Ints,
    onward_cost: Ints,
) -> tuple[Ints, Ints]:
    """Return gain, delay, both labels and number of lanes of each truck, and the last one's lanes.

    Places in the platoon are numbered one member after another; of those that are one lane at one
    instant, the first stands for all.
    """
    far = np.int64(1 << 60)
    n = len(lane)
    stands = np.zeros(n, np.bool_)
    price = np.empty(n, np.int64)
    # Where a chain may begin and end, and who must be next to a place; -1 for anybody.
    may_begin, may_end = np.ones(n, np.bool_), np.ones(n, np.bool_)
    must_follow, must_lead = np.full(n, -1, np.int64), np.full(n, -1, np.int64)
    for g in range(len(first) - 1):
        for e in range(first[g], first[g + 1]):
            size = 0
            stands[e] = True
            for f in range(n):
                if lane[f] == lane[e] and at[f] == at[e]:
                    size += 1
                    if f < e:
                        stands[e] = False
            one = lane[e]
            price[e] = member[one] if size > 1 else 2 * member[one] + extra[one] - alone[one]
            if size > 1:
                continue
            if e < begins[g]:
                rolls = at[e] + drive[one] == at[e + 1]
                if e == begins[g] - 1:
                    may_end[e] = rolls
                else:
                    may_end[e] = False
                    must_lead[e] = e + 1
            elif e > ends[g]:
                may_begin[e] = False
                must_follow[e] = e - 1
    order = np.argsort(at, kind="mergesort")
    follows = np.full((n, 8), -1, np.int64)
    for e in range(n):
        count = 0
        for f in range(n):
            fits = tail[lane[f]] == head[lane[e]] and at[f] == at[e] + drive[lane[e]]
            if not (stands[e] and stands[f] and fits) or count == 8:
                continue
            if must_lead[e] >= 0 and f != must_lead[e]:
                # The next place of the member may be one of a company, where another stands for it.
                g = must_lead[e]
                if lane[f] != lane[g] or at[f] != at[g]:
                    continue
            if must_follow[f] >= 0 and e != must_follow[f]:
                g = must_follow[f]
                if lane[e] != lane[g] or at[e] != at[g]:
                    continue
            follows[e, count] = f
            count += 1
    table = np.zeros((len(trucks), 5), np.int64)
    chain = np.zeros(n, np.int64)
    until = np.full(len(tail), -1, np.int64)
    node_there, node_onward = np.full(nodes, -1, np.int64), np.full(nodes, -1, np.int64)
    value, before = np.empty(n, np.int64), np.empty(n, np.int64)
    for row in range(len(trucks)):
        c = trucks[row]
        for p in range(first_pair[c], first_pair[c + 1]):
            until[pair_lane[p]] = closes[p]
        a, b = first_there[c], first_there[c + 1]
        next_there = np.full(b - a, -1, np.int64)
        for x in range(a, b):
            next_there[x - a] = node_there[there_node[x]]
            node_there[there_node[x]] = x
        d, f0 = first_onward[c], first_onward[c + 1]
        next_onward = np.full(f0 - d, -1, np.int64)
        for z in range(d, f0):
            next_onward[z - d] = node_onward[onward_node[z]]
            node_onward[onward_node[z]] = z
        best = alone_cost[c]
        for place in range(n):
            i = order[place]
            if not stands[i] or not may_begin[i] or until[lane[i]] < at[i]:
                continue
            at_once = False
            start = node_there[tail[lane[i]]]
            while start >= 0:
                later = max(np.int64(0), there_at[start] - at[i])
                start = next_there[start - a]
                if later > slack or at[i] + later > until[lane[i]] or (later == 0 and at_once):
                    continue
                at_once = at_once or later == 0
                # The cheapest way there by then.
                paid, label = far, np.int64(-1)
                x = node_there[tail[lane[i]]]
                while x >= 0:
                    if there_at[x] <= at[i] + later and there_cost[x] < paid:
                        paid, label = there_cost[x], x
                    x = next_there[x - a]
                if label < 0 or paid >= best:
                    continue
                value[:] = far
                value[i], before[i] = paid + price[i], -1
                for step in range(place, n):
                    e = order[step]
                    if value[e] >= best:
                        continue
                    if may_end[e]:
                        z = node_onward[head[lane[e]]]
                        there = at[e] + drive[lane[e]] + later
                        while z >= 0:
                            total = value[e] + onward_cost[z]
                            if onward_at[z] >= there and total < best:
                                best = total
                                count = 0
                                back = e
                                while back >= 0:
                                    count += 1
                                    back = before[back]
                                back = e
                                for spot in range(count - 1, -1, -1):
                                    chain[spot] = back
                                    back = before[back]
                                table[row, 0] = alone_cost[c] - best
                                table[row, 1], table[row, 2] = later, label
                                table[row, 3], table[row, 4] = z, count
                            z = next_onward[z - d]
                    for spot in range(8):
                        f = follows[e, spot]
                        if f < 0:
                            break
                        if at[f] + later > until[lane[f]]:
                            continue
                        if value[e] + price[f] < value[f]:
                            value[f], before[f] = value[e] + price[f], e
        for p in range(first_pair[c], first_pair[c + 1]):
            until[pair_lane[p]] = -1
        for x in range(a, b):
            node_there[there_node[x]] = -1
        for z in range(d, f0):
            node_onward[onward_node[z]] = -1
    return table, chain
