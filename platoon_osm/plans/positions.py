"""The position of each vehicle in its company along its way: who leads from where to where, when.

A span is a longest part of a way in one position of a company of one size. Where pauses or changes
behind it cut the way, but its position stays, a span goes on.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass, replace

from .plan import Plan

__all__ = ["LeadRun", "PositionSpan", "lead_runs", "positions_of"]


@dataclass(frozen=True, slots=True)
class PositionSpan:
    """A vehicle in one position of its company.

    Attributes
    ----------
    vehicle : int
        Position in the plan.
    position, size : int
        Its position, 1 for the leader, and how many they are; 1 of 1 where it drives alone.
    from_m, to_m : float
        From where to where on its way [m].
    start_s, end_s : float or None
        When, in seconds from the start of the timetable; None in a plan without times.
    place : str
        Where it begins: at the origin, a merge, a separation, or a change of the lead.
    first, last : int
        The legs from which to which it goes, counted from 0.
    """

    vehicle: int
    position: int
    size: int
    from_m: float
    to_m: float
    start_s: float | None
    end_s: float | None
    place: str
    first: int
    last: int

    @property
    def leads(self) -> bool:
        """Whether it leads others."""
        return self.position == 1 and self.size > 1


@dataclass(frozen=True, slots=True)
class LeadRun:
    """A vehicle in front of one company, or of several one after the other.

    Attributes
    ----------
    vehicle : int
        Position in the plan.
    length_m : float
        How far it leads [m].
    from_m : float
        From where on its own way [m].
    start_s : float or None
        When it begins, in seconds from the start of the timetable; None without times.
    begins, ends : str
        What the places are called where it begins and ends.
    """

    vehicle: int
    length_m: float
    from_m: float
    start_s: float | None
    begins: str
    ends: str


def positions_of(plan: Plan) -> tuple[PositionSpan, ...]:
    """Return where and when each vehicle drives in which position.

    Parameters
    ----------
    plan : Plan
        Any; of one whose lead is not handed on, too.

    Returns
    -------
    tuple of PositionSpan
        Vehicle by vehicle in driving order; those of one are all of its way.
    """
    places = _begins_at(plan)
    return tuple(span for k in range(len(plan.trips)) for span in _spans(plan, k, places))


def _spans(
    plan: Plan, vehicle: int, places: Mapping[tuple[int, int], str]
) -> Iterator[PositionSpan]:
    times = plan.times[vehicle]
    now: PositionSpan | None = None
    at_m = 0.0
    for leg, number in enumerate(plan.ways[vehicle]):
        stretch = plan.stretches[number]
        position, size = stretch.vehicles.index(vehicle) + 1, len(stretch.vehicles)
        to_m = at_m + stretch.length_m
        start, end = (None, None) if times is None else times.legs[leg]
        if now is not None and (now.position, now.size) == (position, size):
            now = replace(now, to_m=to_m, end_s=end, last=leg)
        else:
            if now is not None:
                yield now
            place = places.get((vehicle, number), "")
            now = PositionSpan(vehicle, position, size, at_m, to_m, start, end, place, leg, leg)
        at_m = to_m
    assert now is not None
    yield now


def _begins_at(plan: Plan) -> dict[tuple[int, int], str]:
    """Return what the places are called where vehicles begin stretches, as far as it is known."""
    found: dict[tuple[int, int], str] = {}
    starts: dict[int, str] = {}
    ends: dict[int, str] = {}
    for event in plan.events:
        (starts if event.kind == "merge" else ends)[event.stretch] = event.point.name
    if plan.rotation is not None:
        starts |= {change.stretch: change.point.name for change in plan.rotation.changes}
    for vehicle, way in enumerate(plan.ways):
        for leg, number in enumerate(way):
            known = starts.get(number) or (ends.get(way[leg - 1]) if leg else None)
            found[vehicle, number] = known or ("" if leg else plan.trips[vehicle].origin.name)
    return found


def lead_runs(plan: Plan) -> tuple[tuple[LeadRun, ...], ...]:
    """Return who leads, group by group, each in driving order.

    Parameters
    ----------
    plan : Plan
        Any.

    Returns
    -------
    tuple of tuple of LeadRun
        A group is who drives one after the other in front of companies linked by their vehicles;
        where such companies drive apart at the same time, those of the earlier vehicle come first.
    """
    places = _begins_at(plan)
    rank = _driving_order(plan)
    spans = sorted(
        _merged(positions_of(plan)),
        key=lambda span: rank[plan.ways[span.vehicle][span.first]],
    )
    groups = (
        tuple(_run(plan, span, places) for span in spans if span.vehicle in platoon.vehicles)
        for platoon in plan.platoons
    )
    return tuple(group for group in groups if group)


def _merged(spans: Iterable[PositionSpan]) -> list[PositionSpan]:
    """Return the spans in front, those of companies that follow each other as one."""
    found: list[PositionSpan] = []
    for span in spans:
        if not span.leads:
            continue
        last = found[-1] if found else None
        if last is not None and last.vehicle == span.vehicle and last.last + 1 == span.first:
            found[-1] = replace(last, to_m=span.to_m, end_s=span.end_s, last=span.last)
        else:
            found.append(span)
    return found


def _driving_order(plan: Plan) -> dict[int, tuple[int, int]]:
    """Return where stretches stand: on the way of who drives longest with others, or the next."""
    together_m = [
        sum(plan.stretches[k].length_m for k in way if plan.stretches[k].together)
        for way in plan.ways
    ]
    guides = sorted(range(len(plan.ways)), key=lambda k: (-together_m[k], k))
    found: dict[int, tuple[int, int]] = {}
    for rank, guide in enumerate(guides):
        for leg, number in enumerate(plan.ways[guide]):
            found.setdefault(number, (rank, leg))
    return found


def _run(plan: Plan, span: PositionSpan, places: Mapping[tuple[int, int], str]) -> LeadRun:
    way = plan.ways[span.vehicle]
    after = span.last + 1
    to = plan.trips[span.vehicle].destination.name
    if after < len(way):
        to = places[span.vehicle, way[after]]
    return LeadRun(
        span.vehicle, span.to_m - span.from_m, span.from_m, span.start_s,
        places[span.vehicle, way[span.first]], to,
    )  # fmt: skip
