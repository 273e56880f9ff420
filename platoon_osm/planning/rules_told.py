"""What a plan says of its driving rules once it is made: what it breaks of them, and their name.

Rules with limits name themselves where breaks and rests are planned. Rest that is spread over the
driving stands in no pause, so that nothing but the name tells why all driving takes longer.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from ..driving.rules import Drive, DrivingRules, spread_of
from ..plans.plan import Plan

__all__ = ["named_rules", "with_rules"]


def named_rules(rules: DrivingRules) -> tuple[str, ...]:
    """Return the condition that names driving rules which spread rest over the driving.

    Parameters
    ----------
    rules : DrivingRules
        Of a problem.

    Returns
    -------
    tuple of str
        One sentence; none for other rules, which say so where they are planned by.
    """
    return (f"driving rules {rules.name}",) if spread_of(rules) else ()


def with_rules(plan: Plan, rules: DrivingRules) -> Plan:
    """Return a plan that names rules which spread rest, and remarks what it breaks of any.

    Parameters
    ----------
    plan : Plan
        Finished but for this.
    rules : DrivingRules
        It was made by.

    Returns
    -------
    Plan
        With the name among the conditions of its proof, and in its timetable if it has one.
    """
    remarks = [
        f"{vehicle.vehicle}: {violation.text}"
        for index, vehicle in enumerate(plan.vehicles)
        for violation in rules.violations(_day(plan, index))
    ]
    plan = replace(plan, remarks=(*plan.remarks, *remarks)) if remarks else plan
    named = named_rules(rules)
    if not named:
        return plan
    table = plan.timetable
    return replace(
        plan,
        proof=replace(plan.proof, conditions=(*plan.proof.conditions, *named)),
        timetable=None if table is None else replace(table, rules=rules.name),
    )


def _day(plan: Plan, index: int) -> Sequence[Drive]:
    times = plan.times[index]
    waits = times.waits if times else (0.0,) * len(plan.ways[index])
    return [
        Drive(plan.stretches[k].drive_s, plan.stretches[k].vehicles[0] == index, wait)
        for k, wait in zip(plan.ways[index], waits, strict=True)
    ]
