"""Platoons of any size, one a trip: candidates grown from pairs, and the best choice of them.

Every two trucks that save something are a candidate (exact, `pairs`). From each size the best
candidates of each truck grow by one truck that joins them (`joining`). In a larger one each truck
leaves and joins again, for whoever was there first may have a better way now. Set packing
(`packing`) chooses. Around what is chosen more candidates are made, with one truck more, one less
or another instead, and the choice is made again, until it saves no more.

No truck joins who must keep apart from one of the platoon.
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterable, Sequence

from .exact_process import Solver
from .instance import Instance
from .joining import Joining
from .one_group import Group, group_of
from .packing import packed
from .pairs import PairOffer, pair_offers

__all__ = ["Keeps", "grown", "nowhere"]

BEST = 8
"""Candidates of each truck that grow, of each size; all of few trucks do."""

NEAR = 16
"""Trucks with which each saves most are those that may join it."""

FEW = 40
"""So few trucks have all candidates of three tried."""

CHOICES = 6
"""How often the choice is made again."""

PACKING_S = 10.0
"""The choice takes no longer [s]."""


Keeps = Callable[[Group, Sequence[int]], bool]


class _Pool:
    """The best platoon of each set of trucks."""

    def __init__(self) -> None:
        self.best: dict[tuple[int, ...], Group] = {}

    def add(self, group: Group | None) -> bool:
        """Add a platoon; tell whether it is new or better."""
        if group is None:
            return False
        known = self.best.get(group.trucks)
        if group.saving <= (0 if known is None else known.saving):
            return False
        self.best[group.trucks] = group
        return True


class _Growth:
    """Candidates of one fleet."""

    def __init__(
        self, instance: Instance, offers: Sequence[PairOffer], apart: Collection[tuple[int, int]],
        forced: Sequence[Group], stop: Callable[[], bool],
    ) -> None:  # fmt: skip
        self.joining = Joining(instance)
        self.apart: dict[int, set[int]] = {}
        for a, b in apart:
            self.apart.setdefault(a, set()).add(b)
            self.apart.setdefault(b, set()).add(a)
        self.largest = instance.largest or instance.trucks
        self.forced = forced
        self.stop = stop
        self.few = instance.trucks <= FEW
        self.pool = _Pool()
        near: dict[int, list[tuple[int, int]]] = {}
        for one in offers:
            near.setdefault(one.first, []).append((-one.saving, one.second))
            near.setdefault(one.second, []).append((-one.saving, one.first))
            pair = (one.first, one.second)
            self.pool.add(group_of(instance, self.joining.windows, pair, one.lanes, one.departs))
        for group in forced:
            self.pool.best.setdefault(group.trucks, group)
        most = instance.trucks if self.few else NEAR
        self.near = {k: [other for _, other in sorted(own)[:most]] for k, own in near.items()}

    def grow(self) -> None:
        """Make candidates of every size from those one smaller."""
        size, last = 2, max([2, *(len(group.trucks) for group in self.forced)])
        while size < self.largest and not self.stop():
            seeds = self._best_of(size)
            for group in seeds:
                if self.stop():
                    return
                self._one_more(group)
            size += 1
            if size > last and not any(len(trucks) == size for trucks in self.pool.best):
                return

    def around(self, chosen: Iterable[Group]) -> bool:
        """Make candidates like some that were chosen; tell whether there are new ones."""
        found = False
        for group in chosen:
            if self.stop():
                break
            found |= self._better(group)
            if len(group.trucks) < self.largest:
                found |= self._one_more(group)
            if len(group.trucks) > 2:
                for k in group.trucks:
                    less = self.joining.without(group, k)
                    if less is not None:
                        found |= self.pool.add(less)
                        found |= self._one_more(less)
        return found

    def _best_of(self, size: int) -> list[Group]:
        """Return candidates of a size: all of few trucks, else the best of each truck."""
        of_size = [group for group in self.pool.best.values() if len(group.trucks) == size]
        of_size.sort(key=lambda group: (-group.saving, group.trucks))
        if self.few and size == 2:
            return of_size
        counts: dict[int, int] = {}
        found = []
        for group in of_size:
            if any(counts.get(k, 0) < BEST for k in group.trucks):
                found.append(group)
                for k in group.trucks:
                    counts[k] = counts.get(k, 0) + 1
        return found

    def _one_more(self, group: Group) -> bool:
        """Add candidates of one truck more; tell whether there are new ones."""
        banned = {other for k in group.trucks for other in self.apart.get(k, ())}
        others = sorted(
            {other for k in group.trucks for other in self.near.get(k, ())}
            - banned - set(group.trucks)
        )  # fmt: skip
        if not others:
            return False
        found = False
        for other, gain in zip(others, self.joining.gains(group, others).tolist(), strict=True):
            if gain <= 0:
                continue
            trucks = tuple(sorted([*group.trucks, other]))
            known = self.pool.best.get(trucks)
            if known is not None and known.saving >= group.saving + gain:
                continue
            larger = self.joining.joined(group, other)
            if self.pool.add(larger):
                assert larger is not None
                found = True
                if self.few:
                    self._better(larger)
        return found

    def _better(self, group: Group) -> bool:
        """Let each truck of a platoon leave and join it again; tell whether that was better."""
        found, again = False, True
        while again:
            again = False
            for k in group.trucks:
                less = self.joining.without(group, k) if len(group.trucks) > 2 else None
                more = None if less is None else self.joining.joined(less, k)
                if more is not None and more.saving > group.saving:
                    group, again = more, True
                    self.pool.add(group)
                    found = True
        return found


def nowhere(_group: Group, _trucks: Sequence[int]) -> bool:
    """Tell of no platoon that trucks drive together in it.

    Parameters
    ----------
    _group : Group
        Any.
    _trucks : sequence of int
        Any.

    Returns
    -------
    bool
        False.
    """
    return False


def grown(
    instance: Instance,
    *,
    least: int = 0,
    apart: Collection[tuple[int, int]] = (),
    forced: Sequence[Group] = (),
    keeps: Keeps = nowhere,
    stop: Callable[[], bool] | None = None,
    time_s: float | None = None,
) -> list[Group]:
    """Return platoons that share no truck, of any size up to the largest.

    Parameters
    ----------
    instance : Instance
        The problem; waiting must be free.
    least : int
        What a platoon has to save [grains].
    apart : collection of (int, int)
        Trucks that must not drive together.
    forced : sequence of Group
        Platoons of trucks that must drive together, though others may join them.
    keeps : callable, optional
        Tells whether trucks that must drive together do so in some platoon.
    stop : callable, optional
        Asked now and then whether to go on with the candidates there are.
    time_s : float or None
        How long one choice may take [s]; None for a number of nodes of the solver.

    Returns
    -------
    list of Group
        By their first trucks; no proof that others do not save more.
    """
    banned = {(min(pair), max(pair)) for pair in apart}
    offers = [one for one in pair_offers(instance) if (one.first, one.second) not in banned]
    growth = _Growth(instance, offers, banned, forced, stop or _never)
    growth.grow()
    must = {k for group in forced for k in group.trucks}
    limit = None if time_s is None else min(PACKING_S, time_s)

    def choice() -> list[Group]:
        free = [group for group in growth.pool.best.values() if must.isdisjoint(group.trucks)]
        worth = [group for group in free if group.saving >= max(1, least)]
        # The platoons as they are told stand beside those of the same trucks that save more.
        bound = [one for one in growth.pool.best.values() if not must.isdisjoint(one.trucks)]
        worth += [
            group
            for group in (*bound, *forced)
            if all(
                {*own.trucks}.isdisjoint(group.trucks) or keeps(group, own.trucks) for own in forced
            )
        ]
        worth.sort(key=lambda group: (group.trucks, group.saving))
        return packed(worth, must, solver, limit)

    with Solver() as solver:
        chosen = choice()
        for _ in range(CHOICES):
            if growth.stop() or not growth.around(chosen):
                break
            again = choice()
            if _saved(again) <= _saved(chosen):
                break
            chosen = again
    return chosen


def _saved(groups: Iterable[Group]) -> int:
    return sum(group.saving for group in groups)


def _never() -> bool:
    return False
