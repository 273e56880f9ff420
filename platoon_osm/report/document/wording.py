"""Words that several parts of a document use: counts, letters in a row, costs of one thing."""

from __future__ import annotations

from collections.abc import Sequence

from ..markup.quantities import CostUnit, percent, signed
from .model_vehicle import CostTexts

__all__ = ["MOST_NAMED", "cost_texts", "counted", "joined"]

MOST_NAMED = 5
"""Vehicles named one by one; a larger company is called the platoon."""


def counted(number: int, one: str, many: str) -> str:
    """Return a number of things.

    Parameters
    ----------
    number : int
        How many.
    one, many : str
        What one is called, and several.

    Returns
    -------
    str
        "1 vehicle", "3 vehicles".
    """
    return f"{number} {one if number == 1 else many}"


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
        return f"{', '.join(letters[: most - 1])} and {len(letters) - most + 1} more"
    return " and ".join(part for part in (", ".join(letters[:-1]), *letters[-1:]) if part)


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
