"""Places beside the roads: where trucks stop, tunnels, and the towns that give orientation."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..errors import NetworkError
from .columns import columns_per
from .making import in_its_type

__all__ = ["NamedPoints"]

PREFIX = "points."

NOT_GIVEN: NDArray[np.int32] = np.zeros(0, np.int32)
"""Stands for columns that get their default."""


@dataclass(frozen=True, slots=True, eq=False)
class NamedPoints:
    """Places beside the roads, p of them; the arrays are read-only.

    Attributes
    ----------
    lon, lat : ndarray of float, (p,)
        Degrees.
    kind : ndarray of uint8, (p,)
        Position in `POINT_KINDS`.
    name : ndarray of int32, (p,)
        Code in the network's texts.
    population : ndarray of int64, (p,)
        Inhabitants, 0 where not known.
    capacity : ndarray of int32, (p,)
        Spaces for trucks, -1 where not known; the default.
    tags : ndarray of int32, (p,)
        Code in the network's texts: what the map says of a stop or a tunnel, in the form of
        `network.restrictions`; by default nothing.
    """

    lon: NDArray[np.float64]
    lat: NDArray[np.float64]
    kind: NDArray[np.uint8]
    name: NDArray[np.int32]
    population: NDArray[np.int64]
    capacity: NDArray[np.int32] = field(default_factory=lambda: NOT_GIVEN)
    tags: NDArray[np.int32] = field(default_factory=lambda: NOT_GIVEN)

    def __post_init__(self) -> None:
        for column in columns_per("named point"):
            name = column.name.removeprefix(PREFIX)
            given = getattr(self, name)
            if given is NOT_GIVEN:
                given = column.filled(np.size(self.lon))
            values = in_its_type(column, given)
            if values.shape != np.shape(self.lon) or values.ndim != 1:
                raise NetworkError(
                    f"network: {column.name} has shape {values.shape}, points.lon "
                    f"{np.shape(self.lon)}; give one value for each place"
                )
            values.flags.writeable = False
            object.__setattr__(self, name, values)

    @classmethod
    def empty(cls) -> NamedPoints:
        """Make a table of no places at all.

        Returns
        -------
        NamedPoints
            Of length 0.
        """
        return cls(*(column.filled(0) for column in columns_per("named point")))

    def __len__(self) -> int:
        return len(self.lon)

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, NamedPoints):
            return NotImplemented
        names = [column.name.removeprefix(PREFIX) for column in columns_per("named point")]
        return all(np.array_equal(getattr(self, name), getattr(other, name)) for name in names)

    def __hash__(self) -> int:
        return hash((self.lon.tobytes(), self.lat.tobytes()))

    def __reduce__(self) -> tuple[Any, ...]:
        # Made anew, so that the arrays come back read-only.
        return NamedPoints, tuple(
            getattr(self, column.name.removeprefix(PREFIX)) for column in columns_per("named point")
        )
