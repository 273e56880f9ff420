"""From a problem to whole numbers: the lanes, windows and routes of all trips that can be planned.

A trip that cannot be planned is listed with the reason, and the others are planned: one without
any time, or that is late even alone.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace
from datetime import datetime

import numpy as np
from numpy.typing import NDArray

from ..costs.time_prices import TimePrices
from ..errors import ScenarioError
from ..planning.asked import Asked
from ..planning.ends import TripEnds
from ..planning.legal.legal_question import LegalQuestion
from ..planning.problem import Problem
from ..planning.question import Question
from ..planning.timing.limits import Window, first_named
from ..plans.clock import late_by
from ..plans.fleet import Unserved
from ..plans.timetable import LATE_S
from .instance import Instance
from .lanes import TICK_S, Lanes, grains_per_unit, lanes_of
from .lawful_trips import lawful
from .limits import Limits
from .served import served
from .windows import Wanted, paired

__all__ = ["FleetModel", "modelled"]

Ints = NDArray[np.int64]


@dataclass(frozen=True, slots=True, eq=False)
class FleetModel:
    """A problem in whole numbers, beside what it was made from.

    Attributes
    ----------
    question : Question
        The problem of the trips that can be planned, with their routes alone.
    first : datetime
        What ticks count from.
    windows : tuple of Window, (N,)
        What each trip asked for [s].
    lanes : Lanes
        The roads.
    instance : Instance
        The problem in whole numbers.
    rounds : int
        Rounds of dropping pairs that were done.
    routes : tuple of ndarray of int64, (N, ...)
        Lanes of each truck's route alone.
    unserved : tuple of Unserved
        Trips that cannot be planned.
    legal : LegalQuestion or None
        The same question with its law, under driving rules that have limits.
    """

    question: Question
    first: datetime
    windows: tuple[Window, ...]
    lanes: Lanes
    instance: Instance
    rounds: int
    routes: tuple[Ints, ...]
    unserved: tuple[Unserved, ...]
    legal: LegalQuestion | None = None


def modelled(problem: Problem, limits: Limits, refused: Sequence[Unserved] = ()) -> FleetModel:
    """Return a problem in whole numbers.

    Parameters
    ----------
    problem : Problem
        What is asked.
    limits : Limits
        Who may drive with whom, and on which routes.
    refused : sequence of Unserved, optional
        Trips that are known to be none.

    Returns
    -------
    FleetModel
        Of all trips that can be planned.

    Raises
    ------
    PlatoonError
        A question that fleets are not planned for, in one line; or no trip that can be planned.
    """
    prices = _checked(problem, limits)
    limits.check_names(trip.vehicle for trip in problem.trips)
    timed, timeless = _with_times(problem)
    question, legal, others = _in_time(timed)
    unserved = (*refused, *timeless, *others)
    windows, asked = question.windows, question.asked_windows
    if legal is not None:
        # Breaks and rests are waits: a lawful plan is one of those that the bound holds for.
        windows, asked = legal.windows, legal.asked
    first = first_named(question.problem.trips)
    assert windows is not None
    assert first is not None
    fleet, ends = question.fleet, question.ends
    largest = problem.max_platoon or 0
    alike: dict[tuple[int, str], int] = {}
    kinds = [
        alike.setdefault((kind, limits.carriers.get(end.vehicle, "")), len(alike))
        for kind, end in zip(fleet.kind, ends, strict=True)
    ]
    grains = _grains(question, prices, kinds)
    places = [node for end in ends for node in (end.origin, end.destination)]
    lanes = lanes_of(question.net, fleet, kinds, places, largest, grains)
    routes = lanes.of_routes(question.alone)
    # Breaks and rests are waits, and those that a trip has alone too cost nothing: the bound takes
    # all waits as free.
    waiting = 0 if legal is not None else math.floor(prices.waiting * TICK_S * grains)
    instance, rounds = paired(
        lanes, _wanted(lanes, ends, windows, routes), given=limits.routes == "given",
        largest=largest, waiting=waiting,
    )  # fmt: skip
    return FleetModel(
        question, first, tuple(asked), lanes, instance, rounds, tuple(routes), unserved, legal
    )


def _grains(question: Question, prices: TimePrices, kinds: Sequence[int]) -> float:
    """Return grains in a unit of cost: fine, but all lanes and any wait have to be told in them."""
    total = float(question.solo.sum())
    windows = question.windows
    if prices.waiting <= 0 or windows is None:
        return grains_per_unit(total)
    arrival = np.array([own.arrival for own in windows], np.float64)
    begins = min(
        until - alone_s if own.earliest is None else own.earliest
        for own, until, alone_s in zip(windows, arrival.tolist(), question.alone_s, strict=True)
    )
    waits = prices.waiting * float(arrival.max() - begins)
    roads = 0.0
    for kind in range(max(kinds) + 1):
        alone = question.fleet.alone(kinds.index(kind))
        roads += float(alone[np.isfinite(alone)].sum())
    return grains_per_unit(2 * max(total, waits, roads), waits=True)


def _checked(problem: Problem, limits: Limits) -> TimePrices:
    """Return the prices of time of a problem that fleets can be planned for."""
    prices = TimePrices.of(problem.objective)
    law = problem.limits_driving
    for refused, what in (
        (problem.method != "dijkstra", "the paper's A*; use method dijkstra"),
        (law and problem.task_relief > 0, "driving rules and a task_relief"),
        (
            law and limits.per_trip == "one",
            "driving rules and one platoon a trip; let trips have many",
        ),
        (law and limits.min_gain > 0, "driving rules and a min_gain"),
        (law and limits.together, "driving rules and vehicles that must drive together"),
        (problem.delays is not None or problem.robust, "delays; leave them out"),
        (problem.lead != "master", "a rotated lead; use lead master"),
        (problem.company != "anywhere", "company of the master alone; use company anywhere"),
        (prices.delay > 0, "prices of delay; use an objective without"),
        (
            prices.waiting > 0 and limits.per_trip == "one",
            "a price of waiting and one platoon a trip; let trips have many",
        ),
        (not prices.are_even, "a price of waiting that is not even; give one by the hour"),
    ):
        if refused:
            raise ScenarioError(f"fleet: fleets are not planned with {what}")
    return prices


def _with_times(problem: Problem) -> tuple[Problem, list[Unserved]]:
    """Return the problem of the trips that name a time, and the others."""
    timed = tuple(trip for trip in problem.trips if trip.times)
    unserved = [
        Unserved(trip.vehicle, "names no time; give it an earliest_departure")
        for trip in problem.trips
        if not trip.times
    ]
    if not timed:
        raise ScenarioError("fleet: no trip names a time; give each an earliest_departure")
    # A case or a master is a rule for one platoon; a fleet has none.
    return replace(problem, trips=timed, case="best", master=None), unserved


def _in_time(problem: Problem) -> tuple[Question, LegalQuestion | None, list[Unserved]]:
    """Return the question of the trips that can be in time alone, with its law, and the others."""
    asked, missing = served(problem)
    question = asked.question
    if problem.limits_driving:
        legal, others = lawful(question)
        return legal.question, legal, [*missing, *others]
    known = question.problem
    late = [
        late_by(own.earliest + alone_s - own.arrival)
        if own.earliest is not None
        and own.arrival is not None
        and own.earliest + alone_s > own.arrival + LATE_S
        else ""
        for own, alone_s in zip(question.asked_windows, question.alone_s, strict=True)
    ]
    unserved = [
        Unserved(trip.vehicle, f"late even alone by {by}; give an earlier departure or a later "
                 "arrival")
        for trip, by in zip(known.trips, late, strict=True)
        if by
    ]  # fmt: skip
    if not unserved:
        return question, None, list(missing)
    stay = tuple(trip for trip, by in zip(known.trips, late, strict=True) if not by)
    if not stay:
        raise ScenarioError(
            f"fleet: no trip can be in time; {unserved[0].vehicle!r} is {unserved[0].reason}"
        )
    return Asked.of(replace(problem, trips=stay)).question, None, [*missing, *unserved]


def _wanted(
    lanes: Lanes, ends: Sequence[TripEnds], windows: Sequence[Window], routes: Sequence[Ints]
) -> Wanted:
    """Return what trucks ask for in ticks."""
    origin, destination = (
        np.searchsorted(lanes.nodes, [getattr(end, name) for end in ends])
        for name in ("origin", "destination")
    )
    drive = np.array([int(lanes.drive[route].sum()) for route in routes], np.int64)
    arrival = np.array([window.arrival for window in windows], np.float64)
    earliest = np.array(
        [np.nan if window.earliest is None else window.earliest for window in windows]
    )
    departure = np.array([np.inf if window.latest is None else window.latest for window in windows])
    latest = np.floor(arrival / TICK_S + 1e-6)
    # Lanes are rounded up to ticks, and nobody is late for that.
    first = np.where(np.isnan(earliest), latest - drive, np.ceil(earliest / TICK_S - 1e-6))
    last = np.maximum(latest, first + drive)
    leaves = np.clip(np.floor(departure / TICK_S + 1e-6), first, last)
    return Wanted(
        origin=origin, destination=destination, earliest=first.astype(np.int64),
        latest_departure=leaves.astype(np.int64), latest=last.astype(np.int64), alone=routes,
    )  # fmt: skip
