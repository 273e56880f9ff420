"""What a driver has behind it when its record begins."""

from __future__ import annotations

from dataclasses import dataclass

__all__ = ["RESTED", "DriverStart"]


@dataclass(frozen=True, slots=True)
class DriverStart:
    """A driver at the beginning of its record.

    Attributes
    ----------
    driven_since_break_s : int
        Driving since the last whole break [s].
    first_part_taken : bool
        Whether the first part of a break was taken since.
    driven_today_s : int
        Driving since the last daily rest [s].
    duty_s : int or None
        How long ago that rest ended [s]; None if it goes on when the record begins.
    driven_this_week_s, driven_last_week_s : int
        Driving in the calendar week in which the record begins, and in the one before [s]. Under
        US rules the first is the time on duty in the days before that still counts.
    long_days_used : int
        Days of more than 9 h of driving in that week.
    reduced_rests_used : int
        Reduced daily rests since the last weekly rest.
    since_weekly_rest_s : int
        How long ago the last weekly rest ended [s]; 0 if it goes on when the record begins.
    drivers : int
        1; 2 for each of two drivers in one vehicle.
    """

    driven_since_break_s: int = 0
    first_part_taken: bool = False
    driven_today_s: int = 0
    duty_s: int | None = None
    driven_this_week_s: int = 0
    driven_last_week_s: int = 0
    long_days_used: int = 0
    reduced_rests_used: int = 0
    since_weekly_rest_s: int = 0
    drivers: int = 1


RESTED = DriverStart()
"""A driver after a weekly rest."""
