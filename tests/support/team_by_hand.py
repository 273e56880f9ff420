"""Two drivers in one vehicle: whether a trip keeps the limits, and the best of all trips.

Written to be plain. Of each driver it is told what it has driven, and for how long it has not been
at the wheel; every way of reading the pauses, and every way of sharing the seats, is kept side by
side. Nothing here knows of labels that cover others, of pooled driving, nor of slack.
"""

from dataclasses import dataclass, replace

from platoon_osm.planning.legal.driver.road import FREE

WEEK = 7 * 24 * 3600

BESIDE_MORE = 5
"""How much longer than a break one sits beside the other for it to be one [s]."""


@dataclass(frozen=True)
class Person:
    """One of the two: at the wheel when `idle` is None."""

    driven: float
    idle: float
    rides: bool
    today: float
    long_days: int
    by_week: tuple


@dataclass(frozen=True)
class Crew:
    """Both, the one at the wheel first, if their pauses are read in one way."""

    wheel: Person
    beside: Person
    first: bool
    began: float
    reduced: int
    weekly_end: float
    long_week: int


@dataclass(frozen=True)
class Case:
    """A road under a law.

    `strict` counts of a stop only what the change of seats takes, or what completes a break: so a
    stop that lasts longer for a ban or an appointment helps nobody.
    """

    road: object
    limits: object
    state: object
    state_at: object
    monday: int
    strict: bool


def day_of(limits):
    return limits.day_s / 2, limits.long_day_s / 2


def crew_of(case, leaves):
    """Return both as the trip finds them; the one may take the wheel as well as the other."""
    state, limits = case.state, case.limits
    since = leaves if case.state_at is None else case.state_at
    week = (since - case.monday) // WEEK
    resting = state.duty_s is None
    began = leaves if resting else since - state.duty_s
    one = Person(
        state.driven_since_break_s, 0, False, state.driven_today_s,
        state.long_days_used + (state.driven_today_s > day_of(limits)[0]),
        ((week - 1, state.driven_last_week_s), (week, state.driven_this_week_s))
        if limits.calendar_weeks
        else ((0, state.driven_this_week_s),),
    )  # fmt: skip
    moved = resting and not state.since_weekly_rest_s
    crew = Crew(
        one, one, True, began, state.reduced_rests_used,
        (leaves if moved else since) - state.since_weekly_rest_s,
        ((leaves if resting else since) - case.monday) // WEEK,
    )  # fmt: skip
    if leaves == since:
        return {crew}
    return set(stopped(case, crew, since, leaves - since, origin=True))


def idle(case, person, more):
    """Return a person that has not driven for some time more."""
    total = person.idle + more
    least = case.limits.beside_s + (BESIDE_MORE if person.rides else 0)
    return replace(person, idle=total, driven=0 if total >= least else person.driven)


def stopped(case, crew, start, stands, origin=False):
    """Yield what a stop at a place may count as, and who drives on."""
    limits = case.limits
    yield crew
    wheel, beside = crew.wheel, crew.beside
    changes = stands >= limits.change_s and not origin
    if stands >= limits.beside_s:
        both = replace(crew, wheel=replace(wheel, driven=0), beside=replace(beside, driven=0))
        yield both
        if changes:
            yield swapped(both)
    if changes and not case.strict:
        yield swapped(replace(crew, wheel=idle(case, wheel, stands),
                              beside=idle(case, beside, stands)))  # fmt: skip
    if not case.strict and not origin:
        yield replace(crew, beside=idle(case, beside, stands))
    if changes and case.strict:
        missing = limits.beside_s + BESIDE_MORE - beside.idle
        for counted in (limits.change_s, missing):
            if limits.change_s <= counted <= stands:
                yield swapped(replace(crew, wheel=idle(case, wheel, counted),
                                      beside=idle(case, beside, counted)))  # fmt: skip
    for rested in rests(case, crew, start, stands):
        yield rested
        if changes:
            yield swapped(rested)


def swapped(crew):
    return replace(crew, wheel=crew.beside, beside=crew.wheel, first=not crew.first)


def rests(case, crew, start, stands):
    """Yield what follows if a stop is a daily or weekly rest."""
    limits = case.limits
    end = start + stands
    week = (end - case.monday) // WEEK

    def fresh(person):
        days = person.long_days if week == crew.long_week else 0
        return replace(person, driven=0, today=0, long_days=days)

    after = replace(
        crew, wheel=fresh(crew.wheel), beside=fresh(crew.beside), began=end, long_week=week
    )
    full = start - crew.began <= limits.window_s
    spare = start - crew.began <= limits.long_window_s and crew.reduced < limits.reduced_rests
    if stands >= limits.rest_s and full:
        yield after
    if stands >= limits.reduced_rest_s and spare:
        yield replace(after, reduced=crew.reduced + 1)
    in_time = start <= crew.weekly_end + limits.weekly_after_s
    if stands >= limits.weekly_rest_s and (full or spare) and in_time:
        if not limits.calendar_weeks:
            none = ((0, 0),)
            after = replace(after, wheel=replace(after.wheel, by_week=none),
                            beside=replace(after.beside, by_week=none))  # fmt: skip
        yield replace(after, reduced=0, weekly_end=end)


