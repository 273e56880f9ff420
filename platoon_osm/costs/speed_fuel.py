r"""Fuel as a function of speed: what driving slower on the way to a meeting saves.

On level road at a constant speed v the engine gives

.. math:: P = (\tfrac{1}{2} \rho c_w A v^2 (1 - s) + c_r m g) v + P_{aux},

s being the share of air resistance that company saves. Fuel per kilometre follows P / v: the air's
part falls with the square of the speed, what fans, pumps and compressors take grows as a kilometre
takes longer. Only ratios of it are used, so that the litres of a preset hold at the speed they are
for. A view of `consumption`, whose physics it is, of an older truck at steady speed; no plan's cost
has it in it.

References
----------
.. [1] Resistances as in `resistance`.
.. [2] Auxiliaries: 5 kW, a round figure of ours for a tractor on the motorway.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..vehicles.profile import Vehicle
from .consumption import Consumption
from .resistance import AIR_KGPM3, DRAG, RANGES, ROLLING, check_ranges

__all__ = ["LEAST_KMH", "SpeedFuel"]

Floats = NDArray[np.float64]

LEAST_KMH = 60.0
"""Below this a truck on a motorway is in the way of others, and in many countries not allowed."""


@dataclass(frozen=True, slots=True)
class SpeedFuel:
    """How fuel per kilometre follows speed.

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

    Raises
    ------
    ScenarioError
        A value that is none, or out of its range.
    """

    rolling: float = ROLLING
    drag: float = DRAG
    air_kgpm3: float = AIR_KGPM3
    auxiliary_kw: float = 5.0

    def __post_init__(self) -> None:
        check_ranges("speed fuel", self, {**RANGES, "auxiliary_kw": (0.0, 50.0)})

    def force_n(
        self, speed_mps: ArrayLike, vehicle: Vehicle | str | None = None, air_saved: float = 0.0
    ) -> Floats:
        """Return the force that fuel per metre is proportional to, auxiliaries included.

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
            P / v [N].
        """
        steady = Consumption(
            rolling=self.rolling,
            drag=self.drag,
            air_kgpm3=self.air_kgpm3,
            auxiliary_kw=self.auxiliary_kw,
            unsteady=0.0,
        )
        return steady.force_n(speed_mps, vehicle, air_saved)

    def ratio(
        self, speed_mps: ArrayLike, usual_mps: ArrayLike, vehicle: Vehicle | str | None = None
    ) -> Floats:
        """Return fuel per kilometre at some speed over that at the usual one.

        Parameters
        ----------
        speed_mps, usual_mps : array_like of float, (k,)
            Speeds [m/s], more than 0.
        vehicle : Vehicle, str or None
            Who drives, or a name of `VEHICLES`; by default `eu-40t`.

        Returns
        -------
        ndarray of float, (k,)
            Below 1 where it is saved.
        """
        return self.force_n(speed_mps, vehicle) / self.force_n(usual_mps, vehicle)

    def slowest_in_time(
        self,
        length_m: ArrayLike,
        usual_mps: ArrayLike,
        spare_s: float,
        vehicle: Vehicle | str | None = None,
    ) -> tuple[float, float, float]:
        """Return the whole km/h that saves most fuel on a way, if time is to spare.

        Edges that are driven faster are driven at that speed, others as usual. Every whole km/h
        from `LEAST_KMH` on is tried.

        Parameters
        ----------
        length_m, usual_mps : array_like of float, (k,)
            Lengths [m] and usual speeds [m/s] of the edges.
        spare_s : float
            How much longer the way may take [s].
        vehicle : Vehicle, str or None
            Who drives, or a name of `VEHICLES`; by default `eu-40t`.

        Returns
        -------
        speed_kmh : float
            The highest speed driven [km/h]; the usual one if nothing is saved.
        longer_s : float
            How much longer it takes [s].
        saved : float
            Share of the way's fuel that is saved, if every metre usually takes the same.
        """
        length, usual = np.asarray(length_m, np.float64), np.asarray(usual_mps, np.float64)
        top = float(usual.max(initial=0.0)) * 3.6
        best = top, 0.0, 0.0
        total = float(length.sum())
        for kmh in np.arange(LEAST_KMH, np.ceil(top)):
            speed = np.minimum(usual, kmh / 3.6)
            longer = float((length / speed - length / usual).sum())
            if longer > spare_s:
                continue
            fuel = float((length * self.ratio(speed, usual, vehicle)).sum())
            if total and 1 - fuel / total > best[2]:
                best = float(kmh), longer, 1 - fuel / total
        return best
