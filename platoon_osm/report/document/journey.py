"""The way of every vehicle by distance: which pieces of line it drives, and from where it counts.

A plan has no times, so nothing here is a time. All vehicles of a platoon count the same
kilometres: where two drive together, both have come equally far on the common scale. Before a
merge and after a separation each is set as far back, or ahead, as the others are.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from itertools import count

import numpy as np
from numpy.typing import NDArray

from ...network.road_network import RoadNetwork
from ...plans.records import JointPlan, VehiclePlan
from ...plans.stretches import PlatoonSection
from .model_day import JourneyScale

__all__ = ["journey", "rounded", "ways"]

AGREE_M = 100.0
"""How far two sections may put one vehicle apart before no common scale is drawn."""


def journey(
    plan: JointPlan,
    net: RoadNetwork,
    sections: Sequence[PlatoonSection],
    groups: Sequence[tuple[int, ...]],
) -> JourneyScale | None:
    """Return the scale on which vehicles of a platoon are always level.

    Platoons that never meet, and vehicles alone, each begin at 0.

    Parameters
    ----------
    plan : JointPlan
        Whose vehicles they are.
    net : RoadNetwork
        Where they drive.
    sections : sequence of PlatoonSection
        Stretches of one company.
    groups : sequence of tuple of int
        Vehicles that belong together.

    Returns
    -------
    JourneyScale or None
        Not rounded. None if vehicles that part and meet again drive ways of other length in
        between.
    """
    starts: dict[int, float] = {}
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
    return JourneyScale(max(ends), every, 0 if len(plan.vehicles) == 1 else guide)


def rounded(scale: JourneyScale | None) -> JourneyScale | None:
    """Return a scale to a tenth of a metre, as it is written.

    Parameters
    ----------
    scale : JourneyScale or None
        As it was worked out.

    Returns
    -------
    JourneyScale or None
        The same, rounded.
    """
    if scale is None:
        return None
    starts = tuple(round(start, 1) for start in scale.starts_m)
    return replace(scale, length_m=round(scale.length_m, 1), starts_m=starts)


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


def ways(
    plan: JointPlan, sections: Sequence[PlatoonSection]
) -> tuple[tuple[tuple[str, int], ...], ...]:
    """Return each vehicle's pieces in driving order.

    Parameters
    ----------
    plan : JointPlan
        Whose vehicles they are.
    sections : sequence of PlatoonSection
        Stretches of one company.

    Returns
    -------
    tuple of tuple
        For each vehicle, "solo" or "platoon" and the position among those, piece by piece.
    """
    solo = count()
    section_of = {
        (index, edge): number
        for number, section in enumerate(sections)
        for index in section.vehicles
        for edge in section.edges
    }
    found: list[tuple[tuple[str, int], ...]] = []
    for index, vehicle in enumerate(plan.vehicles):
        way: list[tuple[str, int]] = []
        for leg in vehicle.legs:
            if leg.role != "platoon" and leg.edges:
                # In the order of `solo_stretches`: leg by leg.
                way.append(("solo", next(solo)))
                continue
            for edge in leg.edges:
                piece = section_of.get((index, edge))
                if piece is not None and way[-1:] != [("platoon", piece)]:
                    way.append(("platoon", piece))
        found.append(tuple(way))
    return tuple(found)
