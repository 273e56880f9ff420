"""Fuel saved in a platoon, by position and size, as measured or assumed by named sources.

A share of fuel holds for the vehicle and the speed at which it was measured. What company spares a
vehicle is air resistance, so a share is handed on to others as the share of air resistance that it
is (`air_saved`): fuel saved over the air's part of the fuel, at the mass and speed of the test. A
heavier vehicle then saves a smaller share of its fuel, and a faster one a larger one. Sources that
name no mass or speed are taken to hold for 40 t at 80 km/h.

Measured savings are those of automated following at gaps of 6 to 21 m. The ENSEMBLE project claims
none for platooning as support of the driver, only for its autonomous function [1]_.

A table of your own goes on the list, and scenarios and `paper_weights` know it by its name:

    FUEL_SAVINGS.add(FuelSaving("ours", 0.02, 0.06, 0.06, "measured by ourselves"))

References
----------
.. [1] https://platooningensemble.eu/project
.. [2] Lammert, Duran, Diez, Burton, Nicholson, "Effect of platooning on fuel consumption of class 8
   vehicles over a range of speeds, following distances, and mass", SAE 2014-01-2438; best case,
   at 55 mph, and the lighter of the two masses, 65,000 lb.
.. [3] North American Council for Freight Efficiency, "Confidence report on two-truck platooning",
   2016; taken at the mass above and 65 mph.
.. [4] EDDI project, A9 from Munich to Nuremberg, 35,000 km in daily service, gaps of 15 to 21 m.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from typing import TYPE_CHECKING

from ..errors import ScenarioError, brief
from ..kinds import is_number, is_whole
from ..registry import Registry
from ..vehicles.profile import DEFAULT_VEHICLE
from ..vehicles.units import MILE_KM, POUND_T

if TYPE_CHECKING:
    from .consumption import Consumption

__all__ = ["FUEL_SAVINGS", "FuelSaving", "fuel_saving"]

TEST_RANGES = {"tested_t": (0.1, 500.0, "t"), "tested_kmh": (1.0, 200.0, "km/h")}
"""Least and most that is no slip of the pen, and the unit."""


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
    sizes : mapping of int to tuple of float
        Own shares of platoons of so many vehicles, leader first; others have those above.
    tested_t, tested_kmh : float
        Mass [t] and speed [km/h] of the vehicles that save these shares of their fuel.

    Raises
    ------
    ScenarioError
        A value that is none, or out of its range.
    """

    name: str
    leader: float
    middle: float
    last: float
    source: str = ""
    sizes: Mapping[int, tuple[float, ...]] = field(default_factory=dict, hash=False)
    tested_t: float = 40.0
    tested_kmh: float = 80.0

    def __post_init__(self) -> None:
        where = f"fuel saving {brief(self.name)}"
        shares = [(one, getattr(self, one)) for one in ("leader", "middle", "last")]
        if not isinstance(self.sizes, Mapping):
            raise ScenarioError(
                f"{where}: sizes is {brief(self.sizes)}; give shares by the number of vehicles"
            )
        for size, table in self.sizes.items():
            fits = isinstance(table, tuple | list) and is_whole(size) and size >= 2
            if not fits or len(table) != size:
                raise ScenarioError(
                    f"{where}: sizes has {brief(table)} for {brief(size)} vehicles; give a share "
                    "for each of 2 or more"
                )
            shares += [(f"vehicle {place + 1} of {size}", one) for place, one in enumerate(table)]
        for position, share in shares:
            if not (is_number(share) and 0 <= share < 1):
                raise ScenarioError(
                    f"{where}: {position} saves {brief(share)}; a share is a number in [0, 1)"
                )
        for label, (least, most, unit) in TEST_RANGES.items():
            value = getattr(self, label)
            if not (is_number(value) and least <= value <= most):
                raise ScenarioError(
                    f"{where}: {label} is {brief(value)}; give {least:g} to {most:g} {unit}"
                )
        own = {size: tuple(table) for size, table in self.sizes.items()}
        object.__setattr__(self, "sizes", own)

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
        if size in self.sizes:
            return self.sizes[size]
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

    def share(self, position: int, size: int) -> float:
        """Return the share of fuel that one vehicle saves, at the mass and speed of the test.

        Parameters
        ----------
        position : int
            Its place; 0 leads.
        size : int
            Vehicles in the platoon; one alone saves nothing.

        Returns
        -------
        float
            The share, in [0, 1).

        Raises
        ------
        ScenarioError
            No such place in a platoon of that size.
        """
        if not (is_whole(position) and is_whole(size) and 0 <= position < size):
            raise ScenarioError(
                f"fuel saving {brief(self.name)}: there is no place {brief(position)} among "
                f"{brief(size)} vehicles; the first is 0"
            )
        if size in self.sizes or size < 2:
            return self.by_position(size)[position]
        if position == 0:
            return self.leader
        return self.last if position == size - 1 else self.middle

    def air_saved(self, position: int, size: int, consumption: Consumption) -> float:
        """Return the share of its air resistance that one vehicle saves, whoever it is.

        Parameters
        ----------
        position : int
            Its place; 0 leads.
        size : int
            Vehicles in the platoon; one alone saves nothing.
        consumption : Consumption
            What tells the air's part of the fuel. The vehicle of the test is taken to be as large
            as `eu-40t`.

        Returns
        -------
        float
            The share, in [0, 1].

        Raises
        ------
        ScenarioError
            No such place, or a share of fuel that is more than all that air resistance takes.
        """
        share = self.share(position, size)
        if share == 0:
            return 0.0
        tested = replace(DEFAULT_VEHICLE, name="tested", mass_t=float(self.tested_t), rating_t=None)
        air = float(consumption.air_share(tested, self.tested_kmh / 3.6))
        if share > air:
            raise ScenarioError(
                f"fuel saving {brief(self.name)}: {share:.1%} of the fuel is more than the "
                f"{air:.1%} that air resistance takes at {self.tested_t:g} t and "
                f"{self.tested_kmh:g} km/h; give a smaller share, or the mass and speed of its test"
            )
        return share / air


FUEL_SAVINGS: Registry[FuelSaving] = Registry(
    "fuel saving",
    [
        FuelSaving(
            "seed_18",
            0.0,
            0.18,
            0.18,
            "assumption of Adas et al. 2025, upper end of their range; not measured",
        ),
        FuelSaving(
            "nrel",
            0.053,
            0.097,
            0.097,
            "Lammert et al. 2014, two trucks on a track, best case",
            tested_t=65_000 * POUND_T,
            tested_kmh=55 * MILE_KM,
        ),
        FuelSaving(
            "nacfe",
            0.04,
            0.10,
            0.10,
            "NACFE confidence report on two-truck platooning 2016, gaps of 12 to 15 m",
            tested_t=65_000 * POUND_T,
            tested_kmh=65 * MILE_KM,
        ),
        FuelSaving(
            "bhoopalam", 0.06, 0.10, 0.10, "Bhoopalam, Agatz, Zuidwijk 2023, as they plan with"
        ),
        FuelSaving(
            "plafosim", 0.055, 0.124, 0.106, "PlaFoSim's defaults for leader, middle and last"
        ),
        FuelSaving(
            "eddi", 0.013, 0.035, 0.035, "EDDI project, daily service on the A9 in Germany, 2019"
        ),
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
