"""Which lane of the drawing each line gets, so that lines on one road lie side by side.

Stretches are cut where others come onto their road, or beside it, or leave it.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from ...plans.records import Stretch

__all__ = ["PlatoonPart", "SoloPart", "platoon_parts", "solo_parts"]

NOBODY: Mapping[int, int] = {}


@dataclass(frozen=True, slots=True)
class PlatoonPart:
    """A part of a platoon's stretch along which the same other platoons use the road.

    Attributes
    ----------
    edges : tuple of int
        Edge ids in driving order.
    beside : tuple of int
        Number of vehicles in each band on the road, from left to right.
    place : int
        Which of those bands is this one's.
    opposite_m : int or None
        How far away others drive the other way [m]; None if none do.
    """

    edges: tuple[int, ...]
    beside: tuple[int, ...]
    place: int
    opposite_m: int | None = None


@dataclass(frozen=True, slots=True)
class SoloPart:
    """A part of a stretch driven alone, drawn in one lane.

    Attributes
    ----------
    edges : tuple of int
        Edge ids in driving order.
    slot, slots : int
        This vehicle's place among those alone on the road, and their number.
    bands : tuple of int
        Vehicles in each platoon on the same road, beside whose bands the line is drawn.
    opposite_m : int or None
        How far away others drive the other way [m]; None if none do.
    """

    edges: tuple[int, ...]
    slot: int
    slots: int
    bands: tuple[int, ...]
    opposite_m: int | None = None


def platoon_parts(
    platoons: Sequence[Stretch], opposite: Mapping[int, int] = NOBODY
) -> list[tuple[PlatoonPart, ...]]:
    """Cut each platoon's stretch where its lane changes.

    Parameters
    ----------
    platoons : sequence of Stretch
        Those driven together.
    opposite : mapping of int to int
        How far from an edge others drive the other way [m], as `opposite_gaps` finds it.

    Returns
    -------
    list of tuple of PlatoonPart
        The parts of each stretch in driving order.
    """
    on_edge = _bands(platoons)
    result: list[tuple[PlatoonPart, ...]] = []
    for number, stretch in enumerate(platoons):
        parts: list[PlatoonPart] = []
        for edge in stretch.edges:
            beside = tuple(len(platoons[other].vehicles) for other in on_edge[edge])
            lane = beside, on_edge[edge].index(number), opposite.get(edge)
            last = parts[-1] if parts else None
            if last and (last.beside, last.place, last.opposite_m) == lane:
                parts[-1] = PlatoonPart((*last.edges, edge), *lane)
            else:
                parts.append(PlatoonPart((edge,), *lane))
        result.append(tuple(parts))
    return result


def solo_parts(
    solos: Sequence[Stretch],
    platoons: Sequence[Stretch],
    opposite: Mapping[int, int] = NOBODY,
) -> list[tuple[SoloPart, ...]]:
    """Cut each stretch driven alone where its lane changes.

    Parameters
    ----------
    solos : sequence of Stretch
        Those driven alone.
    platoons : sequence of Stretch
        Those driven together.
    opposite : mapping of int to int
        How far from an edge others drive the other way [m].

    Returns
    -------
    list of tuple of SoloPart
        The parts of each stretch in driving order.
    """
    bands = _bands(platoons)
    alone: dict[int, list[int]] = defaultdict(list)
    for stretch in solos:
        (index,) = stretch.vehicles
        for edge in stretch.edges:
            if index not in alone[edge]:
                alone[edge].append(index)
    result: list[tuple[SoloPart, ...]] = []
    for stretch in solos:
        (index,) = stretch.vehicles
        parts: list[SoloPart] = []
        for edge in stretch.edges:
            beside = tuple(len(platoons[other].vehicles) for other in bands.get(edge, ()))
            lane = alone[edge].index(index), len(alone[edge]), beside, opposite.get(edge)
            last = parts[-1] if parts else None
            if last and (last.slot, last.slots, last.bands, last.opposite_m) == lane:
                parts[-1] = SoloPart((*last.edges, edge), *lane)
            else:
                parts.append(SoloPart((edge,), *lane))
        result.append(tuple(parts))
    return result


def _bands(platoons: Sequence[Stretch]) -> dict[int, list[int]]:
    """Return for each edge the stretches that use it; those of one vehicle keep their side."""
    on_edge: dict[int, list[int]] = defaultdict(list)
    for number in sorted(range(len(platoons)), key=lambda one: platoons[one].company):
        for edge in dict.fromkeys(platoons[number].edges):
            on_edge[edge].append(number)
    return on_edge
