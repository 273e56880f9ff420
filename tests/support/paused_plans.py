"""Timed plans whose vehicles stand on their way: for breaks, rests, bans and changes of drivers.

Each pause names a stretch, how far along it lies, how long it lasts, what for and where. The plan
is cut there, within an edge too, and all that comes later moves.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace

import numpy as np
from plan_kinds import SIX, plan_kind, timed
from po_valley import THREE, make_plan, po_valley

from platoon_osm.driving.state import RESTED, DriverState
from platoon_osm.network.road_network import RoadNetwork
from platoon_osm.planning.timing.stops import cut_plan
from platoon_osm.plans.pauses import DriverDay, Pause, PausePlace
from platoon_osm.plans.plan import Plan

MIN, H = 60.0, 3600.0


@dataclass(frozen=True)
class Stop:
    """A pause of all who drive a stretch, after a share of its length."""

    stretch: int
    share: float
    lasts_s: float
    purposes: tuple[str, ...] = ("break",)
    name: str = "Secchia Ovest"
    kind: str = "services"
    beside_m: float = 1200.0
    capacity: int | None = None
    nowhere: bool = False


def paused(
    plan: Plan, net: RoadNetwork, stops: Sequence[Stop], *, rules: str = "eu561",
    drivers: Callable[[int, int], tuple[DriverDay, ...]] | None = None,
) -> Plan:  # fmt: skip
    """Return a timed plan with pauses; `drivers` takes first leg after a pause, and legs."""
    assert plan.timetable is not None
    cuts = {k: [] for k in range(len(plan.stretches))}
    wanted: dict[tuple[int, int, float], Stop] = {}
    for stop in stops:
        place = _place(net, plan.stretches[stop.stretch].edges, stop.share)
        cuts[stop.stretch].append(place)
        wanted[stop.stretch, *place] = stop
    made = cut_plan(net, replace(plan, timetable=None), cuts)
    # The pieces of a stretch follow one another, in order of its cuts.
    after: dict[int, tuple[Stop, int, float]] = {}
    first = 0
    for k in range(len(plan.stretches)):
        for number, place in enumerate(sorted(cuts[k]), 1):
            edge = plan.stretches[k].edges[place[0]]
            after[first + number] = wanted[k, *place], edge, place[1]
        first += 1 + len(cuts[k])
    ready = [times.departure_s for times in plan.timetable.vehicles]
    legs: list[list[tuple[float, float]]] = [[] for _ in ready]
    pauses: list[list[Pause]] = [[] for _ in ready]
    begins: dict[int, float] = {}
    while any(len(legs[k]) < len(way) for k, way in enumerate(made.ways)):
        for k, stretch in enumerate(made.stretches):
            who = stretch.company
            if k in begins or any(made.ways[i].index(k) != len(legs[i]) for i in who):
                continue
            stop, edge, share = after.get(k, (None, 0, 0.0))
            begins[k] = max(ready[i] for i in who) + (stop.lasts_s if stop else 0.0)
            for i in who:
                if stop:
                    place = None if stop.nowhere else _stands(net, stop, edge, share)
                    pauses[i].append(Pause(len(legs[i]), stop.purposes, ready[i], begins[k], place))
                ready[i] = begins[k] + stretch.drive_s
                legs[i].append((begins[k], ready[i]))
    vehicles = tuple(
        replace(
            times,
            legs=tuple(legs[i]),
            pauses=tuple(pauses[i]),
            latest_arrival_s=None,
            drivers=(DriverDay(RESTED, 0.0),)
            if drivers is None
            else drivers(pauses[i][0].before if pauses[i] else 0, len(legs[i])),
        )
        for i, times in enumerate(plan.timetable.vehicles)
    )
    table = replace(plan.timetable, vehicles=vehicles, rules=rules, feasible=True)
    return replace(made, timetable=table)


def _place(net: RoadNetwork, edges: Sequence[int], share: float) -> tuple[int, float]:
    lengths = net.length_m[list(edges)]
    at, begins = share * lengths.sum(), np.cumsum(lengths) - lengths
    edge = int(np.searchsorted(begins, at, "right")) - 1
    return edge, float((at - begins[edge]) / lengths[edge])


def _stands(net: RoadNetwork, stop: Stop, edge: int, share: float) -> PausePlace:
    (lon, lat), (to_lon, to_lat) = net.path_shape([edge])[[0, -1]].tolist()
    lon, lat = lon + share * (to_lon - lon), lat + share * (to_lat - lat) + 0.002
    return PausePlace(stop.name, stop.kind, lon, lat, stop.beside_m, stop.capacity)


def longest_together(plan: Plan) -> int:
    """Return the longest stretch that is driven in company."""
    some = [k for k, one in enumerate(plan.stretches) if one.together]
    return max(some, key=lambda k: plan.stretches[k].length_m)


def day_with_breaks(name: Callable[[str], str] | None = None) -> tuple[Plan, RoadNetwork]:
    """Three vehicles: a break together, one in two parts, a ban, a stop where no parking is known.

    `name` spoils every name of a place, a road or a vehicle.
    """
    if name is None:
        plan, net = plan_kind("three vehicles")
    else:
        net = po_valley(name)
        plan = timed(make_plan(net, THREE, name))
    stops = stops_of_a_day(plan, name or str)
    return paused(plan, net, stops), net


def stops_of_a_day(plan: Plan, name: Callable[[str], str] = str) -> list[Stop]:
    """Return pauses of each kind but a rest and a change."""
    together, last = longest_together(plan), plan.ways[0][-1]
    return [
        Stop(together, 0.37, 45 * MIN, ("break", "company"), name("Secchia Ovest"), capacity=40),
        Stop(last, 0.2, 15 * MIN, ("first_part",), name(""), "rest_area"),
        Stop(last, 0.5, 30 * MIN, ("second_part",), name("Uscita 7"), "junction", 0.0),
        Stop(last, 0.8, 90 * MIN, ("ban",), nowhere=True),
    ]


def night(zone: str = "") -> tuple[Plan, RoadNetwork]:
    """A daily rest across midnight, and a change of drivers before it."""
    plan, net = plan_kind("three vehicles")
    assert plan.timetable is not None
    late = f"{SIX.replace(hour=17).isoformat()}{zone}"
    plan = replace(plan, timetable=replace(plan.timetable, start=late))
    together, last = longest_together(plan), plan.ways[0][-1]
    stops = [
        Stop(together, 0.3, 5 * MIN, ("change",), "Limenella", "truck_parking", 20.0),
        Stop(last, 0.5, 11 * H, ("daily_rest",), "Duino Sud", "rest_area", 0.0),
    ]

    def two(change: int, legs: int) -> tuple[DriverDay, ...]:
        state, second = DriverState(drivers=2), range(change, legs)
        first = tuple(leg for leg in range(legs) if leg not in second)
        return DriverDay(state, 0.0, first), DriverDay(state, 0.0, tuple(second))

    return paused(plan, net, stops, drivers=two), net
