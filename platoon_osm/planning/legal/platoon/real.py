"""How a vehicle really drives with a platoon: the fastest legal trip on its joint way.

The joint way of a member is its approach to node i, the master's way from there to node j with the
master's moments of leaving as appointments, and its way onward; a member that joins again drives
alone along the master's route between two such stretches. With the platoon it stands only where
that does; at i and j, and on its own ways, it may pause where there are places.

What is asked for a span of departures is answered by one trip whose limits are longer or shorter by
the span. All that moves with the departure lies between leaving i and the arrival. So what is
driven in a week is the same for the whole span unless a Monday lies between these.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field, replace

import numpy as np

from ....driving.limits import Limits
from ..driver.one_driver import fastest, least_late
from ..driver.road import FREE, IntArray, LegalTrip, Road, joined_roads
from ..driver.trip_question import TripQuestion
from .record import MASTER, Timetable
from .star_times import OPEN_S, StarTimes, VehicleRules

__all__ = ["RoadTrips", "Together"]

Together = tuple[int, int]
"""From which node of the master's route to which a member drives with it."""

WEEK_S = 7 * 24 * 3600

LOOSER_S = 86_400
"""A question about a span of departures that is no longer than this looks first at whether the
approach can be driven at all, with limits that are so much longer [s]."""

BEFORE_S = 3 * 86_400
"""A member that names no earliest departure leaves no earlier than this, and thrice the driving
time of its approach, before it merges [s]."""


