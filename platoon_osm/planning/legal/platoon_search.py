"""The cheapest stops and departure of a master for its members, best first.

A node of the search is a beginning of the master's stops and a span of its departure. Its bound is
the sum of what each member pays at least (`platoon_kernel.py`). Nodes are split in their span, or
by the next stop; once the stops are decided, members whose value is certain for the whole span are
settled and counted no more. Where only pauses on a member's own ways leave it open, the real trip
is asked for: if it can be driven throughout the span the member is settled, if it cannot be driven
at all this pair of points is out, for this span. So bounds hold for pauses anywhere, while every
plan that is returned has been driven with real places.

What is searched: departures in whole seconds; stops at places of the master's way, of the lengths
that the law names and those asked for; as many stops as its driving needs and `extra_stops` more,
and no more daily rests than it needs, one more if there is no plan else.
"""

from __future__ import annotations

import heapq
import time
from collections.abc import Sequence
from dataclasses import dataclass, field, replace
from itertools import count
from typing import Any

import numpy as np
from numpy.typing import NDArray

from . import platoon_kernel as kernel
from .platoon_compiled import evaluator
from .platoon_numbers import StarNumbers, numbers_of_star
from .platoon_record import MASTER, Free, MemberTiming, PlatoonTiming, Real, Timetable
from .platoon_stops import Clocks, MasterStops, Stops
from .road import LegalTrip
from .star_times import OPEN_S, StarTimes

__all__ = ["search_platoon"]

Floats = NDArray[np.float64]
Seconds = NDArray[np.int64]
Marks = NDArray[np.bool_]
FAR = kernel.FAR
Pairs = tuple[tuple[int, int], ...]
"""(row, code) of pairs that are out."""

Table = tuple[Stops, Clocks | None, int, int]
"""Stops, the clocks after them if others may follow, and the departure as it counts for merging and
for separating."""

SPLIT_S = 900
"""Spans shorter than this are split by stops before they are split again [s]."""

ASKED_AT = (3, 10, 40, 160)
"""After how many real trips that cannot be driven it is asked whether any could."""

LOOSER_S = (900, 3600, 14400)
"""By how much more a pair that is ruled out may leave later and arrive earlier, as is tried [s]."""

SAME = 1e-9
"""Sums of costs that differ by less, relative to what all pay alone, are equal."""

HORIZON_S = 48 * 3600
"""How far beyond the members' windows a master without a window may leave [s]."""


@dataclass(slots=True, eq=False)
class _Node:
    """A beginning of the master's stops, and a span of its departure."""

    stops: Stops
    clocks: Clocks | None
    """The master's after the last stop; None if no other stops follow."""
    begin: int
    end: int
    fixed: float
    rows: Seconds
    low: Floats
    refuted: Pairs = ()
    cuts: int = 0
    """How many cuts there were when it was bounded."""


