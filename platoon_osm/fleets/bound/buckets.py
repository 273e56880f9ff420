"""Buckets of time on each lane, and which listed pairs have shares in which.

A lane is cut where a window of a listed pair opens and after one closes, so that the trucks of a
bucket may all enter at any of its instants. Cuts that splitting adds make buckets smaller; cuts are
never taken back, so that shares can be handed down: a bucket's children inherit its shares, and
stay valid.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ...search.hierarchy.runtime.jit import compiled
from ..instance import Instance

__all__ = ["Buckets", "Clock", "bucketed", "inherited"]

Ints = NDArray[np.int64]
Floats = NDArray[np.float64]


@dataclass(frozen=True, slots=True)
class Clock:
    """Lanes and instants as single numbers that sort by lane, then by instant.

    Attributes
    ----------
    first : int
        An instant before all others [ticks].
    span : int
        How many instants there are.
    """

    first: int
    span: int

    @classmethod
    def of(cls, instance: Instance) -> Clock:
        """Return the clock of an instance.

        Parameters
        ----------
        instance : Instance
            The fleet's problem.

        Returns
        -------
        Clock
            That holds all instants of its windows.
        """
        if not instance.pairs:
            return cls(0, 1)
        first = int(instance.opens.min()) - 1
        return cls(first, int(instance.closes.max()) - first + 3)

    def key(self, lane: Ints, instant: Ints) -> Ints:
        """Return the numbers of instants on lanes.

        Parameters
        ----------
        lane : ndarray of int64
            Lanes.
        instant : ndarray of int64
            Instants [ticks].

        Returns
        -------
        ndarray of int64
            One for each.
        """
        return lane * self.span + (instant - self.first)


@dataclass(frozen=True, slots=True, eq=False)
class Buckets:
    """The buckets of all lanes and the places of shares in them.

    Attributes
    ----------
    pairs, first_bucket, first_share, lane_first, starts : ndarray of int64
        As in `Shares`.
    keys : ndarray of int64, (B,)
        The cuts, as `Clock` numbers them.
    lane : ndarray of int64, (B,)
        The lane of each bucket.
    first_member : ndarray of int64, (B + 1,)
        Where the members of each bucket begin in `entry`.
    entry : ndarray of int64, (S,)
        Positions of shares, bucket by bucket; in a bucket in order of pairs.
    place : ndarray of int64, (S,)
        Where each share stands in `entry`.
    pair_of : ndarray of int64, (S,)
        The listed pair that each share belongs to.
    extra, leader : ndarray of float64, (B,)
        What a platoon costs once, and what its leader saves, on the bucket's lane [grains].
    """

    pairs: Ints
    first_bucket: Ints
    first_share: Ints
    lane_first: Ints
    starts: Ints
    keys: Ints
    lane: Ints
    first_member: Ints
    entry: Ints
    place: Ints
    pair_of: Ints
    extra: Floats
    leader: Floats

    @property
    def shares(self) -> int:
        """How many shares there are."""
        return len(self.entry)


def bucketed(instance: Instance, clock: Clock, pairs: Ints, cuts: Ints) -> Buckets:
    """Return the buckets of listed pairs.

    Parameters
    ----------
    instance : Instance
        The fleet's problem.
    clock : Clock
        Its clock.
    pairs : ndarray of int64, (K,)
        The listed ones, ascending.
    cuts : ndarray of int64
        Further cuts, as the clock numbers them.

    Returns
    -------
    Buckets
        Cut where windows open and close and at the further cuts.
    """
    lane = instance.pair_lane[pairs]
    opens = clock.key(lane, instance.opens[pairs])
    closes = clock.key(lane, instance.closes[pairs])
    keys = np.union1d(np.concatenate([opens, closes + 1]), cuts)
    first = np.searchsorted(keys, opens, "right") - 1
    last = np.searchsorted(keys, closes, "right") - 1
    first_share = np.concatenate([[0], np.cumsum(last - first + 1)])
    pair_of = np.repeat(np.arange(len(pairs)), last - first + 1)
    bucket = first[pair_of] + np.arange(len(pair_of)) - first_share[pair_of]
    first_member = np.concatenate([[0], np.cumsum(np.bincount(bucket, minlength=len(keys)))])
    entry, place = np.empty(len(bucket), np.int64), np.empty(len(bucket), np.int64)
    _sort_by_bucket(bucket, first_member, entry, place)
    of = keys // clock.span
    return Buckets(
        pairs=pairs, first_bucket=first, first_share=first_share,
        lane_first=np.searchsorted(of, np.arange(instance.lanes + 1)),
        starts=keys % clock.span + clock.first, keys=keys, lane=of, first_member=first_member,
        entry=entry, place=place, pair_of=pair_of, extra=instance.extra[of].astype(np.float64),
        leader=instance.leader_saves[of].astype(np.float64),
    )  # fmt: skip


def inherited(old: Buckets, share: Floats, new: Buckets, unlisted: Floats) -> Floats:
    """Return the shares of new buckets, which they inherit from those they are parts of.

    Parameters
    ----------
    old : Buckets
        The buckets before; all their cuts are cuts of the new ones.
    share : ndarray of float64, (S,)
        Their shares [grains].
    new : Buckets
        The new buckets; all pairs listed before are listed still.
    unlisted : ndarray of float64, (K,)
        What each listed pair has if it was not listed before [grains].

    Returns
    -------
    ndarray of float64
        As valid as the old ones, and with the same bound.
    """
    before = np.searchsorted(old.pairs, new.pairs)
    known = old.pairs[np.minimum(before, len(old.pairs) - 1)] == new.pairs
    before = np.where(known, before, 0)
    parent = np.searchsorted(old.keys, new.keys, "right") - 1
    bucket = new.first_bucket[new.pair_of] + np.arange(new.shares) - new.first_share[new.pair_of]
    pair = before[new.pair_of]
    at = np.maximum(parent[bucket] - old.first_bucket[pair], 0) + old.first_share[pair]
    inside = known[new.pair_of]
    return np.where(inside, share[np.where(inside, at, 0)], unlisted[new.pair_of])


@compiled
def _sort_by_bucket(bucket: Ints, first: Ints, entry: Ints, place: Ints) -> None:
    """Sort shares by their buckets, those of a bucket in order."""
    free = first[:-1].copy()
    for i in range(len(bucket)):
        at = free[bucket[i]]
        entry[at] = i
        place[i] = at
        free[bucket[i]] = at + 1
