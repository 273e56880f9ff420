"""What must hold in a plan before anybody relies on it, whoever made it."""

from __future__ import annotations

from collections.abc import Sequence
from graphlib import CycleError, TopologicalSorter

from ..errors import ScenarioError, brief
from ..kinds import is_whole
from .needed import all_finite, need
from .records import Event, Line, PlannedTrip, Platoon, PlatoonPoint, Span, Stop, Stretch
from .timetable import Timetable

__all__ = ["check_parts", "check_times"]


def check_parts(
    trips: Sequence[PlannedTrip],
    stretches: Sequence[Stretch],
    ways: Sequence[Sequence[int]],
    platoons: Sequence[Platoon],
    events: Sequence[Event],
    timetable: Timetable | None,
) -> None:
    """Check that the parts of a plan fit each other; nothing is asked of its network.

    Parameters
    ----------
    trips, stretches, ways, platoons, events : sequence
        Fields of `Plan`.
    timetable : Timetable or None
        Its times.

    Raises
    ------
    ScenarioError
        In one line: what does not fit.
    """
    count = len(trips)
    need(len(ways) == count, f"{count} trips have {len(ways)} ways")
    for trip in trips:
        alone = trip.alone
        where = f"trip {trip.vehicle!r}"
        _finite(where, alone.length_m, alone.time_s, alone.fuel_l, alone.cost)
        need(len(alone.access) == 2, f"{where} has not one way to the road and one from it")
        need(all_finite((*alone.terms, alone.paused_s)), f"{where} has a term that is not finite")
        need(bool(alone.edges or any(alone.access)), f"{where} drives nothing alone")
        _check_span(alone.edges, alone.span, where)
        for line in alone.access:
            _check_line(line, where)
        _check_place(trip.origin, where)
        _check_place(trip.destination, where)
    for number, stretch in enumerate(stretches):
        _check_stretch(stretch, count, f"stretch {number}")
    _check_ways(trips, stretches, ways)
    for number, platoon in enumerate(platoons):
        where = f"platoon {number}"
        _positions(platoon.vehicles, count, where)
        need(
            platoon.master is None or platoon.master in platoon.vehicles,
            f"{where} has a master that is not in it",
        )
    for number, event in enumerate(events):
        where = f"event {number}"
        _positions((*event.movers, *event.others), count, where)
        need(event.kind in ("merge", "separation"), f"{where} is a {brief(event.kind)}")
        need(len(event.movers) > 0, f"{where} moves nobody")
        need(0 <= event.stretch < len(stretches), f"{where} is at no stretch")
        _check_place(event.point, where)
    if timetable:
        check_times(trips, ways, timetable)


def check_times(
    trips: Sequence[PlannedTrip], ways: Sequence[Sequence[int]], timetable: Timetable
) -> None:
    """Check that a timetable is one of a plan's vehicles and ways.

    Parameters
    ----------
    trips, ways : sequence
        Fields of `Plan`.
    timetable : Timetable
        The times.

    Raises
    ------
    ScenarioError
        It is that of others.
    """
    own = [(trip.vehicle, len(way)) for trip, way in zip(trips, ways, strict=True)]
    if own != [(times.vehicle, len(times.legs)) for times in timetable.vehicles]:
        raise ScenarioError("plan: its timetable is that of other vehicles; plan again")


def _check_stretch(stretch: Stretch, count: int, where: str) -> None:
    if stretch.access is None:
        need(len(stretch.edges) > 0, f"{where} has no edges")
    else:
        # One edge, where the plan is laid out on a network that has the way.
        need(len(stretch.edges) < 2, f"{where} is a way beside the road, but has edges")
        need(len(stretch.vehicles) == 1, f"{where} is a way beside the road, driven together")
        _check_line(stretch.access, where)
    _check_span(stretch.edges, stretch.span, where)
    need(len(stretch.vehicles) > 0, f"{where} has no vehicles")
    _positions(stretch.vehicles, count, where)
    need(len(stretch.shares) == len(stretch.vehicles), f"{where} has not one share a vehicle")
    _finite(where, stretch.length_m, stretch.drive_s, stretch.inferred_m)
    for share in stretch.shares:
        told = (value for value in (share.alone_cost, share.money) if value is not None)
        _finite(where, share.cost, share.fuel_l, share.alone_fuel_l, *told)
        _finite(where, *share.terms, *share.alone_terms)


def _check_span(edges: Sequence[int], span: Span, where: str) -> None:
    need(len(span) == 2 and all_finite(span), f"{where} has a span that is none")
    begin, end = span
    need(0 <= begin < 1 and 0 < end <= 1, f"{where} begins or ends beside its edges")
    need(len(edges) != 1 or begin < end, f"{where} ends before it begins")


def _check_line(line: Line | None, where: str) -> None:
    if line is not None:
        fits = all(
            len(point) == 2 and all_finite(point) and abs(point[0]) <= 180 and abs(point[1]) <= 90
            for point in line
        )
        need(len(line) == 2 and fits, f"{where} has a way to the road that is no line")


def _check_place(place: Stop | PlatoonPoint, where: str) -> None:
    need((place.edge is None) == (place.share is None), f"{where} has half a place on an edge")
    if place.edge is not None and place.share is not None:
        fits = is_whole(place.edge) and place.edge >= 0 and all_finite([place.share])
        need(fits and 0 <= place.share <= 1, f"{where} has a place on an edge that is none")


def _check_ways(
    trips: Sequence[PlannedTrip], stretches: Sequence[Stretch], ways: Sequence[Sequence[int]]
) -> None:
    driven: list[set[int]] = [set() for _ in stretches]
    before: dict[int, set[int]] = {}
    for index, way in enumerate(ways):
        name = trips[index].vehicle
        need(len(way) > 0, f"{name!r} drives nothing")
        for place, stretch in enumerate(way):
            need(
                isinstance(stretch, int) and 0 <= stretch < len(stretches),
                f"{name!r} drives no such stretch",
            )
            driven[stretch].add(index)
            before.setdefault(stretch, set()).update(way[place - 1 : place] if place else ())
    for number, own in enumerate(stretches):
        need(
            driven[number] == set(own.vehicles),
            f"stretch {number} is not driven by the vehicles it names",
        )
    try:
        tuple(TopologicalSorter(before).static_order())
    except CycleError:
        raise ScenarioError(
            "plan: its stretches wait for each other in a circle; plan again"
        ) from None


def _positions(vehicles: tuple[int, ...], count: int, where: str) -> None:
    need(
        all(isinstance(one, int) and 0 <= one < count for one in vehicles)
        and len(set(vehicles)) == len(vehicles),
        f"{where} names vehicles that are not in the plan",
    )


def _finite(where: str, *values: float) -> None:
    need(all_finite(values), f"{where} has a number that is not finite")
