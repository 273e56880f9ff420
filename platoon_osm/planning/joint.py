"""A master and its members: from trips to a joint plan."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Any, Literal

import numpy as np
from numpy.typing import NDArray

from .._version import __version__
from ..costs.weights import EdgeWeights
from ..errors import ScenarioError
from ..network.road_network import RoadNetwork
from ..plans.records import JointPlan, VehiclePlan
from ..plans.trip import Trip, check_one_clock
from ..search.dijkstra import ReferenceEngine
from ..search.joining import entry_exit_costs
from .cases import CASES, MemberPlans, choose_points, route_nodes
from .ends import TripEnds, resolve_trips
from .pair import plan_pair
from .routers import AstarRouter, DijkstraRouter, Method, Router
from .system import choose_for_system
from .timing.schedule import with_times
from .writing import Journey, identity_of, vehicle_plan

__all__ = ["Objective", "plan_joint"]

Objective = Literal["member", "system"]
Edges = NDArray[np.int64]

NO_EDGES: Edges = np.zeros(0, np.int64)
WAITING_FREE = "waiting at merging points is free"
ALIKE = "vehicles are alike"
ROUTE_FIXED = "the master keeps its own route"
ONE_STRETCH = "one shared stretch for each member"


def plan_joint(
    net: RoadNetwork,
    weights: EdgeWeights,
    trips: Sequence[Trip],
    case: str = "best",
    *,
    objective: Objective = "member",
    method: Method = "dijkstra",
    master: str | None = None,
) -> JointPlan:
    """Plan who merges where with whom, what it saves and, if trips name times, when.

    Parameters
    ----------
    trips : two or more; one alone is planned as it is.
    case : "A" members merge and stay, "B" start together and separate, "C" both, "D" two vehicles
        whose routes are both free, "best" the cheapest of those that apply.
    objective : "member": each member pays least itself (the paper); "system": members and master
        together pay least.
    method : "dijkstra" is exact; "astar" is the paper's inflated A*, and the plan then reports
        its excess over the optimum.
    master : name of the vehicle that keeps its route; by default that of the longest route.

    Raises
    ------
    ScenarioError
        Unknown case, objective, method or master; D for other than two vehicles; a trip that ends
        where it starts; times with and without a zone.
    NoRouteError
        A trip without any route.
    """
    _check(case, objective, method, trips)
    engine = ReferenceEngine(net, weights.solo)
    ends = resolve_trips(net, weights, engine, trips)
    router = DijkstraRouter(engine)
    chosen_master = _master(net, router, ends, master)
    task = _Task(net, weights, tuple(ends), chosen_master, objective, case)
    wanted = [case] if case != "best" else [c for c in CASES if c != "D" or len(ends) == 2]
    if method == "astar" and case == "best":
        wanted = [c for c in wanted if c != "D"]
    plans = [_plan(task, one, router, method) for one in wanted]
    best = plans[0]
    for plan in plans[1:]:
        # Of equally good cases the earlier one is simpler.
        if plan.joint_cost < best.joint_cost * (1 - 1e-9):
            best = plan
    return with_times(best, trips)


def _check(case: str, objective: str, method: str, trips: Sequence[Trip]) -> None:
    for label, value, allowed in (
        ("case", case, (*CASES, "best")),
        ("objective", objective, ("member", "system")),
        ("method", method, ("dijkstra", "astar")),
    ):
        if value not in allowed:
            raise ScenarioError(f"{label} {value!r} is unknown; use {', '.join(allowed)}")
    if not trips:
        raise ScenarioError("plan: no trips; give at least one")
    if case == "D" and len(trips) != 2:
        raise ScenarioError(
            f"case 'D' plans two vehicles, not {len(trips)}; use C for one master and many members"
        )
    if case == "D" and method == "astar":
        raise ScenarioError("case 'D' is beyond the paper's A*; use method dijkstra")
    check_one_clock(trips)


@dataclass(frozen=True, slots=True)
class _Task:
    """What stays the same for all cases of one plan."""

    net: RoadNetwork
    weights: EdgeWeights
    ends: tuple[TripEnds, ...]
    master: int
    objective: Objective
    asked: str


def _master(
    net: RoadNetwork, router: DijkstraRouter, ends: Sequence[TripEnds], name: str | None
) -> int:
    if name is not None:
        names = [item.vehicle for item in ends]
        if name not in names:
            raise ScenarioError(f"master {name!r} has no trip; vehicles are {', '.join(names)}")
        return names.index(name)
    lengths = [
        round(float(net.length_m[router.route(item.origin, item.destination)].sum()), 3)
        for item in ends
    ]
    return int(np.argmax(lengths))


def _plan(task: _Task, case: str, exact: DijkstraRouter, method: Method) -> JointPlan:
    if case == "D":
        return _pair_plan(task, exact)
    if method == "dijkstra":
        return _member_plan(task, case, exact, "dijkstra")
    master = task.ends[task.master]
    router = AstarRouter(
        task.net,
        task.weights.solo,
        exact.cost(master.origin, master.destination),
        float(task.weights.params.get("speed_kmh", 80.0)) / 3.6,
    )
    plan = _member_plan(task, case, router, "astar")
    compared = _member_plan(task, case, exact, "dijkstra")
    optimum, alone = compared.joint_cost, compared.solo_cost
    proof = {
        "kind": "heuristic",
        "optimum": optimum,
        # May fall below 0: A* gives the master a longer route, which others may share more of.
        "excess": plan.joint_cost / optimum - 1 if optimum else 0.0,
        "solo_excess": plan.solo_cost / alone - 1 if alone else 0.0,
        "conditions": [
            "the inflated heuristic is not admissible",
            "the optimum is that of the same case along Dijkstra's route of the master",
        ],
    }
    return replace(plan, proof=proof)


def _member_plan(task: _Task, case: Any, router: Router, method: Method) -> JointPlan:
    net, weights, ends = task.net, task.weights, task.ends
    master = ends[task.master]
    route = router.route(master.origin, master.destination)
    members = [item for k, item in enumerate(ends) if k != task.master]
    origins = np.array([item.origin for item in members], np.int64)
    destinations = np.array([item.destination for item in members], np.int64)
    if isinstance(router, DijkstraRouter):
        costs = entry_exit_costs(router, route_nodes(net, route), origins, destinations)
    else:
        costs = _astar_costs(router, route_nodes(net, route), origins, destinations)

    def choose(gain: NDArray[np.float64] | None, rows: Edges) -> MemberPlans:
        entry, leave, solo = costs
        some = [members[k] for k in rows]
        return choose_points(
            net, weights, route, origins[rows], destinations[rows], case,
            (entry[rows], leave[rows], solo[rows]),
            [item.origins for item in some], [item.destinations for item in some], gain,
        )  # fmt: skip

    proof: dict[str, Any] = {"kind": "exact", "conditions": [WAITING_FREE, ROUTE_FIXED]}
    if task.objective == "member" or not members:
        chosen = choose(None, np.arange(len(members)))
    else:
        gain = (weights.solo - weights.master)[route]
        if (gain < 0).any():
            raise ScenarioError(
                f"objective 'system': edge {route[np.argmax(gain < 0)]} costs the master more in "
                "company than alone; plan with objective 'member'"
            )
        found = choose_for_system(choose, gain, len(members))
        chosen = found.members
        master_alone = float(weights.solo[route].sum())
        cost, bound = found.cost + master_alone, found.bound + master_alone
        gap = (cost - bound) / cost if cost else 0.0
        if gap > 1e-9:
            proof = {**proof, "kind": "bound", "bound": bound, "gap": gap}
    vehicles = _member_vehicles(task, case, router, route, members, chosen)
    return JointPlan(
        vehicles=vehicles,
        case=case,
        asked=task.asked,
        objective=task.objective,
        method=method,
        unit=weights.unit,
        params=dict(weights.params),
        network=identity_of(net),
        proof=proof,
        remarks=_remarks(net, vehicles),
        version=__version__,
    )


def _astar_costs(
    router: AstarRouter, nodes: Edges, origins: Edges, destinations: Edges
) -> tuple[NDArray[np.float64], NDArray[np.float64], NDArray[np.float64]]:
    shape = (len(origins), len(nodes))
    entry = [router.cost(o, r) for o in origins for r in nodes]
    leave = [router.cost(r, g) for g in destinations for r in nodes]
    solo = [router.cost(o, g) for o, g in zip(origins, destinations, strict=True)]
    return np.reshape(entry, shape), np.reshape(leave, shape), np.array(solo, np.float64)


def _member_vehicles(
    task: _Task, case: str, router: Router, route: Edges, members: list[TripEnds],
    chosen: MemberPlans,
) -> tuple[VehiclePlan, ...]:  # fmt: skip
    net, weights = task.net, task.weights
    leader = task.ends[task.master]
    present: list[set[str]] = [set() for _ in route]
    for k, item in enumerate(members):
        if chosen.merge_index[k] >= 0:
            for at in range(chosen.merge_index[k], chosen.separation_index[k]):
                present[at].add(item.vehicle)
    everyone = tuple(frozenset(names) for names in present)
    plans = {
        leader.vehicle: vehicle_plan(
            net, weights, leader, route, Journey(NO_EDGES, route, NO_EDGES, everyone, True),
            "master",
        )
    }  # fmt: skip
    for k, item in enumerate(members):
        alone = router.route(item.origin, item.destination)
        i, j = int(chosen.merge_index[k]), int(chosen.separation_index[k])
        if i < 0:
            plans[item.vehicle] = vehicle_plan(
                net, weights, item, alone, Journey(alone, NO_EDGES, NO_EDGES, ()), "alone",
                _why_alone(case, bool(chosen.applicable[k]), leader.vehicle),
            )  # fmt: skip
            continue
        partners = tuple(names - {item.vehicle} | {leader.vehicle} for names in everyone[i:j])
        journey = Journey(
            router.route(item.origin, int(chosen.merge[k])),
            route[i:j],
            router.route(int(chosen.separation[k]), item.destination, backward=True),
            partners,
        )
        plans[item.vehicle] = vehicle_plan(net, weights, item, alone, journey, "member")
    return tuple(plans[item.vehicle] for item in task.ends)


def _why_alone(case: str, applicable: bool, master: str) -> str:
    if applicable:
        return f"driving alone costs less than any way with {master}"
    end = "destination" if case == "A" else "origin"
    return f"case {case} does not apply: its {end} is not on the route of {master}"


def _pair_plan(task: _Task, router: DijkstraRouter) -> JointPlan:
    net, weights = task.net, task.weights
    first, second = task.master, 1 - task.master
    both = task.ends[first], task.ends[second]
    pair = plan_pair(
        net, weights, (both[0].origin, both[1].origin), (both[0].destination, both[1].destination)
    )
    vehicles = {}
    for k, item in enumerate(both):
        partner = frozenset({both[1 - k].vehicle})
        journey = Journey(
            pair.before[k], pair.shared, pair.after[k], (partner,) * len(pair.shared), k == 0
        )
        together = len(pair.shared) > 0
        reason = "" if together else _why_alone("D", True, both[1 - k].vehicle)
        vehicles[item.vehicle] = vehicle_plan(
            net, weights, item, router.route(item.origin, item.destination), journey,
            "member" if together else "alone", reason,
        )  # fmt: skip
    ordered = tuple(vehicles[item.vehicle] for item in task.ends)
    return JointPlan(
        vehicles=ordered,
        case="D",
        asked=task.asked,
        objective="system",
        method="dijkstra",
        unit=weights.unit,
        params=dict(weights.params),
        network=identity_of(net),
        proof={"kind": "exact", "conditions": [WAITING_FREE, ALIKE, ONE_STRETCH]},
        remarks=_remarks(net, ordered),
        version=__version__,
    )


def _remarks(net: RoadNetwork, vehicles: Sequence[VehiclePlan]) -> tuple[str, ...]:
    remarks = []
    for vehicle in vehicles:
        inferred = sum(leg.inferred_m for leg in vehicle.legs)
        if inferred:
            count = int(net.inferred[list(vehicle.edges)].sum())
            remarks.append(
                f"{vehicle.vehicle} drives {inferred / 1000:.1f} km over {count} connectors that "
                "were inferred, not mapped; check them before driving"
            )
    return tuple(remarks)
