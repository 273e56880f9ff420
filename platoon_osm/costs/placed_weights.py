"""What edges cost on a network that has places between its junctions, or beside its roads."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np

from ..network.placed import PlacedNetwork, is_beside
from ..network.road_network import RoadNetwork
from .objective import Objective, edge_weights
from .weights import EdgeWeights

__all__ = ["placed_weights"]

IN_COMPANY = ("platoon", "master", "middle", "last")
"""Weights of company: on a way beside the road nobody has any."""


def placed_weights(
    objective: Objective | EdgeWeights, net: RoadNetwork, where: str, vehicle: object = None
) -> EdgeWeights:
    """Return what edges cost on a network that may have places between its junctions.

    An objective is asked for all of them. Weights that were made for the network below are carried
    over: a piece costs its share of the edge, and a way beside the road what the same length costs
    alone on the road it leads to. In a platoon nobody saves on such a way.

    Parameters
    ----------
    objective : Objective or EdgeWeights
        Whose weights.
    net : RoadNetwork
        The network they are to be used on.
    where : str
        Who asks, for messages.
    vehicle : object
        Who drives; None for the standard vehicle.

    Returns
    -------
    EdgeWeights
        Those of this network.

    Raises
    ------
    ScenarioError
        As `edge_weights`.
    """
    if not isinstance(net, PlacedNetwork) or net.below is None:
        return edge_weights(objective, net, where, vehicle)
    way = net.below_edge < 0
    if not isinstance(objective, EdgeWeights):
        found = edge_weights(objective, net, where, vehicle)
        alone: dict[str, Any] = {
            name: np.where(way, found.solo, own)
            for name in IN_COMPANY
            if (own := getattr(found, name)) is not None
        }
        return replace(found, **alone)
    own = edge_weights(objective, net.below, where, vehicle)
    share = net.ends - net.begins
    beside = np.zeros(net.m)
    for edge in np.flatnonzero(way).tolist():
        beside[edge] = _solo_per_metre(net, own, edge) * float(net.length_m[edge])
    carried: dict[str, Any] = {
        name: np.where(way, beside, weight[net.below_edge] * share)
        for name in ("solo", *IN_COMPANY)
        if (weight := getattr(own, name)) is not None
    }
    placed = None if own.by_place is None else own.by_place.on(net)
    name = net.identity() if own.network else ""
    return replace(own, **carried, network=name, by_place=placed)


def _solo_per_metre(net: PlacedNetwork, own: EdgeWeights, edge: int) -> float:
    """Return the cost alone of a metre of the roads that a way from beside the road leads to."""
    assert net.below is not None
    tail, head = int(net.tail[edge]), int(net.head[edge])
    first = net.below.n
    node = head if is_beside(net, tail) else tail
    if node >= first:
        edges = net.place_edge[node - first : node - first + 1]
    else:
        below = net.below
        into, first_in = below.incoming()
        edges = np.concatenate(
            [
                np.arange(below.first_out[node], below.first_out[node + 1]),
                into[first_in[node] : first_in[node + 1]],
            ]
        )
    length = float(net.below.length_m[edges].sum())
    if length == 0:
        edges, length = np.arange(net.below.m), float(net.below.length_m.sum())
    return float(own.solo[edges].sum()) / length if length else 0.0
