"""Callouts and names of towns on a still drawing, where they cover least."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass

from ..document.model import Document
from ..drawing.crowd import MANY_EVENTS
from ..drawing.lines import Point
from .placement import Box, Cover

__all__ = ["NAME_SIZE", "Callout", "clipped", "placed_callouts", "placed_names", "text_width"]

NAME_SIZE = 11.5
"""Of a town's name, in pixels."""

CALLOUT_HEIGHT = 34.0
WIDEST_CALLOUT = 270.0


@dataclass(frozen=True, slots=True)
class Callout:
    """A box with a text beside an event.

    Attributes
    ----------
    x, y : float
        Where the event is, in pixels.
    box : Box
        Where the text stands.
    head, line : str
        Its bold head, and the line below.
    near : tuple of float, or None
        Where a leader from the event ends; None if the box is near enough.
    """

    x: float
    y: float
    box: Box
    head: str
    line: str
    near: tuple[float, float] | None


def placed_callouts(
    document: Document, places: Sequence[Point | None], cover: Cover
) -> Iterator[Callout]:
    """Yield the callouts of all events that find room, where they cover least.

    Parameters
    ----------
    document : Document
        Whose events they are.
    places : sequence of tuple of float or None
        Where the events or their marks stand, in pixels; None for one that has no callout.
    cover : Cover
        What is taken already; callouts take their room.

    Yields
    ------
    Callout
        In the order of the events.
    """
    worst = 1_000 if len(document.events) <= MANY_EVENTS else 60
    for event, place in zip(document.events, places, strict=True):
        if place is None:
            continue
        x, y = place
        head = clipped(f"{event.kind.capitalize()}: {event.name}", 11.5, True)
        line = clipped(event.text, 11)
        width = 16 + max(text_width(head, 11.5, True), text_width(line, 11))
        box = cover.place(_around(x, y, width, CALLOUT_HEIGHT, (16, 30, 48, 70, 100)), worst)
        if box is None:
            continue
        near = min(max(x, box.left), box.right), min(max(y, box.top), box.bottom)
        far = math.hypot(near[0] - x, near[1] - y) > 20
        yield Callout(x, y, box, head, line, near if far else None)


def clipped(text: str, size: float, bold: bool = False, widest: float = WIDEST_CALLOUT) -> str:
    """Return a text, shortened if it is too wide.

    Parameters
    ----------
    text : str
        The text.
    size : float
        Of its type, in pixels.
    bold : bool
        Whether it is bold.
    widest : float
        Greatest width, in pixels.

    Returns
    -------
    str
        It ends in an ellipsis if something is missing.
    """
    while len(text) > 2 and text_width(text, size, bold) > widest:
        text = text[: max(1, int(len(text) * 0.9) - 1)].rstrip("\u2026 ") + "\u2026"
    return text


def _around(
    x: float, y: float, width: float, height: float, distances: Sequence[float]
) -> Iterator[tuple[Box, float]]:
    """Yield boxes around a point, each with what its distance costs."""
    for away in distances:
        lefts = (x - width / 2, x - width - away * 0.5, x + away * 0.5, x - width - away, x + away)
        for left in lefts:
            for top in (y - height - away, y + away):
                yield Box(left, top, width, height), away * 0.5
        yield Box(x + away, y - height / 2, width, height), away * 0.5
        yield Box(x - away - width, y - height / 2, width, height), away * 0.5


def placed_names(
    document: Document, places: Sequence[Point], cover: Cover, scale: float = 1.0
) -> Iterator[tuple[str, Box]]:
    """Yield the names of towns that find room.

    Parameters
    ----------
    document : Document
        Whose towns they are.
    places : sequence of tuple of float
        Where they are, in pixels.
    cover : Cover
        What is taken already; names take their room.
    scale : float
        How much larger than common they are; larger ones want more room, and fewer find it.

    Yields
    ------
    tuple of str and Box
        Each name and the box it stands in.
    """
    placed: list[tuple[float, float, float]] = []
    size = NAME_SIZE * scale
    high, side = 18 * scale, 4 * scale
    for (_, _, name, rank), (x, y) in zip(document.towns, places, strict=True):
        if rank > 1 or not (0 < x < cover.width and 0 < y < cover.height):
            continue
        text = clipped(name, size, widest=WIDEST_CALLOUT * scale)
        width = text_width(text, size)
        # A blank margin round the text keeps names apart, a wide one thins out lesser towns.
        gap = (24 if rank else 8) * scale
        if any(
            abs(x - other_x) < (width + other) / 2 + gap and abs(y - other_y) < high + gap / 2
            for other_x, other_y, other in placed
        ):
            continue
        wide, left = width + 2 * side, x - width / 2 - side
        spots = (
            (Box(left, y - high - 2, wide, high), 0.0),
            (Box(left, y + 3, wide, high), 0.5),
            (Box(x + 2, y - high / 2, wide, high), 1.0),
            (Box(x - wide - 2, y - high / 2, wide, high), 1.0),
            (Box(left, y - high - 12 * scale, wide, high), 1.5),
            (Box(left, y + 12 * scale, wide, high), 1.5),
            # Clear of a mark in the middle of the town.
            (Box(left, y - high - 18 * scale, wide, high), 2.0),
            (Box(left, y + 18 * scale, wide, high), 2.0),
        )
        # Large names may touch a line, or hardly any would find a place.
        box = cover.place(spots, 8.0 if scale == 1 else 16.0 * scale)
        if box is not None:
            placed.append((x, y, width))
            yield text, box


def text_width(text: str, size: float, bold: bool = False) -> float:
    """Return about how wide a text is in a common sans-serif face; rather too wide.

    Parameters
    ----------
    text : str
        The text.
    size : float
        Of its type, in pixels.
    bold : bool
        Whether it is bold.

    Returns
    -------
    float
        In pixels.
    """
    return sum(map(_em, text)) * size * (1.17 if bold else 1.0)


def _em(character: str) -> float:
    if character in "iljtfrI.,:;'|! ":
        return 0.38
    if character in "mwMW@%":
        return 0.9
    # Ideographs and most emoji stand in a square.
    return 0.63 if ord(character) < 0x2E80 else 1.05
