"""How much goes onto one sheet: type sizes by what there is to say, and the room left for a map.

Heights are estimates from the rather too wide widths of `text_width`; the map takes what is left,
so that an estimate that is wrong by some lines makes it smaller and cuts nothing.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from dataclasses import dataclass

from ..maps.map_texts import text_width
from .words import StepWords

__all__ = ["CROWDED", "MAP_WIDTH_MM", "Layout", "layout_of"]

MM = 96 / 25.4
"""Pixels of a style sheet in a millimetre."""

PAGE_MM = 271.0
"""Of a sheet, between the margins of A4."""

MAP_WIDTH_MM = 186.0

GOOD_MAP_MM = 46.0
"""How high a map should be before larger type is taken."""

DRAWN_MAP_MM = (40.0, 150.0)
"""Least and greatest height for which a map is drawn; the style sheet hides what has no room."""

LIKELY = 0.9
"""Of an estimated height, what steps take at most in common faces."""

WITHOUT_MAP = ("dense", "tight")
"""Types that do without a map, rather than that steps become rows of a table."""

ROW_PX = 10.2
WHAT_MM, PLACE_MM, ROW_LINE_MM = 68.0, 62.0, 3.4
"""Of a table's rows: type, widths of two columns, and the height of a line."""

CROWDED = "crowded"


@dataclass(frozen=True, slots=True)
class _Type:
    """Sizes of one density, as assets/sheets.css has them: type [px], line, text and gap [mm]."""

    size_px: float
    line_mm: float
    width_mm: float
    gap_mm: float


TYPES = {
    "roomy": _Type(13.4, 5.1, 148.0, 5.5),
    "medium": _Type(12.4, 4.7, 149.0, 3.8),
    "dense": _Type(11.4, 4.3, 150.0, 2.6),
    "tight": _Type(10.4, 3.8, 151.0, 1.3),
}


@dataclass(frozen=True, slots=True)
class Layout:
    """How a sheet is set.

    Attributes
    ----------
    density : {"roomy", "medium", "dense", "tight", "crowded"}
        Class of the sheet.
    map_mm : float
        About how high the map is.
    rows : int
        How many steps are told.
    """

    density: str
    map_mm: float
    rows: int


def layout_of(words: Sequence[StepWords], head_mm: float) -> Layout:
    """Return how a sheet is set.

    Parameters
    ----------
    words : sequence of StepWords
        All steps.
    head_mm : float
        What all the rest of the sheet takes but steps and map.

    Returns
    -------
    Layout
        The largest type in which there is room for a map; small type also without one, before steps
        become a table.
    """
    room = PAGE_MM - head_mm
    for density, sizes in TYPES.items():
        taken = sum(_height(one, sizes) for one in words)
        left = room - LIKELY * taken
        if left >= GOOD_MAP_MM:
            return Layout(density, _drawn(left), len(words))
        if density in WITHOUT_MAP and LIKELY * taken <= room - 6:
            return Layout(density, _drawn(left), len(words))
    left = room - 12.0
    heights = [_row_height(one) for one in words]
    rows = len(words)
    while rows > 2 and sum(heights[:rows]) > left:
        rows -= 1
    left -= sum(heights[:rows])
    return Layout(CROWDED, _drawn(left), rows)


def _drawn(left_mm: float) -> float:
    least, most = DRAWN_MAP_MM
    return min(max(left_mm, least), most)


def _row_height(words: StepWords) -> float:
    lines = max(
        lines_of(words.what, ROW_PX, WHAT_MM),
        lines_of(f"{words.place}  {words.at}", ROW_PX, PLACE_MM),
    )
    return 1.0 + lines * ROW_LINE_MM


def _height(words: StepWords, sizes: _Type) -> float:
    lines = sum(lines_of(text, sizes.size_px, sizes.width_mm) for text in _texts(words))
    # The order of driving is a line or two of discs, and a box has a border.
    order = 1.6 if words.kind in ("merge", "separation", "start") else 0.0
    return lines * sizes.line_mm + order * sizes.line_mm + bool(words.without) * 2.0 + sizes.gap_mm


def _texts(words: StepWords) -> Iterable[str]:
    return filter(
        None,
        (words.what, f"{words.place}  {words.at}", words.wait, words.without, words.way),
    )


def lines_of(text: str, size_px: float, width_mm: float) -> int:
    """Return about how many lines a text takes.

    Parameters
    ----------
    text : str
        The text.
    size_px : float
        Of its type.
    width_mm : float
        Of a line.

    Returns
    -------
    int
        One or more.
    """
    return max(1, math.ceil(text_width(text, size_px) * 1.05 / (width_mm * MM)))
