"""Roads for residents that a plan's vehicle drives on the way, having left its own zone of them."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np
from numpy.typing import NDArray

from ..network.placed import network_below
from ..network.road_network import RoadNetwork
from ..plans.plan import Plan
from ..plans.records import Stop
from ..vehicles.closures import Closures
from ..vehicles.profile import Vehicle
from .end_zones import EndZones
from .told_edge import place_of, road_of

__all__ = ["zones_crossed"]


def zones_crossed(
    plan: Plan, net: RoadNetwork, vehicles: Sequence[Vehicle], shut: NDArray[np.bool_]
) -> Iterator[str]:
    """Yield a remark for each vehicle that comes back through its own zone, only to leave it again.

    Parameters
    ----------
    plan : Plan
        Its ways are driven as they stand.
    net : RoadNetwork
        The network it was made on, with or without places between its junctions.
    vehicles : sequence of Vehicle, (N,)
        What drives each trip.
    shut : ndarray of bool
        Edges of the network below that count as closed for this plan.

    Yields
    ------
    str
        Who does so, and where.
    """
    net = network_below(net)
    if not net.restriction.any():
        return
    zones: dict[Vehicle, EndZones] = {}
    for own, way, vehicle in zip(plan.vehicles, plan.ways, vehicles, strict=True):
        judged = net.attached(Closures).of(vehicle)
        edges = np.array(
            [
                edge
                for k in way
                if plan.stretches[k].access is None
                for edge in plan.stretches[k].edges
            ],
            np.int64,
        )
        if not judged.ends[edges].any():
            continue
        if vehicle not in zones:
            closed = judged.closed | shut
            zones[vehicle] = EndZones(net, judged.ends & ~closed, closed)
        beside = [plan.stretches[k].access is not None for k in (way[0], way[-1])]
        within = (
            beside[0] or _between_nodes(own.origin),
            beside[1] or _between_nodes(own.destination),
        )
        at = zones[vehicle].returns(edges, within)
        if at is not None:
            yield (
                f"{own.vehicle} returns on its way to roads for residents that it had left "
                f"({road_of(net, at)}, {place_of(net, at)}): check whether it may"
            )


def _between_nodes(stop: Stop) -> bool:
    return stop.edge is not None
