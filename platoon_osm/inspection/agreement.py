"""Whether a timetable agrees with itself and with what was asked: no law, only its own word.

Who drives a stretch together drives it at the same time, and nobody faster than its road. Nobody
leaves or arrives outside its window. A pause lies between two legs, is as long as what it is for,
and one that the rules ask for says where it is. Every leg has one driver.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

from ..plans.pauses import DriverDay, Pause
from ..plans.plan import Plan
from ..plans.timetable import LATE_S, VehicleTimes
from .activities import clock_span
from .rule_sets import RuleSet
from .violation import Violation

__all__ = ["ARTICLE", "WINDOW", "disagreements"]

ARTICLE = "plan"
WINDOW = "window"
"""What stands in the place of an article."""

NEAR_S = 1.0
"""Times are planned to the second; less is none [s]."""

Said = Iterator[tuple[int, Violation]]


def disagreements(plan: Plan, rules: RuleSet) -> Said:
    """Yield where the timetable of a plan contradicts itself.

    Parameters
    ----------
    plan : Plan
        With a timetable; nothing comes of one without.
    rules : RuleSet
        That say how long a pause must be.

    Yields
    ------
    (int, Violation)
        Position of the vehicle, and what is wrong.
    """
    if plan.timetable is None:
        return
    yield from _apart(plan, plan.timetable.vehicles)
    for vehicle, times in enumerate(plan.timetable.vehicles):
        for found in (
            *_outside_window(times),
            *_pauses(times, rules),
            *_drivers(times),
        ):
            yield vehicle, found


def _apart(plan: Plan, vehicles: Sequence[VehicleTimes]) -> Said:
    spans: dict[int, tuple[float, float]] = {}
    for vehicle, (times, way) in enumerate(zip(vehicles, plan.ways, strict=True)):
        for leg, stretch in zip(times.legs, way, strict=True):
            first = spans.setdefault(stretch, leg)
            apart_s = max(abs(leg[0] - first[0]), abs(leg[1] - first[1]))
            if apart_s > LATE_S:
                text = "is not with its company on a stretch that they drive together"
                yield vehicle, Violation(ARTICLE, leg[0], apart_s, text)
            short_s = plan.stretches[stretch].drive_s - (leg[1] - leg[0])
            if short_s > NEAR_S:
                text = "drives a stretch faster than its road allows"
                yield vehicle, Violation(ARTICLE, leg[0], short_s, text)


def _outside_window(times: VehicleTimes) -> Iterator[Violation]:
    for text, at_s, over_s in (
        ("leaves before its earliest departure", times.departure_s,
         _above(times.earliest_departure_s, times.departure_s)),
        ("leaves after its latest departure", times.departure_s,
         _above(times.departure_s, times.latest_departure_s)),
        ("arrives after its latest arrival", times.arrival_s,
         _above(times.arrival_s, times.latest_arrival_s)),
    ):  # fmt: skip
        if over_s > LATE_S:
            yield Violation(WINDOW, at_s, over_s, text)


def _above(high: float | None, low: float | None) -> float:
    return 0.0 if high is None or low is None else high - low


def _pauses(times: VehicleTimes, rules: RuleSet) -> Iterator[Violation]:
    least_s = dict(rules.least_s)
    if len(times.drivers) > 1:
        least_s.update(rules.team_least_s)
    ends = [times.departure_s, *(end for _, end in times.legs)]
    parted = any(_parted_before(driver, times.departure_s, least_s) for driver in times.drivers)
    free_s = times.departure_s
    for pause in sorted(times.pauses, key=lambda one: one.start_s):
        low_s = max(free_s, ends[pause.before])
        high_s = times.legs[pause.before][0]
        outside_s = max(low_s - pause.start_s, pause.end_s - high_s)
        if outside_s > LATE_S:
            text = "pauses while it drives or pauses already"
            yield Violation(ARTICLE, pause.start_s, outside_s, text)
        free_s = pause.end_s
        for purpose in pause.purposes:
            if purpose == "break" and "change" in pause.purposes:
                continue  # who leaves the wheel takes its break beside it
            short_s = least_s.get(purpose, 0) - (pause.end_s - pause.start_s)
            if short_s >= NEAR_S:
                said = purpose.replace("_", " ")
                text = f"pauses {clock_span(round(pause.end_s - pause.start_s))} for a {said} of "
                text += clock_span(least_s[purpose])
                yield Violation(ARTICLE, pause.start_s, short_s, text)
        if least_s and pause.is_break and pause.place is None:
            text = "takes a break or rest at no stated place"
            yield Violation(ARTICLE, pause.start_s, pause.end_s - pause.start_s, text)
        if "second_part" in pause.purposes and not parted:
            text = "takes the second part of a break before the first"
            yield Violation(ARTICLE, pause.start_s, pause.end_s - pause.start_s, text)
        parted = _parted(pause, parted)


def _parted_before(driver: DriverDay, leaves_s: float, least_s: Mapping[str, float]) -> bool:
    """Return whether a driver has taken a first part when it leaves, before the trip or waiting."""
    stood_s = leaves_s - driver.state_at_s
    waited = "first_part" in least_s and stood_s >= least_s["first_part"] - NEAR_S
    return driver.state.first_part_taken or (waited and driver.state.driven_since_break_s > 0)


def _parted(pause: Pause, before: bool) -> bool:
    """Return whether the first part of a break was taken, and no whole one since."""
    if pause.is_rest or {"break", "second_part"} & set(pause.purposes):
        return False
    return before or "first_part" in pause.purposes


def _drivers(times: VehicleTimes) -> Iterator[Violation]:
    if not times.drivers:
        return
    for number, (start_s, end_s) in enumerate(times.legs):
        count = sum(one.drives is None or number in one.drives for one in times.drivers)
        if count != 1:
            who = "nobody" if count == 0 else f"{count} drivers"
            yield Violation(ARTICLE, start_s, end_s - start_s, f"has {who} at the wheel on a leg")
