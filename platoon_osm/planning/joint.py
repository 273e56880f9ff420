"""From a problem to a plan: who merges where with whom, what it saves and, if asked, when."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace
from typing import Any

from ..costs.objective import Objective
from ..costs.placed_weights import placed_weights
from ..costs.weights import EdgeWeights
from ..driving.rules import Drive
from ..errors import ScenarioError, brief
from ..network.access import STANDARD_ACCESS, Access
from ..network.placed import access_of
from ..network.road_network import RoadNetwork
from ..plans.plan import Plan
from ..plans.proof import Proof
from ..plans.records import Platoon
from ..plans.stretches import Run, runs_alone, runs_along
from ..plans.trip import Trip
from ..search.protocol import EngineName
from ..search.searches import Searches
from ..search.trees import Trees
from .ends import TripEnds, located, resolve_trips
from .master import longest_route
from .pair import PairPlan, plan_pair
from .place_remarks import with_place_remarks
from .places import placed
from .problem import Optimum, Problem, check_choice
from .routers import AstarRouter, DijkstraRouter, Method
from .star import Star, StarChoice
from .timing.schedule import with_times
from .writing import written_plan

__all__ = ["plan_joint", "solve"]

WAITING_FREE = "waiting at merging points is free"
ALIKE = "vehicles are alike"
ROUTE_FIXED = "the master keeps its own route"
ONE_STRETCH = "one shared stretch for each member"

NO_CHEAPER = 1e-9
"""A case is better only if it costs less by this share; else the simpler one is taken."""

ESTIMATED_KMH = 80.0
"""Cruising speed by which A* estimates times where the costs name none."""


def plan_joint(
    net: RoadNetwork | Problem,
    weights: EdgeWeights | Objective | None = None,
    trips: Iterable[Trip] | None = None,
    case: str = "best",
    *,
    objective: Optimum = "member",
    method: Method = "dijkstra",
    master: str | None = None,
    engine: EngineName = "auto",
    access: Access = STANDARD_ACCESS,
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
    objective : {"member", "system"}
        "member": each member pays least itself (the paper); "system": members and master together
        pay least.
    method : {"dijkstra", "astar", "astar-closed-once"}
        "dijkstra" is exact; "astar" is the paper's inflated A*, and the plan then reports its
        excess over the optimum; "astar-closed-once" is the same with each node explored once.
    master : str, optional
        Name of the vehicle that keeps its route; by default that of the longest route.
    engine : {"auto", "reference", "hierarchy"}
        Which engine searches, "auto" the one that is likely faster; routes do not depend on it.
    access : Access
        How places beside the road get onto it, and how far from it they may be.

    Returns
    -------
    Plan
        With what is proved about it.

    Raises
    ------
    ScenarioError
        Unknown case, objective, method, engine or master; D for other than two vehicles; a trip
        that ends where it starts; times with and without a zone; arguments of another kind.
    NetworkError
        A place that is not on the network.
    NoRouteError
        A trip without any route.
    """
    if isinstance(net, Problem):
        if weights is not None or trips is not None:
            raise ScenarioError("plan: a Problem says all; give no weights or trips beside it")
        return solve(net)
    check_choice("objective", objective, ("member", "system"))
    costs: Any = weights
    given: Any = trips
    return solve(
        Problem(
            net=net, trips=given, objective=costs, case=case, master=master, method=method,
            optimum=objective, engine=engine, access=access,
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
    locations = located(problem.net, problem.trips, problem.access)
    places = placed(problem.net, locations, problem.access)
    net = places.net
    weights = placed_weights(problem.objective, net, "plan")
    problem = replace(problem, net=net)
    # A search for each candidate of the fewer, then one from each end of each trip.
    expected = sum(min(len(end.nodes) for end in ends) + 2 for ends in places.ends)
    trees = Trees(net.attached(Searches).under(weights.solo, expected, problem.engine))
    ends = resolve_trips(net, weights, trees, problem.trips, places.ends)
    case = _Cases(problem, weights, tuple(ends), trees)
    plan = with_place_remarks(case.best(), net, locations)
    return _with_rules(with_times(plan, problem.trips), problem)


@dataclass(frozen=True, slots=True)
class _Decision:
    """A case that was planned, not yet written down."""

    case: str
    cost: float
    choice: StarChoice | PairPlan


class _Cases:
    """The cases of one problem; they share routes, searches and tables."""

    def __init__(
        self, problem: Problem, weights: EdgeWeights, ends: tuple[TripEnds, ...], trees: Trees
    ) -> None:
        self.problem, self.weights, self.ends, self.trees = problem, weights, ends, trees
        net = problem.net
        exact = DijkstraRouter(trees)
        alone = [exact.route(item.origin, item.destination) for item in ends]
        names = [item.vehicle for item in ends]
        self.master = (
            longest_route([float(net.length_m[route].sum()) for route in alone])
            if problem.master is None
            else names.index(problem.master)
        )
        self.exact = Star(net, weights, ends, self.master, exact)
        self.star = self.exact
        if problem.method != "dijkstra":
            own = ends[self.master]
            speed = float(weights.params.get("speed_kmh", ESTIMATED_KMH)) / 3.6
            cost = trees.tree(own.origin).dist[own.destination]
            router = AstarRouter(net, weights.solo, float(cost), speed, problem.method)
            self.star = Star(net, weights, ends, self.master, router)

    def best(self) -> Plan:
        """Return the plan of the cheapest case; of equally good ones the first."""
        first, *others = (self._decide(case) for case in self.problem.cases)
        best = first
        for other in others:
            if other.cost < best.cost * (1 - NO_CHEAPER):
                best = other
        if isinstance(best.choice, PairPlan):
            return self._written_pair(best.choice)
        return self._written_star(best.choice)

    def _decide(self, case: str) -> _Decision:
        if case == "D":
            first, second = self.ends[self.master], self.ends[1 - self.master]
            pair = plan_pair(
                self.problem.net,
                self.weights,
                (first.origin, second.origin),
                (first.destination, second.destination),
                trees=self.trees,
            )
            return _Decision(case, pair.cost, pair)
        choice = self.star.choose(case, self.problem.optimum)
        return _Decision(case, choice.cost, choice)

    def _conditions(self, *own: str) -> tuple[str, ...]:
        free = self.problem.objective.waiting(3600.0) == 0
        return (*((WAITING_FREE,) if free else ()), *own)

    def _written_star(self, choice: StarChoice) -> Plan:
        star, case = self.star, choice.case
        reasons = [""] * len(self.ends)
        master = self.ends[self.master].vehicle
        group = [self.master]
        for k, index in enumerate(star.members):
            if choice.points.merge_index[k] >= 0:
                group.append(index)
            else:
                reasons[index] = _why_alone(case, bool(choice.points.applicable[k]), master)
        return written_plan(
            self.problem,
            self.weights,
            self.ends,
            star.alone,
            star.routes(choice.points),
            [Platoon(tuple(sorted(group)), self.master, case)],
            reasons,
            case,
            self._proof_of(choice),
        )

    def _proof_of(self, choice: StarChoice) -> Proof:
        if self.problem.method == "dijkstra":
            return Proof.of(choice.cost, choice.bound, self._conditions(ROUTE_FIXED))
        compared = self.exact.choose(choice.case, self.problem.optimum)
        alone = self.exact.solo_cost
        return Proof(
            "heuristic",
            choice.cost,
            None,
            (
                "the inflated heuristic is not admissible",
                "the optimum is that of the same case along Dijkstra's route of the master",
            ),
            # The plan may cost less: A* gives the master a longer route, for others to share.
            optimum=compared.cost,
            solo_excess=self.star.solo_cost / alone - 1 if alone else 0.0,
        )

    def _written_pair(self, pair: PairPlan) -> Plan:
        order = (self.master, 1 - self.master)
        # A way beside the road is nobody's company, though it costs no more side by side.
        ways = access_of(self.problem.net, pair.shared)
        together = not ways.all()
        routes: list[list[Run]] = [[], []]
        for k, index in enumerate(order):
            routes[index] = [
                *runs_alone(pair.before[k], index),
                *runs_along(pair.shared, [order] * len(pair.shared)),
                *runs_alone(pair.after[k], index),
            ]
        names = [item.vehicle for item in self.ends]
        return written_plan(
            self.problem,
            self.weights,
            self.ends,
            self.exact.alone,
            routes,
            [Platoon((0, 1), None, "D")] if together else [],
            ["" if together else _why_alone("D", True, names[1 - index]) for index in (0, 1)],
            "D",
            Proof.of(pair.cost, pair.cost, self._conditions(ALIKE, ONE_STRETCH)),
        )


def _why_alone(case: str, applicable: bool, master: str) -> str:
    if applicable:
        return f"driving alone costs less than any way with {master}"
    end = "destination" if case == "A" else "origin"
    return f"case {case} does not apply: its {end} is not on the route of {master}"


def _with_rules(plan: Plan, problem: Problem) -> Plan:
    """Remark what the plan breaks of the driving rules."""
    remarks = [
        f"{vehicle.vehicle}: {violation.text}"
        for index, vehicle in enumerate(plan.vehicles)
        for violation in problem.rules.violations(_day(plan, index))
    ]
    return replace(plan, remarks=(*plan.remarks, *remarks)) if remarks else plan


def _day(plan: Plan, index: int) -> Sequence[Drive]:
    times = plan.times[index]
    waits = times.waits if times else (0.0,) * len(plan.ways[index])
    return [
        Drive(plan.stretches[k].drive_s, plan.stretches[k].vehicles[0] == index, wait)
        for k, wait in zip(plan.ways[index], waits, strict=True)
    ]
