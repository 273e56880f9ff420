"""How the vehicles of a problem get to the routes of others and onward, at what cost and how soon.

Each end of a trip is searched once, for all routes of the problem: by cost and by time. What cannot
pay, or is late whatever follows, is left out: a way of cost c to node x can pay only if

    c + f D(x, g)  <=  D(o, g) + G,

D being least costs alone and f the least share of the cost alone that an edge costs in company.
Under the system's objective company is worth more than that to a member by what its master gains;
G is what such gains exceed the edges' costs by, most often nothing.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ..network.road_network import RoadNetwork
from ..search.protocol import Engine
from ..search.searches import engine_for
from ..search.trees import Trees
from .ends import TripEnds
from .fleet import Fleet
from .problem import Problem
from .routers import Router
from .timing.limits import Window
from .timing.pareto import SAME_S, Budget, Labels, Reach, is_cheap_quick, labels_of

__all__ = ["WaysInTime"]

Floats = NDArray[np.float64]
Longs = NDArray[np.int64]

CAN_PAY = 1 + 1e-9
"""A way is kept if it is dearer than what can pay by no more than last digits."""


@dataclass(frozen=True, slots=True, eq=False)
class _Single:
    """Where the cheapest way to each node is the quickest: costs and times at nodes of routes."""

    cost: Floats
    time_s: Floats


class WaysInTime:
    """Ways between the ends of trips and the nodes of all routes.

    Parameters
    ----------
    problem : Problem
        What is asked; its network and engine count.
    fleet : Fleet
        What edges cost each vehicle, where it may drive, and how fast.
    ends : sequence of TripEnds, (N,)
        Where vehicles go.
    trees : sequence of Trees, (N,)
        Searches by cost.
    routers : sequence of Router, (N,)
        The routes that are taken where they are quick enough.
    routes : sequence of ndarray of int, (N, ...)
        What others may join, as edges.
    nodes : sequence of ndarray of int, (N, ...)
        The nodes of these.
    solo : ndarray of float, (N,)
        Cost alone.
    windows : sequence of Window, (N,)
        Limits of each vehicle.
    """

    def __init__(
        self,
        problem: Problem,
        fleet: Fleet,
        ends: Sequence[TripEnds],
        trees: Sequence[Trees],
        routers: Sequence[Router],
        routes: Sequence[Longs],
        nodes: Sequence[Longs],
        solo: Floats,
        windows: Sequence[Window],
    ) -> None:
        self.net: RoadNetwork = problem.net
        self._engine = problem.engine
        self._system = problem.optimum == "system"
        self._fleet, self._ends, self._trees, self._routers = fleet, ends, trees, routers
        self._routes, self._solo, self._windows = routes, solo, windows
        self._nodes = np.unique(np.concatenate(nodes)) if len(nodes) else np.zeros(0, np.int64)
        self._known: dict[tuple[int, bool], _Single | Labels] = {}
        self._quick: dict[tuple[int, int], Engine] = {}
        self._paying: dict[int, tuple[float, float]] = {}

    def to(self, vehicle: int, nodes: Longs, forward: bool) -> tuple[Longs, Floats, Floats]:
        """Return the ways of a vehicle to some nodes of routes, or from them.

        Parameters
        ----------
        vehicle : int
            Position in the plan.
        nodes : ndarray of int, (k,)
            Nodes of one of the routes.
        forward : bool
            Whether ways lead from the vehicle's origin; else to its destination.

        Returns
        -------
        position : ndarray of int, (W,)
            In `nodes`, ascending.
        cost, time_s : ndarray of float, (W,)
            What each costs alone, and how long it takes [s].
        """
        found = self._of(vehicle, forward)
        if isinstance(found, Labels):
            return found.at(nodes)
        columns = np.searchsorted(self._nodes, nodes)
        cost, time_s = found.cost[columns], found.time_s[columns]
        position = np.flatnonzero(np.isfinite(cost))
        return position, cost[position], time_s[position]

    def is_complete(self, vehicle: int) -> bool:
        """Tell whether no way that counts is missing.

        Parameters
        ----------
        vehicle : int
            Position in the plan.

        Returns
        -------
        bool
            False if a search gave up.
        """
        every = (self._of(vehicle, forward) for forward in (True, False))
        return all(found.complete for found in every if isinstance(found, Labels))

    def route(self, vehicle: int, node: int, time_s: float, forward: bool) -> Longs:
        """Return the cheapest way that takes no longer.

        Parameters
        ----------
        vehicle : int
            Position in the plan.
        node : int
            Node of a route.
        time_s : float
            How long it may take [s]; that of one of the ways.
        forward : bool
            Whether it leads from the vehicle's origin; else to its destination.

        Returns
        -------
        ndarray of int, (k,)
            Edge ids in driving order: the usual route if that is quick enough.
        """
        own = self._ends[vehicle]
        pair = (own.origin, node) if forward else (node, own.destination)
        usual = self._routers[vehicle].route(*pair)
        if not self._is_asked(vehicle, forward) or (
            self._fleet.route_s((vehicle,), usual) <= time_s + SAME_S
        ):
            return usual
        found = self._of(vehicle, forward)
        if not isinstance(found, Labels):
            # Of equally cheap ways the usual one is not the quickest.
            found = self._labels(vehicle, forward)
        return found.route(node, time_s)

    def _is_asked(self, vehicle: int, forward: bool) -> bool:
        window = self._windows[vehicle]
        return (window.earliest if forward else window.arrival) is not None

    def _of(self, vehicle: int, forward: bool) -> _Single | Labels:
        key = vehicle, forward
        if key not in self._known:
            self._known[key] = self._found(vehicle, forward)
        return self._known[key]

    def _found(self, vehicle: int, forward: bool) -> _Single | Labels:
        reach = self._reach(vehicle, forward)
        budget = self._budget(vehicle, forward)
        some = budget.within(reach)
        if self._is_asked(vehicle, forward) and not is_cheap_quick(
            self.net, self._fleet.alone(vehicle), self._fleet.drive_s((vehicle,)), reach, some,
            forward,
        ):  # fmt: skip
            return self._labels(vehicle, forward)
        keep = some[self._nodes]
        return _Single(
            np.where(keep, reach.cost[self._nodes], np.inf),
            np.where(keep, reach.time_s[self._nodes], np.inf),
        )

    def _labels(self, vehicle: int, forward: bool) -> Labels:
        return labels_of(
            self.net, self._fleet.alone(vehicle), self._fleet.drive_s((vehicle,)),
            self._reach(vehicle, forward), self._budget(vehicle, forward), forward,
        )  # fmt: skip

    def _reach(self, vehicle: int, forward: bool) -> Reach:
        own = self._ends[vehicle]
        root = own.origin if forward else own.destination
        cost = self._trees[vehicle].costs([root], forward)[0]
        return Reach(root, cost, self._quickest(vehicle).distances([root], forward)[0])

    def _quickest(self, vehicle: int) -> Engine:
        """Return the searches by time of a vehicle; those alike share theirs."""
        pace = self._fleet.drive_s((vehicle,))
        key = id(pace), self._fleet.kind[vehicle]
        if key not in self._quick:
            self._quick[key] = engine_for(
                self.net, self._fleet.barred(vehicle, pace), self._engine, 2 * len(self._ends)
            )
        return self._quick[key]

    def _budget(self, vehicle: int, forward: bool) -> Budget:
        window = self._windows[vehicle]
        share, gained = self._pays(vehicle)
        most_s = np.inf
        if window.earliest is not None and window.arrival is not None:
            most_s = window.arrival - window.earliest
        most = (float(self._solo[vehicle]) + gained) * CAN_PAY
        return Budget.of(most, most_s, self._reach(vehicle, not forward), share)

    def _pays(self, vehicle: int) -> tuple[float, float]:
        """Return the least share of an edge's cost alone in company, and what can exceed it."""
        kind = self._fleet.kind[vehicle]
        if kind not in self._paying:
            own = self._fleet[vehicle]
            left = own.platoon
            gained = 0.0
            if self._system:
                firsts = [some[0] for some in self._fleet.kinds]
                gain = np.maximum.reduce(
                    [self._fleet[k].solo - self._fleet[k].master for k in firsts]
                )
                left = own.platoon - np.maximum(gain, 0.0)
                beyond = np.maximum(-left, 0.0)
                gained = max(float(beyond[route].sum()) for route in self._routes)
            paid = own.solo > 0
            share = float((left[paid] / own.solo[paid]).min(initial=1.0))
            self._paying[kind] = min(max(share, 0.0), 1.0), gained
        return self._paying[kind]
