"""A problem with its places found: what every way of answering it starts from."""

from __future__ import annotations

from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from ..costs.weights import EdgeWeights
from ..plans.clock import Clock
from ..plans.stretches import Run
from ..plans.zones import in_order
from ..search.trees import Trees
from .company.draft import Draft
from .ends import TripEnds
from .join_costs import JoinCosts, road_of
from .problem import Problem
from .routers import DijkstraRouter
from .timing.feasible import InTime
from .timing.flexibility import with_latest_arrivals
from .timing.limits import Window, allowed_windows, asked_windows

__all__ = ["NO_DEARER", "Question"]

Edges = NDArray[np.int64]
Floats = NDArray[np.float64]

NO_DEARER = 1e-9
"""Who pays this share more than alone has lost nothing but last digits."""


class Question:
    """What is known of a problem before anybody joins anybody.

    Parameters
    ----------
    problem : Problem
        What is asked.
    weights : EdgeWeights
        What edges cost.
    ends : tuple of TripEnds, (N,)
        Where vehicles go.
    trees : Trees
        Searches under the solo weight.

    Attributes
    ----------
    alone : list of ndarray of int, (N, ...)
        The route of each vehicle alone.
    lengths_m : ndarray of float, (N,)
        Their lengths [m].
    """

    def __init__(
        self, problem: Problem, weights: EdgeWeights, ends: tuple[TripEnds, ...], trees: Trees
    ) -> None:
        self.problem, self.weights, self.ends, self.trees = problem, weights, ends, trees
        self.net = problem.net
        self.router = DijkstraRouter(trees)
        self.alone = [self.router.route(item.origin, item.destination) for item in ends]
        self.lengths_m = np.array([float(self.net.length_m[own].sum()) for own in self.alone])

    @cached_property
    def solo(self) -> Floats:
        """Cost of each vehicle alone, (N,)."""
        return np.array([float(self.weights.solo[own].sum()) for own in self.alone])

    @cached_property
    def join_costs(self) -> JoinCosts:
        """What it costs to reach the routes of others."""
        roads = [road_of(self.net, own) for own in self.alone]
        return JoinCosts(self.net, self.ends, roads, self.router)

    @cached_property
    def drive_s(self) -> Floats:
        """Driving time of each edge [s], (m,)."""
        return self.net.length_m / self.net.speed_mps

    @cached_property
    def windows(self) -> list[Window] | None:
        """How far company may move each vehicle; None if nobody names a time."""
        named = [at for trip in self.problem.trips for at in trip.times.values()]
        if not named:
            return None
        alone_s = [float(self.drive_s[own].sum()) for own in self.alone]
        trips = with_latest_arrivals(self.problem.trips, alone_s)
        asked = asked_windows(trips, Clock.at(min(named, key=in_order)))
        return allowed_windows(asked, alone_s, self.problem.patience_min * 60.0)

    @cached_property
    def _in_time(self) -> InTime:
        return InTime(self.drive_s, self.windows)

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
        paid = draft.costs(self.weights)
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
