"""What to check on the road before driving a plan, for the map does not say it for sure."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np

from ..network.nearest_road import is_closed
from ..network.placed import PlacedNetwork, is_beside
from ..network.road_network import RoadNetwork
from ..plans.records import PlannedTrip
from ..plans.stretches import Run

__all__ = ["meets", "road_remarks"]


def road_remarks(
    net: RoadNetwork,
    trips: Sequence[PlannedTrip],
    runs: Sequence[Run],
    ways: Sequence[Sequence[int]],
) -> Iterator[str]:
    """Yield what to check of the roads of a plan.

    Parameters
    ----------
    net : RoadNetwork
        The network with its places.
    trips : sequence of PlannedTrip, (N,)
        Who drives.
    runs : sequence of Run
        What is driven by whom.
    ways : sequence of sequence of int, (N, ...)
        The runs of each vehicle in driving order.

    Yields
    ------
    str
        Connectors that were inferred, then ways onto a motorway without a junction.
    """
    yield from _inferred(net, trips, runs, ways)
    yield from _between_junctions(net, trips, runs, ways)


def meets(net: RoadNetwork, edge: int) -> int:
    """Return the node where a way beside the road meets it.

    Parameters
    ----------
    net : RoadNetwork
        The network with its places.
    edge : int
        The way beside the road.

    Returns
    -------
    int
        Node of the road.
    """
    tail, head = int(net.tail[edge]), int(net.head[edge])
    return head if is_beside(net, tail) else tail


def _inferred(
    net: RoadNetwork,
    trips: Sequence[PlannedTrip],
    runs: Sequence[Run],
    ways: Sequence[Sequence[int]],
) -> Iterator[str]:
    for trip, way in zip(trips, ways, strict=True):
        edges = np.array([edge for k in way for edge in runs[k].edges], np.int64)
        inferred = edges[net.inferred[edges]]
        if len(inferred):
            yield (
                f"{trip.vehicle} drives {net.length_m[inferred].sum() / 1000:.1f} km over "
                f"{len(inferred)} connectors that were inferred, not mapped; check them before "
                "driving"
            )


def _between_junctions(
    net: RoadNetwork,
    trips: Sequence[PlannedTrip],
    runs: Sequence[Run],
    ways: Sequence[Sequence[int]],
) -> Iterator[str]:
    """Remark ways to a motorway that meet it where the map has no junction."""
    if not isinstance(net, PlacedNetwork) or net.below is None:
        return
    first = net.below.n
    for trip, way in zip(trips, ways, strict=True):
        for edge in (edge for k in way for edge in runs[k].edges if net.below_edge[edge] < 0):
            leaves = is_beside(net, int(net.tail[edge]))
            node = meets(net, edge)
            road = int(net.place_edge[node - first]) if node >= first else -1
            if road >= 0 and is_closed(net.below, road):
                yield (
                    f"{trip.vehicle} {'gets onto' if leaves else 'leaves'} "
                    f"{net.below.edge_ref(road) or 'the road'} between two junctions, for the map "
                    f"has none near {trip.origin.name if leaves else trip.destination.name}; check "
                    "that there is a way"
                )
