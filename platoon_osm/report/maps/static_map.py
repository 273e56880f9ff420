"""The map as one still SVG, for print and for readers without JavaScript."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from ..document.model import Document
from ..document.model_vehicle import Vehicle
from ..drawing.crowd import CROWD, MOST_SPOKEN
from ..drawing.lines import Point
from ..drawing.palette import CASING
from ..drawing.ticks import round_below
from ..markup.fragments import NOTHING, Piece, Tree
from .lanes import band_aside, band_lines, band_width, solo_aside, solo_step
from .map_texts import NAME_SIZE, placed_callouts, placed_names
from .map_view import MapView
from .pixels import laid, path_data
from .placement import Box, Cover
from .static_marks import event_places, placed_marks

__all__ = ["NARROW", "small_maps", "static_map", "static_texts", "town_names"]

NARROW = 2.1
"""How much larger marks and names are drawn for a screen that shows the map at half its size."""

SMALL_NARROW = 1.75


def static_map(document: Document) -> Piece:
    """Return the still map of a document: routes, letters, points and names.

    Parameters
    ----------
    document : Document
        What is drawn.

    Returns
    -------
    Piece
        One SVG.
    """
    view = MapView([document])
    cover = Cover(view.width, view.height)
    routes = list(_routes(document, view, cover))
    narrow = cover.copy()
    marks = tuple(placed_marks(document, view, cover))
    scale = _scale(view, cover)
    # Callouts choose their place before names do: they matter more.
    callouts = tuple(_callouts(document, view, cover))
    names = tuple(town_names(document, view, cover))
    return Piece(
        "static-map",
        {
            "width": f"{view.width:g}",
            "height": f"{view.height:g}",
            "title": document.title,
            "description": f"Map of {document.subtitle}: "
            + "; ".join(
                f"{v.letter} {v.origin.name} to {v.destination.name}"
                for v in document.vehicles[:MOST_SPOKEN]
            ),
            "network": view.network_path(document.basemap.known),
            "inferred": view.path(document.basemap.inferred),
            "inferred_routes": view.path(document.inferred_routes),
            "routes": tuple(routes),
            "wide": static_texts("wide", names, marks, callouts),
            "narrow": _narrow_texts(document, view, narrow, NARROW),
            "scale": scale,
        },
    )


SMALL_WIDTH, SMALL_HEIGHT = 640.0, 400.0
SMALL_NETWORK_DATA = 40_000


def small_maps(documents: Sequence[Document]) -> list[Piece]:
    """Return a small still map of each document, all of the same part of the world.

    Parameters
    ----------
    documents : sequence of Document
        Of plans on one network.

    Returns
    -------
    list of Piece
        An SVG for each. The network is drawn by the first alone; the others refer to it.
    """
    view = MapView(documents, SMALL_WIDTH, (SMALL_HEIGHT, SMALL_HEIGHT), margin=26.0)
    lines = documents[0].basemap.known
    network = Piece("small-network", {"path": view.network_path(lines, SMALL_NETWORK_DATA)})
    maps: list[Piece] = []
    for document in documents:
        cover = Cover(view.width, view.height)
        routes = tuple(_routes(document, view, cover))
        narrow = cover.copy()
        marks = tuple(placed_marks(document, view, cover))
        names = tuple(town_names(document, view, cover))
        maps.append(
            Piece(
                "small-map",
                {
                    "width": f"{view.width:g}",
                    "height": f"{view.height:g}",
                    "title": f"Map: {document.title}, {document.subtitle}",
                    "network": NOTHING if maps else network,
                    "routes": routes,
                    "wide": static_texts("wide", names, marks),
                    "narrow": _narrow_texts(document, view, narrow, SMALL_NARROW),
                },
            )
        )
    return maps


def static_texts(
    kind: str, names: Tree, marks: Tree, callouts: Tree = NOTHING, scale: float = 1.0
) -> Piece:
    """Return what is written on a map for one kind of screen.

    Parameters
    ----------
    kind : str
        "wide" or "narrow".
    names, marks, callouts : Tree
        What is written.
    scale : float
        How much larger than common it is.

    Returns
    -------
    Piece
        A group of the SVG.
    """
    return Piece(
        "static-texts",
        {
            "kind": kind,
            "names": names,
            "marks": marks,
            "callouts": callouts,
            "size": f"{NAME_SIZE * scale:g}",
            "halo": f"{3 * scale:g}",
        },
    )


def _narrow_texts(document: Document, view: MapView, cover: Cover, scale: float) -> Tree:
    """Return marks and names larger, and so fewer, for narrow screens; callouts have no room."""
    marks = tuple(placed_marks(document, view, cover, scale))
    names = tuple(town_names(document, view, cover, scale))
    return static_texts("narrow", names, marks, scale=scale)


def _routes(document: Document, view: MapView, cover: Cover) -> Iterator[Piece]:
    vehicles = document.vehicles
    solo_lines: list[tuple[str, Vehicle, float]] = []
    for solo in document.solos:
        points = laid([(view.pixels(part.line), solo_aside(part, view)) for part in solo.parts])
        cover.add_line(points)
        slots = max((part.slots for part in solo.parts), default=1)
        width = min(3.6, max(1.3, solo_step(slots) * 0.8))
        solo_lines.append((path_data(points), vehicles[solo.vehicle], width))
    for path, _, width in solo_lines:
        yield Piece(
            "static-line",
            {
                "path": path,
                "colour": CASING,
                "width": f"{width + 3.4:.3g}",
                "dash": "none",
                "cap": "butt",
            },
        )
    for path, vehicle, width in solo_lines:
        yield Piece(
            "static-line",
            {
                "path": path,
                "colour": vehicle.colour,
                "width": f"{width:.3g}",
                "dash": vehicle.stroke,
                "cap": vehicle.cap,
            },
        )
    for section in document.platoons:
        count = len(section.vehicles)
        lanes = [(view.pixels(part.line), band_aside(part, view)) for part in section.parts]
        step, width = band_lines(count)
        inner = band_width(count)

        yield Piece(
            "static-band",
            {
                "path": path_data(_lane(lanes, 0.0)),
                "outer": f"{inner + 2:g}",
                "inner": f"{inner:g}",
            },
        )
        for place, index in enumerate(section.vehicles):
            points = _lane(lanes, (place - (count - 1) / 2) * step)
            cover.add_line(points, weight=4)
            yield Piece(
                "static-line",
                {
                    "path": path_data(points),
                    "colour": vehicles[index].colour,
                    "width": f"{width:.3g}",
                    "dash": (count <= CROWD and vehicles[index].dash) or "none",
                    "cap": vehicles[index].cap,
                },
            )


def _lane(lanes: Sequence[tuple[Sequence[Point], float]], aside: float) -> list[Point]:
    """Return one line along a band's roads, so far right of the band's middle."""
    return laid([(points, band + aside) for points, band in lanes])


def _callouts(document: Document, view: MapView, cover: Cover) -> Iterator[Piece]:
    for one in placed_callouts(document, view, cover, event_places(document, view)):
        leader = NOTHING
        if one.near:
            x2, y2 = one.near
            leader = Piece(
                "static-leader",
                {"x1": f"{one.x:.1f}", "y1": f"{one.y:.1f}", "x2": f"{x2:.1f}", "y2": f"{y2:.1f}"},
            )
        box = one.box
        yield Piece(
            "static-callout",
            {
                "leader": leader,
                "x": f"{box.left:.1f}",
                "y": f"{box.top:.1f}",
                "width": f"{box.width:.1f}",
                "text_x": f"{box.left + 8:.1f}",
                "head_y": f"{box.top + 14:.1f}",
                "line_y": f"{box.top + 28:.1f}",
                "head": one.head,
                "line": one.line,
            },
        )


def town_names(
    document: Document, view: MapView, cover: Cover, scale: float = 1.0
) -> Iterator[Piece]:
    """Yield the names of towns that find room.

    Parameters
    ----------
    document : Document
        Whose towns they are.
    view : MapView
        Where on the drawing things lie.
    cover : Cover
        What is taken already; names take their room.
    scale : float
        How much larger than common they are.

    Yields
    ------
    Piece
        Each name.
    """
    for text, box in placed_names(document, view, cover, scale):
        yield Piece(
            "static-name",
            {"x": f"{box.left + 4 * scale:.1f}", "y": f"{box.top + 13 * scale:.1f}", "text": text},
        )


def _scale(view: MapView, cover: Cover) -> Piece:
    widest = 120 * view.metres_per_pixel
    length = round_below(widest)
    width = length / view.metres_per_pixel
    cover.add_box(Box(4, view.height - 32, width + 20, 30))
    return Piece(
        "static-scale",
        {"y": f"{view.height - 14:g}", "width": f"{width:.1f}", "text": _round_length(length)},
    )


def _round_length(length_m: float) -> str:
    return f"{length_m:g} m" if length_m < 1000 else f"{length_m / 1000:g} km"
