"""What one vehicle pays on a stretch of road, and what it would pay there alone."""

from __future__ import annotations

from dataclasses import dataclass

__all__ = ["Share"]


@dataclass(frozen=True, slots=True)
class Share:
    """One vehicle's part of what a stretch costs.

    Attributes
    ----------
    cost : float
        What it pays there as planned, in the unit of the plan.
    alone_cost : float or None
        What it would pay there alone; None if a plan of an older version does not tell.
    fuel_l, alone_fuel_l : float
        Fuel as planned and alone [l].
    money : float or None
        What it pays as planned, where costs are not money themselves; None if nobody worked it out.
    """

    cost: float
    alone_cost: float | None
    fuel_l: float
    alone_fuel_l: float
    money: float | None = None

    @property
    def gain(self) -> float | None:
        """What company saves there; None if the cost alone is not known."""
        return None if self.alone_cost is None else self.alone_cost - self.cost
