"""The verdict on a finished plan: every violation of driving rules in it, and of its own word."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import TYPE_CHECKING, NamedTuple

from ..errors import ScenarioError
from ..kinds import kind_of
from ..plans.plan import Plan
from .agreement import disagreements
from .plan_records import driver_records
from .rule_sets import rule_set
from .violation import Violation

if TYPE_CHECKING:
    from .plan_records import DriverRecord

__all__ = ["Found", "driving_of", "inspect_plan"]


class Found(NamedTuple):
    """A violation, and whose it is."""

    vehicle: str
    driver: int
    violation: Violation


def inspect_plan(plan: Plan, rules: str | None = None, *, article_12: bool = False) -> list[Found]:
    """Return every violation in a plan's timetable; an empty list if there is none.

    Only the timetable is looked at, and who drives which stretch; how the plan was found plays no
    part. See docs/checker.md for how the law is read.

    Parameters
    ----------
    plan : Plan
        From whomever; one without a timetable has nothing that could be wrong.
    rules : {"eu561", "us395", "spread-rest", "none"}, optional
        Which rules to look at; by default those that the timetable names, none if it names none.
    article_12 : bool
        Whether to mark violations that (EC) 561/2006 art. 12 would excuse.

    Returns
    -------
    list of (str, int, Violation)
        Name of the vehicle, number of its driver, and the violation, whose `at_s` counts from the
        start of the timetable; vehicle by vehicle, in order of time. The number is 0 where the
        vehicle's times contradict each other ("plan") or leave its windows ("window").

    Raises
    ------
    ScenarioError
        Rules that have no checker, or an argument that is none.
    """
    if not isinstance(plan, Plan):
        raise ScenarioError(f"inspect_plan: plan is a {kind_of(plan)}; give a Plan")
    if not isinstance(article_12, bool):
        raise ScenarioError(f"inspect_plan: article_12 is a {kind_of(article_12)}; give a bool")
    own = "" if plan.timetable is None else plan.timetable.rules
    chosen = rule_set(own if rules is None else rules)
    found: list[tuple[int, int, Violation]] = [
        (vehicle, 0, violation) for vehicle, violation in disagreements(plan, chosen)
    ]
    for one in driver_records(plan):
        for violation in chosen.check(one.record, one.start, one.clock_s, article_12):
            moved = replace(violation, at_s=violation.at_s + one.monday_s)
            found.append((one.vehicle, one.driver, moved))
    found.sort(key=lambda item: (item[0], item[2].at_s, item[1], item[2].article))
    names = [trip.vehicle for trip in plan.trips]
    return [Found(names[vehicle], driver, violation) for vehicle, driver, violation in found]


def driving_of(plan: Plan) -> tuple[int, int]:
    """Return how many drivers a plan has, and how long they drive in all.

    Parameters
    ----------
    plan : Plan
        With a timetable.

    Returns
    -------
    int
        Drivers.
    int
        Driving, as the rules count it [s].
    """
    drivers: Sequence[DriverRecord] = list(driver_records(plan))
    driven = (activity.driven_s for one in drivers for activity in one.record)
    return len(drivers), sum(driven)
