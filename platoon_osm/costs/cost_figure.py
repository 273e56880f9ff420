"""A figure that costs are worked out with, and who says so."""

from __future__ import annotations

from dataclasses import dataclass

__all__ = ["CostFigure"]


@dataclass(frozen=True, slots=True)
class CostFigure:
    """A figure that costs are worked out with.

    Attributes
    ----------
    name : str
        What it is, as parameters of the objective are called.
    value : float
        The figure.
    unit : str
        Such as "EUR/l"; empty for a share.
    source : str
        Who says so, and when.
    """

    name: str
    value: float
    unit: str
    source: str