@dataclass(slots=True, eq=False)
class _Search:
    star: StarTimes
    numbers: StarNumbers
    stops: MasterStops
    real: Real | None
    deadline: float
    evaluate: Any
    tolerance: float
    free: Free | None = None
    most_spans: int = 10**9
    heap: list[tuple[tuple[int, ...], float, _Node]] = field(default_factory=list)
    order: Any = field(default_factory=count)
    best: float = np.inf
    found: tuple[Stops, int] | None = None
    asked: dict[tuple[Any, ...], LegalTrip | None] = field(default_factory=dict)
    cuts: list[tuple[int, ...]] = field(default_factory=list)
    """(row, code) of pairs that are out if the platoon leaves i and reaches j within some moments,
    whatever its stops, and these."""
    failed: dict[tuple[int, int], int] = field(default_factory=dict)
    evaluations: int = 0
    spans: int = 0
    plan: Seconds = field(init=False)

    def __post_init__(self) -> None:
        self.plan = self.stops.plan

    def values(
        self, rows: Seconds, tables: Sequence[Table], sure: bool, refuted: Pairs = (),
        floor: Floats | None = None, most: float = np.inf,
    ) -> tuple[Floats, Seconds, Seconds]:  # fmt: skip
        """Return what vehicles pay with some timetables, and their points."""
        some = self.numbers
        size = len(tables), len(rows)
        first = np.zeros(len(rows) + 1, np.int64)
        codes = np.zeros((0, 5), np.int64)
        if refuted or self.cuts:
            own: list[list[tuple[int, ...]]] = [[] for _ in rows]
            where = {int(row): k for k, row in enumerate(rows)}
            for row, code in refuted:
                if row in where:
                    own[where[row]].append((code, -FAR, FAR, -FAR, FAR))
            for row, *cut in self.cuts:
                if row in where:
                    own[where[row]].append(tuple(cut))
            first[1:] = np.cumsum([len(one) for one in own])
            codes = np.array([code for one in own for code in one], np.int64).reshape(-1, 5)
        room = max(1, max(len(table[0]) for table in tables))
        made = np.zeros((len(tables), room, 2), np.int64)
        for k, table in enumerate(tables):
            if table[0]:
                made[k, : len(table[0])] = table[0]
        rest = np.array(
            [(len(one[0]), *(one[1] or (-1, 0, 0)), one[2], one[3]) for one in tables], np.int64
        )
        out = np.empty(size), np.empty(size, np.int64), np.empty(size, np.int64)
        self.evaluate(
            rows, some.vehicles, some.approach, some.ready, some.entry, some.onward, some.must,
            some.leave, some.platoon,
            some.alone, some.slack, some.pos, some.tau, some.clocks, some.clock_of, some.along,
            some.stay, self.stops.places, self.plan, np.ascontiguousarray(made[:, :, 0]),
            np.ascontiguousarray(made[:, :, 1]), np.ascontiguousarray(rest[:, 0]),
            np.ascontiguousarray(rest[:, 1:4]), np.ascontiguousarray(rest[:, 4]),
            np.ascontiguousarray(rest[:, 5]), sure, first, codes,
            np.zeros(len(rows)) if floor is None else floor, most, *out,
        )  # fmt: skip
        self.evaluations += len(rows) * len(tables)
        return out

    def push(self, nodes: Sequence[_Node]) -> None:
        """Bound nodes of the same vehicles, and keep those that may be better than the best."""
        nodes = [node for node in nodes if node.begin <= node.end]
        if not nodes:
            return
        self.spans += len(nodes)
        one = nodes[0]
        low, _, _ = self.values(
            one.rows, [(node.stops, node.clocks, node.end, node.begin) for node in nodes], False,
            one.refuted, one.low, self.best - self.tolerance - one.fixed,
        )  # fmt: skip
        bounds = (one.fixed + low.sum(axis=1)).tolist()
        below = [
            k for k, bound in enumerate(bounds)
            if bound < self.best - self.tolerance and bound < np.inf
        ]  # fmt: skip
        ended = [k for k in below if nodes[k].clocks is None]
        high = None
        if ended:
            tables: list[Table] = [
                (nodes[k].stops, None, nodes[k].begin, nodes[k].end) for k in ended
            ]
            high = self.values(one.rows, tables, self.real is not None, one.refuted)[0]
        for k in below:
            node, own = nodes[k], low[k]
            node.low, node.cuts = own, len(self.cuts)
            if node.clocks is None:
                assert high is not None
                most = high[ended.index(k)]
                same = most - own <= self.tolerance * 1e-3
                total = node.fixed + float(most.sum())
                if total < self.best:
                    self.best, self.found = total, (node.stops, node.begin)
                node.fixed += float(own[same].sum())
                node.rows, node.low = node.rows[~same], own[~same]
                if not len(node.rows):
                    continue
            # Of equal bounds the one that is nearest to its end.
            unsettled = len(self.numbers.alone) if node.clocks else len(node.rows)
            pauses = sum(length for _, length in node.stops)
            level = round(bounds[k] / self.tolerance)
            key = level, unsettled, -len(node.stops), pauses, -next(self.order)
            heapq.heappush(self.heap, (key, bounds[k], node))

    def run(self, begin: int, end: int) -> bool:
        """Search; return whether it came to an end before the time was over."""
        # The master comes first: a timetable that it cannot keep needs no further look.
        rows = np.roll(np.arange(len(self.numbers.alone)), 1)
        clocks = self.stops.states((), end)
        if clocks is None or begin > end:
            return True
        self.push([_Node((), clocks, begin, end, 0.0, rows, np.zeros(len(rows)))])
        while self.heap:
            if self.heap[0][1] >= self.best - self.tolerance:
                break
            if self.spans > self.most_spans or time.perf_counter() > self.deadline:
                return False
            node = heapq.heappop(self.heap)[-1]
            if node.cuts < len(self.cuts):
                self.push([node])
            elif node.clocks is None:
                self.settle(node)
            elif node.end - node.begin >= SPLIT_S:
                halves = []
                for low, high in _halves(node.begin, node.end):
                    clocks = self.stops.states(node.stops, high)
                    if clocks is not None:
                        halves.append(replace(node, clocks=clocks, begin=low, end=high))
                self.push(halves)
            else:
                self.branch(node)
        self.heap.clear()
        return True

    def branch(self, node: _Node) -> None:
        """Decide the next stop, or that there is none."""
        ways = self.stops
        clocks = node.clocks
        assert clocks is not None
        at = node.stops[-1][0] if node.stops else 0
        children = self.ended(node, node.stops) if ways.is_end(node.stops, clocks) else []
        for stop in ways.nexts(node.stops, clocks, node.begin):
            longer = (*node.stops, stop)
            after = ways.after(clocks, at, stop)
            if after and ways.can_end(longer, after, ways.budget(longer, node.begin)):
                if len(longer) == ways.most:
                    children += self.ended(node, longer)
                else:
                    children.append(replace(node, stops=longer, clocks=after))
        self.push(children)

    def ended(self, node: _Node, stops: Stops) -> list[_Node]:
        """Return the nodes at which no other stops follow."""
        return [
            replace(node, stops=stops, clocks=None, begin=low, end=high)
            for low, high in self.allowed(stops, node.begin, node.end)
        ]

    def allowed(self, stops: Stops, begin: int, end: int) -> list[tuple[int, int]]:
        """Return the departures at which no hop starts while it is closed."""
        road = self.star.road
        row = self.numbers.vehicles[self.numbers.master]
        stood = sum(length for _, length in stops)
        end = min(end, int(row[kernel.ARRIVAL] - self.numbers.tau[-1] - stood))
        if begin > end:
            return []
        if not len(road.forbidden_s):
            return [(begin, end)]
        leave = Timetable.of(self.star, 0, stops).leave_s[:-1]
        hops = np.repeat(np.arange(road.hops), np.diff(road.forbidden_first))
        closed = road.forbidden_s - leave[hops][:, None]
        closed = closed[np.argsort(closed[:, 0], kind="stable")]
        found, low = [], begin
        for first, last in closed.tolist():
            if last <= low:
                continue
            if first >= end:
                break
            if first >= low:
                found.append((low, first))
            low = max(low, last)
        if low <= end:
            found.append((low, end))
        return found

    def settle(self, node: _Node) -> None:
        """Ask for real trips where only they can tell, then split the span."""
        rows, stops, u, v = node.rows, node.stops, node.begin, node.end
        refuted = list(node.refuted)
        keep = np.ones(len(rows), bool)
        fixed = node.fixed
        if self.real is not None:
            middle, i, j = (
                one[0] for one in self.values(rows, [(stops, None, u, v)], False, node.refuted)
            )
            for k in np.flatnonzero(middle - node.low <= self.tolerance * 1e-3).tolist():
                # Not its time decides, but where it may pause.
                row, a, b = int(rows[k]), int(i[k]), int(j[k])
                if a < 0 or self.trip(row, a, b, stops, u, u - v) is not None:
                    fixed, keep[k] = fixed + float(middle[k]), False
                elif self.cut(row, a, b, stops, u, v):
                    continue
                elif u == v or self.never(row, a, b, stops, u, v):
                    refuted.append((row, a * len(self.numbers.pos) + b))
        rest = replace(
            node, fixed=fixed, rows=rows[keep], low=node.low[keep], refuted=tuple(refuted)
        )
        if u == v or len(refuted) > len(node.refuted) or len(self.cuts) > node.cuts:
            self.push([rest])
        else:
            self.push([replace(rest, begin=low, end=high) for low, high in _halves(u, v)])

    def never(self, row: int, i: int, j: int, stops: Stops, u: int, v: int) -> bool:
        """Whether a pair cannot be driven at any departure of a span."""
        if self.numbers.approach[row, i] == 0 and row != self.numbers.master:
            leaves = Timetable.of(self.star, v, stops).leave_s[self.numbers.pos[i]]
            if leaves > self.numbers.vehicles[row, kernel.LATEST]:
                return False  # it leaves its origin with the platoon, and might leave earlier
        return self.trip(row, i, j, stops, v, v - u) is None

    def cut(self, row: int, i: int, j: int, stops: Stops, u: int, v: int) -> bool:
        """Rule a pair out whatever the stops are, if it is; return whether it is."""
        if self.free is None or row == self.numbers.master:
            return False
        code = i * len(self.numbers.pos) + j
        self.failed[row, code] = self.failed.get((row, code), 0) + 1
        if self.failed[row, code] not in ASKED_AT:
            return False
        at, shift = self.numbers.pos, self.numbers.first_node
        early, late = (Timetable.of(self.star, one, stops) for one in (u, v))
        known = 0
        for more in (0, *LOOSER_S):
            moments = (
                int(early.leave_s[at[i]]) - more, int(late.leave_s[at[i]]) + more,
                int(early.arrive_s[at[j]]) - more, int(late.arrive_s[at[j]]) + more,
            )  # fmt: skip
            if self.free(row, i - shift, j - shift, moments):
                break
            if known:
                self.cuts.pop()
            self.cuts.append((row, code, *moments))
            known += 1
        return known > 0

    def trip(
        self, row: int, i: int, j: int, stops: Stops, departure: int, slack: int
    ) -> LegalTrip | None:
        """Ask for a real trip, once."""
        some = self.numbers
        if self.real is None:
            return None
        if row == some.master:
            between, key_at = stops, departure
        else:
            low, high = int(some.pos[i]), int(some.pos[j])
            between = tuple(stop for stop in stops if low <= stop[0] <= high)
            stood = sum(length for position, length in stops if position < low)
            key_at = departure + stood
        key = (row, i, j, between, key_at, slack)
        if key not in self.asked:
            table = Timetable.of(self.star, departure, stops, slack)
            if row == some.master:
                self.asked[key] = self.real(MASTER, 0, len(self.star.node_at) - 1, table)
            else:
                shift = some.first_node
                self.asked[key] = self.real(row, i - shift, j - shift, table)
        return self.asked[key]

    def real_choices(self, stops: Stops, departure: int) -> list[MemberTiming] | None:
        """Return what members do at a departure, with real trips; None if the master cannot."""
        some = self.numbers
        master = np.array([some.master])
        table: Table = (stops, None, departure, departure)
        low, _, _ = self.values(master, [table], False)
        if np.isinf(low).any() or (
            self.real is not None
            and self.trip(some.master, 0, len(some.pos) - 1, stops, departure, 0) is None
        ):
            return None
        rows = np.arange(some.master)
        refuted: list[tuple[int, int]] = []
        chosen: dict[int, MemberTiming] = {}
        while len(rows):
            cost, i, j = (one[0] for one in self.values(rows, [table], False, tuple(refuted)))
            left = []
            for k, row in enumerate(rows.tolist()):
                if i[k] < 0:
                    able = cost[k] < some.penalty
                    pays = float(self.star.alone[row]) if able else np.inf
                    chosen[row] = MemberTiming(pays, possible=bool(able))
                    continue
                trip = self.trip(row, int(i[k]), int(j[k]), stops, departure, 0)
                if trip is None and self.real is not None:
                    refuted.append((row, int(i[k]) * len(some.pos) + int(j[k])))
                    left.append(row)
                else:
                    shift = some.first_node
                    nodes = int(i[k]) - shift, int(j[k]) - shift
                    chosen[row] = MemberTiming(float(cost[k]), *nodes, trip)
            rows = np.array(left, np.int64)
        return [chosen[row] for row in range(some.master)]


