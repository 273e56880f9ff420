"""The platoons that vehicles form under driving rules: star after star, each with its best master.

Every vehicle is tried as master (`compared.py`). Who is left alone then may form further platoons
among themselves, found likewise.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator, Sequence
from dataclasses import dataclass, field

from ...plans.records import MasterTried
from ...plans.stretches import Run, runs_alone
from ..answers import of_pair
from ..star import Star
from .compared import Compared
from .cut_at_pauses import Driven
from .legal_question import LegalQuestion
from .star_in_time import Platooned

__all__ = ["Planned", "alone_plan", "planned_platoons"]

MOST_SPANS = 12_000
"""Spans of departures that are looked at for all masters together, about, real trips counted by
what they take; then the best that was found is taken, with a bound. It is a count, not a time, lest
plans differ between machines."""


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
    waiting_bound : float or None
        Likewise, of plans in which masters stand for any time at their stops; `bound` is of those
        in which they stand for their law alone.
    waits : bool
        Whether a master stands longer for its company than its law asks for.
    tried : list of MasterTried
        What each master would give, the cheapest first.
    masters : int
        How many masters were tried or cannot be better.
    unfinished : bool
        Whether a search ran out of time.
    company : int
        How many vehicles drive with the master of the first platoon.
    work : int
        Spans of departures looked at, real trips counted by what they took.
    """

    runs: list[list[Run]]
    driven: list[Driven]
    cost: float
    master: int | None = None
    bound: float | None = None
    waiting_bound: float | None = None
    waits: bool = False
    tried: list[MasterTried] = field(default_factory=list)
    masters: int = 0
    unfinished: bool = False
    company: int = 0
    work: int = 0


def planned_platoons(
    legal: LegalQuestion,
    most_spans: int = MOST_SPANS,
    masters: Sequence[int] | None = None,
    among: Collection[int] | None = None,
) -> Planned:
    """Return the platoons of a question under driving rules.

    Parameters
    ----------
    legal : LegalQuestion
        What is asked, with its law.
    most_spans : int
        Spans of departures that are looked at for all masters together, about.
    masters : sequence of int, optional
        Who may be the master of the first platoon; by default whoever the question lets.
    among : collection of int, optional
        Who may drive in company; by default all.

    Returns
    -------
    Planned
        In which nobody is late for company who is in time alone.
    """
    question, plan = legal.question, alone_plan(legal)
    everyone = range(len(question.ends))
    if len(everyone) < 2:
        return plan
    free = set(everyone if among is None else among)
    fixed = question.fixed_master
    usual = sorted(free) if fixed is None else [fixed]
    first = _best_star(legal, among, usual if masters is None else masters, plan, most_spans)
    if first is None:
        return plan
    plan.company = len(first.joined) - 1
    plan.master = first.star.master
    plan.bound, plan.waiting_bound = (
        min(plan.cost if one is None else one, plan.cost)
        for one in (plan.bound, plan.waiting_bound)
    )
    if masters is not None or among is not None:
        plan.bound = plan.waiting_bound = None
    several = question.problem.company == "anywhere" and question.problem.case in ("C", "best")
    free -= set(first.joined)
    while several and len(free) > 1:
        more = _best_star(legal, free, sorted(free), plan, most_spans)
        if more is None:
            break
        plan.bound = plan.waiting_bound = None
        free -= set(more.joined)
    return plan


def alone_plan(legal: LegalQuestion) -> Planned:
    """Return the plan in which everyone drives alone.

    Parameters
    ----------
    legal : LegalQuestion
        What is asked, with its law.

    Returns
    -------
    Planned
        Always possible.
    """
    question = legal.question
    alone = float(question.solo.sum())
    return Planned(
        [runs_alone(route, k) for k, route in enumerate(question.alone)],
        [Driven(one.way, one.trip, rules)
         for one, rules in zip(legal.alone, legal.rules, strict=True)],
        alone, bound=alone, waiting_bound=alone,
    )  # fmt: skip


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
    order = {k: place for place, k in enumerate(question.by_length)}
    stars = sorted(
        _stars(legal, sorted(masters, key=order.__getitem__)), key=lambda star: star.bound
    )
    compared = Compared(legal, among, alone)
    compared.search(stars, most_spans)
    best = compared.best
    plan.unfinished |= compared.unfinished
    plan.work += compared.work
    if among is None:
        plan.tried = sorted(compared.tried.values(), key=lambda one: one.cost)
        # The route that suits two best is one more of the same master.
        plan.masters = len({star.master for star in stars})
        plan.bound, plan.waiting_bound = compared.bound, compared.waiting_bound
    if best is None:
        return None
    plan.waits |= best.timing.waits
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
