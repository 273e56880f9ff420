"""How vehicles are told apart: a letter, a colour and a dash, no two vehicles alike in all."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from ..markup.shown_text import shown

__all__ = ["VehicleStyle", "letter_size", "vehicle_styles"]

# All keep 4.5:1 against white, so that a white letter reads on them and they read on paper;
# neighbours in the list differ for the three common kinds of colour blindness.
COLOURS = (
    "#0072b2", "#c14900", "#007a5a", "#8f3c97", "#7a5a00", "#b3124f", "#4152c4", "#4d5560",
)  # fmt: skip

# Seven dashes and eight colours: 56 vehicles before a pair of them returns.
# The cap of dots is round, or they would be specks.
DASHES = (
    ("", "butt"), ("9 5", "butt"), ("2 6", "round"), ("14 4 2 4", "butt"), ("5 4", "butt"),
    ("18 6", "butt"), ("9 4 2 4 2 4", "butt"),
)  # fmt: skip

LONGEST_LETTER = 2


@dataclass(frozen=True, slots=True)
class VehicleStyle:
    """Letter, stroke colour, dash array (empty: solid) and line cap of one vehicle."""

    letter: str
    colour: str
    dash: str
    cap: str


def vehicle_styles(names: Sequence[str]) -> list[VehicleStyle]:
    """Return the style of each vehicle, in order.

    Short names serve as letters themselves; otherwise letters run A to Z, AA, AB and on.
    """
    plain = [shown(name) for name in names]
    serve = len(set(plain)) == len(plain) and all(
        name.isascii() and name.isalnum() and len(name) <= LONGEST_LETTER for name in plain
    )
    return [
        VehicleStyle(
            plain[i] if serve else _letters(i),
            COLOURS[i % len(COLOURS)],
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


def letter_size(letter: str) -> str:
    """Return the type size at which a vehicle's letter, or two, fits its disc."""
    return "11" if len(letter) == 1 else "9"
