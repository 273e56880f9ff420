"""Connect carriageways that meet on the ground but not in the data.

An extract of `highway=motorway` alone lacks the ramps: motorways cross at interchanges without a
common node, and carriageways end where a ramp began. Four rules put likely connectors back:

1. where two carriageways cross, a truck may go from each to the other;
2. where two pass within reach of each other and are not opposed, likewise, at the
   point where they are nearest;
3. where a carriageway ends, it goes on to those that pass within reach ahead of it, and where one
   begins, it is reached from those that pass within reach behind it;
4. where both carriageways of a road end, at the edge of the data or where the motorway becomes an
   ordinary road, a truck may leave by the one and come back by the other.

Other than that, turning back into the opposite direction is never inferred. Whether there really
is a ramp only a complete extract can tell, so every connector is marked `inferred`.
"""

from __future__ import annotations

from dataclasses import dataclass
from numbers import Real
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...errors import NetworkError
from ..columns import lengthened
from ..geodesy import bearing_deg, distance_m, metres_per_degree
from ..road_network import ROAD_CLASSES, RoadNetwork, checked_network
from .split import split_edges
from .unrolled import unrolled

__all__ = ["infer_links"]

SHARPEST_TURN_DEG = 150.0
"""A connector may turn by as much as a loop ramp does; more would be turning back."""

PASSING_TURN_DEG = 120.0
"""Carriageways that pass each other without crossing; opposite ones of one road turn more."""

END_TURN_DEG = 120.0
"""A carriageway that ends goes on roughly ahead."""

SHORTEST_RAMP_M = 300.0
"""Length given to a connector between roads that touch: that of a short ramp."""

RAMP_SPEED_MPS = 50 / 3.6

Floats = NDArray[np.float64]
Index = NDArray[np.int64]


@dataclass(frozen=True, slots=True, eq=False)
class _Segments:
    """Straight pieces of all edges, (s,) each: the edge, its two points, where it starts."""

    edge: Index
    lon1: Floats
    lat1: Floats
    lon2: Floats
    lat2: Floats
    along_m: Floats
    length_m: Floats
    bearing: Floats
    tree: Any


@dataclass(frozen=True, slots=True, eq=False)
class _Links:
    """Connectors from one point along an edge to another, (c,) each."""

    from_edge: Index
    from_m: Floats
    to_edge: Index
    to_m: Floats


def infer_links(net: RoadNetwork, reach_m: float = 200.0) -> RoadNetwork:
    """Return the network with likely connectors, marked `inferred`, and a report of them.

    Parameters
    ----------
    net : RoadNetwork
        An extract that lacks its ramps.
    reach_m : float
        How far from the end of a carriageway another may pass to be its continuation [m].

    Returns
    -------
    RoadNetwork
        With more edges, and nodes where connectors begin or end.

    Raises
    ------
    NetworkError
        `reach_m` is no distance.
    """
    proper = isinstance(reach_m, Real) and not isinstance(reach_m, bool) and 0 <= reach_m < 1e5
    if not proper:
        shown = " ".join(repr(reach_m).split())[:80]
        raise NetworkError(f"network: reach_m {shown}: give metres, from 0 to 100,000")
    plane = unrolled(checked_network(net))
    segments = _segments(plane)
    crossing = _crossings(plane, segments)
    passing = _passes(plane, segments, reach_m)
    ends = _ends(plane, segments, reach_m)
    turning = _turning_places(plane, segments, reach_m)
    links = _on_land(net, _joined(crossing, passing, ends, turning))
    cut, nodes = split_edges(
        net,
        np.concatenate([links.from_edge, links.to_edge]),
        np.concatenate([links.from_m, links.to_m]),
    )
    tails, heads = nodes[: len(links.from_edge)], nodes[len(links.from_edge) :]
    # A connector must come from somewhere and lead somewhere.
    goes_on = np.diff(cut.first_out) > 0
    is_reached = np.bincount(cut.head, minlength=cut.n) > 0
    useful = (tails != heads) & is_reached[tails] & goes_on[heads]
    pairs = np.unique(np.column_stack([tails, heads])[useful], axis=0)
    joined = _with_links(cut, pairs)
    before, after = net.connected_share(), joined.connected_share()
    return joined.with_report(
        net.load_report.extended(
            {
                "crossings of carriageways without a common node": len(crossing.from_edge) // 2,
                "carriageways that pass within reach": len(passing.from_edge) // 2,
                "carriageway ends continued within reach": len(ends.from_edge),
                "carriageway ends with a way back": len(turning.from_edge),
                "connectors inferred": len(pairs),
            },
            f"{len(pairs)} connectors were inferred, not mapped; the largest strongly connected "
            f"part now holds {after:.0%} of the carriageway-km instead of {before:.0%}",
            *_ramps_remark(net),
        )
    )


