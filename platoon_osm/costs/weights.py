"""What every edge of a network costs: alone, in a platoon, and as its master."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..errors import ScenarioError
from ..network.road_network import RoadNetwork
from .share import Share

__all__ = ["EdgeWeights"]

Floats = NDArray[np.float64]


@dataclass(frozen=True, slots=True, eq=False)
class EdgeWeights:
    """What each edge of a network costs one vehicle.

    Attributes
    ----------
    solo, platoon : ndarray of float, (m,)
        Cost of one vehicle alone, and of one member of a platoon.
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

    Raises
    ------
    ScenarioError
        Arrays of other sizes, or a cost that is negative or not finite.
    """

    solo: Floats
    platoon: Floats
    master: Floats
    unit: str
    params: Mapping[str, Any]
    fuel_l_per_m: tuple[float, float, float] = (0.0, 0.0, 0.0)
    network: str = ""

    def __post_init__(self) -> None:
        for label in ("solo", "platoon", "master"):
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

    def share(self, edges: ArrayLike, length_m: float, position: int, size: int) -> Share:
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

        Returns
        -------
        Share
            Cost and fuel, as planned and alone.
        """
        ids = np.asarray(edges, np.int64)
        alone_l, leading_l, following_l = self.fuel_l_per_m
        alone = float(self.solo[ids].sum())
        if size < 2:
            return Share(alone, alone, length_m * alone_l, length_m * alone_l)
        weight, litres = (self.master, leading_l) if position == 0 else (self.platoon, following_l)
        return Share(float(weight[ids].sum()), alone, length_m * litres, length_m * alone_l)


def _numbers(label: str, values: ArrayLike) -> Floats:
    try:
        return np.asarray(values, np.float64)
    except (TypeError, ValueError):
        raise ScenarioError(
            f"weights: {label} is no array of numbers; give one cost for each edge"
        ) from None
