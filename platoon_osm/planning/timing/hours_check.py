"""Whether anybody is on a road while it is closed: a plan's times, checked edge by edge.

It knows nothing of how the times were found. Each edge of each leg is asked for what is closed
between the moments at which its vehicle enters and leaves it.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from datetime import datetime, timedelta

import numpy as np
from numpy.typing import NDArray

from ...driving.bans.judging import banned
from ...driving.bans.rules import Road, bans_of
from ...network.road_network import RoadNetwork
from ...plans.plan import Plan
from ...vehicles.access import Way
from ...vehicles.closures import Closures
from ...vehicles.conditional_values import has_conditions
from ...vehicles.conditions import next_change
from ...vehicles.judgement import judge
from ...vehicles.profile import Vehicle
from .on_the_spot import country_of_edge, edge_times, local_clock, midpoint
from .road_hours import BESIDE

__all__ = ["Broken", "broken_hours"]

HAIR = timedelta(seconds=0.01)
"""Who is on an edge for less than this while it closes or opens is not on it."""


@dataclass(frozen=True, slots=True)
class Broken:
    """A vehicle on a road that is closed to it.

    Attributes
    ----------
    vehicle : int
        Its position in the plan.
    road : str
        Number of the road; empty if it has none.
    begin, end : datetime
        Between which moments, by the clock of the plan.
    why : str
        What is closed, in a few words.
    """

    vehicle: int
    road: str
    begin: datetime
    end: datetime
    why: str


def broken_hours(plan: Plan, net: RoadNetwork, vehicles: Sequence[Vehicle]) -> list[Broken]:
    """Return who is on a road while it is closed.

    Parameters
    ----------
    plan : Plan
        With times; one without breaks nothing.
    net : RoadNetwork
        The network it was made on.
    vehicles : sequence of Vehicle, (N,)
        What drives each trip.

    Returns
    -------
    list of Broken
        Vehicle by vehicle in driving order, one an edge and closing.
    """
    return list(_broken(plan, net, vehicles))


def _broken(plan: Plan, net: RoadNetwork, vehicles: Sequence[Vehicle]) -> Iterator[Broken]:
    if plan.timetable is None:
        return
    start = plan.timetable.clock.start
    free = (net.restriction == 0) & ~_with_bans(net)
    for index, (way, times) in enumerate(zip(plan.ways, plan.timetable.vehicles, strict=True)):
        near = beside_edges(plan, way)
        bans = _Bans(
            *(start + timedelta(seconds=at) for at in (times.departure_s, times.arrival_s))
        )
        for k, edge, (begin_s, _) in zip(way, near, times.legs, strict=True):
            stretch = plan.stretches[k]
            if free[list(stretch.edges) or [edge]].all():
                continue
            # A way beside the road has no edges: it counts as a small road of its country.
            spans = edge_times(net, stretch) if stretch.edges else [(0.0, stretch.drive_s)]
            edges = stretch.edges or (edge,)
            for own, (enter, leave) in zip(edges, spans, strict=True):
                first, last = (start + timedelta(seconds=begin_s + at) for at in (enter, leave))
                if own < 0 or last - first <= 2 * HAIR:
                    continue
                road = Road.of_edge(net, own) if stretch.edges else BESIDE
                found = _closed(net, bans, own, road, vehicles[index], first + HAIR, last - HAIR)
                for begin, end, why in found:
                    yield Broken(index, road.ref, begin, end, why)


def beside_edges(plan: Plan, way: Sequence[int]) -> list[int]:
    """Return for each stretch of a way an edge of it, or of the road next to it.

    Parameters
    ----------
    plan : Plan
        The plan.
    way : sequence of int
        Stretches that a vehicle drives.

    Returns
    -------
    list of int
        -1 where a vehicle drives nothing but ways beside the road.
    """
    own = [plan.stretches[k].edges[:1] for k in way]
    known = [edges[0] for edges in own if edges]
    if not known:
        return [-1] * len(own)
    return [
        edges[0] if edges else known[0] if place == 0 else known[-1]
        for place, edges in enumerate(own)
    ]


class _Bans:
    """Bans of the whole journey of a vehicle, asked for once for each kind of road."""

    def __init__(self, first: datetime, last: datetime) -> None:
        self._first, self._last = first, last
        self._known: dict[tuple[str, Vehicle, Road], list[tuple[datetime, datetime, str]]] = {}

    def between(
        self, country: str, vehicle: Vehicle, road: Road, first: datetime, last: datetime
    ) -> Iterator[tuple[datetime, datetime, str]]:
        key = (country, vehicle, road)
        if key not in self._known:
            self._known[key] = [
                (*self._face(ban.begin, ban.end), f"the {ban.name} of {country}")
                for ban in banned(country, vehicle, self._first, self._last, road)
            ]
        for begin, end, why in self._known[key]:
            if begin < last and first < end:
                yield max(first, begin), min(last, end), why

    def _face(self, begin: datetime, end: datetime) -> tuple[datetime, datetime]:
        """Return moments in the zone of the plan, or without one if it has none."""
        zone = self._first.tzinfo
        if zone is None:
            return begin.replace(tzinfo=None), end.replace(tzinfo=None)
        return begin.astimezone(zone), end.astimezone(zone)


def _with_bans(net: RoadNetwork) -> NDArray[np.bool_]:
    """Mark the edges of countries that have bans."""
    codes = [
        code for code in np.unique(net.country).tolist() if bans_of(net.texts[code][:2].upper())
    ]
    return np.isin(net.country, codes)


def _closed(
    net: RoadNetwork,
    bans: _Bans,
    edge: int,
    road: Road,
    vehicle: Vehicle,
    first: datetime,
    last: datetime,
) -> Iterator[tuple[datetime, datetime, str]]:
    country = country_of_edge(net, edge)
    yield from bans.between(country, vehicle, road, first, last)
    closures = net.attached(Closures)
    layers = closures.layers(edge)
    if road is BESIDE or not any(has_conditions(layer) for layer in layers):
        return
    if closures.on(edge, vehicle).way == Way.CLOSED:
        return
    asked = midpoint(net, edge), country or None
    clock = local_clock(country, first)
    at, until = clock(first), clock(last)
    while at <= until:
        found = judge(layers, vehicle, at, *asked)
        changes = (next_change(layer, vehicle, at, *asked) for layer in layers)
        later = min((change for change in changes if change is not None), default=None)
        if found.way == Way.CLOSED:
            end = last if later is None else min(last, first + (later - clock(first)))
            name = road.ref or net.edge_name(edge) or "a road"
            why = f"the hours of {name} ({', '.join(found.reasons)})"
            yield first + (at - clock(first)), end, why
        if later is None:
            return
        at = later
