"""From arcs back to roads: the edges of a least-cost path.

A shortcut is not stored with the node it passes. Its cost is the exact sum of two lower arcs, so
looking for the pair with that sum finds the node, and paths cost nothing until one is asked for.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from ...network.road_network import RoadNetwork
from .customization import Metric
from .runtime.jit import compiled
from .sweeping.sweeps import ancestors

__all__ = ["ascended", "path_between", "path_from_labels"]

Ints = NDArray[np.int32]
Longs = NDArray[np.int64]
Floats = NDArray[np.float64]


def path_between(
    net: RoadNetwork, weight: Floats, metric: Metric, source: int, target: int
) -> Longs | None:
    """Return the edges of a least-cost path, in driving order; None if there is none."""
    t = metric.topology
    climbed, arcs = _meet(
        int(t.rank[source]), int(t.rank[target]), t.first, t.head, t.parent, metric.up, metric.down
    )
    return None if climbed < 0 else _edges(net, weight, metric, arcs, climbed)


def ascended(metric: Metric, labels: Floats) -> tuple[Floats, Ints]:
    """Return what climbing from all labelled nodes gives each rank, and by which arc; -1 none."""
    t = metric.topology
    return _ascend_by(t.first, t.head, metric.up, labels[t.node])


def path_from_labels(
    net: RoadNetwork, weight: Floats, metric: Metric, climbed: tuple[Floats, Ints], target: int
) -> Longs:
    """Return the edges of the best path to a node from any start, as `ascended` found them."""
    t = metric.topology
    dist, by = climbed
    up, arcs = _from_above(int(t.rank[target]), t.first, t.head, t.parent, metric.down, dist, by)
    return _edges(net, weight, metric, arcs, up)


def _edges(net: RoadNetwork, weight: Floats, metric: Metric, arcs: Ints, climbed: int) -> Longs:
    t = metric.topology
    edges = _unpack(
        arcs, climbed, t.first, t.head, t.below_first, t.below, metric.up, metric.down, t.node,
        net.first_out, net.head, weight,
    )  # fmt: skip
    return _without_circles(net, edges)


def _without_circles(net: RoadNetwork, edges: Longs) -> Longs:
    """Drop what returns to a node passed before; only edges of no cost can do so."""
    nodes = net.path_nodes(edges)
    if len(np.unique(nodes)) == len(nodes):
        return edges
    last = {node: place for place, node in enumerate(nodes.tolist())}
    kept, place = [], 0
    while (place := last[int(nodes[place])]) < len(edges):
        kept.append(int(edges[place]))
        place += 1
    return np.array(kept, np.int64)


@compiled
def _climb_by(chain: Ints, first: Ints, head: Ints, climb: Floats) -> tuple[Floats, Ints, Ints]:
    """Return for each ancestor its cost, the arc that gives it, and the arc's lower end."""
    dist = np.full(len(chain), np.inf)
    by, below = np.full(len(chain), -1, np.int32), np.full(len(chain), -1, np.int32)
    dist[0] = 0.0
    for k in range(len(chain)):
        at = k
        for a in range(first[chain[k]], first[chain[k] + 1]):
            while chain[at] != head[a]:
                at += 1
            if dist[k] + climb[a] < dist[at]:
                dist[at], by[at], below[at] = dist[k] + climb[a], a, k
    return dist, by, below