def driven(case, crew, leave, drive, clock):
    """Yield a crew after a hop, if it is allowed."""
    limits, wheel = case.limits, crew.wheel
    day, long_day = day_of(limits)
    end = leave + drive
    if wheel.driven + clock > limits.spell_s or wheel.today + clock > long_day:
        return
    if end > crew.weekly_end + limits.weekly_after_s:
        return
    days = wheel.long_days + (wheel.today + clock > day >= wheel.today)
    if wheel.today + clock > day and days > limits.long_days:
        return
    spare = crew.reduced < limits.reduced_rests
    if end - crew.began > (limits.long_window_s if spare else limits.window_s):
        return
    weeks = dict(wheel.by_week)
    if limits.calendar_weeks:
        first = (leave - case.monday) // WEEK
        over = max(0, end - case.monday - (first + 1) * WEEK)
        later = clock * over / drive
        weeks[first] = weeks.get(first, 0) + clock - later
        weeks[first + 1] = weeks.get(first + 1, 0) + later
    else:
        weeks = {0: sum(weeks.values()) + clock}
    for week, own in weeks.items():
        if own <= dict(wheel.by_week).get(week, 0):
            continue
        if own > limits.week_s / 2:
            return
        if limits.calendar_weeks and own + weeks.get(week - 1, 0) > limits.fortnight_s / 2:
            return
    moved = replace(
        wheel, driven=wheel.driven + clock, idle=0, rides=False, today=wheel.today + clock,
        long_days=days, by_week=tuple(sorted(weeks.items())),
    )  # fmt: skip
    yield replace(crew, wheel=moved, beside=idle(case, replace(crew.beside, rides=True), drive))


def after_stop(case, crews, hop, at, leave):
    """Return the crews that leave a point after they reached it."""
    road = case.road
    if road.leave_s[hop] != FREE and leave != road.leave_s[hop]:
        return set()
    if any(a < leave < b for a, b in road.forbidden(hop).tolist()):
        return set()
    stay = float(road.stay_s[hop])
    if hop == 0 or leave == at:
        return crews
    if leave - at > stay and road.leave_s[hop] == FREE:
        return set()
    counted = min(leave - at, stay)
    if not counted:
        return crews
    return {one for crew in crews for one in stopped(case, crew, at, counted)}


def after_hop(case, crews, hop, leave):
    drive, clock = int(case.road.drive_s[hop]), int(case.road.clock_s[hop])
    return {one for crew in crews for one in driven(case, crew, leave, drive, clock)}


def legal(case, trip):
    """Return whether a trip of the search keeps the law, with the drivers that it names."""
    road = case.road
    ends = {one.point: one.end_s for one in trip.pauses}
    at = trip.departure_s
    crews = crew_of(case, at)
    for hop in range(road.hops):
        leave = ends.get(hop, at) if hop else at
        crews = after_stop(case, crews, hop, at, leave)
        crews = {one for one in crews if one.first == (trip.drives[hop] == 0)}
        crews = after_hop(case, crews, hop, leave)
        at = leave + int(road.drive_s[hop])
    return bool(crews) and at == trip.arrival_s


def best_of_all(case, unit, earliest, latest, until, longest, aim):
    """Return departure and arrival of the best of all trips in steps of a unit, or None."""
    road, n = case.road, case.road.hops
    left = [int(road.drive_s[k:].sum()) for k in range(n + 1)]
    best = [None]

    def worth(leaves, arrives):
        return (arrives, -leaves) if aim == "arrive" else (-leaves, arrives)

    def onward(leaves, hop, at, crews):
        if hop == n:
            if best[0] is None or worth(leaves, at) < worth(*best[0]):
                best[0] = leaves, at
            return
        if road.leave_s[hop] != FREE:
            ends = [int(road.leave_s[hop])] if road.leave_s[hop] >= at else []
        else:
            ends = range(at, at + int(min(longest, road.stay_s[hop])) + 1, unit)
        for leave in [leaves] if hop == 0 else ends:
            arrives = leave + left[hop]
            if arrives > until or (best[0] and worth(leaves, arrives) >= worth(*best[0])):
                break
            later = after_hop(case, after_stop(case, crews, hop, at, leave), hop, leave)
            if later:
                onward(leaves, hop + 1, leave + int(road.drive_s[hop]), later)

    for leaves in range(earliest, int(min(latest, until)) + 1, unit):
        if leaves + left[0] <= until:
            onward(leaves, 0, leaves, crew_of(case, leaves))
    return best[0]
