"""The least cost of a tiny fleet by enumeration, and random tiny fleets to try it on.

Every truck may drive every simple path over the lanes of its kind and enter its lanes at every
instant that matters; a plan is one such schedule of each. `optimum` looks at all plans, but for
those whose lower bound is no better than the best one found; `slow_optimum` looks at every plan at
every whole tick, and skips nothing. Neither uses the pairs of an instance, but for given routes.
"""

from __future__ import annotations

import itertools
from collections import Counter
from dataclasses import dataclass

import numpy as np

from platoon_osm.fleets.instance import Instance
from platoon_osm.fleets.lanes import Lanes
from platoon_osm.fleets.windows import Wanted, paired

__all__ = [
    "Best",
    "cheapest_alone",
    "company_cost",
    "cost_of",
    "instance_of",
    "optimum",
    "random_instance",
    "schedules_of",
    "slow_optimum",
]

Schedule = tuple[tuple[int, int], ...]
"""Lanes and the instants at which they are entered."""


@dataclass(frozen=True)
class Best:
    """The least cost [grains], and a plan that has it: lanes and instants of each truck."""

    cost: int
    schedules: tuple[Schedule, ...]


def company_cost(instance: Instance, lane: int, n: int) -> int:
    """Return what n trucks pay that enter a lane at one instant: the cheapest way to part them."""
    alone, member, extra = (int(x[lane]) for x in (instance.alone, instance.member, instance.extra))
    most = instance.largest or max(n, 2)
    best = [0]
    for k in range(1, n + 1):
        ways = [best[k - 1] + alone]
        ways += [best[k - q] + q * member + extra for q in range(2, min(most, k) + 1)]
        best.append(min(ways))
    return best[n]


def cost_of(instance: Instance, schedules: tuple[Schedule, ...]) -> int:
    """Return what a plan costs, waiting on the road among it [grains]."""
    together = Counter(entry for own in schedules for entry in own)
    cost = sum(company_cost(instance, lane, n) for (lane, _), n in together.items())
    return cost + sum(_waits(instance, own) for own in schedules)


def optimum(
    instance: Instance, most_schedules: int = 40_000, only: set[tuple[int, int]] | None = None
) -> Best:
    """Return a plan of least cost, by all plans at the instants that matter.

    `only` names the lanes that each truck may drive, if it may not drive all of its kind.

    Where waiting is free those are of plans shifted left, so that every entry is some truck's
    earliest departure and the lanes it or its companions drove since; a price of waiting brings in
    what can be told from latest departures and arrivals, forward and backward.
    """
    choices = schedules_of(instance, most_schedules)
    if only is not None:
        choices = [
            [own for own in some if all((k, lane) in only for lane, _ in own)]
            for k, some in enumerate(choices)
        ]
    return _least(instance, choices)


def schedules_of(instance: Instance, most: int = 40_000) -> list[list[Schedule]]:
    """Return all schedules of each truck at the instants that matter."""
    instants = _instants(instance)
    return [_schedules(instance, k, instants, most) for k in range(instance.trucks)]


def slow_optimum(instance: Instance) -> Best:
    """Return a plan of least cost, by all plans at all whole ticks; nothing is skipped."""
    horizon = range(int(instance.earliest.min()), int(instance.latest.max()) + 1)
    ticks = [set(horizon)] * instance.nodes
    choices = [_schedules(instance, k, ticks, 10**6) for k in range(instance.trucks)]
    plans = itertools.product(*choices)
    best = min(plans, key=lambda plan: cost_of(instance, plan))
    return Best(cost_of(instance, best), best)


def _waits(instance: Instance, schedule: Schedule) -> int:
    pieces = itertools.pairwise(schedule)
    waited = sum(then - at - int(instance.drive[lane]) for (lane, at), (_, then) in pieces)
    return instance.waiting * waited


def _instants(instance: Instance) -> list[set[int]]:
    """Return the instants at which a lane may be entered or left, at each node."""
    found: list[set[int]] = [set() for _ in range(instance.nodes)]
    todo = []
    for k in range(instance.trucks):
        todo.append((int(instance.origin[k]), int(instance.earliest[k])))
        if instance.waiting:
            todo.append((int(instance.origin[k]), int(instance.latest_departure[k])))
            todo.append((int(instance.destination[k]), int(instance.latest[k])))
    low, high = int(instance.earliest.min()), int(instance.latest.max())
    moves = list(
        zip(instance.tail.tolist(), instance.head.tolist(), instance.drive.tolist(), strict=True)
    )
    while todo:
        node, at = todo.pop()
        if at in found[node] or not low <= at <= high:
            continue
        found[node].add(at)
        todo += [(head, at + drive) for tail, head, drive in moves if tail == node]
        if instance.waiting:
            todo += [(tail, at - drive) for tail, head, drive in moves if head == node]
    return found


