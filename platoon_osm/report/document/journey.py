"""The way of every vehicle by distance: which pieces of line it drives, and from where it counts.

A plan has no times, so nothing here is a time. All vehicles of a platoon count the same
kilometres: where two drive together, both have come equally far on the common scale. Before a
merge and after a separation each is set as far back, or ahead, as the others are.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ...network.road_network import RoadNetwork
from ...plans.records import JointPlan, VehiclePlan
from ...plans.stretches import PlatoonSection, platoon_groups, solo_stretches

__all__ = ["Journey", "journey", "ways"]

AGREE_M = 100.0
"""How far two sections may put one vehicle apart before no common scale is drawn."""


@dataclass(frozen=True, slots=True)
class Journey:
    """A common scale of distance.

    Attributes
    ----------
    length_m : from where the first vehicle starts to where the last arrives.
    starts_m : where on the scale each vehicle starts.
    guide : the vehicle by whose kilometres the scale is read; None if there is no single one.
    """

    length_m: float
    starts_m: tuple[float, ...]
    guide: int | None


def journey(
    plan: JointPlan, net: RoadNetwork, sections: Sequence[PlatoonSection]
) -> Journey | None:
    """Return the scale on which vehicles of a platoon are always level; None if there is none.

    There is none if vehicles that part and meet again drive ways of other length in between.
    Platoons that never meet, and vehicles alone, each begin at 0.
    """
    starts: dict[int, float] = {}
    groups = platoon_groups(sections, len(plan.vehicles))
    for group in groups:
        own = [section for section in sections if section.vehicles[0] in group]
        found = _level(plan, net, group, own)
        if found is None:
            return None
        first = min(found.values())
        starts |= {index: start - first for index, start in found.items()}
    every = tuple(starts.get(index, 0.0) for index in range(len(plan.vehicles)))
    ends = [start + one.length_m for start, one in zip(every, plan.vehicles, strict=True)]
    guide = _guide(plan, groups[0]) if len(groups) == 1 else None
    return Journey(max(ends), every, 0 if len(plan.vehicles) == 1 else guide)


def _guide(plan: JointPlan, group: Sequence[int]) -> int:
    """Return the master of a group, or else who drives farthest in the platoon."""
    masters = [index for index in group if plan.vehicles[index].role == "master"]
    return masters[0] if masters else max(group, key=lambda i: (plan.vehicles[i].platoon_m, -i))


def _level(
    plan: JointPlan, net: RoadNetwork, group: Sequence[int], sections: Sequence[PlatoonSection]
) -> dict[int, float] | None:
    """Return a start for each vehicle of a group, so that all are level on every section."""
    driven = {index: _driven_before(plan.vehicles[index], net) for index in group}
    starts = {group[0]: 0.0}
    waiting = list(sections)
    while waiting:
        known = [section for section in waiting if any(i in starts for i in section.vehicles)]
        if not known:
            return None
        for section in known:
            waiting.remove(section)
            at = {index: driven[index][section.edges[0]] for index in section.vehicles}
            guide = next(index for index in section.vehicles if index in starts)
            level = starts[guide] + at[guide]
            for index in section.vehicles:
                start = starts.setdefault(index, level - at[index])
                if abs(start + at[index] - level) > AGREE_M:
                    return None
    return starts


def _driven_before(vehicle: VehiclePlan, net: RoadNetwork) -> dict[int, float]:
    edges: NDArray[np.int64] = np.asarray(vehicle.edges, np.int64)
    reached = np.cumsum(net.length_m[edges]) - net.length_m[edges]
    # A road driven twice counts from the first time.
    return {int(e): float(d) for e, d in zip(edges[::-1], reached[::-1], strict=True)}


def ways(plan: JointPlan, sections: Sequence[PlatoonSection]) -> list[list[tuple[str, int]]]:
    """Return each vehicle's pieces in driving order: ("solo" or "platoon", its position)."""
    solo_of = iter(range(sum(1 for _ in solo_stretches(plan, sections))))
    section_of = {
        (index, edge): number
        for number, section in enumerate(sections)
        for index in section.vehicles
        for edge in section.edges
    }
    found: list[list[tuple[str, int]]] = []
    for index, vehicle in enumerate(plan.vehicles):
        way: list[tuple[str, int]] = []
        for leg in vehicle.legs:
            if leg.role != "platoon" and leg.edges:
                way.append(("solo", next(solo_of)))
                continue
            for edge in leg.edges:
                piece = section_of.get((index, edge))
                if piece is not None and way[-1:] != [("platoon", piece)]:
                    way.append(("platoon", piece))
        found.append(way)
    return found
