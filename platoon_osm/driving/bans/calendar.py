"""Which days a rule means: weekdays, holidays, days counted from Easter, seasons.

Holidays are those of the library holidays, or those that the law itself names where it counts fewer
or other days than are holidays.
"""

from __future__ import annotations

from datetime import date, timedelta
from functools import lru_cache

from .rules import CountryBans, Rule

__all__ = ["holidays_of", "means", "season_of"]

WEEKDAYS = ("Mo", "Tu", "We", "Th", "Fr", "Sa", "Su")
SUNDAY = 6

WORKED_FOR = "substituted"
"""In names of days off that are made up for on another day: no holidays for a ban."""


@lru_cache(maxsize=1_000)
def holidays_of(bans: CountryBans, year: int) -> frozenset[date]:
    """Return the holidays on which a country's bans hold.

    Parameters
    ----------
    bans : CountryBans
        Of the country.
    year : int
        Which year.

    Returns
    -------
    frozenset of date
        Those of all regions together, where regions differ.
    """
    if isinstance(bans.holidays, tuple):
        found = (_named(text, year) for text in bans.holidays)
        return frozenset(day for day in found if day is not None)
    from holidays import country_holidays

    known = country_holidays(bans.country, years=year, language="en_US")
    return frozenset(day for day, name in known.items() if WORKED_FOR not in name)


def means(rule: Rule, bans: CountryBans, day: date) -> bool:
    """Tell whether a day is one of those of a rule, its season included.

    Parameters
    ----------
    rule : Rule
        The rule.
    bans : CountryBans
        Of its country.
    day : date
        The day itself, also where the evening before is meant.

    Returns
    -------
    bool
        Whatever the hour.
    """
    return in_season(rule.season, day) and any(_is(text, bans, day) for text in rule.days)


def in_season(season: tuple[str, ...], day: date) -> bool:
    """Tell whether a day lies in a season.

    Parameters
    ----------
    season : tuple of str
        First and last day; empty for always.
    day : date
        The day.

    Returns
    -------
    bool
        First and last day included.
    """
    if not season:
        return True
    first, last = season_of(season, day.year)
    return first <= day <= last if first <= last else day >= first or day <= last


@lru_cache(maxsize=1_000)
def season_of(season: tuple[str, ...], year: int) -> tuple[date, date]:
    """Return the first and last day of a season.

    Parameters
    ----------
    season : tuple of str
        As in the files.
    year : int
        Which year.

    Returns
    -------
    first, last : date
        Of one year; `last` is before `first` for a season over New Year.
    """
    first, last = (_bound(text, year) for text in season)
    return first, last


def _bound(text: str, year: int) -> date:
    words = text.split()
    day = date(year, *map(int, words[-1].split("-")))
    if len(words) == 1:
        return day
    if words[0] == "last":  # such as "last Su to 08-31"
        return day - timedelta(days=(day.weekday() - WEEKDAYS.index(words[1])) % 7)
    return day + timedelta(days=(WEEKDAYS.index(words[0]) - day.weekday()) % 7)


def _is(text: str, bans: CountryBans, day: date) -> bool:
    if text == "daily":
        return True
    if text in WEEKDAYS:
        return WEEKDAYS[day.weekday()] == text
    if text == "PH":
        return day in holidays_of(bans, day.year)
    if text == "last PH":
        return day in holidays_of(bans, day.year) and not _rests(bans, day + timedelta(days=1))
    return _named(text, day.year) == day


def _rests(bans: CountryBans, day: date) -> bool:
    return day.weekday() == SUNDAY or day in holidays_of(bans, day.year)


def _named(text: str, year: int) -> date | None:
    """Return the day that a text names in a year; None if it names none in it."""
    text, _, unless = text.partition(" unless ")
    if unless:
        other, _, weekdays = unless.partition(" is ")
        ruled_out = _named(other, year)
        if ruled_out and WEEKDAYS[ruled_out.weekday()] in weekdays.split(" or "):
            return None
    if text.startswith("easter"):
        from dateutil.easter import easter

        sunday: date = easter(year)
        return sunday + timedelta(days=int(text.removeprefix("easter")))
    parts = [int(part) for part in text.split("-")]
    if len(parts) == 3:
        return date(*parts) if parts[0] == year else None
    return date(year, *parts)
