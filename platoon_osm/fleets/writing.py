"""When what is best so far is written, and what is kept of the limit for telling the plan.

Writing takes time from the search, so it may take no more than a small part of what has passed.
"""

from __future__ import annotations

from .phases import CROWD
from .stopping import Course

__all__ = ["A_TRUCK_WRITTEN_S", "Writing"]

PART, FIRST_PART = 0.05, 0.25
"""At most this share of the time goes into writing what is best so far, and in a crowd into the
first time."""

CLOSING, CLOSING_WRITTEN = 0.7, 1.1
"""What it takes to tell a plan, and to write it too, as a part of what modelling took: both go with
trucks and lanes. It is measured once something was written."""

A_TRUCK_S, A_TRUCK_WRITTEN_S = 0.65e-3, 0.95e-3
"""What it takes at least for each truck: given routes are modelled in no time, but told in as much
(measured for 20,000 on two cores) [s]."""


class Writing:
    """How long writing took so far, and what was written.

    Parameters
    ----------
    course : Course
        How far the search is; what is kept of its limit is noted in it.
    alone : int
        What all cost alone; a plan that costs no more is worth writing [grains].
    trucks : int
        How many there are; in a crowd the first time waits until it is worth it.
    wanted : bool
        Whether anything is written.
    """

    def __init__(self, course: Course, alone: int, trucks: int, wanted: bool) -> None:
        self._course, self._crowded, self._wanted = course, trucks >= CROWD, wanted
        self._spent_s = 0.0
        self._cost = alone + 1
        part, each = (CLOSING_WRITTEN, A_TRUCK_WRITTEN_S) if wanted else (CLOSING, A_TRUCK_S)
        course.closing_s = max(part * course.seconds, each * trucks)

    def is_due(self, cost: int, seconds: float) -> bool:
        """Tell whether a plan is written now.

        Parameters
        ----------
        cost : int
            What it costs [grains].
        seconds : float
            Since the search began [s].

        Returns
        -------
        bool
            Whether it is cheaper than what was written, and writing takes little of the time.
        """
        if not self._wanted or cost >= self._cost:
            return False
        if self._spent_s:
            return self._spent_s <= PART * seconds
        return not self._crowded or self._course.closing_s <= FIRST_PART * seconds

    def done(self, cost: int, since_s: float) -> None:
        """Note that a plan was written.

        Parameters
        ----------
        cost : int
            What it costs [grains].
        since_s : float
            When writing began, since the search did [s].
        """
        took = self._course.seconds - since_s
        self._spent_s += took
        self._course.closing_s = max(self._course.closing_s, took)
        self._cost = cost
