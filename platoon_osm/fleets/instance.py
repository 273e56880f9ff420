"""A fleet's problem in whole numbers: lanes, trucks, and which truck may enter which lane when.

A tick is the unit of time and a grain that of cost. A lane is a road, or a chain of roads between
two places where one may turn off, that one kind of vehicles may drive; vehicles of a kind are alike
in all that matters here, and a platoon is of one kind. Trucks that enter a lane at one instant are
a company. With Q the largest platoon, a company of n pays on a lane

    alone                                 if n = 1,
    n member + extra ceil(n / Q)          if n >= 2 (extra once if Q is not limited),

where of an odd company under Q = 2 one pays alone. `extra` is what a platoon costs beyond its
members: alone = member + extra if its leader saves nothing, extra = 0 if all save alike; what a
leader saves, alone - member - extra, is called `leader_saves` here and h in docs/fleets.md.
"""

from __future__ import annotations

from dataclasses import dataclass, fields
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..errors import ScenarioError

__all__ = ["Instance"]

Ints = NDArray[np.int64]
Marks = NDArray[np.bool_]

MOST_GRAINS = 2**52
"""Sums of costs stay whole in double precision."""


@dataclass(frozen=True, slots=True, eq=False)
class Instance:
    """The problem of a fleet of N trucks on L lanes, with the P pairs of a truck and a lane.

    A truck leaves its origin from `earliest` on, waits at any node, and is at its destination by
    `latest`. Pairs are sorted by truck, then by tail of the lane, then by lane; those of truck k
    are `first_pair[k]` to `first_pair[k + 1]`.

    Attributes
    ----------
    nodes : int
        Number of nodes.
    tail, head : ndarray of int64, (L,)
        Nodes of each lane.
    drive : ndarray of int64, (L,)
        How long each takes [ticks]; above 0.
    alone, member, extra : ndarray of int64, (L,)
        What one vehicle pays alone, each one in a platoon, and a platoon once more [grains].
    lane_kind : ndarray of int64, (L,)
        The kind of vehicles whose lane it is.
    origin, destination : ndarray of int64, (N,)
        Nodes.
    earliest, latest_departure, latest : ndarray of int64, (N,)
        Earliest and latest departure, and latest arrival [ticks].
    kind : ndarray of int64, (N,)
        The kind of each truck.
    largest : int
        Vehicles of the largest platoon; 0 for any.
    given : bool
        Whether each truck keeps one route; its pairs are then a chain.
    waiting : int
        Price of waiting on the road [grains a tick]; waiting before leaving costs nothing.
    first_pair : ndarray of int64, (N + 1,)
        Where the pairs of each truck begin.
    pair_truck, pair_lane : ndarray of int64, (P,)
        Truck and lane of each pair.
    opens, closes : ndarray of int64, (P,)
        First and last instant at which the truck may enter the lane [ticks].
    on_alone : ndarray of bool, (P,)
        Whether the lane is on the truck's cheapest route alone that is in time.
    alone_cost : ndarray of int64, (N,)
        What that route costs alone [grains].

    Raises
    ------
    ScenarioError
        Arrays that do not fit each other, or costs beyond what the bound is proved for.
    """

    nodes: int
    tail: Ints
    head: Ints
    drive: Ints
    alone: Ints
    member: Ints
    extra: Ints
    lane_kind: Ints
    origin: Ints
    destination: Ints
    earliest: Ints
    latest_departure: Ints
    latest: Ints
    kind: Ints
    largest: int
    given: bool
    waiting: int
    first_pair: Ints
    pair_truck: Ints
    pair_lane: Ints
    opens: Ints
    closes: Ints
    on_alone: Marks
    alone_cost: Ints

    def __post_init__(self) -> None:
        for own in fields(self):
            value = getattr(self, own.name)
            if isinstance(value, np.ndarray):
                dtype = np.bool_ if own.name == "on_alone" else np.int64
                frozen: NDArray[Any] = np.ascontiguousarray(value, dtype=dtype).view()
                frozen.flags.writeable = False
                object.__setattr__(self, own.name, frozen)
        self._check()

    @property
    def trucks(self) -> int:
        """How many trucks there are."""
        return len(self.origin)

    @property
    def lanes(self) -> int:
        """How many lanes there are."""
        return len(self.tail)

    @property
    def pairs(self) -> int:
        """How many pairs of a truck and a lane there are."""
        return len(self.pair_lane)

    @property
    def leader_saves(self) -> Ints:
        """What the leader of a platoon saves on each lane [grains]."""
        return self.alone - self.member - self.extra

    def _check(self) -> None:
        sizes = {
            "tail": (self.tail, self.head, self.drive, self.alone, self.member, self.extra,
                     self.lane_kind),
            "origin": (self.origin, self.destination, self.earliest, self.latest_departure,
                       self.latest, self.kind, self.alone_cost, self.first_pair[1:]),
            "pair_lane": (self.pair_lane, self.pair_truck, self.opens, self.closes,
                          self.on_alone),
        }  # fmt: skip
        for name, arrays in sizes.items():
            if len({array.shape for array in arrays}) > 1:
                raise ScenarioError(f"fleet: arrays beside {name} differ in size; make them alike")
        if (self.drive <= 0).any():
            raise ScenarioError("fleet: a lane takes no time; give each at least one tick")
        if self.largest < 0 or self.largest == 1 or self.waiting < 0:
            raise ScenarioError("fleet: largest must be 0 or 2 and more, waiting 0 or more")
        leader = self.leader_saves
        if (self.extra < 0).any() or (leader < 0).any() or (leader > self.member).any():
            raise ScenarioError(
                "fleet: on some lane a platoon costs more than driving alone, or saves more than "
                "half of it; the bound is not proved for such costs"
            )
        if int(self.alone_cost.sum()) > MOST_GRAINS:
            raise ScenarioError("fleet: costs are too large for whole numbers; use coarser grains")
