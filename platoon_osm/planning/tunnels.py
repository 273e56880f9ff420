"""Tunnels that a plan passes and that are closed to some dangerous goods: who drives there knows.

Of category A are tunnels that close to nobody; who carries dangerous goods is told of these too.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from ..network.placed import network_below
from ..network.restrictions import decode
from ..network.road_network import POINT_KINDS, RoadNetwork
from ..network.stops import tunnels_along
from ..plans.plan import Plan
from ..vehicles.closures import Closures
from ..vehicles.judgement import TUNNEL
from ..vehicles.profile import Vehicle
from .told_edge import place_of, road_of

__all__ = ["passed_tunnels"]

MOST_TOLD = 5
"""Tunnels told for each vehicle, in driving order; of more only the number."""

NOBODY = "A"


def passed_tunnels(plan: Plan, net: RoadNetwork, vehicles: Sequence[Vehicle]) -> Iterator[str]:
    """Yield a remark for each tunnel with a category that a vehicle passes.

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
        Who passes a tunnel of which category, and where.
    """
    net = network_below(net)
    if not net.restriction.any() and not (net.points.kind == POINT_KINDS.index("tunnel")).any():
        return
    for trip, way, vehicle in zip(plan.trips, plan.ways, vehicles, strict=True):
        edges = [int(edge) for k in way for edge in plan.stretches[k].edges]
        # Stretches meet within an edge, which then stands in both.
        edges = [edge for k, edge in enumerate(edges) if k == 0 or edge != edges[k - 1]]
        told = list(dict.fromkeys(_tunnels(net, edges, vehicle.hazardous)))
        for category, where in told[:MOST_TOLD]:
            yield f"{trip.vehicle} passes a tunnel of category {category} ({where})"
        if len(told) > MOST_TOLD:
            yield f"{trip.vehicle} passes {len(told) - MOST_TOLD} more tunnels with a category"


def _tunnels(net: RoadNetwork, edges: Sequence[int], hazardous: bool) -> Iterator[tuple[str, str]]:
    """Yield category and place of the tunnels on a path, those that follow each other as one."""
    closures = net.attached(Closures)
    names: dict[int, list[tuple[str, str]]] = {}
    for passed in tunnels_along(net, edges):
        category = _category(decode(passed.stop.tags))
        names.setdefault(passed.place, []).append((category, passed.stop.name))
    before = ""
    for place, edge in enumerate(edges):
        category = _category(closures.layers(edge)) if net.restriction[edge] else ""
        own = dict(reversed(names.get(place, [])))
        if category and category != before:
            yield category, _where(net, edge, own.get(category, ""))
        if hazardous and NOBODY in own:
            yield NOBODY, _where(net, edge, own[NOBODY])
        before = category


def _category(layers: Sequence[dict[str, str]]) -> str:
    found = [layer[key].strip().upper() for layer in layers for key in TUNNEL if key in layer]
    return max((one for one in found if one in tuple("ABCDE")), default="")


def _where(net: RoadNetwork, edge: int, name: str) -> str:
    return f"{name or net.edge_name(edge) or road_of(net, edge)}, {place_of(net, edge)}"
