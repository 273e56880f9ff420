"""Where each vehicle of a plan stands on its way: how long, why, at which place and with whom.

A record of a pause says so itself. What a record leaves of the gap between two legs, and a gap
without one, is a wait for others where the next leg begins.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace

from ...network.road_network import RoadNetwork
from ...plans.clock import MENTIONED_S
from ...plans.pauses import Pause
from ...plans.plan import Plan
from ...plans.standing import standing
from ...plans.timetable import VehicleTimes
from .stands import kind_of

__all__ = ["Halt", "halts_of"]


@dataclass(frozen=True, slots=True)
class Halt:
    """A while in which a vehicle stands on its way.

    Attributes
    ----------
    before : int
        The leg that follows, counted from 0 along its way.
    purposes : tuple of str
        Of `PURPOSES`, what matters most first.
    begin_s, end_s : float
        From when to when [s].
    is_planned : bool
        Whether the plan has a record of it; else it is a wait that follows from the times.
    name : str
        Of the place; other people's text, and empty if it has none.
    kind : str
        What is there, of `PLACE_KINDS` or as the network calls it; empty if nothing is known.
    lon, lat : float
        Of the place [deg].
    beside_m : float
        How far it is from the road [m].
    capacity : int or None
        Spaces for trucks; None where not known.
    company : tuple of int
        Other vehicles that stand there meanwhile.
    """

    before: int
    purposes: tuple[str, ...]
    begin_s: float
    end_s: float
    is_planned: bool
    name: str
    kind: str
    lon: float
    lat: float
    beside_m: float = 0.0
    capacity: int | None = None
    company: tuple[int, ...] = ()

    @property
    def lasts_s(self) -> float:
        """How long [s]."""
        return self.end_s - self.begin_s

    @property
    def what(self) -> str:
        """What it is drawn as: "rest", "break", "ban", "change" or "wait", what matters most."""
        return kind_of(self.purposes)

    @property
    def has_parking(self) -> bool:
        """Whether trucks are known to park there."""
        return self.kind not in ("", "junction", "origin")


def halts_of(plan: Plan, net: RoadNetwork) -> tuple[tuple[Halt, ...], ...]:
    """Return where the vehicles of a plan stand.

    Parameters
    ----------
    plan : Plan
        Laid out in whole edges.
    net : RoadNetwork
        The network it is laid out on.

    Returns
    -------
    tuple of tuple of Halt, (N, ...)
        Of each vehicle, in order of time; empty for all without times.
    """
    alone = [
        () if times is None else tuple(_halts(plan, net, index, times))
        for index, times in enumerate(plan.times)
    ]
    return tuple(
        tuple(replace(halt, company=_company(plan, alone, index, halt)) for halt in own)
        for index, own in enumerate(alone)
    )


def _halts(plan: Plan, net: RoadNetwork, index: int, times: VehicleTimes) -> Iterator[Halt]:
    records = {(pause.before, pause.end_s) for pause in times.pauses}
    for pause in standing(times):
        if (pause.before, pause.end_s) in records:
            yield _planned(plan, net, index, pause)
        elif pause.duration_s >= MENTIONED_S:
            yield _wait(plan, net, index, pause)


def _planned(plan: Plan, net: RoadNetwork, index: int, pause: Pause) -> Halt:
    place = pause.place
    if place is None or place.kind == "origin":
        return replace(_wait(plan, net, index, pause), is_planned=True)
    return Halt(
        pause.before, pause.purposes, pause.start_s, pause.end_s, True, place.name, place.kind,
        place.lon, place.lat, place.beside_m, place.capacity,
    )  # fmt: skip


def _wait(plan: Plan, net: RoadNetwork, index: int, pause: Pause) -> Halt:
    """Return a pause where a leg begins."""
    way, origin, leg = plan.ways[index], plan.trips[index].origin, pause.before
    told = leg, pause.purposes, pause.start_s, pause.end_s, False
    if leg == 0:
        return Halt(*told, origin.name, "origin", origin.lon, origin.lat)
    for event in plan.events:
        at = (event.kind == "merge" and event.stretch == way[leg]) or (
            event.kind == "separation" and event.stretch == way[leg - 1]
        )
        if at and index in (*event.movers, *event.others):
            return Halt(*told, event.point.name, "", event.point.lon, event.point.lat)
    node = int(net.tail[plan.stretches[way[leg]].edges[0]])
    return Halt(*told, net.place_name(node), "", float(net.lon[node]), float(net.lat[node]))


def _company(plan: Plan, halts: list[tuple[Halt, ...]], index: int, halt: Halt) -> tuple[int, ...]:
    """Return who stands at the place of a halt meanwhile, of those met before or after it."""
    way = plan.ways[index]
    near = {way[leg] for leg in (halt.before - 1, halt.before) if leg >= 0}
    others = {one for k in near for one in plan.stretches[k].vehicles} - {index}
    return tuple(
        other
        for other in sorted(others)
        if any(
            (one.lon, one.lat) == (halt.lon, halt.lat)
            and min(one.end_s, halt.end_s) - max(one.begin_s, halt.begin_s) >= MENTIONED_S
            for one in halts[other]
        )
    )