def search_platoon(
    star: StarTimes,
    real: Real | None,
    time_limit_s: float = 10.0,
    *,
    most_spans: int = 10**9,
    free: Free | None = None,
    in_time: Marks | None = None,
    plain: Marks | None = None,
    extra_stops: int = 1,
    lengths: tuple[int, ...] = (),
) -> PlatoonTiming:
    """Return when a master leaves and where it stops, so that its members pay least in all.

    Parameters
    ----------
    star : StarTimes
        The master and its members.
    real : callable or None
        Says how a vehicle really drives; None if it may pause anywhere on its own ways, and no
        trips are asked for.
    time_limit_s : float
        After which the best found is returned, with its bound [s].
    most_spans : int
        After so many spans of departures likewise; unlike time, the same on every machine.
    free : callable, optional
        Says whether a member could drive by two nodes whatever the stops are; it saves questions.
    in_time : ndarray of bool, (M,), optional
        Which members may go alone: in time and within the law; by default those whose cost alone is
        finite.
    plain : ndarray of bool, (M,), optional
        Which members have no driving bans or closed hours on any of their ways; by default all.
    extra_stops : int
        How many more stops are searched than the master's driving needs.
    lengths : tuple of int
        Lengths of pauses that are tried besides those that the law names [s].

    Returns
    -------
    PlatoonTiming
        Proved if nothing searched is better; else with a bound.
    """
    began = time.perf_counter()
    members = len(star.alone)
    if in_time is None:
        in_time = np.isfinite(star.alone)
    if plain is None:
        plain = np.ones(members, bool)
    begin, end = _departures(star)
    found = PlatoonTiming(np.inf, np.inf, True, None, None)
    for more in range(3):
        probe = MasterStops(numbers_of_star(star, in_time, plain, 0), 0, 0)
        clocks = probe.states((), end) or (0, kernel.FAR, 0)
        stops, rests, _ = probe.left(clocks, int(probe.numbers.tau[-1]))
        rests += more
        most = max(stops, rests) + extra_stops
        numbers = numbers_of_star(star, in_time, plain, rests + 1)
        if more and probe.numbers.vehicles[probe.numbers.master, kernel.REST] >= kernel.FAR:
            break
        total = float(np.abs(star.alone[np.isfinite(star.alone)]).sum()) + 1.0
        search = _Search(
            star, numbers, MasterStops(numbers, most, rests, lengths), real,
            began + time_limit_s, evaluator(members * len(numbers.pos)), SAME * total, free,
            most_spans,
        )  # fmt: skip
        ended = search.run(begin, end)
        found = _result(search, ended, began)
        if found.timetable is not None or not ended:
            break
    return found


