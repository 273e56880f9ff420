"""What a set of driving rules allows, as numbers: the planner's whole knowledge of the law.

All rule sets that we know have one shape. Driving is cut into spells by breaks, spells into days by
daily rests, days into weeks by weekly rests; each has a longest driving time, and a day a longest
time from the end of one daily rest until driving ends. What a rule set does not have is infinite
or None.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, fields

from ..errors import ScenarioError, brief
from ..kinds import is_number, is_whole

__all__ = ["UNLIMITED", "Limits"]


@dataclass(frozen=True, slots=True)
class Limits:
    """What is allowed to a driver, or to two in one vehicle.

    Attributes
    ----------
    spell_s : float
        Driving without a break [s].
    break_s : float
        A break [s].
    parts_s : (float, float) or None
        The two parts in which a break may be taken instead, in this order [s].
    work_spell_s : float
        Work of any kind, driving included, without a pause of `work_pause_s` [s].
    work_pause_s : float
        What ends such a spell of work [s].
    day_s : float
        Driving between two daily rests [s].
    long_day_s : float
        The same on some days [s].
    long_days : int
        On how many days of a calendar week.
    rest_s : float
        A daily rest [s].
    reduced_rest_s : float
        A reduced one [s].
    reduced_rests : int
        How many may be reduced between two weekly rests.
    window_s : float
        From the end of a rest to the end of driving, if a full daily rest follows [s].
    long_window_s : float
        The same if a reduced one follows [s].
    rest_in_window : bool
        Whether that rest itself has to begin by then; if not, nothing is driven after it, which
        is one moment for both rests.
    week_s, fortnight_s : float
        Driving in a calendar week from Monday 0:00 UTC, and in two [s].
    weekly_rest_s : float
        A weekly rest [s]; inf where there is none.
    weekly_after_s : float
        When a weekly rest begins at the latest, after the end of the one before [s].
    change_s : float
        How long two drivers stand to change seats [s]; 0 for one driver. With it the driving times
        are those of the vehicle, and each of the two has half of them.
    beside_s : float
        How long one of two drivers sits beside the other for it to be a break, and how long the
        vehicle stands for a break of both [s].
    calendar_weeks : bool
        Whether a week ends on Sunday 24:00 UTC; if not, a weekly rest alone begins a new one.
    """

    spell_s: float = math.inf
    break_s: float = 0.0
    parts_s: tuple[float, float] | None = None
    work_spell_s: float = math.inf
    work_pause_s: float = 0.0
    day_s: float = math.inf
    long_day_s: float = math.inf
    long_days: int = 0
    rest_s: float = 0.0
    reduced_rest_s: float = 0.0
    reduced_rests: int = 0
    window_s: float = math.inf
    long_window_s: float = math.inf
    rest_in_window: bool = True
    week_s: float = math.inf
    fortnight_s: float = math.inf
    weekly_rest_s: float = math.inf
    weekly_after_s: float = math.inf
    change_s: float = 0.0
    beside_s: float = 0.0
    calendar_weeks: bool = True

    def __post_init__(self) -> None:
        for item in fields(self):
            value = getattr(self, item.name)
            if item.name == "parts_s":
                good = value is None or (len(value) == 2 and all(map(_is_time, value)))
            elif item.name in ("long_days", "reduced_rests"):
                good = is_whole(value) and value >= 0
            elif item.name in ("calendar_weeks", "rest_in_window"):
                good = isinstance(value, bool)
            else:
                good = _is_time(value)
            if not good:
                raise ScenarioError(f"driving rules: {item.name} is {brief(value)}; give 0 or more")
        if not self.rest_in_window and self.window_s != self.long_window_s:
            raise ScenarioError(
                "driving rules: window_s and long_window_s differ, but no rest has to begin within "
                "them; give them alike"
            )

    @property
    def limits_driving(self) -> bool:
        """Whether there is any limit at all."""
        return self != UNLIMITED


def _is_time(value: object) -> bool:
    return is_number(value) and value >= 0


UNLIMITED = Limits()
"""No rule at all."""
