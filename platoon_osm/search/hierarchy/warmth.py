"""Compile the kernels before they are needed, and tell whether that has been done."""

from __future__ import annotations

import time

import numpy as np

from ...network.road_network import RoadNetwork
from .engine import HierarchyEngine
from .fused import members
from .runtime.jit import lies_in_cache

__all__ = ["is_compiled", "is_warm", "warm_up"]

_state = {"warm": False}


def is_warm() -> bool:
    """Tell whether this process has loaded the kernels.

    Returns
    -------
    bool
        Whether `warm_up` has run.
    """
    return _state["warm"]


def is_compiled() -> bool:
    """Tell whether compiled kernels lie in numba's cache, so that loading them is quick.

    Returns
    -------
    bool
        Whether there is an index of them.
    """
    return lies_in_cache(members._blocks)


def warm_up() -> float:
    """Run every kernel once on a tiny network.

    Returns
    -------
    float
        Seconds that took.
    """
    begin = time.perf_counter()
    side = 3
    xs, ys = np.meshgrid(np.arange(side), np.arange(side))
    node = np.arange(side * side).reshape(side, side)
    a = np.concatenate([node[:, :-1].ravel(), node[:-1].ravel()])
    b = np.concatenate([node[:, 1:].ravel(), node[1:].ravel()])
    net = RoadNetwork.from_edges(
        np.concatenate([a, b]), np.concatenate([b, a]), np.ones(2 * len(a)),
        lon=xs.ravel() / 100, lat=ys.ravel() / 100,
    )  # fmt: skip
    engine = HierarchyEngine(net, net.length_m, threads=1)
    engine.distances(np.arange(8))
    engine.tree(0).path(8)
    engine.seeded(np.zeros(net.n)).path(8)
    engine.many_to_many([0, 1], [2, 3])
    there, onward = engine.distances([0, 1]), engine.distances([7, 8], forward=False)
    for table in (np.asfortranarray, np.ascontiguousarray):
        engine.shared_stretch(net.length_m * 1.9, list(table(there)), list(table(onward)), 1e9)
    along = np.arange(3.0)
    engine.best_on_route(node[0], node[1], node[2], along, along)
    _state["warm"] = True
    return time.perf_counter() - begin
