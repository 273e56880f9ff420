"""Bridges and gates that a plan passes with little room: who drives there should know."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from ..network.placed import network_below
from ..network.road_network import RoadNetwork
from ..plans.plan import Plan
from ..vehicles.closures import Closures
from ..vehicles.limits import Passed
from ..vehicles.profile import Vehicle
from .told_edge import place_of, road_of

__all__ = ["tight_limits"]

MOST_TOLD = 5
"""Places told for each vehicle, the tightest first; of more only the number."""


def tight_limits(plan: Plan, net: RoadNetwork, vehicles: Sequence[Vehicle]) -> Iterator[str]:
    """Yield a remark for each limit that a vehicle passes with little room.

    Parameters
    ----------
    plan : Plan
        Its ways are driven as they stand.
    net : RoadNetwork
        The network it was made on, with or without places between its junctions.
    vehicles : sequence of Vehicle, (N,)
        What drives each trip.

    Yields
    ------
    str
        Who passes which limit, with how much room, and where.
    """
    net = network_below(net)
    if not net.restriction.any():
        return
    closures = net.attached(Closures)
    for trip, way, vehicle in zip(plan.trips, plan.ways, vehicles, strict=True):
        found: dict[tuple[str, float, str], tuple[float, Passed, str]] = {}
        for edge in (edge for k in way for edge in plan.stretches[k].edges):
            if not net.restriction[edge]:
                continue
            for passed in closures.on(edge, vehicle).margins:
                road = road_of(net, edge)
                room = (passed.limit - passed.value) / passed.limit
                place = place_of(net, edge)
                found.setdefault((passed.key, passed.limit, road), (room, passed, place))
        told = sorted(found.items(), key=lambda one: (one[1][0], one[0]))
        for (key, limit, road), (_, passed, place) in told[:MOST_TOLD]:
            unit = passed.kind.unit
            yield (
                f"{trip.vehicle} passes {key} {limit:g} {unit} with {_room(passed)} of room "
                f"({road}, {place})"
            )
        if len(told) > MOST_TOLD:
            yield f"{trip.vehicle} passes {len(told) - MOST_TOLD} more limits with little room"


def _room(passed: Passed) -> str:
    room = max(passed.limit - passed.value, 0.0)
    return f"{100 * room:.0f} cm" if passed.kind.unit == "m" else f"{room:.1f} t"
