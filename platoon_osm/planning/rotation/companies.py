"""Companies in the order in which they drive: who comes in whose row, and who goes on in which.

A company is all road that the same vehicles drive one after the other, over as many stretches as
pauses have made of it. Whoever joins comes in at the back of the row that is there, whoever leaves
drops out of it. Where rows meet, that of the vehicle that was planned to lead stays in front.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from graphlib import TopologicalSorter
from itertools import pairwise

from ...plans.records import Stretch

__all__ = ["Company", "companies_of"]


@dataclass(frozen=True, slots=True)
class Company:
    """What the same vehicles drive together, one stretch after the other.

    Attributes
    ----------
    stretches : tuple of int
        In driving order.
    rows : tuple of tuple of int
        The vehicles by where they come from: of each company before, or one alone; that of the
        planned leader first.
    goes_on : frozenset of int
        Vehicles that drive on in another company.
    before : tuple of (int or None)
        For each of `rows`, the last stretch that it drove in company before; None for who drove
        alone, or starts here.
    """

    stretches: tuple[int, ...]
    rows: tuple[tuple[int, ...], ...]
    before: tuple[int | None, ...]
    goes_on: frozenset[int]


def companies_of(
    stretches: Sequence[Stretch], ways: Sequence[Sequence[int]]
) -> tuple[Company, ...]:
    """Return the companies of a plan.

    Parameters
    ----------
    stretches, ways : sequence
        Fields of `Plan`.

    Returns
    -------
    tuple of Company
        Each after those its vehicles come from.
    """
    after: dict[tuple[int, int], int] = {}
    before: dict[tuple[int, int], int] = {}
    earlier: dict[int, set[int]] = {number: set() for number in range(len(stretches))}
    for index, way in enumerate(ways):
        for first, second in pairwise(way):
            after[index, first] = second
            before[index, second] = first
            earlier[second].add(first)
    order = TopologicalSorter({k: sorted(own) for k, own in earlier.items()}).static_order()
    runs: dict[int, list[int]] = {}
    run_of: dict[int, int] = {}
    for number in order:
        if not stretches[number].together:
            continue
        come = {before.get((index, number)) for index in stretches[number].vehicles}
        last = come.pop()
        same = not come and last is not None
        if same and stretches[last].company == stretches[number].company:  # type: ignore[index]  # `same` says that there is one
            run_of[number] = run_of[last]  # type: ignore[index]  # likewise
            runs[run_of[number]].append(number)
        else:
            run_of[number] = number
            runs[number] = [number]
    left_m = _left_m(stretches, ways)
    found = []
    for first, run in runs.items():
        rows: dict[int, list[int]] = {}
        for index in stretches[first].vehicles:
            came = before.get((index, first))
            alone = came is None or not stretches[came].together
            rows.setdefault(-1 - index if alone else came, []).append(index)  # type: ignore[arg-type]
        leader = stretches[first].vehicles[0]
        # Of those who join one by one, who leaves first comes to lead first.
        keys = sorted(
            rows,
            key=lambda k: (
                leader not in rows[k],
                round(min(left_m[one, first] for one in rows[k])),
                rows[k],
            ),
        )
        goes_on = frozenset(
            index
            for index in stretches[run[-1]].vehicles
            if (index, run[-1]) in after and stretches[after[index, run[-1]]].together
        )
        found.append(
            Company(
                tuple(run),
                tuple(tuple(rows[key]) for key in keys),
                tuple(key if key >= 0 else None for key in keys),
                goes_on,
            )
        )
    return tuple(found)


def _left_m(
    stretches: Sequence[Stretch], ways: Sequence[Sequence[int]]
) -> dict[tuple[int, int], float]:
    """Return how far each vehicle drives on without a stretch alone, from each stretch on [m]."""
    found: dict[tuple[int, int], float] = {}
    for index, way in enumerate(ways):
        left = 0.0
        for number in reversed(way):
            stretch = stretches[number]
            left = left + stretch.length_m if stretch.together else 0.0
            found[index, number] = left
    return found
