"""Entries and exits of all members, which are replaced where the places of own ways are known."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any, Protocol

import numpy as np
from numpy.typing import NDArray

from ..driver.road import Road
from . import clocks as clocks_of
from .numbers import StarNumbers
from .own_places import MOST_LABELS
from .own_ways import ENTRY, EXIT
from .star_times import NEVER_S

__all__ = ["OwnRoads", "OwnTables"]

Seconds = NDArray[np.int64]
Marks = NDArray[np.bool_]


class OwnRoads(Protocol):
    """Says what lies on members' own ways."""

    def road_to(self, member: int, node: int) -> Road:
        """Return the way of a member to a node of the master's route.

        Parameters
        ----------
        member, node : int
            As the star numbers them.

        Returns
        -------
        Road
            Its driving time is that in the star.
        """

    def road_from(self, member: int, node: int) -> Road:
        """Return its way on from there.

        Parameters
        ----------
        member, node : int
            As the star numbers them.

        Returns
        -------
        Road
            Likewise.
        """


@dataclass(slots=True, eq=False)
class _Rows:
    """Entries or exits, of one kind: from where to where each point's are, and all of them."""

    at: Seconds
    rows: Seconds
    used: int

    def replace(self, vehicle: int, point: int, own: Seconds) -> None:
        """Replace those of a point."""
        end = self.used + len(own)
        if end > len(self.rows):
            more = np.empty((max(end, 2 * len(self.rows)), self.rows.shape[1]), np.int64)
            more[: self.used] = self.rows[: self.used]
            self.rows = more
        self.rows[self.used : end] = own
        self.at[vehicle, point] = self.used, end
        self.used = end


class OwnTables:
    """Entries and exits of one star, see `own_ways.py`.

    Parameters
    ----------
    numbers : StarNumbers
        The star.
    roads : OwnRoads or None
        What lies on members' own ways; None if they may pause anywhere.
    plain_ways, entries_by_places, exits_by_places : callable
        The kernels, compiled or not.

    Attributes
    ----------
    looked : int
        Points whose own ways were looked at.
    """

    def __init__(
        self, numbers: StarNumbers, roads: OwnRoads | None, plain_ways: Callable[..., int],
        entries_by_places: Callable[..., int], exits_by_places: Callable[..., int],
    ) -> None:  # fmt: skip
        self.numbers, self.roads = numbers, roads
        self.looked = 0
        self._by_places = entries_by_places, exits_by_places
        self._found = (
            np.empty((MOST_LABELS, ENTRY), np.int64),
            np.empty((MOST_LABELS, EXIT), np.int64),
        )
        shape = numbers.approach.shape
        self._known = np.full((2, *shape), roads is None)
        # Nothing is asked about the master: it drives its own way.
        self._known[:, numbers.master] = True
        self._until = _of_use(numbers)
        self._rows = [
            [self._plain(plain_ways, entering, sure) for sure in (False, True)]
            for entering in (True, False)
        ]

    def _plain(self, kernel: Callable[..., int], entering: bool, sure: bool) -> _Rows:
        some = self.numbers
        drives = some.approach if entering else some.onward
        at = np.zeros((*drives.shape, 2), np.int64)
        width = ENTRY if entering else EXIT
        rows = np.empty((0, width), np.int64)
        while True:
            total = kernel(
                some.vehicles,
                drives,
                some.stay[some.pos],
                self._until[1 - entering],
                NEVER_S,
                entering,
                sure,
                at,
                rows,
            )
            if total <= len(rows):
                return _Rows(at, rows, total)
            rows = np.empty((total, width), np.int64)

    def of(self, sure: bool) -> tuple[Any, ...]:
        """Return the tables of one kind, as `evaluate` takes them.

        Parameters
        ----------
        sure : bool
            Whether those are wanted that are certain.

        Returns
        -------
        tuple of ndarray
            Entries and exits.
        """
        into, out = self._rows[0][sure], self._rows[1][sure]
        return into.at, into.rows, out.at, out.rows

    def look(self, rows: Seconds, merge: Seconds, separate: Seconds) -> bool:
        """Look at the own ways to some points and from some, if that was not done yet.

        Parameters
        ----------
        rows : ndarray of int, (R,)
            Which vehicles.
        merge, separate : ndarray of int, (R,)
            A pair of points of each; -1 for none.

        Returns
        -------
        bool
            Whether any was new.
        """
        new = False
        for side, points in enumerate((merge, separate)):
            todo = (points >= 0) & ~self._known[side, rows, points]
            for k in np.flatnonzero(todo).tolist():
                self._look(side, int(rows[k]), int(points[k]))
                new = True
        return new

    def _look(self, side: int, member: int, point: int) -> None:
        some = self.numbers
        assert self.roads is not None
        node = point - some.first_node
        road = (self.roads.road_from if side else self.roads.road_to)(member, node)
        stay = road.stay_s.copy()
        end = 0 if side else road.hops
        stay[end] = max(stay[end], some.stay[some.pos[point]])
        self._known[side, member, point] = True
        self.looked += 1
        for sure in (False, True):
            found = self._found[side]
            count = self._by_places[side](
                some.vehicles[member],
                road.drive_s,
                road.clock_s,
                stay,
                sure,
                self._until[side, member, point],
                found,
            )
            if count >= 0:
                self._rows[side][sure].replace(member, point, found[:count])


def _of_use(some: StarNumbers) -> Seconds:
    """Return until when entries of points are of use, and how long exits may stand to be."""
    v, drive = some.vehicles, some.tau[some.pos]
    last = v[:, clocks_of.ARRIVAL, None]
    behind = np.where(some.onward < NEVER_S, drive + some.onward, NEVER_S)
    behind = np.minimum.accumulate(behind[:, ::-1], axis=1)[:, ::-1]
    before = np.where(some.approach < NEVER_S, some.approach - drive, NEVER_S)
    before = np.minimum.accumulate(before, axis=1) + drive
    until = last - behind + drive
    return np.stack([until, last - v[:, clocks_of.EARLIEST, None] - before - some.onward])
