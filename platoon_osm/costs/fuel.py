"""Fuel saved in a platoon, by position, as measured or assumed by named sources."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from ..errors import ScenarioError

__all__ = ["FUEL_SAVINGS", "FuelSaving", "fuel_saving"]


@dataclass(frozen=True, slots=True)
class FuelSaving:
    """Share of fuel saved by position in the platoon, in [0, 1).

    Attributes
    ----------
    name : what to call it in a plan.
    leader, middle, last : share saved by the first, an inner and the last vehicle.
    source : who measured or assumed it.
    """

    name: str
    leader: float
    middle: float
    last: float
    source: str = ""

    def __post_init__(self) -> None:
        for position in ("leader", "middle", "last"):
            share = getattr(self, position)
            is_number = isinstance(share, int | float) and not isinstance(share, bool)
            if not (is_number and 0 <= share < 1):
                raise ScenarioError(
                    f"fuel saving {self.name!r}: {position} saves {share!r}; a share is a number "
                    "in [0, 1)"
                )

    def by_position(self, size: int) -> tuple[float, ...]:
        """Return the share saved by each vehicle of a platoon of `size`, leader first."""
        if size < 2:
            return (0.0,) * size
        return (self.leader, *(self.middle,) * (size - 2), self.last)

    def mean(self, size: int) -> float:
        """Return the share each saves when the lead is rotated evenly among `size` vehicles."""
        return sum(self.by_position(size)) / size if size else 0.0


FUEL_SAVINGS: Mapping[str, FuelSaving] = {
    saving.name: saving
    for saving in (
        FuelSaving("seed_18", 0.0, 0.18, 0.18, "Adas et al. 2025, upper end of their range"),
        FuelSaving("nrel", 0.053, 0.097, 0.097, "Lammert et al. 2014, two trucks, best case"),
        FuelSaving("nacfe", 0.04, 0.10, 0.10, "NACFE confidence report on two-truck platooning"),
        FuelSaving("bhoopalam", 0.06, 0.10, 0.10, "Bhoopalam, Agatz, Zuidwijk 2023"),
        FuelSaving("plafosim", 0.055, 0.124, 0.106, "PlaFoSim defaults, three positions"),
        FuelSaving("eddi", 0.013, 0.035, 0.035, "EDDI project, daily service on the A9 in Germany"),
    )
}


def fuel_saving(preset: str | FuelSaving) -> FuelSaving:
    """Return a named preset, or the given model itself.

    Raises
    ------
    ScenarioError
        If no preset has that name.
    """
    if isinstance(preset, FuelSaving):
        return preset
    if not isinstance(preset, str) or preset not in FUEL_SAVINGS:
        raise ScenarioError(
            f"fuel saving {preset!r} is unknown; use one of {', '.join(FUEL_SAVINGS)}"
        )
    return FUEL_SAVINGS[preset]
