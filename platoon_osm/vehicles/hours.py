"""Times as maps write them ("Mo-Fr 07:00-19:00; PH off"), read for a place and its clocks.

The reading is that of the library opening-hours, which knows the whole grammar, public holidays of
countries, and the sun. Moments are local: what a clock on the spot shows. What depends on something
that is not known here is neither open nor closed: school holidays, holidays without a country, the
sun without a place, "unknown" times.

Source: https://wiki.openstreetmap.org/wiki/Key:opening_hours/specification
"""

from __future__ import annotations

import re
from datetime import datetime
from functools import lru_cache
from typing import Any

__all__ = ["LongLat", "hours_change", "hours_hold", "reads_as_hours"]

LongLat = tuple[float, float]
"""Longitude and latitude [degree]."""

SCHOOL = re.compile(r"\bSH\b")
HOLIDAY = re.compile(r"\bPH\b", re.IGNORECASE)
SUN = re.compile(r"sunrise|sunset|dawn|dusk", re.IGNORECASE)


def reads_as_hours(text: str) -> bool:
    """Tell whether a text says times.

    Parameters
    ----------
    text : str
        Such as "22:00-05:00".

    Returns
    -------
    bool
        Whether its grammar is right; not whether all it asks for is known.
    """
    return _read(text.strip(), None, None) is not None


def hours_hold(
    text: str, when: datetime, place: LongLat | None = None, country: str | None = None
) -> bool | None:
    """Tell whether a moment lies within some times.

    Parameters
    ----------
    text : str
        The times.
    when : datetime
        What clocks on the spot show; a zone it has is not looked at.
    place : (float, float), optional
        Longitude and latitude, for the sun.
    country : str, optional
        Two letters, for public holidays.

    Returns
    -------
    bool or None
        None if the text is no times, or they depend on what is not known.
    """
    times = _known(text, place, country)
    if times is None:
        return None
    at = when.replace(tzinfo=None)
    if times.is_unknown(at):
        return None
    return bool(times.is_open(at))


def hours_change(
    text: str, when: datetime, place: LongLat | None = None, country: str | None = None
) -> datetime | None:
    """Return when it next changes whether times hold.

    Parameters
    ----------
    text : str
        The times.
    when : datetime
        What clocks on the spot show.
    place : (float, float), optional
        Longitude and latitude, for the sun.
    country : str, optional
        Two letters, for public holidays.

    Returns
    -------
    datetime or None
        A moment after `when` by the clocks on the spot, without a zone; None if it never changes or
        nobody knows.
    """
    times = _known(text, place, country)
    if times is None:
        return None
    found: datetime | None = times.next_change(when.replace(tzinfo=None))
    return None if found is None else found.replace(tzinfo=None)


def _known(text: str, place: LongLat | None, country: str | None) -> Any:
    """Return times of which everything is known that they ask for; None for others."""
    text = text.strip()
    if SCHOOL.search(text):
        return None
    sun = SUN.search(text) is not None
    if sun and place is None:
        return None
    holiday = HOLIDAY.search(text) is not None
    if holiday and country is None:
        return None
    # Of what is not asked for nothing is said, so that one text is read once for a whole country.
    spot = (round(place[0], 1), round(place[1], 1)) if place is not None and sun else None
    return _read(text, spot, country.upper() if country is not None and holiday else None)


@lru_cache(maxsize=20_000)
def _read(text: str, place: LongLat | None, country: str | None) -> Any:
    """Return the library's reading of a text; None if it has none."""
    from opening_hours import OpeningHours

    coords = None if place is None else (place[1], place[0])
    try:
        times = OpeningHours(
            text, country=country, coords=coords, auto_country=False, auto_timezone=True
        )
        times.is_open(datetime(2026, 1, 1))
    except (KeyboardInterrupt, SystemExit, MemoryError):
        raise
    except BaseException:  # a panic of the library is no Exception of Python
        return None
    return times
