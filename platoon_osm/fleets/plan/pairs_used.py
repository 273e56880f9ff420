"""The pairs of a truck and a lane that the search looks at, and their shares.

Of free routes those are dropped whose cheapest way through them costs more by the bound's shares
than the truck's cheapest schedule by them, by more than a margin: a plan near the bound hardly ever
needs them. Those of ways alone and of the plan at hand stay. Each truck's nodes are numbered on
their own ("spots"), so that a search of one truck touches little memory.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from ..instance import Instance

__all__ = ["Prices", "Used", "priced", "used_pairs"]

Ints = NDArray[np.int64]
Floats = NDArray[np.float64]
Marks = NDArray[np.bool_]


class Used(NamedTuple):
    """Pairs of N trucks, P of them, sorted by truck and spot; and the trucks' spots.

    Attributes
    ----------
    first : ndarray of int64, (N + 1,)
        Where the pairs of each truck begin.
    truck, lane, opens, closes, drive : ndarray of int64, (P,)
        Of each pair: truck, lane, its window and how long it takes [ticks].
    alone, member, save : ndarray of float64, (P,)
        What the lane costs alone, in a platoon, and what a leader saves [grains].
    head : ndarray of int64, (P,)
        The spot a pair leads to.
    spot_first : ndarray of int64, (S + 1,)
        Where the pairs out of each spot begin.
    first_spot : ndarray of int64, (N + 1,)
        Where the spots of each truck begin.
    from_spot, to_spot : ndarray of int64, (N,)
        Those of origin and destination.
    tail_spot : ndarray of int64, (P,)
        The spot a pair leads out of.
    onward : ndarray of int64, (P,)
        The pairs of each truck by the time at which they end at latest; for chains in reverse.
    chain : ndarray of bool, (N,)
        Whether a truck's pairs are one way.
    earliest : ndarray of int64, (N,)
        Earliest departures [ticks].
    by_lane, by_opens : ndarray of int64, (P,)
        The pairs of each lane by opening, and those openings.
    lane_first : ndarray of int64, (L + 1,)
        Where those of each lane begin.
    lane_wide : ndarray of int64, (L,)
        The longest window of each lane [ticks].
    """

    first: Ints
    truck: Ints
    lane: Ints
    opens: Ints
    closes: Ints
    drive: Ints
    alone: Floats
    member: Floats
    save: Floats
    head: Ints
    spot_first: Ints
    first_spot: Ints
    from_spot: Ints
    to_spot: Ints
    tail_spot: Ints
    onward: Ints
    chain: Marks
    earliest: Ints
    by_lane: Ints
    by_opens: Ints
    lane_first: Ints
    lane_wide: Ints


class Prices(NamedTuple):
    """Shares of platoons' prices by pair and bucket.

    Attributes
    ----------
    starts : ndarray of int64
        When buckets begin [ticks]; the last begins never.
    bucket, buckets : ndarray of int64, (P,)
        The first bucket of each pair, and how many it has.
    place : ndarray of int64, (P,)
        Where its shares begin.
    share : ndarray of float64
        Shares [grains].
    least : ndarray of float64, (P,)
        The least of each pair.
    cost : ndarray of float64, (N,)
        What each truck's cheapest schedule costs by them.
    """

    starts: Ints
    bucket: Ints
    buckets: Ints
    place: Ints
    share: Floats
    least: Floats
    cost: Floats


def used_pairs(instance: Instance, keep: Marks | None) -> tuple[Used, Ints]:
    """Return the pairs that are looked at.

    Parameters
    ----------
    instance : Instance
        The problem.
    keep : ndarray of bool, (P,), or None
        Which of its pairs; None for all.

    Returns
    -------
    used : Used
        Them.
    which : ndarray of int64
        The instance's pair of each.
    """
    which = np.arange(instance.pairs) if keep is None else np.flatnonzero(keep)
    count, nodes = instance.trucks, instance.nodes
    truck, lane = instance.pair_truck[which], instance.pair_lane[which]
    tail_key = truck * nodes + instance.tail[lane]
    head_key = truck * nodes + instance.head[lane]
    every = np.arange(count, dtype=np.int64) * nodes
    spots = np.unique(
        np.concatenate([tail_key, head_key, every + instance.origin, every + instance.destination])
    )
    tail_spot = np.searchsorted(spots, tail_key).astype(np.int64)
    head = np.searchsorted(spots, head_key).astype(np.int64)
    first = np.searchsorted(truck, np.arange(count + 1)).astype(np.int64)
    opens, closes = instance.opens[which], instance.closes[which]
    drive = instance.drive[lane]
    onward = np.lexsort((-(closes + drive), truck)).astype(np.int64)
    by_lane = np.lexsort((opens, lane)).astype(np.int64)
    lane_first = np.searchsorted(lane[by_lane], np.arange(instance.lanes + 1)).astype(np.int64)
    wide = np.zeros(instance.lanes, np.int64)
    np.maximum.at(wide, lane, closes - opens)
    from_spot = np.searchsorted(spots, every + instance.origin).astype(np.int64)
    to_spot = np.searchsorted(spots, every + instance.destination).astype(np.int64)
    chain = _chains(truck, tail_spot, head, from_spot, to_spot, opens)
    # A chain is gone through in its own order: by opening, the last first.
    in_chain = np.lexsort((-opens, truck)).astype(np.int64)
    onward = np.where(chain[truck[onward]], in_chain, onward) if len(onward) else onward
    used = Used(
        first=first, truck=truck, lane=lane, opens=opens, closes=closes, drive=drive,
        alone=instance.alone[lane].astype(np.float64),
        member=instance.member[lane].astype(np.float64),
        save=instance.leader_saves[lane].astype(np.float64),
        head=head,
        spot_first=np.searchsorted(tail_spot, np.arange(len(spots) + 1)).astype(np.int64),
        first_spot=np.searchsorted(spots, np.arange(count + 1) * nodes).astype(np.int64),
        from_spot=from_spot, to_spot=to_spot, tail_spot=tail_spot, onward=onward, chain=chain,
        earliest=instance.earliest, by_lane=by_lane, by_opens=opens[by_lane],
        lane_first=lane_first, lane_wide=wide,
    )  # fmt: skip
    return used, which


def _chains(
    truck: Ints, tail: Ints, head: Ints, from_spot: Ints, to_spot: Ints, opens: Ints
) -> Marks:
    """Return whether each truck's pairs, in the order of their openings, are one way."""
    count = len(from_spot)
    order = np.lexsort((opens, truck))
    truck, tail, head = truck[order], tail[order], head[order]
    chain = np.zeros(count, bool)
    first = np.searchsorted(truck, np.arange(count + 1))
    has = first[1:] > first[:-1]
    chain[has] = (tail[first[:-1][has]] == from_spot[has]) & (
        head[first[1:][has] - 1] == to_spot[has]
    )
    broken = (truck[1:] == truck[:-1]) & (head[:-1] != tail[1:])
    chain[truck[1:][broken]] = False
    # Whoever could turn back has a choice.
    repeated = np.sort(tail)[1:][np.diff(np.sort(tail)) == 0]
    chain[truck[np.isin(tail, repeated) | (tail == to_spot[truck])]] = False
    return chain


