"""A problem with its places found: what every way of answering it starts from."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from copy import copy
from functools import cached_property
from types import MappingProxyType
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from ..costs.time_prices import TimePrices
from ..plans.stretches import Run
from ..search.trees import Trees
from .company.draft import Draft
from .ends import TripEnds
from .fleet import Fleet
from .join_costs import JoinCosts, road_of
from .master import longest_first
from .problem import Problem
from .routers import DijkstraRouter
from .star import Star
from .timing.feasible import InTime
from .timing.least_price import least_price
from .timing.limits import NOTHING_ASKED, Window, first_named, windows_of
from .ways_in_time import WaysInTime

__all__ = ["NO_DEARER", "Question", "QuickRoute"]

Edges = NDArray[np.int64]
Floats = NDArray[np.float64]

NO_DEARER = 1e-9
"""Who pays this share more than alone has lost nothing but last digits."""


class QuickRoute(NamedTuple):
    """A route alone that is quicker than the cheapest.

    Attributes
    ----------
    route : ndarray of int, (k,)
        Its edges.
    late_s : float
        How late its vehicle would be by the cheapest [s].
    """

    route: Edges
    late_s: float


NO_QUICK: Mapping[int, QuickRoute] = MappingProxyType({})
"""All take their cheapest routes."""


class Question:
    """What is known of a problem before anybody joins anybody.

    Parameters
    ----------
    problem : Problem
        What is asked.
    fleet : Fleet
        What edges cost each vehicle, and where it may drive.
    ends : tuple of TripEnds, (N,)
        Where vehicles go.
    trees : sequence of Trees, (N,)
        Each one's searches alone; vehicles alike share theirs.
    cheapest : sequence of ndarray of int, (N, ...), optional
        The cheapest route of each alone, where they are known.
    quick : mapping of int to QuickRoute, optional
        What some take instead.

    Attributes
    ----------
    alone : list of ndarray of int, (N, ...)
        The route of each vehicle alone.
    lengths_m : ndarray of float, (N,)
        Their lengths [m].
    least : ndarray of float, (N,)
        Least cost of each alone, whatever the clock.
    quicker : dict of int to float
        Vehicles whose route alone is quicker than the cheapest, and by how much they would be late
        on that [s].
    """

    def __init__(
        self,
        problem: Problem,
        fleet: Fleet,
        ends: tuple[TripEnds, ...],
        trees: Sequence[Trees],
        cheapest: Sequence[Edges] | None = None,
        quick: Mapping[int, QuickRoute] = NO_QUICK,
    ) -> None:
        self.problem, self.fleet, self.ends, self.trees = problem, fleet, ends, trees
        self.net = problem.net
        self.routers = [DijkstraRouter(own) for own in trees]
        if cheapest is None:
            cheapest = [
                router.route(item.origin, item.destination)
                for router, item in zip(self.routers, ends, strict=True)
            ]
        self._cheapest, self._quick = cheapest, quick
        self.alone = [quick[k].route if k in quick else own for k, own in enumerate(cheapest)]
        self.lengths_m = np.array([float(self.net.length_m[own].sum()) for own in self.alone])
        self.least = np.array([float(fleet[k].solo[own].sum()) for k, own in enumerate(cheapest)])
        self.quicker = {index: one.late_s for index, one in quick.items()}

    def by_quick_routes(self, quick: Mapping[int, QuickRoute]) -> Question:
        """Return the same question with other routes alone.

        Parameters
        ----------
        quick : mapping of int to QuickRoute
            Of some vehicles by position; the others keep theirs.

        Returns
        -------
        Question
            This one if there are none.
        """
        if not quick:
            return self
        routes = {**self._quick, **quick}
        return Question(self.problem, self.fleet, self.ends, self.trees, self._cheapest, routes)

    def with_chance(self, chance: float) -> Question:
        """Return the same question for vehicles to which company saves a part of what it does.

        Parameters
        ----------
        chance : float
            How likely what company saves comes about.

        Returns
        -------
        Question
            Routes alone are the same.
        """
        fleet = self.fleet.with_chance(chance)
        return Question(self.problem, fleet, self.ends, self.trees, self._cheapest, self._quick)

    @cached_property
    def solo(self) -> Floats:
        """Cost of each vehicle alone, (N,)."""
        return np.array([float(self.fleet[k].solo[own].sum()) for k, own in enumerate(self.alone)])

    @cached_property
    def node_pairs(self) -> list[tuple[int, int]]:
        """The nodes where each vehicle starts and ends, (N, 2)."""
        return [(item.origin, item.destination) for item in self.ends]

    @cached_property
    def by_length(self) -> list[int]:
        """The vehicles by the length of their routes, the longest first."""
        return longest_first(self.lengths_m)

    @cached_property
    def fixed_master(self) -> int | None:
        """The master that the problem asks for; None if the best is to be found."""
        asked = self.problem.master
        if asked is None:
            return None
        names = [item.vehicle for item in self.ends]
        # What is no name is the rule of the longest route: Problem takes nothing else.
        return names.index(asked) if asked in names else self.by_length[0]

    @property
    def first_master(self) -> int:
        """The master that is asked for, or else that of the longest route."""
        return self.by_length[0] if self.fixed_master is None else self.fixed_master

    @cached_property
    def star_cases(self) -> tuple[str, ...]:
        """The cases with one master that are asked for, of "A", "B" and "C"."""
        return tuple(case for case in self.problem.cases if case != "D")

    def star(self, master: int) -> Star:
        """Return what it takes to join a master, by routes that are known already.

        Parameters
        ----------
        master : int
            Position in the plan.

        Returns
        -------
        Star
            All others are its members.
        """
        return Star(
            self.net, self.fleet, self.ends, master, self.routers, self.alone, self.join_costs
        )

    @cached_property
    def join_costs(self) -> JoinCosts:
        """What it costs to reach the routes of others."""
        roads = [road_of(self.net, own) for own in self.alone]
        found = JoinCosts(self.net, self.ends, roads, self.routers, self.fleet)
        for index in self.quicker:
            found.solo[index] = self.solo[index]
        return found

    @cached_property
    def windows(self) -> list[Window] | None:
        """How far company may move each vehicle; None if nobody names a time."""
        both = self._windows
        return None if both is None else both[1]

    @property
    def asked_windows(self) -> list[Window]:
        """What trips name, whatever company may do."""
        both = self._windows
        return [NOTHING_ASKED] * len(self.ends) if both is None else both[0]

    @cached_property
    def _windows(self) -> tuple[list[Window], list[Window]] | None:
        first = first_named(self.problem.trips)
        if first is None:
            return None
        patience_s = self.problem.patience_min * 60.0
        return windows_of(self.problem.trips, self.alone_s, patience_s, first)

    @cached_property
    def alone_s(self) -> list[float]:
        """Driving time of each vehicle alone [s], (N,)."""
        return [self.fleet.route_s((k,), own) for k, own in enumerate(self.alone)]

    def within(self, windows: Sequence[Window], ways: WaysInTime | None = None) -> Question:
        """Return the same question with other limits.

        Parameters
        ----------
        windows : sequence of Window, (N,)
            How far company may move each vehicle.
        ways : WaysInTime, optional
            Ways that are known already, for windows no narrower.

        Returns
        -------
        Question
            What does not depend on times is shared.
        """
        found = copy(self)
        for name in ("_in_time", "ways_in_time"):
            found.__dict__.pop(name, None)
        found.__dict__["windows"] = list(windows)
        if ways is not None:
            found.__dict__["ways_in_time"] = ways
        return found

    @cached_property
    def time_prices(self) -> TimePrices:
        """What waiting on the road and delay cost."""
        return TimePrices.of(self.problem.objective)

    @cached_property
    def ways_in_time(self) -> WaysInTime:
        """How vehicles get to the routes of others in time."""
        assert self.windows is not None
        joins = self.join_costs
        routes = [road_of(self.net, own) for own in self.alone]
        return WaysInTime(
            self.problem, self.fleet, self.ends, self.trees, self.routers, routes, joins.nodes,
            self.solo, self.windows,
        )  # fmt: skip

    @cached_property
    def _in_time(self) -> InTime:
        return InTime(self.fleet.route_s, self.windows)

    def in_time(self, draft: Draft) -> bool:
        """Tell whether a draft can be driven, each vehicle within its limits.

        Parameters
        ----------
        draft : Draft
            Who drives what with whom.

        Returns
        -------
        bool
            False too where vehicles would wait for each other in a circle.
        """
        runs: list[list[Run]] = draft.runs()
        return self._in_time(runs)

    def time_cost(self, draft: Draft) -> float:
        """Return what waiting and delay cost at least if a draft is driven.

        Parameters
        ----------
        draft : Draft
            Who drives what with whom, in time.

        Returns
        -------
        float
            0 where both are free, or nobody names a time.
        """
        if self.windows is None or self.time_prices.are_free:
            return 0.0
        runs: list[list[Run]] = draft.runs()
        return least_price(
            runs, self.fleet.route_s, self.windows, self.asked_windows, self.alone_s,
            self.time_prices,
        )  # fmt: skip

    def losers(self, draft: Draft) -> list[int]:
        """Return who pays more than alone.

        Parameters
        ----------
        draft : Draft
            Who drives what with whom.

        Returns
        -------
        list of int
            Positions in the plan.
        """
        paid = draft.costs(self.fleet)
        return np.flatnonzero(paid > self.solo * (1 + NO_DEARER)).tolist()

    def allows(self, draft: Draft) -> bool:
        """Tell whether a draft may be proposed: in time, and under "member" nobody loses.

        Parameters
        ----------
        draft : Draft
            Who drives what with whom.

        Returns
        -------
        bool
            Whether it may.
        """
        if self.problem.optimum == "member" and self.losers(draft):
            return False
        return self.in_time(draft)
