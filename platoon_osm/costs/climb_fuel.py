r"""Energy and fuel that climbs add to driving on level road.

Level road asks of a vehicle, for every metre, the force of its rolling and air resistance

.. math:: F = c_r m g + \tfrac{1}{2} \rho c_w A v^2 .

A climb of height h adds m g h; the engine gives it, at the efficiency of engine and driveline. A
descent gives m g h back, but only up to what resistance takes on its length: the rest is braked
away. How much of that is used, for drivers and cruise controls brake more, is `recovered`.

No plan's cost has this in it: paper costs are those of the paper, and money comes with its own
issue. It is here to be read, and for costs of one's own.

References
----------
.. [1] National Research Council, "Review of the 21st Century Truck Partnership, Second Report",
   2012, table G-1: drag coefficient 0.63 and rolling resistance 0.0068 of tractors with high roofs
   and their trailers, mid-2000s.
.. [2] Directive 2009/28/EC, annex III: 36 MJ in a litre of diesel (lower heating value).
.. [3] National Research Council, as [1]_: engines of trucks reach 42 %; with a driveline of 95 %.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ..errors import ScenarioError, brief
from ..kinds import is_number
from ..network.road_network import RoadNetwork, checked_network
from ..vehicles.profile import Vehicle, vehicle_of

__all__ = ["GRAVITY_MPS2", "ClimbFuel"]

Floats = NDArray[np.float64]

GRAVITY_MPS2 = 9.80665
"""Standard acceleration of gravity (CGPM 1901) [m/s²]."""

RANGES = {
    "efficiency": (0.01, 1.0),
    "recovered": (0.0, 1.0),
    "rolling": (0.0, 0.1),
    "drag": (0.0, 2.0),
    "air_kgpm3": (0.0, 2.0),
    "fuel_mjpl": (1.0, 100.0),
}
"""Least and most that is no slip of the pen."""


@dataclass(frozen=True, slots=True)
class ClimbFuel:
    """How climbs become fuel.

    Attributes
    ----------
    efficiency : float
        Of engine and driveline together.
    recovered : float
        Share of what a descent can save at most that is saved.
    rolling : float
        Coefficient of rolling resistance.
    drag : float
        Coefficient of air resistance; the area is the vehicle's height by its width.
    air_kgpm3 : float
        Density of air [kg/m³].
    fuel_mjpl : float
        Energy of a litre of fuel [MJ/l].

    Raises
    ------
    ScenarioError
        A value that is none, or out of its range.
    """

    efficiency: float = 0.42 * 0.95
    recovered: float = 1.0
    rolling: float = 0.0068
    drag: float = 0.63
    air_kgpm3: float = 1.2
    fuel_mjpl: float = 36.0

    def __post_init__(self) -> None:
        for label, (least, most) in RANGES.items():
            value = getattr(self, label)
            if not (is_number(value) and least <= value <= most):
                raise ScenarioError(
                    f"climb fuel: {label} is {brief(value)}; give {least:g} to {most:g}"
                )

    def extra_mj(self, net: RoadNetwork, vehicle: Vehicle | str | None = None) -> Floats:
        """Return the mechanical energy that climbs and descents add on each edge.

        Parameters
        ----------
        net : RoadNetwork
            With `climb_m` and `descent_m`; where they are not known nothing is added.
        vehicle : Vehicle, str or None
            Who drives, or a name of `VEHICLES`; by default `eu-40t`.

        Returns
        -------
        ndarray of float, (m,)
            Megajoules at the wheels [MJ]; below 0 where descents save energy.
        """
        who = vehicle_of(vehicle)
        weight_n = who.mass_t * 1000 * GRAVITY_MPS2
        speed = checked_network(net).speed_mps
        area = who.height_m * who.width_m
        resistance_n = self.rolling * weight_n + self.air_kgpm3 / 2 * self.drag * area * speed**2
        climb, descent = net.climb_m.astype(np.float64), net.descent_m.astype(np.float64)
        # Of an edge only the sums are known: where it descends is taken to be the share of its
        # graded length that its descent has of all ups and downs.
        total = climb + descent
        share = np.divide(descent, total, out=np.zeros(net.m), where=total > 0)
        usable = np.minimum(weight_n * descent, resistance_n * share * net.graded_m)
        return (weight_n * climb - self.recovered * usable) / 1e6

    def extra_l(self, net: RoadNetwork, vehicle: Vehicle | str | None = None) -> Floats:
        """Return the fuel that climbs and descents add on each edge.

        Parameters
        ----------
        net : RoadNetwork
            As in `extra_mj`.
        vehicle : Vehicle, str or None
            Who drives, or a name of `VEHICLES`; by default `eu-40t`.

        Returns
        -------
        ndarray of float, (m,)
            Litres [l]; below 0 where descents save fuel.
        """
        return self.extra_mj(net, vehicle) / (self.efficiency * self.fuel_mjpl)
