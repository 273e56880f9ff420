"""(EC) 561/2006 read from its articles: a record is legal if some way to count its pauses is.

Every way is tried, so nothing is bounded or dropped. Weeks are left out: records here lie within
one calendar week, with less than 56 h of driving and no weekly rest due. A pause may count in
article 7 and in article 8 on its own, as what suits there.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from datetime import UTC
from typing import NamedTuple

from platoon_osm.plans.plan import Plan

H, MIN = 3600.0, 60.0
HAIR = 1.5
"""Plans are made to the second [s]."""


class Drive(NamedTuple):
    start: float
    end: float
    counted: float


class Gap(NamedTuple):
    """Where a driver does not drive, and of that what the vehicle stands."""

    start: float
    end: float
    stands: tuple[tuple[float, float], ...]


class Record(NamedTuple):
    """What one driver does after its state was told, and that state."""

    steps: tuple[Drive | Gap, ...]
    state: object
    since: float


def records(plan: Plan, vehicle: int) -> Iterator[Record]:
    """Yield the record of each driver of a vehicle."""
    table = plan.timetable
    times = table.vehicles[vehicle]
    for driver in times.drivers:
        since = min(driver.state_at_s, times.departure_s)
        steps: list[Drive | Gap] = []
        at, free, stands = since, since, []
        for number, ((begin, end), way) in enumerate(
            zip(times.legs, plan.ways[vehicle], strict=True)
        ):
            if begin > at:
                stands.append((at, begin))
            at = end
            if driver.drives is not None and number not in driver.drives:
                continue
            if begin > free:
                steps.append(Gap(free, begin, tuple(stands)))
            follows = plan.stretches[way].vehicles[0] != vehicle
            relief = table.task_relief if follows else 0.0
            steps.append(Drive(begin, end, (end - begin) * (1 - relief)))
            free, stands = end, []
        yield Record(tuple(steps), driver.state, since)


def weekdays(plan: Plan) -> set[int]:
    """Return on which days of the week a plan's drives lie, by the clock of the week, UTC."""
    clock = plan.timetable.clock
    moments = [at for times in plan.timetable.vehicles for leg in times.legs for at in leg]
    shown = [clock.moment(at) for at in moments]
    return {(one if one.tzinfo is None else one.astimezone(UTC)).weekday() for one in shown}


def legal(record: Record) -> bool:
    """Tell whether a record keeps articles 6(1), 7 and 8."""
    state = record.state
    return _breaks(record.steps, state.driven_since_break_s, state.first_part_taken) and _days(
        record.steps,
        state.driven_today_s,
        None if state.duty_s is None else record.since - state.duty_s,
        False,
        2 - state.long_days_used,
        10**6 if state.drivers == 2 else 3 - state.reduced_rests_used,
        30 * H if state.drivers == 2 else 24 * H,
    )


def _breaks(steps: Sequence[Drive | Gap], driven: float, parted: bool) -> bool:
    """Article 7: 45 min after 4 h 30 of driving, or 15 and later 30 min within that driving."""
    if not steps:
        return True
    step, left = steps[0], steps[1:]
    if isinstance(step, Drive):
        driven += step.counted
        return driven <= 4.5 * H + HAIR and _breaks(left, driven, parted)
    lasts = step.end - step.start
    # Time beside the one who drives may be a whole break, and is no part of one.
    rests = max((high - low for low, high in step.stands), default=0.0)
    whole = lasts >= 45 * MIN - HAIR or (parted and rests >= 30 * MIN - HAIR)
    first = driven > 0 and rests >= 15 * MIN - HAIR
    return (
        (whole and _breaks(left, 0.0, False))
        or (first and _breaks(left, driven, True))
        or _breaks(left, driven, parted)
    )


def _days(
    steps: Sequence[Drive | Gap], driven: float, begun: float | None, halved: bool, long_days: int,
    reduced: int, within: float, at: float = 0.0, is_long: bool = False,
) -> bool:  # fmt: skip
    """Articles 6(1) and 8: 9 or 10 h from rest to rest, and a rest within 24 h, or 30 of two."""
    if not steps:
        if begun is None:
            return True  # it never drove
        # After the arrival it rests, in time.
        due = begun + within + HAIR
        return at + 11 * H <= due or (at + 9 * H <= due and (reduced > 0 or halved))
    step, left = steps[0], steps[1:]
    if isinstance(step, Drive):
        begun = step.start if begun is None else begun
        driven += step.counted
        if driven > 9 * H + HAIR and not is_long:
            long_days, is_long = long_days - 1, True
        fine = driven <= 10 * H + HAIR and (not is_long or long_days >= 0)
        own = (driven, begun, halved, long_days, reduced, within, step.end, is_long)
        return fine and _days(left, *own)
    if begun is None:
        return _days(left, driven, None, halved, long_days, reduced, within, step.end)
    if _days(left, driven, begun, halved, long_days, reduced, within, step.end, is_long):
        return True
    for low, high in step.stands:
        counts = min(high, begun + within + HAIR) - low
        again = (left, 0.0, high, False, long_days)
        regular = counts >= 11 * H - HAIR or (halved and counts >= 9 * H - HAIR)
        if (regular and _days(*again, reduced, within, step.end)) or (
            counts >= 9 * H - HAIR and reduced > 0 and _days(*again, reduced - 1, within, step.end)
        ):
            return True
        if high - low >= 3 * H - HAIR and not halved:
            own = (driven, begun, True, long_days, reduced, within, step.end, is_long)
            if _days(left, *own):
                return True
    return False
