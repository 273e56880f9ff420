"""The way of each vehicle by distance, where a plan has no times."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence

from ..document.model import Document
from ..document.model_map import EventMark
from ..drawing.crowd import MOST_SPOKEN
from ..drawing.palette import MUTED, TICK
from ..language.speech import say
from ..markup.fragments import NOTHING, Piece, Tree
from .axes import SIZE, WIDTH, Tick, letter_type, number_scale

__all__ = ["along_chart", "ticks_of"]

LEFT, RIGHT = 34.0, WIDTH - 8
ALONG_TOP, ALONG_ROW = 30, 26

ICON_WIDTH = 15.0


def along_chart(document: Document, members: Sequence[int], key: str = "") -> Tree:
    """Return the way of some vehicles by distance: platoon in yellow, merges and separations.

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
        An SVG; nothing if there is no common scale.
    """
    scale = document.journey
    if scale is None or not members:
        return NOTHING
    vehicles, starts = document.vehicles, scale.starts_m
    end_m = max(starts[i] + vehicles[i].length_m for i in members)
    per_metre = (RIGHT - LEFT) / max(end_m, 1.0)
    bottom = ALONG_TOP + ALONG_ROW * len(members)
    rows = [
        _along_row(document, index, starts[index], ALONG_TOP + ALONG_ROW * place, per_metre)
        for place, index in enumerate(members)
    ]
    here = frozenset(members)
    events = [pair for pair in enumerate(document.events) if pair[1].concerns(here)]
    return Piece(
        "along",
        {
            "key": key,
            "height": f"{bottom + 20:g}",
            "zero": LEFT,
            "end": RIGHT,
            "per_metre": f"{per_metre:.9g}",
            "bottom": bottom,
            "rows": tuple(rows),
            "ticks": tuple(
                ticks_of(_distances(end_m, per_metre), LEFT, per_metre * 1000, 22, bottom)
            ),
            "events": tuple(_event_marks(events, per_metre, bottom)),
            "title": say(
                "along.title",
                who="; ".join(
                    f"{vehicles[i].letter} {vehicles[i].length_text}" for i in members[:MOST_SPOKEN]
                ),
            ),
            "note": " ".join(_along_notes(document, members)),
        },
    )


def _along_notes(document: Document, members: Sequence[int]) -> Iterator[str]:
    """Yield what the drawing means; pages without a platoon do not speak of one."""
    if any(kind == "platoon" for index in members for kind, _ in document.vehicles[index].way):
        yield say("along.level")
    yield say("along.no-times")


def _distances(end_m: float, per_metre: float) -> list[Tick]:
    return number_scale(end_m / 1000, per_metre * 1000, LEFT, (0.0, WIDTH), "km")


def _along_row(document: Document, index: int, at: float, y: float, per_metre: float) -> Piece:
    vehicle = document.vehicles[index]
    first = LEFT + at * per_metre
    bands: list[Piece] = []
    for kind, piece in vehicle.way:
        length = document.piece_m(kind, piece)
        if kind == "platoon":
            x = f"{LEFT + at * per_metre:.1f}"
            bands.append(Piece("along-band", {"x": x, "width": f"{length * per_metre:.1f}"}))
        at += length
    return Piece(
        "along-row",
        {
            "y": f"{y:g}",
            "index": index,
            "colour": vehicle.colour,
            "letter": vehicle.letter,
            "size": letter_type(vehicle.letter),
            "bands": tuple(bands),
            "x1": f"{first:.1f}",
            "x2": f"{LEFT + at * per_metre:.1f}",
            "square": f"{LEFT + at * per_metre - 3.5:.1f}",
            "dash": vehicle.stroke,
            "cap": vehicle.cap,
        },
    )


def ticks_of(
    ticks: Sequence[Tick], zero: float, per_unit: float, top: float, bottom: float
) -> Iterator[Piece]:
    """Yield lines of a scale with their labels below.

    Parameters
    ----------
    ticks : sequence of Tick
        Of the scale.
    zero, per_unit : float
        Where its 0 lies, and pixels per unit.
    top, bottom : float
        Ends of its lines.

    Yields
    ------
    Piece
        A line with its label.
    """
    for tick in ticks:
        texts = (
            Piece(
                "tick-text",
                {"x": f"{tick.place:.1f}", "y": f"{bottom + SIZE * (1 + k) + 3:g}", "text": text},
            )
            for k, text in enumerate(tick.texts)
        )
        yield Piece(
            "tick",
            {
                "x": f"{zero + tick.at * per_unit:.1f}",
                "top": f"{top:g}",
                "bottom": f"{bottom:g}",
                "colour": MUTED if tick.strong else TICK,
                "dash": "5 3" if tick.strong else "none",
                "texts": tuple(texts),
            },
        )


def _event_marks(
    events: Sequence[tuple[int, EventMark]], per_metre: float, bottom: float
) -> Iterator[Piece]:
    last = -math.inf
    placed = [(event.at_m, index, event) for index, event in events if event.at_m is not None]
    for at_m, index, event in sorted(placed, key=lambda one: one[:2]):
        x = LEFT + at_m * per_metre
        # Icons of points near each other stand side by side; their lines tell the true place.
        icon = max(x, last + ICON_WIDTH)
        last = icon
        yield Piece(
            "along-event",
            {
                "index": index,
                "x": f"{x:.1f}",
                "icon_x": f"{icon:.1f}",
                "icon": event.kind,
                "bottom": bottom,
                "title": f"{event.name}: {event.text}",
            },
        )