@dataclass(frozen=True, slots=True, eq=False)
class RoadTrips:
    """Answers `Real` questions by the fastest legal trip, and tells the own ways of members.

    Attributes
    ----------
    star : StarTimes
        The master and its members.
    road_to, road_from : callable
        From a member and a node of the master's route to the way of the one to the other, or back.
        Its driving time is that in `star`.
    between : callable, optional
        From a member and two nodes of the master's route to the route as it drives it alone; by
        default as the master does.
    reached : dict
        When members reach nodes at the earliest, as far as that was asked, in questions about one
        departure or about the best of a span [s]; None for never.
    """

    star: StarTimes
    road_to: Callable[[int, int], Road]
    road_from: Callable[[int, int], Road]
    between: Callable[[int, int, int], Road] | None = None
    reached: dict[tuple[int, int, bool], int | None] = field(default_factory=dict)

    def __call__(self, member: int, i: int, j: int, table: Timetable) -> LegalTrip | None:
        """Return the fastest legal trip; None if there is none."""
        return self.master(table) if member == MASTER else self.trip(member, [(i, j)], table)

    def master(self, table: Timetable) -> LegalTrip | None:
        """Return the legal trip of the master.

        Parameters
        ----------
        table : Timetable
            Its moments; no hop is closed, and it is in time, at all departures that are asked for.

        Returns
        -------
        LegalTrip or None
            None if it cannot keep the law.
        """
        star, road, slack = self.star, self.star.road, table.slack_s
        leave = np.append(table.leave_s[:-1], FREE)
        closed = [road.forbidden(k) for k in range(road.hops)]
        road = _road(road.drive_s, road.drive_s, _standing(road.stay_s, table), leave, closed)
        leaves, arrival = int(leave[0]), star.window.arrival_s
        asked = TripQuestion(
            road, self._limits(star.rules, road, leaves, arrival, slack), star.rules.state,
            star.rules.state_at_s, leaves, leaves,
            None if arrival >= OPEN_S else arrival + max(slack, 0), star.monday_s,
        )  # fmt: skip
        trip = fastest(asked)
        moves = self._moves_weeks(star.rules, road, leaves, trip, slack)
        return None if moves else trip

    def trip(self, member: int, together: Sequence[Together], table: Timetable) -> LegalTrip | None:
        """Return the fastest legal trip of a member that drives with the master.

        Parameters
        ----------
        member : int
            Of the star.
        together : sequence of (int, int)
            Where it drives with the master, in driving order.
        table : Timetable
            The master's.

        Returns
        -------
        LegalTrip or None
            None if it cannot keep the law and its window that way.
        """
        star, slack = self.star, table.slack_s
        rules, window = star.member_rules[member], star.windows[member]
        merges = int(table.leave_s[self._low(together[0][0])])
        if self._is_late(member, together[0][0], merges, slack):
            return None
        road = self.joint(member, together, table)
        latest = window.latest_s
        if road.leave_s[0] != FREE:
            latest += slack  # it leaves its origin with the platoon, for all of the span
        asked = TripQuestion(
            road, self._limits(rules, road, merges, window.arrival_s, slack), rules.state,
            rules.state_at_s, self._earliest(member, together[0][0], merges),
            None if window.latest_s >= OPEN_S else latest,
            None if window.arrival_s >= OPEN_S else window.arrival_s + slack, star.monday_s,
        )  # fmt: skip
        trip = fastest(asked)
        return None if self._moves_weeks(rules, road, merges, trip, slack) else trip

    def _is_late(self, member: int, i: int, merges: int, slack: int) -> bool:
        """Tell whether a member cannot be at a node by a moment, whatever follows."""
        star, road = self.star, self.road_to(member, i)
        rules, window = star.member_rules[member], star.windows[member]
        if window.earliest_s <= -OPEN_S or slack > LOOSER_S or not road.hops:
            return False
        key = member, i, slack > 0
        if key not in self.reached:
            limits = rules.limits
            if slack > 0:
                limits = replace(
                    limits, window_s=limits.window_s + LOOSER_S, week_s=np.inf, fortnight_s=np.inf,
                    long_window_s=limits.long_window_s + LOOSER_S, long_days=limits.long_days + 7,
                    weekly_after_s=limits.weekly_after_s + LOOSER_S,
                )  # fmt: skip
            latest = None if window.latest_s >= OPEN_S else window.latest_s
            asked = TripQuestion(
                road, limits, rules.state, rules.state_at_s, window.earliest_s, latest,
                monday_s=star.monday_s,
            )  # fmt: skip
            self.reached[key] = least_late(asked)
        reached = self.reached[key]
        return reached is None or merges < reached

    def joint(self, member: int, together: Sequence[Together], table: Timetable) -> Road:
        """Return the joint way of a member, with the platoon's moments of leaving.

        Parameters
        ----------
        member : int
            Of the star.
        together : sequence of (int, int)
            Where it drives with the master, in driving order.
        table : Timetable
            The master's; its slack moves what is closed from the first of these nodes on.

        Returns
        -------
        Road
            The hops of the approach, of the master's way, and those onward.
        """
        road, last = self.star.road, None
        parts = [self.road_to(member, together[0][0])]
        for i, j in together:
            if last is not None:
                parts.append(_shifted(self._between(member, last, i), table.slack_s))
            low, high = self._low(i), self._low(j)
            stay = _standing(road.stay_s, table)[low : high + 1]
            # Who merges or separates may pause there, whether the platoon stands or not.
            stay[[0, -1]] = road.stay_s[[low, high]]
            leave = np.append(table.leave_s[low:high], FREE)
            parts.append(_shifted(self._shared(low, high, stay, leave), table.slack_s))
            last = j
        assert last is not None
        return joined_roads([*parts, _shifted(self.road_from(member, last), table.slack_s)])

    def _low(self, node: int) -> int:
        return int(self.star.node_at[node])

    def _earliest(self, member: int, i: int, merges: int) -> int:
        """Return when a member leaves at the earliest that merges at a moment."""
        earliest = self.star.windows[member].earliest_s
        if earliest > -OPEN_S:
            return earliest
        return merges - 3 * int(self.star.approach_s[member, i]) - BEFORE_S

    def _shared(self, low: int, high: int, stay: IntArray, leave: IntArray) -> Road:
        """Return a part of the master's way as a follower drives it."""
        road = self.star.road
        drive = road.drive_s[low:high]
        clock = np.ceil(drive * (1.0 - self.star.relief) - 1e-6).astype(np.int64)
        return _road(drive, clock, stay, leave, [road.forbidden(k) for k in range(low, high)])

    def _between(self, member: int, i: int, j: int) -> Road:
        """Return the master's route between two nodes, driven alone."""
        if self.between is not None:
            return self.between(member, i, j)
        road, low, high = self.star.road, self._low(i), self._low(j)
        drive = road.drive_s[low:high]
        closed = [road.forbidden(k) for k in range(low, high)]
        return _road(
            drive, drive, road.stay_s[low : high + 1], np.full(high - low + 1, FREE), closed
        )

    def _limits(
        self, rules: VehicleRules, road: Road, leaves: int, arrival: int, slack: int
    ) -> Limits:
        """Return limits for a span of departures, by when i is left and the latest arrival."""
        limits = rules.limits
        if not slack:
            return limits
        limits = replace(
            limits,
            window_s=max(0.0, limits.window_s + slack),
            long_window_s=max(0.0, limits.long_window_s + slack),
            weekly_after_s=max(0.0, limits.weekly_after_s + slack),
        )
        if slack < 0 or not self._over_monday(rules, road, leaves - slack, arrival + slack):
            return limits
        # Some of the driving may lie in either week, and a long day, too.
        return replace(limits, week_s=np.inf, fortnight_s=np.inf, long_days=limits.long_days + 7)

    def _moves_weeks(
        self, rules: VehicleRules, road: Road, leaves: int, trip: LegalTrip | None, slack: int
    ) -> bool:
        """Tell whether a trip that is to hold for a span might be too much for a week in it."""
        if trip is None or slack >= 0:
            return False
        return self._over_monday(rules, road, leaves, trip.arrival_s - slack)

    def _over_monday(self, rules: VehicleRules, road: Road, begin: int, end: int) -> bool:
        """Tell whether driving that moves over a Monday between two moments may be too much there.

        Who leaves later drives less before it and more after it: no more than in all, and on no
        more long days.
        """
        limits, monday = rules.limits, self.star.monday_s
        if not limits.calendar_weeks or not np.isfinite(limits.day_s):
            return False
        total = float(road.clock_s.sum())
        long_days = (rules.state.driven_today_s + total) / limits.day_s
        most = limits.week_s / (2 if limits.change_s else 1)
        if total <= min(most, limits.fortnight_s) and long_days <= limits.long_days + 1:
            return False
        return end >= OPEN_S or (begin - monday) // WEEK_S != (end - monday) // WEEK_S


def _standing(stay_s: IntArray, table: Timetable) -> IntArray:
    """Return how long one may stand at positions if one stands only with the platoon."""
    own = np.zeros(len(stay_s), np.int64)
    for position, _ in table.stops:
        own[position] = stay_s[position]
    return own


def _shifted(road: Road, later_s: int) -> Road:
    """Return a road whose closings begin later, and end when they do."""
    if not later_s or not len(road.forbidden_s):
        return road
    closed = []
    for hop in range(road.hops):
        some = road.forbidden(hop) + np.array([later_s, 0])
        closed.append(_apart(some[some[:, 0] < some[:, 1]]))
    return _road(road.drive_s, road.clock_s, road.stay_s, road.leave_s, closed)


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
