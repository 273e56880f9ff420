"""Merge chains of edges that only pass through a node, keeping shape, length and driving time."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...errors import NetworkError
from ..columns import Column, columns_per
from ..making import in_its_type
from ..road_network import RoadNetwork, checked_network
from ..shapes import ragged_order
from .chains import Chains, contract_chains

__all__ = ["merge_chains"]

KEEP = Column("keep", "node", "b1")

SPEEDS = ("speed_mps", "posted_mps")
WORKED_OUT = frozenset({"tail", "head", *SPEEDS})
"""Columns of a chain that are no choice among those of its parts."""


def merge_chains(net: RoadNetwork, keep: NDArray[np.bool_] | None = None) -> RoadNetwork:
    """Return the network without nodes of degree two, each chain being one edge.

    Lengths, climbs and driving times add up; the shape passes all points. Road number, name, class
    and way are those of the longest part of the chain. A node stays where the toll begins or
    ends, where inferred road meets mapped road, where a restriction or another country begins,
    and where `keep` says so.

    Parameters
    ----------
    net : RoadNetwork
        The network as the map draws it.
    keep : array_like of bool, (n,), optional
        Nodes that must stay, such as named junctions.

    Returns
    -------
    RoadNetwork
        With fewer nodes and longer edges.

    Raises
    ------
    NetworkError
        `keep` does not mark nodes.
    """
    tail, head = checked_network(net).tail.astype(np.int64), net.head.astype(np.int64)
    stay = _where_values_change(net)
    if keep is not None:
        marked = in_its_type(KEEP, keep)
        if marked.shape != (net.n,):
            raise NetworkError(
                f"network: keep has shape {marked.shape}; give one for each of {net.n} nodes"
            )
        stay |= marked
    chains = contract_chains(tail, head, net.n, stay)
    starts, ends = chains.first[:-1], chains.first[1:] - 1
    new_tail, new_head = tail[chains.segments[starts]], head[chains.segments[ends]]
    used = np.zeros(net.n, bool)
    used[new_tail] = used[new_head] = True
    renumbered = np.cumsum(used) - 1
    summed = {
        column.name: _sum(getattr(net, column.name), chains)
        for column in columns_per("edge")
        if column.in_chain == "sum"
    }
    length = summed["length_m"]
    speeds = {name: _mean_speed(net, getattr(net, name), chains, length) for name in SPEEDS}
    points, shape_first = _joined_shapes(net, chains)
    longest = {
        column.name: _of_longest_part(getattr(net, column.name), net.length_m, chains)
        for column in columns_per("edge")
        if column.in_chain == "longest" and column.name not in WORKED_OUT
    }
    return net.take(
        chains.segments[starts],
        **longest,
        **{column.name: getattr(net, column.name)[used] for column in columns_per("node")},
        tail=renumbered[new_tail],
        head=renumbered[new_head],
        **summed,
        **speeds,
        shape_first=shape_first,
        shape_lon=net.shape_lon[points],
        shape_lat=net.shape_lat[points],
    )


def _sum(values: NDArray[Any], chains: Chains) -> NDArray[Any]:
    """Return the sum of each chain's parts, in the type of the parts."""
    starts = chains.first[:-1]
    if not len(starts):
        return values[:0]
    sums: NDArray[Any] = np.add.reduceat(values[chains.segments].astype(np.float64), starts)
    return sums.astype(values.dtype, copy=False)


def _mean_speed(
    net: RoadNetwork, speed: NDArray[np.float64], chains: Chains, length: NDArray[np.float64]
) -> NDArray[np.float64]:
    """Return the speed at which each chain takes as long as its parts [m/s]."""
    starts = chains.first[:-1]
    first = speed[chains.segments[starts]]
    if not len(starts):
        return first
    time = np.add.reduceat((net.length_m / speed)[chains.segments], starts)
    return np.divide(length, time, out=first.copy(), where=time > 0)


def _where_values_change(net: RoadNetwork) -> NDArray[np.bool_]:
    """Mark nodes whose edges differ in what chains keep: costs change there."""
    changes = np.zeros(net.n, bool)
    for column in columns_per("edge"):
        if column.in_chain != "same":
            continue
        values = getattr(net, column.name)
        # One value of each node's edges, whichever is written last, for the others to match.
        one = np.zeros(net.n, values.dtype)
        one[net.tail] = values
        one[net.head] = values
        for ends in (net.tail, net.head):
            changes[ends[values != one[ends]]] = True
    return changes


def _of_longest_part(
    values: NDArray[np.generic], length_m: NDArray[np.float64], chains: Chains
) -> NDArray[np.generic]:
    """Return for each chain the value that holds on most of its length."""
    starts = chains.first[:-1]
    ordered = values[chains.segments]
    result = ordered[starts]
    chain = np.repeat(np.arange(len(starts)), np.diff(chains.first))
    mixed = np.zeros(len(starts), bool)
    mixed[chain[ordered != result[chain]]] = True
    rows = np.flatnonzero(mixed[chain])
    if not len(rows):
        return result
    order = rows[np.lexsort((ordered[rows], chain[rows]))]
    key_change = np.ones(len(order), bool)
    key_change[1:] = (chain[order][1:] != chain[order][:-1]) | (
        ordered[order][1:] != ordered[order][:-1]
    )
    groups = np.flatnonzero(key_change)
    total = np.add.reduceat(length_m[chains.segments[order]], groups)
    of_chain, of_value = chain[order][groups], ordered[order][groups]
    # Sorting by length last to first leaves the longest part as the one that is written last.
    last = np.argsort(total, kind="stable")
    result[of_chain[last]] = of_value[last]
    return result


def _joined_shapes(net: RoadNetwork, chains: Chains) -> tuple[NDArray[np.int64], NDArray[np.int64]]:
    """Return the points of each chain: those of its segments without the doubled joints."""
    points, first = ragged_order(net.shape_first, chains.segments)
    keep = np.ones(len(points), bool)
    keep[first[1:] - 1] = False
    keep[first[chains.first[1:]] - 1] = True
    # Count kept points up to each chain's end.
    upto = np.concatenate([[0], np.cumsum(keep)])
    return points[keep], upto[first[chains.first]]
