"""Where and when two vehicles can go on together, by which ways: what none beats in cost and time.

Vehicle k comes to node x by ways (c_k, T_k) from an origin that it leaves from e_k on, so it is
there from e_k + T_k. At moment M both are there at a cost of

    sum over k of min { c_k + w max(0, M - l_k - T_k) : e_k + T_k <= M },

with l_k its latest departure and w the price of a second of waiting. Only moments at which a way of
either becomes possible are of use, and of these those that cost less than all before.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ...search.pareto_labels import Labels
from .limits import Window

__all__ = ["Meeting", "PairVehicle", "Side", "meetings"]

Floats = NDArray[np.float64]

HAIR_S = 5e-7
"""Who is late by less is in time: sums of the same times in another order [s]."""


@dataclass(frozen=True, slots=True, eq=False)
class PairVehicle:
    """One of two vehicles.

    Attributes
    ----------
    origin, destination : int
        Nodes.
    weight : ndarray of float, (m,)
        Cost of each edge alone; inf where it may not drive.
    drive_s : ndarray of float, (m,)
        Driving time of each edge alone [s].
    there, rest : ndarray of float, (n,)
        Least costs alone from its origin to each node, and from each to its destination.
    window : Window
        When it may leave and arrive [s].
    alone_s : float
        How long it drives alone [s].
    delay_price : float
        What it costs to arrive a second later than alone, leaving as early as it may; of one that
        names no earliest departure, nothing.
    """

    origin: int
    destination: int
    weight: Floats
    drive_s: Floats
    there: Floats
    rest: Floats
    window: Window
    alone_s: float = 0.0
    delay_price: float = 0.0


class Side:
    """One vehicle of a pair as its labels see it.

    Parameters
    ----------
    vehicle : PairVehicle
        Who drives.
    named_s : float
        Some moment that the other may leave at; one that names no time is ready from then on [s].
    wait_price : float
        What a second of waiting costs.

    Attributes
    ----------
    first, last, leaves : float
        Its earliest departure, latest arrival and latest departure [s].
    there_s, onward_s : ndarray of float, (m,)
        How long it takes for each edge on its way to the other, and after they part [s]; 0 where it
        names nothing that this could miss.
    there_weight : ndarray of float, (m,)
        By what its ways to the other are compared: c - w T.
    price : float
        That w.
    delay_price : float
        What it costs to arrive a second later [s].
    """

    def __init__(self, vehicle: PairVehicle, named_s: float, wait_price: float) -> None:
        own, weight = vehicle.window, vehicle.weight
        self.vehicle = vehicle
        self.first = named_s if own.earliest is None else own.earliest
        self.last = math.inf if own.arrival is None else own.arrival + HAIR_S
        self.leaves = math.inf if own.latest is None else own.latest
        nothing = np.zeros(len(weight))
        self.there_s = nothing if own.earliest is None else vehicle.drive_s
        self.delay_price = 0.0 if own.earliest is None else vehicle.delay_price
        free = own.arrival is None and not self.delay_price
        self.onward_s = nothing if free else vehicle.drive_s
        self.wait_price = wait_price if math.isfinite(self.leaves) else 0.0
        self.price, self.there_weight = 0.0, weight
        if self.wait_price > 0:
            timed = np.isfinite(weight) & (self.there_s > 0)
            # No more than any second of driving costs, or circles would be cheaper than waiting.
            least = float((weight[timed] / self.there_s[timed]).min(initial=np.inf))
            self.price = min(self.wait_price, least)
            self.there_weight = np.maximum(weight - self.price * self.there_s, 0.0)

    def ways(self, labels: Labels, some: Sequence[int]) -> list[tuple[float, float, int]]:
        """Return ways to a node.

        Parameters
        ----------
        labels : Labels
            Of its ways.
        some : sequence of int
            Those that end at the node.

        Returns
        -------
        list of (float, float, int)
            When it is there [s], what that cost, and the label.
        """
        return [
            (
                self.first + float(labels.time[way]),
                float(labels.cost[way] + self.price * labels.time[way]),
                way,
            )
            for way in some
        ]

    def delay_cost(self, arrives_s: float) -> float:
        """Return what it costs to arrive at a moment.

        Parameters
        ----------
        arrives_s : float
            When [s].

        Returns
        -------
        float
            Less than nothing for who is earlier than alone.
        """
        return self.delay_price * (arrives_s - self.first - self.vehicle.alone_s)

    def wait_s(self, meets_s: float, ready_s: float) -> float:
        """Return how long it must wait where it meets the other.

        Parameters
        ----------
        meets_s, ready_s : float
            When both go on, and when it could be there [s].

        Returns
        -------
        float
            Seconds, if it leaves its origin as late as it may.
        """
        return max(0.0, meets_s - ready_s - (self.leaves - self.first))


@dataclass(frozen=True, slots=True)
class Meeting:
    """Where and when both are ready.

    Attributes
    ----------
    node : int
        Where.
    at_s : float
        When [s].
    cost : float
        What both have paid then, waiting included.
    ways : tuple of int, (2,)
        The labels of their ways.
    """

    node: int
    at_s: float
    cost: float
    ways: tuple[int, int]


def meetings(
    sides: tuple[Side, Side], there: tuple[Labels, Labels], rest: Floats, limit: float
) -> Iterator[Meeting]:
    """Yield where and when two vehicles can go on together.

    Parameters
    ----------
    sides : tuple of Side, (2,)
        Who drives.
    there : tuple of Labels, (2,)
        Ways of each.
    rest : ndarray of float, (n,)
        What both must still pay from each node.
    limit : float
        Plans that must cost more are of no interest.

    Yields
    ------
    Meeting
        At each node the earliest first, each cheaper than those before.
    """
    first, second = (labels.by_node() for labels in there)
    for node, some in first.items():
        if node not in second:
            continue
        ways = (sides[0].ways(there[0], some), sides[1].ways(there[1], second[node]))
        begin = max(min(ready for ready, _, _ in own) for own in ways)
        moments = sorted({ready for own in ways for ready, _, _ in own if ready >= begin})
        least = limit - float(rest[node])
        for at in moments:
            choice = [_cheapest(side, own, at) for side, own in zip(sides, ways, strict=True)]
            cost = choice[0][0] + choice[1][0]
            if cost <= least:
                yield Meeting(node, at, cost, (choice[0][1], choice[1][1]))
                least = math.nextafter(cost, -math.inf)


def _cheapest(side: Side, ways: list[tuple[float, float, int]], at: float) -> tuple[float, int]:
    """Return what the cheapest way that is there in time costs with its waiting, and its label."""
    return min(
        (cost + side.wait_price * side.wait_s(at, ready) if side.wait_price else cost, way)
        for ready, cost, way in ways
        if ready <= at
    )
