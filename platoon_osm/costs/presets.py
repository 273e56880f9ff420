"""Objectives by name, as scenarios ask for them: `[objective] preset = "eu"`.

Reading this list costs nothing: an objective is imported when it is made.
"""

from __future__ import annotations

import difflib
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from ..errors import ScenarioError, brief
from ..registry import Registry

if TYPE_CHECKING:
    from .objective import Objective

__all__ = ["DEFAULT_PRESET", "PRESETS", "CostPreset"]


@dataclass(frozen=True, slots=True)
class CostPreset:
    """An objective that can be asked for by name.

    Attributes
    ----------
    name : str
        What scenarios call it.
    about : str
        One line for lists.
    make : callable
        Returns the objective from parameters by name, and raises `ScenarioError` for a value that
        cannot be.
    parameters : tuple of str
        Names that `make` takes.
    """

    name: str
    about: str
    make: Callable[..., Objective]
    parameters: tuple[str, ...] = ()

    def objective(self, params: Mapping[str, Any]) -> Objective:
        """Return the objective with some parameters set.

        Parameters
        ----------
        params : mapping of str to object
            Values by name; others keep their defaults.

        Returns
        -------
        Objective
            What `make` made.

        Raises
        ------
        ScenarioError
            A parameter unknown or out of range.
        """
        for name in params:
            if name not in self.parameters:
                near = difflib.get_close_matches(str(name), self.parameters, 1, 0.5)
                hint = f"did you mean {near[0]!r}?" if near else (
                    f"those of {self.name!r} are {', '.join(self.parameters)}"
                )  # fmt: skip
                raise ScenarioError(f"cost parameter {brief(name)} is unknown; {hint}")
        return self.make(**params)


def _paper(**params: Any) -> Objective:
    from .paper import PaperCosts

    return PaperCosts(**params)


PAPER_PARAMETERS = (
    "tau", "xi", "mixing", "fuel_saving", "positions", "speed_kmh", "rest_s", "driving_s",
    "fuel_l_per_100km",
)  # fmt: skip

PRICE_PARAMETERS = (
    "fuel_per_l", "driver_per_h", "driver_following", "toll", "toll_unknown_per_km", "co2_per_t",
    "waiting_per_h", "delay_per_h", "to_wheel_kg_per_l", "from_well_kg_per_l",
)  # fmt: skip
FUEL_PARAMETERS = (
    "positions", "rolling", "drag", "air_kgpm3", "auxiliary_kw", "efficiency", "recovered",
    "fuel_mjpl", "unsteady",
)  # fmt: skip


def _money(preset: str) -> Callable[..., Objective]:
    def make(**params: Any) -> Objective:
        from .money.objective import money_costs

        return money_costs(preset, **params)

    return make


def _fuel(**params: Any) -> Objective:
    from .money.fuel_costs import fuel_costs

    return fuel_costs(**params)


PRESETS = Registry(
    "objective",
    [
        CostPreset(
            "eu",
            "money in Europe [EUR]: fuel, driver, toll, waiting; savings as measured on roads",
            _money("eu"),
            (*PRICE_PARAMETERS, *FUEL_PARAMETERS),
        ),
        CostPreset(
            "us",
            "money in the United States [USD], likewise",
            _money("us"),
            (*PRICE_PARAMETERS, *FUEL_PARAMETERS),
        ),
        CostPreset("fuel", "litres of fuel; savings as measured on roads", _fuel, FUEL_PARAMETERS),
        CostPreset(
            "paper",
            "Adas et al. 2025: distance, time and fuel in metre equivalents, 18 % saved (its "
            "assumption)",
            _paper,
            PAPER_PARAMETERS,
        ),
    ],
)
DEFAULT_PRESET = "paper"
