"""Who drives where together: platoon sections of one company each, and solo stretches.

Also which lane of the drawing each gets, so that lines on one road lie side by side.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterator
from dataclasses import dataclass

from ..planning.plans import JointPlan, Leg

__all__ = ["PlatoonSection", "SoloStretch", "platoon_sections", "solo_stretches"]


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
class SoloPart:
    """A part of a solo stretch, drawn in one lane.

    Attributes
    ----------
    edges : edge ids in driving order.
    slot, slots : this vehicle's place among the solo vehicles on the road, and their number.
    band : vehicles in platoon on the same road, beside whose band the line is drawn.
    """

    edges: tuple[int, ...]
    slot: int
    slots: int
    band: int


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


def solo_stretches(plan: JointPlan) -> Iterator[SoloStretch]:
    """Yield the solo legs of all vehicles, each cut into parts of one lane."""
    alone: dict[int, list[int]] = defaultdict(list)
    band: dict[int, int] = defaultdict(int)
    for index, vehicle in enumerate(plan.vehicles):
        for leg in vehicle.legs:
            for edge in leg.edges:
                if leg.role == "platoon":
                    band[edge] += 1
                elif index not in alone[edge]:
                    alone[edge].append(index)
    for index, vehicle in enumerate(plan.vehicles):
        for leg in vehicle.legs:
            if leg.role == "platoon" or not leg.edges:
                continue
            parts: list[SoloPart] = []
            for edge in leg.edges:
                lane = alone[edge].index(index), len(alone[edge]), band.get(edge, 0)
                last = parts[-1] if parts else None
                if last and (last.slot, last.slots, last.band) == lane:
                    parts[-1] = SoloPart((*last.edges, edge), *lane)
                else:
                    parts.append(SoloPart((edge,), *lane))
            yield SoloStretch(index, leg, tuple(parts))
