"""A question with its law: each vehicle's way alone in whole seconds, its trip alone, its window.

How far company may move a vehicle follows the rule of `timing.limits`, with the duration of the
legal trip alone, breaks and rests included, in place of the driving time.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from copy import copy
from dataclasses import dataclass, replace
from datetime import UTC, datetime, timedelta
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from ...driving.rules import limits_of, team_of
from ...errors import NoLegalTripError, ScenarioError
from ...network.placed import PlacedNetwork, network_below
from ...plans.clock import Clock
from ...plans.timetable import LATE_S
from ...vehicles.profile import Vehicle
from ..question import Question, QuickRoute
from ..quick_alone import quicker_ways
from ..timing.forbidden import Interval
from ..timing.limits import Window, first_named, windows_of
from ..timing.road_hours import RoadHours
from .driver.one_driver import fastest
from .driver.road import LegalTrip
from .driver.trip_question import TripQuestion
from .platoon.star_times import OPEN_S, Span, VehicleRules
from .way_points import WayPoints, way_points
from .why_no_trip import nothing_left, why_no_trip

__all__ = ["LegalQuestion", "TripAlone"]

Edges = NDArray[np.int64]

MOST_WAYS = 24
"""Of more ways that are quicker than the usual one every second, third and so on is looked at, the
quickest among them."""

DAY_S = 86_400.0

AROUND_S = 10 * DAY_S
"""How long before the first and after the last moment that trips name closings are looked for."""


@dataclass(frozen=True, slots=True, eq=False)
class TripAlone:
    """A vehicle's legal trip alone.

    Attributes
    ----------
    way : WayPoints
        Its way.
    trip : LegalTrip
        Its times.
    after_latest_s : int
        How long after its latest departure it leaves, for it must rest or be let through first [s];
        0 where it keeps it.
    """

    way: WayPoints
    trip: LegalTrip
    after_latest_s: int = 0


class LegalQuestion:
    """What is known of a question under driving rules before anybody joins anybody.

    Parameters
    ----------
    question : Question
        What is asked.
    vehicles : sequence of Vehicle, (N,)
        What drives each trip.
    refused : dict of int to NoLegalTripError, optional
        Where it is given, vehicles without any legal trip are put into it by their positions, with
        the reason; a question that has some is of no other use.

    Attributes
    ----------
    first : datetime
        The first time that trips name; all seconds count from it.
    monday_s : int
        A Monday, 0:00 UTC, at or before it [s]; times without a zone are taken to be in UTC.
    rules : tuple of VehicleRules, (N,)
        The law for each vehicle.
    alone : tuple of TripAlone, (N,)
        The legal trip of each vehicle alone; the question's routes alone are theirs.

    Raises
    ------
    ScenarioError
        No trip names a time.
    NoLegalTripError
        A vehicle has no legal trip at all.
    """

    def __init__(
        self,
        question: Question,
        vehicles: Sequence[Vehicle],
        refused: dict[int, NoLegalTripError] | None = None,
    ) -> None:
        self.question, self.vehicles = question, tuple(vehicles)
        problem = question.problem
        first = first_named(problem.trips)
        if first is None:
            raise ScenarioError(
                f"driving rules {problem.rules.name!r} need a clock; give at least one trip an "
                "earliest_departure"
            )
        self.first = first
        self.monday_s = _monday_s(first)
        clock = Clock.at(first)
        named = [{name: clock.seconds(at) for name, at in trip.times.items()}
                 for trip in problem.trips]  # fmt: skip
        # Earliest and latest moments are rounded inward, so that whole seconds keep them.
        self._asked = [
            Window(_up(one.get("earliest_departure")), _down(one.get("latest_departure")),
                   _down(one.get("latest_arrival")))
            for one in named
        ]  # fmt: skip
        self.rules = tuple(
            VehicleRules(
                limits_of(problem.rules, trip.driver.drivers), trip.driver,
                None if asked.earliest is None else int(asked.earliest),
            )
            for trip, asked in zip(problem.trips, self._asked, strict=True)
        )  # fmt: skip
        # Vehicles that are alike are told by the first of them.
        self._alike = tuple(self.vehicles.index(one) for one in self.vehicles)
        self._closed: dict[tuple[int, int], Sequence[Interval]] = {}
        self._open: dict[tuple[int, int], bool] = {}
        self._ways: dict[tuple[int, int, int, int], tuple[Edges, WayPoints]] = {}
        moments = [at for one in named for at in one.values()]
        self._about = min(moments) - DAY_S, max(moments) + 2 * DAY_S
        self._hours = RoadHours(
            network_below(question.net), first, min(moments) - AROUND_S, max(moments) + AROUND_S
        )
        quick: dict[int, QuickRoute] = {}
        found: list[TripAlone] = []
        for index in range(len(self.vehicles)):
            try:
                found.append(self._alone(index, quick))
            except NoLegalTripError as error:
                if refused is None:
                    raise
                refused[index] = error
        self.alone = tuple(found)
        self.question = question.by_quick_routes(quick)

    def closed(self, index: int, edge: int) -> Sequence[Interval]:
        """Return when an edge is closed to a vehicle.

        Parameters
        ----------
        index : int
            The vehicle's position.
        edge : int
            An edge of the network with places.

        Returns
        -------
        sequence of Interval
            Seconds; by driving bans and by the hours of roads.
        """
        key = self._alike[index], edge
        found = self._closed.get(key)
        if found is None:
            net = self.question.net
            own = int(net.below_edge[edge]) if isinstance(net, PlacedNetwork) else edge
            found = self._hours.on(own, self.vehicles[index]) if own >= 0 else ()
            self._closed[key] = found
        return found

    def way(
        self,
        index: int,
        edges: Edges,
        company: Sequence[int] = (),
        keep: Sequence[int] = (),
        near_s: float | None = None,
    ) -> WayPoints:
        """Return the points of a way of a vehicle.

        Parameters
        ----------
        index : int
            The vehicle's position.
        edges : ndarray of int, (k,)
            The way, on the network with places.
        company : sequence of int
            Vehicles that may drive it together; it is driven as the slowest does. By default the
            vehicle alone.
        keep : sequence of int
            Positions of edges whose beginning is a point in any case.
        near_s : float, optional
            As in `way_points`.

        Returns
        -------
        WayPoints
            In whole seconds.
        """
        drive_s = self.question.fleet.drive_s(company or (index,))[edges]
        known = {} if near_s is None else {"near_s": near_s}
        return way_points(
            self.question.net, edges, drive_s, self.vehicles[index], keep,
            lambda edge: self.closed(index, edge), **known,
        )  # fmt: skip

    def cheapest_way(self, index: int, start: int, end: int) -> tuple[Edges, WayPoints]:
        """Return the cheapest way of a vehicle alone between two nodes, worked out once.

        Parameters
        ----------
        index : int
            The vehicle's position.
        start, end : int
            Nodes of the network with places.

        Returns
        -------
        edges : ndarray of int
            In driving order; none from a node to itself.
        way : WayPoints
            Its points.
        """
        # Vehicles that are alike drive alike, whoever leads.
        key = self._alike[index], int(self.question.fleet.kind[index]), start, end
        if key not in self._ways:
            edges = self.question.routers[index].route(start, end)
            self._ways[key] = edges, self.way(index, edges)
        return self._ways[key]

    def _alone(self, index: int, quick: dict[int, QuickRoute]) -> TripAlone:
        """Return the trip by the cheapest route that is in time, or by the one least late."""
        usual = best = self._by(index, self.question.alone[index])
        late_s = self._late_s(index, usual)
        if late_s <= 0:
            return usual
        route = None
        ways = quicker_ways(self.question, index)[::-1]
        for edges in ways[:: -(-len(ways) // MOST_WAYS) or 1][::-1]:
            found = self._by(index, edges)
            if self._late_s(index, found) < self._late_s(index, best):
                best, route = found, edges
                if self._late_s(index, best) <= 0:
                    break
        if route is not None:
            quick[index] = QuickRoute(route, late_s)
        return best

    def _late_s(self, index: int, own: TripAlone) -> float:
        """Return how late a trip arrives, or leaves; the later of both [s]."""
        arrival = self._asked[index].arrival
        late = 0.0 if arrival is None else own.trip.arrival_s - arrival
        return max(late, float(own.after_latest_s))

    @property
    def late_s(self) -> list[float]:
        """How late each is alone, at its arrival or its departure [s]; 0 or less if not, (N,)."""
        return [self._late_s(index, own) for index, own in enumerate(self.alone)]

    def _by(self, index: int, edges: Edges) -> TripAlone:
        if len(edges) and (why := nothing_left(self.rules[index])):
            raise self._no_trip(index, why)
        for near_s in (None, 0.0):
            way = self.way(index, edges, near_s=near_s)
            for keeps_latest in (True, False):
                trip = self._fastest(index, way, keeps_latest)
                if trip is not None:
                    latest = self._asked[index].latest
                    late = 0 if keeps_latest or latest is None else trip.departure_s - int(latest)
                    return TripAlone(way, trip, max(late, 0))
        raise self._no_trip(index, self._why_none(index, edges, way))

    def _no_trip(self, index: int, why: str) -> NoLegalTripError:
        name, law = self.question.ends[index].vehicle, self.question.problem.rules.name
        return NoLegalTripError(f"{name}: no trip keeps the driving rules {law!r}: {why}")

    def _why_none(self, index: int, edges: Edges, way: WayPoints) -> str:
        """Return why a vehicle has no legal trip on a way."""
        question, asked, rules = self.question, self._asked[index], self.rules[index]
        earliest, arrival = (
            None if at is None else int(at) for at in (asked.earliest, asked.arrival)
        )
        if earliest is None and arrival is None:
            earliest = 0 if asked.latest is None else int(asked.latest)
        return why_no_trip(
            question.net, edges, way, rules, team_of(question.problem.rules, rules.state),
            earliest, arrival, self.monday_s,
        )  # fmt: skip

    def _fastest(self, index: int, way: WayPoints, keeps_latest: bool) -> LegalTrip | None:
        asked, rules = self._asked[index], self.rules[index]
        latest = None if asked.latest is None or not keeps_latest else int(asked.latest)

        def found(
            earliest: int | None, last: int | None, arrival: int | None = None, leave: bool = False
        ) -> LegalTrip | None:
            asked = TripQuestion(
                way.road, rules.limits, rules.state, rules.state_at_s, earliest, last, arrival,
                self.monday_s,
            )  # fmt: skip
            return fastest(asked, "leave" if leave else "arrive")

        if asked.earliest is not None:
            return found(int(asked.earliest), latest)
        if asked.arrival is not None:
            return found(None, latest, int(asked.arrival), leave=True)
        begin = 0 if asked.latest is None else int(asked.latest)
        return found(begin, begin if keeps_latest else None)

    @cached_property
    def duration_s(self) -> list[float]:
        """How long each takes alone from its earliest departure until it is there [s], (N,)."""
        found = []
        for asked, own in zip(self._asked, self.alone, strict=True):
            begin = own.trip.departure_s if asked.earliest is None else asked.earliest
            found.append(float(own.trip.arrival_s - begin))
        return found

    @cached_property
    def _windows(self) -> tuple[list[Window], list[Window]]:
        problem = self.question.problem
        patience_s = problem.patience_min * 60.0
        return windows_of(problem.trips, self.duration_s, patience_s, self.first)

    @property
    def asked(self) -> list[Window]:
        """What trips name, (N,)."""
        return self._windows[0]

    @property
    def windows(self) -> list[Window]:
        """How far company may move each vehicle, not rounded, (N,)."""
        return self._windows[1]

    @cached_property
    def spans(self) -> tuple[Span, ...]:
        """How far company may move each vehicle, in whole seconds, (N,)."""
        found = []
        for window, own in zip(self._windows[1], self.alone, strict=True):
            span = Span(
                -OPEN_S if window.earliest is None else int(_up(window.earliest) or 0),
                OPEN_S if window.latest is None else int(_down(window.latest) or 0),
                OPEN_S if window.arrival is None else int(_down(window.arrival) or 0),
            )
            if own.after_latest_s:
                span = replace(span, latest_s=max(span.latest_s, own.trip.departure_s))
            found.append(span)
        return tuple(found)

    def delayed(self, delay_s: float) -> LegalQuestion:
        """Return the same question with a delay that all allow instead of their windows.

        Parameters
        ----------
        delay_s : float
            How much later than alone each vehicle may arrive [s].

        Returns
        -------
        LegalQuestion
            Who names no earliest departure may leave so much earlier than alone, and arrive when it
            would alone; who names no time goes along with anybody.
        """
        late = math.floor(delay_s)

        def span(asked: Window, trip: LegalTrip) -> Span:
            if asked.earliest is not None:
                return Span(int(asked.earliest), OPEN_S, trip.arrival_s + late)
            if asked.latest is None and asked.arrival is None:
                return Span()
            return Span(trip.departure_s - late, OPEN_S, trip.arrival_s)

        return self._with_spans(
            span(asked, own.trip) for asked, own in zip(self._asked, self.alone, strict=True)
        )

    def hurried(self, delay_s: float) -> LegalQuestion:
        """Return the same question with a limit of delay besides the windows.

        Parameters
        ----------
        delay_s : float
            How much later than alone each vehicle that names an earliest departure may arrive [s].

        Returns
        -------
        LegalQuestion
            No vehicle may do what it could not before.
        """
        late = math.floor(delay_s)
        return self._with_spans(
            span
            if asked.earliest is None
            else replace(span, arrival_s=min(span.arrival_s, own.trip.arrival_s + late))
            for span, asked, own in zip(self.spans, self._asked, self.alone, strict=True)
        )

    def _with_spans(self, spans: Iterable[Span]) -> LegalQuestion:
        """Return the same question with other spans; what was worked out from them is forgotten."""
        found = copy(self)
        found.__dict__.pop("has_closings", None)
        found._open = {}
        found.__dict__["spans"] = tuple(spans)
        return found

    @cached_property
    def has_closings(self) -> bool:
        """Whether a road of somebody's way is closed at some hour that matters."""
        return any(self._matters(own.way.road.forbidden_s.tolist()) for own in self.alone)

    def is_open(self, index: int, edge: int) -> bool:
        """Tell whether an edge is never closed to a vehicle at an hour that matters.

        Parameters
        ----------
        index : int
            The vehicle's position.
        edge : int
            An edge of the network with places.

        Returns
        -------
        bool
            Whether nobody has to wait for it.
        """
        key = self._alike[index], edge
        if key not in self._open:
            self._open[key] = not self._matters(self.closed(index, edge))
        return self._open[key]

    def _matters(self, closed: Iterable[Sequence[float]]) -> bool:
        """Tell whether any of some intervals lies where vehicles may drive."""
        spans = self.spans
        low, high = self._about
        begin = min(low if one.earliest_s == -OPEN_S else one.earliest_s for one in spans)
        end = max(high if one.arrival_s == OPEN_S else one.arrival_s for one in spans)
        return any(first < end and last > begin for first, last in closed)


def _up(at: float | None) -> float | None:
    return None if at is None else float(math.ceil(at - LATE_S))


def _down(at: float | None) -> float | None:
    return None if at is None else float(math.floor(at + LATE_S))


def _monday_s(first: datetime) -> int:
    """Return the last Monday, 0:00 UTC, before a moment, in seconds from it."""
    moment = first.replace(tzinfo=UTC) if first.tzinfo is None else first.astimezone(UTC)
    day = moment.replace(hour=0, minute=0, second=0, microsecond=0)
    monday = day - timedelta(days=day.weekday())
    return math.floor((monday - moment).total_seconds())