def _halves(begin: int, end: int) -> tuple[tuple[int, int], tuple[int, int]]:
    middle = (begin + end) // 2
    return (begin, middle), (middle + 1, end)


def _departures(star: StarTimes) -> tuple[int, int]:
    """Return the first and the last departure of the master that are searched."""
    window = star.window
    drive = int(star.road.drive_s.sum())
    last = min(window.latest_s, window.arrival_s - drive)
    known = [
        at
        for one in (*star.windows, window)
        for at in (one.earliest_s, one.latest_s, one.arrival_s)
        if abs(at) < OPEN_S // 2
    ]
    first = window.earliest_s
    if first <= -OPEN_S // 2:
        first = (min(known) - drive - HORIZON_S) if known else 0
        first = min(first, last)
    if last >= OPEN_S // 2:
        last = (max(known) + HORIZON_S) if known else first
        last = max(first, last)
    return first, last


def _result(search: _Search, ended: bool, began: float) -> PlatoonTiming:
    star, some = search.star, search.numbers
    alone = float(star.alone.sum()) + star.master_alone
    bound = min([search.best, *(entry[1] for entry in search.heap)])
    chosen = None
    if search.found is not None:
        stops, departure = search.found
        chosen = search.real_choices(stops, departure)
    counts = (search.evaluations, len(search.asked), search.spans)
    if search.found is None or chosen is None:
        return PlatoonTiming(
            np.inf, bound + star.master_alone - float(np.maximum(star.gain, 0).sum()),
            ended, None, None, (), alone, *counts, time.perf_counter() - began,
        )  # fmt: skip
    met = np.zeros(len(star.gain), bool)
    for one in chosen:
        met[max(one.merge, 0) : max(one.separate, 0)] |= not one.is_alone
    pays = sum(one.cost if one.possible else some.penalty for one in chosen)
    short = max(0.0, pays - bound) if not ended else 0.0
    cost = sum(one.cost for one in chosen) + star.master_alone - float(star.gain[met].sum())
    table = Timetable.of(star, departure, stops)
    trip = search.trip(some.master, 0, len(some.pos) - 1, stops, departure, 0)
    return PlatoonTiming(
        cost, cost - short, ended, table, trip, tuple(chosen), alone, *counts,
        time.perf_counter() - began,
    )  # fmt: skip
