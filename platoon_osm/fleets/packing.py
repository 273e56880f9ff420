"""Which platoons are driven: of many that could be, those that save most and share no truck.

With x_g whether platoon g is driven, the sum of saving_g x_g is to be greatest where the sum of x_g
over the platoons of each truck is at most 1 (set packing). Few trucks are solved by going through
their sets, more by HiGHS; where it finds nothing in time, platoons are taken in order of what they
save for each truck.
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Sequence

import numpy as np

from .exact import Programme
from .exact_process import Solver
from .instants import Entries
from .one_group import Group

__all__ = ["packed"]

FEW = 14
"""So many trucks have few enough sets."""


def packed(
    groups: Sequence[Group],
    must: Collection[int],
    solver: Solver,
    time_s: float | None,
    stop: Callable[[], bool] | None = None,
) -> list[Group]:
    """Return the platoons that save most together, no truck in two of them.

    Parameters
    ----------
    groups : sequence of Group
        All that could be driven.
    must : collection of int
        Trucks each of which is in one of those that are chosen.
    solver : Solver
        Whom to ask.
    time_s : float or None
        For how long [s]; None for a number of nodes.
    stop : callable, optional
        Asked now and then whether to give up.

    Returns
    -------
    list of Group
        By their first trucks.
    """
    trucks = sorted({k for group in groups for k in group.trucks})
    # What each brings, and so much for every truck that must be in one that nothing outweighs it.
    worth = 1 + sum(abs(group.saving) for group in groups) if must else 0
    gains = [group.saving + worth * len({*must} & {*group.trucks}) for group in groups]
    if len(trucks) <= FEW:
        found = _by_sets(groups, gains, trucks)
    else:
        solved = solver.solve(_programme(groups, must, trucks), time_s, stop=stop)
        found = (
            _in_turn(groups, gains)
            if solved is None
            else [group for group, value in zip(groups, solved[0], strict=True) if value > 0.5]
        )
    return sorted(found, key=lambda group: group.trucks)


def _by_sets(groups: Sequence[Group], gains: Sequence[int], trucks: Sequence[int]) -> list[Group]:
    """Go through all sets of trucks that are left, the lowest truck of each in turn."""
    bit = {k: 1 << place for place, k in enumerate(trucks)}
    by_first: dict[int, list[tuple[int, int, Group]]] = {}
    for group, gain in zip(groups, gains, strict=True):
        mask = sum(bit[k] for k in group.trucks)
        by_first.setdefault(mask & -mask, []).append((mask, gain, group))
    best: dict[int, tuple[int, list[Group]]] = {0: (0, [])}

    def of(left: int) -> tuple[int, list[Group]]:
        if left not in best:
            low = left & -left
            found = of(left ^ low)
            for mask, gain, group in by_first.get(low, ()):
                if mask & left == mask:
                    others, rest = of(left ^ mask)
                    if others + gain > found[0]:
                        found = (others + gain, [group, *rest])
            best[left] = found
        return best[left]

    return of((1 << len(trucks)) - 1)[1]


def _programme(groups: Sequence[Group], must: Collection[int], trucks: Sequence[int]) -> Programme:
    row_of = {k: row for row, k in enumerate(trucks)}
    sizes = [len(group.trucks) for group in groups]
    rows = [row_of[k] for group in groups for k in group.trucks]
    count, none = len(groups), np.zeros(0, np.int64)
    return Programme(
        np.array([group.saving for group in groups], np.int64), np.ones(count),
        np.ones(count, bool), np.array(rows, np.int64), np.repeat(np.arange(count), sizes),
        np.ones(len(rows), np.int64), np.where(np.isin(trucks, list(must)), 1.0, -np.inf),
        np.ones(len(trucks)), Entries(none, none, none),
    )  # fmt: skip


def _in_turn(groups: Sequence[Group], gains: Sequence[int]) -> list[Group]:
    taken: set[int] = set()
    found = []
    each = [gain / len(group.trucks) for group, gain in zip(groups, gains, strict=True)]
    for place in sorted(range(len(groups)), key=lambda place: (-each[place], place)):
        group = groups[place]
        if taken.isdisjoint(group.trucks):
            taken.update(group.trucks)
            found.append(group)
    return found
