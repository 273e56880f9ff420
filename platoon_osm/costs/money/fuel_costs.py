"""Fuel alone, in litres; an `Objective` that asks for no price."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import asdict, dataclass, field, replace
from typing import Any, ClassVar

from ...network.road_network import RoadNetwork
from ...vehicles.profile import Vehicle
from ..consumption import Consumption
from ..fuel import FuelSaving, fuel_saving
from ..weights import EdgeWeights
from .objective import MoneyCosts, consumption_of

__all__ = ["FuelCosts", "fuel_costs"]


@dataclass(frozen=True, slots=True)
class FuelCosts:
    """Litres of fuel, alone and by place in a platoon; an `Objective`.

    Attributes
    ----------
    positions : str or FuelSaving
        What each place in a platoon saves, a name of `FUEL_SAVINGS`.
    consumption : Consumption
        How driving becomes fuel.

    Raises
    ------
    ScenarioError
        A name or value that is none.
    """

    positions: str | FuelSaving = "eddi"
    consumption: Consumption = field(default_factory=Consumption)

    name: ClassVar[str] = "fuel"
    unit: ClassVar[str] = "l"

    def __post_init__(self) -> None:
        fuel_saving(self.positions)

    @property
    def params(self) -> Mapping[str, Any]:
        """All parameters by name, with the preset's name first."""
        return {
            "preset": self.name,
            "positions": fuel_saving(self.positions).name,
            **asdict(self.consumption),
        }

    def weights(self, net: RoadNetwork, vehicle: Any = None) -> EdgeWeights:
        """Return the fuel of each edge, alone and in a platoon.

        Parameters
        ----------
        net : RoadNetwork
            The network.
        vehicle : Vehicle or str or None
            Who drives; None for the standard vehicle.

        Returns
        -------
        EdgeWeights
            Litres [l].
        """
        found = self._priced().weights(net, vehicle)
        return replace(found, unit=self.unit, params=self.params)

    def waiting(self, seconds: float) -> float:
        """Return what waiting costs: no fuel.

        Parameters
        ----------
        seconds : float
            How long.

        Returns
        -------
        float
            Always 0.
        """
        del seconds
        return 0.0

    def per_km(
        self, vehicle: Vehicle | str | None, position: int, size: int, speed_kmh: float
    ) -> float:
        """Return what a kilometre of level road takes.

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
            Litres [l].
        """
        return self._priced().per_km(vehicle, position, size, speed_kmh)

    def _priced(self) -> MoneyCosts:
        """Return prices under which costs are litres: one costs one, and all else nothing."""
        return MoneyCosts(
            "eu", 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
            positions=self.positions, consumption=self.consumption,
        )  # fmt: skip


def fuel_costs(**params: Any) -> FuelCosts:
    """Return costs in fuel with some figures changed.

    Parameters
    ----------
    **params : float or str
        `positions`, and fields of `Consumption` by name.

    Returns
    -------
    FuelCosts
        An objective.

    Raises
    ------
    ScenarioError
        A figure that is none.
    """
    own = dict(params)
    physics = consumption_of(own)
    return FuelCosts(**own, consumption=physics)
