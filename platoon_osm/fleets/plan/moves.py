"""One move of the search: trucks are taken out and put back, and the change accepted or not.

They are put back one after another by their responses with guesses, then respond once or twice
more to what all really do. The change in cost is exact, in whole numbers; a rise is accepted with
probability exp(-rise / temperature) (Metropolis), else all is as it was.
"""

from __future__ import annotations

from math import exp
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from . import waiting
from .desk import Desk, Plan, Taste
from .draws import below, uniform
from .entering import flavoured, price_now
from .occupancy import Costs, Occupancy, enter, leave
from .pairs_used import Prices, Used
from .responses import respond
from .waiting import respond_waiting, waits

__all__ = ["HELPERS", "MOST", "Crew", "answered", "crew", "moved", "put_in", "taken_out"]

Ints = NDArray[np.int64]
Floats = NDArray[np.float64]

MOST = 64
"""Trucks of one move at most."""


class Crew(NamedTuple):
    """The trucks of a move, and what they did before it.

    Attributes
    ----------
    truck : ndarray of int64, (MOST,)
        Them.
    inside : ndarray of bool, (N,)
        Whether a truck is one of them.
    legs, departs, lengths : ndarray of int32, ndarray of int64, ndarray of int64
        Their schedules before, a row each; the last row is for one truck's response.
    """

    truck: Ints
    inside: NDArray[np.bool_]
    legs: NDArray[np.int32]
    departs: Ints
    lengths: Ints


def crew(trucks: int, width: int) -> Crew:
    """Return space for the trucks of a move.

    Parameters
    ----------
    trucks, width : int
        Trucks of the fleet, and most lanes of a schedule.

    Returns
    -------
    Crew
        For one thread.
    """
    return Crew(
        np.zeros(MOST, np.int64), np.zeros(trucks, np.bool_),
        np.zeros((MOST + 1, width), np.int32), np.zeros((MOST + 1, width), np.int64),
        np.zeros(MOST + 1, np.int64),
    )  # fmt: skip


def taken_out(
    k: int, row: int, used: Used, costs: Costs, lanes: Occupancy, plan: Plan, entered: Ints,
    some: Crew,
) -> int:  # fmt: skip
    """Take a truck out and keep its schedule in a row; return what all pay less.

    Parameters
    ----------
    k, row : int
        The truck, and which row of `some`.
    used, costs, lanes, plan, entered, some : Used, Costs, Occupancy, Plan, ndarray, Crew
        As of `moved`.

    Returns
    -------
    int
        The difference [grains].
    """
    less = 0
    for q in range(plan.lengths[k]):
        p, instant = plan.legs[k, q], plan.departs[k, q]
        some.legs[row, q], some.departs[row, q] = p, instant
        entered[p] = -1
        less += leave(lanes, costs, used.lane[p], instant)
    if costs.waiting > 0:
        less += costs.waiting * waits(plan.legs[k], plan.departs[k], plan.lengths[k], used)
    some.lengths[row] = plan.lengths[k]
    plan.lengths[k] = 0
    return less


def put_in(
    k: int, legs: NDArray[np.int32] | Ints, departs: Ints, count: int, used: Used, costs: Costs,
    lanes: Occupancy, plan: Plan, entered: Ints,
) -> int:  # fmt: skip
    """Let a truck that is out drive a schedule; return what all pay more.

    Parameters
    ----------
    k : int
        The truck.
    legs, departs, count : ndarray of int32, ndarray of int64, int
        Its schedule.
    used, costs, lanes, plan, entered : Used, Costs, Occupancy, Plan, ndarray
        As of `moved`.

    Returns
    -------
    int
        The difference [grains].
    """
    more = 0
    for q in range(count):
        p, instant = legs[q], departs[q]
        plan.legs[k, q], plan.departs[k, q] = p, instant
        entered[p] = instant
        more += enter(lanes, costs, used.lane[p], instant)
    plan.lengths[k] = count
    if costs.waiting > 0:
        more += costs.waiting * waits(legs, departs, count, used)
    return more


