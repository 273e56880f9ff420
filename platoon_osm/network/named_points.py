"""Places beside the roads: service and rest areas, and the towns that give orientation."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..errors import NetworkError
from .columns import columns_per
from .making import in_its_type

__all__ = ["NamedPoints"]

PREFIX = "points."


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
    """

    lon: NDArray[np.float64]
    lat: NDArray[np.float64]
    kind: NDArray[np.uint8]
    name: NDArray[np.int32]
    population: NDArray[np.int64]

    def __post_init__(self) -> None:
        for column in columns_per("named point"):
            name = column.name.removeprefix(PREFIX)
            values = in_its_type(column, getattr(self, name))
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
