"""How a vehicle really drives with a platoon: the fastest legal trip on its joint way.

The joint way of a member is its approach to node i, the master's way from there to node j with the
master's moments of leaving as appointments, and its way onward. Between i and j it stands only
where the platoon does; at i and j, and on its own ways, it may pause where there are places.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace

import numpy as np

from .one_driver import fastest
from .platoon_record import MASTER, Timetable
from .road import FREE, IntArray, LegalTrip, Road
from .star_times import OPEN_S, StarTimes, VehicleRules

__all__ = ["RoadTrips"]

WEEK_S = 7 * 24 * 3600

BEFORE_S = 48 * 3600
"""A member without any window leaves no earlier than its driving time and this before it meets."""


@dataclass(frozen=True, slots=True, eq=False)
class RoadTrips:
    """Answers `Real` questions by the fastest legal trip.

    Attributes
    ----------
    star : StarTimes
        The master and its members.
    approach, onward : callable
        From a member and a node of the master's route to the way of the one to the other, or back.
        Its driving time is that in `star`.
    """

    star: StarTimes
    approach: Callable[[int, int], Road]
    onward: Callable[[int, int], Road]

    def __call__(self, member: int, i: int, j: int, table: Timetable) -> LegalTrip | None:
        """Return the fastest legal trip; None if there is none."""
        star = self.star
        rules = star.rules if member == MASTER else star.member_rules[member]
        window = star.window if member == MASTER else star.windows[member]
        slack = table.slack_s
        road = self.joint(member, i, j, table)
        limits = rules.limits
        if slack:
            limits = replace(
                limits,
                window_s=max(0.0, limits.window_s + slack),
                long_window_s=max(0.0, limits.long_window_s + slack),
                weekly_after_s=max(0.0, limits.weekly_after_s + slack),
            )
            if self._weeks_matter(rules, road, table):
                if slack < 0:
                    return None
                limits = replace(
                    limits, week_s=np.inf, fortnight_s=np.inf, long_days=limits.long_days + 7
                )
        earliest = None if window.earliest_s <= -OPEN_S else window.earliest_s
        at_once = bool(road.leave_s[0] != FREE)
        latest = None
        if window.latest_s < OPEN_S:
            latest = window.latest_s + (slack if at_once and member != MASTER else 0)
        arrival = None
        if window.arrival_s < OPEN_S:
            arrival = window.arrival_s + (slack if member != MASTER else max(slack, 0))
        if earliest is None and arrival is None:
            first = table.departure_s if member == MASTER else int(table.leave_s[self._low(i)])
            earliest = first - int(road.drive_s.sum()) - BEFORE_S
        return fastest(
            road, limits, rules.state, rules.state_at_s, earliest, latest, arrival, star.monday_s
        )

    def joint(self, member: int, i: int, j: int, table: Timetable) -> Road:
        """Return the joint way, with the platoon's moments of leaving.

        Parameters
        ----------
        member : int
            Of the star, or `MASTER`.
        i, j : int
            Nodes of the master's route where it merges and separates.
        table : Timetable
            The master's; its slack moves what is closed from node i on.

        Returns
        -------
        Road
            First the hops of the approach, then those of the master's way, then those onward.
        """
        road = self.star.road
        if member == MASTER:
            leave = np.append(table.leave_s[:-1], FREE)
            closed = [self._closed(road, k, 0) for k in range(road.hops)]
            return _road(road.drive_s, road.drive_s, _standing(road.stay_s, table), leave, closed)
        low, high = self._low(i), self._low(j)
        before, after = self.approach(member, i), self.onward(member, j)
        shared = road.drive_s[low:high]
        counted = np.ceil(shared * (1.0 - self.star.relief) - 1e-6).astype(np.int64)
        stay = _standing(road.stay_s, table)[low : high + 1]
        stay[0] = max(road.stay_s[low], before.stay_s[-1])
        stay[-1] = max(road.stay_s[high], after.stay_s[0])
        closed = [
            *(self._closed(before, k, 0) for k in range(before.hops)),
            *(self._closed(road, k, table.slack_s) for k in range(low, high)),
            *(self._closed(after, k, table.slack_s) for k in range(after.hops)),
        ]
        return _road(
            np.concatenate([before.drive_s, shared, after.drive_s]),
            np.concatenate([before.clock_s, counted, after.clock_s]),
            np.concatenate([before.stay_s[:-1], stay, after.stay_s[1:]]),
            np.concatenate(
                [before.leave_s[:-1], table.leave_s[low:high], [FREE], after.leave_s[1:]]
            ),
            closed,
        )

    def road_to(self, member: int, node: int) -> Road:
        """Return the way of a member to a node of the master's route.

        Parameters
        ----------
        member, node : int
            Of the star.

        Returns
        -------
        Road
            As `approach` says.
        """
        return self.approach(member, node)

    def road_from(self, member: int, node: int) -> Road:
        """Return the way of a member on from a node of the master's route.

        Parameters
        ----------
        member, node : int
            Of the star.

        Returns
        -------
        Road
            As `onward` says.
        """
        return self.onward(member, node)

    def _low(self, node: int) -> int:
        return int(self.star.node_at[node])

    @staticmethod
    def _closed(road: Road, hop: int, later_s: int) -> IntArray:
        found = road.forbidden(hop)
        if not later_s or not len(found):
            return found
        found = found + np.array([later_s, 0])
        return _apart(found[found[:, 0] < found[:, 1]])

    def _weeks_matter(self, rules: VehicleRules, road: Road, table: Timetable) -> bool:
        """Whether a limit of the week might bind, or Monday lie within the trip."""
        limits, state = rules.limits, rules.state
        driven = float(road.clock_s.sum()) + state.driven_this_week_s
        share = 2 if limits.change_s else 1
        if driven > limits.week_s / share:
            return True
        if driven + state.driven_last_week_s > limits.fortnight_s / share:
            return True
        if not limits.calendar_weeks or not np.isfinite(limits.day_s):
            return False
        span = 2 * int(road.drive_s.sum()) + WEEK_S // 7
        low = (int(table.leave_s[0]) - span - self.star.monday_s) // WEEK_S
        high = (int(table.leave_s[-1]) + span - self.star.monday_s) // WEEK_S
        return bool(low != high)


def _standing(stay_s: IntArray, table: Timetable) -> IntArray:
    """Return how long one may stand at positions if one stands only with the platoon."""
    own = np.zeros(len(stay_s), np.int64)
    for position, _ in table.stops:
        own[position] = stay_s[position]
    return own


def _apart(intervals: IntArray) -> IntArray:
    """Join intervals that overlap."""
    found: list[list[int]] = []
    for begin, end in intervals.tolist():
        if found and begin < found[-1][1]:
            found[-1][1] = max(found[-1][1], end)
        else:
            found.append([begin, end])
    return np.array(found, np.int64).reshape(-1, 2)


def _road(
    drive: IntArray, clock: IntArray, stay: IntArray, leave: IntArray, closed: list[IntArray]
) -> Road:
    first = np.concatenate([[0], np.cumsum([len(one) for one in closed])]).astype(np.int64)
    some = np.concatenate([*closed, np.zeros((0, 2), np.int64)]).astype(np.int64)
    return Road(drive, clock, stay, leave, first, some)
