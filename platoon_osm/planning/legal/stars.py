"""The platoons that vehicles form under driving rules: star after star, each with its best master.

Every vehicle is tried as master, those first whose bound without a clock is least, until no other
can be better. Who is left alone then may form further platoons among themselves, found likewise.

Under "system" members and master pay least in all. The master gains once an edge, so members hang
together. Paid the whole gain on each edge they do not, and pay no more than any plan costs: that is
a bound, and exact for one member; paid a share each, that less what is given away beside. The plan
is the best of those that are found at these prices, at its true cost.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator, Sequence
from dataclasses import dataclass, field, replace

import numpy as np
from numpy.typing import NDArray

from ...plans.records import MasterTried
from ...plans.stretches import Run, runs_alone
from ..answers import of_pair
from ..cases import Case, running_sum
from ..company.draft import NO_CHEAPER
from ..question import Question
from ..star import Star
from .cut_at_pauses import Driven
from .legal_question import LegalQuestion
from .member_ways import MemberWays
from .platoon_again import Again
from .platoon_real import Together
from .platoon_record import PlatoonTiming
from .platoon_search import search_platoon
from .star_input import star_way

__all__ = ["LIMIT_S", "MOST_SPANS", "Planned", "case_of", "planned_platoons"]

Floats = NDArray[np.float64]

MOST_SPANS = 16_000
"""Spans of departures that are looked at for all masters together; then the best of each that was
found is taken, with a bound. It is a count, not a time, lest plans differ between machines."""

LEAST_SPANS = 500
"""But no fewer than this for one master."""

LIMIT_S = 60.0
"""No search for one master lasts longer, on however slow a machine [s]."""


@dataclass(frozen=True, slots=True, eq=False)
class Platooned:
    """One star as it is driven.

    Attributes
    ----------
    star : Star
        The master and its members.
    timing : PlatoonTiming
        When.
    ways : MemberWays
        The members' ways.
    together : list of sequence of (int, int), (M, ...)
        Where each member drives with the master; nothing for one that stays alone.
    """

    star: Star
    timing: PlatoonTiming
    ways: MemberWays
    together: list[Sequence[Together]]

    @property
    def joined(self) -> list[int]:
        """The vehicles that drive with the master, and the master, as positions in the plan."""
        own = [k for k, some in zip(self.star.members, self.together, strict=True) if len(some)]
        return sorted([self.star.master, *own]) if own else []


@dataclass(slots=True, eq=False)
class Planned:
    """The platoons of a plan under driving rules.

    Attributes
    ----------
    runs : list of list of Run, (N, ...)
        Who drives what with whom.
    driven : list of Driven, (N,)
        Each vehicle's way and legal times.
    cost : float
        Of all vehicles together.
    master : int or None
        Of the first platoon; None if nobody joins anybody.
    bound : float or None
        No plan with one platoon, and any master that was to be tried, costs less; None if there
        are several platoons.
    tried : list of MasterTried
        What each master would give, the cheapest first.
    masters : int
        How many masters were tried or cannot be better.
    unfinished : bool
        Whether a search ran out of time.
    company : int
        How many vehicles drive with the master of the first platoon.
    spans : int
        Spans of departures looked at.
    """

    runs: list[list[Run]]
    driven: list[Driven]
    cost: float
    master: int | None = None
    bound: float | None = None
    tried: list[MasterTried] = field(default_factory=list)
    masters: int = 0
    unfinished: bool = False
    company: int = 0
    spans: int = 0


def planned_platoons(legal: LegalQuestion, most_spans: int = MOST_SPANS) -> Planned:
    """Return the platoons of a question under driving rules.

    Parameters
    ----------
    legal : LegalQuestion
        What is asked, with its law.
    most_spans : int
        Spans of departures that are looked at for all masters together, about.

    Returns
    -------
    Planned
        In which nobody is late for company who is in time alone.
    """
    question = legal.question
    alone = float(question.solo.sum())
    everyone = range(len(question.ends))
    plan = Planned(
        [runs_alone(route, k) for k, route in enumerate(question.alone)],
        [Driven(one.way, one.trip, rules)
         for one, rules in zip(legal.alone, legal.rules, strict=True)],
        alone, bound=alone,
    )  # fmt: skip
    if len(everyone) < 2:
        return plan
    free = set(everyone)
    fixed = question.fixed_master
    first = _best_star(legal, None, everyone if fixed is None else [fixed], plan, most_spans)
    if first is None:
        return plan
    plan.company = len(first.joined) - 1
    plan.master, plan.bound = first.star.master, min(plan.bound or alone, plan.cost)
    several = question.problem.company == "anywhere" and question.problem.case in ("C", "best")
    free -= set(first.joined)
    while several and len(free) > 1:
        more = _best_star(legal, free, sorted(free), plan, most_spans)
        if more is None:
            break
        plan.bound = None
        free -= set(more.joined)
    return plan


def _best_star(
    legal: LegalQuestion,
    among: Collection[int] | None,
    masters: Sequence[int],
    plan: Planned,
    most_spans: int,
) -> Platooned | None:
    """Find the best star of some vehicles and put it into a plan; None if none is cheaper."""
    question = legal.question
    alone = float(question.solo.sum())
    best: Platooned | None = None
    least, bounds = alone, [alone]
    order = {k: place for place, k in enumerate(question.by_length)}
    stars = sorted(
        _stars(legal, sorted(masters, key=order.__getitem__)), key=lambda star: star.bound
    )
    tried = []
    most = max(most_spans // max(len(stars), 1), LEAST_SPANS)
    for star in stars:
        if star.bound >= least * (1 - NO_CHEAPER):
            bounds.append(star.bound)
            break  # those after it have bounds no better
        found = _timed_star(legal, star, among, most)
        bounds.append(found.timing.bound)
        plan.unfinished |= not found.timing.proved
        plan.spans += found.timing.spans
        if np.isfinite(found.timing.cost):
            tried.append(MasterTried(star.master, case_of(legal.question), found.timing.cost))
        better = found.timing.cost < least * (1 - (NO_CHEAPER if best is None else 0))
        if better and found.joined and _allowed(legal, found):
            least, best = found.timing.cost, found
    if among is None:
        plan.tried = sorted(tried, key=lambda one: one.cost)
        plan.masters = len(stars)
        plan.bound = min(bounds)
    if best is None:
        return None
    plan.cost -= alone - best.timing.cost
    for index, run in enumerate(best.ways.runs(best.together)):
        if index in best.joined:
            plan.runs[index] = run
    trip = best.timing.master_trip
    assert trip is not None
    plan.driven[best.star.master] = Driven(best.ways.own.way, trip, best.ways.own.times.rules)
    table = best.timing.timetable
    assert table is not None
    for row, (member, some) in enumerate(zip(best.star.members, best.together, strict=True)):
        if len(some):
            own = best.timing.members[row].trip
            assert own is not None
            way = best.ways.way(row, some, table)
            plan.driven[member] = Driven(way, own, legal.rules[member])
    return best


def _stars(legal: LegalQuestion, masters: Sequence[int]) -> Iterator[Star]:
    question = legal.question
    if question.star_cases:
        yield from (question.star(master) for master in masters)
    if "D" not in question.problem.cases:
        return
    # The route that suits both best is one more for either of them to lead on.
    for answer in of_pair(question, question.first_master):
        if not answer.draft.together:
            continue
        led = answer.draft.led()
        master = led.index(max(led))
        routes = [
            answer.draft.routes[k] if k == master else own for k, own in enumerate(question.alone)
        ]
        yield Star(question.net, question.fleet, question.ends, master, question.routers, routes)


def case_of(question: Question) -> Case:
    """Return which points are free in a star.

    Parameters
    ----------
    question : Question
        What is asked.

    Returns
    -------
    {"A", "B", "C"}
        "C" where any case will do.
    """
    asked = question.problem.case
    return "A" if asked == "A" else "B" if asked == "B" else "C"


def _timed_star(
    legal: LegalQuestion, star: Star, among: Collection[int] | None, most_spans: int
) -> Platooned:
    gain = np.maximum(star.gain, 0.0)
    if legal.question.problem.optimum == "member" or not gain.any():
        return _searched(legal, star, among, most_spans)
    shares = dict.fromkeys((1.0, 1.0 / max(len(star.members), 1)))
    found = [
        _for_all(_searched(legal, star, among, most_spans // len(shares), share * gain), share)
        for share in shares
    ]
    best = min(found, key=lambda one: one.timing.cost)
    timing = replace(
        best.timing,
        bound=min(best.timing.cost, max(one.timing.bound for one in found)),
        proved=all(one.timing.proved for one in found),
        spans=sum(one.timing.spans for one in found),
    )
    return replace(best, timing=timing)


def _for_all(found: Platooned, share: float) -> Platooned:
    """Return a star that was searched at prices with its true cost, and a bound of all plans.

    Members that are paid a share of the master's gain on each of their edges, and the rest of all
    gains given away, cost no more in all than any plan does: the gain counts once an edge.
    """
    star, timing = found.star, found.timing
    gain = np.maximum(star.gain, 0.0)
    along = running_sum(gain)
    alone = found.star.costs[2]
    pays = [
        one.cost + share * sum(float(along[j] - along[i]) for i, j in some)
        for one, some in zip(timing.members, found.together, strict=False)
    ]
    together = list(found.together)
    # One companion is enough for the master: who costs more than it brings stays alone.
    for row in sorted(range(len(pays)), key=lambda k: float(alone[k]) - pays[k]):
        with_it = float(star.gain[_met(star, together)].sum())
        without = float(star.gain[_met(star, [*together[:row], *together[row + 1 :]])].sum())
        if together[row] and pays[row] - alone[row] > (with_it - without) + NO_CHEAPER * pays[row]:
            together[row], pays[row] = (), float(alone[row])
    bound = timing.bound - (1.0 - share) * float(gain.sum())
    cost = timing.cost
    if timing.timetable is not None:
        cost = sum(pays) + star.master_alone - float(star.gain[_met(star, together)].sum())
    timing = replace(timing, cost=cost, bound=min(bound, cost))
    return replace(found, timing=timing, together=together)


def _met(star: Star, together: Sequence[Sequence[Together]]) -> NDArray[np.bool_]:
    """Mark the edges of the route on which the master has company."""
    met = np.zeros(len(star.route), bool)
    for some in together:
        for i, j in some:
            met[i:j] = True
    return met


def _searched(
    legal: LegalQuestion,
    star: Star,
    among: Collection[int] | None,
    most_spans: int,
    price: Floats | None = None,
) -> Platooned:
    own = star_way(legal, star, case_of(legal.question), among, price)
    ways = MemberWays(legal, own)
    open_roads = np.full(len(star.members), not legal.has_closings)
    timing = search_platoon(
        own.times, ways.trips, LIMIT_S, most_spans=most_spans, roads=ways.trips, plain=open_roads,
        again=_again(legal, ways) if case_of(legal.question) == "C" else None,
    )  # fmt: skip
    together: list[Sequence[Together]] = [one.stretches for one in timing.members] or [
        () for _ in star.members
    ]
    return Platooned(star, timing, ways, together)


def _again(legal: LegalQuestion, ways: MemberWays) -> Again:
    """Return what it takes for members that stopped alone to join again."""
    star, fleet = ways.own.star, legal.question.fleet
    solo_along = [running_sum(fleet.alone(member)[star.route]) for member in star.members]

    shape = len(star.members), len(star.route) + 1
    return Again(np.array(solo_along).reshape(shape), ways.trips.trip)


def _allowed(legal: LegalQuestion, found: Platooned) -> bool:
    """Tell whether nobody pays more than alone, where members look at their own cost."""
    question = legal.question
    if question.problem.optimum == "system":
        return True
    star = found.star
    gained = float(star.gain[_met(star, found.together)].sum())
    return gained >= -NO_CHEAPER * float(question.solo[star.master])
