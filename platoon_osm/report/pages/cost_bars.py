"""Bars of what the platoon gains each vehicle, against what its longer way costs it."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from ..charts.axes import WIDTH
from ..document.bill_parts import stood_cents
from ..document.model import Document
from ..document.model_vehicle import Vehicle
from ..language.speech import say
from ..markup.fragments import NOTHING, Piece, Tree

__all__ = ["cost_bars"]

BARS_LEFT, BARS_END = 34.0, WIDTH
BAR_ROW = 30

DIGIT, NET_DIGIT = 6.3, 7.4
"""Width of a letter of a number in pixels, and of one in bold."""

LEAST_ROOM = 24.0
"""Of the bars of losses, where texts take nearly all, in pixels."""


@dataclass(frozen=True, slots=True)
class _Scale:
    """Where zero lies, what a pixel is worth, and whether gain and detour are told apart."""

    zero: float
    per_pixel: float
    split: bool


def cost_bars(document: Document, members: Sequence[int], key: str = "") -> Tree:
    """Return a bar per vehicle.

    Parameters
    ----------
    document : Document
        Whose vehicles they are.
    members : sequence of int
        Their positions.
    key : str
        Ends the ids in the picture, so that several stand on one page.

    Returns
    -------
    Tree
        An SVG; nothing if nobody gains or loses.
    """
    vehicles = [document.vehicles[index] for index in members]
    split = all(vehicle.detour is not None for vehicle in vehicles)
    both = [_gain_and_loss(vehicle, split) for vehicle in vehicles]
    longer = say("bars.longer-waiting" if _pays_for_time(document) else "bars.longer")
    most_gain, most_loss = (max(values) for values in zip(*both, strict=True))
    if most_gain + most_loss <= 0:
        return NOTHING
    # Texts are kept room for: of the net at the right, of a loss left of its bar, and of a gain,
    # which begins on its bar and may reach beyond it.
    right = BARS_END - _room([vehicle.text.saved for vehicle in vehicles], NET_DIGIT)
    label_room = 0.0
    if most_loss > 0:
        label_room = max(
            _room([one.text.detour for one in vehicles], DIGIT) + 5,
            _room([longer], DIGIT) - BARS_LEFT,
        )
    gain_room = _room([one.text.gain for one in vehicles], DIGIT) + 6 if split else 0.0
    room = right - BARS_LEFT - label_room
    loss_share = most_loss / (most_gain + most_loss)
    if loss_share * room > room - gain_room:
        room = min(room, max(room - gain_room, LEAST_ROOM) / loss_share)
    per_pixel = (most_gain + most_loss) / room
    zero = BARS_LEFT + label_room + most_loss / per_pixel
    scale = _Scale(zero, per_pixel, split)
    rows = [
        _bar_row(document, index, gain, loss, scale, 22 + BAR_ROW * place)
        for place, (index, (gain, loss)) in enumerate(zip(members, both, strict=True))
    ]
    heads = [(f"{WIDTH:g}", "end", say("bars.net"))]
    if split:
        heads.append((f"{zero + 6:.1f}", "start", say("bars.gained")))
        if most_loss > 0:
            heads.append((f"{zero - 6:.1f}", "end", longer))
    else:
        heads.append((f"{zero + 6:.1f}", "start", say("bars.saved")))
    title = say("bars.split" if split else "bars.plain", unit=document.cost_unit.label)
    return Piece(
        "bars",
        {
            "key": key,
            "title": title,
            "label": say("bars.label", title=title),
            "note": Piece("bars-note") if split and most_gain > 0 else NOTHING,
            "height": 22 + BAR_ROW * len(vehicles) - 4,
            "zero": f"{zero:.1f}",
            "heads": tuple(
                Piece("bars-head", {"x": x, "anchor": anchor, "text": text})
                for x, anchor, text in heads
            ),
            "rows": tuple(rows),
        },
    )


def _pays_for_time(document: Document) -> bool:
    """Return whether somebody pays for standing or being late, which the losses then hold."""
    bill = document.bill
    return bill is not None and any(
        stood_cents(bill, index) > 0 for index in range(len(document.vehicles))
    )


def _room(texts: Sequence[str], letter: float) -> float:
    """Return the width of the longest text, with a gap before it."""
    return max(map(len, texts), default=0) * letter + 10


def _gain_and_loss(vehicle: Vehicle, split: bool) -> tuple[float, float]:
    """Return gain and detour where all are known, else what is saved or lost."""
    if split and vehicle.platoon_gain is not None and vehicle.detour is not None:
        return vehicle.platoon_gain, vehicle.detour
    return max(vehicle.saved, 0.0), max(-vehicle.saved, 0.0)


def _bar_row(
    document: Document, index: int, gain: float, loss: float, scale: _Scale, y: float
) -> Piece:
    vehicle = document.vehicles[index]
    zero, per_pixel, split = scale.zero, scale.per_pixel, scale.split
    shapes: list[Piece] = []
    if loss > 0:
        left = zero - loss / per_pixel
        shapes.append(
            Piece(
                "bar-loss",
                {
                    "x": f"{left:.1f}",
                    "width": f"{zero - left:.1f}",
                    "text_x": f"{left - 5:.1f}",
                    "text": vehicle.text.detour if split else "",
                },
            )
        )
    if gain > 0:
        shapes.append(
            Piece(
                "bar-gain",
                {
                    "x": f"{zero:.1f}",
                    "width": f"{gain / per_pixel:.1f}",
                    "text_x": f"{zero + 6:.1f}",
                    "colour": vehicle.colour,
                    "text": vehicle.text.gain if split else "",
                },
            )
        )
    if gain > 0 and split:
        shapes.append(Piece("bar-net", {"x": f"{zero + (gain - loss) / per_pixel:.1f}"}))
    return Piece(
        "bars-row",
        {
            "y": f"{y:g}",
            "index": index,
            "colour": vehicle.colour,
            "letter": vehicle.letter,
            "size": vehicle.letter_size,
            "shapes": tuple(shapes),
            "net": vehicle.text.saved,
        },
    )
