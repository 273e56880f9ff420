"""A law of few seconds, drawn stars, and every way to drive them: an oracle for platoons.

Nothing here bounds, sorts or dominates: states are carried from point to point in sets, with every
whole second of standing at places.
"""

import itertools
from dataclasses import dataclass

import numpy as np

from platoon_osm.driving.limits import Limits
from platoon_osm.driving.state import DriverState
from platoon_osm.planning.legal.driver.road import NO_LIMIT, LegalTrip, road_of
from platoon_osm.planning.legal.platoon.star_times import NEVER_S, Span, StarTimes, VehicleRules

SMALL = Limits(
    spell_s=6, break_s=3, parts_s=(1, 2), day_s=11, long_day_s=13, long_days=1, rest_s=9,
    reduced_rest_s=7, reduced_rests=1, window_s=19, long_window_s=22,
)  # fmt: skip
NO_PARTS = Limits(
    spell_s=7, break_s=2, day_s=12, long_day_s=12, rest_s=8, reduced_rest_s=8, window_s=17,
    long_window_s=17,
)  # fmt: skip


@dataclass(frozen=True)
class Way:
    """Hops, how long one may stand at their ends, when these have to be left, what is closed."""

    drive: tuple
    clock: tuple
    stay: tuple
    leave: tuple
    closed: tuple = ()


