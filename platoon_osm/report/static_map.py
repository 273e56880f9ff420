"""The map as one still SVG, for print and for readers without JavaScript."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from typing import Any

from .basemap import BASEMAP_STEPS, ROUTE_STEPS
from .fragments import Markup, fill, join
from .map_texts import placed_callouts, placed_names
from .map_view import (
    MapView,
    Point,
    band_aside,
    band_lines,
    band_width,
    path_data,
    shifted,
    solo_aside,
    solo_step,
)
from .placement import Box, Cover
from .polyline import decode_lines, decode_polyline

__all__ = ["small_maps", "static_map"]

CROWD_COLOUR = "#4d5560"
LETTER_SIZE = {1: 11.0, 2: 9.0, 3: 8.0}

CROWD = 8
"""Lines of more vehicles than this are too thin for dashes."""

MOST_ENDS = 3
"""More starts or destinations than this on one spot become one mark that counts them."""


def static_map(document: dict[str, Any]) -> Markup:
    """Return the still map of a report document: routes, letters, points and names."""
    view = MapView(document)
    cover = Cover(view.width, view.height)
    vehicles = document["vehicles"]
    routes = list(_routes(document, view, cover))
    marks = list(_marks(document, view, cover))
    scale = _scale(view, cover)
    # Callouts choose their place before names do: they matter more.
    callouts = list(_callouts(document, view, cover))
    names = list(_names(document, view, cover))
    return fill(
        "static-map",
        width=f"{view.width:g}",
        height=f"{view.height:g}",
        title=document["title"],
        description=f"Map of {document['subtitle']}: "
        + "; ".join(f"{v['letter']} {v['origin']['name']} to {v['destination']['name']}"
                    for v in vehicles[:12]),
        network=view.network_path(decode_lines(document["basemap"]["known"], BASEMAP_STEPS)),
        inferred=view.path(decode_lines(document["basemap"]["inferred"], BASEMAP_STEPS)),
        inferred_routes=view.path(
            [decode_polyline(line, ROUTE_STEPS) for line in document["inferred_routes"]]
        ),
        routes=join(routes),
        names=join(names),
        marks=join(marks),
        callouts=join(callouts),
        scale=scale,
    )  # fmt: skip


SMALL_WIDTH, SMALL_HEIGHT = 640.0, 400.0
SMALL_NETWORK_DATA = 40_000


def small_maps(documents: Sequence[dict[str, Any]]) -> list[Markup]:
    """Return a small still map of each document, all of the same part of the world.

    The network is drawn by the first alone; the others on the page refer to it.
    """
    every = {
        name: [one for document in documents for one in document[name]]
        for name in ("platoons", "solos", "vehicles")
    }
    view = MapView(every, SMALL_WIDTH, (SMALL_HEIGHT, SMALL_HEIGHT), margin=26.0)
    lines = decode_lines(documents[0]["basemap"]["known"], BASEMAP_STEPS)
    network = fill("small-network", path=view.network_path(lines, SMALL_NETWORK_DATA))
    maps: list[Markup] = []
    for document in documents:
        cover = Cover(view.width, view.height)
        routes = join(_routes(document, view, cover))
        marks = join(_marks(document, view, cover))
        maps.append(
            fill(
                "small-map",
                width=f"{view.width:g}",
                height=f"{view.height:g}",
                title=f"Map: {document['title']}, {document['subtitle']}",
                network=Markup("") if maps else network,
                routes=routes,
                marks=marks,
                names=join(_names(document, view, cover)),
            )
        )
    return maps


def _routes(document: dict[str, Any], view: MapView, cover: Cover) -> Iterator[Markup]:
    vehicles = document["vehicles"]
    solo_lines: list[tuple[str, dict[str, Any], float]] = []
    for solo in document["solos"]:
        points: list[Point] = []
        for part in solo["parts"]:
            points += shifted(view.route(part["line"]), solo_aside(part))
        cover.add_line(points)
        slots = max((part["slots"] for part in solo["parts"]), default=1)
        width = min(3.6, max(1.3, solo_step(slots) * 0.8))
        solo_lines.append((path_data(points), vehicles[solo["vehicle"]], width))
    for path, _, width in solo_lines:
        yield fill(
            "static-line",
            path=path,
            colour="#fff",
            width=f"{width + 3.4:.3g}",
            dash="none",
            cap="butt",
        )
    for path, vehicle, width in solo_lines:
        yield fill(
            "static-line", path=path, colour=vehicle["colour"], width=f"{width:.3g}",
            dash=vehicle["dash"] or "none", cap=vehicle["cap"],
        )  # fmt: skip
    for section in document["platoons"]:
        count = len(section["vehicles"])
        lanes = [(view.route(part["line"]), band_aside(part)) for part in section["parts"]]
        step, width = band_lines(count)
        inner = band_width(count)

        def line(aside: float, lanes: Any = lanes) -> list[Point]:
            return [point for points, band in lanes for point in shifted(points, band + aside)]

        yield fill(
            "static-band", path=path_data(line(0.0)), outer=f"{inner + 2:g}", inner=f"{inner:g}"
        )
        for place, index in enumerate(section["vehicles"]):
            points = line((place - (count - 1) / 2) * step)
            cover.add_line(points, weight=4)
            yield fill(
                "static-line", path=path_data(points), colour=vehicles[index]["colour"],
                width=f"{width:.3g}", dash=(count <= CROWD and vehicles[index]["dash"]) or "none",
                cap=vehicles[index]["cap"],
            )  # fmt: skip


# Places round a spot in pixels, near ones first; sideways before up and down.
_FAN = sorted(
    ((x, y) for x in range(-60, 61, 12) for y in (-40, -20, 0, 20, 40)),
    key=lambda move: (math.hypot(move[0], 1.3 * move[1]), move),
)


def _beside(x: float, y: float, taken: list[Point]) -> Point:
    """Return where a mark near (x, y) covers none before it; where it is, if all is taken."""
    place = next(
        (
            (x + right, y + down)
            for right, down in _FAN
            if all(abs(x + right - a) > 19 or abs(y + down - b) > 19 for a, b in taken)
        ),
        (x, y),
    )
    taken.append(place)
    return place


def _marks(document: dict[str, Any], view: MapView, cover: Cover) -> Iterator[Markup]:
    taken: list[Point] = []
    for end, fragment, word in (
        ("origin", "static-start", "from"),
        ("destination", "static-end", "to"),
    ):
        spots: dict[Point, list[dict[str, Any]]] = {}
        for vehicle in document["vehicles"]:
            spots.setdefault((vehicle[end]["lon"], vehicle[end]["lat"]), []).append(vehicle)
        for at, vehicles in spots.items():
            x, y = view.at(*at)
            letters = ", ".join(vehicle["letter"] for vehicle in vehicles)
            faces = [(vehicle["colour"], vehicle["letter"]) for vehicle in vehicles]
            if len(vehicles) > MOST_ENDS:
                faces = [(CROWD_COLOUR, f"{len(vehicles)}\u00d7")]
            for place, (colour, letter) in enumerate(faces):
                left, top = _beside(x + 21 * (place - (len(faces) - 1) / 2), y, taken)
                cover.add_box(Box(left - 10, top - 10, 20, 20))
                yield fill(
                    fragment, x=f"{left:.1f}", y=f"{top:.1f}", colour=colour, letter=letter,
                    size=LETTER_SIZE[min(len(letter), 3)],
                    title=f"{letters} {word} {vehicles[0][end]['name']}",
                )  # fmt: skip
    for event in document["events"]:
        x, y = view.at(event["lon"], event["lat"])
        x, y = _beside(x, y, taken)
        cover.add_box(Box(x - 12, y - 12, 24, 24))
        yield fill(
            "static-event", x=f"{x:.1f}", y=f"{y:.1f}", icon=event["kind"],
            title=f"{event['name']}: {event['text']}",
        )  # fmt: skip


def _callouts(document: dict[str, Any], view: MapView, cover: Cover) -> Iterator[Markup]:
    for one in placed_callouts(document, view, cover):
        leader = Markup("")
        if one.near:
            x2, y2 = one.near
            leader = fill(
                "static-leader", x1=f"{one.x:.1f}", y1=f"{one.y:.1f}", x2=f"{x2:.1f}",
                y2=f"{y2:.1f}",
            )  # fmt: skip
        box = one.box
        yield fill(
            "static-callout", leader=leader, x=f"{box.left:.1f}", y=f"{box.top:.1f}",
            width=f"{box.width:.1f}", text_x=f"{box.left + 8:.1f}", head_y=f"{box.top + 14:.1f}",
            line_y=f"{box.top + 28:.1f}", head=one.head, line=one.line,
        )  # fmt: skip


def _names(document: dict[str, Any], view: MapView, cover: Cover) -> Iterator[Markup]:
    for text, box in placed_names(document, view, cover):
        yield fill("static-name", x=f"{box.left + 4:.1f}", y=f"{box.top + 13:.1f}", text=text)


def _scale(view: MapView, cover: Cover) -> Markup:
    metres_per_pixel = 111_320 * math.cos(math.radians(view.latitude)) / max(view.per_degree, 1e-9)
    widest = 120 * metres_per_pixel
    step = 10 ** math.floor(math.log10(widest))
    length = max(factor * step for factor in (1, 2, 5) if factor * step <= widest)
    width = length / metres_per_pixel
    cover.add_box(Box(4, view.height - 32, width + 20, 30))
    return fill(
        "static-scale", y=f"{view.height - 14:g}", width=f"{width:.1f}", text=_round_length(length)
    )


def _round_length(length_m: float) -> str:
    return f"{length_m:g} m" if length_m < 1000 else f"{length_m / 1000:g} km"
