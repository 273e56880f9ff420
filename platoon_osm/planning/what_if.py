"""What if a figure were another: a plan for each value, and what planning anew is worth.

The network stays, and what searches know of it; equal problems are planned once. Where company
begins to pay is found by halving the interval between two values, one with company and one
without.

Of a price p a plan of fixed roads and times costs a + b p, and alone vehicles pay the least of such
lines, which is concave. What a plan saves is thus concave in p: if it saves at two values, it saves
at all between. A plan that saves at the value found and at the last one asked so proves that
company pays from there on. If all plans are as dear as alone at two values, and everybody's road
alone is the same at both, no plan saves between them, for what it saves is then a line.
"""

from __future__ import annotations

import dataclasses
import math
from collections.abc import Iterable
from functools import cached_property
from typing import Any

from ..costs.consumption import Consumption
from ..errors import ScenarioError, brief
from ..kinds import is_number
from ..plans.paid import paid
from ..plans.plan import Plan
from ..plans.what_if import Threshold, Value, WhatIf, WhatIfRow
from .joint import solve
from .kept_plan import KeptPlan
from .plan_changes import changes, in_company, leaders
from .problem import Problem

__all__ = ["MOST_VALUES", "PRICED", "TASK_RELIEF", "what_if"]

MOST_VALUES = 200
"""Of more values nobody reads the table."""

TASK_RELIEF = "task_relief"

PRICED = frozenset({
    "fuel_per_l", "driver_per_h", "toll", "toll_unknown_per_km", "co2_per_t", "waiting_per_h",
    "delay_per_h",
})  # fmt: skip
"""Figures in which the cost of every plan is a line, all others being the same."""

PART = 100
"""Into so many parts a range is cut to say where company begins to pay, unless told otherwise."""

LESS_RELIEF = "it may not be within the rules where a follower's clock slows less"


def what_if(
    problem: Problem,
    figure: str,
    values: Iterable[Value],
    *,
    tolerance: float | None = None,
    plan: Plan | None = None,
) -> WhatIf:
    """Plan anew for each value of a figure, all else being the same.

    Parameters
    ----------
    problem : Problem
        What is asked.
    figure : str
        A parameter of its objective, such as "fuel_per_l", "driver_per_h" (with the price of
        waiting, where that is the driver's hour), "toll", "co2_per_t", "positions" or the paper's
        "tau"; or "task_relief".
    values : iterable of float or str
        Of the figure, 200 at most.
    tolerance : float, optional
        How near the value is told at which company begins to pay; by default a hundredth of the
        range of the values.
    plan : Plan, optional
        The plan as asked, where it was made before.

    Returns
    -------
    WhatIf
        One row a value, in their order.

    Raises
    ------
    ScenarioError
        A figure that the objective has not, no values, too many, or one that cannot be.
    PlatoonError
        As `plan_joint`.
    """
    asked, wanted = _checked(problem, figure, values)
    if tolerance is not None and not (is_number(tolerance) and tolerance > 0):
        raise ScenarioError(f"what_if: tolerance {brief(tolerance)} is none; give one above 0")
    names = [trip.vehicle for trip in problem.trips]
    if plan is not None and not (
        isinstance(plan, Plan) and [trip.vehicle for trip in plan.trips] == names
    ):
        raise ScenarioError(f"what_if: plan {brief(plan)} is not that of the problem; leave it out")
    study = _Study(problem, figure, asked, plan)
    for value in wanted:  # all are checked before any is planned
        study.problem_of(value)
    rows = tuple(study.row(value) for value in wanted)
    return WhatIf(
        figure, _unit_of(problem, figure), asked, study.base, rows, study.threshold(rows, tolerance)
    )


