"""The published model in whole numbers.

What was recovered of it from the published figures: trucks drive at 80 km/h and wait at cities for
nothing; each arrives by its earliest departure, its shortest driving time and its flexibility;
earliest departures are rounded up to a grid of 15 minutes. Of two trucks the leader saves 6 % of
its fuel and the other 10 %, which the kilometres and savings of all pairs fit to the last digit
printed. Of three they save 27 % in all: with 26 %, which 6, 10 and 10 % would make, the proven
optimum of ONEORIG stays 0.1 to 0.25 points below what was published, and savings less those of
pairs, per kilometre in threes, are 9.0 % a truck (8.85 to 9.04).
"""

from __future__ import annotations

import itertools
import math

import numpy as np
from numpy.typing import NDArray

from ...errors import ScenarioError
from ..instance import Instance
from ..lanes import Lanes
from ..windows import Wanted, paired
from .records import DutchData, DutchInstance

__all__ = ["GRID_MIN", "dutch_instance"]

Ints = NDArray[np.int64]

GRID_MIN = 15.0
"""Earliest departures are rounded up to a multiple of it [min]."""

TICKS_PER_KM = 45_000
"""Milliseconds at 80 km/h."""

GRAINS_PER_KM = 100_000
"""A grain is a hundred-thousandth of what a kilometre burns alone."""

PAIR, TRIPLE = 0.16, 0.27
"""What platoons of two and three save in all, of what one burns alone."""


def dutch_instance(
    data: DutchData,
    one: DutchInstance,
    flexibility_min: float,
    largest: int,
    grid_min: float = GRID_MIN,
) -> Instance:
    """Return an instance in whole numbers.

    Parameters
    ----------
    data : DutchData
        The network.
    one : DutchInstance
        The trucks.
    flexibility_min : float
        How much later than by driving at once each may arrive [min].
    largest : {2, 3}
        Vehicles of the largest platoon.
    grid_min : float
        To what earliest departures are rounded up [min]; 0 for exact minutes.

    Returns
    -------
    Instance
        On free routes.

    Raises
    ------
    ScenarioError
        A truck without a way.
    """
    lanes, places = _lanes(data, len(one.trucks))
    try:
        origin = np.array([places[truck.origin] for truck in one.trucks])
        destination = np.array([places[truck.destination] for truck in one.trucks])
    except KeyError as error:
        raise ScenarioError(
            f"{one.name} {len(one.trucks)}, {one.number}: no link leads to city {error}; check it"
        ) from None
    routes = _shortest(lanes, origin, destination, one)
    leaves = [
        math.ceil(truck.departure_min / grid_min) * grid_min if grid_min else truck.departure_min
        for truck in one.trucks
    ]
    earliest = np.rint(np.array(leaves) * 60_000).astype(np.int64)
    drive = np.array([lanes.drive[route].sum() for route in routes])
    latest = earliest + drive + round(flexibility_min * 60_000)
    wanted = Wanted(origin, destination, earliest, latest, latest, routes)
    return paired(lanes, wanted, given=False, largest=largest)[0]


def _lanes(data: DutchData, trucks: int) -> tuple[Lanes, dict[int, int]]:
    cities = sorted({city for a, b, _ in data.links for city in (a, b)})
    places = {city: place for place, city in enumerate(cities)}
    ways = dict.fromkeys(
        (places[a], places[b], km)
        for both in data.links
        for a, b, km in (both, (both[1], both[0], both[2]))
    )
    tail, head = (np.array([way[k] for way in ways]) for k in (0, 1))
    km = np.array([way[2] for way in ways])
    alone = np.rint(km * GRAINS_PER_KM).astype(np.int64)
    # The line through what two and three pay: 2 member + extra, 3 member + extra.
    saved = TRIPLE - PAIR
    member = np.rint((1 - saved) * km * GRAINS_PER_KM).astype(np.int64)
    extra = np.rint((2 * saved - PAIR) * km * GRAINS_PER_KM).astype(np.int64)
    count = len(tail)
    lanes = Lanes(
        nodes=np.arange(len(cities)), tail=tail, head=head,
        drive=np.rint(km * TICKS_PER_KM).astype(np.int64), alone=alone, member=member,
        extra=extra, lane_kind=np.zeros(count, np.int64), first_edge=np.arange(count + 1),
        edges=np.arange(count), kind=np.zeros(trucks, np.int64), grains=float(GRAINS_PER_KM),
    )  # fmt: skip
    return lanes, places


def _shortest(lanes: Lanes, origin: Ints, destination: Ints, one: DutchInstance) -> list[Ints]:
    """Return the shortest path of each truck."""
    import rustworkx

    graph = rustworkx.PyDiGraph()
    graph.add_nodes_from(range(len(lanes.nodes)))
    graph.add_edges_from(
        [(int(a), int(b), k) for k, (a, b) in enumerate(zip(lanes.tail, lanes.head, strict=True))]
    )
    found = []
    for start, end in zip(origin.tolist(), destination.tolist(), strict=True):
        path = rustworkx.dijkstra_shortest_paths(
            graph, start, end, weight_fn=lambda k: float(lanes.alone[k])
        )
        if end not in path:
            raise ScenarioError(
                f"{one.name} {len(one.trucks)}, {one.number}: a truck has no way to its "
                "destination; check the links"
            )
        nodes = list(path[end])
        found.append(
            np.array(
                [
                    min(
                        (int(k) for k in graph.get_all_edge_data(a, b)),
                        key=lambda k: (lanes.alone[k], k),
                    )
                    for a, b in itertools.pairwise(nodes)
                ],
                np.int64,
            )
        )
    return found