@compiled
def _meet(
    source: int, target: int, first: Ints, head: Ints, parent: Ints, up: Floats, down: Floats
) -> tuple[int, Ints]:
    """Return the arcs from source to target, and how many of them climb; -1 if there are none."""
    there, back = ancestors(source, parent), ancestors(target, parent)
    dist, by, below = _climb_by(there, first, head, up)
    rest, by_rest, below_rest = _climb_by(back, first, head, down)
    # Ancestors both have in common are the last of either chain.
    best, at, common = np.inf, -1, 1
    while (
        common <= min(len(there), len(back))
        and there[len(there) - common] == back[len(back) - common]
    ):
        total = dist[len(there) - common] + rest[len(back) - common]
        if total < best:
            best, at = total, common
        common += 1
    arcs = np.empty(len(there) + len(back), np.int32)
    if at < 0:
        return -1, arcs[:0]
    count, k = 0, len(there) - at
    while by[k] >= 0:
        arcs[count] = by[k]
        count += 1
        k = below[k]
    climbed = count
    arcs[:count] = arcs[:count][::-1].copy()
    k = len(back) - at
    while by_rest[k] >= 0:
        arcs[count] = by_rest[k]
        count += 1
        k = below_rest[k]
    return climbed, arcs[:count]


@compiled
def _ascend_by(first: Ints, head: Ints, climb: Floats, dist: Floats) -> tuple[Floats, Ints]:
    by = np.full(len(dist), -1, np.int32)
    for v in range(len(dist)):
        for a in range(first[v], first[v + 1]):
            if dist[v] + climb[a] < dist[head[a]]:
                dist[head[a]] = dist[v] + climb[a]
                by[head[a]] = a
    return dist, by


@compiled
def _from_above(
    target: int, first: Ints, head: Ints, parent: Ints, down: Floats, dist: Floats, by: Ints
) -> tuple[int, Ints]:
    back = ancestors(target, parent)
    rest, by_rest, below_rest = _climb_by(back, first, head, down)
    best, at = np.inf, 0
    for k in range(len(back)):
        if dist[back[k]] + rest[k] < best:
            best, at = dist[back[k]] + rest[k], k
    climbed, v = 0, back[at]
    while by[v] >= 0:
        climbed += 1
        v = np.searchsorted(first, by[v], side="right") - 1
    arcs = np.empty(climbed + len(back), np.int32)
    count, v = climbed, back[at]
    while by[v] >= 0:
        count -= 1
        arcs[count] = by[v]
        v = np.searchsorted(first, by[v], side="right") - 1
    count, k = climbed, at
    while by_rest[k] >= 0:
        arcs[count] = by_rest[k]
        count += 1
        k = below_rest[k]
    return climbed, arcs[:count]


@compiled
def _unpack(
    arcs: Ints, climbed: int, first: Ints, head: Ints, below_first: Ints, below: Ints,
    up: Floats, down: Floats, node: Ints, first_out: Ints, net_head: Ints, weight: Floats,
) -> Longs:  # fmt: skip
    edges = np.empty(64, np.int64)
    count = 0
    # The next arc to replace lies on top; arcs that lead down are marked by their complement.
    stack = [np.int64(arcs[k] if k < climbed else ~arcs[k]) for k in range(len(arcs) - 1, -1, -1)]
    while stack:
        a = stack.pop()
        upward = a >= 0
        a = a if upward else ~a
        low, high = np.searchsorted(first, a, side="right") - 1, head[a]
        cost = up[a] if upward else down[a]
        begin, end = (node[low], node[high]) if upward else (node[high], node[low])
        edge = -1
        for e in range(first_out[begin], first_out[begin + 1]):
            if net_head[e] == end and weight[e] == cost:
                edge = e
                break
        if edge >= 0:
            if count == len(edges):
                larger = np.empty(2 * count, np.int64)
                larger[:count] = edges
                edges = larger
            edges[count] = edge
            count += 1
            continue
        for k in range(below_first[low], below_first[low + 1]):
            to_low = below[k]
            v = np.searchsorted(first, to_low, side="right") - 1
            part = head[first[v] : first[v + 1]]
            i = np.searchsorted(part, high)
            if i == len(part) or part[i] != high:
                continue
            to_high = first[v] + i
            if upward and down[to_low] + up[to_high] == cost:
                stack.append(np.int64(to_high))
                stack.append(np.int64(~to_low))
                break
            if not upward and down[to_high] + up[to_low] == cost:
                stack.append(np.int64(to_low))
                stack.append(np.int64(~to_high))
                break
    return edges[:count].copy()
