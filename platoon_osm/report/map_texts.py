"""Callouts and names of towns on a still drawing, where they cover least."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import Any

from .basemap import BASEMAP_STEPS
from .map_view import MapView
from .placement import Box, Cover, text_width

__all__ = ["Callout", "placed_callouts", "placed_names"]

CALLOUT_HEIGHT = 34.0
WIDEST_CALLOUT = 230.0


@dataclass(frozen=True, slots=True)
class Callout:
    """A box beside an event, at (x, y): a bold head, a line, and perhaps a leader from `near`."""

    x: float
    y: float
    box: Box
    head: str
    line: str
    near: tuple[float, float] | None


def placed_callouts(document: dict[str, Any], view: MapView, cover: Cover) -> Iterator[Callout]:
    """Yield the callouts of all events that find room, where they cover least."""
    for event in document["events"]:
        x, y = view.at(event["lon"], event["lat"])
        head = _clipped(f"{event['kind'].capitalize()}: {event['name']}", 11.5, True)
        line = _clipped(event["text"], 11, False)
        width = 16 + max(text_width(head, 11.5, True), text_width(line, 11))
        box = cover.place(_around(x, y, width, CALLOUT_HEIGHT, (16, 30, 48, 70, 100)), 1_000)
        if box is None:
            continue
        near = min(max(x, box.left), box.right), min(max(y, box.top), box.bottom)
        far = math.hypot(near[0] - x, near[1] - y) > 20
        yield Callout(x, y, box, head, line, near if far else None)


def _clipped(text: str, size: float, bold: bool) -> str:
    while len(text) > 2 and text_width(text, size, bold) > WIDEST_CALLOUT:
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
    document: dict[str, Any], view: MapView, cover: Cover
) -> Iterator[tuple[str, Box]]:
    """Yield the names of towns that find room, each with the box it stands in."""
    placed: list[tuple[float, float, float]] = []
    for lon, lat, name, rank in document["towns"]:
        x, y = view.at(lon / BASEMAP_STEPS, lat / BASEMAP_STEPS)
        if rank > 1 or not (0 < x < view.width and 0 < y < view.height):
            continue
        text = _clipped(name, 11.5, False)
        width = text_width(text, 11.5)
        # A blank margin round the text keeps names apart, a wide one thins out lesser towns.
        gap = 18 if rank else 6
        if any(
            abs(x - other_x) < (width + other) / 2 + gap and abs(y - other_y) < 18 + gap / 2
            for other_x, other_y, other in placed
        ):
            continue
        places = (
            (Box(x - width / 2 - 4, y - 20, width + 8, 18), 0.0),
            (Box(x - width / 2 - 4, y + 3, width + 8, 18), 0.5),
            (Box(x + 2, y - 9, width + 8, 18), 1.0),
            (Box(x - width - 10, y - 9, width + 8, 18), 1.0),
            (Box(x - width / 2 - 4, y - 30, width + 8, 18), 1.5),
            (Box(x - width / 2 - 4, y + 12, width + 8, 18), 1.5),
        )
        box = cover.place(places, 8.0)
        if box is not None:
            placed.append((x, y, width))
            yield text, box
