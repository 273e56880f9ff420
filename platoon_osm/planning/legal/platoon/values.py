"""What vehicles of one star pay at least, or for certain: the arrays for `kernel.py`."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from . import kernel
from .nodes import Past
from .numbers import StarNumbers
from .pairs import MemberPairs
from .stops import OPEN, Clocks, MasterStops, Night, Stops
from .tables import OwnTables

__all__ = ["StarValues", "Table", "Values"]

Floats = NDArray[np.float64]
Seconds = NDArray[np.int64]
Places = NDArray[np.int32]

Table = tuple[Stops, Clocks | None, int, int] | tuple[Stops, Clocks | None, int, int, Night]
"""Stops, the clocks after them if others may follow, the span of the departure, the next rest."""


MOST_PLACES = 40960
"""Places in lists that a node keeps; of many vehicles those of several cells together."""


@dataclass(frozen=True, slots=True, eq=False)
class Values:
    """What some vehicles pay with some timetables.

    Attributes
    ----------
    cost : ndarray of float, (C, R)
        Each of them.
    rank : ndarray of int, (C, R)
        Where in its list each is.
    bound : ndarray of float, (C,)
        All together at least.
    begin, end : ndarray of int, (C,)
        What is of interest of the span [s].
    ranks : ndarray of int, (C, R, G)
        As `rank`, in each cell of the span.
    cut : ndarray of int, (C, 2)
        When the first of these cells begins, and how long each is [s].
    """

    cost: Floats
    rank: Seconds
    bound: Floats
    begin: Seconds
    end: Seconds
    ranks: Places
    cut: Seconds

    def past(self, table: int) -> Past:
        """Return what is known of the pairs of a timetable.

        Parameters
        ----------
        table : int
            Which.

        Returns
        -------
        Past
            For its parts.
        """
        begin, width = self.cut[table].tolist()
        return Past(self.ranks[table].copy(), begin, width)


@dataclass(slots=True, eq=False)
class StarValues:
    """The values of one star.

    Attributes
    ----------
    numbers : StarNumbers
        The star.
    pairs : MemberPairs
        Where members may merge and separate, the cheapest first.
    tables : OwnTables
        What members' own ways allow.
    stops : MasterStops
        Where the master may stop.
    evaluate : callable
        The kernel.
    computed : int
        Values computed.
    """

    numbers: StarNumbers
    pairs: MemberPairs
    tables: OwnTables
    stops: MasterStops
    evaluate: Any
    computed: int = 0

    def of(
        self, rows: Seconds, tables: Sequence[Table], *, sure: bool = False,
        throughout: bool = False, rank: Seconds | None = None, past: Past | None = None,
        most: float = np.inf, plan: Seconds | None = None,
    ) -> Values:  # fmt: skip
        """Return what vehicles pay with some timetables, and the places of their pairs.

        Parameters
        ----------
        rows : ndarray of int, (R,)
            Which vehicles, as `StarNumbers` numbers them.
        tables : sequence of Table, (C,)
            The timetables.
        sure : bool
            Whether entries, exits and limits are the strict ones.
        throughout : bool
            Whether pairs have to be drivable at all departures of a span; else at some.
        rank : ndarray of int, (R,) or (C, R), optional
            Where in its list each is to go on.
        past : Past, optional
            Likewise in cells of a span that holds theirs.
        most : float
            A timetable is of no interest if all together pay as much.
        plan : ndarray of int, (4,), optional
            How many stops that are not decided there may be and how long; by default as
            `MasterStops.plan`.

        Returns
        -------
        Values
            Of each timetable and vehicle.
        """
        some, pairs, size = self.numbers, self.pairs, (len(tables), len(rows))
        room = max(1, max(len(table[0]) for table in tables))
        made = np.zeros((len(tables), room, 2), np.int64)
        for k, table in enumerate(tables):
            if table[0]:
                made[k, : len(table[0])] = table[0]
        rest = np.array(
            [
                (len(one[0]), *(one[1] or (-1, 0, 0)), one[2], one[3], *(one[4:] or (OPEN,))[0])
                for one in tables
            ],
            np.int64,
        )
        own = np.zeros(len(rows), np.int64) if rank is None or not len(rows) else rank
        if past is None:
            past = Past(np.zeros((len(rows), 1), np.int32), 0, 1)
        cells = 1 if throughout else min(kernel.CELLS, max(1, MOST_PLACES // max(1, len(rows))))
        found = Values(
            np.empty(size), np.empty(size, np.int64), np.empty(len(tables)), rest[:, 4].copy(),
            rest[:, 5].copy(), np.empty((*size, cells), np.int32),
            np.zeros((len(tables), 2), np.int64),
        )  # fmt: skip
        self.evaluate(
            rows, own[None] if own.ndim == 1 else own, past.rank, past.begin, past.width,
            some.vehicles, some.approach, some.onward,
            *self.tables.of(sure), pairs.first, pairs.merge, pairs.separate, pairs.cost,
            some.alone, some.pos, some.tau, some.clocks, some.clock_of, self.stops.places,
            self.stops.plan if plan is None else plan,
            np.ascontiguousarray(made[:, :, 0]), np.ascontiguousarray(made[:, :, 1]),
            np.ascontiguousarray(rest[:, 0]), np.ascontiguousarray(rest[:, 1:4]),
            np.ascontiguousarray(rest[:, 6:]), sure, throughout,
            most, found.begin, found.end, found.bound, found.cost, found.rank, found.ranks,
            found.cut,
        )  # fmt: skip
        self.computed += len(rows) * len(tables)
        return found

    def points(self, rows: Seconds, rank: Seconds) -> tuple[Seconds, Seconds]:
        """Return where vehicles merge and separate.

        Parameters
        ----------
        rows : ndarray of int, (R,)
            Which vehicles.
        rank : ndarray of int, (R,)
            Where in its list each is.

        Returns
        -------
        merge, separate : ndarray of int, (R,)
            Points; -1 for who stays alone.
        """
        first = self.pairs.first
        at = first[rows] + rank
        met = at < first[rows + 1]
        at = np.minimum(at, first[-1] - 1)
        return np.where(met, self.pairs.merge[at], -1), np.where(met, self.pairs.separate[at], -1)

    def ends(self, rows: Seconds) -> Seconds:
        """Return how long the lists of pairs are.

        Parameters
        ----------
        rows : ndarray of int, (R,)
            Of which vehicles.

        Returns
        -------
        ndarray of int, (R,)
            Who is there in its list stays alone.
        """
        return self.pairs.first[rows + 1] - self.pairs.first[rows]

    def look(self, rows: Seconds, rank: Seconds) -> bool:
        """Look at the own ways of some vehicles by which they would pay least.

        Parameters
        ----------
        rows : ndarray of int, (R,)
            Which vehicles.
        rank : ndarray of int, (R,)
            Where in its list each is.

        Returns
        -------
        bool
            Whether any was not looked at before.
        """
        return self.tables.look(rows, *self.points(rows, rank))
