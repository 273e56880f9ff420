"""The paper's costs: distance, time and fuel, each rescaled to metres, alone and in a platoon.

References
----------
.. [1] Adas et al., "Joint travel route optimization", IFAC 2025.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import asdict, dataclass, fields
from typing import Any, ClassVar, Literal, get_args

import numpy as np
from numpy.typing import NDArray

from ..errors import ScenarioError, brief
from ..kinds import is_number
from ..network.road_network import RoadNetwork
from .fuel import fuel_saving
from .objective import Role
from .weights import EdgeWeights

__all__ = ["Mixing", "PaperCosts", "PaperTerm", "paper_weights"]

Mixing = Literal["printed", "gain"]
Position = Literal["leader", "follower", "middle", "last"]
Floats = NDArray[np.float64]


@dataclass(frozen=True, slots=True)
class PaperTerm:
    """One term of eq. 11 and 12 of [1]_: a cost per metre for each role, rescaled to metres.

    Attributes
    ----------
    name : str
        "distance", "time" or "fuel".
    per_metre : mapping of str to float
        For each role, the metre equivalents that a metre of road costs.
    """

    name: str
    per_metre: Mapping[Role, float]
    unit: ClassVar[str] = "m"

    def per_edge(self, net: RoadNetwork, vehicle: object, role: Role) -> Floats:
        """Return what each edge costs; see `CostTerm`.

        Parameters
        ----------
        net : RoadNetwork
            The network.
        vehicle : object
            Not looked at: in the paper all vehicles are alike.
        role : {"alone", "master", "member"}
            In what company.

        Returns
        -------
        ndarray of float, (m,)
            Metre equivalents of each edge.
        """
        del vehicle
        return net.length_m * self.per_metre[role]


@dataclass(frozen=True, slots=True)
class PaperCosts:
    """Parameters of the paper's cost model, in its symbols; an `Objective`.

    Attributes
    ----------
    tau, xi : float
        Weights of time and fuel in a platoon (eq. 12), [0, 1].
    mixing : {"printed", "gain"}
        "printed" is eq. 12 as it stands; "gain" reads tau and xi as gains (method.md, 1).
    fuel_saving : float
        s, share of fuel saved in a platoon, [0, 1), by each vehicle: the lead is rotated.
    positions : str or None
        Name of a preset of `FUEL_SAVINGS` if the lead is not rotated: the master leads and saves
        the leader's share, the last vehicle saves the last one's, and those between save that of
        the middle; it stands in place of `fuel_saving`. Members choose as if each saved the lesser
        of middle and last.
    speed_kmh : float
        v_c, cruising speed [km/h].
    rest_s, driving_s : float
        T_r and T_EU [s], 45 min of rest for 9 h of driving.
    fuel_l_per_100km : float
        f; it cancels in the cost (kappa_FC = 1 / f) and serves the fuel figures.
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

    name: ClassVar[str] = "paper"
    unit: ClassVar[str] = "m"

    def __post_init__(self) -> None:
        for name, low, high in (
            ("tau", 0.0, 1.0), ("xi", 0.0, 1.0), ("fuel_saving", 0.0, 0.99),
            ("speed_kmh", 1.0, 200.0), ("rest_s", 0.0, math.inf), ("driving_s", 1.0, math.inf),
            ("fuel_l_per_100km", 0.1, 1000.0),
        ):  # fmt: skip
            value = getattr(self, name)
            if not (is_number(value) and low <= value <= high and math.isfinite(value)):
                raise ScenarioError(
                    f"{name} = {brief(value)} must be a number in [{low:g}, {high:g}]"
                )
        if not isinstance(self.mixing, str) or self.mixing not in get_args(Mixing):
            raise ScenarioError(f'mixing = {brief(self.mixing)} must be "printed" or "gain"')
        if self.positions is not None:
            fuel_saving(self.positions)
            if self.mixing == "gain":
                raise ScenarioError(
                    f'positions = {brief(self.positions)} needs mixing = "printed": read as '
                    "gains, xi is the saving itself"
                )

    @property
    def params(self) -> Mapping[str, Any]:
        """All parameters by name, with the preset's name first."""
        return {"preset": self.name, **asdict(self)}

    def saving(self, position: Position = "follower") -> float:
        """Return the share of fuel saved at a position in the platoon.

        Parameters
        ----------
        position : {"leader", "follower", "middle", "last"}
            Where it drives; "follower" is any place behind the first, as it is planned with.

        Returns
        -------
        float
            The share, [0, 1).
        """
        if self.positions is None:
            return self.fuel_saving
        preset = fuel_saving(self.positions)
        return {
            "leader": preset.leader,
            "middle": preset.middle,
            "last": preset.last,
            "follower": min(preset.middle, preset.last),
        }[position]

    # Each method is one of the paper's symbols, per metre of road.

    def travel_alone(self) -> float:
        """Return C_T(I) / d [s/m]: driving and the rest it calls for, eq. 4 of [1]_.

        Returns
        -------
        float
            Seconds a metre.
        """
        return (1 + self.rest_s / self.driving_s) / (self.speed_kmh / 3.6)

    def travel_platoon(self) -> float:
        """Return C_T(P) / d [s/m]: rest is taken while following, eq. 5 of [1]_.

        Returns
        -------
        float
            Seconds a metre.
        """
        return 1 / (self.speed_kmh / 3.6)

    def fuel_alone(self) -> float:
        """Return C_FC(I) / d [l/m], which [1]_ gives without a number.

        Returns
        -------
        float
            Litres a metre.
        """
        return self.fuel_l_per_100km / 100_000

    def fuel_platoon(self, position: Position = "follower") -> float:
        """Return C_FC(P) / d [l/m], which [1]_ gives without a number.

        Parameters
        ----------
        position : {"leader", "follower", "middle", "last"}
            Where it drives; "follower" is any place behind the first, as it is planned with.

        Returns
        -------
        float
            Litres a metre.
        """
        return (1 - self.saving(position)) * self.fuel_alone()

    def terms(self) -> tuple[PaperTerm, ...]:
        """Return distance, time and fuel as cost terms, whose sum is the weight (eq. 11, 12).

        Returns
        -------
        tuple of PaperTerm
            In the order in which the paper adds them up.
        """
        kappa_t, kappa_fc = self.speed_kmh / 3.6, 1 / self.fuel_alone()
        if self.mixing == "printed":
            time = self.tau * kappa_t * self.travel_platoon()
            leading, following = (
                self.xi * kappa_fc * self.fuel_platoon(position)
                for position in ("leader", "follower")
            )
        else:
            rest_saved = self.travel_alone() - self.travel_platoon()
            time = kappa_t * (self.travel_platoon() + (1 - self.tau) * rest_saved)
            leading = following = (1 - self.xi) * kappa_fc * self.fuel_alone()
        return (
            PaperTerm("distance", {"alone": 1.0, "master": 1.0, "member": 1.0}),
            PaperTerm(
                "time", {"alone": kappa_t * self.travel_alone(), "master": time, "member": time}
            ),
            PaperTerm(
                "fuel",
                {"alone": kappa_fc * self.fuel_alone(), "master": leading, "member": following},
            ),
        )

    def solo_factor(self) -> float:
        """Return w_I / d, eq. 11 of [1]_: distance, time and fuel, rescaled to metres by kappa.

        Returns
        -------
        float
            Metre equivalents a metre.
        """
        return self._factor("alone")

    def platoon_factor(self, position: Position = "follower") -> float:
        """Return w_P / d, eq. 12 of [1]_, or its reading as gains.

        Parameters
        ----------
        position : {"leader", "follower", "middle", "last"}
            Where it drives; "follower" is any place behind the first, as it is planned with.

        Returns
        -------
        float
            Metre equivalents a metre.
        """
        factor = self._factor("master" if position == "leader" else "member")
        if position in ("leader", "follower") or self.positions is None:
            return factor
        # Positions stand with the printed mixing alone, where fuel is a term of its own.
        more = self.saving(position) - self.saving("follower")
        return factor - self.xi * more

    def per_km(self, vehicle: object, position: int, size: int, speed_kmh: float) -> float:
        """Return what a vehicle pays for a kilometre.

        Parameters
        ----------
        vehicle : object
            Not looked at: in the paper all vehicles are alike.
        position : int
            Its place; 0 leads.
        size : int
            Vehicles in the platoon; 1 is alone.
        speed_kmh : float
            Not looked at: in the paper all drive at the cruising speed.

        Returns
        -------
        float
            Metre equivalents a kilometre.
        """
        del vehicle, speed_kmh
        if size < 2:
            return 1000 * self.solo_factor()
        place: Position = "leader" if not position else "last" if position == size - 1 else "middle"
        return 1000 * self.platoon_factor(place)

    def _factor(self, role: Role) -> float:
        return sum(term.per_metre[role] for term in self.terms())

    def weights(self, net: RoadNetwork, vehicle: object = None) -> EdgeWeights:
        """Return the weights of every edge, in metre equivalents (eq. 11 to 13 of [1]_).

        Parameters
        ----------
        net : RoadNetwork
            The network.
        vehicle : object
            Not looked at: in the paper all vehicles are alike.

        Returns
        -------
        EdgeWeights
            Alone, in a platoon, and as its master.
        """
        del vehicle
        real: dict[Position, Floats | None] = {"middle": None, "last": None}
        if self.saving("middle") != self.saving("last"):
            for position in real:
                real[position] = net.length_m * self.platoon_factor(position)
        return EdgeWeights(
            solo=net.length_m * self.solo_factor(),
            platoon=net.length_m * self.platoon_factor("follower"),
            master=net.length_m * self.platoon_factor("leader"),
            unit=self.unit,
            params=self.params,
            fuel_l_per_m=(
                self.fuel_alone(), self.fuel_platoon("leader"), self.fuel_platoon("last")
            ),
            network=net.identity(),
            middle=real["middle"],
            last=real["last"],
            middle_fuel_l_per_m=self.fuel_platoon("middle"),
        )  # fmt: skip

    def waiting(self, seconds: float) -> float:
        """Return what waiting costs: nothing, in the paper.

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


def paper_weights(net: RoadNetwork, costs: PaperCosts | None = None, **params: Any) -> EdgeWeights:
    """Return the paper's weights of every edge, in metre equivalents (eq. 11 to 13 of [1]_).

    Parameters
    ----------
    net : RoadNetwork
        The network.
    costs : PaperCosts, optional
        All parameters at once.
    **params : float or str
        Or fields of `PaperCosts` by name: `paper_weights(net, tau=1.0, xi=0.18)`.

    Returns
    -------
    EdgeWeights
        Alone, in a platoon, and as its master.

    Raises
    ------
    ScenarioError
        A parameter unknown or out of range, or a network or costs that are none.

    References
    ----------
    .. [1] Adas et al., "Joint travel route optimization", IFAC 2025.
    """
    if not isinstance(net, RoadNetwork):
        raise ScenarioError(
            f"paper_weights: a {type(net).__name__} is no network; give one from load_network first"
        )
    if costs is not None and params:
        raise ScenarioError("paper_weights: give a PaperCosts or its fields by name, not both")
    if costs is None:
        known = [item.name for item in fields(PaperCosts)]
        unknown = set(params) - set(known)
        if unknown:
            raise ScenarioError(
                f"cost parameter {sorted(unknown)[0]!r} is unknown; the paper's are "
                + ", ".join(known)
            )
        costs = PaperCosts(**params)
    if not isinstance(costs, PaperCosts):
        raise ScenarioError(
            f"paper_weights: costs is a {type(costs).__name__}; give a PaperCosts, or its fields "
            "by name"
        )
    return costs.weights(net)
