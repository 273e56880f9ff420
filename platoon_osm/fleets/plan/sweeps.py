"""All trucks respond one after another: how a plan is made from nothing.

The order is drawn. Where trucks must keep apart from others these come first, the one with the
least time before others; if one finds no way beside those before it, all begin anew, it first.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from ...errors import ScenarioError
from . import draws
from .at_hand import AtHand
from .compiled import PLAIN_S, SWEEP
from .desk import Taste, desk
from .moves import crew

__all__ = ["plain_taste", "sweeps"]

Ints = NDArray[np.int64]

ORDERS = 100
"""In how many orders trucks that must keep apart are put in before that is given up."""


def plain_taste(trust: float, crowd: float = 0.0) -> Taste:
    """Return a taste without chance and without bonus.

    Parameters
    ----------
    trust, crowd : float
        See `Taste`.

    Returns
    -------
    Taste
        How a response guesses.
    """
    return Taste(trust, 0.0, 0.0, crowd, -1, -1, 0.0)


def sweeps(
    at: AtHand,
    tastes: Sequence[Taste],
    seed: int,
    call: int,
    extra: tuple[Ints, Ints] | None = None,
) -> int:
    """Let all trucks respond, once for each taste.

    Parameters
    ----------
    at : AtHand
        The plan, which changes.
    tastes : sequence of Taste
        How they guess.
    seed, call : int
        Of the draws.
    extra : tuple of ndarray of int64, optional
        Lanes and instants that are entered besides [ticks].

    Returns
    -------
    int
        What the plan costs then [grains].

    Raises
    ------
    ScenarioError
        Trucks that must keep apart and cannot.
    """
    rng = np.random.default_rng([abs(seed), 4, call, len(tastes)])
    begun = at.legs.copy(), at.departs.copy(), at.count.copy()
    first: list[int] = []
    stuck = -1
    for _ in range(ORDERS):
        stuck = _swept(at, tastes, seed, call, extra, rng, first)
        if stuck < 0:
            return at.whole(at.copied()).cost(at.instance)
        # Others went in before it and left it no way: it begins.
        first = [stuck, *(one for one in first if one != stuck)]
        legs, departs, taken = begun
        at.legs, at.departs, at.count = legs.copy(), departs.copy(), taken.copy()
    raise ScenarioError(
        f"fleet: truck {stuck} must keep apart from others, and no way was found in which it "
        "does; widen its window"
    )


def _swept(
    at: AtHand, tastes: Sequence[Taste], seed: int, call: int, extra: tuple[Ints, Ints] | None,
    rng: np.random.Generator, first: Sequence[int],
) -> int:  # fmt: skip
    """Let all trucks respond, some before all others; return one that has no way, else -1."""
    view, count = at.view, at.instance.trucks
    lanes, entered = at.occupied(extra)
    state = draws.started(seed, 3, call)
    work, some = desk(view.used, at.width), crew(count, at.width)
    kernel = SWEEP.ready(count * len(tastes) * PLAIN_S)
    for taste in tastes:
        _, stuck = kernel(
            _order(at, rng, first), -1e-6, taste, view.used, view.prices, at.costs, lanes,
            at.plan(), entered, work, state, some,
        )  # fmt: skip
        if stuck >= 0:
            return int(stuck)
    return -1


def _order(at: AtHand, rng: np.random.Generator, first: Sequence[int]) -> Ints:
    """Draw the order in which trucks respond."""
    instance = at.instance
    order = rng.permutation(instance.trucks).astype(np.int64)
    order = order[at.is_free[order]]
    if not len(at.apart[1]):
        return order
    bound = np.diff(at.apart[0]) > 0
    spare = (instance.latest - instance.earliest).astype(np.float64)
    if first:
        spare *= rng.uniform(0.5, 1.5, instance.trucks)
        spare[list(first)] = np.arange(len(first)) - len(first)
    return order[np.lexsort((spare[order], ~bound[order]))]
