"""Who leads a plan, and what the others would give, in a sentence."""

from __future__ import annotations

from dataclasses import dataclass

from .plan import Plan
from .text_table import listed, named

__all__ = ["Leading", "leading", "leading_text"]

SAME = 1e-9
"""Costs that differ by this share are the same."""


@dataclass(frozen=True, slots=True)
class Leading:
    """Who leads a plan, and who else might.

    Attributes
    ----------
    who : str
        The master's name.
    others : tuple of str
        Those who would give the best of the other plans; empty if no other was tried.
    saving : float or None
        The share of all costs saved with one of them in front; None if it is the same.
    """

    who: str
    others: tuple[str, ...] = ()
    saving: float | None = None


def leading(plan: Plan) -> Leading | None:
    """Return who leads and what the runner-up would give.

    Parameters
    ----------
    plan : Plan
        Any.

    Returns
    -------
    Leading or None
        None if no master was chosen.
    """
    masters = [one.master for one in plan.platoons if one.master is not None]
    if not plan.masters or not masters or not any(one.together for one in plan.stretches):
        return None
    chosen = masters[0]
    who = plan.trips[chosen].vehicle
    others = sorted(
        (one for one in plan.masters if one.vehicle != chosen), key=lambda one: one.cost
    )
    if not others:
        return Leading(who)
    least = others[0].cost
    level = least * (1 + SAME)
    # Whoever was tried along several routes is named once.
    best = dict.fromkeys(one.vehicle for one in others if one.cost <= level)
    names = tuple(plan.trips[vehicle].vehicle for vehicle in best)
    if level >= plan.joint_cost >= level * (1 - 3 * SAME):
        return Leading(who, names)
    saving = 1 - least / plan.solo_cost if plan.solo_cost else 0.0
    # Nothing is no loss: sums of the same edges differ in their last digits.
    return Leading(who, names, 0.0 if abs(saving) < SAME else saving)


def leading_text(plan: Plan) -> str:
    """Return who leads and what the runner-up would give, in a sentence.

    Parameters
    ----------
    plan : Plan
        Any.

    Returns
    -------
    str
        Empty if no master was chosen.
    """
    if (found := leading(plan)) is None:
        return ""
    # Whose route the others join is the master, also where all lead in turns.
    turns = plan.rotation is not None
    lead = f"{named(found.who)} {'keeps its route' if turns else 'leads'}"
    if not found.others:
        return f"{lead}."
    names = listed(list(found.others))
    names = f"any of {names}" if len(found.others) > 1 else names
    gives = "the same" if found.saving is None else f"{found.saving:.1%} saved in all"
    return f"{lead}; with {names} {'as master' if turns else 'in front'} it would be {gives}."
