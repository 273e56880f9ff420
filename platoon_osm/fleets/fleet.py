"""Plan a whole fleet, and tell how much more could be saved at most."""

from __future__ import annotations

import os
from collections.abc import Callable, Sequence

from ..costs.time_prices import TimePrices
from ..errors import ScenarioError, brief
from ..interrupts import asked_to_end
from ..planning.problem import Problem
from ..plans.fleet import Unserved
from ..plans.plan import Plan
from .lawful_run import LawfulRun
from .limits import Limits
from .model import FleetModel, modelled
from .one_a_trip_run import OneATripRun
from .progress import Progress
from .run import FleetRun
from .stopping import Course
from .warmth import warm_up
from .worthwhile_run import WorthwhileRun

__all__ = ["plan_fleet"]

MANY = 50
"""Fewer trips are planned before the first kernel would be compiled."""


def plan_fleet(
    problem: Problem,
    limits: Limits | None = None,
    *,
    write_to: str | os.PathLike[str] | None = None,
    on_progress: Callable[[Progress], None] | None = None,
    unserved: Sequence[Unserved] = (),
) -> Plan:
    """Plan who drives with whom in a whole fleet, and tell how much more could be saved at most.

    Ctrl-C ends the search, and the best plan so far is returned.

    Parameters
    ----------
    problem : Problem
        The trips, each with at least one time; its case and its master play no part, for a fleet
        has none. Its `max_platoon` is the largest platoon.
    limits : Limits, optional
        How long to search, on which routes, and who may drive with whom.
    write_to : str or path, optional
        A file for the plan with its certificate, as `platoon-osm certify` reads it; what is best so
        far is written as the search goes on, so that it is there if the process is killed.
    on_progress : callable, optional
        Told how far it is after each round.
    unserved : sequence of Unserved, optional
        Trips that are known to be none, as rows of a table that could not be read; they are listed
        before those that are found to be.

    Returns
    -------
    Plan
        Its `fleet` tells saving, bound, gap and conditions, and trips that could not be planned.

    Raises
    ------
    PlatoonError
        A question that fleets are not planned for, in one line; or no trip that can be planned.
    """
    if not isinstance(problem, Problem):
        raise ScenarioError(
            f"fleet: {brief(problem)} is no Problem; make one from a network and trips"
        )
    own = Limits() if limits is None else limits
    if not isinstance(own, Limits):
        raise ScenarioError(f"fleet: limits are {brief(limits)}; give Limits(...)")
    if own.time_s is None and own.rounds is None:
        raise ScenarioError("fleet: limits name neither time_s nor rounds; give one of them")
    if own.time_s is not None and len(problem.trips) >= MANY:
        # Compiling takes seconds once, which are not those that were given to the search.
        law = problem.limits_driving
        waits = not law and TimePrices.of(problem.objective).waiting > 0
        warm_up(law=law, waits=waits)
    with asked_to_end() as ends:
        course = Course(own, ends)
        model = modelled(problem, own, unserved)
        return _kind(model, own)(model, own, course, write_to, on_progress).plan()


def _kind(model: FleetModel, limits: Limits) -> type[FleetRun]:
    """Return the kind of search that a question takes."""
    if model.legal is not None:
        return LawfulRun
    if limits.per_trip == "one":
        return OneATripRun
    return WorthwhileRun if limits.min_gain else FleetRun
