"""Case D within windows: two vehicles, both routes free, exact by labels of cost and time.

With e_k, l_k, a_k the earliest and latest departure and the latest arrival of vehicle k, which
comes to the merging node x by a way of time T_k, both leave x at

    M = max(e_1 + T_1, e_2 + T_2),

for later gains nothing (`meetings.py`). The shared stretch is searched by labels (cost of both,
time), begun at every x with all pairs of ways there that none beats in both, and ended at y by the
cheapest onward way of each that is in time still: with S_k its time, t + S_k <= a_k. Cheap is not
always quick, so the ways to x and from y are sets of labels too. What costs more and takes longer
is of no use.

Where delay has a price, each pays it for when it arrives; the onward way is then that of least cost
and price together.

What a plan must pay beside a label is bounded by searches without a clock: F(z), the least that
both have paid if they are at z together; R(z), the least that both must still pay; and for one
alone the least that the other and the shared stretch cost. Labels that then exceed a limit are
dropped. It is raised in steps from the optimum without a clock to both alone, for most often the
clock costs little; a plan found below a limit is the best of all.

One shared stretch is enough for vehicles alike and free waiting, as without a clock: between a
split and a second merge both could take the cheaper way together, and would not be later. Of
equally cheap plans one is taken, always the same.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ...network.road_network import RoadNetwork
from ...search.pareto_labels import Labels, Roads, Seeds
from .meetings import PairVehicle, Side, meetings

__all__ = ["PairVehicle", "TimedPair", "plan_timed_pair"]

Edges = NDArray[np.int64]
Floats = NDArray[np.float64]

NO_CHEAPER = 1e-9
"""Company must cost less than driving alone by this share, or it is last digits that are saved."""

STEPS = (1 / 64, 1 / 8, 1.0)
"""How far from the optimum without a clock towards both alone the limit is set."""


@dataclass(frozen=True, slots=True, eq=False)
class TimedPair:
    """The best plan of two vehicles that meet in time.

    Attributes
    ----------
    cost : float
        Of both, waiting and delay included.
    before, after : tuple of ndarray of int, (2,)
        The two vehicles' edges before merging and after separating.
    shared : ndarray of int, (k,)
        Edges they drive together.
    meets_s : float
        When they can leave the merging node [s].
    waits_s : tuple of float, (2,)
        What each waits there then [s].
    labels : int
        How many labels were taken below the last limit.
    """

    cost: float
    before: tuple[Edges, Edges]
    shared: Edges
    after: tuple[Edges, Edges]
    meets_s: float
    waits_s: tuple[float, float]
    labels: int


def plan_timed_pair(
    net: RoadNetwork,
    vehicles: tuple[PairVehicle, PairVehicle],
    together: Floats,
    together_s: Floats,
    solo_cost: float,
    wait_price: float = 0.0,
) -> TimedPair | None:
    """Return the cheapest way to drive in company and in time.

    Parameters
    ----------
    net : RoadNetwork
        The network.
    vehicles : tuple of PairVehicle, (2,)
        Who drives.
    together : ndarray of float, (m,)
        What both pay together for each edge; inf where one of them may not drive.
    together_s : ndarray of float, (m,)
        How long they take together [s]; no edge takes one of them longer alone.
    solo_cost : float
        What both pay alone.
    wait_price : float
        What a second of waiting at the merging node costs.

    Returns
    -------
    TimedPair or None
        None if no company that is in time costs less than driving alone.
    """
    search = _Search(net, vehicles, together, together_s, wait_price)
    most = solo_cost * (1 - NO_CHEAPER) + search.most_gained
    least = search.blind(most)
    if least >= most:
        return None
    for share in STEPS:
        found = search.within(least + share * (most - least))
        if found is not None:
            # Where delay costs something, quicker ways apart may be best of all.
            return found if len(found.shared) else None
    return None


class _Search:
    """What the searches for all limits share."""

    def __init__(
        self,
        net: RoadNetwork,
        vehicles: tuple[PairVehicle, PairVehicle],
        together: Floats,
        together_s: Floats,
        wait_price: float,
    ) -> None:
        self.net, self.together, self.together_s = net, together, together_s
        named = [one.window.earliest for one in vehicles if one.window.earliest is not None]
        some = max(named, default=0.0)
        first, second = vehicles
        self.sides = (Side(first, some, wait_price), Side(second, some, wait_price))
        self.onward, self.back = Roads.onward(net), Roads.back(net)
        self.there_s = [
            self._least(self.onward, _open(side, side.there_s), Seeds.one(side.vehicle.origin))
            for side in self.sides
        ]
        self.rest_s = [
            self._least(self.back, _open(side, side.onward_s), Seeds.one(side.vehicle.destination))
            for side in self.sides
        ]
        self.most_gained = sum(
            side.delay_price * max(0.0, side.vehicle.alone_s - float(rest[side.vehicle.origin]))
            for side, rest in zip(self.sides, self.rest_s, strict=True)
            if side.delay_price
        )
        """What both could gain by arriving earlier than alone: limits are of costs without that."""
        self.latest = np.minimum(
            *(_less(side.last, rest) for side, rest in zip(self.sides, self.rest_s, strict=True))
        )

    def _least(
        self,
        roads: Roads,
        weight: Floats,
        seeds: Seeds,
        rest: Floats | None = None,
        limit: float = np.finfo(np.float64).max,
    ) -> Floats:
        n = self.net.n
        weights = weight, np.zeros(self.net.m)
        bound = np.zeros(n) if rest is None else rest
        return Labels.of(roads, weights, seeds, bound, np.full(n, np.inf), limit).least(n)

    def _joined(self, limit: float) -> Floats:
        """Return F, the least that both have paid where they are together."""
        one, other = (side.vehicle for side in self.sides)
        seeds = Seeds.at(one.there + other.there)
        return self._least(self.onward, self.together, seeds, None, limit)

    def blind(self, limit: float) -> float:
        """Return the least cost of company without a clock; inf if it exceeds a limit."""
        one, other = (side.vehicle for side in self.sides)
        return float((self._joined(limit) + one.rest + other.rest).min(initial=np.inf))

    def within(self, limit: float) -> TimedPair | None:
        """Return the best plan in time; None if it costs more than a limit."""
        one, other = (side.vehicle for side in self.sides)
        joined = self._joined(limit)
        left = self._least(self.back, self.together, Seeds.at(one.rest + other.rest), joined, limit)
        there = (self._ways_there(0, left, limit), self._ways_there(1, left, limit))
        met = [
            meeting
            for meeting in meetings(self.sides, there, left, limit)
            if meeting.at_s <= self.latest[meeting.node]
        ]
        shared = Labels.of(
            self.onward, (self.together, self.together_s),
            Seeds(
                np.array([meeting.node for meeting in met], np.int64),
                np.array([meeting.cost for meeting in met], np.float64),
                np.array([meeting.at_s for meeting in met], np.float64),
            ),
            left, self.latest, limit,
        )  # fmt: skip
        onward = (self._ways_on(0, joined, limit), self._ways_on(1, joined, limit))
        cost, end, ways = self._ended(shared, onward)
        if cost > limit - self.most_gained:
            return None
        edges, seed = shared.traced(end)
        meeting = met[seed]
        ready = [
            side.first + float(labels.time[way])
            for side, labels, way in zip(self.sides, there, meeting.ways, strict=True)
        ]
        waits = [side.wait_s(meeting.at_s, at) for side, at in zip(self.sides, ready, strict=True)]
        return TimedPair(
            cost,
            _both(
                labels.traced(way)[0][::-1] for labels, way in zip(there, meeting.ways, strict=True)
            ),
            np.array(edges[::-1], np.int64),
            _both(labels.traced(way)[0] for labels, way in zip(onward, ways, strict=True)),
            meeting.at_s,
            (waits[0], waits[1]),
            sum(len(labels) for labels in (*there, shared, *onward)),
        )

    def _ways_there(self, k: int, left: Floats, limit: float) -> Labels:
        """Return the ways of one vehicle to all nodes where it may meet the other."""
        side, own, other = self.sides[k], self.sides[k].vehicle, self.sides[1 - k].vehicle
        seeds = Seeds.at(other.there + left)
        rest = self._least(self.back, own.weight, seeds, own.there, limit)
        latest = _less(side.last - side.first, self.rest_s[k])
        weights = side.there_weight, side.there_s
        start = Seeds.one(own.origin)
        return Labels.of(self.onward, weights, start, rest, latest, limit, side.price)

    def _ways_on(self, k: int, joined: Floats, limit: float) -> Labels:
        """Return the ways of one vehicle from all nodes where it may leave the other."""
        side, own, other = self.sides[k], self.sides[k].vehicle, self.sides[1 - k].vehicle
        seeds = Seeds.at(joined + other.rest)
        rest = self._least(self.onward, own.weight, seeds, own.rest, limit)
        latest = _less(side.last - side.first, self.there_s[k])
        weights = own.weight, side.onward_s
        return Labels.of(self.back, weights, Seeds.one(own.destination), rest, latest, limit)

    def _ended(
        self, shared: Labels, onward: tuple[Labels, Labels]
    ) -> tuple[float, int, tuple[int, int]]:
        """Return the least cost, and the labels of shared stretch and onward ways that have it."""
        at = [labels.by_node() for labels in onward]
        best, end, ways = np.inf, -1, (-1, -1)
        for label, node in enumerate(shared.node.tolist()):
            if node not in at[0] or node not in at[1]:
                continue
            now, cost = float(shared.time[label]), float(shared.cost[label])
            chosen = []
            for side, labels, own in zip(self.sides, onward, at, strict=True):
                # The cheapest are the slowest; what is in time last of all is the quickest.
                way = next((k for k in own[node] if now + labels.time[k] <= side.last), None)
                if way is None:
                    break
                paid = float(labels.cost[way])
                if side.delay_price:
                    pays = [
                        (float(labels.cost[k]) + side.delay_cost(now + float(labels.time[k])), k)
                        for k in own[node]
                        if now + labels.time[k] <= side.last
                    ]
                    paid, way = min(pays)
                chosen.append(way)
                cost += paid
            if len(chosen) == 2 and cost < best:
                best, end, ways = cost, label, (chosen[0], chosen[1])
        return best, end, ways


def _less(moment: float, times: Floats) -> Floats:
    """Return a moment less some times; minus infinity where there is no way."""
    return np.where(np.isfinite(times), moment - np.where(np.isfinite(times), times, 0.0), -np.inf)


def _open(side: Side, times: Floats) -> Floats:
    """Return times with inf where a vehicle may not drive."""
    return np.where(np.isfinite(side.vehicle.weight), times, np.inf)


def _both(edges: Iterable[list[int]]) -> tuple[Edges, Edges]:
    first, second = (np.array(own, np.int64) for own in edges)
    return first, second
