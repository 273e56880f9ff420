"""Times that keep to driving bans and to the hours of roads: departures move, and vehicles stop.

A plan's times are first those of `schedule.py`. If somebody is then on a road while it is closed,
those who drive together with it get new times: by later or earlier departures alone, if nobody then
is late or breaks a closing; else by stops at junctions too. Windows that trips name are kept. A
patience is one for company and does not bound how long a vehicle stands because of the law. What
nobody can keep, the plan says.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from ...network.placed import network_below
from ...network.road_network import RoadNetwork
from ...plans.clock import Clock
from ...plans.plan import Plan
from ...plans.stretches import linked
from ...plans.timetable import LATE_S, Timetable, VehicleTimes
from ...plans.trip import Trip
from ...plans.zones import clock_of
from ...vehicles.profile import Vehicle
from .forbidden import Interval, Part, Section, forbidden_starts, latest_starts_along
from .hours_check import beside_edges, broken_hours
from .hours_remarks import breaking, kept
from .lawful import lawful_starts
from .limits import NOTHING_ASKED, Window, first_named, windows_of
from .on_the_spot import edge_times
from .parking_before import parking_before
from .pieces import pieces_of
from .road_hours import RoadHours
from .schedule import NEAR_S, settled
from .stops import cut_plan, stops_within
from .unjudged import without_times

__all__ = ["with_hours"]

AROUND_S = 10 * 86_400.0
"""How long before and after the times without closings others are looked for [s]."""

LONGEST_S = 100 * 86_400.0
"""Times of a group that lie farther apart are not moved [s]."""

Span = tuple[float, float]


def with_hours(
    plan: Plan,
    net: RoadNetwork,
    trips: Sequence[Trip],
    vehicles: Sequence[Vehicle],
    patience_s: float | None = None,
) -> Plan:
    """Return a plan whose times keep to driving bans and hours of roads, as far as they can.

    Parameters
    ----------
    plan : Plan
        With its times, if its trips name any.
    net : RoadNetwork
        The network it was made on, with or without places between junctions.
    trips : sequence of Trip, (N,)
        Those of the plan, in its order.
    vehicles : sequence of Vehicle, (N,)
        What drives each.
    patience_s : float, optional
        As in `schedule`.

    Returns
    -------
    Plan
        Remarks say who stops for what, and who breaks what. Without times, they say what is passed
        that depends on hours.
    """
    net = network_below(net)
    if plan.timetable is None:
        return replace(plan, remarks=(*plan.remarks, *without_times(plan, net, vehicles)))
    broken = broken_hours(plan, net, vehicles)
    if not broken:
        return plan
    found = _Times(plan, net, trips, vehicles, patience_s).moved({one.vehicle for one in broken})
    left = broken_hours(found, net, vehicles)

    def parking(index: int) -> str:
        return parking_before(found, net, index, vehicles[index])

    told = (*kept(plan, found, broken, left, parking), *breaking(found, left))
    return replace(found, remarks=(*found.remarks, *told))


@dataclass(frozen=True, slots=True)
class _Driven:
    """Some edges of a stretch that are driven without a stop."""

    stretch: int
    first: int
    vehicles: tuple[int, ...]
    drive_s: float
    sections: tuple[Section, ...]


class _Times:
    """Finds times for groups of vehicles, and the plan that has them."""

    def __init__(
        self,
        plan: Plan,
        net: RoadNetwork,
        trips: Sequence[Trip],
        vehicles: Sequence[Vehicle],
        patience_s: float | None,
    ) -> None:
        assert plan.timetable is not None
        self.plan, self.net, self.vehicles = plan, net, vehicles
        self.patience_s = patience_s or 0.0
        first = first_named(trips)
        assert first is not None
        self.first = first
        alone = [trip.alone.time_s for trip in plan.trips]
        self.asked, self.windows = windows_of(trips, alone, patience_s, first)
        self.shift = Clock.at(first).seconds(plan.timetable.clock.start)
        self.spans = [
            [(begin + self.shift, end + self.shift) for begin, end in times.legs]
            for times in plan.timetable.vehicles
        ]
        self.leaves = [times.departure_s + self.shift for times in plan.timetable.vehicles]
        self.between = 0.0, 0.0
        self.hours = RoadHours(net, first, *self.between)
        self.cuts: dict[int, set[int]] = {}
        self.found: dict[int, tuple[float, list[Span]]] = {}

    def moved(self, broken: set[int]) -> Plan:
        """Return the plan with other times for those who break a closing, and their company."""
        companies = [stretch.vehicles for stretch in self.plan.stretches]
        for group in linked(companies, len(self.plan.ways)):
            if broken.intersection(group):
                self._move(group)
        cuts = {k: [(place, 0.0) for place in sorted(own)] for k, own in self.cuts.items()}
        plan = cut_plan(self.net, replace(self.plan, timetable=None), cuts)
        return replace(plan, timetable=self._timetable(plan))

    def _move(self, group: tuple[int, ...]) -> None:
        """Choose times for a group: without stops if that will do."""
        ends = [at for index in group for span in self.spans[index] for at in span]
        if max(ends) - min(ends) > LONGEST_S:
            return  # it keeps its times, and is named for what it breaks
        self.between = min(ends) - AROUND_S, max(ends) + AROUND_S
        self.hours = RoadHours(self.net, self.first, *self.between)
        whole = self._driven(group, stops=False)
        starts, good = self._starts(group, whole, may_wait=False)
        driven = whole
        if not good:
            driven = self._driven(group, stops=True)
            starts, _ = self._starts(group, driven, may_wait=True)
        self._take(group, driven, starts)

    def _driven(self, group: Sequence[int], stops: bool) -> list[list[_Driven]]:
        """Return what each vehicle drives without a stop; shared pieces are one object."""
        known: dict[int, list[_Driven]] = {}
        ways = []
        for index in group:
            way = self.plan.ways[index]
            for k, near in zip(way, beside_edges(self.plan, way), strict=True):
                if k not in known:
                    known[k] = self._cut(k, near, stops)
            ways.append([piece for k in way for piece in known[k]])
        return ways

    def _cut(self, k: int, near: int, stops: bool) -> list[_Driven]:
        stretch = self.plan.stretches[k]
        drivers = [self.vehicles[index] for index in stretch.vehicles]
        sections = self.hours.sections(stretch, drivers, near)
        places = stops_within(self.net, stretch) if stops and sections else []
        if not places:
            return [_Driven(k, 0, stretch.vehicles, stretch.drive_s, sections)]
        times = edge_times(self.net, stretch)
        bounds = [0.0, *(times[place][0] for place in places), stretch.drive_s]
        return [
            _Driven(k, place, stretch.vehicles, end - begin, _within(sections, begin, end))
            for place, begin, end in zip([0, *places], bounds[:-1], bounds[1:], strict=True)
        ]

    def _starts(
        self, group: tuple[int, ...], ways: list[list[_Driven]], may_wait: bool
    ) -> tuple[dict[_Driven, Span], bool]:
        """Return when each piece is driven, and whether nobody is late or breaks a closing."""
        order = {piece: k for k, piece in enumerate(dict.fromkeys(p for way in ways for p in way))}
        place = {index: k for k, index in enumerate(group)}
        timed = [
            replace(piece, vehicles=tuple(place[index] for index in piece.vehicles))
            for piece in order
        ]
        pieces = pieces_of(
            timed,
            [[order[piece] for piece in way] for way in ways],
            range(len(timed)) if may_wait else (),
        )
        forbidden: list[tuple[Interval, ...]] = [()] * len(timed)
        for way, own in zip(ways, pieces.ways, strict=True):
            for piece, k in zip(way, own, strict=True):
                forbidden[k] = forbidden_starts(piece.sections)
        asked = [self.asked[index] for index in group]
        windows = [self._window(index, way) for index, way in zip(group, ways, strict=True)]
        starts = lawful_starts(pieces, windows, asked, forbidden, self.between)
        spans = settled(pieces, windows, np.asarray(starts))
        good = not any(
            begin + LATE_S < spans[k][0] < end - LATE_S
            for k, closed in enumerate(forbidden)
            for begin, end in closed
        ) and not any(
            window.arrival is not None and spans[own[-1]][1] > window.arrival + LATE_S
            for window, own in zip(windows, pieces.ways, strict=True)
        )
        found = {
            piece: spans[k]
            for way, own in zip(ways, pieces.ways, strict=True)
            for piece, k in zip(way, own, strict=True)
        }
        return found, good

    def _window(self, index: int, way: Sequence[_Driven]) -> Window:
        """Return within which limits a vehicle is moved: its own, and no patience."""
        asked, window = self.asked[index], self.windows[index]
        if asked == NOTHING_ASKED:
            return window
        earliest = window.earliest
        if asked.earliest is None and asked.arrival is not None and earliest is not None:
            parts = [Part(piece.drive_s, forbidden_starts(piece.sections)) for piece in way]
            earliest = min(earliest, latest_starts_along(parts, asked.arrival)[0] - self.patience_s)
        return Window(earliest, window.latest, None if asked.arrival is None else window.arrival)

    def _take(
        self, group: Sequence[int], ways: list[list[_Driven]], spans: dict[_Driven, Span]
    ) -> None:
        """Keep the times of a group; cut a stretch only where somebody stops on it."""
        for index, way in zip(group, ways, strict=True):
            legs: list[Span] = []
            for piece in way:
                begin, end = spans[piece]
                if piece.first and begin - legs[-1][1] <= LATE_S:
                    legs[-1] = (legs[-1][0], end)
                    continue
                if piece.first:
                    self.cuts.setdefault(piece.stretch, set()).add(piece.first)
                legs.append((begin, end))
            leaves = self.windows[index].leaves(legs[0][0])
            self.found[index] = leaves, legs

    def _timetable(self, plan: Plan) -> Timetable:
        old = self.plan.timetable
        assert old is not None
        times = [
            self.found.get(index, (self.leaves[index], self.spans[index]))
            for index in range(len(plan.ways))
        ]
        shift = math.floor(min(leaves for leaves, _ in times) + NEAR_S)
        vehicles = tuple(
            VehicleTimes(
                trip.vehicle,
                leaves - shift,
                tuple((begin - shift, end - shift) for begin, end in legs),
                asked.earliest, asked.latest, asked.arrival,
            )
            for trip, (leaves, legs), asked in zip(
                plan.trips, times, (one.moved(shift) for one in self.asked), strict=True
            )
        )  # fmt: skip
        shown = clock_of(self.first, shift, (at for one in vehicles for at in one.moments))
        in_time = not any(one.late_s for one in vehicles)
        return Timetable(
            shown.start.isoformat(), in_time, vehicles, shown.name, shown.offsets, old.patience_s
        )


def _within(sections: Sequence[Section], begin: float, end: float) -> tuple[Section, ...]:
    """Return the parts of sections that lie between two offsets, counted from the first."""
    return tuple(
        Section(max(one.begin_s, begin) - begin, min(one.end_s, end) - begin, one.closed)
        for one in sections
        if min(one.end_s, end) > max(one.begin_s, begin)
    )
