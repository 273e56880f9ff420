"""Who drives where together: platoon sections of one company each, and solo stretches.

Also which lane of the drawing each gets, so that lines on one road lie side by side.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass

from .records import JointPlan, Leg

__all__ = [
    "PlatoonPart", "PlatoonSection", "SoloPart", "SoloStretch", "platoon_groups", "platoon_parts",
    "platoon_sections", "solo_stretches",
]  # fmt: skip


@dataclass(frozen=True, slots=True)
class PlatoonSection:
    """A longest stretch of road driven by one unchanged group.

    Attributes
    ----------
    vehicles : positions in the plan, ascending; two or more.
    edges : edge ids in driving order.
    """

    vehicles: tuple[int, ...]
    edges: tuple[int, ...]


@dataclass(frozen=True, slots=True)
class PlatoonPart:
    """A part of a platoon section along which the same other platoons use the road.

    Attributes
    ----------
    edges : edge ids in driving order.
    beside : number of vehicles in each band on the road, from left to right.
    place : which of those bands is this one's.
    opposite_m : how far away others drive the other way; None if none do.
    """

    edges: tuple[int, ...]
    beside: tuple[int, ...]
    place: int
    opposite_m: int | None = None


@dataclass(frozen=True, slots=True)
class SoloPart:
    """A part of a solo stretch, drawn in one lane.

    Attributes
    ----------
    edges : edge ids in driving order.
    slot, slots : this vehicle's place among the solo vehicles on the road, and their number.
    bands : vehicles in each platoon on the same road, beside whose bands the line is drawn.
    opposite_m : how far away others drive the other way; None if none do.
    """

    edges: tuple[int, ...]
    slot: int
    slots: int
    bands: tuple[int, ...]
    opposite_m: int | None = None


@dataclass(frozen=True, slots=True)
class SoloStretch:
    """One solo leg of one vehicle, cut where its lane in the drawing changes."""

    vehicle: int
    leg: Leg
    parts: tuple[SoloPart, ...]


def platoon_sections(plan: JointPlan) -> list[PlatoonSection]:
    """Return all platoon sections, vehicle by vehicle in driving order, each section once."""
    company = _company(plan)
    sections: list[PlatoonSection] = []
    for index, vehicle in enumerate(plan.vehicles):
        group: tuple[int, ...] = ()
        edges: list[int] = []
        for leg in (*vehicle.legs, None):
            for edge in leg.edges if leg else (-1,):
                now = company.get((index, edge), ()) if leg and leg.role == "platoon" else ()
                if now != group:
                    # The group's first vehicle speaks for it, so that it is listed once.
                    if len(group) > 1 and group[0] == index:
                        sections.append(PlatoonSection(group, tuple(edges)))
                    group, edges = now, []
                edges.append(edge)
    return sections


def _company(plan: JointPlan) -> dict[tuple[int, int], tuple[int, ...]]:
    """Return for each vehicle and platoon edge who drives there together, itself included."""
    position = {vehicle.vehicle: index for index, vehicle in enumerate(plan.vehicles)}
    on_edge: dict[tuple[int, int], frozenset[int]] = {}
    for index, vehicle in enumerate(plan.vehicles):
        for leg in vehicle.legs:
            if leg.role == "platoon":
                partners = frozenset(position[name] for name in leg.partners if name in position)
                on_edge.update(((index, edge), partners) for edge in leg.edges)
    # A leg may name partners who share only some of its edges: those count who are there.
    return {
        (index, edge): tuple(
            sorted({index, *(other for other in partners if (other, edge) in on_edge)})
        )
        for (index, edge), partners in on_edge.items()
    }


def platoon_groups(sections: Sequence[PlatoonSection], vehicles: int) -> list[tuple[int, ...]]:
    """Return who belongs together: vehicles linked by sections, in order of their first vehicle.

    Two vehicles are in one group if they share a section, or each shares one with a third.
    Vehicles without any section are in no group.
    """
    head = list(range(vehicles))

    def first(index: int) -> int:
        while head[index] != index:
            index = head[index]
        return index

    for section in sections:
        heads = sorted({first(index) for index in section.vehicles})
        for other in heads[1:]:
            head[other] = heads[0]
    members: dict[int, list[int]] = defaultdict(list)
    for index in range(vehicles):
        members[first(index)].append(index)
    return [tuple(group) for group in members.values() if len(group) > 1]


NOBODY: Mapping[int, int] = {}


def platoon_parts(
    sections: Sequence[PlatoonSection], opposite: Mapping[int, int] = NOBODY
) -> list[tuple[PlatoonPart, ...]]:
    """Cut each section where others come onto its road, or beside it, or leave it.

    `opposite` tells how far from an edge others drive the other way, as `opposite_gaps` finds it.
    """
    on_edge = _bands(sections)
    result: list[tuple[PlatoonPart, ...]] = []
    for number, section in enumerate(sections):
        parts: list[PlatoonPart] = []
        for edge in section.edges:
            beside = tuple(len(sections[other].vehicles) for other in on_edge[edge])
            lane = beside, on_edge[edge].index(number), opposite.get(edge)
            last = parts[-1] if parts else None
            if last and (last.beside, last.place, last.opposite_m) == lane:
                parts[-1] = PlatoonPart((*last.edges, edge), *lane)
            else:
                parts.append(PlatoonPart((edge,), *lane))
        result.append(tuple(parts))
    return result


def _bands(sections: Sequence[PlatoonSection]) -> dict[int, list[int]]:
    """Return for each edge the sections that use it; those of one vehicle keep their side."""
    on_edge: dict[int, list[int]] = defaultdict(list)
    for number in sorted(range(len(sections)), key=lambda one: sections[one].vehicles):
        for edge in dict.fromkeys(sections[number].edges):
            on_edge[edge].append(number)
    return on_edge


def solo_stretches(
    plan: JointPlan,
    sections: Sequence[PlatoonSection] | None = None,
    opposite: Mapping[int, int] = NOBODY,
) -> Iterator[SoloStretch]:
    """Yield the solo legs of all vehicles, each cut into parts of one lane."""
    sections = platoon_sections(plan) if sections is None else sections
    bands = _bands(sections)
    alone: dict[int, list[int]] = defaultdict(list)
    for index, vehicle in enumerate(plan.vehicles):
        for leg in vehicle.legs:
            for edge in leg.edges:
                if leg.role != "platoon" and index not in alone[edge]:
                    alone[edge].append(index)
    for index, vehicle in enumerate(plan.vehicles):
        for leg in vehicle.legs:
            if leg.role == "platoon" or not leg.edges:
                continue
            parts: list[SoloPart] = []
            for edge in leg.edges:
                beside = tuple(len(sections[other].vehicles) for other in bands.get(edge, ()))
                lane = alone[edge].index(index), len(alone[edge]), beside, opposite.get(edge)
                last = parts[-1] if parts else None
                if last and (last.slot, last.slots, last.bands, last.opposite_m) == lane:
                    parts[-1] = SoloPart((*last.edges, edge), *lane)
                else:
                    parts.append(SoloPart((edge,), *lane))
            yield SoloStretch(index, leg, tuple(parts))
