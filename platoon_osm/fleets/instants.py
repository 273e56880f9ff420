"""The instants that matter: where waiting is free, some best plan enters lanes at no others.

Any plan can be shifted left without parting anybody: each company starts as soon as the last of its
members is there, and nobody leaves or arrives later for it. So entries lie in the least sets that
hold, for every lane, the earliest departures of trucks that start at its tail, and the arrivals of
trucks that go on over it, at the instants at which they may have entered the lane before.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from ..errors import ScenarioError
from .instance import Instance

__all__ = ["MOST_ENTRIES", "Entries", "entries_of"]

Ints = NDArray[np.int64]

MOST_ENTRIES = 200_000
"""Beyond this many entries (truck, lane, instant) no exact model is made."""


class Entries:
    """What each truck may do: enter a lane at an instant.

    Parameters
    ----------
    truck, lane, at : ndarray of int64, (E,)
        Sorted by truck, lane and instant.
    """

    def __init__(self, truck: Ints, lane: Ints, at: Ints) -> None:
        self.truck, self.lane, self.at = truck, lane, at

    def __len__(self) -> int:
        return len(self.truck)


def entries_of(instance: Instance, most: int = MOST_ENTRIES) -> Entries | None:
    """Return all entries that matter; None if there are too many.

    Parameters
    ----------
    instance : Instance
        The problem.
    most : int
        How many there may be.

    Returns
    -------
    Entries or None
        Those that each truck can reach from its origin, and its destination from.

    Raises
    ------
    ScenarioError
        Waiting has a price: then more instants matter.
    """
    if instance.waiting:
        raise ScenarioError("fleet: the exact model takes waiting as free; use the bound instead")
    if instance.pairs > most:
        return None  # each has an entry
    by_lane: list[list[int]] = [[] for _ in range(instance.lanes)]
    for pair, lane in enumerate(instance.pair_lane.tolist()):
        by_lane[lane].append(pair)
    opens, closes = instance.opens.tolist(), instance.closes.tolist()
    lane_of, drive = instance.pair_lane.tolist(), instance.drive.tolist()
    onward, todo = _onward(instance)
    seen: list[set[int]] = [set() for _ in range(instance.lanes)]
    count = 0
    while todo:
        lane, at = todo.pop()
        if at in seen[lane]:
            continue
        seen[lane].add(at)
        for pair in by_lane[lane]:
            if opens[pair] <= at <= closes[pair]:
                count += 1
                # Whoever enters may be the last for whom others wait on its next lane.
                then = at + drive[lane]
                todo += [
                    (lane_of[after], then)
                    for after in onward[pair]
                    if opens[after] <= then <= closes[after] and then not in seen[lane_of[after]]
                ]
        if count > most:
            return None
    instants = [np.array(sorted(one), np.int64) for one in seen]
    rows = [
        (truck, lane, instants[lane][begin:end])
        for truck, lane, begin, end in (
            (
                truck, lane,
                np.searchsorted(instants[lane], opens[pair]),
                np.searchsorted(instants[lane], closes[pair], side="right"),
            )
            for pair, (truck, lane) in enumerate(
                zip(instance.pair_truck.tolist(), instance.pair_lane.tolist(), strict=True)
            )
        )
    ]  # fmt: skip
    sizes = [len(at) for *_, at in rows]
    return Entries(
        np.repeat([truck for truck, *_ in rows], sizes),
        np.repeat([lane for _, lane, _ in rows], sizes),
        np.concatenate([at for *_, at in rows]),
    )


def _onward(instance: Instance) -> tuple[list[list[int]], list[tuple[int, int]]]:
    """Return the pairs that each truck may use after each, and where and when trucks begin."""
    first = instance.first_pair.tolist()
    lanes = instance.pair_lane.tolist()
    tail, head = instance.tail.tolist(), instance.head.tolist()
    opens, closes = instance.opens.tolist(), instance.closes.tolist()
    onward: list[list[int]] = []
    begins: list[tuple[int, int]] = []
    for k, (origin, earliest) in enumerate(
        zip(instance.origin.tolist(), instance.earliest.tolist(), strict=True)
    ):
        leaving: dict[int, list[int]] = {}
        for pair in range(first[k], first[k + 1]):
            leaving.setdefault(tail[lanes[pair]], []).append(pair)
        for pair in range(first[k], first[k + 1]):
            # Nobody turns back: waiting where it is costs less.
            begun = tail[lanes[pair]]
            after = leaving.get(head[lanes[pair]], ())
            onward.append([one for one in after if head[lanes[one]] != begun])
        begins += [
            (lanes[pair], earliest)
            for pair in leaving.get(origin, ())
            if opens[pair] <= earliest <= closes[pair]
        ]
    return onward, begins
