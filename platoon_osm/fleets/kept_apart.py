"""Vehicles that must not drive together: who they are by number, and whether a plan keeps to it."""

from __future__ import annotations

import itertools
from collections.abc import Iterable, Sequence
from copy import copy
from typing import Self

import numpy as np
from numpy.typing import NDArray

from .exact import Ways

__all__ = ["Apart"]

Ints = NDArray[np.int64]


class Apart:
    """Pairs of trucks that must not drive together.

    Parameters
    ----------
    names : sequence of str, (N,)
        The trucks.
    pairs : sequence of (str, str)
        Names; those without a truck do not count.
    """

    def __init__(self, names: Sequence[str], pairs: Sequence[tuple[str, str]]) -> None:
        place = {name: k for k, name in enumerate(names)}
        self.pairs = sorted(
            {
                (min(place[a], place[b]), max(place[a], place[b]))
                for a, b in pairs
                if a in place and b in place
            }
        )
        self._trucks = len(names)

    def also(self, groups: Iterable[Sequence[int]]) -> Self:
        """Return the same pairs and all of some groups.

        Parameters
        ----------
        groups : iterable of sequence of int
            Trucks; those of one group must not drive together.

        Returns
        -------
        Apart
            Another object.
        """
        found = copy(self)
        added = {pair for group in groups for pair in itertools.combinations(sorted(group), 2)}
        found.pairs = sorted({*self.pairs, *added})
        return found

    def __bool__(self) -> bool:
        return bool(self.pairs)

    @property
    def rows(self) -> tuple[Ints, Ints] | None:
        """Where those of each truck begin, (N + 1,), and who they are; None if there are none."""
        if not self.pairs:
            return None
        both = sorted([*self.pairs, *((b, a) for a, b in self.pairs)])
        first = np.searchsorted([a for a, _ in both], np.arange(self._trucks + 1))
        return first.astype(np.int64), np.array([b for _, b in both], np.int64)

    def kept_by(self, ways: Ways) -> bool:
        """Tell whether a plan keeps them apart.

        Parameters
        ----------
        ways : Ways
            Lanes of each truck, and when it enters them [ticks].

        Returns
        -------
        bool
            Whether no two of a pair enter a lane at one instant.
        """
        lanes, departs = ways

        def entries(k: int) -> set[tuple[int, int]]:
            return set(zip(lanes[k].tolist(), departs[k].tolist(), strict=True))

        return all(entries(a).isdisjoint(entries(b)) for a, b in self.pairs)
