"""Least costs between places, as a table with their names."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from ..costs.objective import Objective, check_objective
from ..costs.placed_weights import placed_weights
from ..costs.weights import EdgeWeights
from ..errors import ScenarioError, brief
from ..kinds import kind_of
from ..network.location import Location, Role
from ..network.road_network import RoadNetwork, checked_network
from ..search.engine import many_to_many
from .ends import ACCESS_DETOUR
from .places import PlacedEnd, placed

if TYPE_CHECKING:
    import pandas

__all__ = ["place_table"]

MEASURES = ("km", "hours")


def place_table(
    net: RoadNetwork,
    origins: Iterable[Any],
    destinations: Iterable[Any] | None = None,
    measure: str | Objective | EdgeWeights = "km",
) -> pandas.DataFrame:
    """Return what the least way between places takes, each from each, for a vehicle alone.

    Parameters
    ----------
    net : RoadNetwork
        The network.
    origins : iterable of place
        Names, (lon, lat) pairs in degrees, nodes, or what `net.locate` found.
    destinations : iterable of place, optional
        By default the origins; from a place to itself it is 0.
    measure : {"km", "hours"}, Objective or EdgeWeights
        What is least and told: length [km], driving time [h], or the cost of a vehicle alone, in
        the unit of the costs.

    Returns
    -------
    pandas.DataFrame, (O, D)
        Origins as index, destinations as columns, by their names; inf where there is no way. Its
        `attrs` name the `unit`.

    Raises
    ------
    NetworkError
        A place that is not found.
    ScenarioError
        No places, or a measure that is none.
    """
    import pandas as pd

    net = checked_network(net)
    asked = _listed(origins, "origins")
    starts = _located(net, asked, "origin")
    other = asked if destinations is None else _listed(destinations, "destinations")
    ends = _located(net, other, "destination")
    count = max(len(starts), len(ends))
    pairs = [(starts[k % len(starts)], ends[k % len(ends)]) for k in range(count)]
    found = placed(net, pairs)
    weight, unit = _weight(found.net, measure)
    first = [pair[0] for pair in found.ends[: len(starts)]]
    last = [pair[1] for pair in found.ends[: len(ends)]]
    values = _least(found.net, weight, first, last)
    same = [[_one_place(a, b) for b in ends] for a in starts]
    values[np.array(same)] = 0.0
    table = pd.DataFrame(
        values,
        pd.Index([place.name for place in starts], name="origin"),
        pd.Index([place.name for place in ends], name="destination"),
    )
    table.attrs["unit"] = unit
    return table


def _listed(places: Any, what: str) -> list[Any]:
    if isinstance(places, str | bytes | Mapping) or not isinstance(places, Iterable):
        raise ScenarioError(f"{what}: a {kind_of(places)} is no list; give places in a list")
    if not (found := list(places)):
        raise ScenarioError(f"{what}: there are none; give at least one place")
    return found


def _located(net: RoadNetwork, places: Sequence[Any], role: Role) -> list[Location]:
    return [net.locate(place, role) for place in places]


def _weight(
    net: RoadNetwork, measure: str | Objective | EdgeWeights
) -> tuple[NDArray[np.float64], str]:
    if isinstance(measure, str):
        if measure not in MEASURES:
            raise ScenarioError(
                f"measure {brief(measure)} is unknown; use km, hours, or costs such as PaperCosts()"
            )
        if measure == "km":
            return net.length_m / 1000, "km"
        return net.length_m / net.speed_mps / 3600, "h"
    check_objective(measure, "measure", ("weights",))
    weights = placed_weights(measure, net, "measure")
    return weights.solo, weights.unit


def _least(
    net: RoadNetwork,
    weight: NDArray[np.float64],
    starts: Sequence[PlacedEnd],
    ends: Sequence[PlacedEnd],
) -> NDArray[np.float64]:
    """Take of each pair of places the nodes that a trip would take."""
    length = float(net.length_m.sum())
    per_metre = ACCESS_DETOUR * float(weight.sum()) / length if length else 0.0
    sides = []
    for places in (starts, ends):
        nodes = np.array([node for place in places for node, _ in place.nodes])
        away = np.array([metres for place in places for _, metres in place.nodes])
        sides.append((nodes, away, np.cumsum([0, *(len(place.nodes) for place in places)])))
    (rows, out, row_first), (columns, into, column_first) = sides
    costs = many_to_many(net, weight, rows, columns)
    told = costs + per_metre * (out[:, None] + into)
    values = np.empty((len(starts), len(ends)))
    for i in range(len(starts)):
        for j in range(len(ends)):
            part = np.s_[row_first[i] : row_first[i + 1], column_first[j] : column_first[j + 1]]
            values[i, j] = costs[part].flat[int(np.argmin(told[part]))]
    return values


def _one_place(one: Location, other: Location) -> bool:
    return (one.lon, one.lat) == (other.lon, other.lat)