def _on_land(net: RoadNetwork, links: _Links) -> _Links:
    """Leave out connectors to ferries, which pass below bridges and along the shore."""
    ferry = net.road_class == ROAD_CLASSES.index("ferry")
    land = ~(ferry[links.from_edge] | ferry[links.to_edge])
    return _Links(links.from_edge[land], links.from_m[land], links.to_edge[land], links.to_m[land])


def _ramps_remark(net: RoadNetwork) -> tuple[str, ...]:
    """Warn where the map has ramps of its own, which connectors may bypass."""
    ramps = int((net.road_class == ROAD_CLASSES.index("motorway_link")).sum())
    if not ramps:
        return ()
    return (
        f"this map has {ramps} ramps of its own; inferred connectors may bypass them, so load it "
        "without infer_links if it connects",
    )


def _segments(net: RoadNetwork) -> _Segments:
    import shapely

    joint = np.zeros(len(net.shape_lon), bool)
    joint[net.shape_first[1:] - 1] = True
    start = np.flatnonzero(~joint)
    lon1, lat1 = net.shape_lon[start], net.shape_lat[start]
    lon2, lat2 = net.shape_lon[start + 1], net.shape_lat[start + 1]
    length = distance_m(lon1, lat1, lon2, lat2)
    edge = np.repeat(np.arange(net.m), np.diff(net.shape_first) - 1)
    upto = np.cumsum(length) - length
    first = net.shape_first[:-1] - np.arange(net.m)  # each edge has one point more than segments
    ends = np.stack([np.column_stack([lon1, lat1]), np.column_stack([lon2, lat2])], axis=1)
    lines = np.atleast_1d(np.asarray(shapely.linestrings(ends)))
    return _Segments(
        edge, lon1, lat1, lon2, lat2, upto - upto[first][edge], length,
        bearing_deg(lon1, lat1, lon2, lat2), shapely.STRtree(lines),
    )  # fmt: skip


def _turn_deg(before: Floats, after: Floats) -> Floats:
    """Return the angle [0, 180] a vehicle turns from one bearing to another."""
    return np.abs((after - before + 180) % 360 - 180)


def _crossings(net: RoadNetwork, seg: _Segments) -> _Links:
    a, b = seg.tree.query(seg.tree.geometries, predicate="intersects")
    keep = (seg.edge[a] < seg.edge[b]) & ~_share_a_node(net, seg.edge[a], seg.edge[b])
    keep &= _turn_deg(seg.bearing[a], seg.bearing[b]) < SHARPEST_TURN_DEG
    a, b = a[keep], b[keep]
    share_a, share_b = _intersection(seg, a, b)
    a_m = seg.along_m[a] + share_a * seg.length_m[a]
    b_m = seg.along_m[b] + share_b * seg.length_m[b]
    return _both_ways(seg.edge[a], a_m, seg.edge[b], b_m)


