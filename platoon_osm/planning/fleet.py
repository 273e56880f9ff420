"""The vehicles of a plan as its searches see them: what each pays, where it may drive, how fast.

Vehicles alike share one object of each kind, so that what is worked out for one holds for all.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from copy import copy
from dataclasses import replace
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from ..costs.share import Share
from ..costs.weights import EdgeWeights
from ..network.road_network import RoadNetwork

__all__ = ["Fleet"]

Floats = NDArray[np.float64]
Marks = NDArray[np.bool_]
Edges = NDArray[np.int64]


class Fleet:
    """What each vehicle of a plan pays for an edge, which ones it may drive, and how long it takes.

    Parameters
    ----------
    weights : sequence of EdgeWeights, (N,)
        What edges cost each vehicle.
    closed : sequence of ndarray of bool, (N, m), optional
        Edges that each may not drive; None for a vehicle to which all are open.
    drive_s : sequence of ndarray of float, (N, m), optional
        How long each takes for every edge alone [s].
    why : callable, optional
        Tells why an edge is closed to a vehicle, from its position and an edge id.
    spread : float
        Share of the driving that rest adds to it in `drive_s`.

    Notes
    -----
    Vehicles that share the same objects are alike; whoever makes a fleet sees to that.
    """

    def __init__(
        self,
        weights: Sequence[EdgeWeights],
        closed: Sequence[Marks | None] | None = None,
        drive_s: Sequence[Floats] | None = None,
        why: Callable[[int, int], str] | None = None,
        spread: float = 0.0,
    ) -> None:
        self._weights = list(weights)
        self._closed = list(closed) if closed is not None else [None] * len(self._weights)
        self._drive_s = list(drive_s) if drive_s is not None else None
        self._why = why
        self._spread = spread
        self._alone: dict[int, Floats] = {}
        kinds: dict[tuple[int, int], int] = {}
        self.kind = [
            kinds.setdefault((id(own), id(shut)), len(kinds))
            for own, shut in zip(self._weights, self._closed, strict=True)
        ]
        """Which vehicles are alike in costs and closed edges, (N,): the same number for these."""

    @classmethod
    def alike(cls, net: RoadNetwork, weights: EdgeWeights, vehicles: int) -> Fleet:
        """Return a fleet of vehicles that are all alike.

        Parameters
        ----------
        net : RoadNetwork
            The network, for its speeds.
        weights : EdgeWeights
            What edges cost each of them.
        vehicles : int
            How many there are.

        Returns
        -------
        Fleet
            All edges are open to it.
        """
        own = net.length_m / net.speed_mps
        return cls([weights] * vehicles, None, [own] * vehicles)

    def with_chance(self, chance: float) -> Fleet:
        """Return a fleet for which company saves a part of what it does.

        Parameters
        ----------
        chance : float
            How likely what company saves comes about, p of solo - p (solo - platoon).

        Returns
        -------
        Fleet
            What edges cost alone, and what is closed, is the same.
        """
        part = {id(own): _in_part(own, chance) for own in self._weights}
        found = copy(self)
        found._weights = [part[id(own)] for own in self._weights]
        return found

    def __len__(self) -> int:
        return len(self._weights)

    def __getitem__(self, vehicle: int) -> EdgeWeights:
        return self._weights[vehicle]

    @property
    def is_alike(self) -> bool:
        """Whether all vehicles pay the same and may drive the same edges."""
        return len(set(self.kind)) < 2

    @cached_property
    def kinds(self) -> list[list[int]]:
        """The vehicles of each kind, in the order of their first."""
        found: list[list[int]] = [[] for _ in range(max(self.kind, default=-1) + 1)]
        for vehicle, kind in enumerate(self.kind):
            found[kind].append(vehicle)
        return found

    def alone(self, vehicle: int) -> Floats:
        """Return what edges cost a vehicle alone.

        Parameters
        ----------
        vehicle : int
            Position in the plan.

        Returns
        -------
        ndarray of float, (m,)
            Inf where it may not drive; the same array for all of one kind.
        """
        kind = self.kind[vehicle]
        if kind not in self._alone:
            self._alone[kind] = self.barred(vehicle, self._weights[vehicle].solo)
        return self._alone[kind]

    def barred(self, vehicle: int, weight: Floats) -> Floats:
        """Return a weight with inf where a vehicle may not drive.

        Parameters
        ----------
        vehicle : int
            Position in the plan.
        weight : ndarray of float, (m,)
            What edges cost.

        Returns
        -------
        ndarray of float, (m,)
            The same array if all edges are open to it.
        """
        closed = self._closed[vehicle]
        return weight if closed is None else np.where(closed, np.inf, weight)

    def closed_on(self, vehicle: int, edges: Edges) -> Marks | None:
        """Mark the edges of a route that a vehicle may not drive.

        Parameters
        ----------
        vehicle : int
            Position in the plan.
        edges : ndarray of int, (k,)
            Edge ids.

        Returns
        -------
        ndarray of bool, (k,), or None
            None if it may drive all of them.
        """
        closed = self._closed[vehicle]
        if closed is None:
            return None
        marked: Marks = closed[edges]
        return marked if marked.any() else None

    def why_closed(self, vehicle: int, edges: Edges) -> str:
        """Return why a vehicle may not drive a route.

        Parameters
        ----------
        vehicle : int
            Position in the plan.
        edges : ndarray of int, (k,)
            Edge ids.

        Returns
        -------
        str
            What closes the first edge that is closed to it; empty if none is.
        """
        closed = self.closed_on(vehicle, edges)
        if closed is None or self._why is None:
            return ""
        return self._why(vehicle, int(edges[np.argmax(closed)]))

    def drive_s(self, company: Sequence[int]) -> Floats:
        """Return how long a company takes for every edge: as long as the slowest of it.

        Parameters
        ----------
        company : sequence of int
            Positions in the plan.

        Returns
        -------
        ndarray of float, (m,)
            Seconds.
        """
        return _slowest(self._paces(company))

    def route_s(self, company: Sequence[int], edges: Sequence[int] | Edges) -> float:
        """Return how long a company takes for some edges.

        Parameters
        ----------
        company : sequence of int
            Positions in the plan.
        edges : sequence of int
            Edge ids.

        Returns
        -------
        float
            Seconds.
        """
        ids = np.asarray(edges, np.int64)
        return float(_slowest([pace[ids] for pace in self._paces(company)]).sum())

    def share(self, company: Sequence[int], place: int, edges: Edges, length_m: float) -> Share:
        """Return what one vehicle of a company pays on some edges.

        Parameters
        ----------
        company : sequence of int
            Positions in the plan, in the order in which they drive.
        place : int
            Whose share, its place in the company.
        edges : ndarray of int, (k,)
            Edge ids.
        length_m : float
            Their length [m].

        Returns
        -------
        Share
            Cost and fuel, as planned and alone.
        """
        own = self._weights[company[place]]
        if own.by_place is None or len(company) < 2:
            return own.share(edges, length_m, place, len(company))
        # Rest that is spread over the driving makes it longer, not slower.
        pace = _slowest([one[edges] for one in self._paces(company)]) / (1 + self._spread)
        return own.share(edges, length_m, place, len(company), pace)

    def _paces(self, company: Sequence[int]) -> list[Floats]:
        """Return how long the vehicles of a company take for every edge, each pace once."""
        assert self._drive_s is not None
        return list({id(one): one for one in (self._drive_s[k] for k in company)}.values())

    def least_by_position(self) -> float:
        """Return the least ratio of what a member may really pay to what is planned with.

        Returns
        -------
        float
            At most 1, which it is where places in a company do not matter.
        """
        own = {id(one): one for one in self._weights}
        return min(one.least_by_position(len(self._weights)) for one in own.values())


def _in_part(weights: EdgeWeights, chance: float) -> EdgeWeights:
    def part(array: Floats) -> Floats:
        return weights.solo - chance * (weights.solo - array)

    return replace(
        weights,
        platoon=part(weights.platoon),
        master=part(weights.master),
        middle=None if weights.middle is None else part(weights.middle),
        last=None if weights.last is None else part(weights.last),
    )


def _slowest(times: list[Floats]) -> Floats:
    return times[0] if len(times) == 1 else np.maximum.reduce(times)
