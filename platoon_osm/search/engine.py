"""One question of a network and a weight at a time: the faces of `Searches`.

Each takes the engine that is likely faster, reference or hierarchy (see `price`), keeps it with the
network, and asks it once. Who asks more takes an engine from `Searches` and hands it down.
"""

from __future__ import annotations

import sys
import time
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..network.road_network import RoadNetwork
from .arguments import checked_network, checked_nodes
from .pareto_labels import Labels, Roads, Seeds, compiled_search
from .protocol import Engine, EngineName, LeastCosts
from .searches import Searches, engine_for

__all__ = [
    "Engine", "EngineName", "LeastCosts", "Searches", "distances", "engine_for", "many_to_many",
    "one_to_many", "path", "prepare", "release", "seeded", "tree", "warm_up",
]  # fmt: skip

Floats = NDArray[np.float64]
Longs = NDArray[np.int64]


def release() -> None:
    """Give the system back what the hierarchy keeps of memory for its next results."""
    module: Any = sys.modules.get(f"{__package__}.hierarchy.runtime.lent")
    if module is not None:
        module.release()


def warm_up() -> float:
    """Compile all kernels, or load them if compiled already.

    Returns
    -------
    float
        Seconds that took.
    """
    from .hierarchy.warmth import warm_up as compile_hierarchy

    seconds = compile_hierarchy()
    begin = time.perf_counter()
    two_nodes = RoadNetwork.from_edges([0], [1], [1.0], lon=[9.0, 9.1], lat=[45.0, 45.0])
    nothing, ever = np.zeros(2), np.full(2, np.inf)
    weights = two_nodes.length_m, two_nodes.length_m
    compiled_search()
    Labels.of(Roads.onward(two_nodes), weights, Seeds.one(0), nothing, ever, 1.0)
    return seconds + time.perf_counter() - begin


def prepare(net: RoadNetwork) -> None:
    """Order and contract a network for the hierarchy, and store that beside its file.

    Parameters
    ----------
    net : RoadNetwork
        The network; one opened from a file knows it.
    """
    from .hierarchy.preparing.storage import topology_of

    topology_of(checked_network(net))


def many_to_many(
    net: RoadNetwork,
    weight: ArrayLike,
    sources: ArrayLike,
    targets: ArrayLike,
    engine: EngineName = "auto",
) -> Floats:
    """Return least costs between sources and targets.

    Parameters
    ----------
    net : RoadNetwork
        The network searched.
    weight : array_like of float, (m,)
        Cost of each edge, 0 or more; inf where closed.
    sources : array_like of int, (S,)
        Nodes where paths start.
    targets : array_like of int, (T,)
        Nodes where they end.
    engine : {"auto", "reference", "hierarchy"}
        Which engine; "auto" is the one that is likely faster.

    Returns
    -------
    ndarray of float, (S, T)
        Costs; inf where there is no way.

    Raises
    ------
    SearchError
        A weight, node or engine that is none.
    """
    checked_network(net)
    start, end = checked_nodes(net, sources), checked_nodes(net, targets)
    return engine_for(net, weight, engine, min(len(start), len(end))).many_to_many(start, end)


def one_to_many(
    net: RoadNetwork,
    weight: ArrayLike,
    source: int,
    targets: ArrayLike,
    engine: EngineName = "auto",
) -> Floats:
    """Return least costs from a source to targets.

    Parameters
    ----------
    net : RoadNetwork
        The network searched.
    weight : array_like of float, (m,)
        Cost of each edge, 0 or more; inf where closed.
    source : int
        Node where paths start.
    targets : array_like of int, (T,)
        Nodes where they end.
    engine : {"auto", "reference", "hierarchy"}
        Which engine; "auto" is the one that is likely faster.

    Returns
    -------
    ndarray of float, (T,)
        Costs; inf where there is no way.

    Raises
    ------
    SearchError
        A weight, node or engine that is none.
    """
    return engine_for(net, weight, engine).one_to_many(source, targets)


def distances(
    net: RoadNetwork,
    weight: ArrayLike,
    nodes: ArrayLike,
    forward: bool = True,
    engine: EngineName = "auto",
) -> Floats:
    """Return least costs from some nodes to all, or from all to these.

    Parameters
    ----------
    net : RoadNetwork
        The network searched.
    weight : array_like of float, (m,)
        Cost of each edge, 0 or more; inf where closed.
    nodes : array_like of int, (k,)
        Nodes searched from.
    forward : bool
        Whether paths start at the nodes; else they end there.
    engine : {"auto", "reference", "hierarchy"}
        Which engine; "auto" is the one that is likely faster.

    Returns
    -------
    ndarray of float, (k, n)
        Costs; inf where there is no way.

    Raises
    ------
    SearchError
        A weight, node or engine that is none.
    """
    checked_network(net)
    wanted = checked_nodes(net, nodes)
    return engine_for(net, weight, engine, len(wanted)).distances(wanted, forward)


def tree(
    net: RoadNetwork,
    weight: ArrayLike,
    node: int,
    forward: bool = True,
    engine: EngineName = "auto",
) -> LeastCosts:
    """Return least costs and paths from a node to all, or from all to it.

    Parameters
    ----------
    net : RoadNetwork
        The network searched.
    weight : array_like of float, (m,)
        Cost of each edge, 0 or more; inf where closed.
    node : int
        Node searched from.
    forward : bool
        Whether paths start at the node; else they end there.
    engine : {"auto", "reference", "hierarchy"}
        Which engine; "auto" is the one that is likely faster.

    Returns
    -------
    LeastCosts
        Costs of all nodes; paths are found when they are asked for.

    Raises
    ------
    SearchError
        A weight, node or engine that is none.
    """
    return engine_for(net, weight, engine).tree(node, forward)


def seeded(
    net: RoadNetwork, weight: ArrayLike, labels: ArrayLike, engine: EngineName = "auto"
) -> LeastCosts:
    """Return least costs and paths where each node may start at a cost of its own.

    Parameters
    ----------
    net : RoadNetwork
        The network searched.
    weight : array_like of float, (m,)
        Cost of each edge, 0 or more; inf where closed.
    labels : array_like of float, (n,)
        Starting costs; inf where no path may start.
    engine : {"auto", "reference", "hierarchy"}
        Which engine; "auto" is the one that is likely faster.

    Returns
    -------
    LeastCosts
        Costs of all nodes; paths are found when they are asked for.

    Raises
    ------
    SearchError
        A weight, label or engine that is none.
    """
    return engine_for(net, weight, engine, 2).seeded(labels)


def path(
    net: RoadNetwork, weight: ArrayLike, source: int, target: int, engine: EngineName = "auto"
) -> Longs:
    """Return the edges of the least-cost path, chosen as `least_paths` says.

    Parameters
    ----------
    net : RoadNetwork
        The network searched.
    weight : array_like of float, (m,)
        Cost of each edge, 0 or more; inf where closed.
    source : int
        Node where the path starts.
    target : int
        Node where it ends.
    engine : {"auto", "reference", "hierarchy"}
        Which engine; "auto" is the one that is likely faster.

    Returns
    -------
    ndarray of int, (k,)
        Edge ids in driving order.

    Raises
    ------
    NoRouteError
        If there is none.
    SearchError
        A weight, node or engine that is none.
    """
    return engine_for(net, weight, engine).path(source, target)
