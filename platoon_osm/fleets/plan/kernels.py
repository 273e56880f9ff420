"""The loops of the search: what ways through pairs cost, a sweep of responses, and some moves."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from . import group_moves
from .desk import Desk, Plan, Taste
from .draws import below, uniform
from .group_moves import banded, other_instant
from .moves import MOST, Crew, answered, moved, put_in, taken_out
from .neighbourhoods import drawn_seed, gathered, parts_of_gap
from .occupancy import Costs, Occupancy
from .pairs_used import Prices, Used

__all__ = ["HELPERS", "explore", "sweep", "through_pairs"]

Ints = NDArray[np.int64]
Floats = NDArray[np.float64]
Marks = NDArray[np.bool_]


def through_pairs(
    used: Used, price: Floats, there: Floats, onward: Floats, through: Floats
) -> None:  # fmt: skip
    """Fill what each truck's cheapest way through each pair costs more than its cheapest way.

    Parameters
    ----------
    used : Used
        Pairs.
    price : ndarray of float64, (P,)
        What each costs at least [grains].
    there, onward : ndarray of float64
        Room for the spots of a truck.
    through : ndarray of float64, (P,)
        Is filled [grains].
    """
    for k in range(len(used.from_spot)):
        begin, end, spot0 = used.first[k], used.first[k + 1], used.first_spot[k]
        for s in range(used.first_spot[k + 1] - spot0):
            there[s] = onward[s] = 1e300
        there[used.from_spot[k] - spot0] = 0.0
        onward[used.to_spot[k] - spot0] = 0.0
        changed = True
        while changed:
            changed = False
            for i in range(begin, end):
                p = used.onward[i]
                u, v = used.tail_spot[p] - spot0, used.head[p] - spot0
                if onward[v] + price[p] < onward[u] - 1e-9:
                    onward[u] = onward[v] + price[p]
                    changed = True
        changed = True
        while changed:
            changed = False
            for i in range(end - 1, begin - 1, -1):
                p = used.onward[i]
                u, v = used.tail_spot[p] - spot0, used.head[p] - spot0
                if there[u] + price[p] < there[v] - 1e-9:
                    there[v] = there[u] + price[p]
                    changed = True
        best = onward[used.from_spot[k] - spot0]
        for p in range(begin, end):
            u, v = used.tail_spot[p] - spot0, used.head[p] - spot0
            through[p] = there[u] + price[p] + onward[v] - best


def sweep(
    order: Ints, slack: float, taste: Taste, used: Used, prices: Prices, costs: Costs,
    lanes: Occupancy, plan: Plan, entered: Ints, work: Desk, state: Ints, some: Crew,
) -> tuple[int, int]:  # fmt: skip
    """Let trucks respond one after another.

    Parameters
    ----------
    order : ndarray of int64
        Trucks; those without a schedule get their first.
    slack : float
        By how much a response may cost more than what the truck does now [grains].
    taste, used, prices, costs, lanes, plan, entered, work, state, some : tuples of arrays
        As of `moved`.

    Returns
    -------
    change : int
        What all pay more [grains].
    stuck : int
        A truck that has no schedule; -1 if all have one.
    """
    change, stuck = 0, -1
    row = len(some.lengths) - 1
    for k in order:
        change -= taken_out(k, row, used, costs, lanes, plan, entered, some)
        count = answered(
            k, row, slack, used, prices, costs, lanes, plan, taste, work, state, some
        )  # fmt: skip
        if count >= 0:
            change += put_in(k, work.legs, work.departs, count, used, costs, lanes, plan, entered)
        elif count == -2:
            change += put_in(
                k, some.legs[row], some.departs[row], some.lengths[row], used, costs, lanes, plan,
                entered,
            )  # fmt: skip
        else:
            stuck = k
    return change, stuck


def explore(
    moves: int, size: int, group: float, temperature: float, active: Ints, is_active: Marks,
    guide: NDArray[np.int32], guide_count: Ints, used: Used, prices: Prices, costs: Costs,
    lanes: Occupancy, plan: Plan, entered: Ints, work: Desk, state: Ints, some: Crew, sums: Floats,
) -> int:  # fmt: skip
    """Do some moves.

    Parameters
    ----------
    moves : int
        How many.
    size : int
        Trucks of a neighbourhood at most.
    group : float
        Share of group moves.
    temperature : float
        See `moves.py` [grains].
    active, is_active : ndarray of int64, ndarray of bool
        Trucks that may be moved.
    guide, guide_count : ndarray of int32, ndarray of int64
        As of `gathered`.
    used, prices, costs, lanes, plan, entered, work, state, some : tuples of arrays
        As of `moved`.
    sums : ndarray of float64
        Room for running sums.

    Returns
    -------
    int
        What all pay more [grains].
    """
    change = 0
    parts_of_gap(active, used, prices, costs, lanes, plan, sums)
    for _ in range(moves):
        k = drawn_seed(active, sums, state)
        if plan.lengths[k] == 0:
            continue
        draw = uniform(state)
        trust = 1.0 if draw < 0.5 else (uniform(state) if draw < 0.85 else 0.0)
        blur = 0.05 * uniform(state) if uniform(state) < 0.3 else 0.0
        spread = 0.5 if trust > 0.0 and uniform(state) < 0.6 else 0.0
        lane, instant, bonus = -1, -1, 0.0
        if uniform(state) < group:
            q = below(state, plan.lengths[k])
            p = plan.legs[k, q]
            instant = other_instant(p, plan.departs[k, q], lanes, used, state)
            if instant < 0:
                continue
            lane = used.lane[p]
            bonus = 3.0 * uniform(state) * costs.extra[lane]
            found = banded(
                k, q, min(2 * size, MOST), below(state, 3), is_active, used, plan, entered, state,
                some,
            )  # fmt: skip
        else:
            wanted = 2 + below(state, size - 1)
            found = gathered(
                k, wanted, is_active, guide, guide_count, used, plan, state, some
            )  # fmt: skip
        taste = Taste(trust, blur, spread, 0.0, lane, instant, bonus)
        change += moved(
            found, temperature, taste, used, prices, costs, lanes, plan, entered, work, state, some
        )  # fmt: skip
        for i in range(found):
            some.inside[some.truck[i]] = False
    return change


HELPERS = group_moves.HELPERS
