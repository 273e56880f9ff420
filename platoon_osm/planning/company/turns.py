"""Plans improve in turns: one vehicle after another plans again around what the others do.

An edge that others drive costs the vehicle w_P, less what a lone one gains there by its company;
every other edge costs w_I. A turn is taken only if the total falls, so the turns end. Where a lone
vehicle gains more than its companion pays, the edge counts as free in the search; the total is then
worked out exactly before the turn is taken.
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Sequence

import numpy as np
from numpy.typing import NDArray

from ...costs.weights import EdgeWeights
from ...network.road_network import RoadNetwork
from ...search.changing_weights import ChangingWeights
from ..fleet import Fleet
from .draft import NO_CHEAPER, Company, Draft, Order

__all__ = ["improved_in_turns"]

Allowed = Callable[[Draft], bool]
Edges = NDArray[np.int64]

MOST_ROUNDS = 20
LOOKS = 4
"""How often a turn looks at every edge that is driven."""

MOST_STEPS = 3_000_000
"""Nodes searched and edges looked at before the turns stop, about a second's work."""


def improved_in_turns(
    net: RoadNetwork,
    draft: Draft,
    fleet: Fleet,
    order: Order,
    most: int | None,
    allowed: Allowed,
    movable: Collection[int],
    ends: Sequence[tuple[int, int]],
) -> Draft:
    """Let vehicles plan again, each around the others, until nobody can improve the total.

    Parameters
    ----------
    net : RoadNetwork
        The network.
    draft : Draft
        Where to begin.
    fleet : Fleet
        What edges cost each vehicle, and where it may drive.
    order : Order
        Who leads.
    most : int or None
        Largest platoon; None for any.
    allowed : callable
        Tells whether a draft can be driven.
    movable : collection of int
        Vehicles that may change their routes.
    ends : sequence of tuple of int, (N, 2)
        Nodes where each starts and ends.

    Returns
    -------
    Draft
        Never dearer; the given one if nothing was found.
    """
    total = float(draft.costs(fleet).sum())
    slots = sum(map(len, draft.routes))
    steps = 0
    quiet = 0
    turns = [vehicle for _ in range(MOST_ROUNDS) for vehicle in sorted(movable)]
    for vehicle in turns:
        if quiet == len(movable) or steps > MOST_STEPS:
            break
        steps += net.n + LOOKS * slots
        found = _turn(net, draft, fleet, order, most, vehicle, ends[vehicle])
        quiet += 1
        for trial in found:
            new = float(trial.costs(fleet).sum())
            if new < total * (1 - NO_CHEAPER) and allowed(trial):
                draft, total, quiet = trial, new, 0
                break
    return draft


def _turn(
    net: RoadNetwork,
    draft: Draft,
    fleet: Fleet,
    order: Order,
    most: int | None,
    vehicle: int,
    ends: tuple[int, int],
) -> list[Draft]:
    """Return what a vehicle could do instead, the best first; nothing if that saves nothing."""
    rest = _without(draft, vehicle, order)
    # What others gain by its company is taken to be what it would gain itself: a turn is only
    # taken if the total, worked out exactly, falls.
    weights = fleet[vehicle]
    joins, weight = _offers(rest, weights, most)
    weight = fleet.barred(vehicle, weight)
    own = draft.routes[vehicle]
    now = sum(
        _marginal(weights, len(company) - 1, edge)
        for edge, company in zip(own.tolist(), draft.companies[vehicle], strict=True)
    )
    if now <= 0:
        return []  # no edge counts for less than nothing in a search
    searched = net.attached(ChangingWeights).search(weight, ends[0], limit=now)
    if not searched.dist[ends[1]] < now - NO_CHEAPER * abs(now):
        return []
    route = searched.path(ends[1])
    pieces = _runs_of(route, joins)
    trials = [_with(rest, vehicle, route, joins, order)]
    if len(pieces) > 1:
        # Not all at once, perhaps: each run of company by itself.
        trials += [
            _with(rest, vehicle, route, {edge: joins[edge] for edge in run}, order)
            for run in pieces
        ]
    return trials


def _marginal(weights: EdgeWeights, others: int, edge: int) -> float:
    """Return what one more vehicle adds to the total on an edge where some drive already."""
    if others < 1:
        return float(weights.solo[edge])
    if others == 1:
        return float(weights.master[edge] + weights.platoon[edge] - weights.solo[edge])
    return float(weights.platoon[edge])


def _offers(
    rest: Draft, weights: EdgeWeights, most: int | None
) -> tuple[dict[int, Company], NDArray[np.float64]]:
    """Return the company that is best to join on each edge, and what edges then cost."""
    joins: dict[int, Company] = {}
    weight = weights.solo.copy()
    for edge, there in rest.on_edges().items():
        for company in there:
            if most is not None and len(company) >= most:
                continue
            added = max(_marginal(weights, len(company), edge), 0.0)
            if added < weight[edge]:
                joins[edge], weight[edge] = company, added
    return joins, weight


def _without(draft: Draft, vehicle: int, order: Order) -> Draft:
    """Return the draft of the others; the vehicle itself drives nothing."""
    # Whole crowds name one company on each of their edges: each is told apart only once.
    known: dict[Company, Company] = {}

    def others(company: Company) -> Company:
        rest = known.get(company)
        if rest is None:
            rest = known[company] = (
                order.company(one for one in company if one != vehicle)
                if vehicle in company
                else company
            )
        return rest

    companies = [[others(company) for company in own] for own in draft.companies]
    companies[vehicle] = []
    routes = list(draft.routes)
    routes[vehicle] = np.zeros(0, np.int64)
    return Draft(tuple(routes), tuple(companies))


def _with(
    rest: Draft, vehicle: int, route: Edges, joins: dict[int, Company], order: Order
) -> Draft:
    """Return the draft in which the vehicle drives a route and joins companies on it."""
    new = {edge: order.company((*joins[edge], vehicle)) for edge in route.tolist() if edge in joins}
    companies = [list(own) for own in rest.companies]
    for one in {one for company in new.values() for one in company} - {vehicle}:
        own = companies[one]
        for at, edge in enumerate(rest.routes[one].tolist()):
            if edge in new and own[at] == joins[edge]:
                own[at] = new[edge]
    companies[vehicle] = [new.get(edge, (vehicle,)) for edge in route.tolist()]
    routes = list(rest.routes)
    routes[vehicle] = route
    return Draft(tuple(routes), tuple(companies))


def _runs_of(route: Edges, joins: dict[int, Company]) -> list[list[int]]:
    """Return the longest runs of edges on which the vehicle has company."""
    runs: list[list[int]] = [[]]
    for edge in route.tolist():
        if edge in joins:
            runs[-1].append(edge)
        elif runs[-1]:
            runs.append([])
    return [run for run in runs if run]
