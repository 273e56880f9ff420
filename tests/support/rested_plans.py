"""Timed plans whose vehicles stand for a while on their way: breaks, rests, bans and changes.

A row names a stretch of a plan, a share of its length, how long its vehicles stand there, what for
and where. The plan is cut there, within an edge too, and all later times move by what they must.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from datetime import datetime
from functools import cache
from importlib import resources
from itertools import pairwise

import numpy as np
from bundled import italy

from platoon_osm.costs.paper import PaperCosts
from platoon_osm.costs.share import Share
from platoon_osm.driving.state import RESTED, DriverState
from platoon_osm.network.road_network import RoadNetwork
from platoon_osm.network.stops import stops_along
from platoon_osm.planning.joint import plan_joint
from platoon_osm.planning.scenario import read_scenario
from platoon_osm.plans.pauses import DriverDay, Pause, PausePlace
from platoon_osm.plans.plan import Plan
from platoon_osm.plans.records import Stretch
from platoon_osm.plans.timetable import Timetable
from platoon_osm.plans.trip import Trip

MIN, H = 60.0, 3600.0
Pauses = dict[int, tuple[tuple[str, ...], float, PausePlace | None]]
"""By new stretch: why its vehicles stand before it, how long, and where."""


@dataclass(frozen=True)
class Halt:
    """Vehicles stand for a while somewhere on a stretch; None is the stop nearest to there."""

    stretch: int
    share: float
    stands_s: float
    purposes: tuple[str, ...] = ("break",)
    place: PausePlace | None = None
    junction: bool = False


def with_halts(
    plan: Plan, net: RoadNetwork, halts: Sequence[Halt], rules: str = "eu561",
    states: dict[int, DriverState] | None = None,
) -> Plan:  # fmt: skip
    """Return a timed plan whose vehicles stand where `halts` say."""
    stretches: list[Stretch] = []
    pieces: list[range] = []
    stands: Pauses = {}
    for number, stretch in enumerate(plan.stretches):
        here = sorted((one for one in halts if one.stretch == number), key=lambda one: one.share)
        first = len(stretches)
        cuts = []
        for one in here:
            edge, share, place = _cut(net, stretch, one)
            cuts.append((edge, share))
            stands[first + len(cuts)] = (one.purposes, one.stands_s, one.place or place)
        stretches += _cut_up(net, stretch, cuts)
        pieces.append(range(first, len(stretches)))
    ways = tuple(tuple(piece for k in way for piece in pieces[k]) for way in plan.ways)
    events = tuple(
        replace(event, stretch=pieces[event.stretch][0 if event.kind == "merge" else -1])
        for event in plan.events
    )
    made = replace(plan, stretches=tuple(stretches), ways=ways, events=events, timetable=None)
    assert plan.timetable is not None
    return _timed(made, plan.timetable, stands, rules, states or {})


def _cut(net: RoadNetwork, stretch: Stretch, halt: Halt) -> tuple[int, float, PausePlace]:
    """Return before which place on which edge a stretch is cut, and what is there."""
    at_m = halt.share * stretch.length_m
    if not halt.junction:
        passed = [
            one
            for one in stops_along(net, stretch.edges, stretch.span)
            if "parking" in one.stop.offers or one.stop.kind in ("services", "rest_area")
        ]
        one = min(passed, key=lambda near: abs(near.at_m - at_m))
        stop = one.stop
        place = PausePlace(
            stop.name, stop.kind, stop.lon, stop.lat, one.access.beside_m, stop.capacity
        )
        return one.place, one.access.share, place
    reached = np.cumsum(net.length_m[list(stretch.edges)])
    edge = min(int(np.searchsorted(reached, at_m)) + 1, len(stretch.edges) - 1)
    node = int(net.tail[stretch.edges[edge]])
    place = PausePlace(net.place_name(node), "junction", float(net.lon[node]), float(net.lat[node]))
    return edge, 0.0, place


def _cut_up(net: RoadNetwork, stretch: Stretch, cuts: Sequence[tuple[int, float]]) -> list[Stretch]:
    """Return a stretch in pieces, each cut before a place and a share of its edge."""
    edges = stretch.edges
    last = (len(edges) - 1, stretch.span[1])
    bounds = [(0, stretch.span[0]), *cuts, last]
    lengths = []
    for (i, a), (j, b) in pairwise(bounds):
        metres = net.length_m[list(edges[i : j + 1])].tolist()
        lengths.append(sum(metres) - a * metres[0] - (1 - b) * metres[-1])
    found = []
    for (i, a), (j, b), metres in zip(bounds, bounds[1:], lengths, strict=False):
        of = metres / sum(lengths)
        end, upto = (j, 1.0) if b == 0.0 and j > i else (j + 1, b)
        found.append(
            replace(
                stretch,
                edges=edges[i:end],
                span=(a, upto),
                length_m=stretch.length_m * of,
                drive_s=stretch.drive_s * of,
                inferred_m=stretch.inferred_m * of,
                shares=tuple(_part(share, of) for share in stretch.shares),
            )
        )
    return found


def _part(share: Share, of: float) -> Share:
    return Share(
        share.cost * of,
        None if share.alone_cost is None else share.alone_cost * of,
        share.fuel_l * of,
        share.alone_fuel_l * of,
        None if share.money is None else share.money * of,
    )


def _timed(
    plan: Plan, table: Timetable, stands: Pauses, rules: str, states: dict[int, DriverState]
) -> Plan:
    ready = [times.legs[0][0] for times in table.vehicles]
    pauses: list[list[Pause]] = [[] for _ in ready]
    legs: list[list[tuple[float, float]]] = [[] for _ in ready]
    # Stretches in an order in which each comes after those that its vehicles drive before it.
    left = [list(way) for way in plan.ways]
    while any(left):
        stretch = next(
            k
            for way in left
            if way
            for k in way[:1]
            if all(left[who][:1] == [k] for who in plan.stretches[k].company)
        )
        company = plan.stretches[stretch].company
        purposes, stands_s, place = stands.get(stretch, ((), 0.0, None))
        begins = max(ready[who] for who in company) + stands_s
        for who in company:
            if purposes:
                start = ready[who]
                pause = Pause(len(legs[who]), purposes, start, begins, place)
                pauses[who].append(pause)
            ready[who] = begins + plan.stretches[stretch].drive_s
            legs[who].append((begins, ready[who]))
            left[who].pop(0)
    vehicles = tuple(
        replace(
            times,
            legs=tuple(legs[who]),
            pauses=tuple(pauses[who]),
            drivers=(DriverDay(states.get(who, RESTED), times.earliest_departure_s or 0.0),),
            latest_arrival_s=None
            if times.latest_arrival_s is None
            else max(times.latest_arrival_s, legs[who][-1][1] + 600),
        )
        for who, times in enumerate(table.vehicles)
    )
    return replace(plan, timetable=replace(table, vehicles=vehicles, rules=rules, feasible=True))


def _longest(plan: Plan) -> int:
    """The longest stretch that is driven in company."""
    together = [k for k, stretch in enumerate(plan.stretches) if stretch.together]
    return max(together, key=lambda k: plan.stretches[k].length_m)


@cache
def corridor() -> Plan:
    """The plan of the demo, without driving rules."""
    path = resources.files("platoon_osm.scenarios") / "po-valley-c.toml"
    with resources.as_file(path) as file:
        return read_scenario(file).plan(italy())


@cache
def corridor_with_breaks() -> tuple[Plan, RoadNetwork]:
    """The demo with breaks: of two together, of one alone at a junction, and one in two parts."""
    plan, net = corridor(), italy()
    longest = _longest(plan)
    last = {name: way[-1] for name, way in zip("ABC", plan.ways, strict=True)}
    halts = [
        Halt(longest, 0.7, 45 * MIN),
        Halt(last["A"], 0.5, 15 * MIN, ("first_part",), junction=True),
        Halt(last["C"], 0.3, 30 * MIN, ("break", "company")),
        Halt(last["C"], 0.6, 90 * MIN, ("ban",)),
    ]
    return with_halts(plan, net, halts, states={1: DriverState(driven_today_s=2 * H)}), net


@cache
def two_days() -> tuple[Plan, RoadNetwork]:
    """Two vehicles down the length of Italy, with breaks and a night."""
    net = italy()
    six = datetime(2026, 3, 2, 6)
    trips = [
        Trip("A", net.locate("Milano"), net.locate("Reggio Calabria"), six),
        Trip("B", net.locate("Venezia"), net.locate("Napoli"), six),
    ]
    plan = plan_joint(net, PaperCosts(tau=1.0, xi=0.18), trips, case="C")
    longest = _longest(plan)
    last = plan.ways[0][-1]
    halts = [
        Halt(longest, 0.45, 45 * MIN),
        Halt(longest, 0.95, 11 * H, ("daily_rest",)),
        Halt(last, 0.5, 45 * MIN),
    ]
    return with_halts(plan, net, halts), net
