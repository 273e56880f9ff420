"""The linear programme of a timetable: rows, limits, bounds, and what is minimised in turn."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from .limits import NOTHING_ASKED, Window
from .pieces import Pieces

__all__ = ["Programme", "Row"]

Floats = NDArray[np.float64]
Row = dict[int, float]


class Programme:
    """Rows, limits and bounds of the linear programme.

    Its variables are the starts of all pieces (those that are settled by another are fixed at 0),
    the lateness of each vehicle, its wait at its origin, and the largest lateness.

    Parameters
    ----------
    pieces : Pieces
        In an order of time.
    windows : sequence of Window, (N,)
        What is demanded of each vehicle.
    asked : sequence of Window, (N,)
        What the trips name themselves.
    """

    def __init__(self, pieces: Pieces, windows: Sequence[Window], asked: Sequence[Window]) -> None:
        self.pieces, self.windows, self.asked = pieces, windows, asked
        self.late = len(pieces.pieces)
        self.origin_wait = self.late + len(windows)
        self.size = self.origin_wait + len(windows) + 1
        self.rows: list[Row] = []
        self.limits: list[float] = []
        self.named = self._named()
        self.bounds: list[tuple[float | None, float | None]] = [(0.0, None)] * self.size
        for k, piece in enumerate(pieces.pieces):
            self.bounds[k] = self._bounds(k)
            if piece.root == k:
                for last, stands in zip(piece.before, piece.stands_s, strict=True):
                    # t_last + d_last + s_last <= t_k, with s how long they stand there at least
                    self.limit(self.row((last, 1), (k, -1)), -self._end(last) - stands)
        for index, window in enumerate(windows):
            first, final = pieces.ways[index][0], pieces.ways[index][-1]
            if window.arrival is not None:
                late = self.late + index
                row = self.row((final, 1)) | {late: -1.0}
                self.limit(row, window.arrival - self._end(final))
                self.limit({late: 1.0, self.size - 1: -1.0}, 0.0)
            if window.latest is not None and len(pieces.pieces[first].company) > 1:
                row = self.row((first, 1)) | {self.origin_wait + index: -1.0}
                self.limit(row, window.latest)

    def limit(self, row: Row, most: float) -> None:
        """Demand that a sum is at most so much.

        Parameters
        ----------
        row : dict of int to float
            Factors by variable.
        most : float
            The limit.
        """
        self.rows.append(row)
        self.limits.append(most)

    def limit_span(self, first: int, last: int, most_s: float) -> None:
        """Demand that no more than so much lies between the start of a piece and an end.

        Parameters
        ----------
        first, last : int
            The piece that starts, and the one that ends.
        most_s : float
            The limit [s].
        """
        start = self.pieces.pieces[first].offset_s
        self.limit(self.row((last, 1), (first, -1)), most_s - self._end(last) + start)

    def limit_end(self, last: int, until: float) -> None:
        """Demand that a piece ends by a moment.

        Parameters
        ----------
        last : int
            The piece.
        until : float
            The moment [s].
        """
        self.limit(self.row((last, 1)), until - self._end(last))

    def demands(self) -> tuple[Any, Floats | None]:
        """Return all rows as a sparse matrix, and what their sums may be at most.

        Returns
        -------
        rows : csr_array or None
            One a demand; None if there are none.
        limits : ndarray of float or None
            Likewise.
        """
        from scipy.sparse import csr_array

        if not self.rows:
            return None, None
        first = np.cumsum([0, *(len(row) for row in self.rows)])
        columns = [column for row in self.rows for column in row]
        factors = [factor for row in self.rows for factor in row.values()]
        shape = (len(self.rows), self.size)
        return csr_array((factors, columns, first), shape=shape), np.array(self.limits)

    def row(self, *terms: tuple[int, float]) -> Row:
        """Return a row with factors for starts of pieces, without what is constant in them.

        Parameters
        ----------
        *terms : tuple of (int, float)
            Pieces and their factors.

        Returns
        -------
        dict of int to float
            Factors by variable.
        """
        row: Row = {}
        for piece, factor in terms:
            root = self.pieces.pieces[piece].root
            row[root] = row.get(root, 0.0) + factor
        return row

    def _end(self, piece: int) -> float:
        """Return what lies between the start of a piece's root and the piece's end."""
        one = self.pieces.pieces[piece]
        return one.offset_s + one.time_s

    def _bounds(self, k: int) -> tuple[float | None, float | None]:
        piece = self.pieces.pieces[k]
        if piece.root != k:
            return 0.0, 0.0
        begin = [self.windows[index] for index in piece.begins]
        low = [window.earliest for window in begin if window.earliest is not None]
        high = [window.latest for window in begin if window.latest is not None]
        # In company a vehicle may have to leave its origin and wait; alone it just leaves.
        alone = len(piece.company) == 1
        if begin and not self.named[min(piece.company)]:
            low.append(0.0)
        return max(low, default=None), min(high, default=None) if alone else None

    def _named(self) -> list[bool]:
        """Return for each vehicle whether it, or one it is linked with, names a time."""
        named = [False] * len(self.windows)
        for group in self.pieces.groups:
            if any(self.windows[index] != NOTHING_ASKED for index in group):
                for index in group:
                    named[index] = True
        return named

    def lateness(self) -> Floats:
        """Return the factors of all lateness.

        Returns
        -------
        ndarray of float
            By variable.
        """
        found = np.zeros(self.size)
        found[self.late : self.origin_wait] = 1
        return found

    def waiting(self) -> Floats:
        """Return the factors of all waiting, but for a constant.

        Returns
        -------
        ndarray of float
            By variable.
        """
        found = np.zeros(self.size)
        found[self.origin_wait : -1] = 1
        for way in self.pieces.ways:
            # arrival - departure, which is driving time and waiting
            for column, factor in self.row((way[-1], 1), (way[0], -1)).items():
                found[column] += factor
        return found

    def aims(self) -> Iterator[Floats]:
        """Yield what is minimised, one after another.

        Yields
        ------
        ndarray of float
            Factors by variable.
        """
        most_late, arrivals, starts = np.zeros((3, self.size))
        most_late[-1] = 1
        for group in self.pieces.groups:
            from_when = any(self.asked[index].earliest is not None for index in group)
            for index in group:
                last = self.pieces.pieces[self.pieces.ways[index][-1]].root
                arrivals[last] += -1 if self.named[index] and not from_when else 1
        if any(window.arrival is not None for window in self.windows):
            yield most_late
            yield self.lateness()
        for k, piece in enumerate(self.pieces.pieces):
            starts[k] = piece.root == k
        yield from (self.waiting(), arrivals, starts)
