"""What a label holds: a legal beginning of a trip up to a point, in whole numbers.

The time, driving since the last break and since the last daily rest, how long ago the duty period
began and how late that could have been, and so on.

Slack. Where a vehicle has to wait (an appointment, a ban), it could instead have left later or have
prolonged its last rest, which moves the beginning of the duty period. So labels hold besides that
beginning the latest moment to which it could be moved without any other change, and likewise for
the departure. A wait of w with a pause of q in it moves both by what is left of w, as far as they
go; each q is a label of its own. As elapsed times do not change when all is moved, labels are
compared in elapsed time and in the latest moment.
"""

from __future__ import annotations

__all__ = ["COLUMNS", "INFO"]

# Fields of a label.
TIME, BROKEN, PART, WORKED, TODAY, DUTY, DUTY_MOST, LONG_DAYS, REDUCED_USED = range(9)
WEEK_DRIVEN, LAST_WEEK, WEEK, WEEKLY_END, GONE, GONE_MOST, BESIDE = range(9, 16)
OTHER_TODAY, OTHER_LONG_DAYS, OTHER_WEEK, OTHER_LAST_WEEK, DUTY_WEEK = range(16, 21)
OTHER_BROKEN = 21
# Long days but today, and when to be here at the latest if all that follows is driving and pauses.
BEFORE, OTHER_BEFORE, ENDS = 22, 23, 24
COLUMNS = 25

# What is kept of how it came about: its parent, its kind of pause, when it might then leave, and
# how long it pauses at least.
PARENT, KIND, OPENS, CLOSES, LASTS = range(5)
INFO = 5

WEEK_S = 604_800

FAR = 2**50
"""No time is so long [s]."""
