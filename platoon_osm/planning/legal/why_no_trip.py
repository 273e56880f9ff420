"""In words: why a vehicle has no legal trip at all, and what would help.

Two things can be in the way. What its driver did before: a rest at the origin mends most of it, but
no rest that had to begin before the trip, and none where the state holds whenever it leaves. Or the
road: between two places to stop more has to be driven than is allowed at a stretch.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from ...driving.limits import Limits
from ...driving.state import DriverState
from ...network.road_network import RoadNetwork
from ...plans.clock import duration
from ..told_edge import road_of
from .driver.why_not import why_not
from .platoon.star_times import VehicleRules
from .way_points import WayPoints

__all__ = ["nothing_left", "why_no_trip"]

Edges = NDArray[np.int64]

REST_FIRST = "let it rest before, and give its state after that"
FROM_THEN = f"give an earliest departure, from which on it rests, or {REST_FIRST}"


class _Due(NamedTuple):
    """A rest that has to begin by now, and whether it had to before."""

    text: str
    lost: bool


def nothing_left(rules: VehicleRules) -> str:
    """Return why a driver may not drive at all, after what it has behind it.

    Parameters
    ----------
    rules : VehicleRules
        Its law and its state.

    Returns
    -------
    str
        What is too much, a semicolon, and what would help; empty if a rest at the origin, which
        begins when the state holds, or nothing is needed.
    """
    rests = list(_rests_behind(rules.state, rules.limits))
    lost = [one.text for one in rests if one.lost]
    if not lost and rules.state_at_s is None:
        driven = _driven_behind(rules.state, rules.limits)
        return _told([*(one.text for one in rests), *driven], FROM_THEN)
    return _told(lost, REST_FIRST)


def _told(facts: Sequence[str], remedy: str) -> str:
    return f"{', and '.join(facts)}; {remedy}" if facts else ""


def why_no_trip(
    net: RoadNetwork,
    edges: Edges,
    way: WayPoints,
    rules: VehicleRules,
    team: Limits | None,
    earliest_s: int | None,
    arrival_s: int | None,
    monday_s: int,
) -> str:
    """Return why a way cannot be driven within the law, though its driver may begin to.

    Whatever the latest departure is, and the latest arrival where an earliest departure is named.

    Parameters
    ----------
    net : RoadNetwork
        The network, with or without places between its junctions.
    edges : ndarray of int, (k,)
        The way.
    way : WayPoints
        The same as the law sees it.
    rules : VehicleRules
        The law for the vehicle, and what its driver has behind it.
    team : Limits or None
        The law for two drivers; None if the rules know none, or there are two already.
    earliest_s, arrival_s : int or None
        The earliest departure, and the latest arrival where there is none [s].
    monday_s : int
        A Monday 0:00 UTC [s].

    Returns
    -------
    str
        What is in the way, a semicolon, and what would help.
    """
    limits, state = rules.limits, rules.state
    found = why_not(
        way.road, limits, team, state, rules.state_at_s, earliest_s, None,
        None if earliest_s is not None else arrival_s, monday_s,
    )  # fmt: skip
    reached = way.road.hops if found is None else found.reached
    if found is not None and "rested" in found.remedies:
        where = _at(net, edges, way, reached)
        rest = FROM_THEN if rules.state_at_s is None else REST_FIRST
        return f"after what its driver did before, it comes no farther than {where}; {rest}"
    if stretch := _without_stop(net, edges, way, limits):
        return stretch
    where = _at(net, edges, way, reached)
    if found is not None and "second_driver" in found.remedies:
        return f"one driver comes no farther than {where}; give two drivers"
    return (
        f"it comes no farther than {where}, where it can neither drive on nor rest as long as it "
        "must; give a map with truck parkings there, or close a road before, for another way"
    )


def _rests_behind(state: DriverState, limits: Limits) -> Iterator[_Due]:
    """Yield which rests have to begin by now."""
    reduced = state.reduced_rests_used < limits.reduced_rests
    window_s = limits.long_window_s if reduced else limits.window_s
    if (duty_s := state.duty_s or 0.0) >= window_s:
        must = "the next has to begin within"
        if not limits.rest_in_window:
            must = "nothing may be driven after"
        yield _Due(
            f"the last daily rest of its driver ended {duration(duty_s)} before the trip, and "
            f"{must} {duration(window_s)}",
            duty_s > window_s and limits.rest_in_window,
        )
    if (weekly_s := state.since_weekly_rest_s) >= limits.weekly_after_s:
        yield _Due(
            f"the last weekly rest of its driver ended {duration(weekly_s)} before the trip, and "
            f"the next has to begin within {duration(limits.weekly_after_s)}",
            weekly_s > limits.weekly_after_s,
        )


def _driven_behind(state: DriverState, limits: Limits) -> Iterator[str]:
    """Yield of what its driver has driven all that is allowed, or more."""
    share = 2 if limits.change_s else 1
    long_day = state.long_days_used < limits.long_days
    day_s = (limits.long_day_s if long_day else limits.day_s) / share
    week, last = state.driven_this_week_s, state.driven_last_week_s
    for driven_s, most_s, since in (
        (state.driven_since_break_s, limits.spell_s, "since its last break"),
        (state.driven_today_s, day_s, "since its last daily rest"),
        (week, limits.week_s / share, "this week"),
        (week + last, limits.fortnight_s / share, "this week and last"),
    ):
        if driven_s >= most_s:
            yield f"its driver has driven {duration(driven_s)} {since}, {duration(most_s)} allowed"


def _without_stop(net: RoadNetwork, edges: Edges, way: WayPoints, limits: Limits) -> str:
    """Return the first stretch that is too long to be driven without a stop; empty if none is."""
    road, share = way.road, 2 if limits.change_s else 1
    least_s = min([limits.break_s, *(limits.parts_s or ())])
    stops = [k for k in range(1, road.hops) if road.stay_s[k] >= max(least_s, 1)]
    at_most = (
        (limits.spell_s, "without a break"),
        (limits.long_day_s / share, "between two daily rests"),
    )
    for begin, end in zip([0, *stops], [*stops, road.hops], strict=True):
        lasts_s = float(road.clock_s[begin:end].sum())
        for most_s, what in at_most:
            if lasts_s > most_s:
                first = min(way.points[begin].at, len(edges) - 1)
                return (
                    f"{road_of(net, int(edges[first]))} from {_at(net, edges, way, begin)} to "
                    f"{_at(net, edges, way, end)} takes {duration(lasts_s)} with no place to stop, "
                    f"and {duration(most_s)} may be driven {what}; give a map with a truck parking "
                    "there, or close that road, for another way"
                )
    return ""


def _at(net: RoadNetwork, edges: Edges, way: WayPoints, point: int) -> str:
    """Return where a point is, by name, and by how far on the way it lies."""
    one = way.points[point]
    if one.place is not None and one.place.name:
        name = one.place.name
    elif one.at < len(edges):
        name = net.place_name(int(net.tail[edges[one.at]]))
    else:
        name = net.place_name(int(net.head[edges[-1]]))
    driven_m = float(net.length_m[edges[: one.at]].sum())
    if one.share:
        driven_m += one.share * float(net.length_m[edges[one.at]])
    return f"{name} (its km {driven_m / 1000:.0f})"
