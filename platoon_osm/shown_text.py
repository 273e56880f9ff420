"""Other people's text made fit to be shown: whole, but unable to move or hide its neighbours.

This is about sight, not about markup: escaping for HTML happens in `fragments`, and for JSON in
`page`. Every name of a map, scenario or vehicle passes here once, on its way into the document.
"""

from __future__ import annotations

import re
import unicodedata

__all__ = ["fitted", "shortened", "shown", "well_formed"]

REPLACEMENT = "\ufffd"

MOST_MARKS = 4
"""Combining marks kept on one letter; living languages need three."""

LONGEST_TEXT = 400
"""No text is longer than this in a page; the plan itself keeps it whole."""

# Written as code points so that this file holds none of the characters it is about: controls,
# line and paragraph separators, bidirectional embeddings, overrides and isolates, deprecated
# format characters, byte order mark, interlinear annotation, noncharacters, lone surrogates.
# Left-to-right and right-to-left marks stay: Arabic and Hebrew names need them, and they cannot
# reach beyond the isolate that a name is put in.
_UNFIT = re.compile(
    "[\u0000-\u001f\u007f-\u009f\u2028\u2029\u202a-\u202e\u2066-\u206f\ufeff"
    "\ufff9-\ufffb\ufdd0-\ufdef\ufffe\uffff\ud800-\udfff\U000e0001]"
)
_BLANK = re.compile("[\t\n\r ]+")
_HALVES = re.compile("[\ud800-\udfff]")


def well_formed(text: str) -> str:
    """Return a text that UTF-8 has bytes for: U+FFFD stands for halves of characters.

    Such halves come from JSON, and from names of files that are no UTF-8.

    Parameters
    ----------
    text : str
        Any.

    Returns
    -------
    str
        The same, unless it holds lone surrogates.
    """
    return _HALVES.sub(REPLACEMENT, text)


def shown(text: object) -> str:
    """Return a text with what cannot be seen, or reorders its surroundings, as U+FFFD.

    Runs of blanks become one space, as a browser would show them.

    Parameters
    ----------
    text : object
        Other people's text.

    Returns
    -------
    str
        The same, fit to be shown.
    """
    plain = _UNFIT.sub(REPLACEMENT, _BLANK.sub(" ", str(text)))
    if plain.isascii():
        return plain.strip()
    kept: list[str] = []
    marks = 0
    for character in plain:
        marks = marks + 1 if unicodedata.combining(character) else 0
        if marks <= MOST_MARKS:
            kept.append(character)
    return "".join(kept).strip()


def shortened(text: str, most: int) -> str:
    """Return a text that is not too long.

    Parameters
    ----------
    text : str
        Fit to be shown.
    most : int
        Characters it may have.

    Returns
    -------
    str
        The same, or its beginning and an ellipsis.
    """
    return text if len(text) <= most else text[: most - 1].rstrip() + "\u2026"


def fitted(text: object) -> str:
    """Return a text fit to be shown, at most `LONGEST_TEXT` long.

    Parameters
    ----------
    text : object
        Other people's text.

    Returns
    -------
    str
        As `shown` makes it.
    """
    return shortened(shown(text), LONGEST_TEXT)
