"""One road of a fleet's plan, and who drives it when: the numbers of a time-distance diagram.

A corridor is a chain of edges. By default it is the busiest: each of the edges with most
vehicle-kilometres is made longer at both ends, each time by the edge from or to which most vehicles
come or go on, as long as these are at least `GOES_ON` of its own; of these roads the one with most
vehicle-kilometres is taken. A stretch is drawn where it runs along it, at its mean speed.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ...errors import ScenarioError, brief
from ...network.road_network import RoadNetwork
from ...plans.plan import Plan
from ...shown_text import fitted, shown

__all__ = ["Corridor", "Ends", "Run", "corridor_of"]

GOES_ON = 0.4
LONGEST_M = 600_000.0
SEEDS = 40

Ints = NDArray[np.int64]
Ends = tuple[int | str, int | str]
"""From where to where: nodes, or names of places."""


@dataclass(frozen=True, slots=True)
class Run:
    """A stretch where it runs along a corridor.

    Attributes
    ----------
    vehicles : int
        How many drive it together.
    begin_m, end_m : float
        From where to where on the corridor [m].
    begin_s, end_s : float
        From when to when on the clock of the plan [s].
    """

    vehicles: int
    begin_m: float
    end_m: float
    begin_s: float
    end_s: float


@dataclass(frozen=True, slots=True)
class Corridor:
    """A road, and all that drive it.

    Attributes
    ----------
    length_m : float
        Of the road [m].
    places : tuple of (float, str)
        Where on it what is [m]; its ends are among them.
    runs : tuple of Run
        Of all stretches along it.
    vehicles : int
        How many drive any of it.
    """

    length_m: float
    places: tuple[tuple[float, str], ...]
    runs: tuple[Run, ...]
    vehicles: int


def corridor_of(plan: Plan, net: RoadNetwork, ends: Ends | None = None) -> Corridor | None:
    """Return a corridor of a plan.

    Parameters
    ----------
    plan : Plan
        Laid out in whole edges of `net`.
    net : RoadNetwork
        Its network.
    ends : tuple of int or str, (2,), or None
        Nodes, or names of places, from where to where; by default the busiest road.

    Returns
    -------
    Corridor or None
        None for a plan without times.

    Raises
    ------
    ScenarioError
        Ends between which nobody drives.
    """
    if plan.timetable is None:
        return None
    routes = _routes(plan)
    road = _busiest(routes, net) if ends is None else _between(plan, routes, net, ends)
    begins = np.concatenate([[0.0], np.cumsum(net.length_m[road])])
    nodes = np.append(net.tail[road], net.head[road[-1:]])
    on_road = set(road.tolist())
    return Corridor(
        length_m=float(begins[-1]),
        places=tuple(
            (float(at), fitted(net.place_name(int(node))))
            for at, node in zip(begins, nodes, strict=True)
        ),
        runs=_runs(plan, net, road, begins),
        vehicles=sum(not on_road.isdisjoint(route.tolist()) for route in routes),
    )


def _routes(plan: Plan) -> list[Ints]:
    return [
        np.array([e for k in way for e in plan.stretches[k].edges], np.int64) for way in plan.ways
    ]


def _busiest(routes: Sequence[Ints], net: RoadNetwork) -> Ints:
    every = np.concatenate(routes)
    owner = np.repeat(np.arange(len(routes)), [len(route) for route in routes])
    count = np.bincount(every, minlength=net.m)
    goes_on = owner[1:] == owner[:-1]
    pairs, times = np.unique(
        np.stack([every[:-1][goes_on], every[1:][goes_on]]), axis=1, return_counts=True
    )
    seeds = np.argsort(-count * net.length_m, kind="stable")[:SEEDS]
    roads = [_longer(int(seed), count, pairs, times, net) for seed in seeds if count[seed]]
    return max(roads, key=lambda road: float((count[road] * net.length_m[road]).sum()))


def _longer(seed: int, count: Ints, pairs: Ints, times: Ints, net: RoadNetwork) -> Ints:
    """Return the road on which most vehicles of an edge come and go on."""
    least = GOES_ON * count[seed]
    road, length = [seed], float(net.length_m[seed])
    for own, other, at in ((0, 1, -1), (1, 0, 0)):
        while True:
            steps = np.flatnonzero(pairs[own] == road[at])
            if not len(steps):
                break
            step = steps[np.argmax(times[steps])]
            edge = int(pairs[other, step])
            longer = length + float(net.length_m[edge])
            if times[step] < least or edge in road or longer > LONGEST_M:
                break
            length = longer
            road.insert(len(road) if at else 0, edge)
    return np.array(road, np.int64)


def _between(plan: Plan, routes: Sequence[Ints], net: RoadNetwork, ends: Ends) -> Ints:
    """Return the road between two places that most vehicles drive."""
    if not isinstance(ends, tuple | list) or len(ends) != 2:
        raise ScenarioError(f"corridor {brief(ends)} must be two places, such as (from, to)")
    begin, end = (_nodes(plan, routes, net, one) for one in ends)
    found: Counter[tuple[int, ...]] = Counter()
    for route in routes:
        starts = np.flatnonzero(np.isin(net.tail[route], list(begin)))
        stops = np.flatnonzero(np.isin(net.head[route], list(end)))
        if len(starts) and len(stops) and starts[0] <= stops[-1]:
            found[tuple(route[starts[0] : stops[-1] + 1].tolist())] += 1
    if not found:
        raise ScenarioError(
            f"corridor: nobody drives from {brief(ends[0])} to {brief(ends[1])}; "
            "name two places on one route, as the plan calls them"
        )
    return np.array(max(found, key=lambda road: (found[road], len(road))), np.int64)


def _nodes(plan: Plan, routes: Sequence[Ints], net: RoadNetwork, place: int | str) -> set[int]:
    if isinstance(place, int) and not isinstance(place, bool):
        return {place}
    wanted = shown(place).casefold()
    found = {
        stop.node
        for trip in plan.trips
        for stop in (trip.origin, trip.destination)
        if stop.node >= 0 and shown(stop.name).casefold() == wanted
    }
    if not found:
        used = np.unique(net.tail[np.unique(np.concatenate(routes))]).tolist()
        found = {node for node in used if shown(net.place_name(node)).casefold() == wanted}
    return found


def _runs(plan: Plan, net: RoadNetwork, road: Ints, begins: NDArray[np.float64]) -> tuple[Run, ...]:
    place = np.full(net.m, -1, np.int64)
    place[road] = np.arange(len(road))
    spans = {
        k: span
        for way, times in zip(plan.ways, plan.times, strict=True)
        if times is not None
        for k, span in zip(way, times.legs, strict=True)
    }
    found: list[Run] = []
    for k, stretch in enumerate(plan.stretches):
        edges = np.array(stretch.edges, np.int64)
        at = place[edges]
        here = np.flatnonzero(at >= 0)
        if not len(here):
            continue
        metres = np.concatenate([[0.0], np.cumsum(net.length_m[edges])])
        begin_s, end_s = spans[k]
        pace = (end_s - begin_s) / metres[-1] if metres[-1] else 0.0
        for part in np.split(here, np.flatnonzero(np.diff(at[here]) != 1) + 1):
            first, last = int(part[0]), int(part[-1])
            found.append(
                Run(
                    len(stretch.vehicles),
                    float(begins[at[first]]),
                    float(begins[at[last] + 1]),
                    begin_s + pace * float(metres[first]),
                    begin_s + pace * float(metres[last + 1]),
                )
            )
    return tuple(found)
