"""Which truck could enter which lane, and when, if it kept its window.

A truck from o to g may enter lane (u, v) from earliest + T(o, u) to latest - T(v, g) - drive, T
being quickest times over lanes of its kind; out of its origin until its latest departure.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from .compiling import compiled
from .heap import drop_least, put
from .told import Told

__all__ = ["FAR", "Pairs", "all_pairs"]

Ints = NDArray[np.int64]
Marks = NDArray[np.bool_]

FAR = 2**60
"""Beyond every instant and cost."""

AT_ONCE = 4_000_000
"""Pairs of trucks and lanes that are looked at together."""


@dataclass(frozen=True, slots=True, eq=False)
class Pairs:
    """Who may drive what, sorted by truck, then by tail of the lane, then by lane.

    Attributes
    ----------
    first : ndarray of int64, (N + 1,)
        Where the pairs of each truck begin.
    lane : ndarray of int64, (P,)
        Lanes.
    opens, closes : ndarray of int64, (P,)
        First and last instant at which the truck may enter [ticks].
    on_alone : ndarray of bool, (P,)
        Whether the lane is on its way alone.
    """

    first: Ints
    lane: Ints
    opens: Ints
    closes: Ints
    on_alone: Marks

    def only(self, keep: Marks) -> Pairs:
        """Return some of the pairs.

        Parameters
        ----------
        keep : ndarray of bool, (P,)
            Which.

        Returns
        -------
        Pairs
            Those, in the same order.
        """
        kept = np.concatenate([[0], np.cumsum(keep)])
        return Pairs(
            kept[self.first], self.lane[keep], self.opens[keep], self.closes[keep],
            self.on_alone[keep],
        )  # fmt: skip


def all_pairs(told: Told) -> Pairs:
    """Return all pairs that are in time; on given routes those of the routes.

    Parameters
    ----------
    told : Told
        What the file says.

    Returns
    -------
    Pairs
        With their windows.
    """
    kinds = int(max(told.kind.max(), told.lane_kind.max(initial=0))) + 1
    outward, first_out = _by_node(told, told.tail, kinds)
    inward, first_in = _by_node(told, told.head, kinds)
    marked = _marks(told)
    lanes_of_kind = np.bincount(told.lane_kind, minlength=kinds)
    most = max(1, int(lanes_of_kind.max(initial=0)))
    step = max(1, AT_ONCE // most)
    parts: list[tuple[Ints, Ints, Ints, Marks]] = []
    counts = []
    for begin in range(0, told.trucks, step):
        end = min(told.trucks, begin + step)
        room = (end - begin) * most
        lane, opens, closes = (np.empty(room, np.int64) for _ in range(3))
        on_alone = np.empty(room, np.bool_)
        count = np.zeros(end - begin, np.int64)
        used = _windows(
            begin, end, told.nodes, told.tail, told.head, told.drive, told.origin,
            told.destination, told.earliest, told.latest_departure, told.latest, told.kind,
            outward, first_out, inward, first_in, told.given, told.first_route, told.route,
            marked, lane, opens, closes, on_alone, count,
        )  # fmt: skip
        parts.append(
            (lane[:used].copy(), opens[:used].copy(), closes[:used].copy(), on_alone[:used].copy())
        )
        counts.append(count)
    whole = [np.concatenate(own) for own in zip(*parts, strict=True)]
    first = np.concatenate([[0], np.cumsum(np.concatenate(counts))]).astype(np.int64)
    return Pairs(first, whole[0], whole[1], whole[2], whole[3].astype(np.bool_))


def _by_node(told: Told, node: Ints, kinds: int) -> tuple[Ints, Ints]:
    """Return lanes by kind and node, and where those of each begin."""
    key = told.lane_kind * told.nodes + node
    order = np.argsort(key, kind="stable")
    return order, np.searchsorted(key[order], np.arange(kinds * told.nodes + 1))


def _marks(told: Told) -> Ints:
    """Return an array that tells for which truck a lane was marked last: none yet."""
    return np.full(told.lanes, -1, np.int64)


@compiled
def _windows(
    begin: int,
    end: int,
    nodes: int,
    tail: Ints,
    head: Ints,
    drive: Ints,
    origin: Ints,
    destination: Ints,
    earliest: Ints,
    departs: Ints,
    latest: Ints,
    kind: Ints,
    outward: Ints,
    first_out: Ints,
    inward: Ints,
    first_in: Ints,
    given: bool,
    first_route: Ints,
    route: Ints,
    marked: Ints,
    lane: Ints,
    opens: Ints,
    closes: Ints,
    on_alone: Marks,
    count: Ints,
) -> int:
    """Write down the pairs of some trucks; return how many there are."""
    far = np.int64(2**60)
    there = np.full(nodes, far, np.int64)
    back = np.full(nodes, far, np.int64)
    keys = np.empty(len(tail) + 2, np.int64)
    items = np.empty(len(tail) + 2, np.int64)
    at = 0
    for k in range(begin, end):
        room = latest[k] - earliest[k]
        for i in range(first_route[k], first_route[k + 1]):
            marked[route[i]] = k
        base = kind[k] * nodes
        _spread(
            origin[k],
            room,
            base,
            head,
            drive,
            outward,
            first_out,
            given,
            marked,
            k,
            keys,
            items,
            there,
        )
        _spread(
            destination[k],
            room,
            base,
            tail,
            drive,
            inward,
            first_in,
            given,
            marked,
            k,
            keys,
            items,
            back,
        )
        start = at
        for u in range(nodes):
            if there[u] == far:
                continue
            for i in range(first_out[base + u], first_out[base + u + 1]):
                one = outward[i]
                v = head[one]
                if back[v] == far or (given and marked[one] != k):
                    continue
                low = earliest[k] + there[u]
                high = latest[k] - back[v] - drive[one]
                if u == origin[k] and departs[k] < high:
                    high = departs[k]
                if low <= high:
                    lane[at] = one
                    opens[at] = low
                    closes[at] = high
                    on_alone[at] = marked[one] == k
                    at += 1
        count[k - begin] = at - start
        there[:] = far
        back[:] = far
    return at


@compiled
def _spread(
    start: int,
    room: int,
    base: int,
    ahead: Ints,
    drive: Ints,
    lanes: Ints,
    first: Ints,
    given: bool,
    marked: Ints,
    k: int,
    keys: Ints,
    items: Ints,
    times: Ints,
) -> None:
    """Work out quickest times from a node, up to `room`; those beyond stay far."""
    if room < 0:
        return
    times[start] = 0
    size = put(keys, items, 0, 0, start)
    while size > 0:
        now, node = keys[0], items[0]
        size = drop_least(keys, items, size)
        if now > times[node]:
            continue
        for i in range(first[base + node], first[base + node + 1]):
            one = lanes[i]
            if given and marked[one] != k:
                continue
            other = ahead[one]
            then = now + drive[one]
            if then <= room and then < times[other]:
                times[other] = then
                size = put(keys, items, size, then, other)
