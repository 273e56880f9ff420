"""From a problem to a plan: who merges where with whom, what it saves and, if asked, when."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..chance.delays import Delays
from ..costs.objective import Objective
from ..costs.weights import EdgeWeights
from ..driving.rules import DrivingRules
from ..errors import ScenarioError, brief
from ..network.access import STANDARD_ACCESS, Access
from ..network.placed import network_below
from ..network.road_network import RoadNetwork
from ..plans.plan import Plan
from ..plans.proof import Proof
from ..plans.records import MasterTried
from ..plans.stretches import Run
from ..plans.trip import Trip
from ..search.protocol import EngineName
from ..sharing.rule_names import SharingRule
from ..vehicles.profile import Vehicle
from .answers import Answer
from .apart import lawful_company
from .asked import Asked
from .best import Best, best_answer
from .billing import with_bill
from .company.draft import Draft
from .company.platoons import platoons_of
from .gain_shared import with_gain
from .masters import choices_of
from .meeting_chances import with_chances
from .place_remarks import with_place_remarks
from .problem import Company, Lead, Optimum, Problem, check_choice
from .question import Question
from .quick_alone import told_quick
from .reasons import reasons_alone
from .robust import most_robust
from .rotation.rotated import with_rotated_lead
from .routers import AstarRouter, Method
from .rules_told import with_rules
from .star import Star
from .tight_limits import tight_limits
from .timing.bans import with_hours
from .timing.days import Day
from .timing.limits import PATIENCE_MIN
from .timing.schedule import with_times
from .timing.slower_approach import with_slower_approaches
from .timing.waits_at_parkings import with_waits_at_parkings
from .tunnels import passed_tunnels
from .writing import written_plan
from .zones_crossed import zones_crossed

__all__ = ["plan_joint", "solve"]

ESTIMATED_KMH = 80.0
"""Cruising speed by which A* estimates times where the costs name none."""


def plan_joint(
    net: RoadNetwork | Problem,
    weights: EdgeWeights | Objective | None = None,
    trips: Iterable[Trip] | None = None,
    case: str = "best",
    *,
    optimum: Optimum = "member",
    method: Method = "dijkstra",
    master: str | None = None,
    engine: EngineName = "auto",
    access: Access = STANDARD_ACCESS,
    company: Company = "anywhere",
    max_platoon: int | None = None,
    patience_min: float = PATIENCE_MIN,
    profile: Any = None,
    close: Iterable[Any] = (),
    rules: str | DrivingRules = "none",
    task_relief: float = 0.0,
    delays: Delays | None = None,
    robust: bool = False,
    lead: Lead = "master",
    share: SharingRule = "equal",
    objective: Optimum | None = None,
) -> Plan:
    """Plan who merges where with whom, what it saves and, if trips name times, when.

    Parameters
    ----------
    net : RoadNetwork or Problem
        The network; or a `Problem`, which says all the rest too.
    weights : EdgeWeights or Objective
        What edges cost.
    trips : iterable of Trip
        Two or more; one alone is planned as it is.
    case : {"A", "B", "C", "D", "best"}
        "A" members merge and stay, "B" start together and separate, "C" both, "D" two vehicles
        whose routes are both free, "best" the cheapest of those that apply.
    optimum : {"member", "system"}
        "member": each member pays least itself (the paper); "system": members and master together
        pay least.
    method : {"dijkstra", "astar", "astar-closed-once"}
        "dijkstra" is exact; "astar" is the paper's inflated A*, and the plan then reports its
        excess over the optimum; "astar-closed-once" is the same with each node explored once.
    master : str, optional
        Name of the vehicle that keeps its route, or "longest" for that of the longest route, as the
        paper has it. By default every vehicle is tried, and the plan that is cheapest for all is
        taken; under "astar" it is the longest.
    engine : {"auto", "reference", "hierarchy"}
        Which engine searches, "auto" the one that is likely faster; routes do not depend on it.
    access : Access
        How places beside the road get onto it, and how far from it they may be.
    company : {"anywhere", "master"}
        Where vehicles that drive side by side are a platoon: "anywhere", and then vehicles plan
        again in turns around each other; or with the master alone, as in the paper.
    max_platoon : int, optional
        Vehicles of the largest platoon allowed, 2 or more; by default any.
    patience_min : float
        By how many minutes company may move a vehicle that names no window. One with a window may
        be moved within it, and nobody who is in time alone is late for company.
    profile : Vehicle or str or mapping, optional
        The vehicle of every trip that names none: one of `VEHICLES`, as "eu-40t", or fields of
        `Vehicle` by name. By default a truck of 40 t at whatever speed the network was loaded for.
    close : iterable of str, int or (float, float)
        Roads that count as closed: edge ids, "way 123456", points on them, road numbers.
    rules : str or DrivingRules
        Of driving times: a name of `RULES`, as "eu561", or rules of your own.
    task_relief : float
        How much a follower's driving clock slows under them, from 0 to 1.
    delays : Delays, optional
        How late vehicles may be; the plan then tells how likely each merge is.
    robust : bool
        Whether to take the plan that is expected to save most with these, not the cheapest.
    lead : {"master", "rotated"}
        Who leads: the master wherever it is, or all in turns, handed on at junctions so that each
        leads its fair share.
    share : {"equal", "shapley", "least-core"}
        By what rule the gain is shared, where costs are money.
    objective : {"member", "system"}, optional
        What `optimum` was called before; it counts if given.

    Returns
    -------
    Plan
        With what is proved about it.

    Raises
    ------
    ScenarioError
        Unknown case, optimum, method, engine, rules or master; D for other than two vehicles; a
        trip that ends where it starts; times with and without a zone; arguments of another kind.
    NetworkError
        A place that is not on the network.
    NoRouteError
        A trip without any route, or with none that keeps the rules.
    """
    if isinstance(net, Problem):
        if weights is not None or trips is not None:
            raise ScenarioError("plan: a Problem says all; give no weights or trips beside it")
        return solve(net)
    if objective is not None:
        check_choice("objective", objective, ("member", "system"))
        optimum = objective
    costs: Any = weights
    given: Any = trips
    shut: Any = close
    law: Any = rules
    return solve(
        Problem(
            net=net, trips=given, objective=costs, case=case, master=master, method=method,
            optimum=optimum, engine=engine, access=access, company=company,
            max_platoon=max_platoon, patience_min=patience_min, profile=profile, close=shut,
            rules=law, task_relief=task_relief, delays=delays, robust=robust,
            lead=lead, share=share,
        )
    )  # fmt: skip


def solve(problem: Problem) -> Plan:
    """Return the best plan of a problem; what `plan_joint` does once it knows the question.

    Parameters
    ----------
    problem : Problem
        What is asked.

    Returns
    -------
    Plan
        With what is proved about it.

    Raises
    ------
    PlatoonError
        As `plan_joint`, or no problem.
    """
    if not isinstance(problem, Problem):
        raise ScenarioError(
            f"plan: {brief(problem)} is no Problem; make one from a network, trips and an objective"
        )
    asked = Asked.of(problem)
    question, locations, shut = asked.question, asked.locations, asked.shut
    problem, net = question.problem, question.net
    exact = problem.method == "dijkstra"
    patience_s = problem.patience_min * 60.0 if exact else None
    vehicles = [problem.vehicle_of(trip) for trip in problem.trips]

    def timed(plan: Plan, days: Sequence[Day] | None = None) -> Plan:
        plan = with_times(with_place_remarks(plan, net, locations), problem.trips, patience_s, days)
        return with_hours(plan, net, problem.trips, vehicles, patience_s)

    def finished(best: Best, reasons: Sequence[str], days: Sequence[Day] | None = None) -> Plan:
        return timed(_of_best(question, best, reasons), days)

    if exact and problem.limits_driving:
        from .legal.solve import solved_under_law

        plan = solved_under_law(
            question,
            vehicles,
            lambda routed, best, reasons: with_place_remarks(
                _of_best(routed, best, reasons), net, locations
            ),
        )
    elif exact:
        best = best_answer(question)
        plan = finished(best, reasons_alone(question, best.answer))
        plan = lawful_company(question, best, plan, vehicles, finished)
        if problem.robust:
            plan = most_robust(question, best, plan, vehicles, finished)
        plan = with_slower_approaches(plan, network_below(net), vehicles)
        plan = replace(plan, remarks=(*plan.remarks, *told_quick(question)))
    else:
        plan = timed(_by_astar(question))
    plan = with_waits_at_parkings(plan, network_below(net), vehicles)
    if problem.lead == "rotated":
        plan = with_rotated_lead(plan, net, question.fleet)
    if problem.delays is not None:
        plan = with_chances(plan, problem.delays, problem.objective)
    plan = with_rules(_with_limits(plan, net, vehicles, shut), problem.rules)
    plan = with_bill(plan, problem.objective, network_below(net))
    if plan.bill is None:
        return plan
    fleet = question.fleet if network_below(net) is net else None
    return with_gain(plan, problem, problem.share, fleet, bounded=False)


def _with_limits(
    plan: Plan, net: RoadNetwork, vehicles: Sequence[Vehicle], shut: NDArray[np.bool_]
) -> Plan:
    """Remark what vehicles pass with little room, tunnels with a category, and zones crossed."""
    remarks = (
        *tight_limits(plan, net, vehicles),
        *passed_tunnels(plan, net, vehicles),
        *zones_crossed(plan, net, vehicles, shut),
    )
    return replace(plan, remarks=(*plan.remarks, *remarks)) if remarks else plan


def _of_best(question: Question, best: Best, reasons: Sequence[str]) -> Plan:
    """Return the plan of an answer, without times."""
    answer = best.answer
    return _written(
        question, answer.draft.runs(), answer.case, answer.master, best.proof, reasons,
        masters=best.masters, remarks=best.remarks,
    )  # fmt: skip


def _written(
    question: Question,
    runs: list[list[Run]],
    case: str,
    master: int | None,
    proof: Proof,
    reasons: Sequence[str],
    masters: tuple[MasterTried, ...] = (),
    remarks: tuple[str, ...] = (),
) -> Plan:
    plan = written_plan(
        question.problem, question.fleet, question.ends, question.alone, runs,
        platoons_of(runs, master, case), reasons, case, proof,
    )  # fmt: skip
    return replace(plan, masters=masters, remarks=(*remarks, *plan.remarks))


def _by_astar(question: Question) -> Plan:
    """Return the plan of the paper's A*, beside the exact one of the same case and master."""
    problem, fleet, ends = question.problem, question.fleet, question.ends
    master = question.first_master
    exact = question.star(master)
    speed = float(fleet[master].params.get("speed_kmh", ESTIMATED_KMH)) / 3.6
    cost = float(question.solo[master])
    routers = [
        AstarRouter(question.net, fleet.alone(kind[0]), cost, speed, problem.method)
        for kind in fleet.kinds
    ]
    star = Star(question.net, fleet, ends, master, [routers[kind] for kind in fleet.kind])
    choice = choices_of(star, question.star_cases, problem.optimum)[0]
    compared = exact.choose(choice.case, problem.optimum)
    proof = Proof(
        "heuristic",
        choice.cost,
        None,
        (
            "the inflated heuristic is not admissible",
            "the optimum is that of the same case along Dijkstra's route of the master",
        ),
        # The plan may cost less: A* gives the master a longer route, for others to share.
        optimum=compared.cost,
        solo_excess=star.solo_cost / exact.solo_cost - 1 if exact.solo_cost else 0.0,
    )
    runs = star.routes(choice.points)
    draft = Draft.of(runs)
    answer = Answer(draft, draft.costs(fleet), choice.case, master, None)
    question.alone = star.alone
    return _written(question, runs, choice.case, master, proof, reasons_alone(question, answer))
