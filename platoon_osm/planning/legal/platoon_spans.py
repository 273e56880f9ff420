"""Spans of a master's departure, with beginnings of its stops: bounded, split and settled.

The bound of a node is the sum of what each member pays at least (`platoon_kernel.py`). Once its
stops are decided, members whose value is certain for the whole span are settled and counted no
more. Where only pauses on a member's own ways leave it open, the real trip is asked for: if it can
be driven throughout the span the member is settled; if at no departure of it, this pair of points
is out for the span; and if by no stops at all between some moments, it is out between these.
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
from .platoon_numbers import StarNumbers
from .platoon_record import MASTER, Free, Real, Timetable
from .platoon_stops import Clocks, MasterStops, Stops
from .road import LegalTrip
from .star_times import StarTimes

__all__ = ["Choice", "SpanNode", "SpanSearch", "Table"]

Floats = NDArray[np.float64]
Seconds = NDArray[np.int64]
FAR = kernel.FAR
Pairs = tuple[tuple[int, int], ...]
"""(row, code) of pairs that are out."""

Choice = tuple[float, int, int, LegalTrip | None]
"""What a member pays, the points where it merges and separates (-1 if it stays alone), its trip."""

Table = tuple[Stops, Clocks | None, int, int]
"""Stops, the clocks after them if others may follow, and the departure as it counts for merging and
for separating."""

SPLIT_S = 900
"""Spans shorter than this are split by stops before they are split again [s]."""

ASKED_AT = (3, 10, 40, 160)
"""After how many real trips that cannot be driven it is asked whether any could."""

LOOSER_S = (900, 3600, 14400)
"""By how much more a pair that is ruled out may leave later and arrive earlier, as is tried [s]."""


@dataclass(slots=True, eq=False)
class SpanNode:
    """A beginning of the master's stops, and a span of its departure.

    Attributes
    ----------
    stops : tuple of (int, int)
        Those decided.
    clocks : (int, int, int) or None
        The master's after the last of them; None if no other stops follow.
    begin, end : int
        The span [s].
    fixed : float
        What those pay together of whom it is settled.
    rows : ndarray of int, (R,)
        The others, as `StarNumbers` numbers them.
    low : ndarray of float, (R,)
        What each of these pays at least.
    refuted : tuple of (int, int)
        Vehicles and pairs of points that are out within the span.
    cuts : int
        How many pairs were out whatever the stops are when it was bounded.
    """

    stops: Stops
    clocks: Clocks | None
    begin: int
    end: int
    fixed: float
    rows: Seconds
    low: Floats
    refuted: Pairs = ()
    cuts: int = 0


@dataclass(slots=True, eq=False)
class SpanSearch:
    """The search of one star.

    Attributes
    ----------
    star : StarTimes
        The master and its members.
    numbers : StarNumbers
        The same in whole numbers.
    stops : MasterStops
        Where the master may stop.
    real : callable or None
        Says how a vehicle really drives.
    deadline : float
        When the search is to end, on the clock of `time.perf_counter` [s].
    evaluate : callable
        The kernel.
    tolerance : float
        Sums of costs that differ by less are equal.
    free : callable or None
        Says whether a member could drive by two nodes whatever the stops are.
    most_spans : int
        After so many spans the search ends, too.
    heap : list
        Nodes, the most promising first.
    best : float
        What all pay in the best that was found; inf if nothing was.
    found : tuple or None
        Its stops and departure.
    asked : dict
        Real trips that were asked for.
    cuts : list of tuple of int
        Vehicles and pairs that are out if the platoon leaves i and reaches j within some moments,
        whatever its stops, and these moments.
    failed : dict
        How often each pair could not be driven.
    tried : int
        Nodes with all their stops that were looked at.
    evaluations, spans : int
        Values of members computed, and spans of departures looked at.
    plan : ndarray of int, (4,)
        As `MasterStops.plan`.
    least : ndarray of float, (M + 1,)
        What each vehicle pays at least, whatever the stops and the departure.
    """

    star: StarTimes
    numbers: StarNumbers
    stops: MasterStops
    real: Real | None
    deadline: float
    evaluate: Any
    tolerance: float
    free: Free | None = None
    most_spans: int = 10**9
    heap: list[tuple[tuple[int, ...], float, SpanNode]] = field(default_factory=list)
    order: Any = field(default_factory=count)
    best: float = np.inf
    found: tuple[Stops, int] | None = None
    asked: dict[tuple[Any, ...], LegalTrip | None] = field(default_factory=dict)
    cuts: list[tuple[int, ...]] = field(default_factory=list)
    failed: dict[tuple[int, int], int] = field(default_factory=dict)
    tried: int = 0
    evaluations: int = 0
    spans: int = 0
    plan: Seconds = field(init=False)
    least: Floats = field(init=False)

    def __post_init__(self) -> None:
        self.plan = self.stops.plan
        self.least = np.zeros(len(self.numbers.alone))

    def values(
        self, rows: Seconds, tables: Sequence[Table], sure: bool, refuted: Pairs = (),
        floor: Floats | None = None, most: float = np.inf,
    ) -> tuple[Floats, Seconds, Seconds]:  # fmt: skip
        """Return what vehicles pay with some timetables, and their points.

        Parameters
        ----------
        rows : ndarray of int, (R,)
            Which vehicles, as `StarNumbers` numbers them.
        tables : sequence of Table, (C,)
            The timetables.
        sure : bool
            Whether the value is wanted that is certain; else the least.
        refuted : tuple of (int, int)
            Pairs that are out.
        floor : ndarray of float, (R,), optional
            What each pays at least, as far as is known.
        most : float
            A timetable is of no interest if all together pay as much.

        Returns
        -------
        cost : ndarray of float, (C, R)
            What they pay.
        merge, separate : ndarray of int, (C, R)
            Their points; -1 for who stays alone.
        """
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

    def bounded(
        self, nodes: Sequence[SpanNode], most: float
    ) -> list[tuple[float, float, SpanNode]]:
        """Bound nodes of the same vehicles, and settle those of whom it is certain what they pay.

        Parameters
        ----------
        nodes : sequence of SpanNode
            They are changed.
        most : float
            Nodes that are bounded by as much are left out.

        Returns
        -------
        list of (float, float, SpanNode)
            The bound, what it costs for certain, and the node.
        """
        nodes = [node for node in nodes if node.begin <= node.end]
        if not nodes:
            return []
        self.spans += len(nodes)
        one = nodes[0]
        low, _, _ = self.values(
            one.rows, [(node.stops, node.clocks, node.end, node.begin) for node in nodes], False,
            one.refuted, one.low, most - one.fixed,
        )  # fmt: skip
        bounds = (one.fixed + low.sum(axis=1)).tolist()
        below = [k for k, bound in enumerate(bounds) if bound < most and bound < np.inf]
        ended = [k for k in below if nodes[k].clocks is None]
        high = low
        if ended:
            tables: list[Table] = [
                (nodes[k].stops, None, nodes[k].begin, nodes[k].end) for k in ended
            ]
            high = self.values(one.rows, tables, self.real is not None, one.refuted)[0]
        found = []
        for k in below:
            node, own, total = nodes[k], low[k], np.inf
            node.low, node.cuts = own, len(self.cuts)
            if node.clocks is None:
                certain = high[ended.index(k)]
                same = certain - own <= self.tolerance * 1e-3
                total = node.fixed + float(certain.sum())
                node.fixed += float(own[same].sum())
                node.rows, node.low = node.rows[~same], own[~same]
            found.append((bounds[k], total, node))
        return found

    def _push(self, nodes: Sequence[SpanNode]) -> None:
        """Bound nodes of the same vehicles, and keep those that may be better than the best."""
        for bound, total, node in self.bounded(nodes, self.best - self.tolerance):
            if total < self.best:
                self.best, self.found = total, (node.stops, node.begin)
            if node.clocks is None and not len(node.rows):
                continue
            # Of equal bounds the one that is nearest to its end.
            unsettled = len(self.numbers.alone) if node.clocks else len(node.rows)
            pauses = sum(length for _, length in node.stops)
            level = round(bound / self.tolerance)
            key = level, unsettled, -len(node.stops), pauses, -next(self.order)
            heapq.heappush(self.heap, (key, bound, node))

    def start(self, stops: Stops, clocks: Clocks | None, begin: int, end: int) -> SpanNode:
        """Return a node of all vehicles.

        Parameters
        ----------
        stops : tuple of (int, int)
            Those decided.
        clocks : (int, int, int) or None
            The master's after them; None if no other stops follow.
        begin, end : int
            The span of its departure [s].

        Returns
        -------
        SpanNode
            Nothing is known of it yet.
        """
        # The master comes first: a timetable that it cannot keep needs no further look.
        rows = np.roll(np.arange(len(self.numbers.alone)), 1)
        return SpanNode(stops, clocks, begin, end, 0.0, rows, np.zeros(len(rows)))

    def run(
        self, begin: int, end: int, among: Sequence[Stops] | None = None, floor: float = -np.inf
    ) -> bool:
        """Search for something cheaper than the best that is known.

        Parameters
        ----------
        begin, end : int
            The first and the last departure of the master [s].
        among : sequence of tuple of (int, int), optional
            Nothing but these stops is tried.
        floor : float
            What all pay at least.

        Returns
        -------
        bool
            Whether it came to an end before time and spans were used up.
        """
        clocks = self.stops.states((), end)
        if clocks is None or begin > end:
            return True
        if among is None:
            root = self.start((), clocks, begin, end)
            self._push([root])
            # The master stays first.
            self.least[root.rows] = root.low
            self.least[self.numbers.master] = -np.inf
        else:
            self._push(
                [
                    self.start(stops, None, *span)
                    for stops in among
                    for span in self.allowed(stops, begin, end)
                ]
            )
        while self.heap:
            if max(self.heap[0][1], floor) >= self.best - self.tolerance:
                break
            if self.spans > self.most_spans or time.perf_counter() > self.deadline:
                return False
            node = heapq.heappop(self.heap)[-1]
            # Who has come to pay most comes first: so a node that is too dear is soon seen to be.
            order = np.argsort(self.least[node.rows] - node.low, kind="stable")
            node.rows, node.low = node.rows[order], node.low[order]
            if node.cuts < len(self.cuts):
                self._push([node])
            elif node.clocks is None:
                self._try(node)
                self._push(self.settled(node))
            elif node.end - node.begin >= SPLIT_S:
                halves = []
                for low, high in _halves(node.begin, node.end):
                    clocks = self.stops.states(node.stops, high)
                    if clocks is not None:
                        halves.append(replace(node, clocks=clocks, begin=low, end=high))
                self._push(halves)
            else:
                self._branch(node)
        self.heap.clear()
        return True

    def _try(self, node: SpanNode) -> None:
        """See what the first departure of a node costs, now and then."""
        self.tried += 1
        if self.real is None or self.tried & (self.tried - 1):
            return
        chosen = self.choices(node.stops, node.begin)
        if chosen is None:
            return
        total = sum(one[0] for one in chosen)
        if total < self.best:
            self.best, self.found = total, (node.stops, node.begin)

    def choices(self, stops: Stops, departure: int) -> list[Choice] | None:
        """Return what members do at a departure, the cheapest that can really be driven.

        Parameters
        ----------
        stops : tuple of (int, int)
            The master's.
        departure : int
            When it leaves [s].

        Returns
        -------
        list of Choice, (M,), or None
            None if the master cannot drive like that.
        """
        some = self.numbers
        table: Table = (stops, None, departure, departure)
        low, _, _ = self.values(np.array([some.master]), [table], False)
        if np.isinf(low).any() or (
            self.real is not None
            and self.trip(some.master, 0, len(some.pos) - 1, stops, departure, 0) is None
        ):
            return None
        rows = np.arange(some.master)
        refuted: list[tuple[int, int]] = []
        chosen: dict[int, Choice] = {}
        while len(rows):
            cost, i, j = (one[0] for one in self.values(rows, [table], False, tuple(refuted)))
            left = []
            for k, row in enumerate(rows.tolist()):
                a, b = int(i[k]), int(j[k])
                trip = None if a < 0 else self.trip(row, a, b, stops, departure, 0)
                if a < 0 or self.real is None or trip is not None:
                    chosen[row] = float(cost[k]), a, b, trip
                else:
                    refuted.append((row, a * len(some.pos) + b))
                    left.append(row)
            rows = np.array(left, np.int64)
        return [chosen[row] for row in range(some.master)]

    def _branch(self, node: SpanNode) -> None:
        """Decide the next stop, or that there is none."""
        ways = self.stops
        clocks = node.clocks
        assert clocks is not None
        children = self._ended(node, node.stops) if ways.is_end(node.stops, clocks) else []
        reach = self._reach(node)
        for stop, after in ways.nexts(node.stops, clocks, node.begin):
            if stop[0] > reach:
                continue
            longer = (*node.stops, stop)
            if len(longer) == ways.most:
                children += self._ended(node, longer)
            else:
                children.append(replace(node, stops=longer, clocks=after))
        self._push(children)

    def _reach(self, node: SpanNode) -> int:
        """Return the last position to which the master may drive without a stop more.

        A hop that is closed at every departure of the node is the end of that.
        """
        road = self.star.road
        if not len(road.forbidden_s):
            return road.hops
        leave = Timetable.of(self.star, 0, node.stops).leave_s[:-1]
        hops = np.repeat(np.arange(road.hops), np.diff(road.forbidden_first))
        closed = road.forbidden_s - leave[hops][:, None]
        shut = (closed[:, 0] < node.begin) & (closed[:, 1] > node.end)
        shut &= hops >= (node.stops[-1][0] if node.stops else 0)
        return int(hops[shut].min(initial=road.hops))

    def _ended(self, node: SpanNode, stops: Stops) -> list[SpanNode]:
        """Return the nodes at which no other stops follow."""
        return [
            replace(node, stops=stops, clocks=None, begin=low, end=high)
            for low, high in self.allowed(stops, node.begin, node.end)
        ]

    def allowed(self, stops: Stops, begin: int, end: int) -> list[tuple[int, int]]:
        """Return departures at which no hop starts while it is closed and the master is in time.

        Parameters
        ----------
        stops : tuple of (int, int)
            All its stops.
        begin, end : int
            The span of its departure [s].

        Returns
        -------
        list of (int, int)
            Spans in order [s].
        """
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

    def settled(self, node: SpanNode) -> list[SpanNode]:
        """Ask for real trips where only they can tell what vehicles pay.

        Parameters
        ----------
        node : SpanNode
            Bounded, with all its stops.

        Returns
        -------
        list of SpanNode
            What is left of it, in halves unless something was ruled out.
        """
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
                elif self._cut(row, a, b, stops, u, v):
                    continue
                elif u == v or self._never(row, a, b, stops, u, v):
                    refuted.append((row, a * len(self.numbers.pos) + b))
        rest = replace(
            node, fixed=fixed, rows=rows[keep], low=node.low[keep], refuted=tuple(refuted)
        )
        if u == v or len(refuted) > len(node.refuted) or len(self.cuts) > node.cuts:
            return [rest]
        return [replace(rest, begin=low, end=high) for low, high in _halves(u, v)]

    def _never(self, row: int, i: int, j: int, stops: Stops, u: int, v: int) -> bool:
        """Whether a pair cannot be driven at any departure of a span."""
        if self.numbers.approach[row, i] == 0 and row != self.numbers.master:
            leaves = Timetable.of(self.star, v, stops).leave_s[self.numbers.pos[i]]
            if leaves > self.numbers.vehicles[row, kernel.LATEST]:
                return False  # it leaves its origin with the platoon, and might leave earlier
        return self.trip(row, i, j, stops, v, v - u) is None

    def _cut(self, row: int, i: int, j: int, stops: Stops, u: int, v: int) -> bool:
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
        """Ask for a real trip, once.

        Parameters
        ----------
        row : int
            The vehicle.
        i, j : int
            Points where it merges and separates.
        stops : tuple of (int, int)
            The master's.
        departure, slack : int
            When it leaves, and how much later or earlier it may, see `Real` [s].

        Returns
        -------
        LegalTrip or None
            None if it cannot be driven.
        """
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


def _halves(begin: int, end: int) -> tuple[tuple[int, int], tuple[int, int]]:
    middle = (begin + end) // 2
    return (begin, middle), (middle + 1, end)
