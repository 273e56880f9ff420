"""Who leads a plan, and what the others would give, in a sentence."""

from __future__ import annotations

from collections.abc import Sequence

from .plan import Plan
from .records import MasterTried
from .text_table import listed, named

__all__ = ["leading_text"]

SAME = 1e-9
"""Costs that differ by this share are the same."""


def leading_text(plan: Plan) -> str:
    """Return who leads and what the runner-up would give.

    Parameters
    ----------
    plan : Plan
        Any.

    Returns
    -------
    str
        A sentence; empty if no master was chosen.
    """
    masters = [one.master for one in plan.platoons if one.master is not None]
    if not plan.masters or not masters or not any(one.together for one in plan.stretches):
        return ""
    chosen = masters[0]
    lead = f"{named(plan.trips[chosen].vehicle)} leads"
    others = sorted(
        (one for one in plan.masters if one.vehicle != chosen), key=lambda one: one.cost
    )
    if not others:
        return f"{lead}."
    level = others[0].cost * (1 + SAME)
    same = [one for one in others if one.cost <= level]
    names = listed([plan.trips[one.vehicle].vehicle for one in same])
    names = f"any of {names}" if len(same) > 1 else names
    gives = (
        "the same" if level >= plan.joint_cost >= level * (1 - 3 * SAME) else _saving(plan, same)
    )
    return f"{lead}; with {names} in front it would be {gives}."


def _saving(plan: Plan, same: Sequence[MasterTried]) -> str:
    saved = 1 - same[0].cost / plan.solo_cost if plan.solo_cost else 0.0
    return f"{saved:.1%} saved in all"
