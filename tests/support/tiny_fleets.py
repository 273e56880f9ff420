"""All schedules of tiny fleets, the linear program over them, and shares tried one by one."""

from itertools import combinations

import numpy as np
from scipy.optimize import linprog


def all_schedules(fleet, k):
    """Return all schedules of a truck in whole ticks: tuples of (lane, instant)."""
    own = slice(fleet.first_pair[k], fleet.first_pair[k + 1])
    windows = {
        int(lane): (int(a), int(b))
        for lane, a, b in zip(
            fleet.pair_lane[own], fleet.opens[own], fleet.closes[own], strict=True
        )
    }
    found = []

    def go(node, ready, done, seen):
        if node == fleet.destination[k]:
            found.append(tuple(done))
            return
        for lane, (opens, closes) in windows.items():
            if fleet.tail[lane] != node or fleet.head[lane] in seen:
                continue
            for instant in range(max(ready, opens), closes + 1):
                go(
                    int(fleet.head[lane]), instant + int(fleet.drive[lane]),
                    [*done, (lane, instant)], {*seen, int(fleet.head[lane])},
                )  # fmt: skip

    go(int(fleet.origin[k]), int(fleet.earliest[k]), [], {int(fleet.origin[k])})
    return found


def waiting_cost(fleet, schedule):
    """Return what a schedule pays for waiting on the road."""
    ends = [at + int(fleet.drive[lane]) for lane, at in schedule[:-1]]
    return fleet.waiting * sum(at - end for end, (_, at) in zip(ends, schedule[1:], strict=True))


def linear_bound(fleet, schedules):
    """Return the value of the linear program over mixes of schedules and of companies."""
    columns, rows, costs, right = [], {}, [], []

    def row(name, value):
        if name not in rows:
            rows[name] = len(rows)
            right.append(value)
        return rows[name]

    present = {}
    for k, own in enumerate(schedules):
        for schedule in own:
            column = {row(("one", k), 1.0): 1.0}
            for cell in schedule:
                column[row((k, cell), 0.0)] = 1.0
                present.setdefault(cell, set()).add(k)
            columns.append(column)
            costs.append(float(waiting_cost(fleet, schedule)))
    most = fleet.largest or len(schedules)
    for cell, trucks in present.items():
        for n in range(1, min(most, len(trucks)) + 1):
            for company in combinations(sorted(trucks), n):
                columns.append({row((k, cell), 0.0): -1.0 for k in company})
                lane = cell[0]
                costs.append(
                    fleet.alone[lane] if n == 1 else n * fleet.member[lane] + fleet.extra[lane]
                )
    matrix = np.zeros((len(rows), len(columns)))
    for j, column in enumerate(columns):
        for i, value in column.items():
            matrix[i, j] = value
    done = linprog(costs, A_eq=matrix, b_eq=right, bounds=(0, None), method="highs")
    assert done.status == 0, done.message
    return float(done.fun)


def valid_by_trying(fleet, shares):
    """Tell whether no company of listed trucks pays more than it costs, in whole numbers."""
    ends = np.append(shares.starts[1:], np.iinfo(np.int64).max)
    ends[shares.lane_first[1:][shares.lane_first[1:] > 0] - 1] = np.iinfo(np.int64).max
    members = {}
    for j, p in enumerate(shares.pairs):
        own = shares.share[shares.first_share[j] : shares.first_share[j + 1]]
        first = shares.first_bucket[j]
        last = first + len(own) - 1
        lane = fleet.pair_lane[p]
        inside = shares.lane_first[lane] <= first <= last < shares.lane_first[lane + 1]
        if not inside or shares.starts[first] > fleet.opens[p] or ends[first] <= fleet.opens[p]:
            return False
        if shares.starts[last] > fleet.closes[p] or ends[last] <= fleet.closes[p]:
            return False
        for i, share in enumerate(own.tolist()):
            members.setdefault((int(lane), int(first) + i), []).append(share)
    for (lane, _), own in members.items():
        extra = int(fleet.extra[lane])
        leader = int(fleet.leader_saves[lane])
        if max(own) > extra + leader:
            return False
        most = fleet.largest or len(own)
        for n in range(2, min(most, len(own)) + 1):
            if any(sum(company) > extra for company in combinations(own, n)):
                return False
    return True


def cost_under(fleet, shares, schedules):
    """Return what the cheapest schedules cost together under shares, trying all schedules."""
    listed = {int(p): j for j, p in enumerate(shares.pairs)}
    total = 0
    for k, own in enumerate(schedules):
        pair = {
            int(fleet.pair_lane[p]): p for p in range(fleet.first_pair[k], fleet.first_pair[k + 1])
        }

        def price(lane, instant, pair=pair):
            j = listed.get(int(pair[lane]))
            leader = fleet.leader_saves[lane]
            share = -leader
            if j is not None:
                bounds = shares.starts[shares.lane_first[lane] : shares.lane_first[lane + 1]]
                bucket = shares.lane_first[lane] + np.searchsorted(bounds, instant, "right") - 1
                share = shares.share[shares.first_share[j] + bucket - shares.first_bucket[j]]
            return min(fleet.alone[lane], fleet.member[lane] + share)

        total += min(
            sum(price(*cell) for cell in schedule) + waiting_cost(fleet, schedule)
            for schedule in own
        )
    return int(total)
