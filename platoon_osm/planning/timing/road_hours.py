"""When the road under a vehicle is closed to it: driving bans, and hours on the map.

Times are seconds from one moment. If it has a zone, so have all: a ban by the clocks of Rome and
one by those of Zagreb are moments. If it has none, all countries are taken to go by the same
clocks.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from datetime import UTC, datetime, timedelta

from ...driving.bans.judging import banned
from ...driving.bans.rules import Road, bans_of
from ...network.road_network import RoadNetwork
from ...plans.records import Stretch
from ...vehicles.access import Way
from ...vehicles.closures import Closures
from ...vehicles.conditional_values import has_conditions
from ...vehicles.conditions import next_change
from ...vehicles.judgement import judge
from ...vehicles.profile import Vehicle
from .forbidden import Interval, Section, united
from .on_the_spot import LocalClock, country_of_edge, edge_times, local_clock, midpoint

__all__ = ["BESIDE", "RoadHours"]

BESIDE = Road("other", "")
"""What a way beside the road counts as."""

MOST_CHANGES = 500
"""Of one road's state that are looked at."""


class RoadHours:
    """Tells when edges are closed to vehicles between two moments.

    Parameters
    ----------
    net : RoadNetwork
        The network whose edges plans name.
    start : datetime
        What seconds count from.
    begin_s, end_s : float
        Between which moments closings are wanted [s].
    """

    def __init__(self, net: RoadNetwork, start: datetime, begin_s: float, end_s: float) -> None:
        self._net, self._start = net, start
        self.begin_s, self.end_s = begin_s, end_s
        self._bans: dict[tuple[str, Road, Vehicle], tuple[Interval, ...]] = {}
        self._hours: dict[tuple[int, str, Vehicle], tuple[Interval, ...]] = {}

    def country(self, edge: int) -> str:
        """Return the country of an edge.

        Parameters
        ----------
        edge : int
            Its position.

        Returns
        -------
        str
            Two letters; empty if it is not known.
        """
        return country_of_edge(self._net, edge)

    def on(self, edge: int, vehicle: Vehicle) -> tuple[Interval, ...]:
        """Return when an edge is closed to a vehicle.

        Parameters
        ----------
        edge : int
            Its position.
        vehicle : Vehicle
            Who drives.

        Returns
        -------
        tuple of Interval
            By bans, then by hours on the map; they may overlap.
        """
        country = self.country(edge)
        found = self._banned(country, Road.of_edge(self._net, edge), vehicle)
        if code := int(self._net.restriction[edge]):
            found += self._closed(code, edge, country, vehicle)
        return found

    def sections(
        self, stretch: Stretch, vehicles: Sequence[Vehicle], beside: int = -1
    ) -> tuple[Section, ...]:
        """Return the sections of a stretch and when they are closed to any of its vehicles.

        Parameters
        ----------
        stretch : Stretch
            Of a plan.
        vehicles : sequence of Vehicle
            Those that drive it.
        beside : int
            An edge near a way beside the road, for its country; -1 if there is none.

        Returns
        -------
        tuple of Section
            In driving order, each as long as its closings are the same; none where it is open
            always.
        """
        if not stretch.edges:
            return self._beside(stretch, vehicles, beside)
        found: list[Section] = []
        for edge, (begin, end) in zip(stretch.edges, edge_times(self._net, stretch), strict=True):
            closed = united(interval for vehicle in vehicles for interval in self.on(edge, vehicle))
            if found and found[-1].closed == closed and found[-1].end_s == begin:
                found[-1] = Section(found[-1].begin_s, end, closed)
            else:
                found.append(Section(begin, end, closed))
        return tuple(section for section in found if section.closed)

    def _beside(
        self, stretch: Stretch, vehicles: Sequence[Vehicle], edge: int
    ) -> tuple[Section, ...]:
        country = self.country(edge) if edge >= 0 else ""
        closed = united(
            interval for vehicle in vehicles for interval in self._banned(country, BESIDE, vehicle)
        )
        return (Section(0.0, stretch.drive_s, closed),) if closed else ()

    def _banned(self, country: str, road: Road, vehicle: Vehicle) -> tuple[Interval, ...]:
        key = (country, road, vehicle)
        if key not in self._bans:
            bans = bans_of(country)
            if bans is None:
                self._bans[key] = ()
                return ()
            first, last = (self._start + timedelta(seconds=at) for at in (self.begin_s, self.end_s))
            self._bans[key] = tuple(
                (self._seconds(ban.begin), self._seconds(ban.end))
                for ban in banned(country, vehicle, first, last, road)
            )
        return self._bans[key]

    def _closed(self, code: int, edge: int, country: str, vehicle: Vehicle) -> tuple[Interval, ...]:
        key = (code, country, vehicle)
        if key not in self._hours:
            self._hours[key] = tuple(self._walk(edge, country, vehicle))
        return self._hours[key]

    def _walk(self, edge: int, country: str, vehicle: Vehicle) -> Iterator[Interval]:
        """Yield when a road is closed that is open without regard to hours."""
        closures = self._net.attached(Closures)
        layers = closures.layers(edge)
        if not any(has_conditions(layer) for layer in layers):
            return
        if closures.on(edge, vehicle).way == Way.CLOSED:
            return  # closed whatever the hour, as far as the planner knows: nobody was sent there
        place = midpoint(self._net, edge)
        clock = local_clock(country, self._start)
        at, last = (
            clock(self._start + timedelta(seconds=one)) for one in (self.begin_s, self.end_s)
        )
        begins = None
        for _ in range(MOST_CHANGES):
            found = judge(layers, vehicle, at, place, country or None)
            if found.way == Way.CLOSED and begins is None:
                begins = at
            if found.way != Way.CLOSED and begins is not None:
                yield self._from_local(begins, clock), self._from_local(at, clock)
                begins = None
            later = [
                change
                for layer in layers
                if (change := next_change(layer, vehicle, at, place, country or None)) is not None
            ]
            if at >= last or not later:
                break
            at = min(later)
        if begins is not None:
            yield self._from_local(begins, clock), self.end_s

    def _seconds(self, at: datetime) -> float:
        if self._start.tzinfo is None:
            return (at.replace(tzinfo=None) - self._start).total_seconds()
        return (at.astimezone(UTC) - self._start.astimezone(UTC)).total_seconds()

    def _from_local(self, at: datetime, clock: LocalClock) -> float:
        return self._seconds(at if clock.zone is None else at.replace(tzinfo=clock.zone))
