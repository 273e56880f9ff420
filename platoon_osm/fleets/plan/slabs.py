"""The day cut in two, so that trucks of one part never meet those of the other.

The cut is drawn near the middle of the day: trucks whose windows end before it, and trucks whose
windows begin behind it, never meet, and each side is worked off with random numbers of its own, in
any order or at once; trucks across the cut wait for the next round. Where too many lie across, one
round is for all.
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

from ..instance import Instance
from . import draws
from .at_hand import AtHand
from .compiled import EXPLORE, PLAIN_S
from .desk import desk
from .habits import habits_of
from .moves import crew

__all__ = ["explored", "slabs"]

Ints = NDArray[np.int64]

CHUNK = 250
"""Moves between two questions whether to stop."""


def slabs(instance: Instance, every: Ints, seed: int, call: int) -> list[Ints]:
    """Return trucks that may be moved, in sets that never meet.

    Parameters
    ----------
    instance : Instance
        The problem.
    every : ndarray of int64
        Trucks that may be moved.
    seed, call : int
        Of the draws.

    Returns
    -------
    list of ndarray of int64
        One or two.
    """
    rng = np.random.default_rng([abs(seed), 1, call])
    middle = ((instance.earliest + instance.latest) // 2)[every]
    cut = int(np.quantile(middle, 0.5 + 0.2 * (2 * rng.random() - 1)))
    early, late = every[instance.latest[every] < cut], every[instance.earliest[every] > cut]
    if min(len(early), len(late)) < 50 or len(early) + len(late) < 0.6 * len(every):
        return [every]
    return [early, late]


def explored(
    at: AtHand,
    active: Ints,
    moves: int,
    temperature: float,
    stream: tuple[int, int, int],
    stop: Callable[[], bool],
) -> int:
    """Do the moves of one set of trucks.

    Parameters
    ----------
    at : AtHand
        The plan, which changes.
    active : ndarray of int64
        The trucks.
    moves : int
        How many neighbourhoods.
    temperature : float
        See `moves` [grains].
    stream : tuple of int
        Seed, call, and number of the set: of the draws.
    stop : callable
        Asked between chunks of moves; True ends it.

    Returns
    -------
    int
        What all pay more [grains].
    """
    view, count = at.view, at.instance.trucks
    lanes, entered = at.occupied()
    is_active = np.zeros(count, bool)
    is_active[active] = True
    seed, call, number = stream
    state = draws.started(seed, 2, call, number)
    work, some = desk(view.used, at.width), crew(count, at.width)
    sums = np.zeros(len(active))
    habits = habits_of(count)
    size = max(2, min(habits.neighbours, len(active)))
    kernel = EXPLORE.ready(moves * size * PLAIN_S)
    change, done = 0, 0
    while done < moves:
        now = min(CHUNK, moves - done)
        change += int(
            kernel(
                now, size, habits.group_moves, temperature, active, is_active, view.guide,
                view.guide_count, view.used, view.prices, at.costs, lanes, at.plan(), entered,
                work, state, some, sums,
            )
        )  # fmt: skip
        done += now
        if done < moves and stop():
            break
    return change
