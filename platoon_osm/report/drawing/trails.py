"""Lines that meet made into fewer and longer ones: the same drawing in less text.

Every line of a background costs a beginning, and a network has a line between each two junctions.
Where lines meet, those two that go on straightest are joined, then the next two of the others. All
points stay where they are, so nothing is drawn otherwise.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterator, Sequence
from itertools import combinations

import numpy as np
from numpy.typing import NDArray

__all__ = ["trails"]

Points = NDArray[np.int64]
End = tuple[int, bool]
"""A line and whether its last point is meant, or else its first."""


def trails(lines: Sequence[Points]) -> list[Points]:
    """Return lines joined where they meet.

    Parameters
    ----------
    lines : sequence of array of int, (k, 2)
        Longitude and latitude in steps; two points at least, else they stay as they are.

    Returns
    -------
    list of array of int
        Each piece of the given lines once, in one direction or the other.
    """
    mates = _mates(lines)
    used: set[int] = set()
    # From ends that go on nowhere first; what is left goes round.
    starts = [
        (line, last)
        for line in range(len(lines))
        for last in (False, True)
        if (line, last) not in mates
    ]
    starts += [(line, False) for line in range(len(lines))]
    return [
        np.concatenate(list(_walk(lines, mates, start, used)))
        for start in starts
        if start[0] not in used
    ]


def _mates(lines: Sequence[Points]) -> dict[End, End]:
    """Return which end each end goes on to."""
    meeting: dict[tuple[int, ...], list[End]] = defaultdict(list)
    for line, points in enumerate(lines):
        for last in (False, True):
            if len(points) > 1:
                meeting[tuple(points[-1 if last else 0].tolist())].append((line, last))
    found: dict[End, End] = {}
    for ends in meeting.values():
        ways = {end: _heading(lines[end[0]], end[1]) for end in ends}
        pairs = [(a, b) for a, b in combinations(ends, 2) if a[0] != b[0]]
        for a, b in sorted(pairs, key=lambda pair: (float(ways[pair[0]] @ ways[pair[1]]), pair)):
            if a not in found and b not in found:
                found[a], found[b] = b, a
    return found


def _heading(points: Points, last: bool) -> NDArray[np.float64]:
    """Return the direction, of length 1, in which a line leaves one of its ends."""
    away = points[-2] - points[-1] if last else points[1] - points[0]
    found: NDArray[np.float64] = away / max(float(np.hypot(*away)), 1.0)
    return found


def _walk(
    lines: Sequence[Points], mates: dict[End, End], start: End, used: set[int]
) -> Iterator[Points]:
    """Yield a line from one of its ends, then what it goes on to; each meeting point once."""
    end: End | None = start
    first = True
    while end is not None and end[0] not in used:
        line, last = end
        used.add(line)
        points = lines[line][::-1] if last else lines[line]
        yield points if first else points[1:]
        first = False
        end = mates.get((line, not last))
