"""Coordinates written as text: "10.22, 45.54", and with the decimal comma "10,22; 45,54".

Longitude comes first, as everywhere here. A text of two numbers is never a name.
"""

from __future__ import annotations

import re

from ..errors import NetworkError, brief
from .spelling import plain

__all__ = ["coordinates_in", "printed_position"]

LONGEST = 80
"""Characters of a coordinate at most; longer texts are names."""

BRACKETS = str.maketrans("", "", "()[]")
POINT = r"[+-]?\d+(?:\.\d*)?"
COMMA = r"[+-]?\d+(?:,\d+)?"
PAIRS = (
    re.compile(rf"({POINT})(?:\s*[,;]\s*|\s+)({POINT})"),
    re.compile(rf"({COMMA})(?:\s*;\s*|,?\s+)({COMMA})"),
)
"""Two numbers with decimal points, with a comma, semicolon or blank between them; or with decimal
commas, with a semicolon or blank."""

AMBIGUOUS = re.compile(r"[+-]?\d+,\d+")
"""Two whole numbers, or one with a decimal comma."""

HEMISPHERES = re.compile(
    r"[+-]?\d[\d.,]*\s*°?[\d\s.,'\"′″]*[NS]\b[,;\s]*\d[\d.,]*\s*°?[\d\s.,'\"′″]*[EWO]"
)


POSITION = re.compile(r"(?<![\w.])(\d{1,2}\.\d{3}) ([ns]) (\d{1,3}\.\d{3}) ([ew])\)?$")
"""What `format_position` prints, in small letters."""


def coordinates_in(text: str) -> tuple[float, float] | None:
    """Read a text as a longitude and a latitude.

    Parameters
    ----------
    text : str
        What somebody wrote for a place.

    Returns
    -------
    (float, float) or None
        Longitude and latitude [degrees], within any bounds; None if the text is a name.

    Raises
    ------
    NetworkError
        It is meant as a coordinate and may be read in two ways, or has hemispheres.
    """
    # Typographers' minus, and a blank that does not break.
    own = " ".join(text.replace("\u2212", "-").translate(BRACKETS).split())
    if len(own) > LONGEST:
        return None
    if AMBIGUOUS.fullmatch(own):
        raise NetworkError(
            f"place {brief(text)}: may be one number or two; write longitude and latitude with a "
            "decimal point, as 10.22, 45.54"
        )
    for pair in PAIRS:
        if found := pair.fullmatch(own):
            lon, lat = (float(part.replace(",", ".")) for part in found.groups())
            return lon, lat
    if HEMISPHERES.search(own) and printed_position(own) is None:
        raise NetworkError(
            f"place {brief(text)}: write longitude and latitude in degrees, as 10.22, 45.54; west "
            "and south are negative"
        )
    return None


def printed_position(text: str) -> tuple[float, float] | None:
    """Return the coordinates at the end of a name, as `format_position` prints them.

    Parameters
    ----------
    text : str
        Such as "A 4 near Torino (45.070 N 7.690 E)".

    Returns
    -------
    (float, float) or None
        Longitude and latitude [deg]; None if there are none.
    """
    found = POSITION.search(plain(text))
    if found is None:
        return None
    lat = float(found[1]) * (1 if found[2] == "n" else -1)
    return float(found[3]) * (1 if found[4] == "e" else -1), lat
