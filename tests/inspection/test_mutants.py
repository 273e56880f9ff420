"""Would the table of written days notice a mistake in the checker? Each is made, one at a time."""

from __future__ import annotations

import sys
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from types import FrameType, ModuleType

import pytest
from driving_days import (
    BREAKS,
    DAILY_DRIVING,
    DAILY_REST,
    EU_DAYS,
    FERRIES,
    TWO_DRIVERS,
    US_DAYS,
    WEEKS,
    WORK,
    Written,
    told,
)  # fmt: skip
from mutants import Mutant, mutants_of
from places import ROOT
from soak import chosen, soaked

from platoon_osm.inspection import (
    activities,
    breaks,
    daily,
    directive_2002_15,
    driving_by_week,
    eu561,
    pauses,
    rests,
    us395,
    weekly_rest,
)  # fmt: skip

TELLING = {
    breaks: BREAKS + TWO_DRIVERS,
    pauses: TWO_DRIVERS + BREAKS + WORK,
    daily: DAILY_REST + DAILY_DRIVING + FERRIES + TWO_DRIVERS,
    rests: FERRIES + DAILY_REST,
    driving_by_week: WEEKS + FERRIES,
    weekly_rest: WEEKS + FERRIES,
    directive_2002_15: WORK + BREAKS,
    us395: US_DAYS,
    activities: BREAKS,
}
"""The rows that speak of a module come first; the others follow."""

INSIDE = {activities: "crossing"}

AMERICAN = set(map(id, US_DAYS))

PRUNED = "only how many choices are kept changes, not which is best"
CAPPED = "only from how many rests on not all choices are tried changes"
APART = "no two rests touch, for they would be one"
EQUIVALENT = {
    "breaks._Choice.beyond_s: max(0, self.driven_s - SPELL_S) => max(1, self.driven_s - SPELL_S)":
        "a second on every choice, so the best stays the best",
    "breaks._Choice.beyond_s: max(0, self.driven_s - SPELL_S) => max(-1, self.driven_s - SPELL_S)":
        "a second on every choice, so the best stays the best",
    "pauses._pause: max(rests, default=0) => max(rests, default=1)":
        "a pause without rest: a second is no part of a break",
    "pauses._pause: max(rests, default=0) => max(rests, default=-1)":
        "a pause without rest: a second is no part of a break",
    "daily.days_of: began_s // WEEK < week => began_s // WEEK <= week":
        "no day counts in the week before any more",
    "daily._usable: main.end_s >= until_s => main.end_s > until_s": PRUNED,
    "daily._counts: split.start_s < drive.start_s < split.end_s => "
    "split.start_s <= drive.start_s < split.end_s": "nobody drives when a rest begins",
    "driving_by_week.weekly_driving: week + 1 => week + 2":
        "when a limit is crossed nothing is driven in the next week yet",
    "driving_by_week._by_week: at_s - drive.start_s => at_s + drive.start_s":
        "the same on both sides of a difference",
    "weekly_rest.: MOST_CHOICES = 8 => MOST_CHOICES = 9": CAPPED,
    "weekly_rest.: MOST_CHOICES = 8 => MOST_CHOICES = 7": CAPPED,
    "weekly_rest.weekly_rests: len(perhaps) > MOST_CHOICES => len(perhaps) >= MOST_CHOICES": CAPPED,
    "weekly_rest.weekly_rests: badness(found) < badness(best) => badness(found) <= badness(best)":
        "of equals any will do",
    "weekly_rest._longest: rest.end_s <= one.start_s => rest.end_s < one.start_s": APART,
    "weekly_rest._longest: one.end_s <= rest.start_s => one.end_s < rest.start_s": APART,
    "weekly_rest._missing: sum((len(own) > 1 for own in weeks)) > MOST_CHOICES => "
    "sum((len(own) > 1 for own in weeks)) >= MOST_CHOICES": CAPPED,
    "weekly_rest._missing: len(own) > 1 => len(own) >= 1": CAPPED,
    "weekly_rest._missing: len(own) > 1 => len(own) > 2": CAPPED,
    "weekly_rest._missing: len(own) > 1 => len(own) > 0": CAPPED,
    "weekly_rest._missing: weeks = [own[:1] for own in weeks] => "
    "weeks = [own[:2] for own in weeks]": CAPPED,
    "weekly_rest._not_made_up: rest.rest_s >= REGULAR_S => rest.rest_s > REGULAR_S":
        "a rest of 45 h has nothing to spare",
    "weekly_rest._not_made_up: one.rest_s < REGULAR_S => one.rest_s <= REGULAR_S":
        "a rest of 45 h lacks nothing, which any other makes up for",
    "weekly_rest._not_made_up: one.start_s >= rest.end_s => one.start_s > rest.end_s": APART,
    "directive_2002_15.: 45 * MINUTE => 46 * MINUTE": "more than is ever asked for",
    "directive_2002_15.work_violations: day.start_s <= one.start_s < day.end_s => "
    "day.start_s <= one.start_s <= day.end_s": "the rest that ends the day is no work",
    "directive_2002_15._of_day: worked_s <= beyond_s < worked_s + step.worked_s => "
    "worked_s <= beyond_s <= worked_s + step.worked_s":
        "the next piece of work says the same again, later",
    "us395._Choice.beats: badness(self.all_found()) <= badness(other.all_found()) => "
    "badness(self.all_found()) < badness(other.all_found())": PRUNED,
    "us395._Choice.beats: self.from_s >= other.from_s => self.from_s > other.from_s": PRUNED,
    "us395._Choice.beats: self.driven_s <= other.driven_s => self.driven_s < other.driven_s":
        PRUNED,
    "us395._on_duty: day + 1 => day + 2": "nothing is on duty tomorrow yet",
}  # fmt: skip
"""Mutants that are no mistakes, and why."""


