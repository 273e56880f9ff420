"""A day and a time, from whatever a cell of a table or a key of TOML holds."""

from __future__ import annotations

import re
from datetime import date, datetime, time
from typing import Any

from ...errors import ScenarioError, brief

__all__ = ["moment"]

CLOCK = r"(\d{1,2}):(\d{2})(?::(\d{2}))?"
DAY_FIRST = re.compile(rf"(\d{{1,2}})\.(\d{{1,2}})\.(\d{{4}}),?[ T]\s*{CLOCK}")
"""02.03.2026 06:00: with points the day comes first, wherever that is written."""
YEAR_FIRST = re.compile(rf"(\d{{4}})[/.-](\d{{1,2}})[/.-](\d{{1,2}}),?[ T]\s*{CLOCK}")
SLASHES = re.compile(r"\d{1,2}[/-]\d{1,2}[/-]\d{2,4}\b.*")
SHORT_YEAR = re.compile(r"\d{1,2}\.\d{1,2}\.\d{2}\b(?!\d).*")
HALVES_OF_DAY = re.compile(r".*\d\s*[ap]\.?m\.?", re.IGNORECASE)
SERIAL = re.compile(r"\d{5}([.,]\d+)?")
"""Days since the end of 1899, or of 1903: as spreadsheets keep moments."""

FORM = "2026-03-02 06:00"


def moment(where: str, value: Any) -> datetime:
    """Return a moment as such.

    Parameters
    ----------
    where : str
        Whose it is, for messages: "trip 2: latest_arrival".
    value : Any
        What TOML or a table holds.

    Returns
    -------
    datetime
        With a zone if it names one.

    Raises
    ------
    ScenarioError
        It is none, or may be read as two; with the form to write.
    """
    if isinstance(value, datetime):
        return value
    text = value.strip() if isinstance(value, str) else ""
    try:
        # A day alone would be read as its midnight.
        found = _read(text) if ":" in text else None
    except ValueError:
        found = None
    if found is not None:
        return found
    raise ScenarioError(f"{where} = {_shown(value)} {_remedy(text)}")


def _read(text: str) -> datetime | None:
    """Return the moment of a text; None if it has none of our forms."""
    if found := DAY_FIRST.fullmatch(text):
        day, month, year, *clock = found.groups()
    elif found := YEAR_FIRST.fullmatch(text):
        year, month, day, *clock = found.groups()
    elif SLASHES.fullmatch(text):
        return None
    else:
        return datetime.fromisoformat(text)
    hour, minute, second = (int(part or 0) for part in clock)
    return datetime(int(year), int(month), int(day), hour, minute, second)


def _remedy(text: str) -> str:
    if SLASHES.fullmatch(text):
        return f"may put the day or the month first; write {FORM}, or 02.03.2026 06:00"
    if SHORT_YEAR.fullmatch(text):
        return f"has a year of two digits; write {FORM}, or 02.03.2026 06:00"
    if HALVES_OF_DAY.fullmatch(text):
        return f"must count its hours to 24; write {FORM}"
    if SERIAL.fullmatch(text):
        return f"is a spreadsheet's number for a day; format the column as {FORM} and save again"
    return f"must be a day and a time, such as {FORM} or 2026-03-02T06:00:00+01:00"


def _shown(value: Any) -> str:
    if isinstance(value, str):
        return brief(value)[1:-1]
    return value.isoformat() if isinstance(value, date | time) else brief(value)
