r"""Energy and fuel that climbs add to driving on level road.

Level road asks of a vehicle the force of its rolling and air resistance (`resistance`).
A climb of height h adds m g h; the engine gives it, at the efficiency of engine and driveline. A
descent gives m g h back, but only up to what resistance takes on its length: the rest is braked
away. How much of that is used, for drivers and cruise controls brake more, is `recovered`.

A view of `consumption`, whose physics it is, of an older truck at steady speed. No plan's cost has
it in it: the paper's costs are those of the paper, and money counts litres by `Consumption`.

References
----------
.. [1] Directive 2009/28/EC, annex III: 36 MJ in a litre of diesel (lower heating value).
.. [2] National Research Council, as in `resistance`: engines of trucks reach 42 %; with a driveline
   of 95 %.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ..network.road_network import RoadNetwork, checked_network
from ..vehicles.profile import Vehicle
from .consumption import Consumption
from .resistance import AIR_KGPM3, DRAG, RANGES, ROLLING, check_ranges

__all__ = ["ClimbFuel"]

Floats = NDArray[np.float64]

OWN_RANGES = {"efficiency": (0.01, 1.0), "recovered": (0.0, 1.0), "fuel_mjpl": (1.0, 100.0)}
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
    rolling: float = ROLLING
    drag: float = DRAG
    air_kgpm3: float = AIR_KGPM3
    fuel_mjpl: float = 36.0

    def __post_init__(self) -> None:
        check_ranges("climb fuel", self, {**RANGES, **OWN_RANGES})

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
        steady = Consumption(
            rolling=self.rolling,
            drag=self.drag,
            air_kgpm3=self.air_kgpm3,
            recovered=self.recovered,
            unsteady=0.0,
        )
        return steady.hills_mj(checked_network(net), vehicle, speed_mps=net.speed_mps)

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
