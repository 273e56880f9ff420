"""Texts of heights and slopes: `ele` of nodes, `incline` of ways.

A height is in metres, or in feet where it says so. A slope is in percent, in degrees, or a ratio;
"up" and "down" tell its sign and not its size, so they are counted and nothing is made of them. A
bare number other than 0 has no unit, and is not read either.

Sources: https://wiki.openstreetmap.org/wiki/Key:ele and Key:incline.
"""

from __future__ import annotations

import re
from collections.abc import Mapping
from math import isnan, nan, radians, tan

from ..vehicles.units import FOOT_M

__all__ = ["INCLINE_TAGS", "STEEPEST", "read_height_m", "read_slope", "slope_along"]

INCLINE_TAGS = frozenset({"incline", "incline:forward", "incline:backward"})

STEEPEST = 0.3
"""Rise over length; no road that trucks drive is steeper, but a digit too many is."""

LOWEST_M, HIGHEST_M = -450.0, 9000.0
"""The shore of the Dead Sea lies at -430 m, and no road reaches 6,000 m."""

NUMBER = r"[-+\u2212]?[0-9][0-9.,\u00a0\u202f ']*"
HEIGHT = re.compile(rf"({NUMBER}?) ?(m|metres?|meters?|ft|feet|foot|'|\u2032)?", re.IGNORECASE)
SLOPE = re.compile(rf"({NUMBER}?) ?(%|\u2030|\u00b0|deg|degrees?)", re.IGNORECASE)
RATIO = re.compile(r"([-+\u2212]?)([0-9]+(?:[.,][0-9]+)?) ?(?::|in) ?([0-9]+(?:[.,][0-9]+)?)")
RANGE = re.compile(rf"({NUMBER}?) ?(%|\u00b0)? ?(?:-|\u2013|to) ?([0-9][0-9.,]*) ?(%|\u00b0)")
ROUGHLY = re.compile(r"^(?:~|ca\.?|approx\.?|about) ?", re.IGNORECASE)
FEET = frozenset({"ft", "feet", "foot", "'", "\u2032"})
WORDS = frozenset({"up", "down", "yes", "up/down", "up;down", "down;up", "both"})
"""Values that say that a road is steep and not how steep."""

NO_SIZE = "incline without a size (up, down)"
UNREAD = "incline not understood"
STEEP = f"incline of more than {100 * STEEPEST:g} %, ignored"


def read_height_m(text: str) -> float:
    """Read a height.

    Parameters
    ----------
    text : str
        "350", "350.5 m", "1,148 ft"; of several ("350;352") the mean.

    Returns
    -------
    float
        Metres above sea level [m]; NaN where it is none, infinite where no road can be so high or
        so low.
    """
    heights = [_height_m(part) for part in text.split(";") if part.strip()]
    if not heights or any(isnan(height) for height in heights):
        return nan
    if not all(LOWEST_M <= height <= HIGHEST_M for height in heights):
        return float("inf")
    return sum(heights) / len(heights)


def _height_m(text: str) -> float:
    found = HEIGHT.fullmatch(ROUGHLY.sub("", " ".join(text.split())))
    if not found:
        return nan
    factor = FOOT_M if (found.group(2) or "").lower() in FEET else 1.0
    height = _number(found.group(1)) * factor
    if height > HIGHEST_M and found.group(1).count(",") == 1:
        height = _number(found.group(1).replace(",", ".")) * factor
    return height


def _number(text: str) -> float:
    """Read a number with a decimal point or comma, and marks between thousands; NaN if it is none.

    A mark that stands before three digits divides thousands, for heights are given to the decimetre
    at best; of two kinds of marks the last is the decimal one.
    """
    text = text.replace("\u2212", "-").strip()
    digits = re.sub(r"(?<=[0-9])[\u00a0\u202f ' ](?=[0-9]{3}(?![0-9]))", "", text)
    if re.fullmatch(r"[-+]?[1-9][0-9]{0,2}(,[0-9]{3})+(\.[0-9]+)?", digits):
        digits = digits.replace(",", "")
    elif re.fullmatch(r"[-+]?[1-9][0-9]{0,2}(\.[0-9]{3})+,[0-9]+", digits):
        digits = digits.replace(".", "").replace(",", ".")
    else:
        digits = digits.replace(",", ".")
    try:
        return float(digits)
    except ValueError:
        return nan


def read_slope(text: str) -> tuple[float, str]:
    """Read a slope.

    Parameters
    ----------
    text : str
        "5%", "-7,5 %", "10\u00b0", "1:12", "0"; of several or of a range the mean, if they lean one
        way.

    Returns
    -------
    slope : float
        Rise over length, 0.05 being 5 %; NaN where none can be read.
    remark : str
        What to count it as; empty where it was read.
    """
    parts = [part for part in text.replace("\u2013", "-").split(";") if part.strip()]
    if text.strip().lower() in WORDS or all(part.strip().lower() in WORDS for part in parts):
        return nan, NO_SIZE if parts else UNREAD
    slopes = [slope for part in parts for slope in _slopes(" ".join(part.split()).lower())]
    if any(isnan(slope) for slope in slopes) or min(slopes) < 0 < max(slopes):
        return nan, UNREAD
    slope = sum(slopes) / len(slopes)
    return (nan, STEEP) if abs(slope) > STEEPEST else (slope, "")


def _slopes(text: str) -> tuple[float, ...]:
    text = ROUGHLY.sub("", text)
    if text in ("0", "flat", "level"):
        return (0.0,)
    if found := RATIO.fullmatch(text):
        sign, rise, run = found.groups()
        length = _decimal(run)
        return (
            (-1 if sign in ("-", "\u2212") else 1) * _decimal(rise) / length if length else nan,
        )
    if found := RANGE.fullmatch(text):
        first, unit, last, last_unit = found.groups()
        if unit not in (None, last_unit):
            return (nan,)
        low, high = _decimal(first), _decimal(last)
        # "-5-10%" is a fall of 5 to 10 %.
        return _slope(low, last_unit), _slope(high if low >= 0 else -high, last_unit)
    found = SLOPE.fullmatch(text)
    return (_slope(_decimal(found.group(1)), found.group(2)) if found else nan,)


def _decimal(text: str) -> float:
    try:
        return float(text.replace("\u2212", "-").replace(",", ".").replace(" ", ""))
    except ValueError:
        return nan


def _slope(value: float, unit: str) -> float:
    if unit == "%":
        return value / 100
    if unit == "\u2030":
        return value / 1000
    # The tangent of a right angle and of what lies beyond it says nothing.
    return tan(radians(value)) if abs(value) < 80 else nan


def slope_along(tags: Mapping[str, str]) -> tuple[float, str]:
    """Return the slope of a way along its direction as it is drawn.

    Parameters
    ----------
    tags : mapping of str to str
        Of a way. What holds against it alone, `incline:backward`, is turned round.

    Returns
    -------
    slope : float
        Rise over length; NaN where none can be read.
    remark : str
        What to count it as; empty where it was read or nothing is said.
    """
    for key, sign in (("incline", 1), ("incline:forward", 1), ("incline:backward", -1)):
        if key in tags:
            slope, remark = read_slope(tags[key])
            return sign * slope, remark
    return nan, ""