def _paths(instance: Instance, k: int) -> list[tuple[int, ...]]:
    """Return all paths of a truck over lanes of its kind that pass no node twice."""
    if instance.given:
        own = range(int(instance.first_pair[k]), int(instance.first_pair[k + 1]))
        by_tail = {int(instance.tail[lane]): lane for lane in instance.pair_lane[own].tolist()}
        path, at = [], int(instance.origin[k])
        while at != instance.destination[k]:
            path.append(by_tail[at])
            at = int(instance.head[path[-1]])
        return [tuple(path)]
    found: list[tuple[int, ...]] = []
    todo: list[tuple[int, tuple[int, ...], frozenset[int]]] = [
        (int(instance.origin[k]), (), frozenset([int(instance.origin[k])]))
    ]
    while todo:
        node, path, seen = todo.pop()
        if node == instance.destination[k]:
            found.append(path)
            continue
        for lane in range(instance.lanes):
            head = int(instance.head[lane])
            fits = instance.tail[lane] == node and instance.lane_kind[lane] == instance.kind[k]
            if fits and head not in seen:
                todo.append((head, (*path, lane), seen | {head}))
    return found


def _schedules(instance: Instance, k: int, instants: list[set[int]], most: int) -> list[Schedule]:
    """Return all schedules of a truck in its window."""
    found: list[Schedule] = []
    for path in _paths(instance, k):
        rest = [0]
        for lane in reversed(path):
            rest.append(rest[-1] + int(instance.drive[lane]))
        rest.reverse()
        partial: list[tuple[int, Schedule]] = [(int(instance.earliest[k]), ())]
        for i, lane in enumerate(path):
            until = int(instance.latest[k]) - rest[i]
            if i == 0:
                until = min(until, int(instance.latest_departure[k]))
            times = sorted(instants[int(instance.tail[lane])])
            partial = [
                (at + int(instance.drive[lane]), (*own, (lane, at)))
                for ready, own in partial
                for at in times
                if ready <= at <= until
            ]
            if len(partial) > most:
                raise ValueError("too many schedules to enumerate; make the instance smaller")
        found += [own for _, own in partial]
    return found


def _least(instance: Instance, choices: list[list[Schedule]]) -> Best:
    """Return the best of all plans, one schedule of each truck."""
    return _shared_choices(instance, choices, _Search).best()


def _shared_choices(
    instance: Instance, choices: list[list[Schedule]], kind: type[_Search]
) -> _Search:
    """Return the search of some schedules, of which none is needless."""
    users = Counter(entry for own in choices for entry in {e for one in own for e in one})
    # Of schedules alike in all entries that another truck could share, the cheapest will do.
    order = sorted(range(len(choices)), key=lambda k: len(choices[k]))
    slots = {entry: i for i, entry in enumerate(e for e, n in users.items() if n > 1)}
    thinned: list[list[tuple[int, tuple[int, ...], Schedule]]] = []
    for k in order:
        cheapest: dict[tuple[int, ...], tuple[int, Schedule]] = {}
        for own in choices[k]:
            shared = tuple(slots[entry] for entry in own if entry in slots)
            cost = _waits(instance, own)
            cost += sum(int(instance.alone[e[0]]) for e in own if e not in slots)
            if shared not in cheapest or cost < cheapest[shared][0]:
                cheapest[shared] = (cost, own)
        thinned.append([(cost, shared, own) for shared, (cost, own) in cheapest.items()])
    return kind(instance, list(slots), order, thinned)


