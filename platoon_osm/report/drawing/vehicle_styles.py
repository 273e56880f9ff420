"""How vehicles are told apart: a letter, a colour and a dash, no two vehicles alike in all."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

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

LONGEST_LETTER = 2

LETTER_SIZES = (11.0, 9.0, 8.0)
"""Of one letter, two, and more, so that they fit their disc."""


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

    Short names serve as letters themselves; otherwise letters run A to Z, AA, AB and on.

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
    serve = len(set(plain)) == len(plain) and all(
        name.isascii() and name.isalnum() and len(name) <= LONGEST_LETTER for name in plain
    )
    return [
        VehicleStyle(
            plain[i] if serve else _letters(i),
            VEHICLES[i % len(VEHICLES)],
            *DASHES[i % len(DASHES)],
        )
        for i in range(len(plain))
    ]


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
    return LETTER_SIZES[min(max(len(letter), 1), len(LETTER_SIZES)) - 1]
