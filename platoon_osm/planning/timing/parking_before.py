"""Where a truck that has to stand finds a parking: the last one on its way before that place.

Times have a vehicle stand at a junction, where it can leave the road; a driver looks for a rest
area or a truck parking before it.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import pairwise

from ...network.road_network import RoadNetwork
from ...network.road_stop import RoadStop, StopAccess
from ...network.stops import PassedStop, stops_along
from ...plans.clock import MENTIONED_S
from ...plans.pauses import PausePlace
from ...plans.plan import Plan
from ...plans.records import Stretch
from ...vehicles.profile import Vehicle
from ...vehicles.stop_offers import offers_to

__all__ = ["FARTHEST_BACK_M", "parking_before", "parking_place", "parkings_back"]

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


def parkings_back(
    net: RoadNetwork, stretch: Stretch, vehicles: Sequence[Vehicle], back_m: float
) -> Iterator[tuple[PassedStop, float]]:
    """Yield the parkings on a stretch that are near the end of a way, the last first.

    Parameters
    ----------
    net : RoadNetwork
        The network whose edges it names.
    stretch : Stretch
        A part of the way.
    vehicles : sequence of Vehicle
        Those that park.
    back_m : float
        How much of the way follows the stretch [m].

    Yields
    ------
    PassedStop
        Where all of them may park.
    float
        How far before the end of the way, at most `FARTHEST_BACK_M` [m].
    """
    for passed in reversed(stops_along(net, stretch.edges, stretch.span)):
        before_m = back_m + stretch.length_m - passed.at_m
        if before_m > FARTHEST_BACK_M:
            return
        if all("parking" in offers_to(passed.stop, vehicle) for vehicle in vehicles):
            yield passed, before_m


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
    back_m = 0.0
    for number in reversed(plan.ways[index][: stands + 1]):
        stretch = plan.stretches[number]
        for passed, before_m in parkings_back(net, stretch, [vehicle], back_m):
            name = f" {passed.stop.name}" if passed.stop.name else ""
            return f", {before_m / 1000:.0f} km after the truck parking{name}"
        back_m += stretch.length_m
    return ""
