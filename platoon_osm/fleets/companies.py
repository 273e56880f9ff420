"""From instants to companies: who drives each lane with whom, in platoons no larger than allowed.

Trucks that enter a lane at one instant are a company. One that is larger than the largest platoon
drives as ceil(n / Q) platoons. Platoons stay as they are from lane to lane where that fits; with
pairs alone, one of an odd company drives by itself.
"""

from __future__ import annotations

import itertools
from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from .instance import Instance

__all__ = ["Company", "companies_of", "platoons_within"]

Ints = NDArray[np.int64]
Company = tuple[int, ...]


def companies_of(
    instance: Instance, lanes: Sequence[Ints], departs: Sequence[Ints]
) -> list[list[Company]]:
    """Return who drives with whom on each lane of each truck's way.

    Parameters
    ----------
    instance : Instance
        The problem.
    lanes, departs : sequence of ndarray of int64, (N, ...)
        The lanes of each truck in driving order, and when it enters them [ticks].

    Returns
    -------
    list of list of tuple of int, (N, ...)
        The platoon that each drives in, ascending; the truck alone where it drives alone.
    """
    truck = np.repeat(np.arange(len(lanes)), [len(own) for own in lanes])
    place = np.concatenate([np.arange(len(own)) for own in lanes])
    lane, at = np.concatenate(lanes), np.concatenate(departs)
    order = np.lexsort((truck, lane, at))
    found: list[list[Company]] = [[()] * len(own) for own in lanes]
    same = (np.diff(lane[order]) == 0) & (np.diff(at[order]) == 0)
    cuts = np.concatenate([[0], np.flatnonzero(~same) + 1, [len(order)]])
    before: dict[int, Company] = {}
    for begin, end in zip(cuts[:-1].tolist(), cuts[1:].tolist(), strict=True):
        rows = order[begin:end]
        trucks = truck[rows].tolist()
        together = (
            [tuple(trucks)]
            if not instance.largest or len(trucks) <= instance.largest
            else platoons_within(trucks, instance.largest, before)
        )
        own = {one: platoon for platoon in together for one in platoon}
        for row, one in zip(rows.tolist(), trucks, strict=True):
            found[one][place[row]] = own[one]
            before[one] = own[one]
    return found


def platoons_within(
    trucks: Sequence[int], largest: int, before: dict[int, Company]
) -> list[Company]:
    """Return as few platoons as a company needs, kept together where they were.

    Parameters
    ----------
    trucks : sequence of int
        The company, larger than `largest`.
    largest : int
        Vehicles of the largest platoon.
    before : dict of int to tuple of int
        The platoon each drove in last.

    Returns
    -------
    list of tuple of int
        Platoons, and a truck alone under `largest` 2 if their number is odd.
    """
    groups: dict[Company, list[int]] = {}
    for one in trucks:
        groups.setdefault(before.get(one, (one,)), []).append(one)
    kept = sorted(groups.values(), key=lambda group: (-len(group), group))
    count = -(-len(trucks) // largest)
    bins: list[list[int]] = [[] for _ in range(count)]
    for group in kept:
        fits = next((own for own in bins if len(own) + len(group) <= largest), None)
        if fits is None:
            bins = []
            break
        fits += group
    if not bins or min(map(len, bins)) < min(2, largest - 1):
        # In the order of the groups, so that most stay together; sizes as even as they may be.
        row = [one for group in kept for one in group]
        if largest == 2:
            bins = [row[at : at + 2] for at in range(0, len(row), 2)]
        else:
            cuts = [len(row) * part // count for part in range(count + 1)]
            bins = [row[begin:end] for begin, end in itertools.pairwise(cuts)]
    return [tuple(sorted(own)) for own in bins]
