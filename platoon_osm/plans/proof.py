"""How good a plan is known to be, and under which conditions."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from typing import Any

from ..errors import ScenarioError, brief

__all__ = ["NOTHING_LEFT", "Proof"]

NOTHING_LEFT = 1e-9
"""A gap below this share of the cost is the last digits of sums: such a plan is optimal."""

KINDS = ("exact", "bound", "heuristic")


@dataclass(frozen=True, slots=True)
class Proof(Mapping[str, Any]):
    """What is proved about a plan.

    It can be read by names, `proof["kind"]`, too; names that say nothing of this plan are absent.

    Attributes
    ----------
    kind : {"exact", "bound", "heuristic"}
        "exact": no plan under the conditions costs less. "bound": none costs less than `bound`.
        "heuristic": nothing is proved, and `optimum` tells how far off the plan is.
    cost : float
        What the plan costs.
    bound : float or None
        No plan under the conditions costs less; None if nothing is proved.
    conditions : tuple of str
        What it is proved for.
    optimum : float or None
        Least cost of the method that is compared with, for a heuristic.
    solo_excess : float or None
        By what share the heuristic's routes alone cost more than the least.
    any_plan : float or None
        No plan for these trips costs less, whatever its routes, master and companies; None if
        nobody worked it out.
    """

    kind: str
    cost: float
    bound: float | None
    conditions: tuple[str, ...] = ()
    optimum: float | None = None
    solo_excess: float | None = None
    any_plan: float | None = None

    def __post_init__(self) -> None:
        if self.kind not in KINDS:
            raise ScenarioError(
                f"plan: proof of kind {brief(self.kind)} is unknown; kinds are {', '.join(KINDS)}"
            )

    @property
    def gap(self) -> float | None:
        """By what share of its cost the plan may be dearer than the best; None if not known."""
        if self.bound is None:
            return None
        return max(0.0, (self.cost - self.bound) / self.cost) if self.cost else 0.0

    @property
    def excess(self) -> float | None:
        """By what share a heuristic's plan is dearer than `optimum`; None for other kinds."""
        if self.optimum is None:
            return None
        return self.cost / self.optimum - 1 if self.optimum else 0.0

    @classmethod
    def of(
        cls,
        cost: float,
        bound: float,
        conditions: tuple[str, ...],
        any_plan: float | None = None,
    ) -> Proof:
        """Return the proof that a lower bound gives.

        Parameters
        ----------
        cost : float
            What the plan costs.
        bound : float
            What no plan can undercut.
        conditions : tuple of str
            For which plans.
        any_plan : float, optional
            What no plan at all can undercut.

        Returns
        -------
        Proof
            "exact" if the bound is reached, else "bound".
        """
        reached = not cost or (cost - bound) / cost <= NOTHING_LEFT
        return cls(
            "exact" if reached else "bound",
            cost,
            cost if reached else bound,
            conditions,
            any_plan=any_plan,
        )

    def told(self) -> dict[str, Any]:
        """Return what the proof says, by name.

        Returns
        -------
        dict
            Plain JSON types; what follows from others, such as the gap, is among them.
        """
        every = {
            "kind": self.kind,
            "conditions": list(self.conditions),
            "bound": self.bound if self.kind == "bound" else None,
            "gap": self.gap if self.kind == "bound" else None,
            "optimum": self.optimum,
            "excess": self.excess,
            "solo_excess": self.solo_excess,
            "any_plan": self.any_plan,
        }
        return {name: value for name, value in every.items() if value is not None}

    def __getitem__(self, name: str) -> Any:
        return self.told()[name]

    def __iter__(self) -> Iterator[str]:
        return iter(self.told())

    def __len__(self) -> int:
        return len(self.told())
