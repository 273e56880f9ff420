"""How far a fleet's search is, for whoever waits for it."""

from __future__ import annotations

from dataclasses import dataclass

from ..plans.fleet import gap_on_savings

__all__ = ["Progress"]


@dataclass(frozen=True, slots=True)
class Progress:
    """How far a fleet's search is.

    Attributes
    ----------
    share : float
        Of the time or rounds that it may use.
    seconds : float
        Since it began [s].
    saving, bound : float
        What its best plan saves, and what no plan can save more than, in the unit of costs.
    gap : float
        By what share of the bound more could be saved at most.
    """

    share: float
    seconds: float
    saving: float
    bound: float

    @property
    def gap(self) -> float:
        """By what share of the bound more could be saved at most."""
        return gap_on_savings(self.saving, self.bound)
