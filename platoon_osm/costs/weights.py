"""The two weights of every edge, alone and in a platoon: the paper's preset.

References
----------
.. [1] Adas et al., "Joint travel route optimization", IFAC 2025.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import asdict, dataclass
from typing import Any, Literal

import numpy as np
from numpy.typing import NDArray

from ..errors import ScenarioError
from ..network.road_network import RoadNetwork
from .fuel import fuel_saving

__all__ = ["EdgeWeights", "Mixing", "PaperCosts", "paper_weights"]

Mixing = Literal["printed", "gain"]
Position = Literal["leader", "follower"]
Floats = NDArray[np.float64]


@dataclass(frozen=True, slots=True, eq=False)
class EdgeWeights:
    """What each edge of a network costs one vehicle.

    Attributes
    ----------
    solo, platoon : (m,) cost of one vehicle alone, and of one member of a platoon.
    master : (m,) cost of the vehicle whose route the others join, in a platoon; equal to
        `platoon` where the lead is rotated.
    unit : of the costs.
    params : everything they were made from, for the record.
    fuel_l_per_m : litres a metre alone, as the master of a platoon, and as a member of one; for the
        fuel figures of a plan, not for its choice.
    """

    solo: Floats
    platoon: Floats
    master: Floats
    unit: str
    params: Mapping[str, Any]
    fuel_l_per_m: tuple[float, float, float] = (0.0, 0.0, 0.0)

    def __post_init__(self) -> None:
        for label in ("solo", "platoon", "master"):
            array = np.asarray(getattr(self, label), np.float64)
            if array.shape != (len(self.solo),):
                raise ScenarioError(
                    f"weights: {label} has shape {array.shape}; one cost for each of "
                    f"{len(self.solo)} edges is needed"
                )
            right = np.isfinite(array) & (array >= 0)
            if not right.all():
                worst = int(np.argmin(right))
                raise ScenarioError(
                    f"weights: {label} cost of edge {worst} is {array[worst]}; costs must be "
                    "finite and 0 or more"
                )
            # A copy, so that freezing it does not freeze the caller's own array.
            frozen = array.copy()
            frozen.flags.writeable = False
            object.__setattr__(self, label, frozen)


@dataclass(frozen=True, slots=True)
class PaperCosts:
    """Parameters of the paper's cost model, in its symbols.

    Attributes
    ----------
    tau, xi : [0, 1], weights of time and fuel in a platoon (eq. 13).
    mixing : "printed" is eq. 13 as it stands; "gain" reads tau and xi as gains (method.md, 1).
    fuel_saving : s, share of fuel saved in a platoon, [0, 1), by each vehicle: the lead is rotated.
    positions : name of a preset of `FUEL_SAVINGS` if the lead is not rotated: the master leads and
        saves the leader's share, members save the follower's; it stands in place of `fuel_saving`.
    speed_kmh : v_c, cruising speed.
    rest_s, driving_s : T_r and T_EU, 45 min of rest for 9 h of driving.
    fuel_l_per_100km : f; it cancels in the cost (kappa_FC = 1 / f) and serves the fuel figures.
    """

    tau: float = 1.0
    xi: float = 0.18
    mixing: Mixing = "printed"
    fuel_saving: float = 0.18
    positions: str | None = None
    speed_kmh: float = 110.0
    rest_s: float = 2700.0
    driving_s: float = 32400.0
    fuel_l_per_100km: float = 32.0

    def __post_init__(self) -> None:
        for name, low, high in (
            ("tau", 0.0, 1.0), ("xi", 0.0, 1.0), ("fuel_saving", 0.0, 0.99),
            ("speed_kmh", 1.0, 200.0), ("rest_s", 0.0, math.inf), ("driving_s", 1.0, math.inf),
            ("fuel_l_per_100km", 0.1, 1000.0),
        ):  # fmt: skip
            value = getattr(self, name)
            is_number = isinstance(value, int | float) and not isinstance(value, bool)
            if not (is_number and low <= value <= high and math.isfinite(value)):
                raise ScenarioError(f"{name} = {value!r} must be a number in [{low:g}, {high:g}]")
        if self.mixing not in ("printed", "gain"):
            raise ScenarioError(f'mixing = {self.mixing!r} must be "printed" or "gain"')
        if self.positions is not None:
            fuel_saving(self.positions)
            if self.mixing == "gain":
                raise ScenarioError(
                    f'positions = {self.positions!r} needs mixing = "printed": read as gains, xi '
                    "is the saving itself"
                )

    def saving(self, position: Position = "follower") -> float:
        """Share of fuel saved at a position in the platoon."""
        if self.positions is None:
            return self.fuel_saving
        preset = fuel_saving(self.positions)
        return preset.leader if position == "leader" else preset.last

    # Each method is one of the paper's symbols, per metre of road.

    def travel_alone(self) -> float:
        """C_T(I) / d [s/m]: driving and the rest it calls for, eq. 4 of [1]_."""
        return (1 + self.rest_s / self.driving_s) / (self.speed_kmh / 3.6)

    def travel_platoon(self) -> float:
        """C_T(P) / d [s/m]: rest is taken while following, eq. 4 of [1]_."""
        return 1 / (self.speed_kmh / 3.6)

    def fuel_alone(self) -> float:
        """C_FC(I) / d [l/m], eq. 5 of [1]_."""
        return self.fuel_l_per_100km / 100_000

    def fuel_platoon(self, position: Position = "follower") -> float:
        """C_FC(P) / d [l/m], eq. 5 of [1]_."""
        return (1 - self.saving(position)) * self.fuel_alone()

    def solo_factor(self) -> float:
        """w_I / d, eq. 12 of [1]_: distance, time and fuel, each rescaled to metres by kappa."""
        kappa_t, kappa_fc = self.speed_kmh / 3.6, 1 / self.fuel_alone()
        return 1 + kappa_t * self.travel_alone() + kappa_fc * self.fuel_alone()

    def platoon_factor(self, position: Position = "follower") -> float:
        """w_P / d, eq. 13 of [1]_, or its reading as gains."""
        kappa_t, kappa_fc = self.speed_kmh / 3.6, 1 / self.fuel_alone()
        if self.mixing == "printed":
            return (
                1
                + self.tau * kappa_t * self.travel_platoon()
                + self.xi * kappa_fc * self.fuel_platoon(position)
            )
        waiting_saved = self.travel_alone() - self.travel_platoon()
        return (
            1
            + kappa_t * (self.travel_platoon() + (1 - self.tau) * waiting_saved)
            + (1 - self.xi) * kappa_fc * self.fuel_alone()
        )


def paper_weights(net: RoadNetwork, costs: PaperCosts | None = None, **params: Any) -> EdgeWeights:
    """Return the paper's weights of every edge, in metre-equivalents (eq. 12 to 14 of [1]_).

    Parameters
    ----------
    costs : a `PaperCosts`, or give its fields by name: `paper_weights(net, tau=1.0, xi=0.18)`.

    Raises
    ------
    ScenarioError
        A parameter unknown or out of range.
    """
    if costs is not None and params:
        raise ScenarioError("paper_weights: give a PaperCosts or its fields by name, not both")
    if costs is None:
        unknown = set(params) - set(PaperCosts.__slots__)
        if unknown:
            raise ScenarioError(
                f"cost parameter {sorted(unknown)[0]!r} is unknown; the paper's are "
                + ", ".join(PaperCosts.__slots__)
            )
        costs = PaperCosts(**params)
    return EdgeWeights(
        solo=net.length_m * costs.solo_factor(),
        platoon=net.length_m * costs.platoon_factor("follower"),
        master=net.length_m * costs.platoon_factor("leader"),
        unit="m",
        params={"preset": "paper", **asdict(costs)},
        fuel_l_per_m=(
            costs.fuel_alone(), costs.fuel_platoon("leader"), costs.fuel_platoon("follower")
        ),
    )  # fmt: skip
