"""(EC) 561/2006 art. 7: 45 min of break after 4 h 30 of driving, or 15 and then 30 min.

The reading: a day is allowed if *some* choice of its pauses makes it so. A pause of 45 min is a
whole break; so are two pauses, the first of 15 min or more, the second of 30 or more, in that
order; the other way round they are none. Driving is counted from the end of the whole break that
was chosen last. Both parts lie within the driving that they interrupt: a pause before any driving
since a break or rest is no part of one. A pause need not be counted as a first part. Whoever pairs
the first 15 min with the first 30 min that follow, always, makes a legal day illegal by one more
pause: 2 h, 30 min, 2 h, 30 min, 4 h 30 is legal, and would not be so with 15 min more after the
first hour.

If no choice is allowed, one with the least driving beyond 4 h 30 in all is told. The search keeps
choices that no other beats in driving beyond and in driving since the last break, those with a
first part taken apart from those without. Nothing else matters later, so it is exact, and one more
pause never makes the driving beyond more.

With two drivers, 45 min beside the one who drives are a break (third paragraph); shorter times
beside it are no parts of one.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

from .activities import FOREVER, HOUR, MINUTE, Activity, Record, clock_span, crossing
from .driver_start import DriverStart
from .pauses import Pause, drives_and_pauses
from .violation import Violation

__all__ = ["ARTICLE", "break_violations"]

ARTICLE = "561/2006 Art. 7"

SPELL_S = 4 * HOUR + 30 * MINUTE
BREAK_S = 45 * MINUTE
FIRST_PART_S = 15 * MINUTE
SECOND_PART_S = 30 * MINUTE


@dataclass(frozen=True, slots=True)
class _Choice:
    """A choice of pauses: what it broke, and what was driven since its last break."""

    driven_s: int
    found: tuple[Violation, ...] = ()
    crossed_s: int | None = None

    @property
    def beyond_s(self) -> float:
        return sum(one.over_s for one in self.found) + max(0, self.driven_s - SPELL_S)

    def after_drive(self, drive: Activity) -> _Choice:
        driven_s = self.driven_s + drive.driven_s
        crossed_s = self.crossed_s
        if crossed_s is None and driven_s > SPELL_S:
            crossed_s = crossing(drive, max(0, SPELL_S - self.driven_s))
        return replace(self, driven_s=driven_s, crossed_s=crossed_s)

    def after_break(self) -> _Choice:
        return _Choice(0, self.all_found())

    def all_found(self) -> tuple[Violation, ...]:
        if self.crossed_s is None:
            return self.found
        over_s = self.driven_s - SPELL_S
        text = f"{clock_span(self.driven_s)} driven without a break, {clock_span(SPELL_S)} allowed"
        return (*self.found, Violation(ARTICLE, self.crossed_s, over_s, text))


def break_violations(record: Record, start: DriverStart) -> list[Violation]:
    """Return where a driver drives on without the break that article 7 asks for.

    Parameters
    ----------
    record : tuple of Activity
        What it does.
    start : DriverStart
        What it has behind it.

    Returns
    -------
    list of Violation
        Of the choice of its pauses with the least driving beyond.
    """
    none = [_Choice(start.driven_since_break_s)]
    first = list(none) if start.first_part_taken else []
    for step in drives_and_pauses(record):
        if isinstance(step, Pause):
            none, first = _after_pause(none, first, step)
        else:
            none = [choice.after_drive(step) for choice in none]
            first = [choice.after_drive(step) for choice in first]
    return list(min(none, key=lambda choice: choice.beyond_s).all_found())


def _after_pause(
    none: list[_Choice], first: list[_Choice], pause: Pause
) -> tuple[list[_Choice], list[_Choice]]:
    """Return the choices without and with a first part taken, after a pause."""
    whole = list(none)
    if pause.break_s >= BREAK_S:
        whole += [choice.after_break() for choice in none]
    if pause.rest_s >= SECOND_PART_S:
        whole += [choice.after_break() for choice in first]
    parted = list(first)
    if pause.rest_s >= FIRST_PART_S:
        parted += [choice for choice in none if choice.driven_s]
    return _unbeaten(whole), _unbeaten(parted)


def _unbeaten(choices: list[_Choice]) -> list[_Choice]:
    kept: list[_Choice] = []
    least_s = FOREVER
    for choice in sorted(choices, key=lambda one: (one.beyond_s, one.driven_s)):
        # Who has not driven since a break has no first part to take, and so does not beat others.
        if choice.driven_s:
            if choice.driven_s >= least_s:
                continue
            least_s = choice.driven_s
        kept.append(choice)
    return kept
