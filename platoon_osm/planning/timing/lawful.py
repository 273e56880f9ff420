"""When everyone drives if some times are closed: a mixed-integer programme over the timetable's.

To the linear programme of `schedule.py` it adds, for each start t of its own that some closing may
hit, one binary z_j for each allowed interval [a_j, b_j] and one, v, for driving all the same:

    sum_j z_j + v = 1,    sum_j a_j z_j + T0 v <= t <= sum_j b_j z_j + T1 v,

T0 and T1 being the ends of the time looked at. Lateness comes first, as ever; then as few starts as
possible break a closing; then waiting, arrivals and starts are minimised as without closings. When
the intervals are chosen, the times within them are those of the linear programme again: a solver
takes 0.999999 for 1, which is most of a second of ten days.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...errors import ScenarioError
from .forbidden import Interval, allowed_between, united
from .limits import Window
from .pieces import Pieces
from .programme import Programme, Row
from .schedule import solved

__all__ = ["lawful_starts"]

Floats = NDArray[np.float64]

SLACK = 1e-6
"""How far a later aim may move an earlier one from its least value, as a share of the time looked
at: by so much a solver's 1 may be off."""

LEAST_SLACK_S = 1e-4
"""But no less than this [s]."""

ONE_MORE = 0.5
"""Less than one more start that breaks a closing."""

MARGIN_S = 2.0
"""Farther from the ends of an interval than what a solver takes for nothing [s]."""

LIMIT_S = 20.0
"""The solver is given this long for an aim, and then its best answer is taken [s]."""


def lawful_starts(
    pieces: Pieces,
    windows: Sequence[Window],
    asked: Sequence[Window],
    forbidden: Sequence[Sequence[Interval]],
    between: tuple[float, float],
) -> Floats:
    """Return the start of each piece, right but for the last digits.

    Parameters
    ----------
    pieces : Pieces
        In an order of time.
    windows, asked : sequence of Window, (N,)
        As the linear programme has them.
    forbidden : sequence of sequence of Interval
        For each piece, when it may not be started [s].
    between : (float, float)
        From when until when all drive [s].

    Returns
    -------
    ndarray of float
        Seconds.

    Raises
    ------
    ScenarioError
        No times at all.
    """
    for margin in (0.0, MARGIN_S):
        chosen = _Choices(pieces, windows, asked, forbidden, between, margin).chosen()
        model = Programme(pieces, windows, asked)
        for root, (begin, end) in chosen.items():
            low, high = model.bounds[root]
            model.bounds[root] = (
                begin if low is None else max(low, begin),
                end if high is None else min(high, end),
            )
        if all(low is None or high is None or low <= high for low, high in model.bounds):
            try:
                return solved(model)
            except ScenarioError:
                continue
    return solved(Programme(pieces, windows, asked))


class _Choices:
    """The linear programme with its binaries behind its own variables.

    A margin keeps starts that far from the ends of allowed intervals, if they are that long.
    """

    def __init__(
        self,
        pieces: Pieces,
        windows: Sequence[Window],
        asked: Sequence[Window],
        forbidden: Sequence[Sequence[Interval]],
        between: tuple[float, float],
        margin: float,
    ) -> None:
        self.linear = Programme(pieces, windows, asked)
        self.slack = max(LEAST_SLACK_S, SLACK * (between[1] - between[0]))
        self.size = self.linear.size
        self.breaking: list[int] = []
        self.sums: list[dict[int, float]] = []
        self.gaps: dict[int, tuple[int, tuple[float, float]]] = {}
        for root, closed in sorted(_by_root(pieces, forbidden).items()):
            gaps = allowed_between(closed, *between)
            self._choose(root, [_within(gap, margin) for gap in gaps], *between)
            first = self.breaking[-1] - len(gaps)
            self.gaps |= {first + k: (root, gap) for k, gap in enumerate(gaps)}

    def _choose(
        self, root: int, gaps: Sequence[tuple[float, float]], first: float, last: float
    ) -> None:
        own = range(self.size, self.size + len(gaps))
        free = self.size + len(gaps)
        self.size = free + 1
        self.breaking.append(free)
        self.sums.append(dict.fromkeys([*own, free], 1.0))
        low = {k: begin for k, (begin, _) in zip(own, gaps, strict=True)} | {free: first}
        high = {k: -end for k, (_, end) in zip(own, gaps, strict=True)} | {free: -last}
        self.linear.limit({root: -1.0} | low, 0.0)
        self.linear.limit({root: 1.0} | high, 0.0)

    def _aims(self) -> Iterator[Floats]:
        own = list(self.linear.aims())
        late = 2 if any(window.arrival is not None for window in self.linear.windows) else 0
        breaking = np.zeros(self.size)
        breaking[self.breaking] = 1.0
        for place, aim in enumerate(own):
            if place == late:
                yield breaking
            yield np.pad(aim, (0, self.size - len(aim)))

    def chosen(self) -> dict[int, tuple[float, float]]:
        """Return the interval in which each start is to be, where it breaks no closing."""
        from scipy.optimize import milp

        linear = self.linear
        integral = np.zeros(self.size, np.int64)
        integral[linear.size :] = 1
        values: Floats = np.zeros(self.size)
        for aim in self._aims():
            if not aim.any():
                continue
            found = milp(
                aim, integrality=integral, bounds=self._bounds(), constraints=self._demands(),
                options={"time_limit": LIMIT_S},
            )  # fmt: skip
            if found.x is None:
                break  # what earlier aims gave will do; the times within are found exactly
            values = found.x
            counts = not aim[: linear.size].any()
            linear.limit(
                {k: aim[k] for k in np.flatnonzero(aim).tolist()},
                float(aim @ values) + (ONE_MORE if counts else self.slack),
            )
        return {root: gap for k, (root, gap) in self.gaps.items() if values[k] > 0.5}

    def _bounds(self) -> Any:
        from scipy.optimize import Bounds

        low = [-np.inf if begin is None else begin for begin, _ in self.linear.bounds]
        high = [np.inf if end is None else end for _, end in self.linear.bounds]
        more = self.size - self.linear.size
        return Bounds(np.array(low + [0.0] * more), np.array(high + [1.0] * more))

    def _demands(self) -> list[Any]:
        from scipy.optimize import LinearConstraint

        found = [LinearConstraint(_sparse(self.sums, self.size), 1.0, 1.0)] if self.sums else []
        rows = _sparse(self.linear.rows, self.size)
        if self.linear.rows:
            found.append(LinearConstraint(rows, -np.inf, np.array(self.linear.limits)))
        return found


def _within(gap: tuple[float, float], margin: float) -> tuple[float, float]:
    begin, end = gap
    return (begin + margin, end - margin) if end - begin > 2 * margin else gap


def _by_root(
    pieces: Pieces, forbidden: Sequence[Sequence[Interval]]
) -> dict[int, tuple[Interval, ...]]:
    """Return what is forbidden for each start that is free to be chosen."""
    found: dict[int, list[Interval]] = {}
    for piece, closed in zip(pieces.pieces, forbidden, strict=True):
        if closed:
            found.setdefault(piece.root, []).extend(
                (begin - piece.offset_s, end - piece.offset_s) for begin, end in closed
            )
    return {root: united(closed) for root, closed in found.items()}


def _sparse(rows: Sequence[Row], size: int) -> Any:
    from scipy.sparse import csr_array

    first = np.cumsum([0, *(len(row) for row in rows)])
    columns = [column for row in rows for column in row]
    factors = [factor for row in rows for factor in row.values()]
    return csr_array((factors, columns, first), shape=(len(rows), size))