def _checked(problem: object, figure: object, values: object) -> tuple[Value, list[Value]]:
    if not isinstance(problem, Problem):
        raise ScenarioError(
            f"what_if: {brief(problem)} is no Problem; make one from a network, trips and an "
            "objective"
        )
    known = _figures(problem)
    if not (isinstance(figure, str) and figure in known):
        raise ScenarioError(
            f"what_if: figure {brief(figure)} is unknown; those of {brief(_name(problem))} are "
            f"{', '.join(known)}"
        )
    if isinstance(values, str) or not isinstance(values, Iterable):
        raise ScenarioError(f"what_if: values {brief(values)} are no list; give some of {figure}")
    wanted = list(values)
    if not wanted:
        raise ScenarioError(f"what_if: no values of {figure}; give at least one")
    if len(wanted) > MOST_VALUES:
        raise ScenarioError(
            f"what_if: {len(wanted):,} values of {figure}; give {MOST_VALUES} at most"
        )
    asked = known[figure]
    for value in wanted:
        fits = isinstance(value, str) if isinstance(asked, str) else is_number(value)
        if not fits or (not isinstance(value, str) and not math.isfinite(value)):
            kind = "a name" if isinstance(asked, str) else "a number"
            raise ScenarioError(f"what_if: {figure} = {brief(value)} is no value; give {kind}")
    return asked, [value if isinstance(value, str) else float(value) for value in wanted]


def _name(problem: Problem) -> str:
    return getattr(problem.objective, "name", type(problem.objective).__name__)


def _figures(problem: Problem) -> dict[str, Value]:
    """Return the figures that can be varied, with their values as asked."""
    found: dict[str, Value] = {}
    objective = problem.objective
    # Bare weights are arrays, and have no figures.
    if hasattr(objective, "params") and dataclasses.is_dataclass(objective):
        names = {item.name for item in dataclasses.fields(objective)}
        physics = getattr(objective, "consumption", None)
        if isinstance(physics, Consumption):
            names |= {item.name for item in dataclasses.fields(physics)}
        for name, value in objective.params.items():
            if name in names and name != "preset" and (is_number(value) or isinstance(value, str)):
                found[name] = value if isinstance(value, str) else float(value)
    return {**found, TASK_RELIEF: float(problem.task_relief)}


def _unit_of(problem: Problem, figure: str) -> str:
    told = getattr(problem.objective, "figures", None)
    rows = told() if callable(told) else ()
    return next((one.unit for one in rows if one.name == figure), "")


