"""One published instance planned: what it saves, and what is proved."""

from __future__ import annotations

import time
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ...errors import PlatoonError
from ...plans.fleet import gap_on_savings
from ..bound.bound import Bound
from ..companies import companies_of
from ..exact import Ways
from ..exact_process import Exact, Solver, exact_fleet
from ..instance import Instance
from ..matching import matched_pairs
from ..plan.search import FleetSearch
from .model import dutch_instance
from .records import DutchData, DutchInstance

__all__ = ["LIMIT_S", "DutchResult", "solved"]

Ints = NDArray[np.int64]

LIMIT_S = 7.5
"""The exact model is given as long [s]."""

ROUNDS, STEPS, MOVES = 6, 100, 500
"""What shares and search do where that was not enough: rounds, and steps and moves of each."""


@dataclass(frozen=True, slots=True)
class DutchResult:
    """What was found for one instance.

    Attributes
    ----------
    saving_pct, bound_pct : float
        Fuel that the plan saves against all alone, and what no plan saves more than [%].
    platoon_km_pct : float
        Kilometres driven in platoons, of all [%].
    in_platoons_pct : float
        Trucks that drive in any [%].
    seconds : float
        For model and solution [s].
    """

    saving_pct: float
    bound_pct: float
    platoon_km_pct: float
    in_platoons_pct: float
    seconds: float

    @property
    def gap_pct(self) -> float:
        """By what share of the bound more could be saved at most [%]."""
        return 100 * gap_on_savings(self.saving_pct, self.bound_pct)


def solved(
    data: DutchData,
    one: DutchInstance,
    flexibility_min: float,
    largest: int,
    per_trip: int,
    grid_min: float,
    solver: Solver,
) -> DutchResult:
    """Plan an instance as well as can be proved.

    Parameters
    ----------
    data : DutchData
        The network.
    one : DutchInstance
        The trucks.
    flexibility_min : float
        As in `dutch_instance` [min].
    largest : {2, 3}
        Vehicles of the largest platoon.
    per_trip : {0, 1}
        Platoons a trip may have; 0 for any number. With 1 only pairs are planned.
    grid_min : float
        As in `dutch_instance` [min].
    solver : Solver
        For the exact model.

    Returns
    -------
    DutchResult
        A matching is optimal; so is the exact model where its gap is 0.

    Raises
    ------
    PlatoonError
        Nothing was found in time.
    """
    begun = time.perf_counter()
    instance = dutch_instance(data, one, flexibility_min, largest, grid_min)
    if per_trip == 1:
        lanes, departs, saving = matched_pairs(instance)
        bound = saving
    else:
        found = exact_fleet(instance, LIMIT_S, solver)
        if found is None:
            raise PlatoonError(
                f"{one.name} {len(one.trucks)}, {one.number}: nothing was found in {LIMIT_S:g} s; "
                "run it on a faster machine"
            )
        (lanes, departs), saving, bound = found.ways, found.saving, found.bound
        if not found.proved:
            (lanes, departs), saving, bound = _helped(instance, found)
    seconds = time.perf_counter() - begun
    alone = int(instance.alone_cost.sum())
    share, trucks = _together(instance, lanes, departs)
    return DutchResult(
        100 * saving / alone, 100 * bound / alone, 100 * share, 100 * trucks, seconds
    )


def _helped(instance: Instance, found: Exact) -> tuple[Ways, int, int]:
    """Return the better plan and the better bound of the exact model's and a search's."""
    bound, search = Bound(instance), FleetSearch(instance)
    for place in range(ROUNDS):
        bound.improve(float(search.cost), STEPS, lambda: False)
        if place % 2 == 0:
            search.construct(bound.shares, bound.guide)
        heat = 1 - (place + 1) / ROUNDS
        search.improve(bound.shares, bound.guide, MOVES, heat, lambda: False)
    alone = int(instance.alone_cost.sum())
    most = min(found.bound, alone - bound.certified()[1])
    if alone - search.cost <= found.saving:
        return found.ways, found.saving, most
    return search.best.ways(), alone - search.cost, most


def _together(instance: Instance, lanes: list[Ints], departs: list[Ints]) -> tuple[float, float]:
    """Return the shares of kilometres in platoons, and of trucks that drive in any."""
    companies = companies_of(instance, lanes, departs)
    length = instance.alone.tolist()
    driven = together = 0
    for way, own in zip(lanes, companies, strict=True):
        for lane, company in zip(way.tolist(), own, strict=True):
            driven += length[lane]
            together += length[lane] if len(company) > 1 else 0
    in_any = sum(any(len(company) > 1 for company in own) for own in companies)
    return together / driven, in_any / instance.trucks
