"""The way of every vehicle by distance: which pieces of line it drives, and from where it counts.

A plan has no times, so nothing here is a time. All vehicles of a platoon count the same
kilometres: where two drive together, both have come equally far on the common scale. Before a
merge and after a separation each is set as far back, or ahead, as the others are.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from itertools import accumulate

from ...plans.plan import Plan
from .model_day import JourneyScale

__all__ = ["journey", "levels", "rounded"]

AGREE_M = 100.0
"""How far two stretches may put one vehicle apart before no common scale is drawn."""


def journey(plan: Plan, groups: Sequence[tuple[int, ...]]) -> JourneyScale | None:
    """Return the scale on which vehicles of a platoon are always level.

    Platoons that never meet, and vehicles alone, each begin at 0.

    Parameters
    ----------
    plan : Plan
        Whose vehicles they are.
    groups : sequence of tuple of int
        Vehicles that belong together.

    Returns
    -------
    JourneyScale or None
        Not rounded. None if vehicles that part and meet again drive ways of other length in
        between.
    """
    found = levels(plan, groups)
    if any(found[index] is None for group in groups for index in group):
        return None
    every = tuple(start or 0.0 for start in found)
    ends = [start + one.length_m for start, one in zip(every, plan.vehicles, strict=True)]
    guide = _guide(plan, groups[0]) if len(groups) == 1 else None
    return JourneyScale(max(ends), every, 0 if len(plan.vehicles) == 1 else guide)


def levels(plan: Plan, groups: Sequence[tuple[int, ...]]) -> tuple[float | None, ...]:
    """Return where each vehicle starts on the scale of its own group.

    Parameters
    ----------
    plan : Plan
        Whose vehicles they are.
    groups : sequence of tuple of int
        Vehicles that belong together.

    Returns
    -------
    tuple of float or None
        In metres from where the first of its group starts; None if the group has no scale. A
        vehicle alone starts at 0.
    """
    starts: dict[int, float | None] = {}
    for group in groups:
        found = _level(plan, group)
        first = min(found.values()) if found else 0.0
        starts |= {index: found[index] - first if found else None for index in group}
    return tuple(starts.get(index, 0.0) for index in range(len(plan.vehicles)))


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


def _guide(plan: Plan, group: Sequence[int]) -> int:
    """Return the master of a group, or else who drives farthest in the platoon."""
    masters = [index for index in group if plan.vehicles[index].role == "master"]
    return masters[0] if masters else max(group, key=lambda i: (plan.vehicles[i].platoon_m, -i))


def _level(plan: Plan, group: Sequence[int]) -> dict[int, float] | None:
    """Return a start for each vehicle of a group, so that all are level on every stretch."""
    before = {index: _driven_before(plan, index) for index in group}
    starts = {group[0]: 0.0}
    waiting = [
        number
        for number, stretch in enumerate(plan.stretches)
        if stretch.together and stretch.vehicles[0] in group
    ]
    while waiting:
        known = [n for n in waiting if any(i in starts for i in plan.stretches[n].vehicles)]
        if not known:
            return None
        for number in known:
            waiting.remove(number)
            company = plan.stretches[number].company
            guide = next(index for index in company if index in starts)
            level = starts[guide] + before[guide][number]
            for index in company:
                start = starts.setdefault(index, level - before[index][number])
                if abs(start + before[index][number] - level) > AGREE_M:
                    return None
    return starts


def _driven_before(plan: Plan, index: int) -> dict[int, float]:
    """Return how far a vehicle has come at the start of each stretch of its way."""
    way = plan.ways[index]
    lengths = [plan.stretches[stretch].length_m for stretch in way]
    return dict(zip(way, accumulate(lengths[:-1], initial=0.0), strict=True))