class _Study:
    """A problem whose figure takes values; what was planned is kept."""

    def __init__(self, problem: Problem, figure: str, asked: Value, plan: Plan | None) -> None:
        self.problem, self.figure, self.asked = problem, figure, asked
        self._plans: dict[Value, Plan] = {} if plan is None else {asked: plan}

    @cached_property
    def base(self) -> Plan:
        """The plan as asked."""
        return self.plan(self.asked)

    @cached_property
    def _kept(self) -> KeptPlan:
        return KeptPlan.of(self.base, self.problem)

    def problem_of(self, value: Value) -> Problem:
        """Return the problem with a value of the figure."""
        if value == self.asked:
            return self.problem
        if self.figure == TASK_RELIEF:
            assert not isinstance(value, str)
            return dataclasses.replace(self.problem, task_relief=value)
        objective: Any = self.problem.objective
        return dataclasses.replace(self.problem, objective=_changed(objective, self.figure, value))

    def plan(self, value: Value) -> Plan:
        """Return the plan for a value."""
        if value not in self._plans:
            self._plans[value] = solve(self.problem_of(value))
        return self._plans[value]

    def kept(self, plan: Plan, value: Value) -> Plan:
        """Return a plan with what it costs at a value."""
        new = self.plan(value)
        if self.figure == TASK_RELIEF or plan is new:
            return plan
        if _driven(plan) == _driven(new):
            return new  # sums of other stretches would differ by a cent
        kept = self._kept if plan is self.base else self._kept.kept(plan)
        return kept.priced(self.problem_of(value), new)

    def row(self, value: Value) -> WhatIfRow:
        """Return what is told of a value."""
        plan = self.plan(value)
        alone, joint = paid(plan)
        less = self._has_less_relief(value)
        return WhatIfRow(
            value,
            alone,
            joint,
            None if plan.proof.bound is None else max(alone - joint, alone - plan.proof.bound),
            plan.platoon_m,
            sum(one.alone.fuel_l - one.fuel_l for one in plan.vehicles),
            None if plan.bill is None else plan.bill.saved_kg,
            leaders(plan),
            in_company(plan),
            changes(plan, self.base),
            None if less else paid(self.kept(self.base, value))[1],
            LESS_RELIEF if less else "",
            plan.proof,
        )

    def _has_less_relief(self, value: Value) -> bool:
        """Tell whether the plan as asked may break rules for want of relief."""
        if self.figure != TASK_RELIEF or not self.problem.limits_driving:
            return False
        return float(value) < float(self.asked)

    def threshold(self, rows: tuple[WhatIfRow, ...], tolerance: float | None) -> Threshold | None:
        """Return where company first begins or ends to pay as the figure rises."""
        if isinstance(self.asked, str):
            return None
        ordered = sorted({float(row.value): bool(row.company) for row in rows}.items())
        pair = next((k for k in range(1, len(ordered)) if ordered[k][1] != ordered[k - 1][1]), None)
        if pair is None:
            return None
        (low, pays_low), (high, _) = ordered[pair - 1], ordered[pair]
        near = (ordered[-1][0] - ordered[0][0]) / PART if tolerance is None else tolerance
        while high - low > near:
            middle = (low + high) / 2
            if not low < middle < high:
                break
            if bool(in_company(self.plan(middle))) == pays_low:
                low = middle
            else:
                high = middle
        ends = ordered[0][0], ordered[-1][0]
        return Threshold(low, high, not pays_low, self._is_proved(low, high, not pays_low, ends))

    def _is_proved(
        self, low: float, high: float, from_above: bool, ends: tuple[float, float]
    ) -> bool:
        """Tell whether company pays at all values on one side, and at none on the other."""
        if self.figure not in PRICED or self.problem.limits_driving:
            return False
        pays, last = (high, ends[1]) if from_above else (low, ends[0])
        never, first = (low, ends[0]) if from_above else (high, ends[1])
        plan = self.plan(pays)
        if not all(self._pays(self.kept(plan, value)) for value in (pays, last)):
            return False
        apart = [self.plan(value) for value in (never, first)]
        roads = [tuple(trip.alone.edges for trip in one.trips) for one in apart]
        told = [remark for one in (*apart, plan) for remark in one.remarks]
        cheapest = not any(QUICK in remark for remark in told)
        return (
            cheapest
            and roads[0] == roads[1]
            and all(one.proof.kind == "exact" and not in_company(one) for one in apart)
        )

    def _pays(self, plan: Plan) -> bool:
        """Tell whether a plan saves, and where each pays least itself whether nobody loses."""
        each = [paid(plan, [vehicle]) for vehicle in range(len(plan.trips))]
        fair = self.problem.optimum == "system" or all(joint <= alone for alone, joint in each)
        return fair and sum(joint for _, joint in each) < sum(alone for alone, _ in each)


QUICK = "takes a quicker route than its cheapest"
"""Whoever does drives alone not what is cheapest, so what it pays alone is not concave."""


def _driven(plan: Plan) -> tuple[object, ...]:
    """Return who drives what with whom, and when."""
    roads = [(one.edges, one.span, one.access, one.vehicles) for one in plan.stretches]
    times = [None if one is None else (one.departure_s, one.legs) for one in plan.times]
    return roads, plan.ways, times


def _changed(objective: Any, figure: str, value: Value) -> Any:
    """Return an objective with another value of a figure."""
    own = {item.name for item in dataclasses.fields(objective)}
    try:
        if figure not in own:
            physics = dataclasses.replace(objective.consumption, **{figure: value})
            return dataclasses.replace(objective, consumption=physics)
        more = {}
        if figure == "driver_per_h" and objective.waiting_per_h == objective.driver_per_h:
            # Waiting is the driver's hour, and goes with it.
            more["waiting_per_h"] = value
        return dataclasses.replace(objective, **{figure: value}, **more)
    except ScenarioError as error:
        raise ScenarioError(f"what_if: {error}") from None
