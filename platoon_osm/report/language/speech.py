"""The language that is spoken now: set where a page begins, used wherever a text is made.

It is a context variable, as gettext has one: nearly all functions of the report make some text, and
would hand a language on for nothing else. `speaking` is called where writing begins, and nothing
made under it depends on what was spoken before.
"""

from __future__ import annotations

import itertools
from collections.abc import Iterator
from contextlib import contextmanager
from contextvars import ContextVar
from dataclasses import replace
from datetime import datetime

from ...plans.clock import MENTIONED_S, Clock, ClockFace, duration
from .languages import Language, language_of

__all__ = [
    "clock_time",
    "day_and_date",
    "late_by",
    "number",
    "say",
    "speaking",
    "spoken",
    "time_of_day",
    "zone_text",
]

DEFAULT = "en"

_spoken: ContextVar[Language | None] = ContextVar("spoken", default=None)


def spoken() -> Language:
    """Return the language that is spoken.

    Returns
    -------
    Language
        English, unless `speaking` says otherwise.
    """
    return _spoken.get() or language_of(DEFAULT)


@contextmanager
def speaking(language: str | None = None, clock: int | None = None) -> Iterator[Language]:
    """Speak a language for a while.

    Parameters
    ----------
    language : str or None
        Its code; None for that which is spoken already.
    clock : int or None
        24 or 12 hours; None as the language has it.

    Yields
    ------
    Language
        That is spoken.

    Raises
    ------
    ScenarioError
        As in `language_of`.
    """
    if language is None and clock is None:
        chosen = spoken()
    else:
        chosen = language_of(spoken().code if language is None else language, clock)
    before = _spoken.set(chosen)
    try:
        yield chosen
    finally:
        _spoken.reset(before)


def say(key: str, /, **fields: object) -> str:
    """Return a text of the catalogue in the language that is spoken.

    Parameters
    ----------
    key : str
        Of the catalogue, such as "table.alone".
    **fields : object
        As of `Language.say`.

    Returns
    -------
    str
        Plain text.
    """
    return spoken().say(key, **fields)


def number(value: float, decimals: int = 0) -> str:
    """Return a number in the form of the language that is spoken.

    Parameters
    ----------
    value : float
        Any.
    decimals : int
        Behind the decimal sign.

    Returns
    -------
    str
        As of `Language.number`.
    """
    return spoken().number(value, decimals)


def clock_time(clock: Clock, seconds: float) -> str:
    """Return a time of day to the minute: "08:21", "00:10 +1 d", or "8:21 am".

    Parameters
    ----------
    clock : Clock
        Of the plan.
    seconds : float
        After its start.

    Returns
    -------
    str
        With the number of days if it is another day than the clock's first, and with the offset
        from UTC if clocks show this time twice.
    """
    return _face_text(clock.face(seconds))


def time_of_day(clock: Clock, seconds: float) -> str:
    """Return a time of day beside its date: "00:10", or "8:21 am".

    Parameters
    ----------
    clock : Clock
        Of the plan.
    seconds : float
        After its start.

    Returns
    -------
    str
        As `clock_time` without the number of days.
    """
    return _face_text(replace(clock.face(seconds), days=0))


def _face_text(face: ClockFace) -> str:
    hour, minute = divmod(face.minute, 60)
    if spoken().clock == 12:
        half = say("script.pm" if hour >= 12 else "script.am")
        text = f"{(hour - 1) % 12 + 1}:{minute:02d}\u00a0{half}"
    else:
        text = f"{hour:02d}:{minute:02d}"
    if face.days:
        text += f" {face.days:+d} {say('script.day')}"
    return f"{text} {face.twice}" if face.twice else text


def day_and_date(moment: datetime) -> str:
    """Return a day of the calendar in the language that is spoken.

    Parameters
    ----------
    moment : datetime
        Of the day.

    Returns
    -------
    str
        Such as "Fri, 27 Nov 2026".
    """
    return spoken().date(moment)


def late_by(seconds: float) -> str:
    """Return a lateness to the minute, never 0.

    Parameters
    ----------
    seconds : float
        How late [s].

    Returns
    -------
    str
        As `duration`, or "less than a minute".
    """
    return duration(seconds) if seconds >= MENTIONED_S else say("clock.under-a-minute")


def zone_text(clock: Clock) -> str:
    """Return the zone of all times of a plan and its offset, when it changes.

    Parameters
    ----------
    clock : Clock
        Of the plan.

    Returns
    -------
    str
        Such as "Europe/Rome (UTC+02:00)"; "local time" if none was named.
    """
    if not (spells := clock.zone_spells):
        return say("clock.local")
    text = spells[0].offset
    for before, after in itertools.pairwise(spells):
        if before.until is not None:
            until = _face_text(before.until)
            text = say("clock.spells", before=text, until=until, after=after.offset)
    return text if clock.name in ("", text) else f"{clock.name} ({text})"
