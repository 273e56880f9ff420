"""What companies pay on lanes, and when they enter them.

A company enters a lane as soon as it can; or later, when others do, if that is cheaper.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from . import meeting
from .group import Group
from .labels import FAR, Labels, pop, push

__all__ = ["HELPERS", "company", "driven", "entries", "potentials", "searched", "shared_windows"]

Ints = NDArray[np.int64]


def company(size: int, lane: int, group: Group) -> int:
    """Return what a company pays on a lane.

    Parameters
    ----------
    size : int
        Its trucks.
    lane : int
        Where.
    group : Group
        Costs.

    Returns
    -------
    int
        The equation of `instance.py`, and 0 for nobody [grains].
    """
    if size == 0:
        return 0
    if size == 1:
        return int(group.alone[lane])
    if group.largest == 0:
        return int(size * group.member[lane] + group.extra[lane])
    if group.largest == 2:
        pairs = size // 2
        paid = pairs * (2 * group.member[lane] + group.extra[lane])
        return int(paid + (size - 2 * pairs) * group.alone[lane])
    platoons = (size + group.largest - 1) // group.largest
    return int(size * group.member[lane] + platoons * group.extra[lane])


def shared_windows(mask: int, group: Group, opens: Ints, closes: Ints) -> None:
    """Fill when all trucks of a subset may enter each lane.

    Parameters
    ----------
    mask : int
        The subset.
    group : Group
        The trucks.
    opens, closes : ndarray of int64, (L,)
        Are filled [ticks]; closes before it opens if never.
    """
    opens[:] = -FAR
    closes[:] = FAR
    for k in range(len(group.origin)):
        if mask >> k & 1:
            for lane in range(len(group.tail)):
                if group.closes[k, lane] < group.opens[k, lane]:
                    opens[lane], closes[lane] = FAR, -FAR
                opens[lane] = max(opens[lane], group.opens[k, lane])
                closes[lane] = min(closes[lane], group.closes[k, lane])


def potentials(k: int, forward: bool, group: Group, least: Ints) -> None:
    """Fill what a truck pays at least between each node and its end, whoever drives with it.

    Parameters
    ----------
    k : int
        The truck.
    forward : bool
        From nodes to its destination; else from its origin to nodes.
    group : Group
        The problem. Of a company that loses a truck the others pay at most what a leader saves
        more, so a truck is worth at least `member` less that.
    least : ndarray of int64, (V,)
        Is filled [grains].
    """
    least[:] = FAR
    least[group.destination[k] if forward else group.origin[k]] = 0
    changed = True
    while changed:
        changed = False
        for lane in range(len(group.tail)):
            if group.closes[k, lane] < group.opens[k, lane]:
                continue
            begin, end = group.tail[lane], group.head[lane]
            if not forward:
                begin, end = end, begin
            saved = group.alone[lane] - group.member[lane] - group.extra[lane]
            price = max(group.member[lane] - saved, 0)
            if least[end] + price < least[begin]:
                least[begin] = least[end] + price
                changed = True


def driven(
    label: int, lane: int, enter: int, price: int, forward: bool, count: int, waits: int,
    limit: int, least: Ints, group: Group, known: Labels, last: Ints,
) -> tuple[int, int]:  # fmt: skip
    """Let a company drive a lane.

    Parameters
    ----------
    label, lane, enter, price : int
        From which label, where, when [ticks], and at what cost [grains].
    forward : bool
        Whether time counts forward.
    count, waits, limit, least : int, int, int, ndarray of int64
        As of `meeting.merged`.
    group : Group
        The problem.
    known : Labels
        All.
    last : ndarray of int64, (V,)
        The last label that was kept at each node.

    Returns
    -------
    count, waits : int
        As of `meeting.merged`.
    """
    node = group.head[lane] if forward else group.tail[lane]
    cost = known.cost[label] + price
    if cost + least[node] >= limit or (last[node] >= 0 and cost >= known.cost[last[node]]):
        return count, waits
    if count >= len(known.time):
        return -1, waits
    known.time[count] = enter + group.drive[lane] if forward else -enter
    known.cost[count], known.node[count] = cost, node
    known.left[count], known.right[count] = label, -1
    known.lane[count], known.enter[count] = lane, enter
    push(waits, count, known)
    return count + 1, waits + 1


def entries(
    label: int, lane: int, opens: int, closes: int, size: int, forward: bool, count: int,
    waits: int, limit: int, least: Ints, group: Group, known: Labels, last: Ints,
) -> tuple[int, int]:  # fmt: skip
    """Let a company enter a lane at once, or when others do.

    Parameters
    ----------
    label, lane : int
        From which label, and where.
    opens, closes : int
        When all of it may [ticks].
    size : int
        Its trucks.
    forward, count, waits, limit, least, group, known, last : bool, int, ndarray, Group, Labels
        As of `driven`.

    Returns
    -------
    count, waits : int
        As of `meeting.merged`.
    """
    begin, end = group.at_first[lane], group.at_first[lane + 1]
    if forward:
        enter = max(known.time[label], opens)
        place, step = begin, 1
        while place < end and group.at[place] < enter:
            place += 1
    else:
        enter = min(-known.time[label] - group.drive[lane], closes)
        place, step = end - 1, -1
        while place >= begin and group.at[place] > enter:
            place -= 1
    if enter < opens or enter > closes:
        return count, waits
    price = company(size, lane, group)
    if begin <= place < end and group.at[place] == enter:
        there = group.others[place]
        price = company(there + size, lane, group) - company(there, lane, group)
        place += step
    count, waits = driven(
        label, lane, enter, price, forward, count, waits, limit, least, group, known, last
    )  # fmt: skip
    # Waiting for others is worth its while only if they are cheaper than those before.
    while count >= 0 and begin <= place < end and opens <= group.at[place] <= closes:
        there = group.others[place]
        joint = company(there + size, lane, group) - company(there, lane, group)
        if joint < price:
            price = joint
            count, waits = driven(
                label, lane, group.at[place], price, forward, count, waits, limit, least, group,
                known, last,
            )  # fmt: skip
        place += step
    return count, waits


def searched(
    size: int, drives: bool, forward: bool, opens: Ints, closes: Ints, count: int, waits: int,
    limit: int, least: Ints, group: Group, known: Labels, last: Ints, first: Ints,
) -> int:  # fmt: skip
    """Make the labels of one company from those that wait.

    Parameters
    ----------
    size : int
        Its trucks.
    drives : bool
        Whether it may drive together.
    forward : bool
        Whether time counts forward.
    opens, closes : ndarray of int64, (L,)
        When all of it may enter each lane [ticks].
    count, waits, limit, least, group, known : int, int, int, ndarray, Group, Labels
        As of `driven`.
    last : ndarray of int64, (V,)
        Room for the last label of each node.
    first : ndarray of int64, (V,)
        Gets the first label of each node; -1 for none.

    Returns
    -------
    int
        Labels now; -1 if there is no space left.
    """
    last[:] = -1
    first[:] = -1
    while waits > 0:
        label = pop(waits, known)
        waits -= 1
        node = known.node[label]
        if last[node] >= 0 and known.cost[label] >= known.cost[last[node]]:
            continue
        if last[node] >= 0:
            known.following[last[node]] = label
        else:
            first[node] = label
        known.following[label] = -1
        last[node] = label
        if not drives:
            continue
        begin = group.out_first[node] if forward else group.in_first[node]
        end = group.out_first[node + 1] if forward else group.in_first[node + 1]
        for i in range(begin, end):
            lane = group.out_lane[i] if forward else group.in_lane[i]
            if opens[lane] > closes[lane]:
                continue
            count, waits = entries(
                label, lane, opens[lane], closes[lane], size, forward, count, waits, limit, least,
                group, known, last,
            )  # fmt: skip
            if count < 0:
                return -1
    return count


HELPERS = (
    *meeting.HELPERS, company, shared_windows, potentials, driven, entries, searched
)  # fmt: skip
