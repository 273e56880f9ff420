"""Costs in money: fuel, the driver's time, toll, CO2, waiting and delay; an `Objective`.

Every figure has a source (`figures.toml`, `FUEL_SAVINGS`, `Consumption`) and can be changed. What a
platoon saves is what was measured on roads, not the paper's 18 %.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import asdict, dataclass, field, fields, replace
from typing import Any

from ...errors import ScenarioError, brief
from ...kinds import is_number
from ...network.road_network import RoadNetwork
from ...vehicles.profile import Vehicle, vehicle_of
from ..consumption import Consumption
from ..cost_figure import CostFigure
from ..fuel import FuelSaving, fuel_saving
from ..weights import EdgeWeights
from .driving import TERMS, Driving
from .figures import GIVEN, figures_of, physics_of

__all__ = ["CURRENCIES", "PRICES", "MoneyCosts", "consumption_of", "money_costs"]

CURRENCIES = {"eu": "EUR", "us": "USD"}
"""Of the presets."""

PRICES = (
    "fuel_per_l", "driver_per_h", "driver_following", "toll", "toll_unknown_per_km", "co2_per_t",
    "waiting_per_h", "delay_per_h", "to_wheel_kg_per_l", "from_well_kg_per_l",
)  # fmt: skip
"""The figures of the table, by the names of their fields."""

MOST = 1e6
"""A price above this is a slip of the pen."""

LIKE_ANY = 3
"""A platoon of so many has all places that larger ones have, unless a table says otherwise."""

POSITIONS = "eddi"
"""Savings that were measured in daily service."""


@dataclass(frozen=True, slots=True)
class MoneyCosts:
    """Prices, and what driving, waiting and delay cost by them; an `Objective`.

    Attributes
    ----------
    preset : str
        "eu" or "us": where figures come from that are not given.
    fuel_per_l : float
        Price of a litre of diesel.
    driver_per_h : float
        What an hour of a driver costs.
    driver_following : float
        Share of it that is paid while following, [0, 1].
    toll : float
        Factor on the tolls of countries.
    toll_unknown_per_km : float
        Toll where some is due at a rate that is not known.
    co2_per_t : float
        Price of a tonne of CO2e, tank to wheel.
    waiting_per_h : float
        What an hour of waiting for others costs.
    delay_per_h : float
        What it costs to arrive an hour later than alone.
    to_wheel_kg_per_l, from_well_kg_per_l : float
        CO2e of a litre, tank to wheel and well to wheel [kg/l].
    positions : str or FuelSaving
        What each place in a platoon saves, a name of `FUEL_SAVINGS`.
    consumption : Consumption
        How driving becomes fuel.

    Raises
    ------
    ScenarioError
        A preset or figure that is none.
    """

    preset: str = "eu"
    fuel_per_l: float = math.nan
    driver_per_h: float = math.nan
    driver_following: float = math.nan
    toll: float = math.nan
    toll_unknown_per_km: float = math.nan
    co2_per_t: float = math.nan
    waiting_per_h: float = math.nan
    delay_per_h: float = math.nan
    to_wheel_kg_per_l: float = math.nan
    from_well_kg_per_l: float = math.nan
    positions: str | FuelSaving = POSITIONS
    consumption: Consumption = field(default_factory=Consumption)

    def __post_init__(self) -> None:
        if not (isinstance(self.preset, str) and self.preset in CURRENCIES):
            raise ScenarioError(
                f"money: preset {brief(self.preset)} is unknown; use {', '.join(CURRENCIES)}"
            )
        table = figures_of(self.preset)
        for name in PRICES:
            value = getattr(self, name)
            if isinstance(value, float) and math.isnan(value):
                # An hour's waiting is the driver's hour unless it has a price of its own.
                value = self.driver_per_h if name == "waiting_per_h" else table[name].value
            most = 1.0 if name == "driver_following" else MOST
            if not (is_number(value) and 0 <= value <= most):
                raise ScenarioError(f"{name} = {brief(value)} must be a number in [0, {most:g}]")
            object.__setattr__(self, name, float(value))
        fuel_saving(self.positions)
        if not isinstance(self.consumption, Consumption):
            raise ScenarioError(
                f"money: consumption is {brief(self.consumption)}; give a Consumption"
            )

    @property
    def name(self) -> str:
        """What scenarios and plans call it."""
        return self.preset

    @property
    def currency(self) -> str:
        """Of all prices, ISO 4217."""
        return CURRENCIES[self.preset]

    @property
    def unit(self) -> str:
        """Unit of all costs: the currency."""
        return self.currency

    @property
    def terms(self) -> tuple[str, ...]:
        """What driving is paid for, in the order of all shares."""
        return TERMS

    @property
    def kg_per_l(self) -> tuple[float, float]:
        """CO2e of a litre of fuel, tank to wheel and well to wheel [kg/l]."""
        return self.to_wheel_kg_per_l, self.from_well_kg_per_l

    @property
    def saving(self) -> FuelSaving:
        """What each place in a platoon saves."""
        return fuel_saving(self.positions)

    @property
    def told_sizes(self) -> tuple[int, ...]:
        """How large platoons are whose places may save unlike shares, and one beyond."""
        return tuple(range(2, max((LIKE_ANY, *self.saving.sizes)) + 2))

    def air_saved(self, position: int, size: int) -> float:
        """Return the share of air resistance that a place in a platoon saves.

        Tables have shares of fuel; of the fuel of their test air resistance took a known share.

        Parameters
        ----------
        position : int
            The place; 0 leads.
        size : int
            Vehicles in the platoon, 2 or more.

        Returns
        -------
        float
            The share, at most 1.
        """
        return self.saving.air_saved(position, size, self.consumption)

    @property
    def params(self) -> Mapping[str, Any]:
        """All figures by name, with the preset's name first."""
        own = {name: getattr(self, name) for name in PRICES}
        return {
            "preset": self.preset,
            **own,
            "positions": self.saving.name,
            **asdict(self.consumption),
        }

    def figures(self) -> tuple[CostFigure, ...]:
        """Return every figure with its unit and source.

        Returns
        -------
        tuple of CostFigure
            Prices, savings by place, then the physics of fuel.
        """
        table = figures_of(self.preset)
        prices = [
            known
            if (known := table[name]).value == (value := getattr(self, name))
            else CostFigure(name, value, known.unit, GIVEN)
            for name in PRICES
        ]
        saving = self.saving
        places = [
            CostFigure(f"saving_{place}", getattr(saving, place), "", saving.source)
            for place in ("leader", "middle", "last")
        ]
        return (*prices, *places, *physics_of(self.consumption))

    def weights(self, net: RoadNetwork, vehicle: Any = None) -> EdgeWeights:
        """Return what each edge costs a vehicle, alone and in a platoon.

        Parameters
        ----------
        net : RoadNetwork
            The network.
        vehicle : Vehicle or str or None
            Who drives; None for the standard vehicle.

        Returns
        -------
        EdgeWeights
            In the objective's currency; a member's and a master's are the most they may pay,
            whoever drives with them (`Driving`).
        """
        driving = Driving(self, net, None if vehicle is None else vehicle_of(vehicle))
        member, master = driving.planned(None)
        return EdgeWeights(
            solo=driving.solo(),
            platoon=member,
            master=master,
            unit=self.unit,
            params=self.params,
            network=net.identity(),
            by_place=driving,
        )

    def waiting(self, seconds: float) -> float:
        """Return what waiting on the road costs.

        Parameters
        ----------
        seconds : float
            How long.

        Returns
        -------
        float
            Its cost.
        """
        return self.waiting_per_h * seconds / 3600

    def delay(self, seconds: float) -> float:
        """Return what it costs to arrive later than alone.

        Parameters
        ----------
        seconds : float
            How much later.

        Returns
        -------
        float
            Its cost.
        """
        return self.delay_per_h * seconds / 3600

    def per_km(
        self, vehicle: Vehicle | str | None, position: int, size: int, speed_kmh: float
    ) -> float:
        """Return what a kilometre of level road without toll costs.

        Parameters
        ----------
        vehicle : Vehicle or str or None
            Who drives; None for the standard vehicle.
        position, size : int
            Its place in a company of that many; 0 leads.
        speed_kmh : float
            How fast [km/h].

        Returns
        -------
        float
            In the objective's currency.
        """
        km = RoadNetwork.from_edges(
            [0], [1], [1000.0], lon=[0.0, 0.009], lat=[0.0, 0.0], speed_mps=speed_kmh / 3.6
        )
        driving = Driving(replace(self, toll=0.0), km, vehicle_of(vehicle))
        pace = driving.net.length_m / (speed_kmh / 3.6)
        saved = self.air_saved(position, size) if size > 1 else 0.0
        return float(driving.amounts(None, pace, saved, following=position > 0).sum())


def consumption_of(params: dict[str, Any]) -> Consumption:
    """Return the physics of fuel, and take its parameters from those given.

    Parameters
    ----------
    params : dict of str to object
        By name; fields of `Consumption` are taken out.

    Returns
    -------
    Consumption
        With the values given.

    Raises
    ------
    ScenarioError
        A value that is none.
    """
    names = [item.name for item in fields(Consumption)]
    return Consumption(**{name: params.pop(name) for name in names if name in params})


def money_costs(preset: str = "eu", **params: Any) -> MoneyCosts:
    """Return costs in money with some figures changed.

    Parameters
    ----------
    preset : str
        "eu" or "us".
    **params : float or str
        Fields of `MoneyCosts` and of `Consumption` by name.

    Returns
    -------
    MoneyCosts
        An objective.

    Raises
    ------
    ScenarioError
        A figure that is unknown or none.
    """
    own = dict(params)
    physics = consumption_of(own)
    for name in own:
        if name not in (*PRICES, "positions"):
            raise ScenarioError(
                f"cost parameter {brief(name)} is unknown; those of money are "
                + ", ".join((*PRICES, "positions"))
            )
    return MoneyCosts(preset, **own, consumption=physics)
