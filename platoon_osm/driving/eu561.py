"""Regulation (EC) 561/2006 with Directive 2002/15/EC, as a planner sees them.

Article 6 limits driving: 9 h a day, twice a calendar week 10 h, 56 h a week, 90 h in two. Article 7
asks for 45 min of break after 4 h 30 of driving, or for 15 and then 30 min. Article 8 asks for a
daily rest of 11 h within 24 h of the end of the last one, of 9 h up to three times between weekly
rests, and for a weekly rest of 45 h after six times 24 h at the latest. With two drivers, a daily
rest of 9 h lies within 30 h, and 45 min beside the one who drives are a break. The directive (art.
5) lets nobody work for more than 6 h without a pause.

Not planned, though the law has them: a daily rest in two parts, a weekly rest reduced to 24 h, and
driving on to reach a rest under article 12. A plan without them is legal, only later at times.
"""

from __future__ import annotations

import math

from .limits import Limits

__all__ = ["EU561", "EU561_TEAM"]

MIN, H = 60.0, 3600.0

CHANGE_MIN = 5.0
"""How long two drivers stand to change seats; the law names no time for it."""

EU561 = Limits(
    spell_s=4.5 * H, break_s=45 * MIN, parts_s=(15 * MIN, 30 * MIN),
    work_spell_s=6 * H, work_pause_s=15 * MIN,
    day_s=9 * H, long_day_s=10 * H, long_days=2,
    rest_s=11 * H, reduced_rest_s=9 * H, reduced_rests=3, window_s=13 * H, long_window_s=15 * H,
    week_s=56 * H, fortnight_s=90 * H, weekly_rest_s=45 * H, weekly_after_s=6 * 24 * H,
)  # fmt: skip

EU561_TEAM = Limits(
    spell_s=4.5 * H, break_s=CHANGE_MIN * MIN, parts_s=None,
    work_spell_s=math.inf,
    day_s=18 * H, long_day_s=20 * H, long_days=2,
    rest_s=9 * H, reduced_rest_s=9 * H, reduced_rests=0, window_s=21 * H, long_window_s=21 * H,
    week_s=112 * H, fortnight_s=180 * H, weekly_rest_s=45 * H, weekly_after_s=6 * 24 * H,
    change_s=CHANGE_MIN * MIN, beside_s=45 * MIN,
)  # fmt: skip
"""Of the vehicle, driven by two in turns: each drives half of it, while the other's 45 min beside
the wheel are its break."""
