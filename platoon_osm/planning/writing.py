"""Write decisions down: from points on a route to legs with their lengths, times and costs."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ..costs.weights import EdgeWeights
from ..network.road_network import RoadNetwork
from ..plans.records import Leg, NetworkIdentity, PlatoonPoint, Stop, VehiclePlan
from .ends import TripEnds

__all__ = ["Journey", "identity_of", "vehicle_plan"]

Edges = NDArray[np.int64]


@dataclass(frozen=True, slots=True)
class Journey:
    """What one vehicle does.

    Attributes
    ----------
    before, together, after : edges alone, in the platoon, alone again.
    partners : for each edge of `together`, who else is there.
    master : whether it costs what the master pays.
    """

    before: Edges
    together: Edges
    after: Edges
    partners: tuple[frozenset[str], ...]
    master: bool = False


def identity_of(net: RoadNetwork) -> NetworkIdentity:
    """Return which network a plan belongs to."""
    source = net.source
    return NetworkIdentity(
        source.name, source.sha256, source.extracted, source.licence, source.attribution,
        net.n, net.m, net.identity(),
    )  # fmt: skip


def vehicle_plan(
    net: RoadNetwork,
    weights: EdgeWeights,
    ends: TripEnds,
    alone: Edges,
    journey: Journey,
    role: str,
    reason: str = "",
) -> VehiclePlan:
    """Write down one vehicle's part of a plan."""
    legs = [_leg(net, weights, journey.before, "solo", (), False)]
    for edges, partners in _by_partners(journey):
        kind = "platoon" if partners else "solo"
        legs.append(_leg(net, weights, edges, kind, tuple(sorted(partners)), journey.master))
    legs.append(_leg(net, weights, journey.after, "solo", (), False))
    merge = separation = None
    if role != "master" and len(journey.together):
        start = float(net.length_m[journey.before].sum())
        shared = float(net.length_m[journey.together].sum())
        merge = _point(net, int(net.tail[journey.together[0]]), start)
        separation = _point(net, int(net.head[journey.together[-1]]), start + shared)
    return VehiclePlan(
        vehicle=ends.vehicle,
        origin=_stop(net, ends.origin, ends.origin_name),
        destination=_stop(net, ends.destination, ends.destination_name),
        role=role,
        legs=tuple(leg for leg in legs if leg.edges),
        alone=_leg(net, weights, alone, "solo", (), False),
        merge=merge,
        separation=separation,
        reason=reason,
    )


def _by_partners(journey: Journey) -> list[tuple[Edges, frozenset[str]]]:
    """Cut the shared stretch where company changes."""
    stretches: list[tuple[Edges, frozenset[str]]] = []
    begin = 0
    for at in range(1, len(journey.together) + 1):
        if at == len(journey.together) or journey.partners[at] != journey.partners[begin]:
            stretches.append((journey.together[begin:at], journey.partners[begin]))
            begin = at
    return stretches


def _leg(
    net: RoadNetwork,
    weights: EdgeWeights,
    edges: Edges,
    role: str,
    partners: Sequence[str],
    master: bool,
) -> Leg:
    weight = weights.solo if role == "solo" else weights.master if master else weights.platoon
    length = net.length_m[edges]
    alone, leading, following = weights.fuel_l_per_m
    litres_per_m = alone if role == "solo" else leading if master else following
    return Leg(
        role=role,
        edges=tuple(int(edge) for edge in edges),
        partners=tuple(partners),
        length_m=float(length.sum()),
        time_s=float((length / net.speed_mps[edges]).sum()),
        fuel_l=float(length.sum()) * litres_per_m,
        cost=float(weight[edges].sum()),
        inferred_m=float(length[net.inferred[edges]].sum()),
    )


def _stop(net: RoadNetwork, node: int, name: str) -> Stop:
    return Stop(node, float(net.lon[node]), float(net.lat[node]), name)


def _point(net: RoadNetwork, node: int, along_m: float) -> PlatoonPoint:
    return PlatoonPoint(
        node, int(net.node_id[node]), float(net.lon[node]), float(net.lat[node]),
        net.place_name(node), along_m / 1000,
    )  # fmt: skip
