"""The game of a plan on its planned roads: what each group of vehicles would save there by itself.

Its players either drive as planned, each on its own road, or stay alone as if there were no plan.
On a stretch those of its company who take part drive together in their order, led by whomever they
save most with. What a vehicle's own way costs more than driving alone (its detour, its waiting, its
delay) it pays wherever it takes part, and nobody saves that for it. So a group T that takes part
has w(T) = sum over stretches of what its members save there together, less what their own ways cost
more; and a coalition S has the best such part of itself, v(S) = max over T in S of w(T).

Vehicles that never drive with each other, nor are linked by others, are games of their own.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ..costs.weights import EdgeWeights
from ..plans.plan import Plan
from ..plans.records import Stretch
from ..plans.stretches import linked
from ..sharing.coalitions import best_part, members
from ..sharing.company import CompanyGame
from ..sharing.places_in_company import values_by_place

__all__ = ["CENTS", "PlannedCompany", "RoadGame", "road_games"]

Floats = NDArray[np.float64]

CENTS = 100.0
"""In a unit of money."""

LARGEST_ASKED = 8
"""Sizes up to which places are asked for one by one, where a company is too large for all of them;
tables of savings by place know no more."""


@dataclass(frozen=True, slots=True, eq=False)
class PlannedCompany:
    """What the vehicles of one stretch save on it, in cents.

    Attributes
    ----------
    players : tuple of int, (n,)
        Its vehicles as positions in their game, in the order in which they drive.
    stretch : Stretch
        The road.
    weights : tuple of EdgeWeights, (n,)
        What edges cost each.
    """

    players: tuple[int, ...]
    stretch: Stretch
    weights: tuple[EdgeWeights, ...]

    def saved(self, place: int, size: int) -> Floats:
        """Return what each would save at one place of a company of some size.

        Parameters
        ----------
        place : int
            0 leads.
        size : int
            Vehicles in the company.

        Returns
        -------
        ndarray of float, (n,)
            Cents.
        """
        known: dict[int, float] = {}
        for own in self.weights:
            if id(own) not in known:
                known[id(own)] = CENTS * _gain(own, self.stretch, place, size)
        return np.array([known[id(own)] for own in self.weights])

    @property
    def as_planned(self) -> Floats:
        """What each saves as planned, (n,)."""
        return np.array([CENTS * (share.gain or 0.0) for share in self.stretch.shares])

    def game(self) -> CompanyGame:
        """Return the game in which followers save what they do as planned, wherever they are.

        Returns
        -------
        CompanyGame
            The planned leader would be second if it followed.
        """
        size = len(self.players)
        follow = self.as_planned
        follow[0] = self.saved(1, size)[0]
        return CompanyGame(follow, self.saved(0, size))

    def best_game(self) -> CompanyGame:
        """Return a game in which each saves the most it would anywhere, as leader and as follower.

        Returns
        -------
        CompanyGame
            No coalition saves more by itself than this says.
        """
        size = len(self.players)
        sizes = sorted({*range(2, min(size, LARGEST_ASKED) + 1), size})
        lead = np.max([self.saved(0, k) for k in sizes], axis=0)
        places = {(place, k) for k in sizes for place in range(1, min(k, LARGEST_ASKED))}
        places |= {(k - 1, k) for k in sizes}
        follow = np.max([self.saved(*one) for one in sorted(places)], axis=0)
        return CompanyGame(follow, lead)

    def values(self) -> Floats:
        """Return what every coalition of the company saves here by itself.

        Returns
        -------
        ndarray of float, (2^n,)
            Cents.
        """
        n = len(self.players)
        gains = np.zeros((n, n, n))
        for size in range(2, n + 1):
            for place in range(size):
                gains[size - 1, place] = self.saved(place, size)
        return values_by_place(gains)


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

    @property
    def own_ways(self) -> Floats:
        """What each one's own way costs more than driving alone, (n,) [cents]."""
        gained = np.zeros(len(self.vehicles))
        for company in self.companies:
            gained[list(company.players)] += company.as_planned
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
            own = sum(
                ((every >> player & 1) << place for place, player in enumerate(company.players)),
                np.zeros_like(every),
            )
            worth += company.values()[own]
        values = best_part(worth)
        values[-1] = self.saved.sum()
        return values


def road_games(plan: Plan, weights: Sequence[EdgeWeights], saved: Sequence[int]) -> list[RoadGame]:
    """Return the games of a plan, one for each group of vehicles that are linked by companies.

    Parameters
    ----------
    plan : Plan
        Who drives what with whom.
    weights : sequence of EdgeWeights, (N,)
        What edges of the plan's network cost each vehicle, in money; the same object for those
        alike.
    saved : sequence of int, (N,)
        What each saves by the plan [cents].

    Returns
    -------
    list of RoadGame
        Who drives alone is a game of one.
    """
    together = [stretch for stretch in plan.stretches if stretch.together]
    found = []
    for vehicles in linked([stretch.company for stretch in together], len(plan.trips)):
        at = {vehicle: player for player, vehicle in enumerate(vehicles)}
        companies = tuple(
            PlannedCompany(
                tuple(at[one] for one in stretch.vehicles),
                stretch,
                tuple(weights[one] for one in stretch.vehicles),
            )
            for stretch in together
            if stretch.vehicles[0] in at
        )
        own = np.array([saved[one] for one in vehicles], np.float64)
        found.append(RoadGame(vehicles, companies, own))
    return found


def _gain(weights: EdgeWeights, stretch: Stretch, place: int, size: int) -> float:
    """Return what a vehicle saves on a stretch, which may begin and end within an edge."""
    begin, end = stretch.span
    edges = stretch.edges
    gain = _saved(weights, edges, stretch.length_m, place, size)
    if begin > 0:
        gain -= begin * _saved(weights, edges[:1], 0.0, place, size)
    if end < 1:
        gain -= (1 - end) * _saved(weights, edges[-1:], 0.0, place, size)
    return gain


def _saved(
    weights: EdgeWeights, edges: tuple[int, ...], length_m: float, place: int, size: int
) -> float:
    share = weights.share(edges, length_m, place, size)
    assert share.alone_cost is not None
    return share.alone_cost - share.cost