def _passes(net: RoadNetwork, seg: _Segments, reach_m: float) -> _Links:
    """Join carriageways that run side by side without crossing or sharing a node."""
    per_lon, per_lat = metres_per_degree(seg.lat1)
    dx, dy = reach_m / per_lon, reach_m / per_lat
    import shapely

    boxes = shapely.box(
        np.minimum(seg.lon1, seg.lon2) - dx, np.minimum(seg.lat1, seg.lat2) - dy,
        np.maximum(seg.lon1, seg.lon2) + dx, np.maximum(seg.lat1, seg.lat2) + dy,
    )  # fmt: skip
    a, b = seg.tree.query(boxes)
    keep = (seg.edge[a] != seg.edge[b]) & (
        _turn_deg(seg.bearing[a], seg.bearing[b]) < PASSING_TURN_DEG
    )
    a, b = a[keep], b[keep]
    a, b = (side[~_share_a_node(net, seg.edge[a], seg.edge[b])] for side in (a, b))
    # Between two segments that do not cross, an end of one of them is nearest: try each start.
    share, away = _nearest(seg, b, seg.lon1[a], seg.lat1[a])
    keep = away <= reach_m
    a, b, share, away = a[keep], b[keep], share[keep], away[keep]
    low, high = np.minimum(seg.edge[a], seg.edge[b]), np.maximum(seg.edge[a], seg.edge[b])
    order = np.lexsort((away, high, low))
    a, b, share, low, high = a[order], b[order], share[order], low[order], high[order]
    new = np.ones(len(a), bool)
    new[1:] = (low[1:] != low[:-1]) | (high[1:] != high[:-1])
    a, b, share = a[new], b[new], share[new]
    a_m, b_m = seg.along_m[a], seg.along_m[b] + share * seg.length_m[b]
    return _both_ways(seg.edge[a], a_m, seg.edge[b], b_m)


def _both_ways(one: Index, one_m: Floats, other: Index, other_m: Floats) -> _Links:
    return _Links(
        np.concatenate([one, other]), np.concatenate([one_m, other_m]),
        np.concatenate([other, one]), np.concatenate([other_m, one_m]),
    )  # fmt: skip


def _share_a_node(net: RoadNetwork, one: Index, other: Index) -> NDArray[np.bool_]:
    result: NDArray[np.bool_] = (
        (net.tail[one] == net.tail[other]) | (net.tail[one] == net.head[other])
        | (net.head[one] == net.tail[other]) | (net.head[one] == net.head[other])
    )  # fmt: skip
    return result


def _intersection(seg: _Segments, a: Index, b: Index) -> tuple[Floats, Floats]:
    """Return how far along each of two crossing segments they cross, in [0, 1]."""
    ax, ay = seg.lon2[a] - seg.lon1[a], seg.lat2[a] - seg.lat1[a]
    bx, by = seg.lon2[b] - seg.lon1[b], seg.lat2[b] - seg.lat1[b]
    cx, cy = seg.lon1[b] - seg.lon1[a], seg.lat1[b] - seg.lat1[a]
    cross = ax * by - ay * bx
    safe = np.where(cross == 0, 1.0, cross)
    share_a = np.where(cross == 0, 0.5, (cx * by - cy * bx) / safe)
    share_b = np.where(cross == 0, 0.5, (cx * ay - cy * ax) / safe)
    return np.clip(share_a, 0, 1), np.clip(share_b, 0, 1)


def _ends(net: RoadNetwork, seg: _Segments, reach_m: float) -> _Links:
    outs = np.diff(net.first_out)
    ins = np.bincount(net.head, minlength=net.n)
    parts = []
    for stops, forward in (((outs == 0) & (ins > 0), True), ((ins == 0) & (outs > 0), False)):
        ending = np.flatnonzero(stops[net.head if forward else net.tail])
        node = (net.head if forward else net.tail)[ending]
        # The last or first straight piece tells where the carriageway is heading.
        last = np.searchsorted(seg.edge, ending, "right" if forward else "left") - int(forward)
        which, near = _near(seg, net.lon[node], net.lat[node], reach_m)
        share, away = _nearest(seg, near, net.lon[node[which]], net.lat[node[which]])
        turn = _turn_deg(seg.bearing[last[which]], seg.bearing[near])
        at_node = (net.tail[seg.edge[near]] == node[which]) | (
            net.head[seg.edge[near]] == node[which]
        )
        keep = (away <= reach_m) & (turn < END_TURN_DEG) & ~at_node
        which, near, share, away = which[keep], near[keep], share[keep], away[keep]
        # One connector to each carriageway in reach: at the point that is nearest.
        order = np.lexsort((away, seg.edge[near], which))
        which, near, share = which[order], near[order], share[order]
        new = np.ones(len(which), bool)
        new[1:] = (which[1:] != which[:-1]) | (seg.edge[near][1:] != seg.edge[near][:-1])
        which, near, share = which[new], near[new], share[new]
        own_edge = ending[which]
        own_m = seg.along_m[last[which]] + (seg.length_m[last[which]] if forward else 0.0)
        other_edge = seg.edge[near]
        other_m = seg.along_m[near] + share * seg.length_m[near]
        own, other = (own_edge, own_m), (other_edge, other_m)
        parts.append(_Links(*own, *other) if forward else _Links(*other, *own))
    return _joined(*parts)


