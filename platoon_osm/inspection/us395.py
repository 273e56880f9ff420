"""49 CFR 395.3, hours of service of drivers who carry property, with rest split by 395.1(g).

After 10 h off duty nobody drives beyond 11 h of driving, (a)(3)(i), nor after the 14th hour,
(a)(2); nor after 8 h of driving without 30 min in which the driver does not drive, on duty or off,
(a)(3)(ii); nor after 60 h on duty in 7 days, or 70 in 8, (b), which 34 h off duty begin anew, (c).

The 10 h may be two rests of which one has 7 h or more in the berth, the other 2 or more, and both
together 10 (395.1(g)(1)(ii)). Neither counts in the 14 h, and after the second 11 and 14 h count
from the end of the first. Which rests are paired is chosen so that least is violated, as the
authority does itself. A rest of 10 h or more begins everything anew, and may be the second of a
pair.

Readings: rest on the road is in the berth if it has to be. Time available, or beside the one who
drives, is on duty. Days begin at midnight of a clock that the caller names.
"""

from __future__ import annotations

import itertools
from collections import defaultdict
from collections.abc import Iterator
from dataclasses import dataclass, replace

from .activities import DAY, HOUR, MINUTE, Activity, Record, clock_span, crossing
from .driver_start import RESTED, DriverStart
from .rests import Rest, rests_of
from .violation import Violation, badness, in_order

__all__ = ["us395_violations"]

DRIVING_S = 11 * HOUR
WINDOW_S = 14 * HOUR
OFF_S = 10 * HOUR
PART_S = 2 * HOUR
BERTH_S = 7 * HOUR
SPELL_S = 8 * HOUR
INTERRUPTION_S = 30 * MINUTE
RESTART_S = 34 * HOUR
CYCLES = {7: 60 * HOUR, 8: 70 * HOUR}
"""How much is allowed on duty in how many days [s]."""


@dataclass(frozen=True, slots=True)
class _Part:
    """The last rest that is one of a pair, or will be."""

    rest: Rest
    driven_s: int
    paired: bool


@dataclass(frozen=True, slots=True)
class _Choice:
    """A choice of pairs so far."""

    from_s: int
    """When the 14 h began, later by the rests that do not count in them."""
    driven_s: int
    part: _Part | None = None
    found: tuple[Violation, ...] = ()
    too_far: Violation | None = None
    too_late: Violation | None = None

    def all_found(self) -> tuple[Violation, ...]:
        return (*self.found, *(one for one in (self.too_far, self.too_late) if one is not None))

    def after_drive(self, drive: Activity) -> _Choice:
        driven_s = self.driven_s + drive.driven_s
        too_far, too_late = self.too_far, self.too_late
        if driven_s > DRIVING_S and drive.driven_s:
            at_s = crossing(drive, max(0, DRIVING_S - self.driven_s))
            text = f"{clock_span(driven_s)} driven, {clock_span(DRIVING_S)} allowed"
            too_far = Violation(
                "49 CFR 395.3(a)(3)(i)", too_far.at_s if too_far else at_s,
                driven_s - DRIVING_S, text,
            )  # fmt: skip
        until_s = self.from_s + WINDOW_S
        if drive.end_s > until_s:
            at_s = max(drive.start_s, until_s)
            before_s = too_late.over_s if too_late else 0
            text = f"driving until {clock_span(drive.end_s - self.from_s)} after coming on duty, "
            text += f"{clock_span(WINDOW_S)} allowed"
            too_late = Violation(
                "49 CFR 395.3(a)(2)", too_late.at_s if too_late else at_s,
                before_s + drive.end_s - at_s, text,
            )  # fmt: skip
        part = self.part and replace(self.part, driven_s=self.part.driven_s + drive.driven_s)
        return replace(self, driven_s=driven_s, part=part, too_far=too_far, too_late=too_late)

    def after_rest(self, rest: Rest) -> Iterator[_Choice]:
        if rest.span_s >= OFF_S:
            yield _Choice(rest.end_s, 0, None, self.all_found())
            return
        yield self
        if rest.span_s < PART_S:
            return
        own = _Part(rest, 0, paired=False)
        if self.part is None or self.part.paired:
            yield replace(self, from_s=self.from_s + rest.span_s, part=own)
        if self.part is not None and _is_pair(self.part.rest, rest):
            yield _Choice(
                self.part.rest.end_s + rest.span_s, self.part.driven_s,
                replace(own, paired=True), self.all_found(),
            )  # fmt: skip

    def beats(self, other: _Choice) -> bool:
        return self.part == other.part and (
            badness(self.all_found()) <= badness(other.all_found())
            and self.from_s >= other.from_s
            and self.driven_s <= other.driven_s
        )