def answered(
    k: int, row: int, slack: float, used: Used, prices: Prices, costs: Costs, lanes: Occupancy,
    plan: Plan, taste: Taste, work: Desk, state: Ints, some: Crew,
) -> int:  # fmt: skip
    """Write the response of a truck that is out into `work`, which may be its schedule of a row.

    Parameters
    ----------
    k, row : int
        The truck, and the row with its schedule before.
    slack : float
        By how much a response may cost more than that, or must cost less if negative [grains].
    used, prices, costs, lanes, plan, taste, work, state, some : tuples of arrays
        As of `respond` and `flavoured`.

    Returns
    -------
    int
        How many lanes it has; -1 if there is no schedule; -2 if it is that of the row.
    """
    flavoured(k, used, taste, work, state)
    upper = 1e300
    had = some.lengths[row] > 0
    if had:
        upper = price_now(
            k, some.legs[row], some.departs[row], some.lengths[row], used, prices, costs, lanes,
            plan, taste, work,
        )  # fmt: skip
    most = upper + slack if upper < 1e299 else upper
    if costs.waiting > 0:
        count = respond_waiting(k, most, used, prices, costs, lanes, plan, taste, work)
    else:
        count = respond(k, most, used, prices, costs, lanes, plan, taste, work)
    if count < 0 and had and upper < 1e299:
        return -2
    return count


def moved(
    size: int, temperature: float, taste: Taste, used: Used, prices: Prices, costs: Costs,
    lanes: Occupancy, plan: Plan, entered: Ints, work: Desk, state: Ints, some: Crew,
) -> int:  # fmt: skip
    """Take trucks out, put them back, and keep that or not; return what all pay more.

    Parameters
    ----------
    size : int
        How many trucks of `some`.
    temperature : float
        See the module's text [grains].
    taste : Taste
        How they are put back.
    used, prices, costs, lanes, plan, entered, work, state, some : tuples of arrays
        All else.

    Returns
    -------
    int
        The change [grains]; 0 if it was not accepted.
    """
    change = 0
    for i in range(size - 1, 0, -1):
        j = below(state, i + 1)
        some.truck[i], some.truck[j] = some.truck[j], some.truck[i]
    for i in range(size):
        change -= taken_out(some.truck[i], i, used, costs, lanes, plan, entered, some)
    true = Taste(0.0, 0.0, 0.0, 0.0, -1, -1, 0.0)
    failed = False
    for turn in range(3):
        other = False
        for i in range(size):
            k, row = some.truck[i], i
            if turn > 0:
                row = len(some.lengths) - 1
                change -= taken_out(k, row, used, costs, lanes, plan, entered, some)
            count = answered(
                k, row, 1e-6 if turn == 0 else -1e-6, used, prices, costs, lanes, plan,
                taste if turn == 0 else true, work, state, some,
            )  # fmt: skip
            if count >= 0:
                other = True
                change += put_in(
                    k, work.legs, work.departs, count, used, costs, lanes, plan, entered
                )  # fmt: skip
            elif count == -2:
                change += put_in(
                    k, some.legs[row], some.departs[row], some.lengths[row], used, costs, lanes,
                    plan, entered,
                )  # fmt: skip
            else:
                failed = True
        if failed or (turn > 0 and not other):
            break
        if turn == 1 and change > 20.0 * temperature:
            break
    accepted = not failed and (
        change <= 0 or (temperature > 0.0 and uniform(state) < exp(-change / temperature))
    )
    if accepted:
        return change
    row = len(some.lengths) - 1
    for i in range(size):
        taken_out(some.truck[i], row, used, costs, lanes, plan, entered, some)
    for i in range(size):
        put_in(
            some.truck[i], some.legs[i], some.departs[i], some.lengths[i], used, costs, lanes, plan,
            entered,
        )  # fmt: skip
    return 0


HELPERS = (*waiting.HELPERS, below, taken_out, put_in, answered, moved)
