"""Tiny fleets, all their schedules, and what is best and what the linear program says of them."""

from itertools import combinations

import numpy as np
from scipy.optimize import linprog

from platoon_osm.fleets.instance import Instance

MODELS = ("leader saves nothing", "all save alike", "between")


def tiny_fleet(rng, trucks=3, given=False, largest=0, slack=3, model=None, kinds=1):
    """Return a random fleet on few lanes, with all pairs that are in time."""
    nodes = int(rng.integers(3, 6))
    ends = [(i, j) for i in range(nodes) for j in range(nodes) if i != j]
    # A chain makes sure of ways; other lanes are drawn, also beside it and back.
    lanes = [(i, i + 1) for i in range(nodes - 1)]
    lanes += [ends[i] for i in rng.choice(len(ends), int(rng.integers(1, 5)))]
    lanes = [lane for lane in lanes for _ in range(kinds)]
    count = len(lanes)
    lane_kind = np.tile(np.arange(kinds), count // kinds)
    drive = rng.integers(1, 4, count)
    alone = drive * rng.integers(8, 13, count)
    model = model or MODELS[rng.integers(3)]
    saved = np.maximum(alone // int(rng.integers(3, 8)), 1)
    member = alone - saved
    leader = {
        "leader saves nothing": 0 * saved, "all save alike": saved,
        "between": rng.integers(0, saved + 1),
    }[model]  # fmt: skip
    extra = alone - member - leader
    tail, head = np.array(lanes).T
    rows, origin, destination, earliest, latest, departure, costs, of = [], [], [], [], [], [], [], []
    while len(of) < trucks:
        one, two = sorted(rng.choice(nodes, 2, replace=False))
        kind = int(rng.integers(kinds))
        first = int(rng.integers(0, 4))
        paths = list(simple_paths(lanes, lane_kind, one, two, kind))
        best = min(paths, key=lambda path: (alone[path].sum(), path))
        last = first + drive[best].sum() + int(rng.integers(0, slack + 1))
        leaves = int(rng.integers(first, last - drive[best].sum() + 1))
        if rng.random() < 0.6:
            leaves = last
        k = len(of)
        use = [best] if given else [path for path in paths if first + drive[path].sum() <= last]
        windows = {}
        for path in use:
            before = np.concatenate([[0], np.cumsum(drive[path])])
            for i, lane in enumerate(path):
                closes = last - (before[-1] - before[i])
                closes = min(closes, leaves) if tail[lane] == one else closes
                old = windows.get(lane, (first + before[i], closes))
                windows[lane] = (min(old[0], first + before[i]), max(old[1], closes))
        for lane in sorted(windows, key=lambda lane: (tail[lane], lane)):
            if windows[lane][0] <= windows[lane][1]:
                rows.append((k, lane, *windows[lane], lane in best))
        origin.append(one)
        destination.append(two)
        earliest.append(first)
        latest.append(last)
        departure.append(leaves)
        costs.append(alone[best].sum())
        of.append(kind)
    truck, lane, opens, closes, on_alone = (np.array(column) for column in zip(*rows, strict=True))
    return Instance(
        nodes=nodes, tail=tail, head=head, drive=drive, alone=alone, member=member, extra=extra,
        lane_kind=lane_kind, origin=np.array(origin), destination=np.array(destination),
        earliest=np.array(earliest), latest_departure=np.array(departure),
        latest=np.array(latest), kind=np.array(of), largest=largest, given=given, waiting=0,
        first_pair=np.searchsorted(truck, np.arange(trucks + 1)), pair_truck=truck,
        pair_lane=lane, opens=opens, closes=closes, on_alone=on_alone.astype(bool),
        alone_cost=np.array(costs),
    )  # fmt: skip


def simple_paths(lanes, lane_kind, here, there, kind, seen=()):
    """Yield all paths that pass no place twice, as lists of lanes."""
    if here == there:
        yield []
        return
    for lane, (u, v) in enumerate(lanes):
        if u == here and lane_kind[lane] == kind and v not in (*seen, here):
            for rest in simple_paths(lanes, lane_kind, v, there, kind, (*seen, here)):
                yield [lane, *rest]


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


def company_cost(fleet, lane, n):
    """Return what n trucks pay that enter a lane at one instant, split at its best."""
    alone, member, extra = (
        int(getattr(fleet, name)[lane]) for name in ("alone", "member", "extra")
    )
    most = fleet.largest or max(n, 2)
    best = [0, alone]
    for m in range(2, n + 1):
        platoons = [size * member + extra + best[m - size] for size in range(2, min(most, m) + 1)]
        best.append(min([alone + best[m - 1], *platoons]))
    return best[n]


def optimum(fleet, schedules):
    """Return the least cost over all choices of schedules, by trying all."""
    shape = tuple(len(own) for own in schedules)
    cells = {}
    for k, own in enumerate(schedules):
        for s, schedule in enumerate(own):
            for cell in schedule:
                cells.setdefault(cell, []).append((k, s))
    total = np.zeros(shape, np.int64)
    for (lane, _), users in cells.items():
        count = np.zeros(shape, np.int8)
        for k, s in users:
            count[(slice(None),) * k + (s,)] += 1
        prices = [company_cost(fleet, lane, n) for n in range(len(schedules) + 1)]
        total += np.array(prices)[count]
    return int(total.min())


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
            costs.append(0.0)
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

        total += min(sum(price(*cell) for cell in schedule) for schedule in own)
    return int(total)
