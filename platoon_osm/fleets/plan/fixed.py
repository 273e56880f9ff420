"""Trucks that drive lanes at instants that are told, and never otherwise."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np
from numpy.typing import NDArray

from .schedules import Schedules

__all__ = ["FixedWays", "entries_of", "with_fixed"]

Ints = NDArray[np.int64]
FixedWays = Mapping[int, tuple[Ints, Ints]]
"""Lanes and instants of each such truck [ticks]."""


def entries_of(fixed: FixedWays) -> tuple[Ints, Ints]:
    """Return where and when the fixed trucks enter.

    Parameters
    ----------
    fixed : mapping of int to (ndarray of int64, ndarray of int64)
        Their lanes and instants.

    Returns
    -------
    lanes, departs : ndarray of int64
        Of all of them, one after another [ticks].
    """
    none = np.zeros(0, np.int64)
    return (
        np.concatenate([none, *(lanes for lanes, _ in fixed.values())]),
        np.concatenate([none, *(departs for _, departs in fixed.values())]),
    )


def with_fixed(plan: Schedules, fixed: FixedWays) -> Schedules:
    """Return a plan in which the fixed trucks drive what is told.

    Parameters
    ----------
    plan : Schedules
        What the others drive.
    fixed : mapping of int to (ndarray of int64, ndarray of int64)
        Lanes and instants of the fixed ones.

    Returns
    -------
    Schedules
        Of all trucks.
    """
    if not fixed:
        return plan
    wider = max(0, max(len(own) for own, _ in fixed.values()) - plan.lanes.shape[1])
    lanes = np.pad(plan.lanes, ((0, 0), (0, wider)))
    departs = np.pad(plan.departs, ((0, 0), (0, wider)))
    count = plan.count.copy()
    for k, (own, at) in fixed.items():
        lanes[k, : len(own)], departs[k, : len(own)], count[k] = own, at, len(own)
    return Schedules(lanes, departs, count)
