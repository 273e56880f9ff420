"""The volume algorithm: steps along an average of subgradients.

With x(s) marking the shares that the trucks' cheapest schedules under the shares s pay, x(s) is a
subgradient of the bound at s. The algorithm keeps the best shares found, the centre c, and an
average a of subgradients. It tries s = P(c + step a), P being the projection on valid shares, with

    step = f (target - bound(c)) / |a|^2    (a without what P takes off again),

the part of the step of Polyak (1969) that Barahona and Anbil (2000) take, and blends
a := (1 - w) a + w x(s), w falling from step to step. If the bound rises s becomes the centre, and f
grows; after some failures f shrinks. The average tends to a solution of the linear program in which
each truck is a mix of schedules, which is why it goes on where single subgradients jam.
"""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from ...search.hierarchy.runtime.jit import compiled, kept_with
from .buckets import Buckets
from .crews import Crew, chunks_of
from .projecting import project
from .searching import Searching

__all__ = ["Volume"]

Ints = NDArray[np.int64]
Floats = NDArray[np.float64]

AGE, LEAST_WEIGHT = 0.4, 0.001
"""By how much 1 / w grows a step, and the least w."""


@dataclass(slots=True, eq=False)
class Volume:
    """The state of an ascent over the shares of some buckets.

    Attributes
    ----------
    buckets : Buckets
        The buckets.
    searching : Searching
        The trucks' searches over the listed pairs; its shares are those tried last.
    largest : int
        Vehicles of the largest platoon, 0 for any.
    part : float
        f in the module's text.
    weight : float
        w in the module's text.
    patience : int
        Steps without success before the step shrinks.
    before : ndarray of float64, (S,), or None
        An average of subgradients to begin with, pair by pair, of the buckets that these are parts
        of; it is let go once it was taken.
    """

    buckets: Buckets
    searching: Searching
    largest: int
    part: float
    weight: float
    patience: int
    before: Floats | None = None
    best: float = -np.inf
    _centre: Floats = field(init=False)
    _tried: Floats = field(init=False)
    _average: Floats = field(init=False)
    _failures: int = 0
    _chunks: list[tuple[int, int]] = field(init=False)

    def __post_init__(self) -> None:
        self._chunks = chunks_of(self.buckets.first_member)
        self._centre = self.searching.share[self.buckets.entry]
        self._tried = self._centre.copy()
        self._average = np.zeros(self.buckets.shares)
        if self.before is not None:
            self._average = self.before[self.buckets.entry]

    @property
    def shares(self) -> Floats:
        """The best shares, pair by pair [grains]."""
        return self._centre[self.buckets.place]

    @property
    def average(self) -> Floats:
        """The average of subgradients, pair by pair."""
        return self._average[self.buckets.place]

    def begin(self, crew: Crew) -> None:
        """Work out the bound at the first shares.

        Parameters
        ----------
        crew : Crew
            Who does it.
        """
        self.best = self.searching.search(crew)
        self._blend(1.0 if self.before is None else self.weight)
        self.before = None

    def step(self, crew: Crew, target: float) -> None:
        """Take one step.

        Parameters
        ----------
        crew : Crew
            Who does it.
        target : float
            What the bound is thought to reach at most [grains].
        """
        own, share = self.buckets, self.searching.share
        norm = sum(
            crew.each(
                lambda begin, end: _norm(
                    begin, end, self._average, own.first_member, own.leader, self.largest
                ),
                self._chunks,
            )
        )
        if norm <= 0.0:
            self._fail()
            return
        size = self.part * max(target - self.best, 1e-8 * abs(target)) / norm
        crew.each(
            lambda begin, end: _move(
                begin, end, size, self._average, self._centre, own.first_member, own.entry,
                own.extra, own.leader, self.largest, self._tried, share,
            ),
            self._chunks,
        )  # fmt: skip
        value = self.searching.search(crew)
        self._blend(self.weight)
        self.weight = max(1.0 / (1.0 / self.weight + AGE), LEAST_WEIGHT)
        if value > self.best:
            if value - self.best > 1e-4 * (target - self.best):
                self.part = min(self.part * 1.1, 2.0)
                self._failures = 0
            self.best = value
            self._centre, self._tried = self._tried, self._centre
        else:
            self._fail()

    def _fail(self) -> None:
        self._failures += 1
        if self._failures >= self.patience:
            self._failures = 0
            self.part *= 0.7

    def _blend(self, weight: float) -> None:
        routes, ways = self.searching.routes, self.searching.ways
        self._average *= 1.0 - weight
        _add(
            weight, routes.entry, routes.length, ways.first_place, self.buckets.place, self._average
        )


@compiled
def _norm(
    begin: int, end: int, average: Floats, first_member: Ints, leader: Floats, most: int
) -> float:
    """Return the squared length of the average along valid shares, over some buckets."""
    norm = 0.0
    for b in range(begin, end):
        low, high = first_member[b], first_member[b + 1]
        if high - low < 2:
            continue
        squares = 0.0
        total = 0.0
        for i in range(low, high):
            squares += average[i] * average[i]
            total += average[i]
        norm += squares
        # Only on a simplex does the projection take off what is common to all.
        if leader[b] == 0.0 and (most == 0 or high - low <= most):
            norm -= total * total / (high - low)
    return norm


@compiled
def _move(
    begin: int,
    end: int,
    size: float,
    average: Floats,
    centre: Floats,
    first_member: Ints,
    entry: Ints,
    extra: Floats,
    leader: Floats,
    most: int,
    tried: Floats,
    share: Floats,
) -> int:
    """Set the shares of some buckets to the projection of a step from the centre."""
    widest = np.int64(1)
    for b in range(begin, end):
        widest = max(widest, first_member[b + 1] - first_member[b])
    v = np.empty(widest)
    work = np.empty(2 * widest)
    for b in range(begin, end):
        low, high = first_member[b], first_member[b + 1]
        n = high - low
        least = np.inf
        greatest = 0.0
        for i in range(low, high):
            least = min(least, average[i])
            greatest = max(greatest, average[i])
        bent = leader[b] > 0.0 or (most > 0 and n > most)
        if n < 2 or greatest < 1e-9 or (not bent and greatest - least < 1e-9):
            for i in range(low, high):
                tried[i] = centre[i]
                share[entry[i]] = centre[i]
            continue
        for i in range(n):
            v[i] = centre[low + i] + size * average[low + i]
        project(v, n, extra[b], leader[b], most, work)
        for i in range(n):
            tried[low + i] = v[i]
            share[entry[low + i]] = v[i]
    return 0


@compiled
def _add(
    weight: float, entry: Ints, count: Ints, first_place: Ints, place: Ints, average: Floats
) -> None:
    """Add the marks of the cheapest schedules, times a weight."""
    for k in range(len(count)):
        for i in range(first_place[k], first_place[k] + count[k]):
            average[place[entry[i]]] += weight


kept_with(_move, (project,))
