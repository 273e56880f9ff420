"""Cut edges at points along them, so that roads can be joined there."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ...errors import NetworkError
from ..antimeridian import continued_deg, wrapped_deg
from ..columns import Column, lengthened, shared_columns
from ..geodesy import distance_m
from ..making import checked_edges, in_its_type
from ..road_network import RoadNetwork, checked_network
from ..shapes import ragged_order

__all__ = ["SPLIT_NODE_IDS", "split_edges"]

SPLIT_NODE_IDS = -1_000_000_000
"""Ids of nodes made here count down from this number; OpenStreetMap's own are positive."""

AT_AN_END_M = 1.0
ALONG = Column("along_m", "edge", "f8", "m")


def split_edges(
    net: RoadNetwork, edges: ArrayLike, along_m: ArrayLike
) -> tuple[RoadNetwork, NDArray[np.int64]]:
    """Cut edges at given distances from their tails.

    Parameters
    ----------
    net : RoadNetwork
        The network to cut.
    edges : array_like of int, (c,)
        Edge ids, in any order, repeats allowed.
    along_m : array_like of float, (c,)
        Distance of each cut from the edge's tail, along its shape [m].

    Returns
    -------
    network : RoadNetwork
        With new nodes and the pieces in place of the cut edges.
    nodes : ndarray of int64, (c,)
        The node at each cut; an end of the edge if the cut is within a metre of it or of another
        cut.

    Raises
    ------
    NetworkError
        Edges or distances that are none.
    """
    where = checked_edges(edges, checked_network(net).m)
    along = in_its_type(ALONG, along_m)
    if along.shape != where.shape or not np.isfinite(along).all():
        raise NetworkError(
            f"network: along_m has shape {along.shape} for {len(where)} edges; give a finite "
            "distance [m] for each"
        )
    order = np.lexsort((along, where))
    node_of_cut = np.empty(len(where), np.int64)
    lon, lat = list(net.lon), list(net.lat)
    whole = np.ones(net.m, bool)
    tails, heads, parents, shapes, lengths, shares = [], [], [], [], [], []
    for group in np.split(order, np.flatnonzero(np.diff(where[order])) + 1) if len(order) else []:
        edge = int(where[group[0]])
        shape = net.shape(edge)
        counted_on = continued_deg(shape[:, 0])
        steps = distance_m(shape[:-1, 0], shape[:-1, 1], shape[1:, 0], shape[1:, 1])
        measured = np.concatenate([[0.0], np.cumsum(steps)])
        # The edge's length is what the map says; its shape may measure a little differently.
        scale = net.length_m[edge] / measured[-1] if measured[-1] > 0 else 1.0
        tail, at, previous = int(net.tail[edge]), 0.0, shape[0]
        pieces = []
        for cut in group:
            position = min(max(along[cut], 0.0), measured[-1])
            if position - at < AT_AN_END_M:
                node_of_cut[cut] = tail
                continue
            if measured[-1] - position < AT_AN_END_M:
                node_of_cut[cut] = net.head[edge]
                continue
            crossing = np.interp(position, measured, counted_on)
            point = np.array([wrapped_deg(crossing), np.interp(position, measured, shape[:, 1])])
            node = len(lon)
            lon.append(point[0])
            lat.append(point[1])
            inner = shape[(measured > at) & (measured < position)]
            pieces.append((tail, node, np.vstack([previous, inner, point]), position - at))
            node_of_cut[cut] = tail = node
            at, previous = position, point
        if pieces:
            rest = shape[measured > at]
            pieces.append(
                (tail, int(net.head[edge]), np.vstack([previous, rest]), measured[-1] - at)
            )
            whole[edge] = False
            for piece_tail, piece_head, piece_shape, piece_length in pieces:
                tails.append(piece_tail)
                heads.append(piece_head)
                parents.append(edge)
                shapes.append(piece_shape)
                lengths.append(piece_length * scale)
                shares.append(piece_length / measured[-1])
    return _rebuilt(
        net, whole, tails, heads, parents, shapes, lengths, shares, lon, lat
    ), node_of_cut


def _new_ids(net: RoadNetwork, count: int) -> NDArray[np.int64]:
    """Return ids below all there are, so that a network cut twice has each id once."""
    lowest = int(net.node_id.min(initial=0))
    return min(SPLIT_NODE_IDS, lowest - 1) - np.arange(count)


def _rebuilt(
    net: RoadNetwork,
    whole: NDArray[np.bool_],
    tails: list[int],
    heads: list[int],
    parents: list[int],
    shapes: list[NDArray[np.float64]],
    lengths: list[float],
    shares: list[float],
    lon: list[float],
    lat: list[float],
) -> RoadNetwork:
    stays = np.flatnonzero(whole)
    origin = np.concatenate([stays, np.array(parents, np.int64)])
    points, first = ragged_order(net.shape_first, stays)
    added = np.vstack(shapes) if shapes else np.zeros((0, 2))
    sizes = np.array([len(shape) for shape in shapes], np.int64)
    new = len(lon) - net.n
    part = np.concatenate([np.ones(len(stays)), np.array(shares)])
    nodes = lengthened(
        net, "node", new, lon=lon[net.n :], lat=lat[net.n :], node_id=_new_ids(net, new)
    )
    return net.take(
        origin,
        **nodes,
        tail=np.concatenate([net.tail[stays], np.array(tails, np.int32)]),
        head=np.concatenate([net.head[stays], np.array(heads, np.int32)]),
        length_m=np.concatenate([net.length_m[stays], np.array(lengths)]),
        **{column.name: getattr(net, column.name)[origin] * part for column in shared_columns()},
        shape_first=np.concatenate([first, first[-1] + np.cumsum(sizes)]),
        shape_lon=np.concatenate([net.shape_lon[points], added[:, 0]]),
        shape_lat=np.concatenate([net.shape_lat[points], added[:, 1]]),
    )
