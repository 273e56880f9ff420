"""What is known of a plan for a whole fleet: what it saves, how much more could be saved at most.

The gap is on savings, (bound - saving) / bound: all plans lie within a few per cent of the cost,
so a gap on cost would flatter.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

from ..errors import ScenarioError, brief
from ..kinds import is_number

__all__ = ["ENDED", "FleetRecord", "Moment", "Unserved", "gap_on_savings"]

ENDED = {
    "proved": "less than a hundred-thousandth of it more can be saved",
    "time": "the time limit was reached",
    "rounds": "all rounds were done",
    "refused": "platoons that save too little were given up",
    "interrupted": "it was interrupted",
}
"""Why a search ended, and how that is told."""


def gap_on_savings(saving: float, most: float) -> float:
    """Return by what share of the most that can be saved more could be at most.

    Parameters
    ----------
    saving : float
        What a plan saves.
    most : float
        What no plan saves more than.

    Returns
    -------
    float
        (most - saving) / most; 0 if nothing can be saved.
    """
    return max(0.0, (most - saving) / most) if most > 0 else 0.0


@dataclass(frozen=True, slots=True)
class Unserved:
    """A trip that could not be planned.

    Attributes
    ----------
    vehicle : str
        Its name, or the row of the table it stands in.
    reason : str
        Why, in one line.
    """

    vehicle: str
    reason: str


@dataclass(frozen=True, slots=True)
class Moment:
    """How far a search was at a moment.

    Attributes
    ----------
    seconds : float
        Since it began [s].
    saving : float
        What its best plan saved, in the unit of the plan.
    bound : float
        What no plan can save more than, in the unit of the plan.
    """

    seconds: float
    saving: float
    bound: float


@dataclass(frozen=True, slots=True)
class FleetRecord:
    """What is known of a fleet's plan, and how it was found.

    Attributes
    ----------
    saving : float
        What the plan saves against all driving alone, in the unit of the plan.
    bound : float
        No plan under `conditions` saves more, in the unit of the plan.
    alone_cost : float
        What all cost alone, in the unit of the plan.
    seconds : float
        How long the search took [s].
    peak_mb : float
        The most memory the process held [MB]; 0 where that is not known.
    routes : {"given", "free"}
        Whether each truck keeps its cheapest route alone.
    per_trip : {"many", "one"}
        How many platoons a trip may have.
    max_platoon : int or None
        Vehicles of the largest platoon; None for any.
    seed : int
        Of the search's draws.
    ended : {"proved", "time", "rounds", "refused", "interrupted"}
        Why it ended.
    rounds : int
        How many rounds were done.
    history : tuple of Moment
        Saving and bound over time.
    unserved : tuple of Unserved
        Trips that could not be planned; the plan is one of the others.
    conditions : tuple of str
        For which plans the bound holds.
    exact_bound : float or None
        What no plan saves more than by the exact model, as its solver says; no certificate proves
        it. None where it was not solved, or told nothing.

    Raises
    ------
    ScenarioError
        Figures that are none, or a plan that saves more than its bound.
    """

    saving: float
    bound: float
    alone_cost: float
    seconds: float
    peak_mb: float
    routes: str
    per_trip: str
    max_platoon: int | None
    seed: int
    ended: str
    rounds: int
    history: tuple[Moment, ...] = ()
    unserved: tuple[Unserved, ...] = ()
    conditions: tuple[str, ...] = ()
    exact_bound: float | None = None

    def __post_init__(self) -> None:
        figures = (
            self.saving, self.bound, self.alone_cost, self.seconds, self.peak_mb, self.most,
        )  # fmt: skip
        moments = (value for at in self.history for value in (at.seconds, at.saving, at.bound))
        if not all(is_number(value) and math.isfinite(value) for value in (*figures, *moments)):
            raise ScenarioError("plan: the figures of its fleet must be finite numbers; plan again")
        for label, value, allowed in (
            ("routes", self.routes, ("given", "free")),
            ("per_trip", self.per_trip, ("many", "one")),
            ("ended", self.ended, tuple(ENDED)),
        ):
            if value not in allowed:
                raise ScenarioError(
                    f"plan: {label} of its fleet is {brief(value)}; use {', '.join(allowed)}"
                )
        if self.saving > self.most + 1e-9 * max(self.alone_cost, 1.0):
            raise ScenarioError("plan: its fleet saves more than the bound allows; plan again")

    @property
    def most(self) -> float:
        """What no plan saves more than, by the certificate or by the exact model."""
        return self.bound if self.exact_bound is None else min(self.bound, self.exact_bound)

    @property
    def gap(self) -> float:
        """By what share of `most` more could be saved at most; 0 if nothing can be saved."""
        return gap_on_savings(self.saving, self.most)

    @property
    def saved_share(self) -> float:
        """What is saved, as a share of what all cost alone."""
        return self.saving / self.alone_cost if self.alone_cost else 0.0

    @classmethod
    def from_dict(cls, data: Mapping[str, Any]) -> FleetRecord:
        """Rebuild a record from plain JSON types.

        Parameters
        ----------
        data : mapping
            As `dataclasses.asdict` gives it.

        Returns
        -------
        FleetRecord
            The same.
        """
        return cls(
            **{
                **data,
                "history": tuple(Moment(**item) for item in data["history"]),
                "unserved": tuple(Unserved(**item) for item in data["unserved"]),
                "conditions": tuple(data["conditions"]),
            }
        )
