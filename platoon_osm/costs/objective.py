"""What a plan is to save: anything that gives every edge its costs and prices waiting.

A planner asks an objective for the weights of the edges and for the price of waiting, and nothing
else. A new one needs no base class: a dataclass with these members will do, such as `PaperCosts`.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any, Literal, Protocol

import numpy as np
from numpy.typing import NDArray

from ..errors import ScenarioError, brief
from ..kinds import kind_of
from ..network.road_network import RoadNetwork
from .weights import EdgeWeights

__all__ = ["CostTerm", "Objective", "Role", "check_objective", "edge_weights"]

Floats = NDArray[np.float64]

Role = Literal["alone", "master", "member"]
"""In what company a vehicle drives: alone, leading others, or following."""


class CostTerm(Protocol):
    """One part of what driving costs, such as time or fuel; an objective adds up several."""

    @property
    def name(self) -> str:
        """What it is called in tables."""
        ...

    @property
    def unit(self) -> str:
        """Unit of its costs; terms that are added up share it."""
        ...

    def per_edge(self, net: RoadNetwork, vehicle: object, role: Role) -> Floats:
        """Return what each edge costs.

        Parameters
        ----------
        net : RoadNetwork
            The network.
        vehicle : object
            Who drives; None for the standard vehicle.
        role : {"alone", "master", "member"}
            In what company.

        Returns
        -------
        ndarray of float, (m,)
            Cost of each edge, 0 or more.
        """
        ...


class Objective(Protocol):
    """What is to be least.

    One may have a method `delay` besides, like `waiting`: what it costs to arrive so many seconds
    later than alone, leaving as early as the trip allows. Without it delay costs nothing.
    """

    @property
    def name(self) -> str:
        """What it is called in scenarios and plans."""
        ...

    @property
    def unit(self) -> str:
        """Unit of all costs: "m", "EUR", or any other."""
        ...

    @property
    def params(self) -> Mapping[str, Any]:
        """All that it depends on, for the record."""
        ...

    def weights(self, net: RoadNetwork, vehicle: object = None) -> EdgeWeights:
        """Return what each edge costs a vehicle, alone and in a platoon.

        Parameters
        ----------
        net : RoadNetwork
            The network.
        vehicle : object
            Who drives; None for the standard vehicle.

        Returns
        -------
        EdgeWeights
            Costs of the network's edges.
        """
        ...

    def waiting(self, seconds: float) -> float:
        """Return what waiting on the road costs.

        Parameters
        ----------
        seconds : float
            How long.

        Returns
        -------
        float
            Its cost, 0 if waiting is free.
        """
        ...


def check_objective(given: object, where: str, methods: tuple[str, ...]) -> None:
    """Check that what was given can be asked what an objective is asked.

    Parameters
    ----------
    given : object
        An objective, or anything else.
    where : str
        Who asks, for the message.
    methods : tuple of str
        The methods that are going to be called.

    Raises
    ------
    ScenarioError
        One of them is missing, or a class was given in place of an object.
    """
    answers = all(callable(getattr(given, method, None)) for method in methods)
    if isinstance(given, type) or not answers:
        raise ScenarioError(
            f"{where}: weights is a {kind_of(given)}; give edge weights, such as "
            "paper_weights(net), or an objective"
        )


def edge_weights(
    objective: Objective | EdgeWeights, net: RoadNetwork, where: str, vehicle: object = None
) -> EdgeWeights:
    """Return the weights that an objective gives a network, once it is sure that they are that.

    Parameters
    ----------
    objective : Objective or EdgeWeights
        Whose weights.
    net : RoadNetwork
        The network they are to be used on.
    where : str
        Who asks, for the message.
    vehicle : object
        Who drives; None for the standard vehicle.

    Returns
    -------
    EdgeWeights
        Those of this network.

    Raises
    ------
    ScenarioError
        No objective, one whose weights are none, or weights of another network.
    """
    check_objective(objective, where, ("weights",))
    weights = objective.weights(net) if vehicle is None else objective.weights(net, vehicle)
    if not isinstance(weights, EdgeWeights):
        raise ScenarioError(
            f"{where}: the weights of {brief(objective)} are a {type(weights).__name__}; its "
            "method `weights` must return EdgeWeights"
        )
    return weights.weights(net)
