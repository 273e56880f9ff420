"""49 CFR 395.3, hours of service of drivers who carry property, as a planner sees it.

After 10 h off duty a driver may drive 11 h, and not beyond the 14th hour; after 8 h of driving 30
min without driving come first. There are no more than 70 h on duty in 8 days, which 34 h off duty
end. Two drivers with a sleeper berth are not planned, nor rest that is split 7 and 3 h; a plan
without them is legal, only later at times.
"""

from __future__ import annotations

from .limits import Limits

__all__ = ["US395"]

MIN, H = 60.0, 3600.0

US395 = Limits(
    spell_s=8 * H, break_s=30 * MIN,
    day_s=11 * H, long_day_s=11 * H, rest_s=10 * H, reduced_rest_s=10 * H,
    window_s=14 * H, long_window_s=14 * H, rest_in_window=False,
    week_s=70 * H, weekly_rest_s=34 * H, calendar_weeks=False,
)  # fmt: skip
"""Hours on duty fall out of the 8 days only by 34 h off duty here, so none is ever too much."""
