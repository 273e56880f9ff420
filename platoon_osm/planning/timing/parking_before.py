"""Where a truck that has to stand finds a parking: the last one on its way before that place.

Times have a vehicle stand at a junction, where it can leave the road; a driver looks for a rest
area or a truck parking before it.
"""

from __future__ import annotations

from itertools import pairwise

from ...network.road_network import RoadNetwork
from ...network.road_stop import RoadStop, StopAccess
from ...network.stops import stops_along
from ...plans.clock import MENTIONED_S
from ...plans.pauses import PausePlace
from ...plans.plan import Plan
from ...vehicles.profile import Vehicle
from ...vehicles.stop_offers import offers_to

__all__ = ["FARTHEST_BACK_M", "parking_before", "parking_place"]

FARTHEST_BACK_M = 50_000.0
"""A parking farther back than this is of no use to who stands: much can happen on the rest of the
way [m]."""


def parking_place(stop: RoadStop, access: StopAccess) -> PausePlace:
    """Return a stop beside the road as a place to pause.

    Parameters
    ----------
    stop : RoadStop
        The stop.
    access : StopAccess
        Where the road is left for it.

    Returns
    -------
    PausePlace
        For the record.
    """
    return PausePlace(stop.name, stop.kind, stop.lon, stop.lat, access.beside_m, stop.capacity)


def parking_before(plan: Plan, net: RoadNetwork, index: int, vehicle: Vehicle) -> str:
    """Say where a vehicle finds a parking before it stands longest.

    Parameters
    ----------
    plan : Plan
        With times.
    net : RoadNetwork
        The network whose edges it names.
    index : int
        Which vehicle.
    vehicle : Vehicle
        What drives there.

    Returns
    -------
    str
        As ", 4 km after the truck parking Secchia"; empty if it does not stand, or if there is
        none within 50 km.
    """
    assert plan.timetable is not None
    legs = plan.timetable.vehicles[index].legs
    waits = [after[0] - before[1] for before, after in pairwise(legs)]
    if not waits or max(waits) < MENTIONED_S:
        return ""
    stands = waits.index(max(waits))
    driven, found = 0.0, None
    for stretch in (plan.stretches[k] for k in plan.ways[index][: stands + 1]):
        for passed in stops_along(net, stretch.edges, stretch.span):
            if "parking" in offers_to(passed.stop, vehicle):
                found = driven + passed.at_m, passed.stop
        driven += stretch.length_m
    if found is None or driven - found[0] > FARTHEST_BACK_M:
        return ""
    at_m, stop = found
    name = f" {stop.name}" if stop.name else ""
    return f", {(driven - at_m) / 1000:.0f} km after the truck parking{name}"