class _Search:
    """Depth first over trucks; what those to come pay at least is known at every step."""

    def __init__(
        self,
        instance: Instance,
        slots: list[tuple[int, int]],
        order: list[int],
        thinned: list[list[tuple[int, tuple[int, ...], Schedule]]],
    ) -> None:
        trucks = len(order)
        self.order, self.thinned = order, thinned
        price = np.array(
            [[company_cost(instance, lane, n) for n in range(trucks + 1)] for lane, _ in slots],
            np.float64,
        ).reshape(len(slots), trucks + 1)
        # least[left][slot, n]: what each of at most `left` more adds at least to n that are there.
        self.price = price
        self.least = []
        for left in range(trucks + 1):
            table = np.zeros((len(slots), trucks + 1))
            for n in range(trucks - left + 1):
                if left:
                    steps = [
                        (price[:, n + more] - price[:, n]) / more for more in range(1, left + 1)
                    ]
                    table[:, n] = np.minimum.reduce(steps)
            self.least.append(table)
        self.base = [np.array([cost for cost, *_ in own], float) for own in thinned]
        width = [max((len(shared) for _, shared, _ in own), default=0) for own in thinned]
        self.uses = []
        for own, wide in zip(thinned, width, strict=True):
            table = np.full((len(own), wide), len(slots), np.int64)
            for i, (_, shared, _) in enumerate(own):
                table[i, : len(shared)] = shared
            self.uses.append(table)
        self.there = np.zeros(len(slots), np.int64)
        self.slot = np.arange(len(slots))
        self.cost = np.inf
        self.chosen: list[int] = [0] * trucks
        self.found: list[int] = []

    def best(self) -> Best:
        self._step(0, 0.0)
        own = {
            k: self.thinned[i][choice][2]
            for i, (k, choice) in enumerate(zip(self.order, self.found, strict=True))
        }
        return Best(round(self.cost), tuple(own[k] for k in range(len(own))))

    def _step(self, i: int, cost: float) -> None:
        if i == len(self.order):
            if cost < self.cost - 0.5:
                self.cost, self.found = cost, list(self.chosen)
            return
        left = len(self.order) - i
        # Prices of this step are those of all who are left, so that they add up.
        least = np.append(self.least[left][self.slot, self.there], 0.0)
        sums = [
            base + least[uses].sum(axis=1)
            for base, uses in zip(self.base[i:], self.uses[i:], strict=True)
        ]
        rest = sum(own.min() for own in sums[1:])
        now = self.price[self.slot, self.there + 1] - self.price[self.slot, self.there]
        adds = self.base[i] + np.append(now, 0.0)[self.uses[i]].sum(axis=1)
        for choice in np.argsort(sums[0], kind="stable").tolist():
            if cost + sums[0][choice] + rest >= self.cost - 0.5:
                return
            shared = list(self.thinned[i][choice][1])
            self.there[shared] += 1
            self.chosen[i] = choice
            self._step(i + 1, cost + float(adds[choice]))
            self.there[shared] -= 1


def cheapest_alone(lanes: Lanes, wanted: tuple[int, int, int, int, int]) -> list[int]:
    """Return the lanes of the cheapest route alone that is in time; ties to the fewest lanes.

    `wanted` is origin, destination, earliest, latest, kind.
    """
    origin, goal, earliest, latest, kind = wanted
    best: tuple[int, int, list[int]] | None = None
    todo: list[tuple[int, int, int, list[int], set[int]]] = [(origin, earliest, 0, [], {origin})]
    while todo:
        node, at, cost, path, seen = todo.pop()
        if at > latest:
            continue
        if node == goal:
            if best is None or (cost, len(path), path) < best:
                best = (cost, len(path), path)
            continue
        for lane in range(len(lanes.tail)):
            head = int(lanes.head[lane])
            fits = lanes.tail[lane] == node and lanes.lane_kind[lane] == kind
            if fits and head not in seen:
                then, paid = int(lanes.drive[lane]), int(lanes.alone[lane])
                todo.append((head, at + then, cost + paid, [*path, lane], seen | {head}))
    if best is None:
        return []
    return best[2]


