"""Fuel saved in a platoon, by position, as measured or assumed by named sources.

A table of your own goes on the list, and scenarios and `paper_weights` know it by its name:

    FUEL_SAVINGS.add(FuelSaving("ours", 0.02, 0.06, 0.06, "measured by ourselves"))
"""

from __future__ import annotations

from dataclasses import dataclass

from ..errors import ScenarioError, brief
from ..kinds import is_number
from ..registry import Registry

__all__ = ["FUEL_SAVINGS", "FuelSaving", "fuel_saving"]


@dataclass(frozen=True, slots=True)
class FuelSaving:
    """Share of fuel saved by position in the platoon.

    Attributes
    ----------
    name : str
        What to call it in a plan.
    leader : float
        Share that the first vehicle saves, in [0, 1).
    middle : float
        Share that each vehicle between first and last saves, in [0, 1).
    last : float
        Share that the last vehicle saves, in [0, 1).
    source : str
        Who measured or assumed it.
    """

    name: str
    leader: float
    middle: float
    last: float
    source: str = ""

    def __post_init__(self) -> None:
        for position in ("leader", "middle", "last"):
            share = getattr(self, position)
            if not (is_number(share) and 0 <= share < 1):
                raise ScenarioError(
                    f"fuel saving {brief(self.name)}: {position} saves {brief(share)}; a "
                    "share is a number in [0, 1)"
                )

    def by_position(self, size: int) -> tuple[float, ...]:
        """Return the share that each vehicle of a platoon saves.

        Parameters
        ----------
        size : int
            Vehicles in the platoon, 0 or more; one alone saves nothing.

        Returns
        -------
        tuple of float, (size,)
            Shares in [0, 1), leader first.
        """
        if size < 2:
            return (0.0,) * size
        return (self.leader, *(self.middle,) * (size - 2), self.last)

    def mean(self, size: int) -> float:
        """Return the share that each saves when the lead is rotated evenly.

        Parameters
        ----------
        size : int
            Vehicles in the platoon, 0 or more.

        Returns
        -------
        float
            Mean of `by_position`, in [0, 1).
        """
        return sum(self.by_position(size)) / size if size else 0.0


FUEL_SAVINGS: Registry[FuelSaving] = Registry(
    "fuel saving",
    [
        FuelSaving("seed_18", 0.0, 0.18, 0.18, "Adas et al. 2025, upper end of their range"),
        FuelSaving("nrel", 0.053, 0.097, 0.097, "Lammert et al. 2014, two trucks, best case"),
        FuelSaving("nacfe", 0.04, 0.10, 0.10, "NACFE confidence report on two-truck platooning"),
        FuelSaving("bhoopalam", 0.06, 0.10, 0.10, "Bhoopalam, Agatz, Zuidwijk 2023"),
        FuelSaving("plafosim", 0.055, 0.124, 0.106, "PlaFoSim defaults, three positions"),
        FuelSaving("eddi", 0.013, 0.035, 0.035, "EDDI project, daily service on the A9 in Germany"),
    ],
)


def fuel_saving(preset: str | FuelSaving) -> FuelSaving:
    """Return a named preset, or the given model itself.

    Parameters
    ----------
    preset : str or FuelSaving
        A name in `FUEL_SAVINGS`, or a model of one's own.

    Returns
    -------
    FuelSaving
        The model.

    Raises
    ------
    ScenarioError
        No preset has that name; the message names the nearest, and all there are.
    """
    return preset if isinstance(preset, FuelSaving) else FUEL_SAVINGS.find(preset)
