"""Who drives with whom, worked out once: runs of road in one company become stretches and ways.

Each vehicle's route is a list of runs, a run being edges and the company that drives them. Runs
that several vehicles share are one stretch of all of them.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

__all__ = ["Run", "linked", "runs_alone", "runs_along", "stretched"]

Edges = Sequence[int] | NDArray[np.int64]


@dataclass(frozen=True, slots=True)
class Run:
    """A longest run of edges that a vehicle drives in one company.

    Attributes
    ----------
    edges : tuple of int
        Edge ids in driving order; at least one.
    company : tuple of int
        Positions of all who drive it, in the order in which they drive.
    """

    edges: tuple[int, ...]
    company: tuple[int, ...]


def runs_along(edges: Edges, companies: Sequence[tuple[int, ...]]) -> list[Run]:
    """Cut a route where its company changes.

    Parameters
    ----------
    edges : sequence of int, (k,)
        Edge ids in driving order.
    companies : sequence of tuple of int, (k,)
        Who drives each of them.

    Returns
    -------
    list of Run
        None for a route without edges.
    """
    runs: list[Run] = []
    begin = 0
    own = edges.tolist() if isinstance(edges, np.ndarray) else list(map(int, edges))
    for at in range(1, len(own) + 1):
        if at == len(own) or companies[at] != companies[begin]:
            runs.append(Run(tuple(own[begin:at]), companies[begin]))
            begin = at
    return runs


def runs_alone(edges: Edges, vehicle: int) -> list[Run]:
    """Return a route that a vehicle drives alone.

    Parameters
    ----------
    edges : sequence of int, (k,)
        Edge ids in driving order.
    vehicle : int
        Its position.

    Returns
    -------
    list of Run
        One; none for a route without edges.
    """
    return runs_along(edges, [(vehicle,)] * len(edges))


def stretched(
    routes: Sequence[Sequence[Run]],
) -> tuple[tuple[Run, ...], tuple[tuple[int, ...], ...]]:
    """Return the stretches of a plan, each once, and the way of each vehicle over them.

    Parameters
    ----------
    routes : sequence of sequence of Run, (N, ...)
        The runs of each vehicle in driving order.

    Returns
    -------
    stretches : tuple of Run
        Vehicle by vehicle in driving order, each where it is first driven.
    ways : tuple of tuple of int, (N, ...)
        Positions in `stretches`, in driving order.
    """
    found: dict[tuple[object, ...], int] = {}
    stretches: list[Run] = []
    ways: list[tuple[int, ...]] = []
    for index, runs in enumerate(routes):
        way: list[int] = []
        seen: dict[Run, int] = {}
        for run in runs:
            # A road driven twice in one company is two stretches.
            times = seen[run] = seen.get(run, 0) + 1
            own = index if len(run.company) == 1 else -1
            key = (run.edges, frozenset(run.company), own, times)
            if key not in found:
                found[key] = len(stretches)
                stretches.append(run)
            way.append(found[key])
        ways.append(tuple(way))
    return tuple(stretches), tuple(ways)


def linked(companies: Sequence[Sequence[int]], vehicles: int) -> tuple[tuple[int, ...], ...]:
    """Return who belongs together: vehicles linked by companies they share, directly or by others.

    Parameters
    ----------
    companies : sequence of sequence of int
        Who drives each stretch.
    vehicles : int
        How many there are.

    Returns
    -------
    tuple of tuple of int
        Every vehicle once, who drives alone as a group of one; in order of their first vehicle.
    """
    above = list(range(vehicles))

    def top(index: int) -> int:
        while above[index] != index:
            above[index] = index = above[above[index]]
        return index

    for company in companies:
        # The first vehicle of a group stands for it.
        tops = {top(index) for index in company}
        first = min(tops)
        for index in tops:
            above[index] = first
    group: dict[int, list[int]] = {}
    for index in range(vehicles):
        group.setdefault(top(index), []).append(index)
    return tuple(map(tuple, group.values()))
