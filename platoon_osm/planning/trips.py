"""What is asked: a vehicle that wants to go from one place to another."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np

from ..errors import ScenarioError
from ..network.locate import Location

__all__ = ["Trip"]


@dataclass(frozen=True, slots=True)
class Trip:
    """One vehicle's journey.

    Attributes
    ----------
    vehicle : its name, shown in every table and map.
    origin, destination : places found by `net.locate`, or node positions.
    """

    vehicle: str
    origin: Location | int
    destination: Location | int

    def __post_init__(self) -> None:
        if not isinstance(self.vehicle, str) or not self.vehicle.strip():
            raise ScenarioError(f"trip: vehicle name {self.vehicle!r} must be a non-empty text")
        for end in ("origin", "destination"):
            value: Any = getattr(self, end)
            if isinstance(value, np.integer):
                value = int(value)
                object.__setattr__(self, end, value)
            if isinstance(value, bool) or not isinstance(value, Location | int):
                raise ScenarioError(
                    f"trip {self.vehicle!r}: {end} {value!r} must be a node or come from net.locate"
                )
