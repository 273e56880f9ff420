"""Whether a finished trip keeps the limits, and all trips of a small road: written to be plain.

Every way of reading the pauses is kept side by side: each pause may count as anything for which it
is long enough, or as nothing. A trip is legal if one of the readings is. Nothing here knows of
labels that cover others, nor of slack.
"""

from dataclasses import dataclass, replace
from math import inf

from platoon_osm.planning.legal.driver.road import FREE

WEEK = 7 * 24 * 3600


@dataclass(frozen=True)
class Reading:
    """What a driver has behind it, if its pauses are read in one way."""

    driven: float
    part: bool
    today: float
    began: float
    long_days: int
    reduced: int
    weekly_end: float
    by_week: tuple
    long_week: int
    worked: float


def legal(road, limits, state, state_at, monday, trip):
    """Return whether a trip (departure, then for each inner point when it is reached and left) is.

    `trip` is a list of (arrival, departure) of the points 0 to n - 1; the arrival at the origin
    does not matter.
    """
    leaves = trip[0][1]
    since = leaves if state_at is None else state_at
    week = (since - monday) // WEEK
    resting = state.duty_s is None
    readings = {
        Reading(
            state.driven_since_break_s, state.first_part_taken, state.driven_today_s,
            leaves if resting else since - state.duty_s, state.long_days_used,
            state.reduced_rests_used,
            (leaves if resting and not state.since_weekly_rest_s else since)
            - state.since_weekly_rest_s,
            ((week - 1, state.driven_last_week_s), (week, state.driven_this_week_s))
            if limits.calendar_weeks
            else ((0, state.driven_this_week_s),),
            ((leaves if resting else since) - monday) // WEEK,
            state.driven_since_break_s,
        )
    }  # fmt: skip
    for hop, (at, leave) in enumerate(trip):
        if road.leave_s[hop] != FREE and leave != road.leave_s[hop]:
            return False
        if any(a < leave < b for a, b in road.forbidden(hop).tolist()):
            return False
        start = since if hop == 0 else at
        stands = leave - start
        stay = inf if hop == 0 else float(road.stay_s[hop])
        if stands > stay and road.leave_s[hop] == FREE:
            return False
        if stands:
            counted = min(stands, stay)
            readings = {
                one for old in readings for one in paused(old, start, counted, limits, monday)
            }
        drive, clock = int(road.drive_s[hop]), int(road.clock_s[hop])
        readings = {
            one
            for old in readings
            for one in driven(old, leave, drive, clock, limits, monday)
        }  # fmt: skip
        if not readings:
            return False
    return True


def paused(old, start, stands, limits, monday):
    """Yield what a pause may count as."""
    end = start + stands
    new = replace(old, worked=0) if stands >= limits.work_pause_s else old
    yield new
    if stands >= limits.break_s:
        yield replace(new, driven=0, part=False)
    if limits.parts_s is not None:
        if stands >= limits.parts_s[0] and old.driven > 0:
            yield replace(new, part=True)
        if stands >= limits.parts_s[1] and old.part:
            yield replace(new, driven=0, part=False)
    fresh = replace(
        new, driven=0, part=False, today=0, began=end, worked=0, long_week=(end - monday) // WEEK,
        long_days=old.long_days if (end - monday) // WEEK == old.long_week else 0,
    )  # fmt: skip
    due = limits.rest_in_window
    full = not due or start - old.began <= limits.window_s
    spare = start - old.began <= limits.long_window_s or not due
    spare = spare and old.reduced < limits.reduced_rests
    if stands >= limits.rest_s and full:
        yield fresh
    if stands >= limits.reduced_rest_s and spare:
        yield replace(fresh, reduced=old.reduced + 1)
    in_time = start <= old.weekly_end + limits.weekly_after_s
    if stands >= limits.weekly_rest_s and (full or spare) and in_time:
        by_week = old.by_week if limits.calendar_weeks else ((0, 0),)
        yield replace(fresh, reduced=0, weekly_end=end, by_week=by_week)


def driven(old, leave, drive, clock, limits, monday):
    """Yield what is left of a reading after a hop, if it is allowed."""
    end = leave + drive
    new = replace(
        old, driven=old.driven + clock, today=old.today + clock, worked=old.worked + drive
    )
    if new.driven > limits.spell_s or new.worked > limits.work_spell_s:
        return
    if new.today > limits.long_day_s or end > old.weekly_end + limits.weekly_after_s:
        return
    if new.today > limits.day_s >= old.today:
        new = replace(new, long_days=old.long_days + 1)
        if new.long_days > limits.long_days:
            return
    elapsed = end - old.began
    spare = old.reduced < limits.reduced_rests
    if elapsed > limits.long_window_s or (elapsed > limits.window_s and not spare):
        return
    weeks = dict(old.by_week)
    if limits.calendar_weeks:
        first = (leave - monday) // WEEK
        monday_next = monday + (first + 1) * WEEK
        before = clock if end <= monday_next else clock * (monday_next - leave) / drive
        weeks[first] = weeks.get(first, 0) + before
        weeks[first + 1] = weeks.get(first + 1, 0) + clock - before
    else:
        weeks = {0: sum(weeks.values()) + clock}
    now = {week for week, own in weeks.items() if own > dict(old.by_week).get(week, 0)}
    if any(weeks[week] > limits.week_s for week in now):
        return
    if limits.calendar_weeks and any(
        weeks[week] + weeks.get(week - 1, 0) > limits.fortnight_s for week in now
    ):
        return
    yield replace(new, by_week=tuple(sorted(weeks.items())))


def trips(road, unit, earliest, latest, arrival, longest):
    """Yield every trip in steps of a unit that arrives in time, as `legal` takes it."""
    n = len(road.drive_s)
    left = [int(road.drive_s[k:].sum()) for k in range(n + 1)]

    def onward(hop, begun):
        if hop == n:
            yield begun
            return
        at = begun[-1][1] + int(road.drive_s[hop - 1])
        if road.leave_s[hop] != FREE:
            ends = [int(road.leave_s[hop])] if road.leave_s[hop] >= at else []
        else:
            ends = range(at, at + min(longest, int(road.stay_s[hop])) + 1, unit)
        for end in ends:
            if end + left[hop] <= arrival:
                yield from onward(hop + 1, [*begun, (at, end)])

    for leaves in range(earliest, latest + 1, unit):
        if leaves + left[0] <= arrival:
            yield from onward(1, [(leaves, leaves)])


def as_list(road, trip):
    """Return a trip of the search as `legal` takes it."""
    ends = {one.point: one.end_s for one in trip.pauses}
    starts = {one.point: one.start_s for one in trip.pauses}
    found = [(trip.departure_s, trip.departure_s)]
    for hop in range(1, len(road.drive_s)):
        at = found[-1][1] + int(road.drive_s[hop - 1])
        assert starts.get(hop, at) == at
        found.append((at, ends.get(hop, at)))
    assert found[-1][1] + int(road.drive_s[-1]) == trip.arrival_s
    return found