def instance_of(
    lanes: dict[str, list[int]],
    trucks: dict[str, list[int]],
    *,
    nodes: int,
    given: bool = False,
    largest: int = 0,
    waiting: int = 0,
) -> Instance:
    """Return the instance of lanes and trucks told as columns of whole numbers.

    Lanes have tail, head, drive, alone, member, extra, lane_kind; trucks have origin, destination,
    earliest, latest_departure, latest, kind.
    """
    roads = {name: np.array(column, np.int64) for name, column in lanes.items()}
    count = len(roads["tail"])
    table = Lanes(
        nodes=np.arange(nodes), **roads, first_edge=np.arange(count + 1), edges=np.arange(count),
        kind=np.array(trucks["kind"], np.int64), grains=1.0,
    )  # fmt: skip
    own = {name: np.array(column, np.int64) for name, column in trucks.items() if name != "kind"}
    rows = zip(
        *(trucks[name] for name in ("origin", "destination", "earliest", "latest", "kind")),
        strict=True,
    )
    alone = [np.array(cheapest_alone(table, row), np.int64) for row in rows]
    wanted = Wanted(**own, alone=alone)
    return paired(table, wanted, given=given, largest=largest, waiting=waiting)[0]


def random_instance(
    seed: int,
    *,
    trucks: int | None = None,
    nodes: int | None = None,
    kinds: int | None = None,
    largest: int | None = None,
    given: bool | None = None,
    waiting: int | None = 0,
    leader: bool | None = None,
    departures: bool | None = None,
    slack: int = 5,
) -> Instance:
    """Return a random tiny instance; what is None is drawn.

    `leader` says whether the leader of a platoon saves too, `departures` whether there are latest
    departures, `slack` by how many ticks at most a window is longer than the quickest way.
    """
    rng = np.random.default_rng([seed, 16])
    n = int(rng.integers(4, 7)) if nodes is None else nodes
    count = int(rng.integers(2, 6)) if trucks is None else trucks
    many = int(rng.choice([1, 1, 2])) if kinds is None else kinds
    most = int(rng.choice([0, 0, 2, 3])) if largest is None else largest
    fixed = bool(rng.integers(2)) if given is None else given
    saves = bool(rng.integers(2)) if leader is None else leader
    leaves = bool(rng.integers(2)) if departures is None else departures
    price = int(rng.choice([0, 1, 3])) if waiting is None else waiting
    roads = [(a, (a + 1) % n) for a in range(n)]
    roads += [(b, a) for a, b in roads if rng.random() < 0.7]
    roads += [
        (int(a), int(b))
        for a, b in (rng.choice(n, 2, replace=False) for _ in range(int(rng.integers(1, 4))))
    ]
    lanes: dict[str, list[int]] = {
        name: [] for name in ("tail", "head", "drive", "alone", "member", "extra", "lane_kind")
    }
    for kind in range(many):
        for tail, head in roads:
            drive = int(rng.integers(1, 4))
            alone = int(drive * 20 + rng.integers(-5, 6))
            member = int(rng.integers((alone + 1) // 2, alone + 1))
            room = alone - member
            extra = int(rng.integers(0, room + 1)) if saves else room
            row = (tail, head, drive, alone, member, extra, kind)
            for column, value in zip(lanes.values(), row, strict=True):
                column.append(value)
    quickest = _quickest(lanes, n, many)
    wanted: dict[str, list[int]] = {
        name: []
        for name in (
            "origin", "destination", "earliest", "latest_departure", "latest", "kind",
        )
    }  # fmt: skip
    while len(wanted["kind"]) < count:
        kind = int(rng.integers(many))
        origin, goal = (int(x) for x in rng.choice(n, 2, replace=False))
        drive = quickest[kind][origin][goal]
        if drive < 2:
            continue
        earliest = int(rng.integers(0, 5))
        latest = earliest + drive + int(rng.integers(0, slack + 1))
        last = int(rng.integers(earliest, latest - drive + 1)) if leaves else latest
        row = (origin, goal, earliest, last, latest, kind)
        for column, value in zip(wanted.values(), row, strict=True):
            column.append(value)
    return instance_of(lanes, wanted, nodes=n, given=fixed, largest=most, waiting=price)


def _quickest(lanes: dict[str, list[int]], n: int, kinds: int) -> list[list[list[int]]]:
    """Return the quickest times between all nodes, for each kind."""
    far = 10**6
    found = []
    for kind in range(kinds):
        times = [[0 if a == b else far for b in range(n)] for a in range(n)]
        for tail, head, drive, own in zip(
            lanes["tail"], lanes["head"], lanes["drive"], lanes["lane_kind"], strict=True
        ):
            if own == kind:
                times[tail][head] = min(times[tail][head], drive)
        for via, a, b in itertools.product(range(n), repeat=3):
            times[a][b] = min(times[a][b], times[a][via] + times[via][b])
        found.append(times)
    return found
