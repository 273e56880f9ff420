"""Words that several parts of a document use: counts, letters in a row, costs of one thing."""

from __future__ import annotations

from collections.abc import Sequence

from ...plans.paid import paid
from ...plans.plan import Plan
from ..language.speech import say
from ..markup.quantities import CostUnit, cost_unit, percent, signed
from .model_vehicle import CostTexts

__all__ = ["MOST_NAMED", "cost_texts", "joined", "plan_unit"]

MOST_NAMED = 5
"""Vehicles named one by one; a larger company is called the platoon."""


def joined(letters: Sequence[str], most: int = MOST_NAMED) -> str:
    """Return "A, B and C".

    Parameters
    ----------
    letters : sequence of str
        What is told one after another.
    most : int
        Beyond this many it is "A, B, C and 14 more".

    Returns
    -------
    str
        Empty without letters.
    """
    if len(letters) > most:
        told, rest = letters[: most - 1], len(letters) - most + 1
        return say("list.more", n=rest, who=", ".join(told))
    *before, last = letters or [""]
    return say("list.and", before=", ".join(before), last=last) if before else last


def plan_unit(plan: Plan, largest: float | None = None) -> CostUnit:
    """Return how the costs of a plan are printed: all with as many decimals.

    Parameters
    ----------
    plan : Plan
        Whose costs they are.
    largest : float or None
        The largest cost that is printed beside them; by default that of all vehicles alone.

    Returns
    -------
    CostUnit
        Without decimals where sums are large; of a bill always to the cent.
    """
    most = paid(plan)[0] if largest is None else largest
    return cost_unit(plan.unit, most, to_the_cent=plan.bill is not None)


def cost_texts(alone: float, joint: float, unit: CostUnit) -> CostTexts:
    """Return costs as they are printed.

    Parameters
    ----------
    alone, joint : float
        Of driving alone and as planned, in the plan's unit.
    unit : CostUnit
        How they are printed.

    Returns
    -------
    CostTexts
        Both, the difference and the share saved.
    """
    return CostTexts(
        alone=unit.bare(alone),
        joint=unit.bare(joint),
        saved=unit.bare_signed(alone - joint),
        share=signed(percent(1 - joint / alone if alone else 0.0)),
    )
