"""Objectives by name, as scenarios ask for them: `[costs] preset = "paper"`."""

from __future__ import annotations

import difflib
from collections.abc import Callable, Mapping
from dataclasses import dataclass, fields
from typing import Any

from ..errors import ScenarioError, brief
from ..registry import Registry
from .objective import Objective
from .paper import PaperCosts

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


PRESETS = Registry(
    "costs preset",
    [
        CostPreset(
            "paper",
            "Adas et al. 2025: distance, time and fuel in metre equivalents",
            PaperCosts,
            tuple(item.name for item in fields(PaperCosts)),
        )
    ],
)
DEFAULT_PRESET = "paper"
