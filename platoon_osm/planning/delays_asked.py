"""What is asked about delays, checked once: those of the problem, and spreads that trips name."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from ..chance.delays import Delays, factor
from ..errors import ScenarioError, brief
from ..kinds import kind_of
from ..plans.trip import Trip

__all__ = ["checked_delays"]


def checked_delays(
    delays: object, robust: object, trips: Sequence[Trip], is_exact: bool
) -> Delays | None:
    """Return the delays of a problem.

    Parameters
    ----------
    delays : object
        As they were given.
    robust : object
        Whether they count in the choice, as it was given.
    trips : sequence of Trip
        Who goes where; a spread that one names is its vehicle's.
    is_exact : bool
        Whether the plan is made by Dijkstra's method.

    Returns
    -------
    Delays or None
        None if nothing is asked about delays.

    Raises
    ------
    ScenarioError
        Values of another kind, correlations that cannot be, or a choice that cannot be made.
    """
    if not isinstance(robust, bool):
        raise ScenarioError(f"robust is {brief(robust)}; give True or False")
    if delays is None:
        if robust:
            raise ScenarioError("robust weighs delays; give delays too, as Delays(spread_min)")
        named = [trip.vehicle for trip in trips if trip.delay_spread_min is not None]
        if named:
            raise ScenarioError(
                f"trip {named[0]!r} names delay_spread_min, but nothing is said of the others; "
                "give delays too, with spread_min"
            )
        return None
    if not isinstance(delays, Delays):
        raise ScenarioError(f"delays is a {kind_of(delays)}; make it Delays(spread_min)")
    own = {one.vehicle: one.delay_spread_min for one in trips if one.delay_spread_min is not None}
    if own:
        delays = replace(delays, own={**delays.own, **own})
    if delays.correlation or delays.pairs:
        factor(delays.correlations([trip.vehicle for trip in trips]))
    if robust and not any(trip.times for trip in trips):
        raise ScenarioError("robust needs a clock; give at least one trip an earliest_departure")
    if robust and not is_exact:
        raise ScenarioError(
            "robust compares plans by method dijkstra; leave out robust and the chances of the "
            "merges are told all the same"
        )
    return delays
