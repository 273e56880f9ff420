"""What a plan without times passes that depends on hours: counted, for nobody can judge it."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from ...driving.bans.rules import Road, bans_of
from ...network.road_network import RoadNetwork
from ...plans.plan import Plan
from ...plans.text_table import listed
from ...vehicles.access import Way
from ...vehicles.closures import Closures
from ...vehicles.profile import Vehicle
from .on_the_spot import country_of_edge

__all__ = ["without_times"]


def without_times(plan: Plan, net: RoadNetwork, vehicles: Sequence[Vehicle]) -> Iterator[str]:
    """Yield what to say of a plan that names no times.

    Parameters
    ----------
    plan : Plan
        Without times.
    net : RoadNetwork
        The network it was made on.
    vehicles : sequence of Vehicle, (N,)
        What drives each trip.

    Yields
    ------
    str
        A remark on roads with hours, one on driving bans; nothing where there are none.
    """
    closures = net.attached(Closures)
    roads: dict[str, float] = {}
    countries: dict[str, None] = {}
    known: dict[tuple[int, ...], bool] = {}
    for index, way in enumerate(plan.ways):
        for edge in (edge for k in way for edge in plan.stretches[k].edges):
            # What is alike in all that is asked is asked once.
            key = *(int(column[edge]) for column in (net.country, net.road_class, net.ref)), index
            country = country_of_edge(net, edge)
            if key not in known:
                known[key] = _has_bans(net, edge, vehicles[index], country)
            if known[key]:
                countries[country] = None
            judged = closures.on(edge, vehicles[index])
            if judged.undecided and judged.way != Way.CLOSED:
                name = net.edge_ref(edge) or net.edge_name(edge) or "a road without a name"
                own = f"{plan.trips[index].vehicle}: {name}"
                roads[own] = roads.get(own, 0.0) + float(net.length_m[edge])
    if roads:
        told = [f"{own} ({metres / 1000:.1f} km)" for own, metres in roads.items()]
        yield f"passes roads with hours, not judged without times: {listed(told)}"
    if countries:
        yield f"driving bans are not judged without times: {listed(list(countries))}"


def _has_bans(net: RoadNetwork, edge: int, vehicle: Vehicle, country: str) -> bool:
    bans = bans_of(country)
    road = Road.of_edge(net, edge)
    return bans is not None and any(rule.concerns(vehicle, road) for rule in bans.rules)
