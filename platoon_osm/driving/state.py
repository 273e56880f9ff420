"""What a driver has behind it when a trip starts: driven, worked and rested."""

from __future__ import annotations

import difflib
from collections.abc import Mapping
from dataclasses import dataclass, fields
from typing import Any

from ..errors import ScenarioError, brief
from ..kinds import is_number, is_whole

__all__ = ["RESTED", "STATE_KEYS", "DriverState", "state_of"]

HOURS = {
    "driven_since_break_s": 24, "driven_today_s": 24, "duty_s": 30, "driven_this_week_s": 168,
    "driven_last_week_s": 168, "since_weekly_rest_s": 14 * 24,
}  # fmt: skip
"""Of each time, more than this many hours is a mistake in the unit."""


@dataclass(frozen=True, slots=True, repr=False)
class DriverState:
    """The driver of a vehicle, or both of two alike, at the earliest departure of a trip.

    A trip that names no earliest departure has it at whatever moment the vehicle leaves. From then
    until it leaves the driver stands at the origin and is at rest.

    Attributes
    ----------
    driven_since_break_s : float
        Driving since the last break [s].
    first_part_taken : bool
        Whether the first part of a break was taken since.
    driven_today_s : float
        Driving since the last daily rest [s].
    duty_s : float or None
        How long ago that rest ended [s]; None for a driver whose rest ends when it leaves.
    driven_this_week_s, driven_last_week_s : float
        Driving in this calendar week, today's included, and in the one before [s].
    long_days_used : int
        Days of this week on which more than the usual was driven.
    reduced_rests_used : int
        Reduced daily rests since the last weekly rest.
    since_weekly_rest_s : float
        How long ago the last weekly rest ended [s].
    drivers : int
        1, or 2 who take turns.
    """

    driven_since_break_s: float = 0.0
    first_part_taken: bool = False
    driven_today_s: float = 0.0
    duty_s: float | None = None
    driven_this_week_s: float = 0.0
    driven_last_week_s: float = 0.0
    long_days_used: int = 0
    reduced_rests_used: int = 0
    since_weekly_rest_s: float = 0.0
    drivers: int = 1

    def __post_init__(self) -> None:
        for name, most in HOURS.items():
            value = getattr(self, name)
            if name == "duty_s" and value is None:
                continue
            if not (is_number(value) and 0 <= value <= most * 3600.0):
                raise ScenarioError(
                    f"driver: {name} is {brief(value)}; give seconds from 0 to {most} h"
                )
            object.__setattr__(self, name, float(value))
        if not isinstance(self.first_part_taken, bool):
            raise ScenarioError(
                f"driver: first_part_taken is {brief(self.first_part_taken)}; give true or false"
            )
        for name, low, high in (
            ("long_days_used", 0, 7), ("reduced_rests_used", 0, 7), ("drivers", 1, 2),
        ):  # fmt: skip
            count = getattr(self, name)
            if not (is_whole(count) and low <= count <= high):
                raise ScenarioError(
                    f"driver: {name} is {brief(count)}; give a whole number from {low} to {high}"
                )
        if self.duty_s is None and self.driven_today_s:
            # Who has driven today has been on duty at least as long.
            object.__setattr__(self, "duty_s", self.driven_today_s)
        chain = (
            ("driven_since_break_s", "driven_today_s"),
            ("driven_today_s", "duty_s"),
        )
        for small, large in chain:
            if getattr(self, small) > (getattr(self, large) or 0.0) + 1e-9:
                raise ScenarioError(
                    f"driver: {small} is more than {large}; give {large} at least as much"
                )

    def __repr__(self) -> str:
        """Return what differs from a rested driver alone."""
        told = [
            f"{item.name}={getattr(self, item.name)!r}"
            for item in fields(self)
            if getattr(self, item.name) != item.default
        ]
        return f"DriverState({', '.join(told)})"


RESTED = DriverState()
"""A driver after a weekly rest."""

_NAMES = tuple(item.name for item in fields(DriverState))

UNITS = {"_h": 3600.0, "_min": 60.0, "_s": 1.0}
"""Of times, by the end of their keys [s]."""

STATE_KEYS = tuple(
    key
    for name in _NAMES
    for key in ([name.removesuffix("_s") + unit for unit in UNITS] if name in HOURS else [name])
)
"""What a state may be told by: its fields, times in any of three units."""


def state_of(given: Any, where: str) -> DriverState:
    """Return the state of a driver from what was given.

    Parameters
    ----------
    given : DriverState or mapping
        The state, or its fields by name; of each time in seconds, `_h` or `_min` instead of `_s`
        gives it in hours or minutes.
    where : str
        Who asks, for messages.

    Returns
    -------
    DriverState
        The state.

    Raises
    ------
    ScenarioError
        A field that is none, or a value that cannot be.
    """
    if isinstance(given, DriverState):
        return given
    if not isinstance(given, Mapping):
        raise ScenarioError(f"{where}: driver is {brief(given)}; give a table of its state")
    found: dict[str, Any] = {}
    for key, value in given.items():
        if key not in STATE_KEYS:
            raise ScenarioError(f"{where}: driver has no {brief(key)}; {_hint(key)}")
        name, factor = _field(key)
        if name in found:
            raise ScenarioError(f"{where}: driver names {name} twice; give it once")
        if name in HOURS and value is not None:
            most = HOURS[name] * 3600.0 / factor
            if not (is_number(value) and 0 <= value <= most):
                raise ScenarioError(
                    f"{where}: driver {key} is {brief(value)}; give a number from 0 to {most:.0f}"
                )
            value = value * factor
        found[name] = value
    try:
        return DriverState(**found)
    except ScenarioError as error:
        raise ScenarioError(f"{where}: {error}") from None


def _field(key: str) -> tuple[str, float]:
    """Return the field that a key names, and the seconds of its unit."""
    stem, _, unit = key.rpartition("_")
    return (f"{stem}_s", UNITS[f"_{unit}"]) if f"{stem}_s" in HOURS else (key, 1.0)


def _hint(key: object) -> str:
    near = difflib.get_close_matches(str(key)[:60], STATE_KEYS, 1, 0.5)
    if near:
        return f"did you mean {near[0]!r}?"
    shown = [key for key in STATE_KEYS if not key.endswith(("_min", "_s"))]
    return f"known are {', '.join(shown)}"