def _is_pair(one: Rest, other: Rest) -> bool:
    spans = one.span_s, other.span_s
    return max(spans) >= BERTH_S and sum(spans) >= OFF_S


def us395_violations(
    record: Record, start: DriverStart = RESTED, *, days: int = 8, clock_s: int = 0
) -> list[Violation]:
    """Return what a driver's record breaks.

    Parameters
    ----------
    record : tuple of Activity
        What it does, without gaps.
    start : DriverStart
        What it has behind it.
    days : {8, 7}
        Over how many days time on duty is limited: 70 h in 8 days, or 60 h in 7.
    clock_s : int
        How far the clock by which days begin is ahead of the record's [s].

    Returns
    -------
    list of Violation
        In order of time.
    """
    if not record:
        return []
    return in_order(
        (
            *_shifts(record, start),
            *_without_interruption(record, start),
            *_on_duty(record, start, days, clock_s),
        )
    )


def _shifts(record: Record, start: DriverStart) -> tuple[Violation, ...]:
    rests = {rest.start_s: rest for rest in rests_of(record)}
    began_s = record[0].start_s
    if start.duty_s is not None:
        began_s -= start.duty_s
    elif began_s in rests:
        began_s = rests.pop(began_s).end_s
    choices = [_Choice(began_s, start.driven_today_s)]
    for activity in record:
        if activity.start_s in rests:
            rest = rests[activity.start_s]
            choices = _best([after for one in choices for after in one.after_rest(rest)])
        elif activity.kind == "drive":
            choices = [one.after_drive(activity) for one in choices]
    return min(choices, key=lambda one: badness(one.all_found())).all_found()


def _best(choices: list[_Choice]) -> list[_Choice]:
    kept: list[_Choice] = []
    for choice in choices:
        if not any(other.beats(choice) for other in kept):
            kept = [other for other in kept if not choice.beats(other)]
            kept.append(choice)
    return kept


def _without_interruption(record: Record, start: DriverStart) -> list[Violation]:
    found = []
    driven_s, idle_s = start.driven_since_break_s, 0
    crossed_s: int | None = None
    for activity in (*record, None):
        if activity is not None and activity.kind == "drive":
            if crossed_s is None and driven_s + activity.driven_s > SPELL_S:
                crossed_s = crossing(activity, max(0, SPELL_S - driven_s))
            driven_s, idle_s = driven_s + activity.driven_s, 0
            continue
        idle_s += activity.span_s if activity is not None else INTERRUPTION_S
        if idle_s >= INTERRUPTION_S:
            if crossed_s is not None:
                text = f"{clock_span(driven_s)} driven without 30 min of anything else, "
                text += f"{clock_span(SPELL_S)} allowed"
                over_s = driven_s - SPELL_S
                found.append(Violation("49 CFR 395.3(a)(3)(ii)", crossed_s, over_s, text))
            driven_s, crossed_s = 0, None
    return found


def _on_duty(record: Record, start: DriverStart, days: int, clock_s: int) -> list[Violation]:
    """Return driving beyond the hours on duty in some days; once until 34 h off begin anew."""
    most_s = CYCLES[days]
    duty: defaultdict[int, int] = defaultdict(int)
    duty[(record[0].start_s + clock_s) // DAY] = start.driven_this_week_s
    restarts = {rest.start_s for rest in rests_of(record) if rest.span_s >= RESTART_S}
    found: list[Violation] = []
    crossed_s: int | None = None
    over_s = 0
    article = f"49 CFR 395.3(b)({1 if days == 7 else 2})"
    text = f"driving beyond {clock_span(most_s)} on duty in {days} days"
    for activity in record:
        if activity.start_s in restarts:
            duty.clear()
            if crossed_s is not None:
                found.append(Violation(article, crossed_s, over_s, text))
            crossed_s, over_s = None, 0
        if activity.is_rest:
            continue
        for piece_s, end_s in _by_day(activity, clock_s):
            day = (piece_s + clock_s) // DAY
            before_s = sum(duty[one] for one in range(day - days + 1, day + 1))
            at_s = piece_s + max(0, most_s - before_s)
            if activity.kind == "drive" and end_s > at_s:
                crossed_s = at_s if crossed_s is None else crossed_s
                over_s += end_s - at_s
            duty[day] += end_s - piece_s
    if crossed_s is not None:
        found.append(Violation(article, crossed_s, over_s, text))
    return found


def _by_day(activity: Activity, clock_s: int) -> Iterator[tuple[int, int]]:
    """Yield the pieces of an activity, cut at midnights."""
    first = ((activity.start_s + clock_s) // DAY + 1) * DAY - clock_s
    moments = [activity.start_s, *range(first, activity.end_s, DAY), activity.end_s]
    yield from itertools.pairwise(moments)
