"""What happens in a plan one after another: who comes from where to which stretch, and who merges.

It is what a day of late vehicles is played through by. A vehicle waits for others only where it
merges; breaks, rests and bans last as planned, and a stop for a ban does not end before it was to.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from graphlib import TopologicalSorter
from itertools import pairwise

from ..errors import ScenarioError
from ..plans.plan import Plan
from ..plans.standing import asked_by_rules, standing
from ..plans.timetable import VehicleTimes

__all__ = ["AT_ORIGIN", "Course", "Merge", "Step", "course_of"]

AT_ORIGIN = -1
"""Instead of a stretch that a vehicle comes from."""


@dataclass(frozen=True, slots=True)
class Merge:
    """Vehicles that join others where a stretch begins.

    Attributes
    ----------
    event : int
        Its position in the plan's events.
    movers, others : tuple of int
        Who joins whom, positions in the plan.
    host : int
        Of the others the one that the movers look for: the master, or who drives foremost.
    is_first : bool
        Whether it is one vehicle that joins one, and neither was in company before or stood for a
        ban.
    """

    event: int
    movers: tuple[int, ...]
    others: tuple[int, ...]
    host: int
    is_first: bool


@dataclass(frozen=True, slots=True)
class Step:
    """A stretch, driven by its vehicles at one time if all goes as planned.

    Attributes
    ----------
    stretch : int
        Its position in the plan.
    vehicles : tuple of int
        Who drives it, in the order in which they drive.
    before : tuple of int
        The stretch that each of them comes from.
    stands_s : tuple of float
        How long each stands before it, other than for company [s].
    not_before_s : tuple of float
        Before when each does not start [s]; -inf without a ban.
    drive_s : float
        How long it takes [s].
    merges : tuple of Merge
        Who merges where it begins.
    """

    stretch: int
    vehicles: tuple[int, ...]
    before: tuple[int, ...]
    stands_s: tuple[float, ...]
    not_before_s: tuple[float, ...]
    drive_s: float
    merges: tuple[Merge, ...]


@dataclass(frozen=True, slots=True)
class Course:
    """All stretches of a plan, each after those that its vehicles come from.

    Attributes
    ----------
    steps : tuple of Step
        In an order of time.
    departures_s : tuple of float, (N,)
        When each vehicle leaves by the timetable [s].
    """

    steps: tuple[Step, ...]
    departures_s: tuple[float, ...]

    @property
    def merges(self) -> tuple[Merge, ...]:
        """All merges, in the order of the steps."""
        return tuple(merge for step in self.steps for merge in step.merges)


def course_of(plan: Plan) -> Course:
    """Return what happens in a plan one after another.

    Parameters
    ----------
    plan : Plan
        With a timetable.

    Returns
    -------
    Course
        The same for the same plan.

    Raises
    ------
    ScenarioError
        A plan without times.
    """
    if plan.timetable is None:
        raise ScenarioError(
            "delays: the plan has no timetable; give at least one trip an earliest_departure"
        )
    times = plan.timetable.vehicles
    stands = [_stands(own) for own in times]
    before: list[dict[int, int]] = [{} for _ in plan.stretches]
    legs: list[dict[int, int]] = [{} for _ in plan.stretches]
    for index, way in enumerate(plan.ways):
        for leg, (last, k) in enumerate(pairwise((AT_ORIGIN, *way))):
            before[k][index], legs[k][index] = last, leg
    after = {k: sorted({*last.values()} - {AT_ORIGIN}) for k, last in enumerate(before)}
    merges = _merges(plan, times)
    steps = []
    for k in TopologicalSorter(after).static_order():
        stretch = plan.stretches[k]
        here = [(stands[index], legs[k][index]) for index in stretch.vehicles]
        steps.append(
            Step(
                k,
                stretch.vehicles,
                tuple(before[k][index] for index in stretch.vehicles),
                tuple(own.get(leg, (0.0, -math.inf))[0] for own, leg in here),
                tuple(own.get(leg, (0.0, -math.inf))[1] for own, leg in here),
                stretch.drive_s,
                tuple(merges.get(k, ())),
            )
        )
    return Course(tuple(steps), tuple(own.departure_s for own in times))


def _stands(times: VehicleTimes) -> dict[int, tuple[float, float]]:
    """Return how long a vehicle stands before its legs, and before when it does not go on."""
    found: dict[int, tuple[float, float]] = {}
    for pause in standing(times):
        is_ban = "ban" in pause.purposes
        if asked_by_rules(pause) or is_ban:
            stood, until = found.get(pause.before, (0.0, -math.inf))
            until = max(until, pause.end_s) if is_ban else until
            found[pause.before] = (stood + pause.duration_s, until)
    return found


def _merges(plan: Plan, times: Sequence[VehicleTimes]) -> dict[int, list[Merge]]:
    masters = {platoon.master for platoon in plan.platoons}
    found: dict[int, list[Merge]] = {}
    for number, event in enumerate(plan.events):
        if event.kind != "merge":
            continue
        there = event.others or event.movers
        order = [k for k in plan.stretches[event.stretch].vehicles if k in there]
        host = next((k for k in order if k in masters), order[0])
        # Where all come by themselves, the foremost is who the others look for.
        others = event.others or (host,)
        movers = tuple(k for k in event.movers if k not in others)
        first = len(movers) == len(others) == 1 and all(
            _comes_alone(plan, times[k], k, event.stretch) for k in (*movers, *others)
        )
        found.setdefault(event.stretch, []).append(Merge(number, movers, others, host, first))
    return found


def _comes_alone(plan: Plan, times: VehicleTimes, vehicle: int, stretch: int) -> bool:
    """Tell whether nothing but its own delay decides when a vehicle comes to a stretch."""
    way = plan.ways[vehicle]
    place = way.index(stretch)
    banned = any("ban" in pause.purposes and pause.before <= place for pause in times.pauses)
    return not banned and not any(plan.stretches[k].together for k in way[:place])
