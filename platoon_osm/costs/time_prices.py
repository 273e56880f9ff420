"""What a second of waiting and a second of delay cost, as an objective prices them.

A vehicle's delay is how much later it arrives than alone, leaving as early as it may. An objective
need not price it: then it costs nothing. Nor does it for a vehicle that names no earliest
departure, which arrives late by nothing.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

__all__ = ["TimePrices"]

HOUR_S = 3600.0
SAME = 1e-9


def _nothing(seconds: float) -> float:
    """Return what delay costs under an objective that does not price it."""
    del seconds
    return 0.0


@dataclass(frozen=True, slots=True)
class TimePrices:
    """Prices of time.

    Attributes
    ----------
    waiting : float
        Of a second's waiting on the road.
    delay : float
        Of a second's delay.
    are_even : bool
        Whether both are proportional to the time, as searches take for granted. Where they are not,
        an hour's price is spread over it.
    """

    waiting: float = 0.0
    delay: float = 0.0
    are_even: bool = True

    @classmethod
    def of(cls, objective: Any) -> TimePrices:
        """Ask an objective.

        Parameters
        ----------
        objective : Objective or EdgeWeights
            Whose prices.

        Returns
        -------
        TimePrices
            By the second.
        """
        delay = getattr(objective, "delay", None)
        kinds = (objective.waiting, _nothing if delay is None else delay)
        waiting, late = hours = [float(one(HOUR_S)) for one in kinds]
        even = all(
            abs(float(one(3 * HOUR_S)) - 3 * hour) <= SAME * 3 * abs(hour)
            for one, hour in zip(kinds, hours, strict=True)
        )
        return cls(waiting / HOUR_S, late / HOUR_S, even)

    @property
    def are_free(self) -> bool:
        """Whether neither costs anything."""
        return self.waiting == 0 and self.delay == 0
