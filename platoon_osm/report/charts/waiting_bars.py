"""What a vehicle gains by waiting: bars of fuel saved against the time it waits on the road."""

from __future__ import annotations

from collections.abc import Sequence

from ...plans.clock import MENTIONED_S
from ..document.model import Document
from ..document.model_vehicle import Vehicle
from ..drawing.crowd import MOST_SPOKEN
from ..language.speech import say
from ..markup.fragments import NOTHING, Piece, Tree
from ..markup.quantities import litres, true_minus
from .axes import SIZE, WIDTH, letter_type, text_width

__all__ = ["waiting_bars"]

LEFT, ZERO = 24.0, 160.0
ROW = 28

ASIDE = 6.0
"""Blank between a bar and its text."""

MOST_TIME, LEAST_SCALE_S = 62.0, 600.0
"""Bars of time are at most so wide, and so wide only from this wait on."""


def waiting_bars(document: Document, members: Sequence[int], key: str = "") -> Tree:
    """Return a bar per vehicle: fuel saved on one side, time waited on the other.

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
        An SVG; nothing if the plan has no times, or nobody saves or waits.
    """
    if document.schedule is None or not members:
        return NOTHING
    vehicles = [document.vehicles[index] for index in members]
    saved = [vehicle.alone_fuel_l - vehicle.fuel_l for vehicle in vehicles]
    waits = [vehicle.day.waiting_s for vehicle in vehicles]
    if max(saved) <= 0 and max(waits) < MENTIONED_S:
        return NOTHING
    # Each text has room beside its bar, in any language.
    fuel_room = (WIDTH - ZERO - ASIDE - text_width(_litres(one), SIZE) for one in saved)
    per_litre = min(
        (room / one for room, one in zip(fuel_room, saved, strict=True) if one > 0), default=0.0
    )
    texts = (vehicle.day.text.waiting for vehicle in vehicles)
    time_room = (min(MOST_TIME, ZERO - LEFT - ASIDE - text_width(one, SIZE)) for one in texts)
    per_second = min(
        max(room, 0.0) / max(wait, LEAST_SCALE_S)
        for room, wait in zip(time_room, waits, strict=True)
    )
    rows = [
        _row(members[place], vehicle, litre * per_litre, wait * per_second, litre, 20 + ROW * place)
        for place, (vehicle, litre, wait) in enumerate(zip(vehicles, saved, waits, strict=True))
    ]
    return Piece(
        "waiting-bars",
        {
            "key": key,
            "height": 20 + ROW * len(vehicles) - 4,
            "zero": ZERO,
            "left": ZERO - 6,
            "right": ZERO + 6,
            "rows": tuple(rows),
            "title": say(
                "waiting.title",
                who="; ".join(
                    f"{vehicle.letter} {_litres(litre)}, {vehicle.day.text.waiting}"
                    for vehicle, litre in list(zip(vehicles, saved, strict=True))[:MOST_SPOKEN]
                ),
            ),
        },
    )


def _row(
    index: int, vehicle: Vehicle, fuel_width: float, wait_width: float, litre: float, y: float
) -> Piece:
    shapes: list[Piece] = []
    if fuel_width > 0:
        shapes.append(
            Piece(
                "waiting-fuel", {"x": ZERO, "width": f"{fuel_width:.1f}", "colour": vehicle.colour}
            )
        )
    shapes.append(
        Piece(
            "waiting-text",
            {
                "x": f"{ZERO + max(fuel_width, 0.0) + 6:.1f}",
                "anchor": "start",
                "text": _litres(litre),
            },
        )
    )
    if vehicle.day.waiting_s >= MENTIONED_S:
        shapes.append(
            Piece("waiting-time", {"x": f"{ZERO - wait_width:.1f}", "width": f"{wait_width:.1f}"})
        )
    else:
        wait_width = 0.0
    shapes.append(
        Piece(
            "waiting-text",
            {
                "x": f"{ZERO - wait_width - 6:.1f}",
                "anchor": "end",
                "text": vehicle.day.text.waiting,
            },
        )
    )
    return Piece(
        "waiting-row",
        {
            "y": y,
            "index": index,
            "colour": vehicle.colour,
            "letter": vehicle.letter,
            "size": letter_type(vehicle.letter),
            "shapes": tuple(shapes),
        },
    )


def _litres(litre: float) -> str:
    return true_minus(litres(litre))
