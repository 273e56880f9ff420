"""How vehicles are told apart: a letter, a colour and a dash, no two vehicles alike in all.

A short name is its vehicle's letter; the others get letters that are nobody's name.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass
from itertools import count

from ...shown_text import shown
from .palette import VEHICLES

__all__ = ["VehicleStyle", "letter_size", "vehicle_styles"]

# Seven dashes and eight colours: 56 vehicles before a pair of them returns.
# The cap of dots is round, or they would be specks.
DASHES = (
    ("", "butt"),
    ("9 5", "butt"),
    ("2 6", "round"),
    ("14 4 2 4", "butt"),
    ("5 4", "butt"),
    ("18 6", "butt"),
    ("9 4 2 4 2 4", "butt"),
)

LONGEST_LETTER = 3

LETTER_SIZES = (11.0, 9.0, 8.0)
"""Of one letter, two, and more, so that they fit their disc."""

WIDE, WIDER_BY = "MWmw", 0.09
"""Letters that are wider than others, and the share by which each makes the type smaller."""


@dataclass(frozen=True, slots=True)
class VehicleStyle:
    """How one vehicle looks in every picture.

    Attributes
    ----------
    letter : str
        What it is called there.
    colour : str
        Of its line and its disc.
    dash : str
        SVG dash array; empty if its line is solid.
    cap : str
        SVG line cap.
    """

    letter: str
    colour: str
    dash: str
    cap: str


def vehicle_styles(names: Sequence[str]) -> list[VehicleStyle]:
    """Return the style of each vehicle.

    A name of up to three ASCII letters and digits is its vehicle's letter. The others get A to Z,
    AA, AB and on, without those that are a vehicle's name in whichever case.

    Parameters
    ----------
    names : sequence of str
        Of the vehicles.

    Returns
    -------
    list of VehicleStyle
        In the order of the names.
    """
    plain = [shown(name) for name in names]
    taken = {name.casefold() for name in plain}
    free = (letters for index in count() if (letters := _letters(index)).casefold() not in taken)
    how_often = Counter(plain)
    own = [_serves(name) and how_often[name] == 1 for name in plain]
    return [
        VehicleStyle(
            name if serves else next(free),
            VEHICLES[i % len(VEHICLES)],
            *DASHES[i % len(DASHES)],
        )
        for i, (name, serves) in enumerate(zip(plain, own, strict=True))
    ]


def _serves(name: str) -> bool:
    """Return whether a name may stand in a disc, and in the middle of any sentence."""
    return len(name) <= LONGEST_LETTER and name.isascii() and name.isalnum()


def _letters(index: int) -> str:
    text = ""
    index += 1
    while index:
        index, rest = divmod(index - 1, 26)
        text = chr(ord("A") + rest) + text
    return text


def letter_size(letter: str) -> float:
    """Return the type size at which a vehicle's letter, or a count, fits its disc.

    Parameters
    ----------
    letter : str
        One letter or more.

    Returns
    -------
    float
        In pixels.
    """
    size = LETTER_SIZES[min(max(len(letter), 1), len(LETTER_SIZES)) - 1]
    wide = sum(sign in WIDE for sign in letter) if len(letter) > 1 else 0
    return round(size * (1 - WIDER_BY * wide), 1)
