"""A given way as the law sees it: points, what lies between them, and where one may rest.

Points are numbered 0 (the origin) to n (the destination); hop k leads from point k to k + 1 and is
driven without a stop. All times are whole seconds from one moment. Driving times are rounded up so
that their sums are whole: who keeps the law with them keeps it with the times themselves.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field, replace

import numpy as np
from numpy.typing import NDArray

from ....errors import ScenarioError
from ....plans.pauses import PURPOSES

__all__ = [
    "FREE", "NO_LIMIT", "LegalTrip", "PlannedPause", "Road", "joined_roads", "road_of",
    "stopping_where", "until", "without_bans",
]  # fmt: skip

IntArray = NDArray[np.int64]

FREE = -(2**60)
"""As a moment: none is given, the point is left when the search likes."""

NO_LIMIT = 2**60
"""As a stay: as long as one likes."""


@dataclass(frozen=True, slots=True, eq=False)
class Road:
    """A way of n hops between n + 1 points.

    Attributes
    ----------
    drive_s : int64 array, (n,)
        Driving time of each hop [s].
    clock_s : int64 array, (n,)
        What the driver's clock counts of it [s]: less where a follower is relieved.
    stay_s : int64 array, (n + 1,)
        The longest pause at each point [s]; 0 where there is no place for one, `NO_LIMIT` where it
        may be of any length. At the origin a vehicle may always stand.
    leave_s : int64 array, (n + 1,)
        The moment at which a point has to be left [s]; `FREE` where none is given. Before it the
        vehicle stands there, and this is a break or a rest as far as `stay_s` allows.
    forbidden_first : int64 array, (n + 1,)
        Where the intervals of each hop begin in `forbidden_s`.
    forbidden_s : int64 array, (m, 2)
        Open intervals of moments at which the hop may not be started [s]; of each hop disjoint and
        in order.
    """

    drive_s: IntArray
    clock_s: IntArray
    stay_s: IntArray
    leave_s: IntArray
    forbidden_first: IntArray
    forbidden_s: IntArray

    def __post_init__(self) -> None:
        n = len(self.drive_s)
        shapes = {
            "drive_s": (n,), "clock_s": (n,), "stay_s": (n + 1,), "leave_s": (n + 1,),
            "forbidden_first": (n + 1,), "forbidden_s": (len(self.forbidden_s), 2),
        }  # fmt: skip
        for name, shape in shapes.items():
            array = np.ascontiguousarray(getattr(self, name), dtype=np.int64)
            if array.shape != shape:
                raise ScenarioError(f"legal road: {name} has shape {array.shape}; give {shape}")
            array = array.copy() if array.flags.writeable else array
            array.setflags(write=False)
            object.__setattr__(self, name, array)
        if (self.drive_s < 0).any() or (self.clock_s < 0).any() or (self.stay_s < 0).any():
            raise ScenarioError("legal road: a time is negative; give 0 or more")

    @property
    def hops(self) -> int:
        """How many hops there are."""
        return len(self.drive_s)

    def forbidden(self, hop: int) -> IntArray:
        """Return when a hop may not be started.

        Parameters
        ----------
        hop : int
            Its position.

        Returns
        -------
        int64 array, (k, 2)
            Open intervals [s].
        """
        return self.forbidden_s[self.forbidden_first[hop] : self.forbidden_first[hop + 1]]


def road_of(
    drive_s: Sequence[int] | IntArray,
    stay_s: Sequence[int] | IntArray,
    *,
    clock_s: Sequence[int] | IntArray | None = None,
    leave_s: Sequence[int] | IntArray | None = None,
    forbidden: Sequence[Sequence[tuple[int, int]]] | None = None,
) -> Road:
    """Return a road from its hops.

    Parameters
    ----------
    drive_s : sequence of int, (n,)
        Driving time of each hop [s].
    stay_s : sequence of int, (n + 1,)
        The longest pause at each point [s].
    clock_s : sequence of int, (n,), optional
        What the driver's clock counts of each hop [s]; by default its driving time.
    leave_s : sequence of int, (n + 1,), optional
        When each point has to be left [s]; by default `FREE`.
    forbidden : sequence, (n,), optional
        For each hop the open intervals of moments at which it may not be started [s], disjoint and
        in order; by default none.

    Returns
    -------
    Road
        The same, as arrays.
    """
    drive = np.asarray(drive_s, dtype=np.int64)
    closed: Sequence[Sequence[tuple[int, int]]] = (
        [()] * len(drive) if forbidden is None else forbidden
    )
    counts = [len(one) for one in closed]
    return Road(
        drive,
        drive if clock_s is None else np.asarray(clock_s, dtype=np.int64),
        np.asarray(stay_s, dtype=np.int64),
        np.full(len(drive) + 1, FREE) if leave_s is None else np.asarray(leave_s, dtype=np.int64),
        np.concatenate([[0], np.cumsum(np.asarray(counts, dtype=np.int64))]),
        np.array([pair for one in closed for pair in one], dtype=np.int64).reshape(-1, 2),
    )


def joined_roads(parts: Sequence[Road]) -> Road:
    """Return roads that follow each other as one.

    Parameters
    ----------
    parts : sequence of Road
        In driving order; some of them have hops.

    Returns
    -------
    Road
        At a point where two meet the longer stay holds, and whichever moment is given.
    """
    some = [part for part in parts if part.hops]
    stay, leave = some[0].stay_s, some[0].leave_s
    for part in some[1:]:
        stay = np.concatenate([stay[:-1], np.maximum(stay[-1:], part.stay_s[:1]), part.stay_s[1:]])
        leave = np.concatenate(
            [leave[:-1], np.maximum(leave[-1:], part.leave_s[:1]), part.leave_s[1:]]
        )
    counts = [np.diff(part.forbidden_first) for part in some]
    return Road(
        np.concatenate([part.drive_s for part in some]),
        np.concatenate([part.clock_s for part in some]),
        stay,
        leave,
        np.concatenate([[0], np.cumsum(np.concatenate(counts))]),
        np.concatenate([part.forbidden_s for part in some]),
    )


@dataclass(frozen=True, slots=True)
class PlannedPause:
    """A pause at a point of a road.

    Attributes
    ----------
    point : int
        Where.
    start_s, end_s : int
        When [s].
    purposes : tuple of str
        What it is for, of `PURPOSES` and in their order.
    least_s : int
        How long it has to be for that [s].
    """

    point: int
    start_s: int
    end_s: int
    purposes: tuple[str, ...]
    least_s: int = 0

    def __post_init__(self) -> None:
        if not self.purposes or any(one not in PURPOSES for one in self.purposes):
            raise ScenarioError(f"legal trip: a pause for {self.purposes!r}; name its purposes")


@dataclass(frozen=True, slots=True)
class LegalTrip:
    """When a vehicle drives a road within the law.

    Attributes
    ----------
    departure_s, arrival_s : int
        When it leaves the origin and reaches the destination [s].
    pauses : tuple of PlannedPause
        In order. Standing at the origin before the departure is none of them.
    drives : tuple of int
        For two drivers, which of them (0 or 1) drives each hop; empty for one.
    """

    departure_s: int
    arrival_s: int
    pauses: tuple[PlannedPause, ...] = ()
    drives: tuple[int, ...] = field(default=())

    @property
    def duration_s(self) -> int:
        """How long it takes [s]."""
        return self.arrival_s - self.departure_s

    @property
    def paused_s(self) -> int:
        """How long the vehicle stands on the way [s]."""
        return sum(one.end_s - one.start_s for one in self.pauses)


def without_bans(road: Road) -> Road:
    """Return a road that is never closed.

    Parameters
    ----------
    road : Road
        With or without bans.

    Returns
    -------
    Road
        The same without.
    """
    first, none = np.zeros_like(road.forbidden_first), np.zeros((0, 2), dtype=np.int64)
    return replace(road, forbidden_first=first, forbidden_s=none)


def stopping_where(road: Road, trip: LegalTrip) -> Road:
    """Return a road with places only where a trip pauses.

    Parameters
    ----------
    road : Road
        What it drives.
    trip : LegalTrip
        The trip.

    Returns
    -------
    Road
        The same otherwise.
    """
    stay = np.zeros_like(road.stay_s)
    points = [pause.point for pause in trip.pauses]
    stay[points] = road.stay_s[points]
    return replace(road, stay_s=stay)


def until(road: Road, point: int) -> Road:
    """Return the part of a road up to a point.

    Parameters
    ----------
    road : Road
        The whole.
    point : int
        Where it ends.

    Returns
    -------
    Road
        Its first hops.
    """
    last = int(road.forbidden_first[point])
    return Road(
        road.drive_s[:point], road.clock_s[:point], road.stay_s[: point + 1],
        road.leave_s[: point + 1], road.forbidden_first[: point + 1], road.forbidden_s[:last],
    )  # fmt: skip
