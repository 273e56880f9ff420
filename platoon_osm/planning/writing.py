"""Write decisions down: from who drives what with whom to the record of a plan."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np
from numpy.typing import NDArray

from .._version import __version__
from ..costs.weights import EdgeWeights
from ..network.road_network import RoadNetwork
from ..plans.events import platoon_events
from ..plans.plan import Plan
from ..plans.proof import Proof
from ..plans.records import (
    NetworkIdentity,
    PlannedTrip,
    Platoon,
    PlatoonPoint,
    SoloRoute,
    Stop,
    Stretch,
)
from ..plans.stretches import Run, stretched
from .ends import TripEnds
from .problem import Problem

__all__ = ["identity_of", "written_plan"]

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
        Its source, size and hash.
    """
    source = net.source
    return NetworkIdentity(
        source.name, source.sha256, source.extracted, source.licence, source.attribution,
        net.n, net.m, net.identity(),
    )  # fmt: skip


def written_plan(
    problem: Problem,
    weights: EdgeWeights,
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
    weights : EdgeWeights
        What edges cost.
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
    runs, ways = stretched(routes)
    stretches = tuple(_stretch(net, weights, run) for run in runs)

    def point_at(index: int, kind: str, stretch: int) -> PlatoonPoint:
        del index
        edges = stretches[stretch].edges
        node = int(net.tail[edges[0]] if kind == "merge" else net.head[edges[-1]])
        at = float(net.lon[node]), float(net.lat[node])
        return PlatoonPoint(node, int(net.node_id[node]), *at, net.place_name(node), 0.0)

    trips = tuple(
        _trip(net, weights, own, route, reason)
        for own, route, reason in zip(ends, alone, reasons, strict=True)
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
        unit=weights.unit,
        params=dict(weights.params),
        network=identity_of(net),
        proof=proof,
        remarks=tuple(_inferred(net, trips, stretches, ways)),
        version=__version__,
    )


def _stretch(net: RoadNetwork, weights: EdgeWeights, run: Run) -> Stretch:
    edges = np.asarray(run.edges, np.int64)
    length = net.length_m[edges]
    length_m = float(length.sum())
    size = len(run.company)
    return Stretch(
        edges=run.edges,
        vehicles=run.company,
        length_m=length_m,
        drive_s=float((length / net.speed_mps[edges]).sum()),
        shares=tuple(weights.share(edges, length_m, place, size) for place in range(size)),
        inferred_m=float(length[net.inferred[edges]].sum()),
    )


def _trip(
    net: RoadNetwork, weights: EdgeWeights, ends: TripEnds, alone: Edges, reason: str
) -> PlannedTrip:
    own = _stretch(net, weights, Run(tuple(alone.tolist()), (0,)))
    share = own.shares[0]
    return PlannedTrip(
        ends.vehicle,
        _stop(net, ends.origin, ends.origin_name),
        _stop(net, ends.destination, ends.destination_name),
        SoloRoute(
            own.edges, own.length_m, own.drive_s, share.fuel_l, share.cost, own.inferred_m
        ),
        reason,
    )  # fmt: skip


def _stop(net: RoadNetwork, node: int, name: str) -> Stop:
    return Stop(node, float(net.lon[node]), float(net.lat[node]), name)


def _inferred(
    net: RoadNetwork,
    trips: Sequence[PlannedTrip],
    stretches: Sequence[Stretch],
    ways: Sequence[Sequence[int]],
) -> Iterator[str]:
    for trip, way in zip(trips, ways, strict=True):
        inferred_m = sum(stretches[k].inferred_m for k in way)
        if inferred_m:
            count = sum(int(net.inferred[list(stretches[k].edges)].sum()) for k in way)
            yield (
                f"{trip.vehicle} drives {inferred_m / 1000:.1f} km over {count} connectors that "
                "were inferred, not mapped; check them before driving"
            )
