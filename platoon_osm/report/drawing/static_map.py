"""The map as one still SVG, for print and for readers without JavaScript."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from typing import Any

from ..markup.fragments import NOTHING, Markup, fill, join
from .basemap import BASEMAP_STEPS, ROUTE_STEPS
from .map_texts import NAME_SIZE, placed_callouts, placed_names
from .map_view import (
    MapView,
    Point,
    band_aside,
    band_lines,
    band_width,
    laid,
    path_data,
    solo_aside,
    solo_step,
)
from .placement import Box, Cover
from .polyline import decode_lines, decode_polyline
from .static_marks import event_places, placed_marks

__all__ = ["NARROW", "small_maps", "static_map", "static_texts", "town_names"]

CROWD = 8
"""Lines of more vehicles than this are too thin for dashes."""

NARROW = 2.1
"""How much larger marks and names are drawn for a screen that shows the map at half its size."""

SMALL_NARROW = 1.75


def static_map(document: dict[str, Any]) -> Markup:
    """Return the still map of a report document: routes, letters, points and names."""
    view = MapView(document)
    cover = Cover(view.width, view.height)
    vehicles = document["vehicles"]
    routes = list(_routes(document, view, cover))
    narrow = cover.copy()
    marks = join(placed_marks(document, view, cover))
    scale = _scale(view, cover)
    # Callouts choose their place before names do: they matter more.
    callouts = join(_callouts(document, view, cover))
    names = join(town_names(document, view, cover))
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
        wide=static_texts("wide", names, marks, callouts),
        narrow=_narrow_texts(document, view, narrow, NARROW),
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
        narrow = cover.copy()
        marks = join(placed_marks(document, view, cover))
        names = join(town_names(document, view, cover))
        maps.append(
            fill(
                "small-map",
                width=f"{view.width:g}",
                height=f"{view.height:g}",
                title=f"Map: {document['title']}, {document['subtitle']}",
                network=Markup("") if maps else network,
                routes=routes,
                wide=static_texts("wide", names, marks),
                narrow=_narrow_texts(document, view, narrow, SMALL_NARROW),
            )
        )
    return maps


def static_texts(
    kind: str, names: Markup, marks: Markup, callouts: Markup = NOTHING, scale: float = 1.0
) -> Markup:
    """Return what is written on a map for "wide" or "narrow" screens, the latter larger."""
    return fill(
        "static-texts", kind=kind, names=names, marks=marks, callouts=callouts,
        size=f"{NAME_SIZE * scale:g}", halo=f"{3 * scale:g}",
    )  # fmt: skip


def _narrow_texts(document: dict[str, Any], view: MapView, cover: Cover, scale: float) -> Markup:
    """Return marks and names larger, and so fewer, for narrow screens; callouts have no room."""
    marks = join(placed_marks(document, view, cover, scale))
    names = join(town_names(document, view, cover, scale))
    return static_texts("narrow", names, marks, scale=scale)


def _routes(document: dict[str, Any], view: MapView, cover: Cover) -> Iterator[Markup]:
    vehicles = document["vehicles"]
    solo_lines: list[tuple[str, dict[str, Any], float]] = []
    for solo in document["solos"]:
        points = laid(
            [(view.route(part["line"]), solo_aside(part, view)) for part in solo["parts"]]
        )
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
        lanes = [(view.route(part["line"]), band_aside(part, view)) for part in section["parts"]]
        step, width = band_lines(count)
        inner = band_width(count)

        def line(aside: float, lanes: Any = lanes) -> list[Point]:
            return laid([(points, band + aside) for points, band in lanes])

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


def _callouts(document: dict[str, Any], view: MapView, cover: Cover) -> Iterator[Markup]:
    for one in placed_callouts(document, view, cover, event_places(document, view)):
        leader = NOTHING
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


def town_names(
    document: dict[str, Any], view: MapView, cover: Cover, scale: float = 1.0
) -> Iterator[Markup]:
    """Yield the names of towns that find room."""
    for text, box in placed_names(document, view, cover, scale):
        yield fill(
            "static-name", x=f"{box.left + 4 * scale:.1f}", y=f"{box.top + 13 * scale:.1f}",
            text=text,
        )  # fmt: skip


def _scale(view: MapView, cover: Cover) -> Markup:
    widest = 120 * view.metres_per_pixel
    step = 10 ** math.floor(math.log10(widest))
    length = max(factor * step for factor in (1, 2, 5) if factor * step <= widest)
    width = length / view.metres_per_pixel
    cover.add_box(Box(4, view.height - 32, width + 20, 30))
    return fill(
        "static-scale", y=f"{view.height - 14:g}", width=f"{width:.1f}", text=_round_length(length)
    )


def _round_length(length_m: float) -> str:
    return f"{length_m:g} m" if length_m < 1000 else f"{length_m / 1000:g} km"
