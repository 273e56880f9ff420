"""Whether shares are valid: no company that may form pays more than it costs.

In every bucket any 2 to `largest` of the trucks that have shares there pay `extra` together at
most, and each pays alone - member at most, for a truck without shares pays member - h and may join.
The greatest shares of every size tell it all.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from .compiling import compiled
from .faults import FaultError
from .told import Told
from .windows import Pairs

__all__ = ["Listed", "listed_shares"]

Ints = NDArray[np.int64]


@dataclass(frozen=True, slots=True, eq=False)
class Listed:
    """Which pairs have shares.

    Attributes
    ----------
    row : ndarray of int64, (P,)
        Position of each pair among those with shares; -1 if it has none.
    """

    row: Ints


def listed_shares(told: Told, pairs: Pairs) -> Listed:
    """Check all shares.

    Parameters
    ----------
    told : Told
        What the file says.
    pairs : Pairs
        Those that a best plan may need.

    Returns
    -------
    Listed
        Which pairs have shares.

    Raises
    ------
    FaultError
        Shares of a pair that is none, in buckets that are not those of its window, or that are
        not valid.
    """
    at = _positions(told, pairs)
    bucket_lane = np.repeat(np.arange(told.lanes), np.diff(told.lane_first))
    _check_buckets(told, pairs, at)
    counts = np.diff(told.first_share)
    bucket = np.repeat(told.first_bucket - told.first_share[:-1], counts) + np.arange(
        len(told.share)
    )
    low = np.flatnonzero(told.share < -told.member[bucket_lane[bucket]])
    if len(low):
        raise FaultError(f"{_whose(told, int(low[0]))} is below what a member pays")
    first = np.concatenate([[0], np.cumsum(np.bincount(bucket, minlength=len(bucket_lane)))])
    order = np.argsort(bucket, kind="stable")
    bad = _first_invalid(
        first, told.share[order], told.extra[bucket_lane], told.leader_saves[bucket_lane],
        told.largest,
    )  # fmt: skip
    if bad >= 0:
        lane = int(bucket_lane[bad])
        raise FaultError(
            f"lane {lane}: shares from instant {told.starts[bad]} on charge some company more than "
            "it costs"
        )
    row = np.full(len(pairs.lane), -1, np.int64)
    row[at] = np.arange(len(at))
    return Listed(row)


def _positions(told: Told, pairs: Pairs) -> Ints:
    """Return where each pair with shares stands."""
    truck = np.repeat(np.arange(told.trucks), np.diff(pairs.first))
    key = truck * np.int64(told.lanes) + pairs.lane
    order = np.argsort(key)
    wanted = told.share_truck * np.int64(told.lanes) + told.share_lane
    place = np.searchsorted(key[order], wanted)
    there = place < len(key)
    there[there] = key[order[place[there]]] == wanted[there]
    if not there.all():
        bad = int(np.flatnonzero(~there)[0])
        raise FaultError(
            f"vehicle {told.vehicles[told.share_truck[bad]]!r} has shares on lane "
            f"{told.share_lane[bad]}, which it has no use for"
        )
    found: Ints = order[place]
    return found


def _check_buckets(told: Told, pairs: Pairs, at: Ints) -> None:
    """Check that shares are listed for the buckets of the window, all of them."""
    lane, begin = told.share_lane, told.lane_first
    # One number for lane and instant, in the order of both.
    ticks, which = np.unique(
        np.concatenate([told.starts, pairs.opens[at], pairs.closes[at]]), return_inverse=True
    )
    wide = np.int64(len(ticks) + 1)
    of_lane = np.repeat(np.arange(told.lanes), np.diff(begin))
    n, k = len(told.starts), len(at)
    keys = of_lane * wide + which[:n]
    opening = np.searchsorted(keys, lane * wide + which[n : n + k], side="right") - 1
    closing = np.searchsorted(keys, lane * wide + which[n + k :], side="right") - 1
    fits = (opening >= begin[lane]) & (opening == told.first_bucket)
    fits &= np.diff(told.first_share) == closing - opening + 1
    if not fits.all():
        bad = int(np.flatnonzero(~fits)[0])
        raise FaultError(
            f"shares of vehicle {told.vehicles[told.share_truck[bad]]!r} on lane {lane[bad]} are "
            "not listed for the buckets of its window"
        )


def _whose(told: Told, entry: int) -> str:
    row = int(np.searchsorted(told.first_share, entry, side="right")) - 1
    name = told.vehicles[told.share_truck[row]]
    return f"a share of vehicle {name!r} on lane {told.share_lane[row]}"


@compiled
def _first_invalid(first: Ints, share: Ints, extra: Ints, leader: Ints, largest: int) -> int:
    """Return the first bucket whose shares are not valid; -1 if all are."""
    for b in range(len(extra)):
        n = first[b + 1] - first[b]
        if n == 0:
            continue
        own = np.sort(share[first[b] : first[b + 1]])
        if own[n - 1] > extra[b] + leader[b]:
            return b
        if n < 2:
            continue
        most = n if largest == 0 else min(largest, n)
        total = own[n - 1] + own[n - 2]
        if total > extra[b]:
            return b
        for size in range(3, most + 1):
            more = own[n - size]
            if more <= 0:
                break
            total += more
            if total > extra[b]:
                return b
    return -1
