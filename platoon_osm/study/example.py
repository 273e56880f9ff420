"""One run drawn in full: who drives where, alone and in the platoon."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ..search.dijkstra import ReferenceEngine
from .monte_carlo import StudyResult
from .random_network import Draw

__all__ = ["Example", "example_of"]

Index = NDArray[np.int64]


@dataclass(frozen=True, slots=True, eq=False)
class Example:
    """Routes of one run by Dijkstra at one (tau, xi).

    Attributes
    ----------
    draw : Draw
        The network and trips.
    master : int
        Which vehicle keeps its route.
    routes : tuple of (ndarray, ndarray, ndarray)
        For each vehicle its edges before, in and after the platoon.
    longest : int
        The member that stays longest in the platoon; -1 if nobody joins.
    tau, xi : float
        For which the routes are best.
    mixing : {"printed", "gain"}
        For which the routes are best.
    """

    draw: Draw
    master: int
    routes: tuple[tuple[Index, Index, Index], ...]
    longest: int
    tau: float
    xi: float
    mixing: str


def example_of(result: StudyResult, run: int = 0) -> Example:
    """Draw a run of a study again and find its routes.

    The point is the study's first further one, or the last of its grid.

    Parameters
    ----------
    result : StudyResult
        Of any study.
    run : int
        Number of the run, from 0.

    Returns
    -------
    Example
        The run's routes.
    """
    study = result.study
    method = study.methods.index("dijkstra") if "dijkstra" in study.methods else 0
    rows, columns = study.grid_shape
    point = rows * columns if study.points else rows * columns - 1
    seed = np.random.SeedSequence(result.seed).spawn(study.runs)[run]
    draw = study.network.draw(np.random.default_rng(seed))
    net = draw.net
    engine = ReferenceEngine(net, net.length_m * study.alone_factor)
    master = int(result.master[run])
    route = engine.tree(int(draw.origins[master])).path(int(draw.destinations[master]))
    nodes = net.path_nodes(route)
    none = np.zeros(0, np.int64)
    routes = []
    merges, separations = (result.of(name, method, 0) for name in ("merge", "separation"))
    for vehicle in range(len(draw.origins)):
        start, end = int(draw.origins[vehicle]), int(draw.destinations[vehicle])
        merge = int(merges[run, vehicle, point])
        separation = int(separations[run, vehicle, point])
        if vehicle == master or merge < 0:
            alone = route if vehicle == master else engine.tree(start).path(end)
            routes.append((alone, none, none))
            continue
        i, j = (int(np.flatnonzero(nodes == at)[0]) for at in (merge, separation))
        after = engine.tree(end, forward=False).path(separation)
        routes.append((engine.tree(start).path(merge), route[i:j], after))
    together = [float(net.length_m[part].sum()) for _, part, _ in routes]
    longest = int(np.argmax(together)) if max(together) > 0 else -1
    tau, xi = study.grid_points()[point]
    return Example(draw, master, tuple(routes), longest, float(tau), float(xi), study.mixings[0])
