"""Which trips of a fleet can be planned at all: the others are listed, with the reason."""

from __future__ import annotations

from dataclasses import replace

from ..errors import NoRouteError, PlatoonError, ScenarioError
from ..planning.asked import Asked
from ..planning.ends import Ends, PlaceSearch
from ..planning.problem import Problem
from ..plans.fleet import Unserved

__all__ = ["served"]


def served(problem: Problem) -> tuple[Asked, tuple[Unserved, ...]]:
    """Find the places of a problem, and leave out the trips that have none or no route.

    Parameters
    ----------
    problem : Problem
        What is asked.

    Returns
    -------
    asked : Asked
        The problem of all trips with both places and a route; their places are locations.
    unserved : tuple of Unserved
        The others, in the order of their trips.

    Raises
    ------
    PlatoonError
        No trip is left, in which case the first one's reason is told; or what holds for all trips
        alike.
    """
    search = PlaceSearch(problem.net, problem.access, problem.profile)
    reasons: dict[int, PlatoonError] = {}
    found: dict[int, Ends] = {}
    for place, trip in enumerate(problem.trips):
        try:
            found[place] = search.of(trip)
        except PlatoonError as error:
            reasons[place] = error
    while True:
        if not found:
            raise next(iter(reasons.values()))
        trips = tuple(
            replace(problem.trips[place], origin=origin, destination=destination)
            for place, (origin, destination) in found.items()
        )
        kept = problem if len(trips) == len(problem.trips) else replace(problem, trips=trips)
        locations = list(found.values())
        try:
            return Asked.at(kept, locations), _listed(problem, reasons)
        except (NoRouteError, ScenarioError):
            places = list(found)
            refused = Asked.refused(kept, locations)
            if not refused:
                raise
            for index, refusal in refused.items():
                reasons[places[index]] = refusal
                del found[places[index]]


def _listed(problem: Problem, reasons: dict[int, PlatoonError]) -> tuple[Unserved, ...]:
    return tuple(
        Unserved(problem.trips[place].vehicle, _plain(problem.trips[place].vehicle, error))
        for place, error in sorted(reasons.items())
    )


def _plain(vehicle: str, error: PlatoonError) -> str:
    """Return a reason without the vehicle, which is told beside it."""
    said = str(error)
    for start in (f"trip {vehicle!r}: ", f"trip {vehicle!r}, "):
        said = said.removeprefix(start)
    return said
