"""One run of a study: one draw, searched once, answered for the whole grid."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ..costs.fatigue import fatigue_heuristic
from ..network.geodesy import distance_m
from ..planning.master import longest_route
from ..planning.routers import AstarRouter, Method
from ..search.dijkstra import ReferenceEngine
from .grid import best_on_grid, shared_metres
from .random_network import Draw
from .readings import Factors
from .settings import Study

__all__ = [
    "DRIVES_AFTER", "DRIVES_BEFORE", "JOINED", "MASTER_GOES_ON", "MASTER_UNDERWAY", "Solo",
    "plan_draw", "run_once",
    "solo_searches",
]  # fmt: skip

Floats = NDArray[np.float64]
Index = NDArray[np.int64]
Arrays = dict[str, NDArray[np.generic]]

# Bits of `how`: what a member's best plan is like.
JOINED = 1
DRIVES_BEFORE = 2
"""It drives roads alone before it merges; access edges do not count."""
DRIVES_AFTER = 4
"""It drives roads alone after it separates."""
MASTER_UNDERWAY = 8
"""The master has driven roads before the merging point."""
MASTER_GOES_ON = 16
"""The master drives on after the separation point."""


@dataclass(frozen=True, slots=True, eq=False)
class Solo:
    """What one method finds out about a draw: none of it depends on (tau, xi).

    Attributes
    ----------
    route : ndarray of int, (K,)
        Edges of the master's route.
    entry, leave : ndarray of float, (N, K + 1)
        Costs alone of the N members to and from the route's nodes.
    cost : ndarray of float, (V,)
        Costs alone of all vehicles.
    """

    route: Index
    entry: Floats
    leave: Floats
    cost: Floats


def run_once(study: Study, factors: Factors, seed: np.random.SeedSequence) -> Arrays:
    """Draw a network and plan its vehicles for every method, reading and grid point.

    Parameters
    ----------
    study : Study
        M methods.
    factors : Factors
        F different ones, `study.factors()`.
    seed : numpy.random.SeedSequence
        Of this run.

    Returns
    -------
    dict of ndarray
        V vehicles; see `StudyResult`, whose arrays these are without their first axis.
    """
    return plan_draw(study, factors, study.network.draw(np.random.default_rng(seed)))


def plan_draw(study: Study, factors: Factors, draw: Draw) -> Arrays:
    """Plan the vehicles of a draw for every method, reading and grid point.

    Parameters
    ----------
    study : Study
        M methods.
    factors : Factors
        F different ones, `study.factors()`.
    draw : Draw
        A network with trips.

    Returns
    -------
    dict of ndarray
        As `run_once`.
    """
    weight = draw.net.length_m * study.alone_factor
    engine = ReferenceEngine(draw.net, weight)
    forward = engine.distances(draw.origins)
    vehicles = len(draw.origins)
    optimum = forward[np.arange(vehicles), draw.destinations]
    master = longest_route(optimum / study.alone_factor)
    shape = (len(study.methods), vehicles, len(factors.different))
    out: Arrays = {
        "master": np.array(master, np.int32),
        "optimum": optimum,
        "solo_cost": np.empty(shape[:2]),
        "joint_cost": np.empty(shape),
        "platoon_m": np.zeros(shape),
        "merge": np.full(shape, -1, np.int32),
        "separation": np.full(shape, -1, np.int32),
        "how": np.zeros(shape, np.uint8),
        "applicable": np.ones(shape[:2], bool),
        "redraws": np.array([draw.unconnected, draw.impossible], np.int32),
        "overestimate": _overestimate(study, draw, optimum, master),
    }
    for k, method in enumerate(study.methods):
        solo = solo_searches(study, draw, engine, forward, master, method)
        _fill(out, k, study, draw, solo, master, factors.different)
    return out


def solo_searches(
    study: Study, draw: Draw, engine: ReferenceEngine, forward: Floats, master: int, method: Method
) -> Solo:
    """Find the master's route and the members' costs to and from it, by one of the methods.

    Parameters
    ----------
    study : Study
        For its costs.
    draw : Draw
        A network of n nodes, with the trips of V vehicles.
    engine : ReferenceEngine
        Under the weight alone.
    forward : ndarray of float, (V, n)
        Least costs from each origin.
    master : int
        Which vehicle keeps its route.
    method : {"dijkstra", "astar", "astar-closed-once"}
        How routes are found.

    Returns
    -------
    Solo
        The route and the costs.
    """
    net, origins, destinations = draw.net, draw.origins, draw.destinations
    others = np.delete(np.arange(len(origins)), master)
    optimum = forward[np.arange(len(origins)), destinations]
    if method == "dijkstra":
        route = engine.tree(origins[master]).path(destinations[master])
        nodes = net.path_nodes(route)
        leave = engine.distances(destinations[others], forward=False)[:, nodes]
        return Solo(route, forward[np.ix_(others, nodes)], leave, optimum)
    weight = net.length_m * study.alone_factor
    speed = study.costs.speed_kmh / 3.6
    router = AstarRouter(net, weight, float(optimum[master]), speed, method)
    route = router.route(int(origins[master]), int(destinations[master]))
    nodes = net.path_nodes(route)
    entry = [[router.cost(o, r) for r in nodes] for o in origins[others]]
    from_route = [[router.cost(r, g) for r in nodes] for g in destinations[others]]
    cost = [router.cost(o, g) for o, g in zip(origins, destinations, strict=True)]
    return Solo(route, np.array(entry), np.array(from_route), np.array(cost))


def _fill(
    out: Arrays, k: int, study: Study, draw: Draw, solo: Solo, master: int, factors: Floats
) -> None:
    """Answer the grid for one method and put it into its place of all arrays."""
    net, per_metre = draw.net, study.alone_factor
    others = np.delete(np.arange(len(draw.origins)), master)
    nodes = net.path_nodes(solo.route)
    length = np.concatenate([[0.0], np.cumsum(net.length_m[solo.route])])
    entry, leave = solo.entry, solo.leave
    if study.case == "A":
        leave = np.where(nodes == draw.destinations[others, None], leave, np.inf)
        out["applicable"][k, others] = np.isfinite(leave).any(axis=1)
    elif study.case == "B":
        entry = np.where(nodes == draw.origins[others, None], entry, np.inf)
        out["applicable"][k, others] = np.isfinite(entry).any(axis=1)
    i, j, cost = best_on_grid(entry, leave, solo.cost[others], length, factors)
    joined = i >= 0
    row = np.arange(len(others))[:, None]
    # By access edges alone: entering there is not driving roads.
    straight = _access_costs(draw, others, per_metre)[:, nodes]
    to_merge, from_there = entry[row, i], leave[row, j]
    direct = straight[row, i]
    by_access = (to_merge >= direct * (1 - 1e-9)) & (to_merge <= direct * (1 + 1e-9))
    first_road = int(draw.access[solo.route[:1]].sum())
    how = joined * (
        JOINED
        + DRIVES_BEFORE * ((to_merge > 0) & ~by_access)
        + DRIVES_AFTER * (from_there > 0)
        + MASTER_UNDERWAY * (i > first_road)
        + MASTER_GOES_ON * (j < len(solo.route))
    )
    shared = shared_metres(i, j, length)
    out["solo_cost"][k] = solo.cost
    for name, members, of_master in (
        ("joint_cost", cost, solo.cost[master] - (per_metre - factors) * shared),
        ("platoon_m", np.where(joined, length[j] - length[i], 0.0), shared),
        ("merge", np.where(joined, nodes[i], -1), -1),
        ("separation", np.where(joined, nodes[j], -1), -1),
        ("how", how, np.where(shared > 0, JOINED, 0)),
    ):
        out[name][k][others] = members
        out[name][k][master] = of_master


def _access_costs(draw: Draw, vehicles: Index, solo_factor: float) -> Floats:
    """Return what each vehicle pays to a node by one access edge; inf if none leads there."""
    net = draw.net
    row = np.full(net.n, -1, np.int64)
    row[draw.origins[vehicles]] = np.arange(len(vehicles))
    direct = np.full((len(vehicles), net.n), np.inf)
    edges = np.flatnonzero(draw.access & (row[net.tail] >= 0))
    direct[row[net.tail[edges]], net.head[edges]] = net.length_m[edges] * solo_factor
    return direct


def _overestimate(study: Study, draw: Draw, optimum: Floats, master: int) -> Floats:
    """Return the A* heuristic at each origin over the least cost that remains from there (V,)."""
    net, start, end = draw.net, draw.origins, draw.destinations
    away = distance_m(net.lon[start], net.lat[start], net.lon[end], net.lat[end])
    speed = study.costs.speed_kmh / 3.6
    return fatigue_heuristic(away, float(optimum[master]), speed) / optimum
