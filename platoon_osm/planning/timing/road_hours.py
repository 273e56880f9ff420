"""When the road under a vehicle is closed to it: driving bans, and hours on the map.

Times are seconds from one moment. If it has a zone, so have all: a ban by the clocks of Rome and
one by those of Zagreb are moments. If it has none, all countries are taken to go by the same
clocks.
Within a stretch the time to drive it is shared among its edges as for a lone truck.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from datetime import UTC, datetime, timedelta
from itertools import pairwise
from zoneinfo import ZoneInfo

import numpy as np

from ...driving.bans.judging import banned
from ...driving.bans.rules import Road, bans_of
from ...network.road_network import RoadNetwork
from ...plans.records import Stretch
from ...vehicles.access import Way
from ...vehicles.closures import Closures
from ...vehicles.conditions import has_conditions, next_change
from ...vehicles.judgement import judge
from ...vehicles.profile import Vehicle
from .forbidden import Interval, Section, united

__all__ = [
    "BESIDE", "LocalClock", "RoadHours", "country_of_edge", "edge_times", "local_clock",
    "midpoint",
]  # fmt: skip

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


@dataclass(frozen=True, slots=True)
class LocalClock:
    """What clocks on the spot show.

    Attributes
    ----------
    zone : tzinfo or None
        None if all moments are without one.
    """

    zone: ZoneInfo | None

    def __call__(self, at: datetime) -> datetime:
        """Return what they show at a moment, without a zone."""
        return (at if self.zone is None else at.astimezone(self.zone)).replace(tzinfo=None)


def local_clock(country: str, start: datetime) -> LocalClock:
    """Return the clocks of a country.

    Parameters
    ----------
    country : str
        Two letters; of one that is not known, clocks go as those of the plan.
    start : datetime
        A moment of the plan.

    Returns
    -------
    LocalClock
        Turns moments into what they show.
    """
    if start.tzinfo is None:
        return LocalClock(None)
    bans = bans_of(country)
    zone = ZoneInfo(bans.zone) if bans else start.tzinfo
    return LocalClock(zone)  # type: ignore[arg-type]


def country_of_edge(net: RoadNetwork, edge: int) -> str:
    """Return the country of an edge.

    Parameters
    ----------
    net : RoadNetwork
        The network.
    edge : int
        Its position.

    Returns
    -------
    str
        Two letters; empty if it is not known.
    """
    return net.texts[int(net.country[edge])][:2].upper()


def midpoint(net: RoadNetwork, edge: int) -> tuple[float, float]:
    """Return a place on an edge.

    Parameters
    ----------
    net : RoadNetwork
        The network.
    edge : int
        Its position.

    Returns
    -------
    (float, float)
        Longitude and latitude of its head.
    """
    head = int(net.head[edge])
    return float(net.lon[head]), float(net.lat[head])


def edge_times(net: RoadNetwork, stretch: Stretch) -> list[tuple[float, float]]:
    """Return when the edges of a stretch are driven, after its start.

    Parameters
    ----------
    net : RoadNetwork
        The network whose edges it names.
    stretch : Stretch
        With edges.

    Returns
    -------
    list of (float, float)
        Seconds.
    """
    edges = np.array(stretch.edges)
    times = net.length_m[edges] / net.speed_mps[edges]
    begin, end = stretch.span
    if len(edges) == 1:
        times = times * (end - begin)
    else:
        times[0] *= 1 - begin
        times[-1] *= end
    ends = np.cumsum(times)
    if ends[-1] > 0:
        ends *= stretch.drive_s / ends[-1]
    bounds = [0.0, *ends.tolist()]
    return list(pairwise(bounds))
