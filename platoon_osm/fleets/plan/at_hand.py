"""The plan that a search works on, in terms of the pairs that it looks at."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from ..instance import Instance
from .desk import Plan
from .fixed import FixedWays, entries_of, with_fixed
from .guidance import GuideOf, SharesOf
from .habits import LARGE
from .occupancy import Costs, Occupancy
from .occupied import occupied
from .schedules import Schedules
from .views import Views

__all__ = ["AtHand", "Kept"]

Ints = NDArray[np.int64]
Marks = NDArray[np.bool_]

MARGIN = 0.25
"""See `margin`; eight times as wide below `LARGE` trucks."""


class Kept(NamedTuple):
    """A plan that is put by.

    Attributes
    ----------
    pairs : ndarray of int32, (N, w)
        Pairs of the instance, of each truck in driving order.
    departs : ndarray of int64, (N, w)
        When each is entered [ticks].
    lengths : ndarray of int64, (N,)
        How many.
    """

    pairs: NDArray[np.int32]
    departs: Ints
    lengths: Ints


class AtHand:
    """The plan that a search works on.

    Parameters
    ----------
    instance : Instance
        The problem.
    apart : tuple of ndarray of int64
        Trucks that each truck must not drive together with, told for both: `first_apart` (N + 1,)
        and `apart`.
    fixed : mapping of int to (ndarray of int64, ndarray of int64)
        Trucks that are never moved.
    prepared : ndarray of int64
        Lanes that may be entered by so many more trucks as they are listed.

    Attributes
    ----------
    is_free : ndarray of bool, (N,)
        Trucks that may be moved.
    width : int
        Most lanes of a schedule.
    view : View
        What moves work on.
    legs, departs, count : ndarray of int32, ndarray of int64, ndarray of int64
        The plan, in pairs of the view.
    """

    def __init__(
        self, instance: Instance, apart: tuple[Ints, Ints], fixed: FixedWays, prepared: Ints
    ) -> None:
        self.instance, self.apart = instance, apart
        self.large = instance.trucks >= LARGE
        self.costs = Costs(
            instance.alone, instance.member, instance.extra, instance.largest, instance.waiting
        )
        self.is_free: Marks = np.ones(instance.trucks, np.bool_)
        self.is_free[list(fixed)] = False
        widest = int(np.diff(instance.first_pair).max(initial=0))
        self.width = max(1, min(widest, instance.nodes) + 1)
        self.legs = np.zeros((instance.trucks, self.width), np.int32)
        self.departs = np.zeros((instance.trucks, self.width), np.int64)
        self.count = np.zeros(instance.trucks, np.int64)
        room = np.bincount(instance.pair_lane, minlength=instance.lanes) + 2
        self._room = room + np.bincount(prepared, minlength=instance.lanes)
        self._views = Views(instance)
        self.view = self._views.of(None, None, 0.0, ())
        self._last: tuple[object, object] | None = None
        self.fix(fixed)

    def fix(self, fixed: FixedWays) -> None:
        """Let the fixed trucks drive what is told, with room for them on their lanes.

        Parameters
        ----------
        fixed : mapping of int to (ndarray of int64, ndarray of int64)
            Their lanes and instants.
        """
        self.fixed = fixed
        self._taken = entries_of(fixed)
        room = self._room + np.bincount(self._taken[0], minlength=self.instance.lanes)
        self._row_first = np.concatenate([[0], np.cumsum(room)]).astype(np.int64)

    def plan(self) -> Plan:
        """Return the plan as kernels work on it.

        Returns
        -------
        Plan
            The arrays themselves, no copies.
        """
        return Plan(self.legs, self.departs, self.count, *self.apart)

    def occupied(self, extra: tuple[Ints, Ints] | None = None) -> tuple[Occupancy, Ints]:
        """Return who enters which lane when, and when each pair is entered.

        Parameters
        ----------
        extra : tuple of ndarray of int64, optional
            Lanes and instants that are entered besides [ticks].

        Returns
        -------
        lanes : Occupancy
            Of all trucks.
        entered : ndarray of int64
            Of pairs of the view; -1 for those that are not [ticks].
        """
        used = _marks(self.count, self.width)
        legs, departs = self.legs[used].astype(np.int64), self.departs[used]
        entered = np.full(len(self.view.which), -1, np.int64)
        entered[legs] = departs
        more = [self._taken] if extra is None else [self._taken, extra]
        lane = np.concatenate([self.view.used.lane[legs], *(lanes for lanes, _ in more)])
        departs = np.concatenate([departs, *(instants for _, instants in more)])
        return occupied(self._row_first, lane, departs), entered

    def copied(self) -> Kept:
        """Return the plan in pairs of the instance.

        Returns
        -------
        Kept
            A copy.
        """
        pairs = self.view.which[self.legs] if len(self.view.which) else self.legs
        return Kept(pairs.astype(np.int32), self.departs.copy(), self.count.copy())

    def whole(self, plan: Kept) -> Schedules:
        """Return a plan as schedules of all trucks, the fixed ones too.

        Parameters
        ----------
        plan : Kept
            It.

        Returns
        -------
        Schedules
            In lanes.
        """
        pairs, instance = plan.pairs, self.instance
        lanes = (instance.pair_lane[pairs] if instance.pairs else pairs).astype(np.int32)
        return with_fixed(Schedules(lanes, plan.departs, plan.lengths), self.fixed)

    def kept_of(self, lanes: Sequence[Ints], departs: Sequence[Ints]) -> Kept:
        """Return a plan that was made elsewhere.

        Parameters
        ----------
        lanes, departs : sequence of ndarray of int64, (N, ...)
            Lanes of each truck in driving order, and when it enters them [ticks].

        Returns
        -------
        Kept
            In pairs of the instance.
        """
        count = np.array([len(own) for own in lanes], np.int64)
        used = _marks(count, self.width)
        legs, instants = np.zeros_like(self.legs), np.zeros_like(self.departs)
        instants[used] = np.concatenate(departs)
        truck = np.repeat(np.arange(len(count)), count)
        legs[used] = self._views.pairs(truck, np.concatenate(lanes))
        return Kept(legs, instants, count)

    def take(self, plan: Kept) -> None:
        """Go on from a plan, with all pairs in view.

        Parameters
        ----------
        plan : Kept
            It.
        """
        self.departs, self.count = plan.departs.copy(), plan.lengths.copy()
        self.view, self._last = self._views.of(None, None, 0.0, ()), None
        self.legs = self.view.place[plan.pairs].astype(np.int32)

    def see(self, shares: SharesOf | None, guide: GuideOf | None, best: Kept) -> None:
        """Take other shares, and the pairs that they make worth a look.

        Parameters
        ----------
        shares : SharesOf or None
            The bound's shares.
        guide : GuideOf or None
            What they say of each truck.
        best : Kept
            Its pairs stay in view, and those of the plan at hand.
        """
        if self._last is not None and self._last[0] is shares and self._last[1] is guide:
            return
        self._last = (shares, guide)
        old = self.view.which
        now = self.copied().pairs
        part = MARGIN * (1.0 if self.large else 8.0)
        stay = [now[_marks(self.count, self.width)], best.pairs[_marks(best.lengths, self.width)]]
        self.view = self._views.of(shares, guide, part, stay)
        if len(old):
            self.legs = np.maximum(self.view.place[now], 0).astype(np.int32)


def _marks(count: Ints, width: int) -> Marks:
    """Return which of the places of each truck are used."""
    return np.arange(width)[None, :] < count[:, None]
