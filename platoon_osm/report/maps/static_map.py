"""The map as one still SVG, for print and for readers without JavaScript."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from typing import NamedTuple

from ..document.model import Document
from ..drawing.crowd import CROWD, MOST_SPOKEN
from ..drawing.lines import Point
from ..drawing.palette import CASING
from ..drawing.ticks import round_below
from ..language.speech import say
from ..markup.fragments import NOTHING, Piece, Tree
from .ground_paths import BEYOND, ground_piece, town_dots
from .lanes import Strip, band_strips, solo_strips
from .map_texts import NAME_SIZE, Callout, placed_callouts, placed_names
from .map_view import MapView
from .pixels import DrawnLine, lines_along, network_path, path_of
from .placement import Box, Cover
from .ribbons import ribbon_pieces, ribbons
from .static_marks import mark_pieces, placed_marks

__all__ = ["NARROW", "map_foreground", "small_maps", "static_map", "static_texts", "town_names"]

DOTS = "0.1 8"
"""Dashes of a way beside the road: dots, with round ends."""

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
    return Piece(
        "static-map",
        {
            "width": f"{view.width:g}",
            "height": f"{view.height:g}",
            "title": document.title,
            "description": say(
                "still-map.description",
                subtitle=document.subtitle,
                ways="; ".join(
                    say(
                        "still-map.way",
                        who=v.letter,
                        origin=v.origin.name,
                        destination=v.destination.name,
                    )
                    for v in document.vehicles[:MOST_SPOKEN]
                ),
            ),
            "ground": ground_piece(document, view, BEYOND),
            "towns": town_dots(document, view),
            **_background(document, view),
            **map_foreground(document, view, NARROW, whole=True),
        },
    )


SMALL_WIDTH, SMALL_HEIGHT = 640.0, 400.0
SMALL_NETWORK_DATA = 40_000


def small_maps(
    documents: Sequence[Document], key: str = "", network_data: int | None = None
) -> list[Piece]:
    """Return a small still map of each document, all of the same part of the world.

    Parameters
    ----------
    documents : sequence of Document
        Of plans on one network.
    key : str
        Ends the ids, so that several sets of maps stand on one page.
    network_data : int or None
        Letters that the network may take.

    Returns
    -------
    list of Piece
        An SVG for each. The network is drawn by the first alone; the others refer to it.
    """
    view = MapView(documents, SMALL_WIDTH, (SMALL_HEIGHT, SMALL_HEIGHT), margin=26.0)
    known = [view.pixels(line) for line in documents[0].basemap.known]
    path = network_path(known, view.width, view.height, network_data or SMALL_NETWORK_DATA)
    maps: list[Piece] = []
    for document in documents:
        maps.append(
            Piece(
                "small-map",
                {
                    "key": key,
                    "width": f"{view.width:g}",
                    "height": f"{view.height:g}",
                    "title": say(
                        "still-map.small", title=document.title, subtitle=document.subtitle
                    ),
                    "ground": Piece("small-ground-again", {"key": key})
                    if maps
                    else Piece(
                        "small-ground", {"key": key, "ground": ground_piece(documents[0], view)}
                    ),
                    "towns": town_dots(document, view),
                    "network": NOTHING
                    if maps
                    else Piece("small-network", {"key": key, "path": path}),
                    **map_foreground(document, view, SMALL_NARROW, whole=False),
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


def _background(document: Document, view: MapView) -> dict[str, str]:
    """Return the paths of the network, of inferred roads, and of those on a route."""
    basemap = document.basemap
    known, inferred, on_routes = (
        [view.pixels(line) for line in lines]
        for lines in (basemap.known, basemap.inferred, document.inferred_routes)
    )
    return {
        "network": network_path(known, view.width, view.height),
        "inferred": path_of(inferred, view.width, view.height),
        "inferred_routes": path_of(on_routes, view.width, view.height),
    }


def map_foreground(
    document: Document, view: MapView, large: float, *, whole: bool
) -> dict[str, Tree]:
    """Return routes, and marks and texts for wide and for narrow screens.

    On narrow screens they are larger, and so fewer. Callouts and a scale belong to a whole map.

    Parameters
    ----------
    document : Document
        What is drawn.
    view : MapView
        The drawing.
    large : float
        How much larger than common what is written for narrow screens is.
    whole : bool
        Whether it is the whole map of a page.

    Returns
    -------
    dict of str to Tree
        "routes", "wide", "narrow" and, of a whole map, "scale".
    """
    places = view.places(document)
    solos, bands = _solo_drawings(document, view), _band_drawings(document, view)
    traffic = ribbons(document, view)
    crowd = document.traffic is not None
    marks = placed_marks(document, view, counted=crowd)
    larger = placed_marks(document, view, large, counted=crowd)
    length = round_below(120 * view.metres_per_pixel)
    width = length / view.metres_per_pixel
    cover = Cover(view.width, view.height)
    cover.add_lines([one.lines[0].points for one in solos], weight=3)
    cover.add_lines([line.points for ribbon in traffic for line in ribbon.lines], weight=3)
    cover.add_lines([line.points for one in bands for line in one.lines[1:]], weight=6)
    narrow = cover.copy()
    narrow.add_boxes(mark.box for mark in larger)
    cover.add_boxes(mark.box for mark in marks)
    if whole:
        cover.add_boxes([Box(4, view.height - 32, width + 20, 30)])
    # Callouts choose their place before names do: they matter more.
    own = {mark.event: (mark.x, mark.y) for mark in marks if mark.event is not None}
    events = [own.get(number) for number in range(len(document.events))]
    callouts = list(placed_callouts(document, events, cover)) if whole else []
    names = list(placed_names(document, places.towns, cover))
    larger_names = list(placed_names(document, places.towns, narrow, large))
    found: dict[str, Tree] = {
        "routes": (
            *ribbon_pieces(traffic),
            *_solo_routes(document, solos),
            *(piece for one in bands for piece in _band(document, one)),
        ),
        "wide": static_texts(
            "wide", town_names(names), tuple(mark_pieces(marks)), tuple(map(_callout, callouts))
        ),
        "narrow": static_texts(
            "narrow", town_names(larger_names, large), tuple(mark_pieces(larger)), scale=large
        ),
    }
    if whole:
        text = {"width": f"{width:.1f}", "text": _round_length(length)}
        found["scale"] = Piece("static-scale", {"y": f"{view.height - 14:g}", **text})
    return found


class _Drawing(NamedTuple):
    """A stretch as it is drawn: its number, its lines, their width and that of their band."""

    number: int
    lines: list[DrawnLine]
    width: float
    inner: float


def _solo_drawings(document: Document, view: MapView) -> list[_Drawing]:
    """Return the lines of vehicles alone; of a crowd, ribbons stand for all that are on a road."""
    return [
        _drawing(number, [view.pixels(part.line) for part in solo.parts], strip)
        for number, (solo, strip) in enumerate(
            zip(document.solos, solo_strips(document, view), strict=True)
        )
        if document.traffic is None or solo.access
    ]


def _band_drawings(document: Document, view: MapView) -> list[_Drawing]:
    """Return the bands of platoons, unless ribbons stand for them.

    Stretches of one company that follow each other, cut where it stands or hands on the lead, are
    one band, or its lines would not meet where the road bends.
    """
    if document.traffic is not None and document.traffic.bundled:
        return []
    found: list[_Drawing] = []
    roads: list[list[Point]] = []
    asides: list[float] = []
    first = 0
    every = zip(document.platoons, band_strips(document, view), strict=True)
    for number, (one, strip) in enumerate(every):
        if not roads:
            first = number
        roads += [view.pixels(part.line) for part in one.parts]
        asides += strip.asides
        after = document.platoons[number + 1 : number + 2]
        goes_on = bool(roads) and any(
            other.vehicles == one.vehicles
            and other.parts
            and view.pixels(other.parts[0].line)[:1] == roads[-1][-1:]
            for other in after
        )
        if not goes_on:
            found.append(_drawing(first, roads, strip._replace(asides=asides)))
            roads, asides = [], []
    return found


def _drawing(number: int, roads: list[list[Point]], strip: Strip) -> _Drawing:
    lines = lines_along(roads, strip.asides, strip.offsets)
    return _Drawing(number, lines, strip.width, strip.inner)


def _solo_routes(document: Document, drawings: Sequence[_Drawing]) -> Iterator[Piece]:
    """Yield the lines of vehicles alone, over the casings of all of them."""
    for one in drawings:
        yield Piece(
            "static-line",
            {
                "path": one.lines[0].path,
                "colour": CASING,
                "width": f"{one.width + 3.4:.3g}",
                "dash": "none",
                "cap": "butt",
            },
        )
    for one in drawings:
        solo = document.solos[one.number]
        vehicle = document.vehicles[solo.vehicle]
        yield Piece(
            "static-line",
            {
                "path": one.lines[0].path,
                "colour": vehicle.colour,
                "width": f"{one.width:.3g}",
                "dash": DOTS if solo.access else vehicle.stroke,
                "cap": "round" if solo.access else vehicle.cap,
            },
        )


def _band(document: Document, one: _Drawing) -> Iterator[Piece]:
    """Yield the band of a platoon and the lines in it."""
    middle, *lanes = one.lines
    members = [document.vehicles[index] for index in document.platoons[one.number].vehicles]
    yield Piece(
        "static-band",
        {"path": middle.path, "outer": f"{one.inner + 2:g}", "inner": f"{one.inner:g}"},
    )
    for vehicle, line in zip(members, lanes, strict=True):
        yield Piece(
            "static-line",
            {
                "path": line.path,
                "colour": vehicle.colour,
                "width": f"{one.width:.3g}",
                "dash": (len(members) <= CROWD and vehicle.dash) or "none",
                "cap": vehicle.cap,
            },
        )


def _callout(one: Callout) -> Piece:
    leader: Tree = NOTHING
    if one.near:
        x2, y2 = one.near
        leader = Piece(
            "static-leader",
            {"x1": f"{one.x:.1f}", "y1": f"{one.y:.1f}", "x2": f"{x2:.1f}", "y2": f"{y2:.1f}"},
        )
    box = one.box
    return Piece(
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


def town_names(names: Iterable[tuple[str, Box]], scale: float = 1.0) -> tuple[Piece, ...]:
    """Return the names of towns.

    Parameters
    ----------
    names : iterable of tuple of str and Box
        Each name and the box it stands in.
    scale : float
        How much larger than common they are.

    Returns
    -------
    tuple of Piece
        Each name.
    """
    return tuple(
        Piece(
            "static-name",
            {"x": f"{box.left + 4 * scale:.1f}", "y": f"{box.top + 13 * scale:.1f}", "text": text},
        )
        for text, box in names
    )


def _round_length(length_m: float) -> str:
    return f"{length_m:g} m" if length_m < 1000 else f"{length_m / 1000:g} km"
