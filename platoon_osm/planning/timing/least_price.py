"""What waiting and delay cost at least if given runs are driven: a linear programme.

The demands are those of the timetable (`programme.py`); what is minimised is

    w sum of waiting + d sum over who names an earliest departure of (arrival - arrival alone),

with w and d the prices of a second. Lateness, where there must be some, is made least before.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from ...costs.time_prices import TimePrices
from ...plans.stretches import Run
from .feasible import DriveTime, pieces_of_runs
from .limits import Window
from .programme import Programme

__all__ = ["least_price"]

Floats = NDArray[np.float64]

SLACK_S = 1e-5
"""How far lateness may exceed its least value [s]."""


def least_price(
    runs: Sequence[Sequence[Run]],
    drive_s: DriveTime,
    windows: Sequence[Window],
    asked: Sequence[Window],
    alone_s: Sequence[float],
    prices: TimePrices,
) -> float:
    """Return what waiting and delay cost at least.

    Parameters
    ----------
    runs : sequence of sequence of Run, (N, ...)
        Each vehicle's in driving order.
    drive_s : callable
        Returns how long a company takes for some edges [s].
    windows, asked : sequence of Window, (N,)
        How far company may move each, and what its trip names.
    alone_s : sequence of float, (N,)
        Driving time of each alone [s].
    prices : TimePrices
        Of a second.

    Returns
    -------
    float
        Of all together; inf if the runs cannot be driven.
    """
    pieces = pieces_of_runs(runs, drive_s)
    if pieces is None:
        return np.inf
    model = Programme(pieces, windows, asked)
    late, aim = model.lateness(), prices.waiting * model.waiting()
    constant = 0.0
    for index, (own, alone) in enumerate(zip(asked, alone_s, strict=True)):
        if own.earliest is None or not prices.delay:
            continue
        last = pieces.pieces[pieces.ways[index][-1]]
        aim[last.root] += prices.delay
        constant += prices.delay * (last.offset_s + last.time_s - own.earliest - alone)
    for way in pieces.ways:
        first, last = (pieces.pieces[way[k]] for k in (0, -1))
        constant += prices.waiting * (
            last.offset_s + last.time_s - first.offset_s
            - sum(pieces.pieces[piece].time_s for piece in way)
        )  # fmt: skip
    least_late = _least(model, late)
    if not np.isfinite(least_late):
        return np.inf
    model.limit(dict.fromkeys(np.flatnonzero(late).tolist(), 1.0), least_late + SLACK_S)
    return _least(model, aim) + constant


def _least(model: Programme, factors: Floats) -> float:
    """Return the least that a sum can be; inf if no times meet the demands."""
    from scipy.optimize import linprog

    rows, limits = model.demands()
    found = linprog(factors, rows, limits, bounds=model.bounds, method="highs")
    return np.inf if found.x is None else float(factors @ found.x)
