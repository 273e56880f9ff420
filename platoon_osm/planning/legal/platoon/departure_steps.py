"""What all pay under driving rules, for every departure of a master in whole seconds.

Between two moments the cheapest departure is searched, with its stops. With these stops the members
pay the same up to some later moment, which is found by spans that are bounded and split, as in the
search itself. No other stops cost less within these moments, so that is a step of the curve; what
lies before it and after it is searched likewise.

Within each search the master's stops are of those that its driving needs, and these depend on when
it leaves; so searches never reach over a departure at which they change.
"""

from __future__ import annotations

import time
from collections.abc import Iterator
from dataclasses import dataclass, field, replace

from .record import MemberTiming
from .search import choices_of
from .spans import SpanSearch
from .star_searches import MOST_RESTS_MORE, StarSearches, departures_of
from .stops import Stops
from .ties import simplest

__all__ = ["DepartureStep", "DepartureSteps", "steps_of_departure"]

LEAST_SPANS = 100
"""Spans that each search may look at even when those for all are used up."""

MOST_SEARCHES = 400
"""After so many searches the departures that are left stay untold; and likewise after three times
the work after which no step is proved."""

TRIED_SPANS = 400
"""Spans that are looked at with the stops of other steps, before all stops are."""

PIECES = 300
"""Spans that are looked at for the end of one step."""


@dataclass(frozen=True, slots=True)
class DepartureStep:
    """Departures at which all pay the same.

    Attributes
    ----------
    begin_s, end_s : int
        The first and the last of them [s].
    members : tuple of MemberTiming, (M,)
        How each member drives, at one of them.
    stops : tuple of (int, int)
        The master's: position and length [s].
    plain_s : int
        The departure of a plain plan among them [s].
    open_cost : float
        How much less members may pay in all; 0 where nothing is better.
    """

    begin_s: int
    end_s: int
    members: tuple[MemberTiming, ...]
    stops: Stops
    plain_s: int
    open_cost: float = 0.0


@dataclass(frozen=True, slots=True)
class DepartureSteps:
    """All that was found.

    Attributes
    ----------
    steps : tuple of DepartureStep
        In order; at departures between two of them that do not meet the master cannot leave, or
        nothing is known.
    complete : bool
        Whether the least cost at every departure is known.
    spans : int
        Spans of departures looked at.
    """

    steps: tuple[DepartureStep, ...]
    complete: bool
    spans: int


def steps_of_departure(
    searches: StarSearches, most_spans: int, time_limit_s: float
) -> DepartureSteps:
    """Return what all pay at each departure of a master.

    Parameters
    ----------
    searches : StarSearches
        Those of its star.
    most_spans : int
        After so much work, in spans of departures, no step is proved any more.
    time_limit_s : float
        After which likewise [s]; unlike spans, not the same on every machine.

    Returns
    -------
    DepartureSteps
        At each departure the least that members pay in all, each driving one stretch with the
        master.
    """
    walk = _Walk(searches, most_spans, time.perf_counter() + time_limit_s)
    walk.everything(*departures_of(searches.star))
    steps = sorted(walk.found, key=lambda step: step.begin_s)
    return DepartureSteps(tuple(_joined(steps)), walk.complete, walk.spans)


@dataclass(frozen=True, slots=True)
class _Span:
    """Departures that are left, and what is known of them.

    Of departures from `begin` to `end` none has a plan with fewer than `more` rests beyond those
    that the driving needs, and with as many members pay `floor` at least.
    """

    begin: int
    end: int
    more: int = 0
    floor: float = float("-inf")


