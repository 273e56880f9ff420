"""Why and where a vehicle stands between two of its legs, and who drives them."""

from __future__ import annotations

import math
from collections.abc import Collection, Mapping
from dataclasses import dataclass
from typing import Any

from ..driving.state import DriverState
from ..errors import ScenarioError, brief
from ..kinds import is_number, is_whole

__all__ = [
    "PLACE_KINDS", "PURPOSES", "DriverDay", "Pause", "PausePlace", "driver_from_dict", "is_break",
    "is_rest", "pause_from_dict",
]  # fmt: skip

PURPOSES = (
    "weekly_rest", "daily_rest", "reduced_daily_rest", "break", "second_part", "first_part",
    "change", "ban", "company",
)  # fmt: skip
"""What a pause may be for; where it serves several, in this order. "first_part" and "second_part"
are those of a break in two; at a "change" two drivers change seats; "ban" is a driving ban or the
hours of a road; "company" is waiting for others."""

PLACE_KINDS = ("services", "rest_area", "truck_parking", "parking", "fuel", "junction", "origin")
"""Where a pause may be; at a "junction" no parking is known."""


BREAKS = frozenset({"break", "first_part", "second_part"})


def is_rest(purposes: Collection[str]) -> bool:
    """Return whether a daily or weekly rest is among what a pause is for.

    Parameters
    ----------
    purposes : collection of str
        Of `PURPOSES`.

    Returns
    -------
    bool
        Reduced ones count.
    """
    return any(one.endswith("_rest") for one in purposes)


def is_break(purposes: Collection[str]) -> bool:
    """Return whether driving rules ask for a pause: as a break, a part of one, or a rest.

    Parameters
    ----------
    purposes : collection of str
        Of `PURPOSES`.

    Returns
    -------
    bool
        Not for a ban, company, or a change of drivers alone.
    """
    return is_rest(purposes) or not BREAKS.isdisjoint(purposes)


@dataclass(frozen=True, slots=True)
class PausePlace:
    """Where a vehicle stands.

    Attributes
    ----------
    name : str
        As people know it; empty if the map has none.
    kind : str
        Of `PLACE_KINDS`, or another kind of stop of the network.
    lon, lat : float
        Of the place itself [deg].
    beside_m : float
        How far it is from where the road is left [m].
    capacity : int or None
        Spaces for trucks; None where not known.
    """

    name: str
    kind: str
    lon: float
    lat: float
    beside_m: float = 0.0
    capacity: int | None = None

    @property
    def has_parking(self) -> bool:
        """Whether trucks are known to park there."""
        return self.kind not in ("junction", "origin")


@dataclass(frozen=True, slots=True)
class Pause:
    """A pause between two legs.

    Attributes
    ----------
    before : int
        The leg that follows it, counted from 0 along the vehicle's way.
    purposes : tuple of str
        Of `PURPOSES`, in that order; one or more.
    start_s, end_s : float
        When, in seconds from the start of the timetable.
    place : PausePlace or None
        Where; None where it is at a merging point on the road and nothing else is known.
    """

    before: int
    purposes: tuple[str, ...]
    start_s: float
    end_s: float
    place: PausePlace | None = None

    def __post_init__(self) -> None:
        times = (self.start_s, self.end_s)
        if not (is_whole(self.before) and self.before >= 0):
            raise ScenarioError(f"plan: a pause before leg {brief(self.before)}; plan again")
        if not self.purposes or any(one not in PURPOSES for one in self.purposes):
            raise ScenarioError(f"plan: a pause for {brief(self.purposes)}; plan again")
        if not all(is_number(at) and math.isfinite(at) for at in times) or times[1] < times[0]:
            raise ScenarioError("plan: a pause runs backwards; plan again")

    @property
    def duration_s(self) -> float:
        """How long it lasts [s]."""
        return self.end_s - self.start_s

    @property
    def is_rest(self) -> bool:
        """Whether a daily or weekly rest is taken."""
        return is_rest(self.purposes)

    @property
    def is_break(self) -> bool:
        """Whether the driving rules ask for it, as a break, a part of one, or a rest."""
        return is_break(self.purposes)


LONGEST_S = 1e10
"""Times of a plan lie within this of its start [s]."""


@dataclass(frozen=True, slots=True)
class DriverDay:
    """One driver of a vehicle.

    Attributes
    ----------
    state : DriverState
        What it has behind it.
    state_at_s : float
        When that holds [s].
    drives : tuple of int or None
        The legs that it drives; None for all.
    """

    state: DriverState
    state_at_s: float
    drives: tuple[int, ...] | None = None

    def __post_init__(self) -> None:
        if not (is_number(self.state_at_s) and abs(self.state_at_s) < LONGEST_S):
            raise ScenarioError(
                f"plan: a driver's state at {brief(self.state_at_s)}; give seconds, or plan again"
            )


def pause_from_dict(data: Mapping[str, Any]) -> Pause:
    """Rebuild a pause from plain JSON types.

    Parameters
    ----------
    data : mapping
        As `dataclasses.asdict` gives it.

    Returns
    -------
    Pause
        The same.

    Raises
    ------
    ScenarioError
        One that cannot be.
    """
    place = data.get("place")
    own = {**data, "purposes": tuple(data["purposes"])}
    return Pause(**{**own, "place": None if place is None else PausePlace(**place)})


def driver_from_dict(data: Mapping[str, Any]) -> DriverDay:
    """Rebuild a driver's day from plain JSON types.

    Parameters
    ----------
    data : mapping
        As `dataclasses.asdict` gives it.

    Returns
    -------
    DriverDay
        The same.

    Raises
    ------
    ScenarioError
        A state that cannot be.
    """
    drives = data.get("drives")
    return DriverDay(
        DriverState(**data["state"]),
        data["state_at_s"],
        None if drives is None else tuple(drives),
    )
