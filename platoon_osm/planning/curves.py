"""Cost against the departure of a master that does not wait, and saving against allowed delay.

Both are exact under the conditions they name: for each departure each member takes what is cheapest
for itself (`no_wait.py`); for each delay every vehicle is tried as master, and the best
departure is taken. With a wider window all ways of a narrower one remain, so the saving never
falls. Under driving rules a master stands for its breaks and rests (`legal/legal_curves.py`).
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from ..driving.rules import DrivingRules, rules_of
from ..errors import ScenarioError, brief
from ..kinds import is_number
from ..plans.curves import DelayFrontier, DepartureCurve
from ..plans.text_table import listed
from ..plans.zones import clock_of
from .answers import CLOCK, NO_WAIT, PRICED
from .asked import Asked
from .company.bound import least_total
from .company.draft import NO_CHEAPER
from .no_wait import NoWait, best_without_waiting
from .problem import Problem
from .question import Question
from .rules_told import named_rules
from .timed_star import TimedStar
from .timing.departure_curve import MemberSteps, StepCurve, StraightSteps
from .timing.limits import Window, first_named

if TYPE_CHECKING:
    from .legal.legal_question import LegalQuestion

__all__ = ["DELAYS_MIN", "delay_frontier", "departure_curve"]

Floats = NDArray[np.float64]

DELAYS_MIN = (0.0, 15.0, 30.0, 60.0, 120.0, 240.0)
"""Delays of a frontier unless others are asked for [min]."""

MOST_MASTERS = 12
"""Masters that are tried; of more vehicles, those whose stars can save most."""

EACH_ITS_OWN = "each member pays least itself"
MS = 3
"""Decimals of seconds in a curve."""


def departure_curve(
    problem: Problem, master: str | None = None, *, rules: str | DrivingRules | None = None
) -> DepartureCurve:
    """Return what all pay together, by the departure of a master that waits for nobody.

    Parameters
    ----------
    problem : Problem
        Whose trips name times.
    master : str, optional
        Name of the vehicle that keeps its route; by default the problem's, or else that with which
        all pay least.
    rules : str or DrivingRules, optional
        Of driving times; by default the problem's.

    Returns
    -------
    DepartureCurve
        Each member takes what is cheapest for itself, whatever the problem's optimum. Under driving
        rules with limits all take their breaks and rests, driving bans count, and departures are in
        whole seconds; otherwise bans do not count.

    Raises
    ------
    ScenarioError
        No trip names a time, no such vehicle, one vehicle alone, or a master that drives no road
        or cannot be in time.
    PlatoonError
        A place that is not on the network, or a trip without any route, or none that keeps the
        rules.
    """
    question = _question(problem, "departure curve", rules)
    names = [item.vehicle for item in question.ends]
    if master is not None and not (isinstance(master, str) and master in names):
        raise ScenarioError(
            f"departure curve: master {brief(master)} has no trip; vehicles are {listed(names)}"
        )
    known = question.fixed_master if master is None else names.index(master)
    if question.problem.limits_driving:
        from .legal.legal_curves import legal_curve

        return legal_curve(_legal(question), known)
    if known is None:
        best = _best_of_masters(question)
        known = question.first_master if best is None else best[0]
    clocked = TimedStar(question, question.star(known))
    points = clocked.points(_widest(question))
    if not len(clocked.star.route) or points.earliest > points.latest:
        raise ScenarioError(
            f"departure curve: {names[known]} cannot drive with others in time; give it a wider "
            "window, or name another master"
        )
    curve, steps = clocked.shown_curve(points)
    step, cost = curve.best(NO_CHEAPER * float(question.solo.sum()) * 1e-2)
    begin = points.first_moment
    end = _last(curve, begin)
    first = first_named(question.problem.trips)
    assert first is not None
    shown = clock_of(first, 0, [begin, end])
    joins = _spans(clocked, steps, begin, end)
    since, until, low, high, company = _merged(curve, steps, clocked, begin, end)
    own = question.problem.optimum == "member" or not clocked.gains.gain.any()
    exact = own and clocked.is_even and clocked.is_complete
    exact = exact and (clocked.is_free or not clocked.gains.gain.any())
    return DepartureCurve(
        names[known],
        tuple(names[k] for k in clocked.star.members),
        question.fleet[known].unit,
        float(question.solo.sum()),
        shown.start.isoformat(),
        shown.name,
        shown.offsets,
        since, until, low, high, company, joins,
        round(max(curve.moment(step), begin), MS),
        cost,
        exact,
        (f"master {names[known]} {NO_WAIT}", EACH_ITS_OWN, *CLOCK,
         *(() if clocked.is_free else (PRICED,)), *named_rules(question.problem.rules)),
    )  # fmt: skip


def delay_frontier(
    problem: Problem,
    delays_min: Iterable[float] = DELAYS_MIN,
    *,
    rules: str | DrivingRules | None = None,
) -> DelayFrontier:
    """Return the largest saving for each delay that every vehicle allows.

    A vehicle that names an earliest departure may arrive so much later than if it left then and
    drove alone; one that names latest times only may leave so much earlier; one without times goes
    along with anybody.

    Parameters
    ----------
    problem : Problem
        Whose trips name times; their windows are replaced by the delays.
    delays_min : iterable of float
        Delays [min], 0 or more.
    rules : str or DrivingRules, optional
        Of driving times; by default the problem's.

    Returns
    -------
    DelayFrontier
        For the best of all masters that wait for nobody, in the order of the delays. Under driving
        rules with limits alone means the legal trip alone, breaks and rests included.

    Raises
    ------
    ScenarioError
        No trip names a time, one vehicle alone, or delays that are none.
    PlatoonError
        A place that is not on the network, or a trip without any route, or none that keeps the
        rules.
    """
    delays = _checked(delays_min)
    question = _question(problem, "frontier", rules)
    if question.problem.limits_driving:
        from .legal.legal_curves import legal_frontier

        return legal_frontier(_legal(question), delays)
    widest = question.within(_windows(question, delays[-1]))
    total = float(question.solo.sum())
    rows: list[tuple[float, float, str, int]] = []
    for delay in delays:
        asked = question.within(_windows(question, delay), widest.ways_in_time)
        found = _best_of_masters(asked)
        cost, bound, name, company = total, total, "", 0
        if found is not None:
            at, best, proved, bound = found
            if best.choice.cost < total * (1 - NO_CHEAPER):
                cost, name = best.choice.cost, question.ends[at].vehicle
                company = int((best.choice.points.merge_index >= 0).sum())
            bound = min(bound, total) if proved else -math.inf
        if rows and rows[-1][0] <= cost:
            cost, _, name, company = rows[-1]
        if not math.isfinite(bound):
            bound = least_total(
                question.net, question.fleet, question.node_pairs, question.least, cost
            )
        rows.append((cost, min(bound, cost), name, company))
    costs, bounds, names, members = zip(*rows, strict=True)
    return DelayFrontier(
        tuple(item.vehicle for item in question.ends),
        question.fleet[0].unit,
        total,
        np.array(delays),
        np.array(costs),
        np.array(bounds),
        names,
        np.array(members, np.int64),
        (f"a master {NO_WAIT}", *CLOCK, *named_rules(question.problem.rules)),
    )


def _question(problem: Problem, what: str, rules: str | DrivingRules | None) -> Question:
    if not isinstance(problem, Problem):
        raise ScenarioError(
            f"{what}: {brief(problem)} is no Problem; make one from a network, trips and costs"
        )
    if first_named(problem.trips) is None:
        raise ScenarioError(f"{what}: no trip names a time; give an earliest_departure, say")
    if len(problem.trips) < 2:
        raise ScenarioError(f"{what}: one vehicle alone has no company; give two trips or more")
    if rules is not None:
        problem = replace(problem, rules=rules_of(rules))
    if problem.limits_driving:
        # One platoon around a master on its own route.
        case = "C" if problem.case in ("best", "D") else problem.case
        problem = replace(problem, case=case, company="master")
    return Asked.of(problem).question


def _legal(question: Question) -> LegalQuestion:
    from .legal.legal_question import LegalQuestion

    problem = question.problem
    return LegalQuestion(question, [problem.vehicle_of(trip) for trip in problem.trips])


def _widest(question: Question) -> str:
    """Return the case that leaves most points free; C if any will do."""
    return "C" if "C" in question.star_cases or not question.star_cases else (
        question.star_cases[-1]
    )  # fmt: skip


def _best_of_masters(question: Question) -> tuple[int, NoWait, bool, float] | None:
    """Return the best master, its plan, whether all are proved, and what none undercuts."""
    fixed = question.fixed_master
    stars = [question.star(k) for k in (question.by_length if fixed is None else [fixed])]
    if len(stars) > MOST_MASTERS:
        stars = sorted(stars, key=lambda star: star.bound)[:MOST_MASTERS]
    best: tuple[int, NoWait] | None = None
    proved, bound = True, math.inf
    for star in stars:
        found = best_without_waiting(TimedStar(question, star), _widest(question))
        if found is None:
            continue
        proved, bound = proved and found.is_proved, min(bound, found.choice.bound)
        if best is None or found.choice.cost < best[1].choice.cost * (1 - NO_CHEAPER):
            best = star.master, found
    return None if best is None else (*best, proved, bound)


def _windows(question: Question, delay_min: float) -> list[Window]:
    both = zip(question.asked_windows, question.alone_s, strict=True)
    late = delay_min * 60.0

    def window(own: Window, drive_s: float) -> Window:
        first = own.earliest
        if first is None:
            last = own.latest if own.arrival is None else own.arrival - drive_s
            if last is None:
                return own
            first = last - late
        return Window(first, None, first + drive_s + late)

    return [window(own, drive_s) for own, drive_s in both]


def _checked(delays_min: Iterable[float]) -> list[float]:
    given = list(delays_min) if isinstance(delays_min, Iterable) else [delays_min]
    if not given or not all(is_number(at) and 0 <= at < math.inf for at in given):
        raise ScenarioError(
            f"frontier: delays {brief(delays_min)} are none; give minutes, 0 or more"
        )
    return sorted({float(at) for at in given})


def _last(curve: StepCurve, begin: float) -> float:
    if math.isfinite(curve.end):
        return curve.end
    moments = curve.since[np.isfinite(curve.since)]
    return max(float(moments.max(initial=begin)), begin) + 1.0


def _merged(
    curve: StepCurve, steps: MemberSteps, clocked: TimedStar, begin: float, end: float
) -> tuple[Floats, Floats, Floats, Floats, NDArray[np.int64]]:
    """Return the steps that can be told apart: bounds, costs at both ends, and company."""
    company = _company(curve, steps, clocked)
    new = np.ones(len(curve.since), bool)
    new[1:] = (
        (np.abs(np.diff(curve.level)) > NO_CHEAPER * np.abs(curve.level[1:]))
        | (np.diff(curve.slope) != 0)
        | (np.diff(company) != 0)
    )
    since: Floats = np.maximum(curve.since[new], begin)
    until: Floats = np.minimum(np.concatenate([since[1:], [end]]), end)
    level, slope = curve.level[new], curve.slope[new]
    low: Floats = level + slope * since
    high: Floats = level + slope * until
    begins: Floats = np.round(since, MS)
    ends: Floats = np.round(until, MS)
    return begins, ends, low, high, company[new]


def _joined(steps: StraightSteps, clocked: TimedStar) -> NDArray[np.bool_]:
    """Mark the steps in which a member drives with the master."""
    if len(steps.merge):
        found: NDArray[np.bool_] = steps.merge >= 0
        return found
    at = np.where(np.isfinite(steps.since), steps.since, 0.0)
    paid = steps.level + steps.slope * at
    cheaper = paid < clocked.solo[steps.member] - clocked.slack[steps.member]
    return cheaper | (steps.slope > 0)


def _company(curve: StepCurve, steps: MemberSteps, clocked: TimedStar) -> NDArray[np.int64]:
    """Return how many members drive with the master in each step of their sum."""
    straight = steps.straight()
    joins = _joined(straight, clocked).astype(np.int64)
    head = np.ones(len(joins), bool)
    head[1:] = straight.member[1:] != straight.member[:-1]
    change = np.where(head, joins, joins - np.roll(joins, 1))
    # Complex numbers are ordered by their real parts, then by their imaginary ones.
    place = np.searchsorted(curve.since + 1j * curve.after, straight.since + 1j * straight.after)
    found = np.zeros(len(curve.since), np.int64)
    np.add.at(found, place, change)
    return np.cumsum(found)


def _spans(clocked: TimedStar, steps: MemberSteps, begin: float, end: float) -> tuple[Floats, ...]:
    """Return for each member from when to when it drives with the master."""
    straight = steps.straight()
    joins, until = _joined(straight, clocked), straight.until
    spans: list[list[list[float]]] = [[] for _ in clocked.star.members]
    rows: Sequence[int] = np.flatnonzero(joins).tolist()
    for row in rows:
        own = spans[int(straight.member[row])]
        first, last = max(float(straight.since[row]), begin), min(float(until[row]), end)
        if own and own[-1][1] >= first:
            own[-1][1] = last
        else:
            own.append([first, last])
    return tuple(np.round(np.array(own, np.float64).reshape(-1, 2), MS) for own in spans)
