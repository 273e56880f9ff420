"""Names of places above a scale: flags on poles, in rows, none over another nor over a pole."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from ..maps.map_texts import clipped
from .axes import text_width

__all__ = ["Flag", "Flagged", "flags"]

MOST_ROWS = 6
MOST_FLAGS = 10

MOST_TRIES = 400
"""Steps of the search for room; what is not found by then is left out."""

WIDEST = 0.48
"""Greatest width of a name, as a share of the chart's."""

POLE, GAP = 3.0, 6.0
"""Blank between a pole and its name, and between two names of a row."""


@dataclass(frozen=True, slots=True)
class Flagged:
    """What wants a flag.

    Attributes
    ----------
    x : float
        Where, in pixels.
    text : str
        Its name.
    weight : int
        The greater, the sooner it gets one.
    """

    x: float
    text: str
    weight: int


@dataclass(frozen=True, slots=True)
class Flag:
    """A name on a pole.

    Attributes
    ----------
    x : float
        Of the pole, in pixels.
    row : int
        How high it hangs; 0 is the lowest.
    left, right : float
        Ends of the name.
    text : str
        The name, shortened if it is long.
    anchor : str
        "start" if it hangs to the right of its pole, else "end".
    """

    x: float
    row: int
    left: float
    right: float
    text: str
    anchor: str

    @property
    def text_x(self) -> float:
        """Where the name is anchored."""
        return self.left if self.anchor == "start" else self.right


def flags(wanted: Sequence[Flagged], width: float, size: float) -> list[Flag]:
    """Return the flags that find room, the weightiest first.

    Parameters
    ----------
    wanted : sequence of Flagged
        What is to be named.
    width : float
        Of the chart, in pixels.
    size : float
        Of the type.

    Returns
    -------
    list of Flag
        From left to right.
    """
    chosen: list[Flagged] = []
    found: list[Flag] = []
    for one in sorted(wanted, key=lambda one: (-one.weight, one.x, one.text)):
        if len(chosen) == MOST_FLAGS:
            break
        hung = _hung([*chosen, one], width, size)
        if hung is not None:
            chosen.append(one)
            found = hung
    return found


def _hung(some: Sequence[Flagged], width: float, size: float) -> list[Flag] | None:
    """Return a flag for each in as few rows as will do; None if one finds no room."""
    ordered = sorted(some, key=lambda one: (-one.x, one.text))
    texts = [clipped(one.text, size, widest=width * WIDEST) for one in ordered]
    choices: list[list[Flag]] = []
    for one, text in zip(ordered, texts, strict=True):
        long, right, left = text_width(text, size), one.x + POLE, one.x - POLE
        both = [
            Flag(one.x, row, low, high, text, anchor)
            for row in range(MOST_ROWS)
            for low, high, anchor in ((right, right + long, "start"), (left - long, left, "end"))
        ]
        choices.append([flag for flag in both if flag.left >= 0 and flag.right <= width])
    for rows in range(1, MOST_ROWS + 1):
        found = _search([[one for one in some if one.row < rows] for some in choices])
        if found is not None:
            return found[::-1]
    return None


def _search(choices: Sequence[Sequence[Flag]]) -> list[Flag] | None:
    """Return one choice for each so that none is in another's way, if it is found soon enough."""
    hung: list[Flag] = []
    nexts = [0]
    for _ in range(MOST_TRIES):
        level = len(hung)
        options = choices[level]
        place = next(
            (k for k in range(nexts[-1], len(options)) if all(_free(options[k], o) for o in hung)),
            None,
        )
        if place is None:
            nexts.pop()
            if not hung:
                return None
            hung.pop()
            continue
        nexts[-1] = place + 1
        hung.append(options[place])
        if len(hung) == len(choices):
            return hung
        nexts.append(0)
    return None


def _free(flag: Flag, other: Flag) -> bool:
    """Return whether neither name touches the other, nor the pole of the other."""
    if flag.row == other.row:
        return flag.right + GAP <= other.left or other.right + GAP <= flag.left
    high, low = (flag, other) if flag.row > other.row else (other, flag)
    return not low.left - POLE < high.x < low.right + POLE
