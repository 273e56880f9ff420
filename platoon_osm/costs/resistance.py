r"""What level road asks of a vehicle for every metre: its rolling and its air resistance.

.. math:: F = c_r m g + \tfrac{1}{2} \rho c_w A v^2 (1 - s),

A being its height by its width and s the share of air resistance that company saves.

References
----------
.. [1] National Research Council, "Review of the 21st Century Truck Partnership, Second Report",
   2012, table G-1: drag coefficient 0.63 and rolling resistance 0.0068 of tractors with high roofs
   and their trailers, mid-2000s.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Protocol

import numpy as np
from numpy.typing import NDArray

from ..errors import ScenarioError, brief
from ..kinds import is_number
from ..vehicles.profile import Vehicle

__all__ = [
    "AIR_KGPM3", "DRAG", "GRAVITY_MPS2", "RANGES", "ROLLING", "Resistance", "air_n",
    "check_ranges", "level_n",
]  # fmt: skip

Floats = NDArray[np.float64]
Ranges = Mapping[str, tuple[float, float]]

GRAVITY_MPS2 = 9.80665
"""Standard acceleration of gravity (CGPM 1901) [m/s²]."""

ROLLING, DRAG, AIR_KGPM3 = 0.0068, 0.63, 1.2
"""Coefficients of rolling and of air resistance [1]_, and the density of air [kg/m³]."""

RANGES: Ranges = {"rolling": (0.0, 0.1), "drag": (0.0, 2.0), "air_kgpm3": (0.0, 2.0)}
"""Least and most of these that is no slip of the pen."""


class Resistance(Protocol):
    """What resistance depends on besides the vehicle."""

    @property
    def rolling(self) -> float:
        """Coefficient of rolling resistance."""

    @property
    def drag(self) -> float:
        """Coefficient of air resistance."""

    @property
    def air_kgpm3(self) -> float:
        """Density of air [kg/m³]."""


def check_ranges(what: str, values: object, ranges: Ranges) -> None:
    """Check that values lie where they can be meant.

    Parameters
    ----------
    what : str
        Begins the message.
    values : object
        Has them as attributes.
    ranges : mapping of str to tuple of float
        Least and most of each, by its name.

    Raises
    ------
    ScenarioError
        A value that is none, or out of its range.
    """
    for label, (least, most) in ranges.items():
        value = getattr(values, label)
        if not (is_number(value) and least <= value <= most):
            raise ScenarioError(f"{what}: {label} is {brief(value)}; give {least:g} to {most:g}")


def air_n(given: Resistance, vehicle: Vehicle, speed_mps: Floats) -> Floats:
    """Return the force of the air on a vehicle that drives alone.

    Parameters
    ----------
    given : Resistance
        Coefficients and air.
    vehicle : Vehicle
        Who drives.
    speed_mps : ndarray of float, (k,)
        Speeds [m/s].

    Returns
    -------
    ndarray of float, (k,)
        Newton [N].
    """
    area = vehicle.height_m * vehicle.width_m
    found: Floats = given.air_kgpm3 / 2 * given.drag * area * speed_mps**2
    return found


def level_n(
    given: Resistance, vehicle: Vehicle, speed_mps: Floats, air_saved: float = 0.0
) -> Floats:
    """Return the force that level road asks for.

    Parameters
    ----------
    given : Resistance
        Coefficients and air.
    vehicle : Vehicle
        Who drives.
    speed_mps : ndarray of float, (k,)
        Speeds [m/s].
    air_saved : float
        Share of the air's resistance that company saves.

    Returns
    -------
    ndarray of float, (k,)
        Newton [N].
    """
    air = air_n(given, vehicle, speed_mps) * (1 - air_saved)
    found: Floats = given.rolling * vehicle.mass_t * 1000 * GRAVITY_MPS2 + air
    return found
