"""The pieces that a timetable is made of: stretches driven by one company, and what precedes them.

A platoon moves as one, so its stretch between two changes of company is one piece of all its
vehicles. A piece where nobody joins starts when the piece before it ends: there is nobody to wait
for. Only the others have a start of their own to choose.
"""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass
from graphlib import TopologicalSorter
from itertools import pairwise
from typing import Protocol

from ...plans.stretches import linked

__all__ = ["Driven", "Piece", "Pieces", "pieces_of"]


class Driven(Protocol):
    """What the clock asks of a stretch."""

    @property
    def vehicles(self) -> tuple[int, ...]:
        """The positions of its vehicles in the plan."""
        ...

    @property
    def drive_s(self) -> float:
        """How long they drive it [s]."""
        ...


@dataclass(frozen=True, slots=True)
class Piece:
    """A stretch driven by one company, as the clock sees it.

    Attributes
    ----------
    company : frozenset of int
        Positions of its vehicles in the plan.
    time_s : float
        Driving time [s].
    before : tuple of int
        Pieces that its vehicles come from.
    begins : tuple of int
        Vehicles that start their journey with it.
    root : int
        The piece whose start settles this one's, itself if it has a start of its own.
    offset_s : float
        How long after the start of its root it starts [s].
    stands_s : tuple of float
        How long those who come from each piece of `before` stand at least before it starts [s].
    """

    company: frozenset[int]
    time_s: float
    before: tuple[int, ...]
    begins: tuple[int, ...]
    root: int
    offset_s: float
    stands_s: tuple[float, ...] = ()


@dataclass(frozen=True, slots=True)
class Pieces:
    """All pieces of a plan, each after those before it.

    Attributes
    ----------
    pieces : tuple of Piece
        In an order of time.
    ways : tuple of tuple of int
        The pieces of each vehicle's way.
    groups : tuple of tuple of int
        Vehicles linked by driving together; who drives alone is a group.
    """

    pieces: tuple[Piece, ...]
    ways: tuple[tuple[int, ...], ...]
    groups: tuple[tuple[int, ...], ...]


def pieces_of(
    stretches: Sequence[Driven],
    ways: Sequence[Sequence[int]],
    may_wait: Collection[int] = (),
    stands_s: Mapping[tuple[int, int], float] | None = None,
) -> Pieces:
    """Cut a plan into pieces.

    Parameters
    ----------
    stretches : sequence of Driven
        Of the plan.
    ways : sequence of sequence of int, (N, ...)
        The stretches of each vehicle.
    may_wait : collection of int
        Stretches before which their vehicles may wait though nobody joins.
    stands_s : mapping of (int, int) to float, optional
        By vehicle and stretch, how long it stands at least before the stretch, on its way [s].

    Returns
    -------
    Pieces
        One a stretch.
    """
    before: list[dict[int, float]] = [{} for _ in stretches]
    begins: list[list[int]] = [[] for _ in stretches]
    for index, way in enumerate(ways):
        begins[way[0]].append(index)
        for last, stretch in pairwise(way):
            stands = (stands_s or {}).get((index, stretch), 0.0)
            before[stretch][last] = max(before[stretch].get(last, 0.0), stands)
    ordered = list(
        TopologicalSorter({k: sorted(last) for k, last in enumerate(before)}).static_order()
    )
    place = {stretch: rank for rank, stretch in enumerate(ordered)}
    made: list[Piece] = []
    for stretch in ordered:
        come_from = {place[last]: before[stretch][last] for last in sorted(before[stretch])}
        own = stretch in may_wait
        made.append(_piece(stretches[stretch], come_from, begins[stretch], made, own))
    return Pieces(
        tuple(made),
        tuple(tuple(place[stretch] for stretch in way) for way in ways),
        linked([stretch.vehicles for stretch in stretches], len(ways)),
    )


def _piece(
    stretch: Driven,
    come_from: Mapping[int, float],
    begins: Sequence[int],
    made: Sequence[Piece],
    own_start: bool,
) -> Piece:
    company = frozenset(stretch.vehicles)
    root, offset = len(made), 0.0
    before = tuple(come_from)
    if not own_start and len(before) == 1 and not begins and company <= made[before[0]].company:
        last = made[before[0]]
        root, offset = last.root, last.offset_s + last.time_s + come_from[before[0]]
    return Piece(
        company, stretch.drive_s, before, tuple(begins), root, offset, tuple(come_from.values())
    )
