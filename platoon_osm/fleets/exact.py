"""The exact model of a fleet: facility location on the instants that matter, solved by HiGHS.

Each truck is a flow through its places in time (enter a lane at an instant, wait at a node). At a
lane and instant with trucks K, y_k says whether k enters, and z_q how many platoons of q form:

    sum q z_q <= sum y,    sum (q - 1) z_q <= sum over others than k of y    for every k in K,

and what is saved is s_q z_q, s_q = q (alone - member) - extra. Where platoons may be of any size
x_k <= y_k says whether k is in a company, and x_k <= z, sum x >= 2 z. Every y, z and x is whole;
the flows between them follow. The second row keeps a truck from being a platoon with itself: for
two trucks it is z <= y of each. Linear relaxations of both are upper bounds on savings.

HiGHS runs in a process of its own (`exact_process`): a solver that ends badly should not end us.
"""

from __future__ import annotations

import itertools
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from .instance import Instance
from .instants import MOST_ENTRIES, Entries, entries_of

__all__ = ["Programme", "Ways", "programme_of", "ways_of"]

Ints = NDArray[np.int64]
Floats = NDArray[np.float64]
Ways = tuple[list[Ints], list[Ints]]
"""Lanes of each truck in driving order, and when it enters them [ticks]."""

MOST_SIZES = 6
"""Larger platoons are modelled by x and z: the rows by size would be many."""


@dataclass(frozen=True, slots=True, eq=False)
class Programme:
    """A mixed-integer programme in whole numbers: maximise what is saved.

    Attributes
    ----------
    gain : ndarray of int64, (c,)
        Of each column [grains].
    upper : ndarray of float, (c,)
        Its upper bound; the lower one is 0.
    whole : ndarray of bool, (c,)
        Whether it must be whole.
    row, column, value : ndarray of int64
        The entries of the rows.
    low, high : ndarray of float, (r,)
        Limits of each row.
    entries : Entries
        What the first columns mean: y of each.
    """

    gain: Ints
    upper: Floats
    whole: NDArray[np.bool_]
    row: Ints
    column: Ints
    value: Ints
    low: Floats
    high: Floats
    entries: Entries


class _Rows:
    """Rows as they are made."""

    def __init__(self) -> None:
        self.row: list[int] = []
        self.column: list[int] = []
        self.value: list[int] = []
        self.low: list[float] = []
        self.high: list[float] = []

    def add(self, columns: list[int], values: list[int], low: float, high: float) -> None:
        self.row += [len(self.low)] * len(columns)
        self.column += columns
        self.value += values
        self.low.append(low)
        self.high.append(high)


class _Columns:
    """Columns as they are made."""

    def __init__(self) -> None:
        self.gain: list[int] = []
        self.upper: list[float] = []
        self.whole: list[bool] = []

    def add(self, gain: int, upper: float, whole: bool) -> int:
        self.gain.append(gain)
        self.upper.append(upper)
        self.whole.append(whole)
        return len(self.gain) - 1


def programme_of(instance: Instance, most: int = MOST_ENTRIES) -> Programme | None:
    """Return the exact model of an instance; None if it would be too large.

    Parameters
    ----------
    instance : Instance
        The problem.
    most : int
        How many entries there may be.

    Returns
    -------
    Programme or None
        Its value is what is saved against all trucks alone.
    """
    entries = entries_of(instance, most)
    if entries is None:
        return None
    columns, rows = _Columns(), _Rows()
    for lane in entries.lane.tolist():
        columns.add(-int(instance.alone[lane]), 1.0, True)
    _add_flows(instance, entries, columns, rows)
    _add_companies(instance, entries, columns, rows)
    return Programme(
        np.array(columns.gain, np.int64), np.array(columns.upper), np.array(columns.whole),
        np.array(rows.row, np.int64), np.array(rows.column, np.int64),
        np.array(rows.value, np.int64), np.array(rows.low), np.array(rows.high), entries,
    )  # fmt: skip


