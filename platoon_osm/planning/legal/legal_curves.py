"""Cost against a master's departure, and saving against allowed delay, under driving rules.

The curve tells every departure in whole seconds (`departure_steps.py`). For the frontier every
vehicle is tried as master for each delay, as for a plan with one platoon (`stars.py`); the bound
for a longer delay holds for a shorter one too, for that allows less.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ...errors import ScenarioError
from ...plans.curves import DelayFrontier, DepartureCurve
from ...plans.zones import clock_of
from ..best import ONE_STRETCH
from ..company.draft import NO_CHEAPER
from ..question import Question
from .conditions import (
    ALL_TOGETHER,
    MEMBERS,
    STANDS_FOR_LAW,
    STANDS_LONGER,
    STOPPED,
    of_every_curve,
)
from .legal_question import LegalQuestion
from .member_ways import MemberWays
from .platoon.departure_steps import DepartureStep, steps_of_departure
from .platoon.record import gained
from .platoon.search import cost_of
from .platoon.star_searches import StarSearches
from .platoon.star_times import StarTimes
from .star_in_time import LIMIT_S, case_of
from .star_input import star_way
from .stars import planned_platoons

__all__ = ["legal_curve", "legal_frontier"]

Floats = NDArray[np.float64]

CURVE_SPANS = 8_000
"""Spans of departures that are looked at for a curve before no step of it is proved any more, real
trips counted too."""

FRONTIER_SPANS = 12_000
"""Likewise for all delays of a frontier together; after twice as many, longer delays are told what
shorter ones save."""

DELAY_SHARES = 3
"""For one delay as many are looked at as are left for so many, if it takes them."""


def legal_curve(legal: LegalQuestion, master: int | None) -> DepartureCurve:
    """Return what all pay together under driving rules, by the departure of a master.

    Parameters
    ----------
    legal : LegalQuestion
        What is asked, with its law.
    master : int or None
        The vehicle that keeps its route; None for that with which all pay least.

    Returns
    -------
    DepartureCurve
        At every departure in whole seconds the least that members pay in all, each driving one
        stretch with the master.

    Raises
    ------
    ScenarioError
        A master that drives no road or cannot be in time, or a search that found nothing.
    NoLegalTripError
        A vehicle has no legal trip at all.
    """
    question = legal.question
    names = [item.vehicle for item in question.ends]
    if master is None:
        found = planned_platoons(legal).master
        master = question.first_master if found is None else found
    star = question.star(master)
    own = star_way(legal, star, case_of(question))
    ways = MemberWays(legal, own)
    searches = StarSearches(own.times, ways.trips, ways.trips, plain=ways.open())
    told = steps_of_departure(searches, CURVE_SPANS, LIMIT_S)
    if not told.steps and not told.complete:
        raise ScenarioError(
            f"departure curve: the search ended before any departure of {names[master]} was found; "
            "give fewer trips, or narrower windows"
        )
    if not len(star.route) or not told.steps:
        raise ScenarioError(
            f"departure curve: {names[master]} cannot drive with others in time; give it a wider "
            "window, or name another master"
        )
    steps = [_Level.of(step, own.times, question, master) for step in told.steps]
    begin = np.array([one.step.begin_s for one in steps], np.float64)
    end = np.array([one.step.end_s for one in steps], np.float64)
    cost = np.array([one.cost for one in steps])
    open_cost = np.array([one.step.open_cost for one in steps])
    best = int(np.argmin(cost))
    least = float(cost[best]) + NO_CHEAPER * float(question.solo.sum())
    # Of steps that are equally cheap that with the plainest plan, and of these the first.
    best = min(np.flatnonzero(cost <= least).tolist(), key=lambda k: (len(steps[k].step.stops), k))
    shown = clock_of(legal.first, 0, [float(begin[0]), float(end[-1])])
    stopped = () if told.complete else (STOPPED,)
    kept = f"master {names[master]} on its own route, {STANDS_FOR_LAW}"
    own_cost = question.problem.optimum == "member" or not own.times.gain.any()
    return DepartureCurve(
        names[master],
        tuple(names[k] for k in star.members),
        question.fleet[master].unit,
        float(question.solo.sum()),
        shown.start.isoformat(),
        shown.name,
        shown.offsets,
        begin, end, cost, cost.copy(),
        np.array([len(one.joining) for one in steps], np.int64),
        tuple(_spans(steps, row) for row in range(len(star.members))),
        float(steps[best].step.plain_s),
        float(cost[best]),
        told.complete and own_cost,
        (kept, *stopped, ONE_STRETCH, MEMBERS, *of_every_curve(question)),
        question.problem.rules.name,
        cost - open_cost if open_cost.any() else None,
    )  # fmt: skip


@dataclass(frozen=True, slots=True)
class _Level:
    """A step with what all pay, and the members that drive with the master."""

    step: DepartureStep
    cost: float
    joining: tuple[int, ...]

    @classmethod
    def of(cls, step: DepartureStep, times: StarTimes, question: Question, master: int) -> _Level:
        """Add up a step; where a plan would leave everybody alone, all are."""
        alone = float(question.solo.sum())
        cost = cost_of(times, step.members)
        loses = gained(times.gain, (one.stretches for one in step.members)) < -NO_CHEAPER * float(
            question.solo[master]
        )
        if cost >= alone * (1 - NO_CHEAPER) or (loses and question.problem.optimum == "member"):
            return cls(step, alone, ())
        return cls(step, cost, tuple(k for k, one in enumerate(step.members) if not one.is_alone))


def _spans(steps: Sequence[_Level], member: int) -> Floats:
    """Return from when to when a member drives with the master."""
    found: list[list[float]] = []
    for one in steps:
        if member not in one.joining:
            continue
        if found and found[-1][1] + 1 == one.step.begin_s:
            found[-1][1] = float(one.step.end_s)
        else:
            found.append([float(one.step.begin_s), float(one.step.end_s)])
    return np.array(found, np.float64).reshape(-1, 2)


def legal_frontier(legal: LegalQuestion, delays_min: Sequence[float]) -> DelayFrontier:
    """Return the largest saving under driving rules for each delay that every vehicle allows.

    Parameters
    ----------
    legal : LegalQuestion
        What is asked, with its law, of one platoon around one master.
    delays_min : sequence of float, (D,)
        By how much later than its legal trip alone each vehicle may arrive [min], ascending.

    Returns
    -------
    DelayFrontier
        In the order of the delays.

    Raises
    ------
    NoLegalTripError
        A vehicle has no legal trip at all.
    """
    question = legal.question
    total = float(question.solo.sum())
    fixed = question.fixed_master
    masters = range(len(question.ends)) if fixed is None else [fixed]
    # No window makes company cheaper than none at all does.
    floor = min(question.star(master).bound for master in masters)
    rows: list[tuple[float, float, str, int]] = []
    waiting: list[float] = []
    waits, unfinished, left = False, False, FRONTIER_SPANS
    for place, delay in enumerate(delays_min):
        if rows and rows[-1][0] <= floor * (1 + NO_CHEAPER):
            rows.append(rows[-1])
            waiting.append(waiting[-1])
            continue
        if rows and left < -FRONTIER_SPANS:
            rows.append((rows[-1][0], floor, *rows[-1][2:]))
            waiting.append(floor)
            unfinished = True
            continue
        most = DELAY_SHARES * max(left, 0) // (len(delays_min) - place)
        planned = planned_platoons(legal.delayed(delay * 60.0), min(most, left))
        left -= planned.work
        cost, bound, company = planned.cost, planned.bound, planned.company
        waits, unfinished = waits | planned.waits, unfinished | planned.unfinished
        name = "" if planned.master is None else question.ends[planned.master].vehicle
        if rows and rows[-1][0] <= cost:
            cost, _, name, company = rows[-1]
        if bound is None or bound >= cost * (1 - NO_CHEAPER):
            bound = cost
        rows.append((cost, bound, name, company))
        waiting.append(floor if planned.waiting_bound is None else planned.waiting_bound)
    costs, bounds, names, members = zip(*rows, strict=True)
    stands = STANDS_LONGER if waits else STANDS_FOR_LAW
    bounds = tuple(waiting) if waits else bounds
    least = np.minimum(np.maximum.accumulate(np.array(bounds)[::-1])[::-1], costs)
    stopped = unfinished and bool((least < costs).any())
    aim = ALL_TOGETHER if question.problem.optimum == "system" else MEMBERS
    leads = "a master" if fixed is None else f"master {question.ends[fixed].vehicle}"
    return DelayFrontier(
        tuple(item.vehicle for item in question.ends),
        question.fleet[0].unit,
        total,
        np.array(delays_min, np.float64),
        np.array(costs),
        least,
        names,
        np.array(members, np.int64),
        (f"{leads} on its own route, {stands}",
         *((STOPPED,) if stopped else ()), ONE_STRETCH, aim, *of_every_curve(question)),
        question.problem.rules.name,
    )  # fmt: skip
