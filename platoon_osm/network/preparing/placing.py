"""Put places on a network: cut edges where they lie, and lead ways to those beside the road."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, fields
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..columns import ROAD_CLASSES, columns_per, lengthened, shared_columns
from ..placed import PlacedNetwork
from ..road_network import RoadNetwork
from ..road_points import points_along
from ..shapes import ragged_order
from .split import SPLIT_NODE_IDS

__all__ = ["BesideRoad", "Cut", "Placing", "placing"]

Floats = NDArray[np.float64]

AT_AN_END_M = 1.0
"""A cut nearer to a node or another cut than this is there [m]."""

Cut = tuple[int, float]
"""An edge, and the share of its length before a place on it."""


@dataclass(frozen=True, slots=True)
class BesideRoad:
    """A place beside the road, and the ways from it or to it.

    Attributes
    ----------
    lon, lat : float
        The place [deg].
    leaves : bool
        Whether trips start there; else they end there. No way leads through it.
    ways : tuple of (int or Cut, float)
        Where the ways lead, a node of the network or a cut, and how long they are [m].
    speed_mps : float
        Speed on them [m/s].
    """

    lon: float
    lat: float
    leaves: bool
    ways: tuple[tuple[int | Cut, float], ...]
    speed_mps: float


@dataclass(frozen=True, slots=True, eq=False)
class Placing:
    """A network with places on it.

    Attributes
    ----------
    net : RoadNetwork
        The network with them; the one there was if all are at its nodes.
    node_of : mapping of Cut to int
        The node at each cut: one of the network below if the cut is within a metre of it.
    beside : tuple of int
        The node of each place beside the road.
    """

    net: RoadNetwork
    node_of: dict[Cut, int]
    beside: tuple[int, ...]


@dataclass(slots=True)
class _Pieces:
    """Edges that are added behind those of the network below, and what becomes of cut ones."""

    tail: list[int]
    head: list[int]
    length: list[float]
    speed: list[float]
    edge: list[int]
    begins: list[float]
    ends: list[float]
    shape: list[Floats]


def placing(net: RoadNetwork, cuts: Sequence[Cut], beside: Sequence[BesideRoad] = ()) -> Placing:
    """Put places on a network.

    Parameters
    ----------
    net : RoadNetwork
        The network; it stays what it is.
    cuts : sequence of Cut
        Where its edges are cut, in any order, repeats allowed; those that ways lead to need not
        be among them.
    beside : sequence of BesideRoad
        Places beside the road.

    Returns
    -------
    Placing
        The network with them.
    """
    wanted = set(cuts)
    wanted |= {way for place in beside for way, _ in place.ways if not isinstance(way, int)}
    by_edge: dict[int, list[float]] = {}
    for edge, share in sorted(wanted):
        by_edge.setdefault(edge, []).append(share)

    node_of: dict[Cut, int] = {}
    lon: list[float] = []
    lat: list[float] = []
    place_edge: list[int] = []
    place_share: list[float] = []
    added = _Pieces([], [], [], [], [], [], [], [])
    changed: dict[int, tuple[int, float, Floats]] = {}
    """The first piece of each cut edge, which keeps its place: head, share where it ends, shape."""

    for edge, shares in by_edge.items():
        nodes, kept = _nodes_on(net, edge, shares, net.n + len(lon))
        node_of |= {(edge, share): node for share, node in zip(shares, nodes, strict=True)}
        if not kept:
            continue
        shape = net.shape(edge)
        points, position = points_along(shape, np.array(kept))
        lon += points[:, 0].tolist()
        lat += points[:, 1].tolist()
        place_edge += [edge] * len(kept)
        place_share += kept
        first = net.n + len(lon) - len(kept)
        lines = _cut_shape(shape, points, position)
        inner = list(range(first, first + len(kept)))
        changed[edge] = inner[0], kept[0], lines[0]
        for k, tail in enumerate(inner):
            end = kept[k + 1] if k + 1 < len(kept) else 1.0
            added.tail.append(tail)
            added.head.append(inner[k + 1] if k + 1 < len(inner) else int(net.head[edge]))
            added.length.append(float(net.length_m[edge]) * (end - kept[k]))
            added.speed.append(float(net.speed_mps[edge]))
            added.edge.append(edge)
            added.begins.append(kept[k])
            added.ends.append(end)
            added.shape.append(lines[k + 1])
    stops = []
    for place in beside:
        node = net.n + len(lon)
        stops.append(node)
        lon.append(place.lon)
        lat.append(place.lat)
        place_edge.append(-1)
        place_share.append(0.0)
        for way, length_m in place.ways:
            other = way if isinstance(way, int) else node_of[way]
            k = other - net.n
            there = (lon[k], lat[k]) if k >= 0 else (float(net.lon[other]), float(net.lat[other]))
            line = np.array([(place.lon, place.lat), there])
            added.tail.append(node if place.leaves else other)
            added.head.append(other if place.leaves else node)
            added.length.append(length_m)
            added.speed.append(place.speed_mps)
            added.edge.append(-1)
            added.begins.append(0.0)
            added.ends.append(1.0)
            added.shape.append(line if place.leaves else line[::-1])
    made = _made(net, added, changed, lon, lat, place_edge, place_share) if lon else net
    return Placing(made, node_of, tuple(stops))


def _nodes_on(
    net: RoadNetwork, edge: int, shares: list[float], free: int
) -> tuple[list[int], list[float]]:
    """Return the node at each cut of an edge, and the shares where new ones are."""
    length = float(net.length_m[edge])
    nodes: list[int] = []
    kept: list[float] = []
    for share in shares:
        last = kept[-1] if kept else 0.0
        if (share - last) * length < AT_AN_END_M:
            nodes.append(free + len(kept) - 1 if kept else int(net.tail[edge]))
        elif (1.0 - share) * length < AT_AN_END_M:
            nodes.append(int(net.head[edge]))
        else:
            nodes.append(free + len(kept))
            kept.append(share)
    return nodes, kept


def _cut_shape(shape: Floats, points: Floats, position: Floats) -> list[Floats]:
    """Return the pieces of a line between its ends and the points on it."""
    every = np.arange(len(shape))
    bounds = [-1.0, *position.tolist(), float(len(shape))]
    lines = []
    for k in range(len(points) + 1):
        inside = shape[(every > bounds[k]) & (every < bounds[k + 1])]
        parts = [points[k - 1 : k] if k else shape[:0], inside, points[k : k + 1]]
        lines.append(np.vstack(parts))
    return lines


def _made(
    net: RoadNetwork,
    added: _Pieces,
    changed: dict[int, tuple[int, float, Floats]],
    lon: list[float],
    lat: list[float],
    place_edge: list[int],
    place_share: list[float],
) -> PlacedNetwork:
    new, m = len(lon), net.m
    cut = np.fromiter(changed, np.int64, len(changed))
    tail = np.concatenate([net.tail, np.array(added.tail, np.int32)])
    order = np.argsort(tail, kind="stable")
    n = net.n + new
    columns: dict[str, Any] = {
        "first_out": np.concatenate(
            [[0], np.cumsum(np.bincount(tail, minlength=n))]
        ).astype(np.int32),
        "tail": tail[order],
    }  # fmt: skip
    source = np.array(added.edge, np.int64)
    beside = source < 0
    for column in columns_per("edge"):
        if column.name in columns:
            continue
        old = getattr(net, column.name)
        values = old[source] if m else column.filled(len(source))
        # A way from beside the road is of no class, without a number or a name.
        values[beside] = column.filled(1)[0]
        columns[column.name] = np.concatenate([old, values])
    head, length = columns["head"], columns["length_m"]
    head[m:], length[m:] = added.head, added.length
    columns["speed_mps"][m:] = added.speed
    columns["posted_mps"][m:][beside] = columns["speed_mps"][m:][beside]
    columns["road_class"][m:][beside] = ROAD_CLASSES.index("other")
    head[cut] = [one[0] for one in changed.values()]
    ends = np.concatenate([np.ones(m), np.array(added.ends, np.float64)])
    ends[cut] = [one[1] for one in changed.values()]
    length[cut] *= ends[cut]
    begins = np.concatenate([np.zeros(m), np.array(added.begins, np.float64)])
    for column in shared_columns():
        values = columns[column.name]
        values[cut] *= ends[cut]
        values[m:] *= ends[m:] - begins[m:]
    for column in columns_per("edge"):
        if column.name != "tail":
            columns[column.name] = columns[column.name][order]
    lowest = int(net.node_id.min(initial=0))
    ids = min(SPLIT_NODE_IDS, lowest - 1) - np.arange(new)
    columns |= lengthened(net, "node", new, lon=lon, lat=lat, node_id=ids)
    columns |= _shapes(net, added, changed, order)
    same = {item.name: getattr(net, item.name) for item in fields(RoadNetwork) if item.init}
    return PlacedNetwork(
        **{**same, **columns, "_file": None},
        below=net,
        below_edge=np.concatenate([np.arange(m), source])[order],
        begins=begins[order],
        ends=ends[order],
        place_edge=np.array(place_edge, np.int64),
        place_share=np.array(place_share, np.float64),
    )


def _shapes(
    net: RoadNetwork,
    added: _Pieces,
    changed: dict[int, tuple[int, float, Floats]],
    order: NDArray[np.int64],
) -> dict[str, NDArray[Any]]:
    """Return the shape columns: those of the network below, then new ones, in the new order."""
    lines = [*(one[2] for one in changed.values()), *added.shape]
    fresh = np.vstack(lines)
    sizes = np.array([len(line) for line in lines], np.int64)
    # Rows of one ragged array: the old edges, then the first pieces, then what was added.
    first = np.concatenate([net.shape_first, net.shape_first[-1] + np.cumsum(sizes)])
    rows = np.arange(net.m + len(added.shape))
    rows[net.m :] += len(changed)
    for k, edge in enumerate(changed):
        rows[edge] = net.m + k
    points, shape_first = ragged_order(first, rows[order])
    return {
        "shape_first": shape_first,
        "shape_lon": np.concatenate([net.shape_lon, fresh[:, 0]])[points],
        "shape_lat": np.concatenate([net.shape_lat, fresh[:, 1]])[points],
    }