def _add_flows(instance: Instance, entries: Entries, columns: _Columns, rows: _Rows) -> None:
    """Add a flow from origin to destination for each truck, waiting at nodes for nothing."""
    first = np.searchsorted(entries.truck, np.arange(instance.trucks + 1)).tolist()
    lanes, ats = entries.lane.tolist(), entries.at.tolist()
    tail, head, drive = instance.tail.tolist(), instance.head.tolist(), instance.drive.tolist()
    for k in range(instance.trucks):
        origin, goal = int(instance.origin[k]), int(instance.destination[k])
        comes: dict[tuple[int, int], list[int]] = {}
        leaves: dict[tuple[int, int], list[int]] = {}
        start = (origin, int(instance.earliest[k]))
        for entry in range(first[k], first[k + 1]):
            lane, at = lanes[entry], ats[entry]
            leaves.setdefault((tail[lane], at), []).append(entry)
            if head[lane] != goal:
                comes.setdefault((head[lane], at + drive[lane]), []).append(entry)
        # It passes its origin no second time, and its destination is where it ends.
        by_node: dict[int, list[int]] = {}
        for node, at in {*comes, *leaves, start}:
            by_node.setdefault(node, []).append(at)
        arrives = [e for e in range(first[k], first[k + 1]) if head[lanes[e]] == goal]
        rows.add(arrives, [1] * len(arrives), 1.0, 1.0)
        for node, times in by_node.items():
            waiting = -1
            for at in sorted(times):
                own = [(one, -1) for one in leaves.get((node, at), ())]
                own += [(one, 1) for one in comes.get((node, at), ())]
                if waiting >= 0:
                    own.append((waiting, 1))
                waiting = columns.add(0, 1.0, False)
                own.append((waiting, -1))
                need = -1.0 if (node, at) == start else 0.0
                names = [one for one, _ in own]
                rows.add(names, [sign for _, sign in own], need, need)
            # What still waits after the last instant has nowhere to go.
            columns.upper[waiting] = 0.0


def _add_companies(instance: Instance, entries: Entries, columns: _Columns, rows: _Rows) -> None:
    """Add what companies save at each lane and instant."""
    order = np.lexsort((entries.truck, entries.at, entries.lane))
    lane, at = entries.lane[order], entries.at[order]
    new = np.ones(len(order), bool)
    new[1:] = (np.diff(lane) != 0) | (np.diff(at) != 0)
    cuts = [*np.flatnonzero(new).tolist(), len(order)]
    for begin, end in itertools.pairwise(cuts):
        if end - begin < 2:
            continue
        who = order[begin:end].tolist()
        one = int(lane[begin])
        each = int(instance.alone[one] - instance.member[one])
        once = int(instance.extra[one])
        if 2 * each <= once:
            continue
        if instance.largest and instance.largest <= MOST_SIZES:
            _add_sizes(who, each, once, instance.largest, columns, rows)
        else:
            _add_any(who, each, once, instance.largest, columns, rows)


def _add_sizes(
    who: list[int], each: int, once: int, largest: int, columns: _Columns, rows: _Rows
) -> None:
    n = len(who)
    sizes = range(2, min(largest, n) + 1)
    z = [columns.add(q * each - once, float(n // q), True) for q in sizes]
    rows.add([*z, *who], [*sizes, *[-1] * n], -np.inf, 0.0)
    for k in range(n):
        others = who[:k] + who[k + 1 :]
        rows.add([*z, *others], [*(q - 1 for q in sizes), *[-1] * (n - 1)], -np.inf, 0.0)


def _add_any(
    who: list[int], each: int, once: int, largest: int, columns: _Columns, rows: _Rows
) -> None:
    n = len(who)
    many = n // 2 if largest and n > largest else 1
    z = columns.add(-once, float(many), True)
    x = [columns.add(each, 1.0, True) for _ in who]
    for own, enters in zip(x, who, strict=True):
        rows.add([own, enters], [1, -1], -np.inf, 0.0)
        rows.add([own, z], [1, -1], -np.inf, 0.0)
    rows.add([z, *x], [2, *[-1] * n], -np.inf, 0.0)
    if many > 1:
        rows.add([*x, z], [*[1] * n, -largest], -np.inf, 0.0)


def ways_of(instance: Instance, programme: Programme, values: Floats) -> Ways:
    """Return what trucks drive in a solution.

    Parameters
    ----------
    instance : Instance
        The problem.
    programme : Programme
        Its model.
    values : ndarray of float, (c,)
        A solution.

    Returns
    -------
    lanes, departs : list of ndarray of int64, (N, ...)
        In driving order.
    """
    entries = programme.entries
    used = np.flatnonzero(values[: len(entries)] > 0.5)
    used = used[np.lexsort((entries.at[used], entries.truck[used]))]
    cuts = np.searchsorted(entries.truck[used], np.arange(1, instance.trucks))
    return np.split(entries.lane[used], cuts), np.split(entries.at[used], cuts)
