"""A star as arrays of whole numbers, as the search for a platoon's times counts in them.

Of each limit there are two values. In lower bounds a vehicle has the more generous one: long days
and reduced rests as long as any is left, or could be again. What is taken for certain keeps to the
stricter one: a long day or a reduced rest counts only if enough are left for every day of the trip.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from . import clocks as clocks_of
from .star_times import NEVER_S, OPEN_S, Span, StarTimes, VehicleRules

__all__ = ["StarNumbers", "least_s", "numbers_of_star"]

Floats = NDArray[np.float64]
Seconds = NDArray[np.int64]
Marks = NDArray[np.bool_]

FAR = clocks_of.FAR
WEEK_S = 7 * 24 * 3600
TIE = 1e-11
"""As in `search.tie_rule`: costs that differ by less, relative to the cost alone, are equal."""


@dataclass(frozen=True, slots=True, eq=False)
class StarNumbers:
    """Vehicles 0 to M - 1 are the members, M is the master, at n points of the master's way.

    The master is taken as a member that merges at the first point and separates at the last.

    Attributes
    ----------
    vehicles : ndarray of int, (M + 1, NUMBERS)
        What is known of each, see `clocks`.
    approach, onward : ndarray of int, (M + 1, n)
        Driving times to points and from them [s].
    ready, must : ndarray of int, (M + 1, n)
        When each vehicle reaches a point at the earliest, and leaves it at the latest if it is to
        be in time, with the fewest pauses [s].
    entry, leave, platoon : ndarray of float, (M + 1, n)
        What they cost, and the platoon up to each point.
    alone, slack : ndarray of float, (M + 1,)
        What each pays alone, and how far costs may differ and be equal.
    pos : ndarray of int, (n,)
        The position of each point on the master's way.
    tau : ndarray of int, (P + 1,)
        Driving time to each position [s].
    clocks : ndarray of int, (2, P + 1)
        What clocks count of it, a member's and the master's [s].
    clock_of : ndarray of int, (M + 1,)
        Which of the two a vehicle has.
    along : ndarray of float, (n,)
        Metres to each point.
    stay : ndarray of int, (P + 1,)
        The longest pause at each position [s].
    first_node : int
        The point of node 0.
    penalty : float
        What a member is charged that can neither go alone nor with the platoon.
    """

    vehicles: Seconds
    approach: Seconds
    onward: Seconds
    ready: Seconds
    must: Seconds
    entry: Floats
    leave: Floats
    platoon: Floats
    alone: Floats
    slack: Floats
    pos: Seconds
    tau: Seconds
    clocks: Seconds
    clock_of: Seconds
    along: Floats
    stay: Seconds
    first_node: int
    penalty: float

    @property
    def master(self) -> int:
        """The row of the master."""
        return len(self.alone) - 1


def numbers_of_star(star: StarTimes, in_time: Marks, plain: Marks, rests: int) -> StarNumbers:
    """Return a star as arrays.

    Parameters
    ----------
    star : StarTimes
        The master and its members.
    in_time : ndarray of bool, (M,)
        Which members may go alone: in time, and within the law.
    plain : ndarray of bool, (M,)
        Which members have no driving bans on any of their ways.
    rests : int
        Daily rests of the longest trip.

    Returns
    -------
    StarNumbers
        The same in whole numbers.
    """
    tau = np.concatenate([[0], np.cumsum(star.road.drive_s)]).astype(np.int64)
    counted = np.ceil(star.road.drive_s * (1.0 - star.relief) - 1e-6).astype(np.int64)
    clocks = np.array([np.concatenate([[0], np.cumsum(counted)]), tau], np.int64)
    node_at = star.node_at
    last = len(tau) - 1
    head = [0] if node_at[0] != 0 else []
    tail = [last] if node_at[-1] != last else []
    pos = np.concatenate([head, node_at, tail]).astype(np.int64)
    n, members = len(pos), len(star.alone)
    first = len(head)
    nodes = slice(first, first + len(node_at))
    approach = np.full((members + 1, n), NEVER_S, np.int64)
    onward = np.full((members + 1, n), NEVER_S, np.int64)
    entry, leave = np.full((members + 1, n), np.inf), np.full((members + 1, n), np.inf)
    platoon = np.zeros((members + 1, n))
    approach[:-1, nodes], onward[:-1, nodes] = star.approach_s, star.onward_s
    no_way, no_end = star.approach_s >= NEVER_S, star.onward_s >= NEVER_S
    entry[:-1, nodes] = np.where(no_way, np.inf, star.entry)
    leave[:-1, nodes] = np.where(no_end, np.inf, star.leave)
    platoon[:-1, nodes] = star.platoon
    platoon[:-1, nodes.stop :] = star.platoon[:, -1:]
    approach[-1, 0] = onward[-1, -1] = 0
    entry[-1, 0] = leave[-1, -1] = 0.0
    along = np.zeros(n)
    along[nodes], along[nodes.stop :] = star.length_m, star.length_m[-1]
    finite = np.concatenate([[1.0], star.alone[np.isfinite(star.alone)]])
    penalty = 16.0 * float(np.abs(finite).sum() + np.abs(star.platoon[:, -1:]).sum())
    alone = np.concatenate([np.where(in_time, star.alone, penalty), [np.inf]])
    slack = TIE * np.concatenate([np.where(np.isfinite(star.alone), star.alone, 0.0), [0.0]])
    reach = [
        _longest(approach[m], entry[m]) + int(tau[-1]) + _longest(onward[m], leave[m])
        for m in range(members)
    ]
    rules = [*star.member_rules, star.rules]
    spans = [*star.windows, star.window]
    vehicles = np.array(
        [
            _numbers(one, span, drives, rests, bool(free), star.monday_s)
            for one, span, drives, free in zip(
                rules, spans, [*reach, int(tau[-1])], [*plain, True], strict=True
            )
        ],
        np.int64,
    )
    ready = vehicles[:, clocks_of.EARLIEST, None] + least_s(vehicles, approach, begins=True)
    must = vehicles[:, clocks_of.ARRIVAL, None] - least_s(vehicles, onward, begins=False)
    return StarNumbers(
        vehicles, approach, onward, ready, must, entry, leave, platoon, alone, slack, pos, tau,
        clocks, np.array([0] * members + [1], np.int64), along, star.road.stay_s, first, penalty,
    )  # fmt: skip


def least_s(vehicles: Seconds, drives: Seconds, begins: bool) -> Seconds:
    """Return how long ways take at least, with pauses anywhere.

    Parameters
    ----------
    vehicles : ndarray of int, (X, NUMBERS)
        What is known of vehicles.
    drives : ndarray of int, (X, n)
        Driving times of ways of each [s].
    begins : bool
        Whether trips begin there; else clocks are at 0.

    Returns
    -------
    ndarray of int, (X, n)
        With the pauses [s].
    """
    some = {name: vehicles[:, getattr(clocks_of, name), None] for name in (
        "SPELL", "BREAK", "SECOND", "BROKEN", "PART", "DAY", "REST", "TODAY",
    )}  # fmt: skip
    driven = some["BROKEN"] if begins else 0
    today = some["TODAY"] if begins else 0
    part = some["PART"] if begins else 1
    breaks = np.maximum(0, -(-(driven + drives - some["SPELL"]) // some["SPELL"]))
    rests = np.maximum(0, -(-(today + drives - some["DAY"]) // some["DAY"]))
    # A break may always be replaced by a rest that is needed anyway.
    breaks = np.maximum(0, breaks - rests)
    half = np.where(part == 1, np.maximum(0, some["BREAK"] - some["SECOND"]), 0)
    paused = np.where(breaks > 0, breaks * np.minimum(some["BREAK"], NEVER_S) - half, 0)
    rested = np.where(rests > 0, rests * np.minimum(some["REST"], NEVER_S), 0)
    return np.asarray(np.where(drives >= NEVER_S, NEVER_S, drives + paused + rested), np.int64)


def _longest(times: Seconds, costs: Floats) -> int:
    some = times[np.isfinite(costs)]
    return int(some.max()) if len(some) else 0


def _up(seconds: float) -> int:
    return FAR if math.isinf(seconds) else math.ceil(seconds)


def _down(seconds: float) -> int:
    return FAR if math.isinf(seconds) else math.floor(seconds)


def _numbers(
    rules: VehicleRules, span: Span, drives: int, rests: int, free: bool, monday: int
) -> list[int]:
    limits, state = rules.limits, rules.state
    whole = limits.break_s
    if limits.change_s > 0:
        whole = min(whole, limits.change_s)
    first, second = FAR, FAR
    if limits.parts_s is not None:
        first, second = map(_up, limits.parts_s)
        whole = min(whole, first + second)
    if math.isinf(limits.spell_s):
        whole, first, second = FAR, FAR, FAR
    long_left = max(0, limits.long_days - state.long_days_used)
    reduced_left = max(0, limits.reduced_rests - state.reduced_rests_used)
    known = abs(span.earliest_s) < OPEN_S and abs(span.arrival_s) < OPEN_S
    lasts = span.arrival_s - span.earliest_s if known else OPEN_S
    # A new week brings long days back, a weekly rest reduced ones.
    same_week = (
        known and (span.earliest_s - monday) // WEEK_S == (span.arrival_s - monday) // WEEK_S
    )
    long_day = limits.long_day_s if long_left or not same_week else limits.day_s
    may_reduce = reduced_left > 0 or lasts >= limits.weekly_rest_s
    limited = math.isfinite(limits.day_s) or math.isfinite(limits.window_s)
    rest = limits.reduced_rest_s if limits.reduced_rests and may_reduce else limits.rest_s
    window = limits.long_window_s if may_reduce else limits.window_s
    some_left = reduced_left > rests
    sure_rest = limits.reduced_rest_s if limits.reduced_rests and some_left else limits.rest_s
    sure_window = limits.long_window_s if some_left else limits.window_s
    sure_day = limits.long_day_s if long_left > rests else limits.day_s
    day = max(limits.day_s, long_day)
    week = drives + state.driven_this_week_s
    tired = (
        week > limits.week_s
        or week + state.driven_last_week_s > limits.fortnight_s
        or state.since_weekly_rest_s + min(lasts, 2 * drives + 24 * 3600 * (1 + rests))
        > limits.weekly_after_s
    )
    holds = rules.state_at_s is not None
    begins = span.earliest_s if rules.state_at_s is None else max(rules.state_at_s, -OPEN_S)
    duty = -1 if state.duty_s is None else math.ceil(state.duty_s)
    return [
        _down(limits.spell_s), _up(whole), first, second,
        _down(day), _up(rest) if limited else FAR, _down(window),
        _down(sure_day), _up(sure_rest) if limited else FAR, _down(sure_window),
        int(free and not tired and limits.change_s == 0),
        math.ceil(state.driven_since_break_s), int(state.first_part_taken),
        (2 if limits.change_s > 0 else 1) * math.ceil(state.driven_today_s), duty, int(holds),
        max(span.earliest_s, begins) if holds else span.earliest_s, span.latest_s, span.arrival_s,
    ]  # fmt: skip
