"""The cheapest stops and departure of a master for its members, best first.

A node of the search (`platoon_spans.py`) is a beginning of the master's stops and a span of its
departure. Bounds hold for pauses anywhere on the members' own ways, while every plan that is
returned has been driven with real places.

What is searched: departures in whole seconds; stops at places of the master's way, of the lengths
that the law names and those asked for; as many stops as its driving needs and `extra_stops` more,
and no more daily rests than it needs, one more if there is no plan else. Of equally cheap plans one
with few stops, whole breaks and an early departure is taken (`platoon_ties.py`).
"""

from __future__ import annotations

import time

import numpy as np
from numpy.typing import NDArray

from . import platoon_kernel as kernel
from .platoon_again import Again, joined_again
from .platoon_compiled import kernels_for
from .platoon_numbers import numbers_of_star
from .platoon_record import Free, MemberTiming, PlatoonTiming, Real, Timetable
from .platoon_spans import SpanSearch
from .platoon_stops import MasterStops, Stops
from .platoon_ties import simplest
from .star_times import OPEN_S, StarTimes

__all__ = ["search_platoon"]

Marks = NDArray[np.bool_]

SAME = 1e-9
"""Sums of costs that differ by less, relative to what all pay alone, are equal."""

HORIZON_S = 48 * 3600
"""How far beyond the members' windows a master without a window may leave [s]."""


def search_platoon(
    star: StarTimes,
    real: Real | None,
    time_limit_s: float = 10.0,
    *,
    most_spans: int = 10**9,
    free: Free | None = None,
    again: Again | None = None,
    in_time: Marks | None = None,
    plain: Marks | None = None,
    extra_stops: int = 1,
    lengths: tuple[int, ...] = (),
) -> PlatoonTiming:
    """Return when a master leaves and where it stops, so that its members pay least in all.

    Parameters
    ----------
    star : StarTimes
        The master and its members.
    real : callable or None
        Says how a vehicle really drives; None if it may pause anywhere on its own ways, and no
        trips are asked for.
    time_limit_s : float
        After which the best found is returned, with its bound [s].
    most_spans : int
        After so many spans of departures likewise; unlike time, the same on every machine.
    free : callable, optional
        Says whether a member could drive by two nodes whatever the stops are; it saves questions.
    again : Again, optional
        If given, members may join again after they stopped alone, with the timetable that is found.
    in_time : ndarray of bool, (M,), optional
        Which members may go alone: in time and within the law; by default those whose cost alone is
        finite.
    plain : ndarray of bool, (M,), optional
        Which members have no driving bans or closed hours on any of their ways; by default all.
    extra_stops : int
        How many more stops are searched than the master's driving needs.
    lengths : tuple of int
        Lengths of pauses that are tried besides those that the law names [s].

    Returns
    -------
    PlatoonTiming
        Proved if nothing searched is better; else with a bound.
    """
    began = time.perf_counter()
    members = len(star.alone)
    if in_time is None:
        in_time = np.isfinite(star.alone)
    if plain is None:
        plain = np.ones(members, bool)
    begin, end = _departures(star)
    found = PlatoonTiming(np.inf, np.inf, True, None, None)
    for more in range(3):
        probe = MasterStops(numbers_of_star(star, in_time, plain, 0), 0, 0)
        clocks = probe.states((), end) or (0, kernel.FAR, 0)
        stops, rests, _ = probe.left(clocks, int(probe.numbers.tau[-1]))
        rests += more
        most = max(stops, rests) + extra_stops
        numbers = numbers_of_star(star, in_time, plain, rests + 1)
        if more and probe.numbers.vehicles[probe.numbers.master, kernel.REST] >= kernel.FAR:
            break
        total = float(np.abs(star.alone[np.isfinite(star.alone)]).sum()) + 1.0
        evaluate, next_stops = kernels_for(members * len(numbers.pos))
        stopping = MasterStops(numbers, most, rests, lengths, next_stops)
        search = SpanSearch(
            star, numbers, stopping, real, began + time_limit_s, evaluate, SAME * total, free,
            most_spans,
        )  # fmt: skip
        ended = search.run(begin, end)
        found = _result(search, ended, began, again)
        if found.timetable is not None or not ended:
            break
    return found


def _departures(star: StarTimes) -> tuple[int, int]:
    """Return the first and the last departure of the master that are searched."""
    window = star.window
    drive = int(star.road.drive_s.sum())
    last = min(window.latest_s, window.arrival_s - drive)
    known = [
        at
        for one in (*star.windows, window)
        for at in (one.earliest_s, one.latest_s, one.arrival_s)
        if abs(at) < OPEN_S // 2
    ]
    first = window.earliest_s
    if first <= -OPEN_S // 2:
        first = (min(known) - drive - HORIZON_S) if known else 0
        first = min(first, last)
    if last >= OPEN_S // 2:
        last = (max(known) + HORIZON_S) if known else first
        last = max(first, last)
    return first, last


def _result(search: SpanSearch, ended: bool, began: float, again: Again | None) -> PlatoonTiming:
    star, some = search.star, search.numbers
    alone = float(star.alone.sum()) + star.master_alone
    bound = min([search.best, *(entry[1] for entry in search.heap)])
    chosen = None
    if search.found is not None:
        stops, departure = search.found
        chosen = _choices(search, stops, departure)
        if chosen is not None and ended:
            pays = sum(one.cost if one.possible else some.penalty for one in chosen)
            stops, departure = simplest(search, stops, departure, pays, *_departures(star))
            chosen = _choices(search, stops, departure)
    counts = (search.evaluations, len(search.asked), search.spans)
    if search.found is None or chosen is None:
        return PlatoonTiming(
            np.inf, bound + star.master_alone - float(np.maximum(star.gain, 0).sum()),
            ended, None, None, (), alone, True, *counts, time.perf_counter() - began,
        )  # fmt: skip
    pays = sum(one.cost if one.possible else some.penalty for one in chosen)
    short = max(0.0, pays - bound) if not ended else 0.0
    table, complete = Timetable.of(star, departure, stops), True
    if again is not None:
        chosen, complete = joined_again(some, table, chosen, again)
    met = np.zeros(len(star.gain), bool)
    for one in chosen:
        for i, j in one.stretches:
            met[i:j] = True
    cost = sum(one.cost for one in chosen) + star.master_alone - float(star.gain[met].sum())
    trip = search.trip(some.master, 0, len(some.pos) - 1, stops, departure, 0)
    return PlatoonTiming(
        cost, cost - short, ended, table, trip, tuple(chosen), alone, complete, *counts,
        time.perf_counter() - began,
    )  # fmt: skip


def _choices(search: SpanSearch, stops: Stops, departure: int) -> list[MemberTiming] | None:
    """Return what members do at a departure; None if the master cannot leave then."""
    chosen = search.choices(stops, departure)
    if chosen is None:
        return None
    shift, penalty = search.numbers.first_node, search.numbers.penalty
    found = []
    for alone, (cost, i, j, trip) in zip(search.star.alone.tolist(), chosen, strict=True):
        if i >= 0:
            found.append(MemberTiming(cost, i - shift, j - shift, trip))
        else:
            able = cost < penalty
            found.append(MemberTiming(alone if able else np.inf, possible=able))
    return found