@dataclass(slots=True, eq=False)
class _Walk:
    """The searches, one after another."""

    searches: StarSearches
    most_spans: int
    deadline: float
    found: list[DepartureStep] = field(default_factory=list)
    complete: bool = True
    known: dict[tuple[tuple[int, int], int], SpanSearch | None] = field(default_factory=dict)
    stops: dict[Stops, None] = field(default_factory=dict)

    @property
    def spans(self) -> int:
        return sum(search.spans for search in self.known.values() if search is not None)

    @property
    def work(self) -> int:
        """Spans looked at, and what real trips took, counted as spans."""
        return sum(search.work for search in self.known.values() if search is not None)

    def everything(self, begin: int, end: int) -> None:
        """Search all departures from one to another."""
        left = [_Span(u, v) for u, v in self._alike(begin, end)]
        for _ in range(MOST_SEARCHES):
            if not left:
                return
            if self.work > 3 * self.most_spans or time.perf_counter() > self.deadline:
                break
            # What spans are left for goes to the longest, of which most is unknown.
            left.sort(key=lambda span: (span.end - span.begin, -span.begin))
            left += self._next(left.pop())
        self.complete = False

    def _alike(self, u: int, v: int) -> Iterator[tuple[int, int]]:
        """Yield spans in which the driving needs the same, for it never needs more later."""
        while u <= v:
            needs, last, beyond = self.searches.needs(u), u, v + 1
            if self.searches.needs(v) == needs:
                last = v
            while beyond - last > 1:
                middle = (last + beyond) // 2
                if self.searches.needs(middle) == needs:
                    last = middle
                else:
                    beyond = middle
            yield u, last
            u = last + 1

    def _next(self, span: _Span) -> Iterator[_Span]:
        """Keep the step with the cheapest departure of a span, and yield what is left of it."""
        needs, floor = self.searches.needs(span.end), span.floor
        for more in range(span.more, MOST_RESTS_MORE + 1):
            if (needs, more) not in self.known:
                self.known[needs, more] = self.searches.search(needs, more)
            search = self.known[needs, more]
            if search is None:
                return
            ended = self._run(search, span, floor)
            known = search.bound
            search.heap.clear()
            floor = max(floor, known)
            self.complete &= ended
            if search.found is not None:
                step = _step(search, span, ended, floor)
                if step is None:
                    self.complete = False
                    return
                self.found.append(step)
                self.stops[step.stops] = None
                for begin, end in ((span.begin, step.begin_s - 1), (step.end_s + 1, span.end)):
                    if begin <= end:
                        yield _Span(begin, end, more, floor)
                return
            if not ended:
                return
            floor = float("-inf")

    def _run(self, search: SpanSearch, span: _Span, floor: float) -> bool:
        """Search a span, the stops of other steps first; return whether all was compared."""
        search.best, search.found, search.deadline = float("inf"), None, self.deadline
        search.most_spans = search.work + TRIED_SPANS
        known = [stops for stops in self.stops if search.stops.allows(stops)]
        search.run(span.begin, span.end, known, floor)
        search.heap.clear()
        search.most_spans = search.work + max(self.most_spans - self.work, LEAST_SPANS)
        return search.run(span.begin, span.end, floor=floor)


def _step(search: SpanSearch, span: _Span, ended: bool, floor: float) -> DepartureStep | None:
    assert search.found is not None
    stops, at = search.found
    pays = search.best
    if ended:
        stops, at = simplest(search, stops, at, pays, span.begin, span.end)
    members = choices_of(search, stops, at)
    if members is None:
        return None
    end = _last_alike(search, stops, pays, at, span.end)
    short = pays - floor
    return DepartureStep(
        at, end, tuple(members), stops, at, 0.0 if ended or short <= search.tolerance else short
    )


def _last_alike(search: SpanSearch, stops: Stops, pays: float, at: int, v: int) -> int:
    """Return up to which departure members certainly pay no more with the same stops."""
    spans = search.stops.allowed(search.star.road, stops, at, v)
    if not spans or spans[0][0] != at:
        return at
    most, last = pays + search.tolerance, at - 1
    left = [search.start(stops, None, *spans[0])]
    for _ in range(PIECES):
        if not left:
            break
        piece = left.pop()
        below = search.bounded([piece], most)
        if not below:
            break
        _, total, node = below[0]
        if node.begin != last + 1:
            break
        if total < most or not len(node.rows):
            last = node.end
        else:
            left += reversed(search.settled(node))
    return max(last, at)


def _joined(steps: list[DepartureStep]) -> Iterator[DepartureStep]:
    """Yield steps; those that meet and in which all drive alike are one."""
    before: DepartureStep | None = None
    for step in steps:
        if before is not None and before.end_s + 1 == step.begin_s and _alike(before, step):
            plainer = min(before, step, key=lambda one: (len(one.stops), one.begin_s))
            before = replace(
                before, end_s=step.end_s, stops=plainer.stops, plain_s=plainer.plain_s,
                members=plainer.members,
            )  # fmt: skip
            continue
        if before is not None:
            yield before
        before = step
    if before is not None:
        yield before


def _alike(one: DepartureStep, other: DepartureStep) -> bool:
    return one.open_cost == other.open_cost and all(
        a.stretches == b.stretches and a.cost == b.cost
        for a, b in zip(one.members, other.members, strict=True)
    )
