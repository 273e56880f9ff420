"""Where members join a master that leaves at one moment and never waits, so that all are in time.

A member with approach time T(o, r_i) and onward time T(r_j, g) may join at r_i and leave at r_j
of a master that leaves at t0 and reaches r_i after tau_i iff

    e + T(o, r_i) - tau_i <= t0 <= l - T(r_j, g) - tau_j,

e being its earliest departure and l its latest arrival. So for each t0 the choice is that without
a clock over the entries and exits that are open. The best t0 is the earliest, or one at which an
entry opens: from any other the master can leave earlier until the next entry would close, and no
exit closes on the way.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from .limits import Window

__all__ = ["OpenPoints", "best_departure"]

Floats = NDArray[np.float64]

HAIR_S = 1e-6
MOST_DEPARTURES = 300
"""Departures of the master that are tried; of more, they are the openings of each member's own best
entry first."""


@dataclass(frozen=True, slots=True, eq=False)
class OpenPoints:
    """Between which departures of the master members can join and leave.

    Attributes
    ----------
    opens : ndarray of float, (M, K + 1)
        From which departure on each entry can be used [s].
    closes : ndarray of float, (M, K + 1)
        Until which each exit can be used [s].
    earliest, latest : float
        Departures that the master itself allows [s].
    """

    opens: Floats
    closes: Floats
    earliest: float
    latest: float

    @classmethod
    def of(
        cls,
        master: Window,
        members: Sequence[Window],
        route_s: Floats,
        approach_s: Floats,
        onward_s: Floats,
    ) -> OpenPoints:
        """Work out the moments from driving times.

        Parameters
        ----------
        master : Window
            Limits of the master.
        members : sequence of Window, (M,)
            Limits of the members.
        route_s : ndarray of float, (K + 1,)
            When the master is at each node, after its departure [s].
        approach_s, onward_s : ndarray of float, (M, K + 1)
            Driving times of the members' ways to the nodes and from them [s].

        Returns
        -------
        OpenPoints
            Infinite where nothing is asked.
        """
        infinite = np.inf
        first = np.array([-infinite if w.earliest is None else w.earliest for w in members])
        last = np.array([infinite if w.arrival is None else w.arrival for w in members])
        ends = [w for w in (master.latest,) if w is not None]
        if master.arrival is not None:
            ends.append(master.arrival - float(route_s[-1]))
        # Where there is no way that pays, an entry never opens and an exit never does either.
        way, rest = np.isfinite(approach_s), np.isfinite(onward_s)
        opens = first[:, None] + np.where(way, approach_s, 0.0) - route_s
        closes = last[:, None] - np.where(rest, onward_s, 0.0) - route_s
        return cls(
            np.where(way, opens, infinite),
            np.where(rest, closes, -infinite),
            -infinite if master.earliest is None else master.earliest,
            min(ends, default=infinite),
        )

    def at(self, departure: float, entry: Floats, leave: Floats) -> tuple[Floats, Floats]:
        """Return what joining and leaving cost if the master leaves at some moment.

        Parameters
        ----------
        departure : float
            When the master leaves [s].
        entry, leave : ndarray of float, (M, K + 1)
            Costs without a clock.

        Returns
        -------
        entry, leave : ndarray of float, (M, K + 1)
            inf where it is too late.
        """
        return (
            np.where(self.opens <= departure + HAIR_S, entry, np.inf),
            np.where(self.closes >= departure - HAIR_S, leave, np.inf),
        )


def best_departure(
    points: OpenPoints, preferred: NDArray[np.int64], cost_at: Callable[[float], float]
) -> float | None:
    """Return the master's departure at which the members' choices cost least.

    Parameters
    ----------
    points : OpenPoints
        Who can join and leave when.
    preferred : ndarray of int, (M,)
        The entry that each member would take without a clock; -1 for none.
    cost_at : callable
        Returns the cost of all if the master leaves at a moment [s].

    Returns
    -------
    float or None
        Seconds; None if nothing depends on the departure, or it cannot be kept at all.
    """
    joins = np.flatnonzero(preferred >= 0)
    own = points.opens[joins, preferred[joins]]
    rest = np.unique(points.opens[np.isfinite(points.opens)])
    some = rest[:: max(1, -(-len(rest) // MOST_DEPARTURES))]
    candidates = np.concatenate([[points.earliest], own, some])
    inside = (candidates >= points.earliest) & (candidates <= points.latest + HAIR_S)
    moments = np.unique(candidates[inside & np.isfinite(candidates)])
    if not len(moments):
        closing = points.closes[np.isfinite(points.closes)]
        moments = np.array([min(closing.min(initial=0.0), points.latest)])
        if not np.isfinite(moments).all():
            return None
    costs = [cost_at(float(at)) for at in moments]
    return float(moments[int(np.argmin(costs))])
