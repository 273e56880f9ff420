"""What every edge of a network costs: alone, in a platoon, and as its master."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..errors import ScenarioError, brief
from ..network.road_network import RoadNetwork
from .by_place import ByPlace
from .share import Share

__all__ = ["EdgeWeights"]

Floats = NDArray[np.float64]


@dataclass(frozen=True, slots=True, eq=False, repr=False)
class EdgeWeights:
    """What each edge of a network costs one vehicle.

    Attributes
    ----------
    solo, platoon : ndarray of float, (m,)
        Cost of one vehicle alone, and of one member of a platoon as it is planned with: how many
        will drive together is not known when members choose.
    master : ndarray of float, (m,)
        Cost of the vehicle whose route the others join, in a platoon; equal to `platoon` where the
        lead is rotated.
    unit : str
        Unit of the costs.
    params : mapping of str to object
        Everything they were made from, for the record.
    fuel_l_per_m : tuple of float, (3,)
        Litres a metre alone, as the master of a platoon, and as a member of one; for the fuel
        figures of a plan, not for its choice.
    network : str
        `RoadNetwork.identity` of the network they were made for; empty if that was not told, and
        then any network of as many edges will do.
    middle, last : ndarray of float, (m,), or None
        What a member really pays between first and last, and as the last, where its place matters;
        at most `platoon`. None if it pays `platoon`.
    middle_fuel_l_per_m : float or None
        Litres a metre between first and last; None if they are a member's as above.
    by_place : ByPlace or None
        What is really paid by place, size and pace of a company; None if the arrays say all.
    slowest_s : ndarray of float, (m,), or None
        How long the slowest vehicle of a fleet drives each edge [s]; None if all are as fast.

    Raises
    ------
    ScenarioError
        Arrays of other sizes, a cost that is negative or not finite, or a member's real cost above
        the one that is planned with.
    """

    solo: Floats
    platoon: Floats
    master: Floats
    unit: str
    params: Mapping[str, Any]
    fuel_l_per_m: tuple[float, float, float] = (0.0, 0.0, 0.0)
    network: str = ""
    middle: Floats | None = None
    last: Floats | None = None
    middle_fuel_l_per_m: float | None = None
    by_place: ByPlace | None = None
    slowest_s: Floats | None = None

    def __post_init__(self) -> None:
        for label in ("solo", "platoon", "master", "middle", "last"):
            if getattr(self, label) is None and label in ("middle", "last"):
                continue
            array = _numbers(label, getattr(self, label))
            if array.shape != (np.size(self.solo),):
                raise ScenarioError(
                    f"weights: {label} has shape {array.shape}; one cost for each of "
                    f"{np.size(self.solo)} edges is needed"
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
        for label in ("middle", "last"):
            real = getattr(self, label)
            if real is not None and (real > self.platoon).any():
                edge = int(np.argmax(real > self.platoon))
                raise ScenarioError(
                    f"weights: {label} cost of edge {edge} is {real[edge]:g}, above the "
                    f"{self.platoon[edge]:g} that is planned with; platoon must be the dearer of "
                    "middle and last"
                )

    def __repr__(self) -> str:
        return (
            f"<EdgeWeights of {len(self.solo):,} edges in {brief(self.unit)}, for network "
            f"{self.network or 'not told'}>"
        )

    def weights(self, net: RoadNetwork, vehicle: object = None) -> EdgeWeights:
        """Return these weights, once it is sure that they are the network's.

        So weights can stand wherever an `Objective` is asked only for its weights.

        Parameters
        ----------
        net : RoadNetwork
            The network they are to be used on.
        vehicle : object
            Not looked at: these weights are those of every vehicle.

        Returns
        -------
        EdgeWeights
            The same object.

        Raises
        ------
        ScenarioError
            They are those of another network.
        """
        del vehicle
        if len(self.solo) != net.m:
            raise ScenarioError(
                f"weights: they are those of {len(self.solo)} edges, {net.source.name} has "
                f"{net.m}; make them for this network"
            )
        if self.network and self.network != net.identity():
            raise ScenarioError(
                f"weights: they were made for another network ({self.network}) than "
                f"{net.source.name} ({net.identity()}); make them for this network"
            )
        return self

    def same(self, other: EdgeWeights) -> bool:
        """Tell whether others cost exactly the same, edge by edge.

        Parameters
        ----------
        other : EdgeWeights
            Of the same network.

        Returns
        -------
        bool
            Whether nobody could tell them apart.
        """
        return all(
            np.array_equal(own, theirs)
            if isinstance(own := getattr(self, name), np.ndarray)
            and isinstance(theirs := getattr(other, name), np.ndarray)
            else own is getattr(other, name) or own == getattr(other, name)
            for name in self.__slots__
        )

    def waiting(self, seconds: float) -> float:
        """Return what waiting costs under bare weights: nothing.

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

    def among(self, slowest_s: Floats) -> EdgeWeights:
        """Return the weights of the same vehicle in a fleet with slower ones.

        Parameters
        ----------
        slowest_s : ndarray of float, (m,)
            How long the slowest of the fleet drives each edge [s].

        Returns
        -------
        EdgeWeights
            The same object if no pace matters.
        """
        if self.by_place is None:
            return self
        platoon, master = self.by_place.planned(slowest_s)
        return replace(self, platoon=platoon, master=master, slowest_s=slowest_s)

    def share(
        self,
        edges: ArrayLike,
        length_m: float,
        position: int,
        size: int,
        drive_s: Floats | None = None,
    ) -> Share:
        """Return what one vehicle pays on a stretch driven in one company.

        Parameters
        ----------
        edges : array_like of int, (k,)
            Edges of the stretch.
        length_m : float
            Their length [m].
        position : int
            Place of the vehicle in the company; 0 leads.
        size : int
            Vehicles in the company.
        drive_s : ndarray of float, (k,), optional
            How long the company drives each edge [s]; by default as long as the vehicle alone.

        Returns
        -------
        Share
            Cost and fuel, as planned and alone.
        """
        ids = np.asarray(edges, np.int64)
        if self.by_place is not None:
            return self.by_place.share(ids, position, size, drive_s)
        alone_l, leading_l, following_l = self.fuel_l_per_m
        alone = float(self.solo[ids].sum())
        if size < 2:
            return Share(alone, alone, length_m * alone_l, length_m * alone_l)
        weight, litres = self.platoon, following_l
        if position == 0:
            weight, litres = self.master, leading_l
        elif position == size - 1:
            weight = self.platoon if self.last is None else self.last
        else:
            weight = self.platoon if self.middle is None else self.middle
            if self.middle_fuel_l_per_m is not None:
                litres = self.middle_fuel_l_per_m
        return Share(float(weight[ids].sum()), alone, length_m * litres, length_m * alone_l)

    def least_by_position(self, vehicles: int) -> float:
        """Return the least ratio of what a member may really pay to what is planned with.

        Parameters
        ----------
        vehicles : int
            How many there are in all; one can drive in the middle only among three.

        Returns
        -------
        float
            At most 1, which it is where places do not matter.
        """
        if self.by_place is not None:
            return self.by_place.least(vehicles, self.slowest_s)
        least = 1.0
        for real, needed in ((self.last, 2), (self.middle, 3)):
            if real is not None and vehicles >= needed:
                paid = self.platoon > 0
                least = min(least, float((real[paid] / self.platoon[paid]).min(initial=1.0)))
        return least


def _numbers(label: str, values: ArrayLike) -> Floats:
    try:
        return np.asarray(values, np.float64)
    except (TypeError, ValueError):
        raise ScenarioError(
            f"weights: {label} is no array of numbers; give one cost for each edge"
        ) from None
