"""The game of a plan on its planned roads: what each group of vehicles would save there by itself.

Its players either drive as planned, each on its own road, or stay alone as if there were no plan.
On a stretch those of its company who take part drive together in their order, but for the leader,
as far as that saves: led by whomever they save most with, at the pace of the slowest of them, and
without those with whom they would save less. What a vehicle's own way costs more than driving alone
(its detour, its waiting, its delay) it pays wherever it takes part, and nobody saves that for it.
So a group T that takes part has w(T) = sum over stretches of what its members save there together,
less what their own ways cost more; and a coalition S has the best such part of itself, v(S) = max
over T in S of w(T).

Vehicles that never drive with each other, nor are linked by others, are games of their own.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ..plans.plan import Plan
from ..plans.stretches import linked
from ..sharing.coalitions import best_part, members
from .fleet import Fleet
from .planned_company import PlannedCompany

__all__ = ["RoadGame", "road_games"]

Floats = NDArray[np.float64]


@dataclass(frozen=True, slots=True, eq=False)
class RoadGame:
    """The game of vehicles that are linked by companies.

    Attributes
    ----------
    vehicles : tuple of int, (n,)
        Its players, as positions in the plan.
    companies : tuple of PlannedCompany
        Who drives with whom where.
    saved : ndarray of float, (n,)
        What each saves by the plan, its own way paid [cents].
    """

    vehicles: tuple[int, ...]
    companies: tuple[PlannedCompany, ...]
    saved: Floats

    def players(self, company: PlannedCompany) -> list[int]:
        """Return who drives in a company.

        Parameters
        ----------
        company : PlannedCompany
            One of the game.

        Returns
        -------
        list of int
            Positions in the game, in the order in which they drive.
        """
        at = {vehicle: player for player, vehicle in enumerate(self.vehicles)}
        return [at[vehicle] for vehicle in company.vehicles]

    @property
    def own_ways(self) -> Floats:
        """What each one's own way costs more than driving alone, (n,) [cents]."""
        gained = np.zeros(len(self.vehicles))
        for company in self.companies:
            gained[self.players(company)] += company.as_planned
        return gained - self.saved

    def values(self) -> Floats:
        """Return what every coalition would have by itself.

        Returns
        -------
        ndarray of float, (2^n,)
            v [cents]; for everybody what they have by the plan.
        """
        n = len(self.vehicles)
        worth = -(members(n) @ self.own_ways)
        every = np.arange(1 << n)
        for company in self.companies:
            own = np.zeros_like(every)
            for place, player in enumerate(self.players(company)):
                own |= (every >> player & 1) << place
            worth += company.values()[own]
        values = best_part(worth)
        values[-1] = self.saved.sum()
        return values


def road_games(plan: Plan, fleet: Fleet, saved: Sequence[int]) -> list[RoadGame]:
    """Return the games of a plan, one for each group of vehicles that are linked by companies.

    Parameters
    ----------
    plan : Plan
        Who drives what with whom.
    fleet : Fleet
        What edges of the plan's network cost each vehicle, in money.
    saved : sequence of int, (N,)
        What each saves by the plan [cents].

    Returns
    -------
    list of RoadGame
        Who drives alone is a game of one.
    """
    companies = [PlannedCompany(stretch, fleet) for stretch in plan.stretches if stretch.together]
    found = []
    for vehicles in linked([company.vehicles for company in companies], len(plan.trips)):
        among = set(vehicles)
        own = tuple(company for company in companies if company.vehicles[0] in among)
        found.append(RoadGame(vehicles, own, np.array([saved[one] for one in vehicles], float)))
    return found
