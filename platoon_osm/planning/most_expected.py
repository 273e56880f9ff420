"""Which of several plans is expected to save most, on the same days of delays drawn at random.

The first is the cheapest if nobody is late. Another is taken only if it saves more than that by two
standard errors of the difference, for the days are a sample.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace

from ..plans.plan import Plan
from .meeting_chances import DelaysSimulated

__all__ = ["KEPT_APART", "MOST_APART", "MOST_RUNS", "ROBUST", "later_than", "most_expected"]

ROBUST = "chosen for the saving expected with delays, among the plans compared"
KEPT_APART = "company is expected to cost more than it saves, with delays"

MOST_RUNS = 4_000
"""Days on which plans are compared."""
MOST_APART = 12
"""Of larger plans nobody is taken out one by one, for every plan is timed anew."""
ERRORS = 2.0
"""Standard errors of the difference by which another plan must be better."""


def most_expected(compared: Sequence[tuple[Plan, DelaysSimulated]]) -> Plan:
    """Return the plan that is expected to save most.

    Parameters
    ----------
    compared : sequence of tuple
        Plans, and the days played through each; the first is the cheapest.

    Returns
    -------
    Plan
        With a remark on what was compared, and a condition of its proof if it is not the first.
    """
    plan, days = first = compared[0]
    chosen = max(compared, key=lambda one: one[1].chances.expected_saving)
    gained = chosen[1].saved - days.saved
    error = float(gained.std()) / math.sqrt(len(gained))
    more = chosen[1].chances.expected_saving - days.chances.expected_saving
    if more <= ERRORS * error:
        chosen = first
    remark = (
        f"{len(compared)} plans compared on {len(gained):,} days of delays: this one is "
        f"expected to save {_share(*chosen):.1%}, the cheapest {_share(plan, days):.1%}"
    )
    found = chosen[0]
    if chosen is not first and ROBUST not in found.proof.conditions:
        conditions = (*found.proof.conditions, ROBUST)
        found = replace(found, proof=replace(found.proof, conditions=conditions))
    return replace(found, remarks=(*found.remarks, remark))


def later_than(plan: Plan, than: Plan) -> bool:
    """Tell whether anybody is late by a plan who is less so by another.

    Parameters
    ----------
    plan, than : Plan
        Of the same trips.

    Returns
    -------
    bool
        By more than a second.
    """
    pairs = zip(plan.times, than.times, strict=True)
    return any(one and other and one.late_s > other.late_s + 1.0 for one, other in pairs)


def _share(plan: Plan, days: DelaysSimulated) -> float:
    return days.chances.expected_saving / plan.solo_cost if plan.solo_cost else 0.0
