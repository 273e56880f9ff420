"""Bars of what the platoon gains each vehicle, against what its longer way costs it."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from ..document.model import Document
from ..document.model_vehicle import Vehicle
from ..markup.fragments import NOTHING, Piece, Tree

__all__ = ["cost_bars"]

BARS_LEFT, BARS_RIGHT = 34.0, 304.0
BAR_ROW = 30


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
    most_gain, most_loss = (max(values) for values in zip(*both, strict=True))
    if most_gain + most_loss <= 0:
        return NOTHING
    # Text of a loss stands left of its bar, so room is kept for it if there is any loss.
    label_room = 52.0 if most_loss > 0 else 0.0
    room = BARS_RIGHT - BARS_LEFT - label_room
    per_pixel = (most_gain + most_loss) / room
    zero = BARS_LEFT + label_room + most_loss / per_pixel
    scale = _Scale(zero, per_pixel, split)
    rows = [
        _bar_row(document, index, gain, loss, scale, 22 + BAR_ROW * place)
        for place, (index, (gain, loss)) in enumerate(zip(members, both, strict=True))
    ]
    heads = [("372", "end", "net")]
    if split:
        heads.append((f"{zero + 6:.1f}", "start", "gained in platoon"))
        if most_loss > 0:
            heads.append((f"{zero - 6:.1f}", "end", "longer way"))
    else:
        heads.append((f"{zero + 6:.1f}", "start", "saved"))
    unit = document.cost_unit.label
    return Piece(
        "bars",
        {
            "key": key,
            "title": f"{'Gain in platoon, less the longer way' if split else 'Saving'}, {unit}",
            "height": 22 + BAR_ROW * len(vehicles) - 4,
            "zero": f"{zero:.1f}",
            "heads": tuple(
                Piece("bars-head", {"x": x, "anchor": anchor, "text": text})
                for x, anchor, text in heads
            ),
            "rows": tuple(rows),
        },
    )


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
