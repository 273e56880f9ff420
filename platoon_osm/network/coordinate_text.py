"""Coordinates written as text: "10.22, 45.54", and with the decimal comma "10,22; 45,54".

Longitude comes first, as everywhere here. A text of two numbers is never a name.
"""

from __future__ import annotations

import re

from ..errors import NetworkError, brief

__all__ = ["coordinates_in"]

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
    plain = " ".join(text.replace("\u2212", "-").translate(BRACKETS).split())
    if len(plain) > LONGEST:
        return None
    if AMBIGUOUS.fullmatch(plain):
        raise NetworkError(
            f"place {brief(text)}: may be one number or two; write longitude and latitude with a "
            "decimal point, as 10.22, 45.54"
        )
    for pair in PAIRS:
        if found := pair.fullmatch(plain):
            lon, lat = (float(part.replace(",", ".")) for part in found.groups())
            return lon, lat
    if HEMISPHERES.search(plain):
        raise NetworkError(
            f"place {brief(text)}: write longitude and latitude in degrees, as 10.22, 45.54; west "
            "and south are negative"
        )
    return None
