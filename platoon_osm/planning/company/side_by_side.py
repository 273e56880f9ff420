"""Vehicles that drive the same road at the same time are a platoon, whoever is called master.

Routes are given; only companies are formed. Where waiting is free, or the limits of time allow it,
all that drive an edge drive it together. If that cannot be for the whole plan (the limits, a
largest platoon, or a circle of vehicles that wait for each other), one vehicle after another joins
those on its way, the longest route first; then shared runs of two are joined, those that save most
first.
"""

from __future__ import annotations

from collections.abc import Callable
from itertools import combinations

import numpy as np
from numpy.typing import NDArray

from ..fleet import Fleet
from .draft import Company, Draft, Order

__all__ = ["side_by_side"]

Allowed = Callable[[Draft], bool]
Floats = NDArray[np.float64]

MOST_STEPS = 750_000
"""Edges looked at in what is tried one by one; without it a plan of hundreds would take minutes."""


def side_by_side(
    draft: Draft, fleet: Fleet, order: Order, most: int | None, allowed: Allowed
) -> Draft:
    """Count as platoons all that drive the same edges, as far as it saves and can be.

    Parameters
    ----------
    draft : Draft
        Routes and the companies there are.
    fleet : Fleet
        What edges cost each vehicle.
    order : Order
        Who leads.
    most : int or None
        Largest platoon; None for any.
    allowed : callable
        Tells whether a draft can be driven.

    Returns
    -------
    Draft
        Of the same routes, never dearer; the given one if nobody else drives side by side.
    """
    where = _positions(draft)
    # Ways beside the road cost alike in company: they are nobody's platoon.
    gain = _gain(fleet)
    shared = {
        edge: there for edge, there in draft.on_edges().items() if len(there) > 1 and gain[edge] > 0
    }
    shared = {
        edge: there
        for edge, there in shared.items()
        if all(edge in where[one] for company in there for one in company)
    }
    if not shared:
        return draft
    cost = float(draft.costs(fleet).sum())
    if most is None or all(sum(map(len, there)) <= most for there in shared.values()):
        every = _joined(draft, where, order, {
            edge: [one for company in there for one in company] for edge, there in shared.items()
        })  # fmt: skip
        if float(every.costs(fleet).sum()) < cost and allowed(every):
            return every
    tries = MOST_STEPS // max(sum(map(len, draft.routes)), 1)

    def tried(together: dict[int, list[int]]) -> None:
        nonlocal draft, cost, tries
        if not together or tries < 1:
            return
        tries -= 1
        trial = _joined(draft, where, order, together)
        new = float(trial.costs(fleet).sum())
        if new < cost and allowed(trial):
            draft, cost = trial, new

    for vehicle in sorted(range(len(where)), key=lambda one: -len(draft.routes[one])):
        if tries < 1:
            return draft
        tried(_on_its_way(draft, where, vehicle, set(shared), most))
    for first, second, edges in _runs(draft, where, gain, set(shared)):
        if tries < 1:
            return draft
        together: dict[int, list[int]] = {}
        for edge in edges:
            own, other = (_company(draft, where, one, edge) for one in (first, second))
            if own != other and (most is None or len(own) + len(other) <= most):
                together[edge] = [*own, *other]
        tried(together)
    return draft


def _gain(fleet: Fleet) -> Floats:
    """Return what two save on each edge, of unlike ones those that save most: where to look."""
    own = {fleet.kind[k]: fleet[k] for k in range(len(fleet))}
    found: Floats = np.maximum.reduce(
        [2 * weights.solo - weights.master - weights.platoon for weights in own.values()]
    )
    return found


def _on_its_way(
    draft: Draft, where: list[dict[int, int]], vehicle: int, shared: set[int], most: int | None
) -> dict[int, list[int]]:
    """Return with whom a vehicle would drive each edge if it joined the largest company there."""
    there = draft.on_edges()
    found: dict[int, list[int]] = {}
    for edge in shared & set(where[vehicle]):
        own = _company(draft, where, vehicle, edge)
        others = [
            other
            for other in there[edge]
            if other != own and (most is None or len(own) + len(other) <= most)
        ]
        if others:
            found[edge] = [*own, *max(others, key=len)]
    return found


def _positions(draft: Draft) -> list[dict[int, int]]:
    """Return where each vehicle drives each edge, leaving out edges it drives twice."""
    found = []
    for route in draft.routes:
        edges, first, times = np.unique(route, return_index=True, return_counts=True)
        once = times == 1
        found.append(dict(zip(edges[once].tolist(), first[once].tolist(), strict=True)))
    return found


def _company(draft: Draft, where: list[dict[int, int]], vehicle: int, edge: int) -> Company:
    return draft.companies[vehicle][where[vehicle][edge]]


def _joined(
    draft: Draft, where: list[dict[int, int]], order: Order, together: dict[int, list[int]]
) -> Draft:
    """Return the draft in which some vehicles are one company on some edges."""
    companies = [list(own) for own in draft.companies]
    for edge, vehicles in together.items():
        company = order.company(vehicles)
        for one in company:
            companies[one][where[one][edge]] = company
    return Draft(draft.routes, tuple(companies))


def _runs(
    draft: Draft, where: list[dict[int, int]], gain: Floats, shared: set[int]
) -> list[tuple[int, int, list[int]]]:
    """Return runs of edges that two vehicles drive and could drive together, best first."""
    pairs = {
        pair
        for edge in shared
        for pair in combinations(sorted(v for v, own in enumerate(where) if edge in own), 2)
    }
    found = []
    for first, second in sorted(pairs):
        run: list[int] = []
        last = -2
        for edge in draft.routes[first].tolist():
            here = where[second].get(edge, -2) if edge in where[first] else -2
            fits = here >= 0 and _company(draft, where, first, edge) != _company(
                draft, where, second, edge
            )
            if run and not (fits and here == last + 1):
                found.append((first, second, run))
                run = []
            if fits:
                run.append(edge)
            last = here
        if run:
            found.append((first, second, run))
    return sorted(found, key=lambda run: (-float(gain[run[2]].sum()), run))
