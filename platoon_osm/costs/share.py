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
    terms, alone_terms : tuple of float
        Both costs term by term, in the order in which the objective has its terms; empty where it
        does not tell them apart.
    """

    cost: float
    alone_cost: float | None
    fuel_l: float
    alone_fuel_l: float
    money: float | None = None
    terms: tuple[float, ...] = ()
    alone_terms: tuple[float, ...] = ()

    @property
    def gain(self) -> float | None:
        """What company saves there; None if the cost alone is not known."""
        return None if self.alone_cost is None else self.alone_cost - self.cost

    def part(self, of: float) -> Share:
        """Return the same for a part of the stretch.

        Parameters
        ----------
        of : float
            Its share of the stretch.

        Returns
        -------
        Share
            All of it by that share.
        """
        return Share(
            self.cost * of,
            None if self.alone_cost is None else self.alone_cost * of,
            self.fuel_l * of,
            self.alone_fuel_l * of,
            None if self.money is None else self.money * of,
            tuple(one * of for one in self.terms),
            tuple(one * of for one in self.alone_terms),
        )