def priced(
    used: Used,
    which: Ints,
    starts: Ints,
    pairs: Ints,
    first_bucket: Ints,
    first_share: Ints,
    share: Floats,
    cost: Floats,
) -> Prices:
    """Return the shares of the pairs that are looked at.

    Parameters
    ----------
    used, which : Used, ndarray of int64
        As `used_pairs` returned them.
    starts, pairs, first_bucket, first_share, share : ndarray of int64, ndarray of float64
        As of the bound's shares.
    cost : ndarray of float64, (N,)
        Each truck's cheapest schedule by them [grains].

    Returns
    -------
    Prices
        A pair without shares counts as one that is driven alone: the bound's price of it, which no
        plan could pay, would lure trucks there.
    """
    listed = np.searchsorted(pairs, which)
    known = np.zeros(len(which), bool)
    inside = listed < len(pairs)
    known[inside] = pairs[listed[inside]] == which[inside]
    row = listed[known]
    bucket = np.full(len(which), len(starts), np.int64)
    buckets = np.ones(len(which), np.int64)
    place = len(share) + np.arange(len(which), dtype=np.int64)
    bucket[known] = first_bucket[row]
    buckets[known] = first_share[row + 1] - first_share[row]
    place[known] = first_share[row]
    lonely = used.alone - used.member
    every = np.concatenate([share.astype(np.float64), lonely])
    least = lonely.copy()
    if len(share):
        lowest = np.minimum.reduceat(share, first_share[:-1])
        least[known] = lowest[row]
    return Prices(
        starts=np.append(starts, np.iinfo(np.int64).min).astype(np.int64),
        bucket=bucket, buckets=buckets, place=place, share=every, least=least,
        cost=np.ascontiguousarray(cost, np.float64),
    )  # fmt: skip
