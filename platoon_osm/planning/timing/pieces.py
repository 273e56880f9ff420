"""The pieces that a timetable is made of: stretches driven by one company, and what precedes them.

A platoon moves as one, so its stretch between two changes of company is one piece of all its
vehicles. A piece where nobody joins starts when the piece before it ends: there is nobody to wait
for. Only the others have a start of their own to choose.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from graphlib import CycleError, TopologicalSorter

from ...errors import ScenarioError
from ...plans.records import Leg, VehiclePlan

__all__ = ["Piece", "Pieces", "pieces_of"]

AGREE = 1e-6
"""Vehicles of a platoon may differ by this share in the driving time of one stretch."""


@dataclass(frozen=True, slots=True)
class Piece:
    """A stretch driven by one company.

    Attributes
    ----------
    company : positions of its vehicles in the plan.
    time_s : driving time.
    before : pieces that its vehicles come from.
    begins : vehicles that start their journey with it.
    root : the piece whose start settles this one's, itself if it has a start of its own.
    offset_s : how long after the start of its root it starts.
    """

    company: frozenset[int]
    time_s: float
    before: tuple[int, ...]
    begins: tuple[int, ...]
    root: int
    offset_s: float


@dataclass(frozen=True, slots=True)
class Pieces:
    """All pieces of a plan, each after those before it.

    Attributes
    ----------
    pieces : in an order of time.
    ways : the pieces of each vehicle's legs.
    groups : vehicles linked by driving together; who drives alone is a group.
    """

    pieces: tuple[Piece, ...]
    ways: tuple[tuple[int, ...], ...]
    groups: tuple[tuple[int, ...], ...]


def pieces_of(vehicles: Sequence[VehiclePlan]) -> Pieces:
    """Cut a plan into pieces.

    Raises
    ------
    ScenarioError
        Vehicles that name each other as company but do not drive the same, or wait for each other
        in a circle.
    """
    names = {vehicle.vehicle: index for index, vehicle in enumerate(vehicles)}
    driven: dict[tuple[object, ...], list[tuple[int, int]]] = {}
    for index, vehicle in enumerate(vehicles):
        if not vehicle.legs:
            raise ScenarioError(f"schedule: {vehicle.vehicle!r} has no legs; plan again")
        for number, leg in enumerate(vehicle.legs):
            alone = leg.role != "platoon"
            company = frozenset({vehicle.vehicle, *(() if alone else leg.partners)})
            key = (index, number) if alone else (company, leg.edges)
            driven.setdefault(key, []).append((index, number))
    keys = list(driven)
    ways: list[list[int]] = [[] for _ in vehicles]
    for index, _, piece in sorted(
        (index, number, k) for k, key in enumerate(keys) for index, number in driven[key]
    ):
        ways[index].append(piece)
    before = [
        tuple(sorted({ways[i][number - 1] for i, number in driven[key] if number})) for key in keys
    ]
    order = _in_time(before)
    place = {piece: rank for rank, piece in enumerate(order)}
    made: list[Piece] = []
    for piece in order:
        legs = driven[keys[piece]]
        made.append(_piece(vehicles, names, legs, [place[k] for k in before[piece]], made))
    return Pieces(
        tuple(made),
        tuple(tuple(place[piece] for piece in way) for way in ways),
        _groups(made, len(vehicles)),
    )


def _in_time(before: Sequence[tuple[int, ...]]) -> list[int]:
    try:
        return list(TopologicalSorter(dict(enumerate(before))).static_order())
    except CycleError:
        raise ScenarioError(
            "schedule: the legs of the plan wait for each other in a circle; plan again"
        ) from None


def _piece(
    vehicles: Sequence[VehiclePlan], names: dict[str, int], legs: Sequence[tuple[int, int]],
    before: Sequence[int], made: Sequence[Piece],
) -> Piece:  # fmt: skip
    company = frozenset(index for index, _ in legs)
    first, number = legs[0]
    leg = vehicles[first].legs[number]
    _check(vehicles, names, company, leg, vehicles[first].vehicle)
    times = [vehicles[index].legs[number].time_s for index, number in legs]
    if max(times) - min(times) > AGREE * max(times):
        raise ScenarioError(
            f"schedule: vehicles of the platoon of {vehicles[first].vehicle!r} need from "
            f"{min(times):.0f} to {max(times):.0f} s for one stretch; plan again"
        )
    begins = tuple(index for index, number in legs if number == 0)
    root, offset = len(made), 0.0
    if len(before) == 1 and not begins and company <= made[before[0]].company:
        last = made[before[0]]
        root, offset = last.root, last.offset_s + last.time_s
    return Piece(company, max(times), tuple(before), begins, root, offset)


def _check(
    vehicles: Sequence[VehiclePlan], names: dict[str, int], company: frozenset[int], leg: Leg,
    own: str,
) -> None:  # fmt: skip
    missing = set(leg.partners if leg.role == "platoon" else ()) - {
        vehicles[index].vehicle for index in company
    }
    if missing:
        other = min(missing)
        raise ScenarioError(
            f"schedule: {own!r} drives with {other!r}, which "
            f"{'drives no such leg' if other in names else 'is not in the plan'}; plan again"
        )


def _groups(pieces: Sequence[Piece], vehicles: int) -> tuple[tuple[int, ...], ...]:
    group = [{index} for index in range(vehicles)]
    for piece in pieces:
        joined = set().union(*(group[index] for index in piece.company))
        for index in joined:
            group[index] = joined
    return tuple(sorted({tuple(sorted(one)) for one in group}))
