"""What moves work on: the pairs that are worth a look, and what the bound says of them."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ..instance import Instance
from .guidance import GuideOf, SharesOf
from .margin import worth_a_look
from .pairs_used import Prices, Used, priced, used_pairs

__all__ = ["View", "Views"]

Ints = NDArray[np.int64]
Marks = NDArray[np.bool_]


@dataclass(frozen=True, slots=True, eq=False)
class View:
    """Pairs in use, and what the bound says of them.

    Attributes
    ----------
    used : Used
        Them.
    which : ndarray of int64
        The instance's pair of each.
    place : ndarray of int64, (P,)
        Where each of the instance's pairs is; -1 for those that are not in use.
    prices : Prices
        Shares of pairs, and the least of each truck.
    guide, guide_count : ndarray of int32, ndarray of int64
        Pairs of the trucks' cheapest schedules by the shares, -1 for those that are not in use.
    trusted : bool
        Whether there are shares.
    """

    used: Used
    which: Ints
    place: Ints
    prices: Prices
    guide: NDArray[np.int32]
    guide_count: Ints
    trusted: bool


class Views:
    """Views of a fleet's problem.

    Parameters
    ----------
    instance : Instance
        The problem.
    """

    def __init__(self, instance: Instance) -> None:
        self._instance = instance
        self._order: tuple[Ints, Ints] | None = None

    def pairs(self, truck: Ints, lane: Ints) -> Ints:
        """Return the instance's pairs of trucks and lanes.

        Parameters
        ----------
        truck, lane : ndarray of int64
            Them.

        Returns
        -------
        ndarray of int64
            -1 where a truck has no such pair.
        """
        instance = self._instance
        if self._order is None:
            key = instance.pair_truck * instance.lanes + instance.pair_lane
            order = np.argsort(key, kind="stable")
            self._order = (order, key[order])
        order, sorted_key = self._order
        wanted = truck * instance.lanes + lane
        found = np.minimum(np.searchsorted(sorted_key, wanted), max(len(order) - 1, 0))
        return np.where(sorted_key[found] == wanted, order[found], -1)

    def of(
        self,
        shares: SharesOf | None,
        guide: GuideOf | None,
        part: float,
        plan: Sequence[NDArray[np.int32]],
    ) -> View:
        """Return what moves work on.

        Parameters
        ----------
        shares : SharesOf or None
            The bound's shares.
        guide : GuideOf or None
            What they say of each truck.
        part : float
            See `margin`.
        plan : sequence of ndarray of int32
            Pairs of the instance that are in use in any case.

        Returns
        -------
        View
            All pairs, or those that are worth a look by the shares.
        """
        instance = self._instance
        keep: Marks | None = None
        if shares is not None and guide is not None and not instance.given and instance.pairs:
            keep = worth_a_look(instance, guide.least, shares.pairs, part)
            for pairs in plan:
                keep[pairs] = True
        used, which = used_pairs(instance, keep)
        place = np.full(instance.pairs, -1, np.int64)
        place[which] = np.arange(len(which))
        none = np.zeros(0, np.int64)
        cost = np.zeros(instance.trucks) if guide is None else guide.cost
        if shares is None:
            prices = priced(used, which, none, none, none, np.zeros(1, np.int64), np.zeros(0), cost)
        else:
            prices = priced(
                used, which, shares.starts, shares.pairs, shares.first_bucket,
                shares.first_share, np.asarray(shares.share, np.float64), cost,
            )  # fmt: skip
        way = np.full((instance.trucks, 1), -1, np.int32)
        way_count = np.zeros(instance.trucks, np.int64)
        if guide is not None:
            way, way_count = self._guided(guide, place)
        return View(used, which, place, prices, way, way_count, shares is not None)

    def _guided(self, guide: GuideOf, place: Ints) -> tuple[NDArray[np.int32], Ints]:
        """Return the pairs of the trucks' cheapest schedules by the shares."""
        way = np.full(guide.lanes.shape, -1, np.int32)
        used = np.arange(guide.lanes.shape[1])[None, :] < guide.count[:, None]
        truck = np.repeat(np.arange(self._instance.trucks), guide.count)
        pairs = self.pairs(truck, guide.lanes[used].astype(np.int64))
        way[used] = np.where(pairs >= 0, place[pairs], -1)
        return np.ascontiguousarray(way), np.ascontiguousarray(guide.count, np.int64)
