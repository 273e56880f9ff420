r"""Fuel of a truck: the physics of driving, calibrated against published consumption.

At speed v on a slope of angle a the wheels take the power

.. math:: P = (\tfrac{1}{2} \rho c_w A v^2 (1 - s) + m g (c_r \cos a + \sin a)) v,

s being the share of air resistance that company saves; the cosine is taken to be 1, for it is above
0.998 on roads of up to 6 %. A litre gives its energy times the efficiency of engine and driveline;
auxiliaries take their part of it for as long as driving lasts.

Level road at constant speed leaves out changes of speed, and hills that the map does not know. Both
are `unsteady` times the resistance alone, which company does not shrink. Where heights are known, a
climb costs m g h, and a descent gives m g h back but for what is braked away: all beyond the
resistance on its length, and a share 1 - `recovered` of the rest. On such lengths the loss is the
larger of the two, what descents have braked away or what `unsteady` says, never their sum. So no
hill is counted twice, up and down again costs no less than level road, and roads look no better for
having known heights.

Calibration. `unsteady` is set so that the default truck of 40 t takes 32.6 l/100 km at 80 km/h, as
an average European tractor-trailer did over the regulatory long-haul cycle in 2018 [1]_: that takes
0.15. The cycle is driven with 19.3 t of payload [2]_, some 34.3 t in all if tractor and semitrailer
weigh 15 t, an estimate of ours. At that mass the formula has 30.2 l/100 km, between the average
truck of those tests and the best in its class, 29.9: the default truck is more like a new one than
like the average of 2018. The British factor of articulated vehicles above 33 t, for all kinds of
road, is 35.9 l/100 km at 12 t of load [3]_, where the formula has 27.0 at 80 km/h: its litres are
those of long trips on motorways, not of distribution. `tests/costs/test_consumption.py` computes
these differences.

References
----------
.. [1] Rodriguez, Delgado, Muncrief, "Fuel consumption testing of tractor-trailers in the European
   Union and the United States", ICCT 2018: average 32.6, best in class 29.9 l/100 km.
.. [2] Regulation (EU) 2019/1242, annex I: reference payload of tractors 4x2 on long haul.
.. [3] UK government conversion factors for company reporting: 0.9237 kg CO2e a km with average load
   and 2.57082 kg CO2e a litre of diesel (2025); the load is kg a km over kg a tonne and km, 0.93939
   by 0.07835 (2026).
.. [4] ICCT on VECTO and the real world: drag area of tractor-trailers certified in 2019, about
   5.8 m²; of the 4.00 by 2.55 m of such a vehicle that is a coefficient of 0.57.
.. [5] Regulation (EU) 2020/740, annex I: rolling resistance of tyres of class C3, label C is 5.1 to
   6.0 kg/t; 5.5 are a coefficient of 0.0055.
.. [6] National Research Council, "Review of the 21st Century Truck Partnership, Second Report",
   2012: engines of trucks reach 42 %; with a driveline of 95 %.
.. [7] Directive 2009/28/EC, annex III: 36 MJ in a litre of diesel (lower heating value).
.. [8] Auxiliaries: 5 kW, a round figure of ours for a tractor on the motorway.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..errors import ScenarioError, brief
from ..kinds import is_number
from ..network.road_network import RoadNetwork, checked_network
from ..vehicles.pace import drive_times
from ..vehicles.profile import Vehicle, vehicle_of
from .resistance import AIR_KGPM3, GRAVITY_MPS2, RANGES, air_n, check_ranges, level_n

__all__ = ["Consumption"]

Floats = NDArray[np.float64]
Index = NDArray[np.int64]

OWN_RANGES = {
    "auxiliary_kw": (0.0, 50.0),
    "efficiency": (0.01, 1.0),
    "recovered": (0.0, 1.0),
    "fuel_mjpl": (1.0, 100.0),
    "unsteady": (0.0, 2.0),
}
"""Least and most that is no slip of the pen."""


@dataclass(frozen=True, slots=True)
class Consumption:
    """How driving becomes litres.

    Attributes
    ----------
    rolling : float
        Coefficient of rolling resistance.
    drag : float
        Coefficient of air resistance; the area is the vehicle's height by its width.
    air_kgpm3 : float
        Density of air [kg/m³].
    auxiliary_kw : float
        What auxiliaries take at any speed [kW].
    efficiency : float
        Of engine and driveline together.
    recovered : float
        Share of what a descent can save at most that is saved.
    fuel_mjpl : float
        Energy of a litre of fuel [MJ/l].
    unsteady : float
        What changes of speed and unknown hills add, as a share of the resistance on level road.

    Raises
    ------
    ScenarioError
        A value that is none, or out of its range.
    """

    rolling: float = 0.0055
    drag: float = 0.57
    air_kgpm3: float = AIR_KGPM3
    auxiliary_kw: float = 5.0
    efficiency: float = 0.42 * 0.95
    recovered: float = 1.0
    fuel_mjpl: float = 36.0
    unsteady: float = 0.15

    def __post_init__(self) -> None:
        check_ranges("consumption", self, {**RANGES, **OWN_RANGES})

    def force_n(
        self, speed_mps: ArrayLike, vehicle: Vehicle | str | None = None, air_saved: float = 0.0
    ) -> Floats:
        """Return the force that fuel per metre of level road is proportional to: P / v, all in all.

        Parameters
        ----------
        speed_mps : array_like of float, (k,)
            Speeds [m/s], more than 0.
        vehicle : Vehicle, str or None
            Who drives, or a name of `VEHICLES`; by default `eu-40t`.
        air_saved : float
            Share of the air's resistance that company saves.

        Returns
        -------
        ndarray of float, (k,)
            Newton [N].
        """
        who, speed = vehicle_of(vehicle), np.asarray(speed_mps, np.float64)
        found: Floats = (
            level_n(self, who, speed, air_saved)
            + self.unsteady * level_n(self, who, speed)
            + 1000 * self.auxiliary_kw / speed
        )
        return found

    def air_share(self, vehicle: Vehicle | str | None, speed_mps: ArrayLike) -> Floats:
        """Return the share of a vehicle's fuel on level road that goes into air resistance.

        Of this share company saves its `air_saved`; the rest it does not change.

        Parameters
        ----------
        vehicle : Vehicle, str or None
            Who drives, or a name of `VEHICLES`; by default `eu-40t`.
        speed_mps : array_like of float, (k,)
            Speeds [m/s], more than 0.

        Returns
        -------
        ndarray of float, (k,)
            In (0, 1); 0 only without drag or air.
        """
        who, speed = vehicle_of(vehicle), np.asarray(speed_mps, np.float64)
        found: Floats = air_n(self, who, speed) / self.force_n(speed, who)
        return found

    def per_100km(
        self, vehicle: Vehicle | str | None = None, speed_kmh: float = 80.0, air_saved: float = 0.0
    ) -> float:
        """Return the litres that 100 km of road take whose heights are not known.

        Parameters
        ----------
        vehicle : Vehicle, str or None
            Who drives, or a name of `VEHICLES`; by default `eu-40t`.
        speed_kmh : float
            Speed [km/h].
        air_saved : float
            Share of the air's resistance that company saves.

        Returns
        -------
        float
            Litres [l/100 km].
        """
        return float(self.force_n(speed_kmh / 3.6, vehicle, air_saved)) * 1e5 / self._used_jpl

    def litres(
        self,
        net: RoadNetwork,
        vehicle: Vehicle | str | None = None,
        *,
        edges: Index | None = None,
        speed_mps: Floats | None = None,
        air_saved: float = 0.0,
    ) -> Floats:
        """Return the fuel that whole edges take.

        Parameters
        ----------
        net : RoadNetwork
            The network.
        vehicle : Vehicle, str or None
            Who drives, or a name of `VEHICLES`; by default `eu-40t`.
        edges : ndarray of int, (k,), optional
            Ids of edges; by default all of the network.
        speed_mps : ndarray of float, (k,), optional
            How fast each of them is driven [m/s]; by default as the vehicle drives them alone.
        air_saved : float
            Share of the air's resistance that company saves, in [0, 1].

        Returns
        -------
        ndarray of float, (k,)
            Litres [l], 0 or more.

        Raises
        ------
        ScenarioError
            A share or a speed that cannot be.
        """
        who, speed = self._driven(net, vehicle, edges, speed_mps)
        if not (is_number(air_saved) and 0 <= air_saved <= 1):
            raise ScenarioError(f"consumption: air_saved is {brief(air_saved)}; give 0 to 1")
        length = _of(net.length_m, edges)
        force = self.force_n(speed, who, air_saved)
        joules = force * length + self._hills_j(net, who, edges, speed, air_saved)
        # Sums of the same figures in another order may end a hair below nothing.
        found: Floats = np.maximum(joules, 0.0) / self._used_jpl
        return found

    def hills_mj(
        self,
        net: RoadNetwork,
        vehicle: Vehicle | str | None = None,
        *,
        edges: Index | None = None,
        speed_mps: Floats | None = None,
        air_saved: float = 0.0,
    ) -> Floats:
        """Return the energy that known heights add to road whose heights are not known.

        Parameters
        ----------
        net : RoadNetwork
            With `climb_m` and `descent_m`; where they are not known nothing is added.
        vehicle : Vehicle, str or None
            Who drives, or a name of `VEHICLES`; by default `eu-40t`.
        edges : ndarray of int, (k,), optional
            Ids of edges; by default all of the network.
        speed_mps : ndarray of float, (k,), optional
            How fast each of them is driven [m/s]; by default as the vehicle drives them alone.
        air_saved : float
            Share of the air's resistance that company saves.

        Returns
        -------
        ndarray of float, (k,)
            Megajoules at the wheels [MJ]; below 0 where descents save energy.
        """
        who, speed = self._driven(net, vehicle, edges, speed_mps)
        return self._hills_j(net, who, edges, speed, air_saved) / 1e6

    def _hills_j(
        self, net: RoadNetwork, who: Vehicle, edges: Index | None, speed: Floats, air_saved: float
    ) -> Floats:
        climb, descent, graded = (
            _of(array, edges).astype(np.float64)
            for array in (net.climb_m, net.descent_m, net.graded_m)
        )
        weight_n = who.mass_t * 1000 * GRAVITY_MPS2
        # Of an edge only the sums are known: where it descends is taken to be the share of its
        # graded length that its descent has of all ups and downs.
        total = climb + descent
        falling = graded * np.divide(descent, total, out=np.zeros(len(total)), where=total > 0)
        usable = np.minimum(weight_n * descent, level_n(self, who, speed, air_saved) * falling)
        braked = weight_n * descent - self.recovered * usable
        usual = self.unsteady * level_n(self, who, speed) * graded
        found: Floats = weight_n * (climb - descent) + np.maximum(braked - usual, 0.0)
        return found

    def _driven(
        self,
        net: RoadNetwork,
        vehicle: Vehicle | str | None,
        edges: Index | None,
        speed_mps: Floats | None,
    ) -> tuple[Vehicle, Floats]:
        """Return who drives, and how fast."""
        who = vehicle_of(vehicle)
        checked_network(net)
        if speed_mps is None:
            length, time = _of(net.length_m, edges), _of(drive_times(net, who), edges)
            return who, np.divide(length, time, out=np.ones(len(time)), where=time > 0)
        speed = np.asarray(speed_mps, np.float64)
        count = net.m if edges is None else len(edges)
        if speed.shape != (count,) or not ((speed > 0) & np.isfinite(speed)).all():
            raise ScenarioError(
                f"consumption: speed_mps must have one speed above 0 for each of {count} edges"
            )
        return who, speed

    @property
    def _used_jpl(self) -> float:
        """What arrives of a litre where it is used [J/l]."""
        return self.efficiency * self.fuel_mjpl * 1e6


def _of(array: NDArray[np.floating], edges: Index | None) -> NDArray[np.floating]:
    return array if edges is None else array[edges]
