"""One platoon as it drives: trucks that each join it once and leave it once, while it never stops.

A platoon of one platoon a trip is a set of trucks. Each drives alone until it joins, then in
company from lane to lane without a stop, then alone again; whoever else joins or leaves meanwhile
belongs to the same platoon, so that no truck is in two. With n trucks on a lane it saves
n (alone - member) - extra there, if n >= 2.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from .instance import Instance

__all__ = ["Group", "Windows", "group_of", "passes_twice"]

Ints = NDArray[np.int64]


@dataclass(frozen=True, slots=True, eq=False)
class Group:
    """One platoon and all that its trucks drive.

    Attributes
    ----------
    trucks : tuple of int
        Ascending.
    saving : int
        What they save against all of them alone [grains].
    lanes, departs : tuple of ndarray of int64
        Lanes of each in driving order, and when it enters them [ticks].
    begins, ends : tuple of int
        Which lane of each is its first in company, and which its first alone again.
    slack : int
        By how much all of them may be later [ticks].
    """

    trucks: tuple[int, ...]
    saving: int
    lanes: tuple[Ints, ...]
    departs: tuple[Ints, ...]
    begins: tuple[int, ...]
    ends: tuple[int, ...]
    slack: int


class Windows:
    """When trucks may enter lanes.

    Parameters
    ----------
    instance : Instance
        The problem.
    """

    def __init__(self, instance: Instance) -> None:
        key = instance.pair_truck * instance.lanes + instance.pair_lane
        self._order = np.argsort(key, kind="stable")
        self._key = key[self._order]
        self._lanes, self._closes = instance.lanes, instance.closes

    def closes(self, truck: int, lanes: Ints) -> Ints:
        """Return until when a truck may enter some of its lanes.

        Parameters
        ----------
        truck : int
            Which.
        lanes : ndarray of int64
            Each a lane of the truck.

        Returns
        -------
        ndarray of int64
            The last instants [ticks].
        """
        at = np.searchsorted(self._key, truck * self._lanes + lanes)
        found: Ints = self._closes[self._order[at]]
        return found


def group_of(
    instance: Instance,
    windows: Windows,
    trucks: Sequence[int],
    lanes: Sequence[Ints],
    departs: Sequence[Ints],
) -> Group | None:
    """Return some schedules as one platoon.

    Parameters
    ----------
    instance : Instance
        The problem.
    windows : Windows
        Of the same.
    trucks : sequence of int
        In any order.
    lanes, departs : sequence of ndarray of int64
        Lanes of each in driving order, and when it enters them [ticks]. Who waits to join leaves
        later instead, as far as it may.

    Returns
    -------
    Group or None
        None if they are not one platoon, or one is late.
    """
    order = sorted(range(len(trucks)), key=lambda place: trucks[place])
    lanes = [lanes[place] for place in order]
    times = [departs[place].copy() for place in order]
    trucks = [trucks[place] for place in order]
    until = [windows.closes(k, own) for k, own in zip(trucks, lanes, strict=True)]
    runs = _runs(instance, lanes, times)
    if runs is None:
        return None
    for own, at, last, (begin, _) in zip(lanes, times, until, runs, strict=True):
        for i in range(begin - 1, -1, -1):
            at[i] = min(last[i], at[i + 1] - instance.drive[own[i]])
    # Who leaves later may now be in company from an earlier lane on.
    runs = _runs(instance, lanes, times)
    if runs is None:
        return None
    slack = min(int((last - at).min()) for last, at in zip(until, times, strict=True))
    if slack < 0:
        return None
    return Group(
        tuple(trucks), _saving(instance, trucks, lanes, times), tuple(lanes), tuple(times),
        tuple(begin for begin, _ in runs), tuple(end for _, end in runs), slack,
    )  # fmt: skip


def _runs(
    instance: Instance, lanes: Sequence[Ints], times: Sequence[Ints]
) -> list[tuple[int, int]] | None:
    """Return where each is in company; None if they are not one platoon."""
    who: dict[tuple[int, int], list[int]] = {}
    for place, (own, at) in enumerate(zip(lanes, times, strict=True)):
        for entry in zip(own.tolist(), at.tolist(), strict=True):
            who.setdefault(entry, []).append(place)
    runs = []
    for own, at in zip(lanes, times, strict=True):
        marks = [len(who[entry]) > 1 for entry in zip(own.tolist(), at.tolist(), strict=True)]
        if True not in marks:
            return None
        begin = marks.index(True)
        end = begin + sum(marks)
        rolls = at[begin + 1 : end] == at[begin : end - 1] + instance.drive[own[begin : end - 1]]
        if not all(marks[begin:end]) or not rolls.all():
            return None
        runs.append((begin, end))
    return runs if _hang_together(len(lanes), list(who.values())) else None


def _hang_together(count: int, companies: Sequence[Sequence[int]]) -> bool:
    """Tell whether everybody is linked to everybody by companies."""
    reached, todo = {0}, [0]
    while todo:
        one = todo.pop()
        more = {other for company in companies if one in company for other in company} - reached
        reached |= more
        todo += more
    return len(reached) == count


def passes_twice(instance: Instance, lanes: Ints) -> bool:
    """Tell whether lanes lead through a place twice.

    Parameters
    ----------
    instance : Instance
        The problem.
    lanes : ndarray of int64
        In driving order.

    Returns
    -------
    bool
        Whether they do.
    """
    nodes = [int(instance.tail[lanes[0]]), *instance.head[lanes].tolist()]
    return len(set(nodes)) < len(nodes)


def _saving(
    instance: Instance, trucks: Sequence[int], lanes: Sequence[Ints], times: Sequence[Ints]
) -> int:
    entries = np.stack([np.concatenate(lanes), np.concatenate(times)])
    (lane, _), size = np.unique(entries, axis=1, return_counts=True)
    company = size * instance.member[lane] + instance.extra[lane]
    cost = int(np.where(size > 1, company, instance.alone[lane]).sum())
    return int(instance.alone_cost[list(trucks)].sum()) - cost