@contextmanager
def in_place_of(module: ModuleType, mutant: Mutant) -> Iterator[None]:
    """Let a mutant stand for a module, also where others have taken names from it."""
    made = ModuleType(module.__name__)
    made.__dict__.update(__package__=module.__package__, __file__=module.__file__)
    exec(mutant.code(), made.__dict__)  # noqa: S102 (our own source, changed)
    own = {
        name: value
        for name, value in vars(module).items()
        if getattr(value, "__module__", module.__name__) == module.__name__
        and not name.startswith("__")
    }
    others = [
        other
        for name, other in sys.modules.items()
        if name.startswith("platoon_osm.inspection") and other is not None
    ]
    changed = [
        (other, name, value)
        for other in others
        for name, value in own.items()
        if vars(other).get(name) is value and name in vars(made)
    ]
    try:
        for other, name, _ in changed:
            setattr(other, name, vars(made)[name])
        yield
    finally:
        for other, name, value in changed:
            setattr(other, name, value)


MOST_STEPS = 500_000
"""A mutant may never end, or try choices without number; a row takes fewer than 200,000 lines."""

Trace = Callable[[FrameType, str, object], "Trace | None"]

OF_THE_CHECKER = {"<mutant>", *map(str, ROOT.glob("platoon_osm/inspection/*.py"))}


class TooManyStepsError(Exception):
    """A row would take too long."""


@contextmanager
def ended_by_a_count() -> Iterator[None]:
    """End what runs too many lines of the checker: a clock would tell machines apart."""
    left = MOST_STEPS

    def line(frame: FrameType, event: str, value: object) -> Trace | None:
        nonlocal left
        left -= 1
        if left < 0:
            raise TooManyStepsError
        return line

    def call(frame: FrameType, event: str, value: object) -> Trace | None:
        return line if frame.f_code.co_filename in OF_THE_CHECKER else None

    before = sys.gettrace()
    sys.settrace(call)
    try:
        yield
    finally:
        sys.settrace(before)


def is_right(row: Written) -> bool:
    try:
        with ended_by_a_count():
            if id(row) in AMERICAN:
                found = us395.us395_violations(row.record, row.state, **row.options)
            else:
                found = eu561.eu561_violations(row.record, row.state)
        return sorted(map(told, found)) == sorted(row.wrong)
    except Exception:
        return False


def rows_for(module: ModuleType) -> list[Written]:
    rows = list(TELLING[module])
    known = set(map(id, rows))
    if module is not us395:
        rows += [row for row in EU_DAYS if id(row) not in known]
    if module in (rests, activities):
        rows += US_DAYS
    return rows


def survivors(module: ModuleType, rows: Sequence[Written], every: int) -> tuple[list[str], int]:
    """Return which mutants no row sees, and how many were tried."""
    left, count = [], 0
    for number, mutant in enumerate(mutants_of(module, INSIDE.get(module, ""))):
        if number % every == 0 and mutant.name not in EQUIVALENT:
            count += 1
            with in_place_of(module, mutant):
                if all(map(is_right, rows)):
                    left.append(mutant.name)
    return left, count


@soaked
@pytest.mark.parametrize("module", TELLING, ids=lambda module: module.__name__.split(".")[-1])
def test_written_days_see_every_mistake(module: ModuleType) -> None:
    left, count = survivors(module, rows_for(module), chosen(5, 1))
    assert count > 0
    assert left == []


def test_without_days_every_mistake_survives() -> None:
    left, count = survivors(driving_by_week, [], 1)
    assert len(left) == count > 40


def test_as_it_is_the_checker_is_right_again() -> None:
    # Mutants leave nothing behind.
    assert all(map(is_right, [*EU_DAYS[::5], *US_DAYS]))


def test_what_counts_as_no_mistake_is_a_change_that_can_be_made() -> None:
    made = {
        mutant.name for module in TELLING for mutant in mutants_of(module, INSIDE.get(module, ""))
    }
    assert set(EQUIVALENT) <= made
    assert len(EQUIVALENT) < 0.06 * len(made)
