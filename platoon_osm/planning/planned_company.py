"""What the vehicles of one stretch of a plan save there, in any order and in any part of them.

A saving depends on the vehicle, on its place, on how many there are, and on the pace, which is that
of the slowest. Beyond the sizes that a table of savings tells by themselves, only who is first,
last or between matters. Where vehicles of more than three paces drive together, all parts of them
keep the pace of the whole.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from ..plans.bill import CENTS
from ..plans.records import Stretch
from ..sharing.coalitions import best_part, members
from ..sharing.company import CompanyGame
from ..sharing.places_in_company import values_by_place
from .fleet import Fleet

__all__ = ["PlannedCompany"]

Floats = NDArray[np.float64]
Paces = frozenset[int]

FIRST_BETWEEN_LAST = 3
"""Size of the least company that has all these places."""

MOST_PACES = 3
"""Paces of a company up to which each part of it has its own."""


class PlannedCompany:
    """The vehicles of one stretch, and what they save on it in cents.

    Parameters
    ----------
    stretch : Stretch
        Driven together.
    fleet : Fleet
        What edges of its network cost each vehicle, in money.
    """

    def __init__(self, stretch: Stretch, fleet: Fleet) -> None:
        self.vehicles = stretch.vehicles
        """Positions in the plan, in the order in which they drive."""
        self._stretch, self._fleet = stretch, fleet
        self._edges = np.asarray(stretch.edges, np.int64)
        pace: dict[int, int] = {}
        self._pace = [pace.setdefault(id(fleet.drive_s((k,))), len(pace)) for k in self.vehicles]
        # Of each pace one who has it, the slowest first: it makes a company that slow.
        one = {own: self.vehicles[k] for k, own in enumerate(self._pace)}
        self._slowest = sorted(
            one.items(), key=lambda told: -fleet.route_s((told[1],), self._edges)
        )
        self._all: Paces = frozenset(self._pace)
        self._known: dict[tuple[int, int, int, int, Paces], float] = {}

    def __len__(self) -> int:
        return len(self.vehicles)

    @property
    def as_planned(self) -> Floats:
        """What each saves as planned, (n,)."""
        return np.array([CENTS * (share.gain or 0.0) for share in self._stretch.shares])

    def game(self) -> CompanyGame:
        """Return the game in which followers save what they do as planned, wherever they are.

        Returns
        -------
        CompanyGame
            The planned leader would be second if it followed.
        """
        size = len(self)
        lead = np.array([self._saved(k, 0, size, self._all) for k in range(size)])
        follow = self.as_planned
        follow[0] = self._saved(0, 1, size, self._all)
        return CompanyGame(follow, lead)

    def best_game(self) -> CompanyGame:
        """Return a game in which each saves the most it would anywhere, as leader and as follower.

        Returns
        -------
        CompanyGame
            No coalition saves more by itself than this says. Nobody loses by company in it, for who
            would may drive alone, nor gains by leading rather than following.
        """
        size = len(self)
        lead, follow = np.zeros(size), np.zeros(size)
        for k, pace in enumerate(self._pace):
            sizes = range(2, min(size, self._told(k)) + 1)
            among = [paces for paces in self._parts_by_pace() if pace in paces]
            lead[k] = max(self._saved(k, 0, n, paces) for n in sizes for paces in among)
            follow[k] = max(
                self._saved(k, place, n, paces)
                for n in sizes
                for place in range(1, n)
                for paces in among
            )
        lead = np.maximum(lead, 0.0)
        return CompanyGame(np.maximum(follow, lead), lead)

    def values(self) -> Floats:
        """Return what every coalition of the company saves here by itself.

        Returns
        -------
        ndarray of float, (2^n,)
            Cents, as many of each driving together as saves most.
        """
        size = len(self)
        inside = members(size)
        with_pace = {
            pace: inside[:, [own == pace for own in self._pace]].any(axis=1) for pace in self._all
        }
        values = np.zeros(len(inside))
        for paces in self._parts_by_pace():
            gains = np.zeros((size, size, size))
            for n in range(2, size + 1):
                for place in range(n):
                    for k, pace in enumerate(self._pace):
                        if pace in paces:
                            gains[n - 1, place, k] = self._saved(k, place, n, paces)
            there = np.ones(len(inside), bool)
            if len(self._parts_by_pace()) > 1:
                for pace, some in with_pace.items():
                    there &= some == (pace in paces)
            values[there] = values_by_place(gains)[there]
        return best_part(values)

    def _parts_by_pace(self) -> list[Paces]:
        """Return which paces a part of the company can have."""
        if len(self._all) > MOST_PACES:
            return [self._all]
        every = sorted(self._all)
        return [
            frozenset(pace for pace in every if bits >> pace & 1)
            for bits in range(1, 1 << len(every))
        ]

    def _told(self, k: int) -> int:
        """Return the size beyond which only who is first, last or between matters to the kth."""
        by_place = self._fleet[self.vehicles[k]].by_place
        return FIRST_BETWEEN_LAST if by_place is None else max(by_place.told_sizes)

    def _saved(self, k: int, place: int, size: int, paces: Paces) -> float:
        """Return what the kth vehicle saves at a place of a company of some size and paces."""
        most = self._told(k)
        if size > most:
            place = 0 if place == 0 else most - 1 if place == size - 1 else 1
            size = most
        fleet, vehicle = self._fleet, self.vehicles[k]
        key = (id(fleet[vehicle]), self._pace[k], place, size, paces)
        if key not in self._known:
            own = self._pace[k]
            slow = [one for pace, one in self._slowest if pace in paces and pace != own]
            others = [*slow, *[vehicle] * size][: size - 1]
            company = (*others[:place], vehicle, *others[place:])
            self._known[key] = CENTS * self._gain(company, place)
        return self._known[key]

    def _gain(self, company: tuple[int, ...], place: int) -> float:
        """Return what one of a company saves on the stretch, which may begin within an edge."""
        stretch = self._stretch
        begin, end = stretch.span
        edges = self._edges
        gain = self._on(edges, company, place)
        if begin > 0:
            gain -= begin * self._on(edges[:1], company, place)
        if end < 1:
            gain -= (1 - end) * self._on(edges[-1:], company, place)
        return gain

    def _on(self, edges: NDArray[np.int64], company: tuple[int, ...], place: int) -> float:
        share = self._fleet.share(company, place, edges, 0.0)
        return share.gain or 0.0
