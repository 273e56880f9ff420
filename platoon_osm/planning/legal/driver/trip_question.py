"""What is asked of one vehicle on a given way: its law, what its driver did before, its times."""

from __future__ import annotations

from dataclasses import dataclass

from ....driving.limits import Limits
from ....driving.state import DriverState
from .road import NO_LIMIT, Road

__all__ = ["TripQuestion"]


@dataclass(frozen=True, slots=True, eq=False)
class TripQuestion:
    """A vehicle on a way.

    Attributes
    ----------
    road : Road
        The way.
    limits : Limits
        The law; that of two drivers if `state.drivers` is 2.
    state : DriverState
        What the driver has behind it.
    state_at_s : int or None
        When that holds [s]: from then until it leaves, the driver is at rest at the origin. None
        if it holds whenever it leaves.
    earliest_s : int or None
        The earliest departure [s]; None if there is none, and an arrival is named.
    latest_s : int or None
        The latest departure [s].
    arrival_s : int or None
        The latest arrival [s].
    monday_s : int
        A Monday 0:00 UTC [s].
    """

    road: Road
    limits: Limits
    state: DriverState
    state_at_s: int | None
    earliest_s: int | None
    latest_s: int | None = None
    arrival_s: int | None = None
    monday_s: int = 0

    @property
    def last_s(self) -> int:
        """The latest departure, or a moment after all others [s]."""
        return NO_LIMIT if self.latest_s is None else self.latest_s
