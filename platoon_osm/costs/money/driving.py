"""What driving costs one vehicle on one network, term by term, alone and by place in a company.

.. math:: c = p_f L + p_h h t / 3600 + c_t + p_c k L / 10^6,

L being litres (`Consumption`, by speed, mass, climb and the air resistance that company saves), t
seconds, h the share of the driver's hour that is paid in that place, c_t the toll, k grams of CO2e
a litre tank to wheel. A company drives as its slowest, so litres and seconds are those of its pace.
"""

from __future__ import annotations

from dataclasses import dataclass, field, replace
from typing import Protocol

import numpy as np
from numpy.typing import NDArray

from ...network.road_network import RoadNetwork
from ...vehicles.pace import drive_times
from ...vehicles.profile import Vehicle, vehicle_of
from ..consumption import Consumption
from ..share import Share
from ..tolls.charges import due_m, toll_per_m

__all__ = ["TERMS", "Driving", "Prices"]

Floats = NDArray[np.float64]
Index = NDArray[np.int64]

TERMS = ("fuel", "driver", "toll", "co2")
"""What driving is paid for, in the order of all amounts."""

NO_LESS = 1e-12
"""A ratio this near to 1 is 1: it differs by the last digits of sums."""


class Prices(Protocol):
    """What driving is paid by: figures by the names they have in `MoneyCosts`."""

    @property
    def currency(self) -> str:
        """Of all prices, ISO 4217."""
        ...

    @property
    def fuel_per_l(self) -> float:
        """Of a litre."""
        ...

    @property
    def driver_per_h(self) -> float:
        """Of an hour of a driver."""
        ...

    @property
    def driver_following(self) -> float:
        """Share of that hour that is paid while following."""
        ...

    @property
    def toll(self) -> float:
        """Factor on the tolls of countries."""
        ...

    @property
    def toll_unknown_per_km(self) -> float:
        """Toll at a rate that is not known."""
        ...

    @property
    def co2_per_t(self) -> float:
        """Of a tonne of CO2e."""
        ...

    @property
    def to_wheel_kg_per_l(self) -> float:
        """CO2e of a litre, tank to wheel [kg/l]."""
        ...

    @property
    def consumption(self) -> Consumption:
        """How driving becomes fuel."""
        ...

    @property
    def told_sizes(self) -> tuple[int, ...]:
        """How large platoons are whose places may save unlike shares, and one beyond."""
        ...

    def air_saved(self, position: int, size: int) -> float:
        """Return the share of air resistance that a place in a platoon saves.

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
        ...


@dataclass(frozen=True, slots=True, eq=False)
class Driving:
    """Costs of one vehicle on one network; a `ByPlace`.

    Attributes
    ----------
    costs : Prices
        Prices, physics and savings by position.
    net : RoadNetwork
        The network.
    vehicle : Vehicle or None
        Who drives; None for the standard vehicle at whatever speed the network was loaded for.
    """

    costs: Prices
    net: RoadNetwork
    vehicle: Vehicle | None
    own_s: Floats = field(init=False)
    toll: Floats = field(init=False)

    def __post_init__(self) -> None:
        object.__setattr__(self, "own_s", drive_times(self.net, self.vehicle))
        object.__setattr__(self, "toll", self._toll())

    def __eq__(self, other: object) -> bool:
        return (
            isinstance(other, Driving)
            and self.costs == other.costs
            and self.net is other.net
            and self._who() == other._who()
        )

    def __hash__(self) -> int:
        return hash((id(self.net), self._who()))

    def _who(self) -> Vehicle | None:
        """Return the vehicle without its name, which costs nothing."""
        return None if self.vehicle is None else replace(self.vehicle, name="any")

    def _toll(self) -> Floats:
        """Return what each edge costs in toll, in the currency of the prices."""
        prices, who = self.costs, vehicle_of(self.vehicle)
        due = due_m(self.net, who)
        unknown = due * prices.toll_unknown_per_km / 1000
        if prices.currency != "EUR":
            # Rates of the table are in the money of their country; what is not ours is not known.
            return unknown * prices.toll
        known = toll_per_m(self.net, who) * self.net.length_m
        return np.where(np.isnan(known), unknown, known) * prices.toll

    def litres(
        self, edges: Index | None = None, drive_s: Floats | None = None, air_saved: float = 0.0
    ) -> Floats:
        """Return the fuel of some edges.

        Parameters
        ----------
        edges : ndarray of int, (k,), optional
            By default all of the network.
        drive_s : ndarray of float, (k,), optional
            How long each is driven [s]; by default at the vehicle's own pace.
        air_saved : float
            Share of air resistance that company saves.

        Returns
        -------
        ndarray of float, (k,)
            Litres [l].
        """
        ids = np.arange(self.net.m) if edges is None else edges
        seconds = self.own_s[ids] if drive_s is None else drive_s
        found: Floats = self.costs.consumption.litres(
            self.net,
            vehicle_of(self.vehicle),
            edges=ids,
            speed_mps=self.net.length_m[ids] / seconds,
            air_saved=air_saved,
        )
        return found

    def amounts(
        self,
        edges: Index | None = None,
        drive_s: Floats | None = None,
        air_saved: float = 0.0,
        following: bool = False,
    ) -> Floats:
        """Return what some edges cost, term by term.

        Parameters
        ----------
        edges : ndarray of int, (k,), optional
            By default all of the network.
        drive_s : ndarray of float, (k,), optional
            How long each is driven [s]; by default at the vehicle's own pace.
        air_saved : float
            Share of air resistance that company saves.
        following : bool
            Whether it follows others.

        Returns
        -------
        ndarray of float, (4, k)
            In the order of `TERMS`.
        """
        ids = np.arange(self.net.m) if edges is None else edges
        seconds = self.own_s[ids] if drive_s is None else drive_s
        return self._priced(ids, seconds, self.litres(ids, seconds, air_saved), following)

    def _priced(self, ids: Index, seconds: Floats, litres: Floats, following: bool) -> Floats:
        """Return what edges cost by the time and fuel that they take."""
        prices = self.costs
        paid = prices.driver_per_h / 3600 * (prices.driver_following if following else 1.0)
        return np.array(
            [
                prices.fuel_per_l * litres,
                paid * seconds,
                self.toll[ids],
                prices.co2_per_t / 1000 * prices.to_wheel_kg_per_l * litres,
            ]
        )

    @property
    def told_sizes(self) -> tuple[int, ...]:
        """The sizes whose places may cost unlike amounts, and one beyond; see `ByPlace`."""
        return self.costs.told_sizes

    def solo(self) -> Floats:
        """Return what each edge costs alone.

        Returns
        -------
        ndarray of float, (m,)
            All terms together.
        """
        return _summed(self.amounts())

    def share(self, edges: Index, position: int, size: int, drive_s: Floats | None) -> Share:
        """Return what the vehicle pays on a stretch; see `ByPlace`.

        Parameters
        ----------
        edges : ndarray of int, (k,)
            Edges of the stretch.
        position : int
            Place of the vehicle in the company; 0 leads.
        size : int
            Vehicles in the company.
        drive_s : ndarray of float, (k,), or None
            How long the company drives each edge [s]; None for the vehicle's own pace.

        Returns
        -------
        Share
            Cost, fuel and terms, as planned and alone.
        """
        own_s = self.own_s[edges]
        litres = self.litres(edges, own_s)
        alone = self._priced(edges, own_s, litres, following=False).sum(axis=1)
        alone_l = float(litres.sum())
        if size < 2:
            terms = tuple(alone.tolist())
            return Share(sum(terms), sum(terms), alone_l, alone_l, terms=terms, alone_terms=terms)
        seconds = own_s if drive_s is None else drive_s
        litres = self.litres(edges, seconds, self._air_saved(position, size))
        joint = self._priced(edges, seconds, litres, following=position > 0).sum(axis=1)
        terms, alone_terms = tuple(joint.tolist()), tuple(alone.tolist())
        return Share(
            sum(terms),
            sum(alone_terms),
            float(litres.sum()),
            alone_l,
            terms=terms,
            alone_terms=alone_terms,
        )

    def in_place(self, position: int, size: int, drive_s: Floats | None) -> Floats:
        """Return what the vehicle pays on each edge in a place of a company; see `ByPlace`.

        Parameters
        ----------
        position : int
            Place of the vehicle in the company; 0 leads.
        size : int
            Vehicles in the company.
        drive_s : ndarray of float, (m,), or None
            How long the company drives each edge [s]; None for the vehicle's own pace.

        Returns
        -------
        ndarray of float, (m,)
            All terms together.
        """
        saved = self._air_saved(position, size)
        return _summed(self.amounts(None, drive_s, saved, following=position > 0))

    def planned(self, slowest_s: Floats | None) -> tuple[Floats, Floats]:
        """Return the most a member and a master may pay on each edge; see `ByPlace`.

        Of one place costs are convex in the speed, so between two paces they are highest at one of
        both.

        Parameters
        ----------
        slowest_s : ndarray of float, (m,), or None
            How long the slowest vehicle drives each edge [s]; None if all are as fast.

        Returns
        -------
        tuple of ndarray of float, (m,)
            Of a member and of a master.
        """
        behind, front = self._least_saved()
        paces = [None] if slowest_s is None else [None, slowest_s]
        member, master = (
            np.maximum.reduce(
                [_summed(self.amounts(None, pace, saved, following)) for pace in paces]
            )
            for saved, following in ((behind, True), (front, False))
        )
        return member, master

    def least(self, vehicles: int, slowest_s: Floats | None) -> float:
        """Return the least ratio of real to planned cost in company; see `ByPlace`.

        Parameters
        ----------
        vehicles : int
            How many there are in all.
        slowest_s : ndarray of float, (m,), or None
            As in `planned`.

        Returns
        -------
        float
            At most 1.
        """
        member, master = self.planned(slowest_s)
        own = self.own_s
        paces = [own] if slowest_s is None else [own, np.maximum(own, slowest_s)]
        ratio = 1.0
        for size in (one for one in self.costs.told_sizes if one <= vehicles):
            saved = [self._air_saved(place, size) for place in range(size)]
            for most, following, plan in (
                (max(saved[1:]), True, member),
                (saved[0], False, master),
            ):
                # The least of each term by itself, at whichever pace: no pace costs less.
                real = _summed(
                    np.minimum.reduce([self.amounts(None, pace, most, following) for pace in paces])
                )
                paid = plan > 0
                ratio = min(ratio, float((real[paid] / plan[paid]).min(initial=1.0)))
        return 1.0 if ratio > 1 - NO_LESS else ratio

    def on(self, net: RoadNetwork) -> Driving:
        """Return the same on another network.

        Parameters
        ----------
        net : RoadNetwork
            Such as one with places between its junctions.

        Returns
        -------
        Driving
            Of the same vehicle.
        """
        return Driving(self.costs, net, self.vehicle)

    def _air_saved(self, position: int, size: int) -> float:
        return self.costs.air_saved(position, size)

    def _least_saved(self) -> tuple[float, float]:
        """Return the least share of air resistance that is saved behind others, and in front."""
        sizes = self.costs.told_sizes
        behind = min(self._air_saved(k, size) for size in sizes for k in range(1, size))
        return behind, min(self._air_saved(0, size) for size in sizes)


def _summed(amounts: Floats) -> Floats:
    total: Floats = amounts.sum(axis=0)
    return total
