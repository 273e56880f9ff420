"""The platoons of a fleet's plan: chains of stretches in company that follow each other.

Two stretches in company belong to one platoon if one of its vehicles drives from one into the other
without a stop. So a platoon goes on while vehicles join and leave it; it ends where nobody is left,
or where all stand. Where several stretches of one platoon begin it, the earliest does.
"""

from __future__ import annotations

import itertools
from collections import defaultdict
from collections.abc import Mapping
from dataclasses import dataclass

from .plan import Plan
from .timetable import LATE_S

__all__ = ["Convoy", "convoys_of", "vehicle_m_by_size"]


@dataclass(frozen=True, slots=True)
class Convoy:
    """One platoon from where it forms to where the last of it part.

    Attributes
    ----------
    vehicles : tuple of int
        All that drive in it, positions in the plan, ascending.
    stretches : tuple of int
        What it drives, positions in the plan, in order of time, or of the plan without times.
    largest : int
        Most vehicles on one of them.
    forms, parts : str
        What the places are called where it forms and where the last of it part; empty if the plan
        does not tell, as where a company stands and drives on as it came.
    last : int
        The stretch at whose end the last of it part, a position in the plan.
    begins_s, ends_s : float or None
        When, in seconds from the start of the timetable; None without times.
    road_m : float
        Length of its stretches [m].
    vehicle_m : float
        The same for each vehicle on them [m].
    saving : float or None
        What company saves all of them, in the unit of the plan; None if the plan does not tell.
    """

    vehicles: tuple[int, ...]
    stretches: tuple[int, ...]
    largest: int
    forms: str
    parts: str
    last: int
    begins_s: float | None
    ends_s: float | None
    road_m: float
    vehicle_m: float
    saving: float | None


def convoys_of(plan: Plan) -> tuple[Convoy, ...]:
    """Return the platoons of a plan, each from where it forms to where it parts.

    Parameters
    ----------
    plan : Plan
        Any.

    Returns
    -------
    tuple of Convoy
        In order of time, then of their first vehicle.
    """
    spans = _spans(plan)
    group = {k: k for k, one in enumerate(plan.stretches) if one.together}

    def top(k: int) -> int:
        while group[k] != k:
            group[k] = k = group[group[k]]
        return k

    for vehicle, way in enumerate(plan.ways):
        times = plan.times[vehicle]
        for leg, (before, after) in enumerate(itertools.pairwise(way)):
            if before not in group or after not in group:
                continue
            if times is None or times.legs[leg + 1][0] - times.legs[leg][1] <= LATE_S:
                group[top(after)] = top(before)
    held = defaultdict(list)
    for k in group:
        held[top(k)].append(k)
    places = _Places(plan)
    found = [_convoy(plan, own, spans, places) for own in held.values()]
    return tuple(sorted(found, key=lambda one: (one.begins_s or 0.0, one.vehicles)))


def vehicle_m_by_size(plan: Plan) -> dict[int, float]:
    """Return how far vehicles drive in company of which size.

    Parameters
    ----------
    plan : Plan
        Any.

    Returns
    -------
    dict of int to float
        Vehicle-metres by vehicles of the company, 1 for those alone, ascending [m].
    """
    sums: dict[int, float] = defaultdict(float)
    for one in plan.stretches:
        sums[len(one.vehicles)] += len(one.vehicles) * one.length_m
    return dict(sorted(sums.items()))


def _spans(plan: Plan) -> dict[int, tuple[float, float]]:
    """Return when each stretch is driven; nothing without times."""
    return {
        k: span
        for way, times in zip(plan.ways, plan.times, strict=True)
        if times is not None
        for k, span in zip(way, times.legs, strict=True)
    }


def _convoy(
    plan: Plan, own: list[int], spans: Mapping[int, tuple[float, float]], places: _Places
) -> Convoy:
    order = sorted(own, key=lambda k: (spans[k], k) if k in spans else ((0.0, 0.0), k))
    last = max(own, key=lambda k: (spans[k][1], k) if k in spans else (0.0, k))
    stretches = [plan.stretches[k] for k in order]
    gains = [share.gain for one in stretches for share in one.shares]
    known = [gain for gain in gains if gain is not None]
    return Convoy(
        vehicles=tuple(sorted({vehicle for one in stretches for vehicle in one.vehicles})),
        stretches=tuple(order),
        largest=max(len(one.vehicles) for one in stretches),
        forms=places.begin(order[0]),
        parts=places.end(last),
        last=last,
        begins_s=spans[order[0]][0] if spans else None,
        ends_s=spans[last][1] if spans else None,
        road_m=sum(one.length_m for one in stretches),
        vehicle_m=sum(one.length_m * len(one.vehicles) for one in stretches),
        saving=sum(known) if len(known) == len(gains) else None,
    )


class _Places:
    """What the places are called where stretches begin and end, as far as the plan tells.

    It tells of origins, destinations and events. A company that stands, and drives on as it came,
    has no event there; its place has a name if somebody else meets or parts there.
    """

    def __init__(self, plan: Plan) -> None:
        self.starts: dict[int, str] = {}
        self.ends: dict[int, str] = {}
        for trip, way in zip(plan.trips, plan.ways, strict=True):
            self.starts.setdefault(way[0], trip.origin.name)
            self.ends.setdefault(way[-1], trip.destination.name)
        for event in plan.events:
            known = self.starts if event.kind == "merge" else self.ends
            known.setdefault(event.stretch, event.point.name)
        # Where one stretch ends another begins; a name goes from either to all that meet there.
        for _ in range(2):
            for way in plan.ways:
                for before, after in itertools.pairwise(way):
                    name = self.ends.get(before) or self.starts.get(after)
                    if name:
                        self.ends.setdefault(before, name)
                        self.starts.setdefault(after, name)

    def begin(self, stretch: int) -> str:
        return self.starts.get(stretch, "")

    def end(self, stretch: int) -> str:
        return self.ends.get(stretch, "")