def drivable(way, rules, window, slack=0, monday=None):
    """Whether a way can be driven: every departure, every whole second of standing.

    With the moment at which the second week begins, driving of both weeks is counted, too.
    """
    limits, state = rules.limits, rules.state
    late = window.arrival_s + slack
    sure, long_window = limits.window_s + slack, limits.long_window_s + slack
    begin = window.earliest_s
    duty = None if state.duty_s is None else begin - int(state.duty_s)
    start = (
        begin, int(state.driven_since_break_s), int(state.first_part_taken),
        int(state.driven_today_s), duty, state.long_days_used, state.reduced_rests_used,
        int(state.driven_this_week_s), 0, begin - int(state.since_weekly_rest_s),
    )  # fmt: skip
    last_week = int(state.driven_last_week_s)

    def new_week(old, new):
        """Whether a duty period that begins at `new` counts in a later week than one at `old`."""
        return monday is not None and old < monday <= new

    def in_weeks(leaves, drive, clock, this, after):
        """Return what is driven of both weeks after a hop."""
        if monday is None or leaves + drive <= monday:
            return this + clock, after
        if leaves >= monday:
            return this, after + clock
        before = -(-clock * (monday - leaves) // drive)
        return this + before, after + clock - clock * (monday - leaves) // drive

    def paused(now, leaves, counts):
        """Every way to count a pause."""
        time, broken, part, today, duty, long_days, reduced, *weeks = now
        since = begin if duty is None else max(begin, duty)
        fresh = 0 if new_week(since, leaves) else long_days
        length = min(leaves - time, counts)
        yield (leaves, broken, part, today, duty, long_days, reduced, *weeks)
        if limits.parts_s and length >= limits.parts_s[0] and broken > 0:
            yield (leaves, broken, 1, today, duty, long_days, reduced, *weeks)
        if length >= limits.break_s or (limits.parts_s and part and length >= limits.parts_s[1]):
            yield (leaves, 0, 0, today, duty, long_days, reduced, *weeks)
        on_duty = 0 if duty is None else time - duty
        if length >= limits.rest_s and on_duty <= sure:
            yield (leaves, 0, 0, 0, leaves, fresh, reduced, *weeks)
        if (
            length >= limits.reduced_rest_s
            and on_duty <= long_window
            and reduced < limits.reduced_rests
        ):
            yield (leaves, 0, 0, 0, leaves, fresh, reduced + 1, *weeks)
        if length >= limits.weekly_rest_s:
            yield (leaves, 0, 0, 0, leaves, fresh, 0, *weeks[:2], leaves)

    left = list(itertools.accumulate(reversed(way.drive), initial=0))[::-1]
    found = {start}
    for k in range(len(way.drive)):
        after = set()
        for now in found:
            time = now[0]
            if way.leave[k] is not None:
                moments = [way.leave[k]] if way.leave[k] >= time else []
                if k == 0 and way.leave[k] > window.latest_s + slack:
                    moments = []
            else:
                last = min(late - left[k], window.latest_s if k == 0 else late)
                moments = range(time, last + 1) if k == 0 or way.stay[k] else [time]
            if way.closed:
                shut = way.closed[k]
                moments = [one for one in moments if not any(a < one < b for a, b in shut)]
            for leaves in moments:
                counts = NO_LIMIT if k == 0 else way.stay[k]
                for gone in paused(now, leaves, counts):
                    _, broken, part, today, duty, long_days, reduced, *weeks = gone
                    this, after_it, rested = weeks
                    if duty is None:
                        duty = leaves
                        long_days = 0 if new_week(begin, leaves) else long_days
                        rested = rested if state.since_weekly_rest_s else leaves
                    this, after_it = in_weeks(leaves, way.drive[k], way.clock[k], this, after_it)
                    if max(this, after_it) > limits.week_s or (
                        max(last_week + this, this + after_it) > limits.fortnight_s
                    ):
                        continue
                    broken, day = broken + way.clock[k], today + way.clock[k]
                    ends = leaves + way.drive[k]
                    if ends - rested > limits.weekly_after_s:
                        continue
                    if broken > limits.spell_s or day > limits.long_day_s:
                        continue
                    if day > limits.day_s >= today:
                        long_days += 1
                        if long_days > limits.long_days:
                            continue
                    on_duty = ends - duty
                    spent = reduced >= limits.reduced_rests
                    if on_duty > long_window or (on_duty > sure and spent):
                        continue
                    if ends + left[k + 1] <= late:
                        weeks = this, after_it, rested
                        after.add((ends, broken, part, day, duty, long_days, reduced, *weeks))
        found = after
    return bool(found)


@dataclass
class Drawn:
    """A star and the real ways of its members."""

    star: StarTimes
    approach: list
    onward: list
    alone: list
    monday: int | None = None

    def way(self, member, i, j, table):
        """The joint way of a member."""
        star = self.star
        low, high = int(star.node_at[i]), int(star.node_at[j])
        if member < 0:
            low, high = 0, star.road.hops
            before = after = ((), (0,))
        else:
            before, after = self.approach[member][i], self.onward[member][j]
        drive = tuple(star.road.drive_s[low:high].tolist())
        share = 0.0 if member < 0 else star.relief
        clock = tuple(int(np.ceil(one * (1 - share))) for one in drive)
        leave = table.leave_s[low:high].tolist()
        own = star.road.stay_s.tolist()
        stops = dict(table.stops)
        inner = [own[k] if k in stops else 0 for k in range(low + 1, high)]
        ends = [] if low == high else [max(own[low], before[1][-1]), *inner]
        last = max(own[high], after[1][0])
        return Way(
            (*before[0], *drive, *after[0]),
            (*before[0], *clock, *after[0]),
            (*before[1][:-1], *ends, last, *after[1][1:]),
            (*[None] * len(before[0]), *leave, *[None] * (len(after[0]) + 1)),
        )

    def real(self, member, i, j, table):
        """What the search asks."""
        star = self.star
        rules = star.rules if member < 0 else star.member_rules[member]
        window = star.window if member < 0 else star.windows[member]
        way = self.way(member, i, j, table)
        if drivable(way, rules, window, table.slack_s, self.monday):
            return LegalTrip(window.earliest_s, window.arrival_s)
        return None

    def trip(self, member, stretches, table):
        """Whether a member can drive several stretches with the master, alone between them."""
        star = self.star
        own = star.road.stay_s.tolist()
        stops = dict(table.stops)
        before = self.approach[member][stretches[0][0]]
        after = self.onward[member][stretches[-1][1]]
        drive, clock = [*before[0]], [*before[0]]
        stay, leave = [*before[1]], [None] * len(before[0])
        last = None
        for i, j in stretches:
            low, high = int(star.node_at[i]), int(star.node_at[j])
            for k in range(low if last is None else last, high):
                alone = k < low
                hop = int(star.road.drive_s[k])
                drive.append(hop)
                clock.append(hop if alone else int(np.ceil(hop * (1 - star.relief))))
                stay[-1] = max(stay[-1], own[k] if alone or k == low or k in stops else 0)
                if last is not None and k == last:
                    stay[-1] = own[k]
                leave.append(None if alone else int(table.leave_s[k]))
                stay.append(0)
            last = high
        stay[-1] = max(own[last], after[1][0])
        way = Way(
            (*drive, *after[0]), (*clock, *after[0]), (*stay, *after[1][1:]),
            (*leave, *[None] * (len(after[0]) + 1)),
        )  # fmt: skip
        window = star.windows[member]
        if drivable(way, star.member_rules[member], window, monday=self.monday):
            return LegalTrip(window.earliest_s, window.arrival_s)
        return None

    def road_to(self, member, i):
        """What the search asks of a member's way to a node."""
        hops, stay = self.approach[member][i]
        return road_of(hops, stay)

    def road_from(self, member, j):
        """What it asks of the way on."""
        hops, stay = self.onward[member][j]
        return road_of(hops, stay)

    def goes_alone(self, member):
        """Whether a member can drive alone."""
        drive, stay = self.alone[member]
        way = Way(drive, drive, stay, (None,) * len(stay))
        return drivable(way, self.star.member_rules[member], self.star.windows[member])


def cut(rng, seconds, everywhere):
    """Cut a way into hops, with places between some of them."""
    hops = [1] * seconds
    stay = [NO_LIMIT if everywhere or rng.random() < 0.5 else 0 for _ in range(seconds + 1)]
    return tuple(hops), tuple(stay)


def drawn(seed, *, members=2, everywhere=False, limits=SMALL, relief=0.0, night=False, wide=False):
    """Draw a star."""
    rng = np.random.default_rng(seed)
    hops = int(rng.integers(5, 8)) if wide else int(rng.integers(4, 7))
    drive = rng.integers(2, 6, hops) if night else rng.integers(1, 4, hops)
    stay = np.where(rng.random(hops + 1) < 0.7, NO_LIMIT, 0)
    if night and not stay[1:-1].any():
        stay[len(stay) // 2] = NO_LIMIT
    node_at = np.flatnonzero(rng.random(hops + 1) < 0.7)
    if wide:
        node_at = np.arange(hops + 1)
    if len(node_at) < 2:
        node_at = np.array([0, hops])
    total = int(drive.sum())
    nodes = len(node_at)
    tau = np.concatenate([[0], np.cumsum(drive)])[node_at]
    platoon = 0.6 * (tau - tau[0])
    shape = (members, nodes)
    approach = rng.integers(0, 7, shape)
    onward = rng.integers(0, 7, shape)
    alone_s = rng.integers(8, 14, members)
    closed = rng.random(shape) < 0.1
    approach = np.where(closed, NEVER_S, approach)
    entry = np.where(closed, np.inf, approach * rng.uniform(0.4, 1.1, shape))
    leave = onward * rng.uniform(0.4, 1.1, shape)
    if wide:
        # Company is worth having over the whole route, if a driver's clock allows.
        approach, onward = approach % 3, onward % 3
        entry, leave = approach * 1.0, onward * 1.0
        entry[:, 2:], leave[:, :-2] = np.inf, np.inf

    def state():
        today = int(rng.integers(0, 6)) if rng.random() < 0.6 else 0
        broken = min(today, int(rng.integers(0, 5)))
        if wide:
            today = broken = int(rng.integers(1, 6))
        duty = None if today == 0 and rng.random() < 0.5 else today + int(rng.integers(0, 5))
        return DriverState(
            driven_since_break_s=broken, first_part_taken=bool(broken and rng.random() < 0.4),
            driven_today_s=today, duty_s=duty, long_days_used=int(rng.integers(0, 2)),
            reduced_rests_used=int(rng.integers(0, 2)),
        )  # fmt: skip

    windows = []
    for k in range(members):
        begin = int(rng.integers(-4, 10))
        lasts = int(alone_s[k]) + int(rng.integers(0, 16)) + (12 if wide else 0)
        latest = begin + int(rng.integers(0, 12))
        windows.append(Span(begin, latest, begin + lasts))
    rules = [VehicleRules(limits, state(), one.earliest_s) for one in windows]
    standing = int(rng.integers(10, 17)) if night else int(rng.integers(3, 10))
    begin = int(rng.integers(0, 4))
    window = Span(begin, begin + int(rng.integers(0, 9)), begin + total + standing)
    started = DriverState() if night or rng.random() < 0.5 else state()
    star = StarTimes(
        road=road_of(drive, stay), node_at=node_at, window=window,
        rules=VehicleRules(limits, started, begin), approach_s=approach, onward_s=onward,
        entry=entry, leave=leave, platoon=np.array([platoon] * members), length_m=tau * 20.0,
        alone=alone_s * 1.0, alone_s=alone_s, windows=tuple(windows), member_rules=tuple(rules),
        relief=relief, master_alone=float(total), gain=np.zeros(nodes - 1),
        monday_s=-300_000,
    )  # fmt: skip
    ways = [
        [
            [None if one >= NEVER_S else cut(rng, int(one), everywhere) for one in row]
            for row in table
        ]
        for table in (approach, onward)
    ]
    alone = [cut(rng, int(one), everywhere) for one in alone_s]
    return Drawn(star, *ways, alone)


def all_stops(star, rests):
    """Every set of stops that a law's lengths allow, with no regard to whether they are legal."""
    limits = star.rules.limits
    lengths = {limits.break_s, limits.rest_s}
    if limits.reduced_rests:
        lengths.add(limits.reduced_rest_s)
    if limits.parts_s:
        lengths |= set(limits.parts_s)
    shortest = limits.reduced_rest_s if limits.reduced_rests else limits.rest_s
    places = [k for k in range(1, star.road.hops) if star.road.stay_s[k] > 0]
    for count in range(len(places) + 1):
        for chosen in itertools.combinations(places, count):
            for held in itertools.product(sorted(lengths), repeat=count):
                if sum(one >= shortest for one in held) <= rests:
                    yield tuple(zip(chosen, map(int, held), strict=True))
