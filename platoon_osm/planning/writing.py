"""Write decisions down: from who drives what with whom to the record of a plan."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from .._version import __version__
from ..network.placed import PlacedNetwork, access_of, is_beside, network_below, whole_edges
from ..network.road_network import RoadNetwork
from ..plans.events import platoon_events
from ..plans.plan import Plan
from ..plans.proof import Proof
from ..plans.records import (
    WHOLE,
    Line,
    NetworkIdentity,
    PlannedTrip,
    Platoon,
    PlatoonPoint,
    SoloRoute,
    Stop,
    Stretch,
)
from ..plans.stretches import Run, runs_along, stretched
from ..vehicles.profile import Vehicle
from .ends import TripEnds
from .fleet import Fleet
from .positions import proved_by_position
from .problem import Problem
from .road_remarks import meets, road_remarks

__all__ = ["driven_runs", "identity_of", "written_plan"]

Edges = NDArray[np.int64]


def identity_of(net: RoadNetwork) -> NetworkIdentity:
    """Return which network a plan belongs to.

    Parameters
    ----------
    net : RoadNetwork
        The network.

    Returns
    -------
    NetworkIdentity
        Its source, size and hash; those of the network below if it has places between junctions.
    """
    net = network_below(net)
    source = net.source
    return NetworkIdentity(
        source.name, source.sha256, source.extracted, source.licence, source.attribution,
        net.n, net.m, net.identity(),
    )  # fmt: skip


def written_plan(
    problem: Problem,
    fleet: Fleet,
    ends: Sequence[TripEnds],
    alone: Sequence[Edges],
    routes: Sequence[Sequence[Run]],
    platoons: Sequence[Platoon],
    reasons: Sequence[str],
    case: str,
    proof: Proof,
) -> Plan:
    """Return the plan of some decisions.

    Parameters
    ----------
    problem : Problem
        What was asked.
    fleet : Fleet
        What edges cost each vehicle, and how fast it is.
    ends : sequence of TripEnds, (N,)
        Where vehicles go.
    alone : sequence of ndarray of int, (N, ...)
        The route of each vehicle alone.
    routes : sequence of sequence of Run, (N, ...)
        Who drives what with whom.
    platoons : sequence of Platoon
        Who belongs together.
    reasons : sequence of str, (N,)
        Why a vehicle stays alone; empty where it does not.
    case : str
        The case that was planned.
    proof : Proof
        What is proved.

    Returns
    -------
    Plan
        Without times.
    """
    net = problem.net
    runs, ways = driven_runs(net, routes)
    stretches = tuple(_stretch(net, fleet, run) for run in runs)
    names = _place_names(net, ends)
    points: dict[int, PlatoonPoint] = {}

    def point_at(index: int, kind: str, stretch: int) -> PlatoonPoint:
        del index
        edges = runs[stretch].edges
        node = int(net.tail[edges[0]] if kind == "merge" else net.head[edges[-1]])
        if node not in points:
            points[node] = point_of(node)
        return points[node]

    def point_of(node: int) -> PlatoonPoint:
        stop = _stop(net, node, "")
        name = names.get(node) or net.place_name(node)
        osm_id = int(net.node_id[node]) if stop.node >= 0 else 0
        return PlatoonPoint(
            stop.node, osm_id, stop.lon, stop.lat, name, 0.0, stop.edge, stop.share
        )  # fmt: skip

    trips = tuple(
        _trip(net, fleet, index, ends[index], route, reason, problem.vehicle_of(trip))
        for index, (trip, route, reason) in enumerate(
            zip(problem.trips, alone, reasons, strict=True)
        )
    )
    return Plan(
        trips=trips,
        stretches=stretches,
        ways=ways,
        platoons=tuple(platoons),
        events=platoon_events(stretches, ways, platoons, point_at),
        case=case,
        asked=problem.case,
        objective="system" if case == "D" else problem.optimum,
        method="dijkstra" if case == "D" else problem.method,
        unit=fleet[0].unit,
        params=dict(fleet[0].params),
        network=identity_of(net),
        proof=proved_by_position(proof, fleet, stretches),
        remarks=tuple(road_remarks(net, trips, runs, ways)),
        version=__version__,
        closed=tuple(map(str, problem.close)),
    )


def driven_runs(
    net: RoadNetwork, routes: Sequence[Sequence[Run]]
) -> tuple[tuple[Run, ...], tuple[tuple[int, ...], ...]]:
    """Return the runs that become the stretches of a plan, and the way of each vehicle over them.

    Parameters
    ----------
    net : RoadNetwork
        The network, with or without places between its junctions.
    routes : sequence of sequence of Run, (N, ...)
        Who drives what with whom.

    Returns
    -------
    runs : tuple of Run
        One a stretch, ways beside the road by themselves.
    ways : tuple of tuple of int, (N, ...)
        Their positions, in driving order.
    """
    return stretched([_access_apart(net, index, own) for index, own in enumerate(routes)])


def _access_apart(net: RoadNetwork, vehicle: int, runs: Sequence[Run]) -> list[Run]:
    """Return runs of which each is road, or one way beside the road that a vehicle drives alone."""
    found: list[Run] = []
    for run in runs:
        edges = np.asarray(run.edges, np.int64)
        ways = access_of(net, edges)
        if not ways.any():
            found.append(run)
            continue
        companies = [(vehicle,) if way else run.company for way in ways]
        for part in runs_along(edges, companies):
            on = access_of(net, np.asarray(part.edges, np.int64))
            pieces = np.split(np.array(part.edges), np.flatnonzero(on[1:] | on[:-1]) + 1)
            found += [Run(tuple(piece.tolist()), part.company) for piece in pieces]
    return found


def _place_names(net: RoadNetwork, ends: Sequence[TripEnds]) -> dict[int, str]:
    """Return what people call the nodes of places between junctions."""
    names: dict[int, str] = {}
    first = network_below(net).n
    for own in ends:
        for chosen, name, same in (
            (own.origin, own.origin_name, own.origins),
            (own.destination, own.destination_name, own.destinations),
        ):
            # What leads to a place beside the road is not the place.
            for node in [chosen] if is_beside(net, chosen) else sorted(same):
                if node >= first:
                    names.setdefault(node, name)
    return names


def _stretch(net: RoadNetwork, fleet: Fleet, run: Run) -> Stretch:
    edges = np.asarray(run.edges, np.int64)
    length = net.length_m[edges]
    length_m = float(length.sum())
    way = access_of(net, edges)[:1].any()
    below, span = ((), WHOLE) if way else whole_edges(net, edges)
    return Stretch(
        edges=below,
        vehicles=run.company,
        length_m=length_m,
        drive_s=fleet.route_s(run.company, edges),
        shares=tuple(
            fleet.share(run.company, place, edges, length_m) for place in range(len(run.company))
        ),
        inferred_m=float(length[net.inferred[edges]].sum()),
        span=span,
        access=_line(net, run.edges[0]) if way else None,
        access_at=net.place_name(meets(net, run.edges[0])) if way else "",
    )


def _line(net: RoadNetwork, edge: int) -> Line:
    """Return the straight line of a way beside the road."""
    shape = net.shape(edge).tolist()
    (lon, lat), (to_lon, to_lat) = shape[0], shape[-1]
    return (lon, lat), (to_lon, to_lat)


def _trip(
    net: RoadNetwork,
    fleet: Fleet,
    index: int,
    ends: TripEnds,
    alone: Edges,
    reason: str,
    profile: Vehicle,
) -> PlannedTrip:
    edges = np.asarray(alone, np.int64)
    length = net.length_m[edges]
    length_m = float(length.sum())
    share = fleet.share((index,), 0, edges, length_m)
    ways = access_of(net, edges)
    road = edges[~ways]
    below, span = whole_edges(net, road) if len(road) else ((), WHOLE)
    first = _line(net, int(edges[0])) if ways[:1].any() else None
    # Between two places beside the road that share a junction there may be no road at all.
    last = _line(net, int(edges[-1])) if ways[-1:].any() and len(edges) > 1 else None
    return PlannedTrip(
        ends.vehicle,
        _stop(net, ends.origin, ends.origin_name),
        _stop(net, ends.destination, ends.destination_name),
        SoloRoute(
            below,
            length_m,
            fleet.route_s((index,), edges),
            share.fuel_l,
            share.cost,
            float(length[net.inferred[edges]].sum()),
            span,
            (first, last),
            share.terms,
        ),
        reason,
        profile,
    )


def _stop(net: RoadNetwork, node: int, name: str) -> Stop:
    at = float(net.lon[node]), float(net.lat[node])
    first = network_below(net).n
    if not isinstance(net, PlacedNetwork) or node < first:
        return Stop(node, *at, name)
    edge = int(net.place_edge[node - first])
    if edge < 0:
        return Stop(-1, *at, name)
    return Stop(-1, *at, name, edge, float(net.place_share[node - first]))
