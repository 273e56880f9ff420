"""Whether a plan in the making can be driven: nobody waits in a circle, nobody beyond its limits.

Every demand on times says "not before": a piece starts when all who drive it are there, and nobody
leaves before it may. So starting each piece as early as possible is the earliest for all, and the
plan can be driven iff these times keep every latest departure and arrival.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from graphlib import CycleError

from ...plans.stretches import Run, stretched
from .limits import Window
from .pieces import Pieces, pieces_of

__all__ = ["DriveTime", "InTime", "earliest_starts", "pieces_of_runs"]

DriveTime = Callable[[Sequence[int], Sequence[int]], float]
"""From a company and edges to seconds."""

HAIR_S = 1e-6
"""Sums of the same driving times may differ by less than this [s]."""


@dataclass(frozen=True, slots=True)
class _Timed:
    """A stretch of which only company and driving time are known."""

    vehicles: tuple[int, ...]
    drive_s: float


class InTime:
    """Tells whether vehicles can drive some runs within their limits.

    Parameters
    ----------
    drive_s : callable
        Returns how long a company takes for some edges [s].
    windows : sequence of Window, (N,), or None
        Limits of each vehicle; None if nobody names a time.
    """

    def __init__(self, drive_s: DriveTime, windows: Sequence[Window] | None) -> None:
        self._drive_s, self._windows = drive_s, windows

    def __call__(self, runs: Sequence[Sequence[Run]]) -> bool:
        """Tell whether the runs can be driven.

        Parameters
        ----------
        runs : sequence of sequence of Run, (N, ...)
            Each vehicle's in driving order.

        Returns
        -------
        bool
            False if vehicles wait for each other in a circle, or somebody cannot keep its limits.
        """
        pieces = pieces_of_runs(runs, self._drive_s)
        if pieces is None:
            return False
        return self._windows is None or _kept(pieces, self._windows)


def pieces_of_runs(runs: Sequence[Sequence[Run]], drive_s: DriveTime) -> Pieces | None:
    """Return the pieces that runs are driven in.

    Parameters
    ----------
    runs : sequence of sequence of Run, (N, ...)
        Each vehicle's in driving order.
    drive_s : callable
        Returns how long a company takes for some edges [s].

    Returns
    -------
    Pieces or None
        None if vehicles wait for each other in a circle.
    """
    stretches, ways = stretched(runs)
    driven: dict[int, set[int]] = {}
    for index, way in enumerate(ways):
        for stretch in way:
            driven.setdefault(stretch, set()).add(index)
    if any(driven[k] != set(run.company) for k, run in enumerate(stretches)):
        return None  # one drives on where another turns off and comes back
    timed = [_Timed(run.company, drive_s(run.company, run.edges)) for run in stretches]
    try:
        return pieces_of(timed, ways)
    except CycleError:
        return None


def earliest_starts(pieces: Pieces, windows: Sequence[Window]) -> list[float]:
    """Return the earliest start of each piece.

    Parameters
    ----------
    pieces : Pieces
        In an order of time.
    windows : sequence of Window, (N,)
        Limits of the vehicles.

    Returns
    -------
    list of float
        Seconds; minus infinity where nobody names an earliest departure.
    """
    starts: list[float] = []
    for k, piece in enumerate(pieces.pieces):
        if piece.root != k:
            starts.append(starts[piece.root] + piece.offset_s)
            continue
        ready = [
            starts[last] + pieces.pieces[last].time_s + stands
            for last, stands in zip(piece.before, piece.stands_s, strict=True)
        ]
        ready += [low for index in piece.begins if (low := windows[index].earliest) is not None]
        starts.append(max(ready, default=-math.inf))
    return starts


def _kept(pieces: Pieces, windows: Sequence[Window]) -> bool:
    starts = earliest_starts(pieces, windows)
    for way, window in zip(pieces.ways, windows, strict=True):
        first, last = way[0], way[-1]
        end = starts[last] + pieces.pieces[last].time_s
        if window.arrival is not None and end > window.arrival + HAIR_S:
            return False
        # In company it may leave its origin in time and wait there; alone it just leaves.
        alone = len(pieces.pieces[first].company) == 1
        if alone and window.latest is not None and starts[first] > window.latest + HAIR_S:
            return False
    return True
