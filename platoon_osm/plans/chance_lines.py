"""How likely the merges of a plan are, in lines for reading."""

from __future__ import annotations

from .chances import MeetingChance
from .clock import duration
from .plan import Plan
from .text_table import listed, named

__all__ = ["chance_lines"]

SELDOM = 0.005
"""A chance nearer than this to 0 or 1 is not told as if it were certain."""


def chance_lines(plan: Plan) -> list[str]:
    """Return what vehicles that are late leave of a plan.

    Parameters
    ----------
    plan : Plan
        Any.

    Returns
    -------
    list of str
        One on the whole plan, then one for each merge; none for a plan without delays.
    """
    found = plan.chances
    if found is None:
        return []
    spent = plan.solo_cost or 1.0
    days = f", {found.runs:,} days drawn" if found.seed is not None else ""
    whole = (
        f"If vehicles are late ({found.kind} delays{days}) the plan is expected to save "
        f"{found.expected_saving / spent:.1%}, waiting at its price; if nobody is, "
        f"{found.planned_saving / spent:.1%}."
    )
    return [whole, *(_meeting(plan, one) for one in found.meetings)]


def _meeting(plan: Plan, one: MeetingChance) -> str:
    event = plan.events[one.event]
    movers, others = (
        [plan.trips[k].vehicle for k in some] for some in (event.movers, event.others)
    )
    where = f"at {named(event.point.name)} with a chance of {_percent(one.chance)}"
    if not others:
        return (
            f"{listed(movers)} meet {where}; they wait for each other up to "
            f"{duration(one.wait_up_to_s)}"
        )
    meets, wait = ("meets" if len(movers) == 1 else "meet"), "waits" if len(others) == 1 else "wait"
    late = f" and late by {duration(one.missed_late_s)}" if one.missed_late_s >= 60 else ""
    return (
        f"{listed(movers)} {meets} {listed(others)} {where}: {listed(others)} {wait} up to "
        f"{duration(one.wait_up_to_s)}, {listed(movers)} up to "
        f"{duration(one.movers_wait_up_to_s)}; else alone on the planned road{late}"
    )


def _percent(chance: float) -> str:
    if chance < SELDOM:
        return "less than 1%"
    return "more than 99%" if chance > 1 - SELDOM else f"{chance:.0%}"
