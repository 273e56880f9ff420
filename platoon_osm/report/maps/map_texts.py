"""Callouts and names of towns on a still drawing, where they cover least."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import partial

from ..document.model import Document
from ..document.surroundings import Surroundings
from ..drawing.crowd import MANY_EVENTS
from ..drawing.lines import Point
from ..language.speech import say
from .pause_icons import NOUNS
from .placement import SOLID, Box, Cover, crosses

__all__ = ["NAME_SIZE", "Callout", "clipped", "placed_callouts", "placed_names", "text_width"]

NAME_SIZE = 11.5
"""Of a town's name, in pixels."""

CALLOUT_HEIGHT = 34.0
WIDEST_CALLOUT = 360.0


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
    worst = 1_000.0 if len(document.events) <= MANY_EVENTS else 60.0
    found: list[_Choosing] = []
    for event, place in zip(document.events, places, strict=True):
        if place is None:
            continue
        x, y = place
        head = clipped(f"{say(NOUNS[event.kind][0])}: {event.name}", 11.5, True)
        line = clipped(event.text, 11)
        width = 16 + max(text_width(head, 11.5, True), text_width(line, 11))
        choices = list(_around(x, y, width, CALLOUT_HEIGHT, (16, 30, 48, 70, 100)))
        found.append(_Choosing((x, y), head, line, choices))
    # The first to choose may stand in the way of the others: let each choose again, twice.
    for _ in range(3):
        for one in found:
            if one.box is not None:
                cover.free_box(one.box)
            others = [other for other in found if other is not one]
            one.box = cover.place(one.choices, worst, partial(one.tangled, others=others))
    # A leader through a box would be read as that one's: rather no box.
    for one in found:
        others = [other for other in found if other is not one]
        if one.box is not None and one.tangled(one.box, others) >= CROSSED_BOX:
            cover.free_box(one.box)
            one.box = None
    for one in found:
        if one.box is not None:
            near = _leader(one.at, one.box)
            if near is not None:
                cover.add_line([one.at, near], SOLID)
            yield Callout(*one.at, one.box, one.head, one.line, near)


NEAR = 20.0
"""A box further than this from its event is tied to it by a leader, in pixels."""

CROSSED_BOX, CROSSED_LEADER = 400.0, 150.0
"""What a place costs whose leader crosses another box, or another leader."""


@dataclass(slots=True)
class _Choosing:
    """A callout that looks for a place."""

    at: Point
    head: str
    line: str
    choices: list[tuple[Box, float]]
    box: Box | None = None

    def tangled(self, box: Box, others: Sequence[_Choosing]) -> float:
        """Return what a box costs for the leaders that it crosses, or that cross it."""
        near = _leader(self.at, box)
        cost = 0.0
        for other in others:
            if other.box is None:
                continue
            far = _leader(other.at, other.box)
            if near is not None and other.box.is_crossed(self.at, near):
                cost += CROSSED_BOX
            if far is not None and box.is_crossed(other.at, far):
                cost += CROSSED_BOX
            if near is not None and far is not None and crosses(self.at, near, other.at, far):
                cost += CROSSED_LEADER
        return cost


def _leader(at: Point, box: Box) -> Point | None:
    """Return where a leader from an event to its box ends; None if the box is near."""
    near = min(max(at[0], box.left), box.right), min(max(at[1], box.top), box.bottom)
    return near if math.dist(near, at) > NEAR else None


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
    document: Document | Surroundings, places: Sequence[Point], cover: Cover, scale: float = 1.0
) -> Iterator[tuple[str, Box]]:
    """Yield the names of towns that find room.

    Parameters
    ----------
    document : Document or Surroundings
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
        # Beside its dot or mark, then further from it, where nothing of the plan is.
        spots = (
            Box(at_x, at_y, wide, high)
            for away in (3.0, 11 * scale, 18 * scale)
            for at_x, at_y in (
                (left, y - high - away), (left, y + away),
                (x + away, y - high / 2), (x - wide - away, y - high / 2),
                (x + 2, y - high - away), (x - wide - 2, y + away),
                (x - wide - 2, y - high - away), (x + 2, y + away),
            )
        )  # fmt: skip
        box = next((spot for spot in spots if not cover.cost(spot)), None)
        if box is not None:
            cover.add_box(box)
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
