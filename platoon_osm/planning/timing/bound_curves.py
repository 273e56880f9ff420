"""What no plan undercuts, whenever its master leaves: the greatest of several curves.

Between openings the total never falls, and no curve does; so the least is at an opening, or at the
first departure there is. What is known of one departure holds until something opens.
"""

from __future__ import annotations

import numpy as np

from .departure_curve import StepCurve
from .open_points import OpenPoints

__all__ = ["BoundCurves"]


class BoundCurves:
    """The greatest of several lower bounds at every departure of a master.

    Parameters
    ----------
    points : OpenPoints
        When members can join and leave.
    """

    def __init__(self, points: OpenPoints) -> None:
        self._openings = np.unique(points.opens[np.isfinite(points.opens)])
        self._first = points.first_moment
        self._curves: list[StepCurve] = []
        self._settled: list[tuple[float, float, float]] = []

    def add(self, curve: StepCurve) -> None:
        """Count one more bound.

        Parameters
        ----------
        curve : StepCurve
            A lower bound at every departure.
        """
        self._curves.append(curve)

    def settle(self, begin: float, departure: float, bound: float) -> None:
        """Raise the bound from the begin of a step until something opens after a departure.

        Parameters
        ----------
        begin : float
            Where the step begins [s].
        departure : float
            A departure in it [s].
        bound : float
            What no plan for that departure undercuts.
        """
        after = int(np.searchsorted(self._openings, departure, "right"))
        until = float(self._openings[after]) if after < len(self._openings) else np.inf
        self._settled.append((begin, until, bound))

    def lowest(self) -> tuple[float, float, float]:
        """Return where the bound is least, the earliest of equals.

        Returns
        -------
        begin : float
            Where that step begins; minus infinity if nothing is asked of the first departure [s].
        departure : float
            A departure in it [s].
        bound : float
            The bound there.
        """
        moments = [curve.since[curve.after == 0] for curve in self._curves]
        end = self._curves[0].end
        since = np.unique(
            np.concatenate([*moments, [until for _, until, _ in self._settled if until <= end]])
        )
        value = np.max([curve.values(since) for curve in self._curves], axis=0)
        for begin, until, bound in self._settled:
            some = (since >= begin) & (since < until)
            value[some] = np.maximum(value[some], bound)
        step = int(np.argmin(value))
        begin = float(since[step])
        return begin, begin if np.isfinite(begin) else self._first, float(value[step])
