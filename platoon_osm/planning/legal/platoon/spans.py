"""Spans of a master's departure, with beginnings of its stops: bounded, split and settled.

The bound of a node is the sum of what each member pays at least (`kernel.py`): a node holds
how far each member has come in the list of its pairs. Once its stops are decided, members whose
value is certain for the whole span are settled and counted no more. Where the places of a member's
own ways may matter they are looked at, once for each point (`tables.py`). What is left open
then, bans and weeks, the real trip tells: if it can be driven throughout the span the member is
settled; if at no departure of it, this pair is out for the span.
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

from ..driver.road import LegalTrip
from .asked import AskedTrips
from .nodes import Past, SpanNode, halves
from .numbers import StarNumbers
from .star_times import StarTimes
from .stops import OPEN, Clocks, MasterStops, Stops
from .values import StarValues, Table

__all__ = ["Choice", "SpanSearch"]

Floats = NDArray[np.float64]
Seconds = NDArray[np.int64]

Choice = tuple[float, int, int, LegalTrip | None]
"""What a member pays, the points where it merges and separates (-1 if it stays alone), its trip."""

SPLIT_S = 14400
"""Spans shorter than this are split by stops before they are split again [s]."""

SPAN_LABELS = 100
"""About so many labels of searches for real trips take as long as a span."""

DIVE = 1.3
"""The search looks ahead after its first step, and whenever it has taken so many times more."""


@dataclass(slots=True, eq=False)
class SpanSearch:
    """The search of one star.

    Attributes
    ----------
    star : StarTimes
        The master and its members.
    numbers : StarNumbers
        The same in whole numbers.
    values : StarValues
        What vehicles pay.
    trips : AskedTrips
        How vehicles really drive.
    deadline : float
        When the search is to end, on the clock of `time.perf_counter` [s].
    tolerance : float
        Sums of costs that differ by less are equal.
    most_spans : int
        After so much work the search ends, too.
    heap : list
        Nodes, the most promising first.
    best : float
        What all pay in the best that was found; inf if nothing was.
    found : tuple or None
        Its stops and departure.
    tried : int
        Nodes with all their stops that were looked at.
    spans : int
        Spans of departures looked at.
    least : ndarray of float, (M + 1,)
        What each vehicle pays at least, whatever the stops and the departure.
    """

    star: StarTimes
    numbers: StarNumbers
    values: StarValues
    trips: AskedTrips
    deadline: float
    tolerance: float
    most_spans: int = 10**9
    heap: list[tuple[tuple[int, ...], float, SpanNode]] = field(default_factory=list)
    order: Any = field(default_factory=count)
    best: float = np.inf
    found: tuple[Stops, int] | None = None
    tried: int = 0
    spans: int = 0
    least: Floats = field(init=False)

    def __post_init__(self) -> None:
        self.least = np.zeros(len(self.numbers.alone))

    @property
    def stops(self) -> MasterStops:
        """Where the master may stop."""
        return self.values.stops

    @property
    def work(self) -> int:
        """How many spans were looked at, with what real trips took, counted as spans."""
        return self.spans + self.trips.labels // SPAN_LABELS

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
        rows, fixed = nodes[0].rows, nodes[0].fixed
        got = self.values.of(
            rows, [
                (node.stops, node.clocks, node.begin, node.end, node.night) for node in nodes
            ],
            rank=nodes[0].rank, past=nodes[0].past, most=most - fixed,
        )  # fmt: skip
        bounds, begins, ends = ((fixed + got.bound).tolist(), got.begin.tolist(), got.end.tolist())
        kept = [k for k, bound in enumerate(bounds) if bound < most and bound < np.inf]
        ended = [k for k in kept if nodes[k].clocks is None]
        certain = got.cost
        if ended:
            tables: list[Table] = [(nodes[k].stops, None, begins[k], ends[k]) for k in ended]
            sure = self.trips.real is not None
            certain = self.values.of(
                rows, tables, sure=sure, throughout=True, rank=got.rank[ended]
            ).cost
        found, looked = [], self.values.tables.looked
        for k in kept:
            node, total = nodes[k], np.inf
            node.low, node.rank, node.looked, node.taken = got.cost[k], got.rank[k], looked, False
            node.begin, node.end, node.past = begins[k], ends[k], got.past(k)
            if node.clocks is None:
                at = ended.index(k)
                total = fixed + float(certain[at].sum())
                node.keep(np.isinf(certain[at]))
            found.append((bounds[k], total, node))
        return found

    def _push(self, nodes: Sequence[SpanNode]) -> SpanNode | None:
        """Bound nodes of the same vehicles, keep those that may be better, return the first."""
        first: tuple[tuple[int, ...], SpanNode] | None = None
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
            if first is None or key < first[0]:
                first = key, node
        return None if first is None else first[1]

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
        nothing = np.zeros(len(rows), np.int64)
        past = Past(np.zeros((len(rows), 1), np.int32), begin, 1)
        return SpanNode(stops, clocks, begin, end, 0.0, rows, nothing.astype(float), nothing, past)

    @property
    def bound(self) -> float:
        """What all pay at least, in what was looked at."""
        return min([self.best, *(bound for _, bound, node in self.heap if not node.taken)])

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
                    for span in self.stops.allowed(self.star.road, stops, begin, end)
                ]
            )
        return self.go_on(floor)

    def go_on(self, floor: float = -np.inf) -> bool:
        """Go on with a search that was stopped.

        Parameters
        ----------
        floor : float
            What all pay at least.

        Returns
        -------
        bool
            As `run`.
        """
        turn, dive_at, ahead = 0, 1.0, None
        while self.heap:
            if max(self.heap[0][1], floor) >= self.best - self.tolerance:
                break
            if self.work > self.most_spans or time.perf_counter() > self.deadline:
                return False
            # Now and then one looks ahead, the best of the best: a good plan that is found early
            # saves looking at worse ones.
            if ahead is None:
                node, turn = heapq.heappop(self.heap)[-1], turn + 1
                if node.taken:
                    continue
            else:
                node, ahead.taken = ahead, True
            best, ahead = self.best, self._split(node)
            if turn >= dive_at and (ahead is None or self.best < best):
                ahead, dive_at = None, dive_at * DIVE
            elif turn < dive_at:
                ahead = None
        self.heap.clear()
        return True

    def _split(self, node: SpanNode) -> SpanNode | None:
        """Replace a node by its parts; return the most promising of them."""
        if self.values.look(node.rows, node.rank) or node.looked < self.values.tables.looked:
            return self._push([node])
        # Who stays alone is settled: it would be so with less known, too. And who has come to pay
        # most comes first: so a node that is too dear is soon seen to be.
        node.keep(node.rank < self.values.ends(node.rows))
        order = np.argsort(self.least[node.rows] - node.low, kind="stable")
        node.take(order)
        if node.clocks is None:
            self._try(node)
            return self._push(self.settled(node))
        if node.end - node.begin < SPLIT_S:
            # Where roads are closed, what is decided in its order is sooner seen to be late.
            first = node.night == OPEN and not len(self.star.road.forbidden_s)
            return self._with_nights(node) if first else self._branch(node)
        parts = []
        for low, high in halves(node.begin, node.end):
            clocks = self.stops.states(node.stops, high)
            if clocks is not None:
                parts.append(replace(node, clocks=clocks, begin=low, end=high))
        return self._push(parts)

    def _try(self, node: SpanNode) -> None:
        """See what the first departure of a node costs, now and then."""
        self.tried += 1
        if self.trips.real is None or self.tried & (self.tried - 1):
            return
        chosen = self.choices(node.stops, node.begin, with_trips=False)
        if chosen is None:
            return
        total = sum(one[0] for one in chosen)
        if total < self.best:
            self.best, self.found = total, (node.stops, node.begin)

    def choices(
        self, stops: Stops, departure: int, *, with_trips: bool = True
    ) -> list[Choice] | None:
        """Return what members do at a departure, the cheapest that can really be driven.

        Parameters
        ----------
        stops : tuple of (int, int)
            The master's.
        departure : int
            When it leaves [s].
        with_trips : bool
            Whether all trips are wanted; else they are asked for only where the tables do not tell
            for certain that there is one.

        Returns
        -------
        list of Choice, (M,), or None
            None if the master cannot drive like that.
        """
        some = self.numbers
        table: Table = (stops, None, departure, departure)
        if np.isinf(self.values.of(np.array([some.master]), [table]).cost).any() or (
            self.trips.real is not None
            and self.trips.trip(some.master, 0, len(some.pos) - 1, stops, departure, 0) is None
        ):
            return None
        rows = np.arange(some.master)
        rank = np.zeros(len(rows), np.int64)
        chosen: dict[int, Choice] = {}
        while len(rows):
            got = self.values.of(rows, [table], rank=rank)
            cost, rank = got.cost[0], got.rank[0]
            merge, separate = self.values.points(rows, rank)
            if self.values.look(rows, rank):
                continue
            open_rows = np.zeros(len(rows), bool)
            asks = (merge >= 0) & (self.trips.real is not None)
            if not with_trips and asks.any():
                sure = self.values.of(rows, [table], sure=True, throughout=True, rank=rank)
                asks &= np.isinf(sure.cost[0])
            for k, row in enumerate(rows.tolist()):
                a, b = int(merge[k]), int(separate[k])
                trip = self.trips.trip(row, a, b, stops, departure, 0) if asks[k] else None
                if not asks[k] or trip is not None:
                    chosen[row] = float(cost[k]), a, b, trip
                else:
                    open_rows[k] = True
            rows, rank = rows[open_rows], rank[open_rows] + 1
        return [chosen[row] for row in range(some.master)]

    def _with_nights(self, node: SpanNode) -> SpanNode | None:
        """Decide where the next daily rest lies, and how many stops come before it."""
        assert node.clocks is not None
        nights = self.stops.nights(node.stops, node.clocks)
        if len(nights) == 1:
            node.night = nights[0]
            return self._branch(node)
        return self._push([replace(node, night=night) for night in nights])

    def _branch(self, node: SpanNode) -> SpanNode | None:
        """Decide the next stop, or that there is none."""
        ways = self.stops
        clocks = node.clocks
        assert clocks is not None
        none = node.night[0] >= len(self.numbers.tau)
        children = []
        if (none or node.night == OPEN) and ways.is_end(node.stops, clocks):
            children = self._ended(node, node.stops)
        reach = ways.reach(self.star.road, node.stops, node.begin, node.end)
        for stop, after in ways.nexts(node.stops, clocks, node.begin, node.night):
            if stop[0] > reach:
                continue
            longer, at, night = (*node.stops, stop), stop, node.night
            if night[2] == len(longer) and stop != night[:2] and not none:
                # Nothing else comes before the night.
                rested = ways.after(after, stop[0], night[:2])
                if rested is None:
                    continue
                longer, at, after = (*longer, night[:2]), night[:2], rested
            if len(longer) == ways.most:
                children += self._ended(node, longer)
                continue
            for after_it in ways.nights(longer, after) if at == night[:2] else (night,):
                children.append(replace(node, stops=longer, clocks=after, night=after_it))
        return self._push(children)

    def _ended(self, node: SpanNode, stops: Stops) -> list[SpanNode]:
        """Return the nodes at which no other stops follow."""
        return [
            replace(node, stops=stops, clocks=None, begin=low, end=high)
            for low, high in self.stops.allowed(self.star.road, stops, node.begin, node.end)
        ]

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
        rank, keep, fixed = node.rank.copy(), np.ones(len(rows), bool), node.fixed
        merge, separate = self.values.points(rows, rank)
        if self.trips.real is not None:
            got = self.values.of(rows, [(stops, None, u, v)], throughout=True, rank=rank)
            for k in np.flatnonzero(got.cost[0] < np.inf).tolist():
                # Not its time decides, but what the tables do not tell.
                row, a, b = int(rows[k]), int(merge[k]), int(separate[k])
                if a < 0 or self.trips.trip(row, a, b, stops, u, u - v) is not None:
                    fixed, keep[k] = fixed + float(node.low[k]), False
                elif u == v or self.trips.never(row, a, b, stops, u, v):
                    rank[k] += 1
        rest = replace(node, fixed=fixed, rank=rank)
        rest.take(keep)
        if u == v or (rank > node.rank).any():
            return [rest]
        return [replace(rest, begin=low, end=high) for low, high in halves(u, v)]
