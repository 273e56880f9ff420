"""The best plan of a few trucks, where platoons form from several places and part at several.

The class that is searched, for trucks that wait freely: the trucks are parted into sets. Those of a
set are all at one node at some instant; until it, whoever drives together stays together, and after
it, whoever has parted stays apart: merge trees (`kernels`). A set of one drives alone. For two
trucks this is one stretch together, as `pairs` plans it. What sets pay less where two of them enter
a lane together by accident is not counted.

Case D for more trucks than two (`shared_leg`) is smaller: all merge at one node x, drive together
to one node y, and part there. Its cost is the least of sum d(o_i, x) + P(x, y) + sum d(y, g_i), P
being what the company pays, over ways in time: labels (instant, cost) at every node. Pairs of a
truck and a lane that were dropped (`windows`) are not used; a leg that needs one costs no less than
if its truck drives alone and the others together.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ..instance import Instance
from .compiled import PLANTED
from .group import Group, grouped
from .labels import Labels, labels

__all__ = ["MOST_TOGETHER", "Tree", "merge_tree", "shared_leg"]

Ints = NDArray[np.int64]

MOST_TOGETHER = 12
"""Trucks of one shared leg at most."""

FIRST_ROOM = 20_000
"""Labels that there is space for at first."""

PLAIN_S = 2e-5
"""How long a node of a subset takes where nothing is compiled, about [s]."""


@dataclass(frozen=True, slots=True, eq=False)
class Tree:
    """A plan of a few trucks.

    Attributes
    ----------
    trucks : tuple of int, (k,)
        The trucks, as they were named.
    sets : tuple of tuple of int
        Which of them are together at some node; one alone is a set.
    cost : int
        What all pay [grains]; by accident, where sets meet, they may pay less.
    saving : int
        What they save against all alone [grains].
    lanes, departs : tuple of ndarray of int64, (k, ...)
        Lanes of each in driving order, and when it enters them [ticks].
    """

    trucks: tuple[int, ...]
    sets: tuple[tuple[int, ...], ...]
    cost: int
    saving: int
    lanes: tuple[Ints, ...]
    departs: tuple[Ints, ...]


def merge_tree(
    instance: Instance,
    trucks: Sequence[int],
    companies: tuple[Ints, Ints, Ints] | None = None,
) -> Tree:
    """Return the best plan of up to 8 trucks as merge trees.

    Parameters
    ----------
    instance : Instance
        The problem; waiting must be free.
    trucks : sequence of int
        Up to 8 trucks, each once.
    companies : tuple of ndarray of int64, optional
        Lane, instant and size of the companies of all other trucks, sorted by lane, then instant:
        companies of the group may then enter a lane with them, and pay what theirs costs more.

    Returns
    -------
    Tree
        No plan of the class in the module's text costs less, unless sets meet by accident. It never
        costs more than all alone.

    Raises
    ------
    ScenarioError
        Too many trucks, or a price of waiting.
    """
    group, lanes = grouped(instance, trucks, companies)
    found = _planted(group, False)
    return _told(trucks, group, lanes, found, companies is not None)


def shared_leg(instance: Instance, trucks: Sequence[int]) -> Tree | None:
    """Return the best plan of trucks that all merge at one node and part at one (case D).

    Parameters
    ----------
    instance : Instance
        The problem; waiting must be free.
    trucks : sequence of int
        Two or more trucks, each once; no more than the largest platoon and `MOST_TOGETHER`.

    Returns
    -------
    Tree or None
        None if no such plan costs less than all alone.

    Raises
    ------
    ScenarioError
        Too many trucks, or a price of waiting.
    """
    most = min(MOST_TOGETHER, instance.largest or MOST_TOGETHER)
    group, lanes = grouped(instance, trucks, most=most)
    found = _planted(group, True)
    if found.halves[-1, 0] < 0 or len(trucks) < 2:
        return None
    return _told(trucks, group, lanes, found, False)


@dataclass(frozen=True, slots=True, eq=False)
class _Found:
    """What the search over subsets found: see `kernels.planted`."""

    known: Labels
    costs: Ints
    halves: Ints


def _planted(group: Group, once: bool) -> _Found:
    """Plan all subsets of a group, with more space as long as there is too little."""
    trucks, nodes = len(group.origin), len(group.out_first) - 1
    subsets = 1 << trucks
    searched = 2 * trucks if once else subsets
    kernel = PLANTED.ready(PLAIN_S * nodes * (searched + (0 if once else 3**trucks / 4)))
    first = np.zeros((2, subsets, nodes), np.int64)
    least = np.zeros((2, trucks, nodes), np.int64)
    room = np.zeros((4, max(nodes, len(group.tail))), np.int64)
    costs, halves = np.zeros(subsets, np.int64), np.zeros((subsets, 2), np.int64)
    space = FIRST_ROOM
    while True:
        known = labels(space)
        if kernel(once, group, known, first, least, room, costs, halves) >= 0:
            return _Found(known, costs, halves)
        space *= 4


def _told(
    trucks: Sequence[int], group: Group, lanes: Ints, found: _Found, beside: bool
) -> Tree:  # fmt: skip
    """Return what was found as a plan."""
    ways: list[list[int]] = [[] for _ in trucks]
    times: list[list[int]] = [[] for _ in trucks]
    sets = []
    whole = (1 << len(trucks)) - 1
    todo = [whole]
    while todo:
        mask = todo.pop()
        label, after = found.halves[mask].tolist()
        if label < 0:
            todo += [after, mask ^ after]
            continue
        sets.append(tuple(int(k) for place, k in enumerate(trucks) if mask >> place & 1))
        for k, (way, at) in _before(label, found.known).items():
            ways[k] += way
            times[k] += at
        now = int(found.known.time[label])
        for k, (way, at) in _after(after, now, group, found.known, beside).items():
            ways[k] += way
            times[k] += at
    cost = int(found.costs[whole])
    return Tree(
        trucks=tuple(int(k) for k in trucks), sets=tuple(sorted(sets)), cost=cost,
        saving=int(group.alone_cost.sum()) - cost,
        lanes=tuple(lanes[np.array(way, np.int64)] for way in ways),
        departs=tuple(np.array(at, np.int64) for at in times),
    )  # fmt: skip


Ways = dict[int, tuple[list[int], list[int]]]


def _before(label: int, known: Labels) -> Ways:
    """Return lanes and instants of each truck until it is at a label."""
    found: Ways = {}
    todo: list[tuple[int, list[int], list[int]]] = [(label, [], [])]
    while todo:
        label, way, at = todo.pop()
        while known.lane[label] >= 0:
            way.append(int(known.lane[label]))
            at.append(int(known.enter[label]))
            label = int(known.left[label])
        if known.left[label] < 0:
            found[int(known.right[label])] = (way[::-1], at[::-1])
        else:
            todo += [(int(one[label]), [*way], [*at]) for one in (known.left, known.right)]
    return found


def _after(label: int, now: int, group: Group, known: Labels, beside: bool) -> Ways:
    """Return lanes and instants of each truck from a label on, as early as its company may."""
    found: Ways = {}
    todo: list[tuple[int, int, list[int], list[int]]] = [(label, now, [], [])]
    while todo:
        label, now, way, at = todo.pop()
        while known.lane[label] >= 0:
            lane = int(known.lane[label])
            # Beside others, instants are theirs.
            enter = int(known.enter[label]) if beside else now
            way.append(lane)
            at.append(enter)
            now = enter + int(group.drive[lane])
            label = int(known.left[label])
        if known.left[label] < 0:
            found[int(known.right[label])] = (way, at)
        else:
            todo += [(int(one[label]), now, [*way], [*at]) for one in (known.left, known.right)]
    return found
