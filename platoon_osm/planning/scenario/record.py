"""What a scenario says, once it is read: the network, the trips, the costs, and how to plan."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import Any

from ...costs.objective import Objective
from ...costs.presets import DEFAULT_PRESET, PRESETS
from ...costs.weights import EdgeWeights
from ...errors import PlatoonError, ScenarioError, brief
from ...kinds import is_number
from ...network.access import STANDARD_ACCESS, Access
from ...network.road_network import RoadNetwork
from ...plans.plan import Plan
from ...plans.trip import Trip
from ...vehicles.profile import Vehicle, vehicle_of
from ..ends import located
from ..joint import plan_joint
from ..problem import Problem
from .delays_table import delays_of
from .keys import told

__all__ = ["ACCESS_LIMIT", "Scenario"]

ACCESS_LIMIT = "access_limit_km"


@dataclass(frozen=True, slots=True)
class Scenario:
    """What to plan on which network.

    Attributes
    ----------
    file : Path
        Where it was read; of a scenario that has no file of its own, its table of trips.
    title : str
        Heads its pages.
    network : mapping
        Keyword arguments of `load_network`.
    trips : tuple of Trip
        Who goes where, places as they are written.
    options : mapping
        Keyword arguments of `plan_joint`; and `access_limit_km`, beyond which places are refused.
    costs : mapping
        Parameters of the costs.
    preset : str
        Name of the costs in `PRESETS`.
    profiles : mapping of str to Vehicle
        Vehicles of its own, by the names that trips use.
    names_costs : bool
        Whether it says itself what its costs are.
    files : tuple of Path
        What it was read from, itself and its table of trips; no output may replace them.
    """

    file: Path
    title: str
    network: Mapping[str, Any]
    trips: tuple[Trip, ...]
    options: Mapping[str, Any] = field(default_factory=dict)
    costs: Mapping[str, Any] = field(default_factory=dict)
    preset: str = DEFAULT_PRESET
    files: tuple[Path, ...] = ()
    profiles: Mapping[str, Vehicle] = field(default_factory=dict)
    names_costs: bool = False

    def objective(self) -> Objective:
        """Return the costs the scenario asks for.

        Returns
        -------
        Objective
            Of the preset it names, with its parameters.

        Raises
        ------
        ScenarioError
            A parameter out of range, with the file.
        """
        with told(self.file):
            return PRESETS.find(self.preset).objective(self.costs)

    def weights(self, net: RoadNetwork) -> EdgeWeights:
        """Return the weights the scenario asks for.

        Parameters
        ----------
        net : RoadNetwork
            The network.

        Returns
        -------
        EdgeWeights
            Those of its objective.
        """
        return self.objective().weights(net)

    def access(self) -> Access:
        """Return how places beside the road get onto it.

        Returns
        -------
        Access
            The standard one, with the scenario's own limit if it names one.

        Raises
        ------
        ScenarioError
            A limit out of range, with the file.
        """
        if ACCESS_LIMIT not in self.options:
            return STANDARD_ACCESS
        limit = self.options[ACCESS_LIMIT]
        if not is_number(limit):
            raise ScenarioError(
                f"{self.file}: {ACCESS_LIMIT} is {brief(limit)}; give a number of kilometres"
            )
        with told(self.file, PlatoonError):
            return Access(limit_km=float(limit))

    def located(self, net: RoadNetwork) -> list[Trip]:
        """Return the trips with their places found on a network.

        Parameters
        ----------
        net : RoadNetwork
            The network.

        Returns
        -------
        list of Trip
            Places are locations.

        Raises
        ------
        ScenarioError
            A place that is not there, with the file.
        """
        with told(self.file, PlatoonError):
            return [
                replace(trip, origin=origin, destination=destination)
                for trip, (origin, destination) in zip(
                    self.trips,
                    located(net, self.trips, self.access(), self._rules().get("profile")),
                    strict=True,
                )
            ]

    def plan(self, net: RoadNetwork) -> Plan:
        """Plan the scenario on a network.

        Parameters
        ----------
        net : RoadNetwork
            The network.

        Returns
        -------
        Plan
            As `plan_joint` makes it.

        Raises
        ------
        PlatoonError
            Anything that cannot be planned.
        """
        trips, objective = self.located(net), self.objective()
        with told(self.file):
            return plan_joint(net, objective, trips, access=self.access(), **self._rules())

    def problem(self, net: RoadNetwork) -> Problem:
        """Return what is asked, for those who ask more of it than a plan.

        Parameters
        ----------
        net : RoadNetwork
            The network.

        Returns
        -------
        Problem
            That whose answer is `plan`.

        Raises
        ------
        PlatoonError
            Anything that cannot be asked.
        """
        trips = tuple(self.located(net))
        return Problem(net, trips, self.objective(), access=self.access(), **self._rules())

    def unplaced(self, net: RoadNetwork) -> Problem:
        """Return the same as `problem`, its places as they are written.

        Parameters
        ----------
        net : RoadNetwork
            The network.

        Returns
        -------
        Problem
            For those who find places themselves, and go on where some are not there.

        Raises
        ------
        PlatoonError
            Anything that cannot be asked.
        """
        return Problem(net, self.trips, self.objective(), access=self.access(), **self._rules())

    def check(self) -> None:
        """Check all that can be checked without the network: costs, options, who is named.

        Raises
        ------
        ScenarioError
            Anything that `plan` would refuse on any network, with the file.
        """
        with told(self.file, PlatoonError):
            # What is asked is checked where a problem is made; the least network there can be.
            road = RoadNetwork.from_edges([0], [1], lon=[0.0, 0.1], lat=[0.0, 0.0])
            Problem(road, self.trips, self.objective(), access=self.access(), **self._rules())

    def _rules(self) -> dict[str, Any]:
        """Return the options that a problem knows."""
        rules = {key: value for key, value in self.options.items() if key != ACCESS_LIMIT}
        if "profile" in rules:
            rules["profile"] = vehicle_of(rules["profile"], "profile", self.profiles)
        if "delays" in rules:
            rules["delays"] = delays_of(rules["delays"])
        return rules
