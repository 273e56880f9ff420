"""What a plan costs in money, term by term and to the cent, and what it emits.

All amounts are whole cents of the bill's currency, so vehicles, terms and totals add up exactly.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

from ..costs.cost_figure import CostFigure
from ..errors import ScenarioError

__all__ = ["CENTS", "Bill", "VehicleBill"]

CENTS = 100
"""In a unit of money."""


@dataclass(frozen=True, slots=True)
class VehicleBill:
    """What one vehicle pays and emits.

    Attributes
    ----------
    alone_cents, joint_cents : tuple of int, (T,)
        For each term, alone and as planned.
    alone_fuel_l, joint_fuel_l : float
        Fuel [l].
    alone_kg, joint_kg : tuple of float, (2,)
        CO2e, tank to wheel and well to wheel [kg].
    """

    alone_cents: tuple[int, ...]
    joint_cents: tuple[int, ...]
    alone_fuel_l: float
    joint_fuel_l: float
    alone_kg: tuple[float, float]
    joint_kg: tuple[float, float]

    @property
    def saved_cents(self) -> int:
        """What it saves by the plan; below 0 if it pays more."""
        return sum(self.alone_cents) - sum(self.joint_cents)


@dataclass(frozen=True, slots=True)
class Bill:
    """What a plan costs in money.

    Attributes
    ----------
    currency : str
        ISO 4217 code.
    terms : tuple of str, (T,)
        What is paid for: "fuel", "driver", "toll", "co2", "waiting", "delay".
    vehicles : tuple of VehicleBill, (N,)
        In the order of the plan's trips.
    figures : tuple of CostFigure
        All figures it was worked out with, and where they are from.

    Raises
    ------
    ScenarioError
        Vehicles with more or fewer amounts than there are terms.
    """

    currency: str
    terms: tuple[str, ...]
    vehicles: tuple[VehicleBill, ...]
    figures: tuple[CostFigure, ...] = ()

    def __post_init__(self) -> None:
        for one in self.vehicles:
            if not len(one.alone_cents) == len(one.joint_cents) == len(self.terms):
                raise ScenarioError(
                    "plan: its bill has not one amount a term; it is damaged, plan again"
                )

    @property
    def alone_cents(self) -> int:
        """What all pay alone."""
        return sum(map(sum, (one.alone_cents for one in self.vehicles)))

    @property
    def joint_cents(self) -> int:
        """What all pay as planned."""
        return sum(map(sum, (one.joint_cents for one in self.vehicles)))

    @property
    def saved_cents(self) -> int:
        """What all save by the plan."""
        return self.alone_cents - self.joint_cents

    @property
    def saved_kg(self) -> tuple[float, float]:
        """CO2e that the plan saves, tank to wheel and well to wheel [kg]."""
        to_wheel, from_well = (
            sum(one.alone_kg[kind] - one.joint_kg[kind] for one in self.vehicles) for kind in (0, 1)
        )
        return to_wheel, from_well

    @property
    def saved_fuel_l(self) -> float:
        """Fuel that the plan saves [l]."""
        return sum(one.alone_fuel_l - one.joint_fuel_l for one in self.vehicles)

    def of_term(self, term: str) -> tuple[int, int]:
        """Return what all pay for one term.

        Parameters
        ----------
        term : str
            One of `terms`.

        Returns
        -------
        tuple of int
            Alone and as planned, cents.
        """
        place = self.terms.index(term)
        return (
            sum(one.alone_cents[place] for one in self.vehicles),
            sum(one.joint_cents[place] for one in self.vehicles),
        )

    @classmethod
    def from_dict(cls, data: Mapping[str, Any]) -> Bill:
        """Rebuild a bill from plain JSON types.

        Parameters
        ----------
        data : mapping
            Its fields by name.

        Returns
        -------
        Bill
            The same.
        """
        return cls(
            data["currency"],
            tuple(data["terms"]),
            tuple(
                VehicleBill(
                    tuple(one["alone_cents"]), tuple(one["joint_cents"]),
                    one["alone_fuel_l"], one["joint_fuel_l"],
                    _pair(one["alone_kg"]), _pair(one["joint_kg"]),
                )
                for one in data["vehicles"]
            ),
            tuple(CostFigure(**one) for one in data["figures"]),
        )  # fmt: skip


def _pair(values: Any) -> tuple[float, float]:
    first, second = values
    return first, second
