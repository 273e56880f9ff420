"""From a problem to a question: places become nodes, vehicles become weights, and trips ends."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from ..errors import PlatoonError
from ..network.road_network import RoadNetwork
from ..search.searches import Searches
from ..search.trees import Trees
from .ends import Ends, located, refused_trips, resolve_trips
from .fleet import Fleet
from .fleet_of import fleet_of
from .places import PlacedEnds, placed
from .problem import Problem
from .question import Question
from .quick_alone import by_quick_routes
from .road_closures import closed_roads

__all__ = ["Asked"]


@dataclass(frozen=True, slots=True, eq=False)
class Asked:
    """A problem with its places found.

    Attributes
    ----------
    question : Question
        What every way of answering starts from; its problem has the network with the places.
    locations : sequence of tuple of Location, (N, 2)
        What the trips' places were found to be.
    shut : ndarray of bool, (m,)
        Roads of the problem's own network that count as closed.
    """

    question: Question
    locations: Sequence[Ends]
    shut: NDArray[np.bool_]

    @classmethod
    def of(cls, problem: Problem) -> Asked:
        """Find the places of a problem.

        Parameters
        ----------
        problem : Problem
            What is asked.

        Returns
        -------
        Asked
            Ready to be answered.

        Raises
        ------
        PlatoonError
            A place that is not on the network, or a trip without any route.
        """
        return cls.at(problem, located(problem.net, problem.trips, problem.access, problem.profile))

    @classmethod
    def at(cls, problem: Problem, locations: Sequence[Ends]) -> Asked:
        """Return a problem whose places are found already.

        Parameters
        ----------
        problem : Problem
            What is asked.
        locations : sequence of tuple of Location, (N, 2)
            As `located` finds them.

        Returns
        -------
        Asked
            Ready to be answered.

        Raises
        ------
        PlatoonError
            A trip without any route, or that ends where it starts.
        """
        places, shut, fleet = _on_network(problem, locations)
        problem = replace(problem, net=places.net)
        trees = _trees(problem, fleet, places)
        ends = resolve_trips(places.net, fleet, trees, problem.trips, places.ends)
        question = Question(problem, fleet, tuple(ends), trees)
        if problem.method == "dijkstra":
            question = by_quick_routes(question)
        return cls(question, locations, shut)

    @staticmethod
    def refused(problem: Problem, locations: Sequence[Ends]) -> dict[int, PlatoonError]:
        """Return which trips `at` refuses, and why.

        Parameters
        ----------
        problem : Problem
            What is asked.
        locations : sequence of tuple of Location, (N, 2)
            As `located` finds them.

        Returns
        -------
        dict
            By position of the trip.
        """
        places, _, fleet = _on_network(problem, locations)
        problem = replace(problem, net=places.net)
        trees = _trees(problem, fleet, places)
        return refused_trips(places.net, fleet, trees, problem.trips, places.ends)

    @property
    def net(self) -> RoadNetwork:
        """The network with the places."""
        return self.question.net


def _on_network(
    problem: Problem, locations: Sequence[Ends]
) -> tuple[PlacedEnds, NDArray[np.bool_], Fleet]:
    """Return the places on the network, which roads count as closed, and the vehicles."""
    places = placed(problem.net, locations, problem.access)
    shut = closed_roads(problem.net, problem.close)
    return places, shut, fleet_of(problem, places, shut)


def _trees(problem: Problem, fleet: Fleet, places: PlacedEnds) -> list[Trees]:
    """Return the searches of each vehicle; those alike share theirs."""
    searches = problem.net.attached(Searches)
    made: list[Trees] = []
    for kind in fleet.kinds:
        # A search for each candidate of the fewer, then one from each end of each trip.
        ends = [places.ends[k] for k in kind]
        expected = sum(min(len(end.nodes) for end in both) + 2 for both in ends)
        made.append(Trees(searches.under(fleet.alone(kind[0]), expected, problem.engine)))
    return [made[kind] for kind in fleet.kind]