def _turning_places(net: RoadNetwork, seg: _Segments, reach_m: float) -> _Links:
    """Lead from the end of a carriageway to the nearest beginning of another."""
    from scipy.spatial import cKDTree

    outs, ins = np.diff(net.first_out), np.bincount(net.head, minlength=net.n)
    ending = np.flatnonzero(((outs == 0) & (ins > 0))[net.head])
    beginning = np.flatnonzero(((ins == 0) & (outs > 0))[net.tail])
    if not len(ending) or not len(beginning):
        return _Links(*(np.zeros(0, np.int64), np.zeros(0)) * 2)
    ends, begins = net.head[ending], net.tail[beginning]
    tree = cKDTree(_on_sphere(net.lon[begins], net.lat[begins]))
    away, nearest = tree.query(_on_sphere(net.lon[ends], net.lat[ends]))
    near = np.asarray(away) <= reach_m
    own, other = ending[near], beginning[np.asarray(nearest)[near]]
    last = np.searchsorted(seg.edge, own, "right") - 1
    return _Links(own, seg.along_m[last] + seg.length_m[last], other, np.zeros(len(other)))


def _on_sphere(lon: Floats, lat: Floats) -> Floats:
    """Points (k, 3) [m] whose straight distances are those on the ground, nearly."""
    lam, phi = np.radians(lon), np.radians(lat)
    return 6_371_000 * np.column_stack(
        [np.cos(phi) * np.cos(lam), np.cos(phi) * np.sin(lam), np.sin(phi)]
    )


def _joined(*parts: _Links) -> _Links:
    return _Links(
        *(np.concatenate([getattr(part, name) for part in parts]) for name in _Links.__slots__)
    )


def _near(seg: _Segments, lon: Floats, lat: Floats, reach_m: float) -> tuple[Index, Index]:
    """Return pairs (point, segment) whose boxes are within reach."""
    import shapely

    per_lon, per_lat = metres_per_degree(lat)
    dx, dy = reach_m / per_lon, reach_m / per_lat
    which, near = seg.tree.query(shapely.box(lon - dx, lat - dy, lon + dx, lat + dy))
    return which, near


def _nearest(seg: _Segments, near: Index, lon: Floats, lat: Floats) -> tuple[Floats, Floats]:
    """Return how far along a segment is nearest to a point, and the distance [m]."""
    per_lon, per_lat = metres_per_degree(lat)
    ax, ay = (seg.lon1[near] - lon) * per_lon, (seg.lat1[near] - lat) * per_lat
    dx = (seg.lon2[near] - seg.lon1[near]) * per_lon
    dy = (seg.lat2[near] - seg.lat1[near]) * per_lat
    square = dx**2 + dy**2
    share = np.divide(-(ax * dx + ay * dy), square, out=np.zeros_like(square), where=square > 0)
    share = np.clip(share, 0, 1)
    return share, np.hypot(ax + share * dx, ay + share * dy)


def _with_links(net: RoadNetwork, pairs: Index) -> RoadNetwork:
    """Add connectors between pairs of nodes, (c, 2)."""
    tails, heads = pairs[:, 0], pairs[:, 1]
    gap = distance_m(net.lon[tails], net.lat[tails], net.lon[heads], net.lat[heads])
    count = len(pairs)
    ends = pairs.ravel()
    edges = lengthened(
        net,
        "edge",
        count,
        tail=tails,
        head=heads,
        length_m=np.maximum(gap, SHORTEST_RAMP_M),
        speed_mps=RAMP_SPEED_MPS,
        posted_mps=RAMP_SPEED_MPS,
        road_class=ROAD_CLASSES.index("motorway_link"),
        inferred=True,
    )
    return net.with_columns(
        **edges,
        shape_first=np.concatenate(
            [net.shape_first, net.shape_first[-1] + 2 * np.arange(1, count + 1)]
        ),
        shape_lon=np.concatenate([net.shape_lon, net.lon[ends]]),
        shape_lat=np.concatenate([net.shape_lat, net.lat[ends]]),
    )
