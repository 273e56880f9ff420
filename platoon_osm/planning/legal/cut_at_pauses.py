"""A plan cut where its vehicles stand, and what is settled of their days.

A search tells where each vehicle stands by the points of its way. Here those points become places
on the stretches of the written plan, the stretches are cut there, and each pause becomes a stand
before a leg: what the timetable's programme needs.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from ...driving.limits import Limits
from ...network.placed import PlacedNetwork, network_below
from ...network.road_network import RoadNetwork
from ...plans.pauses import PURPOSES, DriverDay
from ...plans.plan import Plan
from ...plans.stretches import Run
from ..timing.days import Day, Duty, Stand
from ..timing.stops import Place, cut_plan
from ..writing import driven_runs
from .driver.road import LegalTrip, PlannedPause
from .platoon.star_times import VehicleRules
from .way_points import WayPoints

__all__ = ["CutPlan", "Driven", "plan_with_days"]

Edges = NDArray[np.int64]

REST = ("daily_rest", "reduced_daily_rest", "weekly_rest")


@dataclass(frozen=True, slots=True, eq=False)
class Driven:
    """What a vehicle drives, and when it stands.

    Attributes
    ----------
    way : WayPoints
        Its way, on the network with places.
    trip : LegalTrip
        Its times.
    rules : VehicleRules
        By which it drives.
    """

    way: WayPoints
    trip: LegalTrip
    rules: VehicleRules


@dataclass(frozen=True, slots=True, eq=False)
class CutPlan:
    """A plan cut at its pauses.

    Attributes
    ----------
    plan : Plan
        Without times.
    days : tuple of Day, (N,)
        Where each vehicle stands before which leg, and which duty periods are limited.
    points : tuple of tuple of int, (N, ...)
        The point of its way at which each leg of a vehicle begins.
    """

    plan: Plan
    days: tuple[Day, ...]
    points: tuple[tuple[int, ...], ...]


def plan_with_days(
    plan: Plan, net: RoadNetwork, routes: Sequence[Sequence[Run]], driven: Sequence[Driven]
) -> CutPlan:
    """Return a plan cut at its pauses, and the days of its vehicles.

    Parameters
    ----------
    plan : Plan
        Without times.
    net : RoadNetwork
        The network with the places of its trips.
    routes : sequence of sequence of Run, (N, ...)
        What it was written from.
    driven : sequence of Driven, (N,)
        The times of each vehicle.

    Returns
    -------
    CutPlan
        The same journeys.
    """
    runs, ways = driven_runs(net, routes)
    located = [
        [_located(net, runs, way, one.way, pause.point) for pause in _told(one.trip)]
        for way, one in zip(ways, driven, strict=True)
    ]
    cuts: dict[int, set[Place]] = {}
    for way, own in zip(ways, located, strict=True):
        for leg, place in own:
            if place is not None:
                cuts.setdefault(way[leg], set()).add(place)
    ordered = {k: sorted(some) for k, some in cuts.items()}
    whole = cut_plan(network_below(net), plan, ordered)
    days, points = [], []
    for way, own, one in zip(ways, located, driven, strict=True):
        first = np.cumsum([0, *(1 + len(ordered.get(k, ())) for k in way)]).tolist()
        legs = [
            first[leg] + (0 if place is None else 1 + ordered[way[leg]].index(place))
            for leg, place in own
        ]
        begins = _begins(net, runs, way, one, ordered)
        points.append(begins)
        days.append(_day(one, legs, first[-1], begins))
    return CutPlan(whole, tuple(days), tuple(points))


def _told(trip: LegalTrip) -> list[PlannedPause]:
    """Return the pauses that need a stand; a wait for company alone is what the programme makes."""
    return [pause for pause in trip.pauses if pause.purposes != ("company",)]


def _told_of_bans(one: Driven, pause: PlannedPause) -> PlannedPause:
    """Return a pause that says so if it is prolonged for the road to be open again."""
    asked_s = pause.start_s + _least_s(pause, one.rules.limits)
    closed = () if "ban" in pause.purposes else one.way.road.forbidden(pause.point).tolist()
    if not any(asked_s < end <= pause.end_s and begin < pause.end_s for begin, end in closed):
        return pause
    purposes = tuple(sorted({*pause.purposes, "ban"}, key=PURPOSES.index))
    return replace(pause, purposes=purposes)


Located = tuple[int, Place | None]
"""Before which stretch of a way, or where within it."""


def _located(
    net: RoadNetwork, runs: Sequence[Run], way: Sequence[int], points: WayPoints, point: int
) -> Located:
    """Return where a point lies on the stretches of a way."""
    one = points.points[point]
    left = one.at
    for leg, k in enumerate(way):
        edges = runs[k].edges
        if left < len(edges):
            if left == 0 and one.share == 0.0:
                return leg, None
            return leg, _place(net, edges, left, one.share)
        left -= len(edges)
    raise AssertionError("no vehicle stands beyond its destination")


def _place(net: RoadNetwork, edges: Sequence[int], at: int, share: float) -> Place:
    """Return a place on a run as one on the edges of the network below."""
    if not isinstance(net, PlacedNetwork) or net.below is None:
        return at, share
    ids = np.asarray(edges, np.int64)
    own = net.below_edge[ids]
    goes_on = (own[1:] == own[:-1]) & (net.begins[ids[1:]] == net.ends[ids[:-1]])
    begin, end = float(net.begins[ids[at]]), float(net.ends[ids[at]])
    place = int(np.count_nonzero(~goes_on[:at]))
    return place, begin + share * (end - begin)


def _day(one: Driven, legs: Sequence[int], count: int, begins: Sequence[int]) -> Day:
    rules, trip = one.rules, one.trip
    limits = rules.limits
    pauses = [_told_of_bans(one, pause) for pause in _told(trip)]
    stands = tuple(
        Stand(
            leg,
            _least_s(pause, limits),
            pause.purposes,
            one.way.points[pause.point].place,
            float(pause.end_s) if "ban" in pause.purposes else None,
        )
        for pause, leg in zip(pauses, legs, strict=True)
    )
    rests = [k for k, pause in enumerate(pauses) if set(REST) & set(pause.purposes)]
    bounds = [0, *(legs[k] for k in rests), count]
    moments = [trip.departure_s, *(at for k in rests for at in _ends(pauses[k])), trip.arrival_s]
    at = rules.state_at_s
    rested_s = 0 if at is None else _rested_s(trip.departure_s - at, rules)
    duties = []
    for number, (first, after) in enumerate(pairwise(bounds)):
        begin, end = moments[2 * number], moments[2 * number + 1]
        before = rules.state.duty_s
        since = 0.0
        if number == 0 and before is not None and at is not None and rested_s < _a_rest(limits):
            since = begin - at + before
        most = limits.window_s if end - begin + since <= limits.window_s else limits.long_window_s
        if most < float("inf"):
            until = None if not since else begin - since + most
            duties.append(Duty(first, after - 1, most, until))
    drivers = [
        DriverDay(rules.state, float(trip.departure_s if at is None else at), own)
        for own in (_drives(one, begins) if trip.drives else [None])
    ]
    return Day(
        stands,
        float(at + rested_s) if at is not None and rested_s else None,
        tuple(duties),
        tuple(drivers),
    )


def _begins(
    net: RoadNetwork,
    runs: Sequence[Run],
    way: Sequence[int],
    one: Driven,
    cuts: dict[int, list[Place]],
) -> tuple[int, ...]:
    """Return the point at which each leg begins, or the last one before it."""
    first = (-1, 0.0)
    starts: list[tuple[int, Place]] = []
    for leg, k in enumerate(way):
        starts += [(leg, first), *((leg, place) for place in cuts.get(k, ()))]
    found, point = [], 0
    located = [_located(net, runs, way, one.way, hop) for hop in range(one.way.road.hops)]
    hops = [(leg, first if place is None else place) for leg, place in located]
    for start in starts:
        while point + 1 < len(hops) and hops[point + 1] <= start:
            point += 1
        found.append(point)
    return tuple(found)


def _drives(one: Driven, begins: Sequence[int]) -> list[tuple[int, ...]]:
    """Return the legs that each of two drivers drives; they change where the vehicle stands."""
    drivers = [one.trip.drives[point] for point in begins]
    return [tuple(leg for leg, who in enumerate(drivers) if who == own) for own in (0, 1)]


def _ends(pause: PlannedPause) -> tuple[int, int]:
    return pause.start_s, pause.end_s


def _a_rest(limits: Limits) -> float:
    return min(limits.rest_s, limits.reduced_rest_s or limits.rest_s)


def _rested_s(seconds: int, rules: VehicleRules) -> int:
    """Return the longest pause of the law that a wait at the origin before leaving holds [s]."""
    limits, state = rules.limits, rules.state
    if not (state.driven_since_break_s or state.driven_today_s or state.duty_s):
        return 0
    first, second = limits.parts_s or (0.0, 0.0)
    whole = limits.beside_s if limits.change_s else limits.break_s
    steps = (
        limits.weekly_rest_s, limits.rest_s, limits.reduced_rest_s, whole, second, first,
    )  # fmt: skip
    return int(max((one for one in steps if 0 < one <= seconds), default=0))


def _least_s(pause: PlannedPause, limits: Limits) -> float:
    """Return how long a pause has to be at least for what it is for [s]."""
    first, second = limits.parts_s or (0.0, 0.0)
    least = {
        "weekly_rest": limits.weekly_rest_s, "daily_rest": limits.rest_s,
        "reduced_daily_rest": limits.reduced_rest_s, "break": limits.break_s,
        "second_part": second, "first_part": first,
    }  # fmt: skip
    if limits.change_s:
        # What two drivers need depends on what is behind each.
        return float(pause.least_s)
    return max((least.get(one, 0.0) for one in pause.purposes), default=0.0)
