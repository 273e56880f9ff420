"""A page for many vehicles: flows on the network, platoons as a list, savings as a histogram."""

from __future__ import annotations

import math
import os

from ...atomic_file import whole_file
from ...network.road_network import RoadNetwork
from ...output_paths import PAGES
from ...plans.plan import Plan
from ..document.checks import check_path
from ..document.flows import FlowDocument, Histogram, flow_document_of
from ..document.model import Document
from ..document.status import lateness
from ..drawing.palette import FLOWS, GAIN, LOSS
from ..language.speech import number, say, speaking
from ..maps.beside import shifted, simplified
from ..maps.ground_paths import ground_piece, town_dots
from ..maps.map_texts import placed_names
from ..maps.map_view import MapView
from ..maps.pixels import network_path, path_data
from ..maps.placement import Box, Cover
from ..maps.static_map import NARROW, static_texts, town_names
from ..markup.fragments import NOTHING, Piece, Tree
from ..markup.quantities import gain_or_loss, percent, true_minus
from ..markup.still_page import PAGE_STYLES, still_page
from .page_pieces import about, credit_lines, heading, late_mark, opening, unit_note

__all__ = ["CLASSES", "flow_class", "histogram_piece", "write_flows"]

CLASSES = len(FLOWS)
THINNEST, WIDEST = 1.8, 9.0

NARROWEST, WIDEST_FRAME = 0.7, 2.3
"""Width to height of the frames that ground and network fill; flows.css keeps to them."""

LEFT, RIGHT, TOP, BASE = 30.0, 366.0, 12.0, 150.0


def write_flows(
    plan: Plan,
    net: RoadNetwork,
    path: str | os.PathLike[str],
    *,
    title: str | None = None,
    language: str | None = None,
    clock: int | None = None,
) -> None:
    """Write the page of a plan with many vehicles; whole or not at all.

    It asks the network for nothing. Its list of platoons is complete without a script; the script
    sorts and filters it and shows a platoon's road on the map.

    Parameters
    ----------
    plan : Plan
        What is told.
    net : RoadNetwork
        The network the plan was made on.
    path : path-like
        Of the file; missing folders are made.
    title : str or None
        Heads the page; by default made from the first vehicle's journey.
    language : str or None
        That the texts are in, such as "de"; by default English.
    clock : int or None
        24 or 12 hours; by default as the language has it.

    Raises
    ------
    ScenarioError
        A plan of another network, or a file that cannot be written.
    """
    path = check_path(path)
    with speaking(language, clock):
        page = _page(flow_document_of(plan, net, title=title))
    with whole_file(path, suffixes=PAGES) as draft:
        draft.write_text(page, encoding="utf-8", newline="\n")


def _page(found: FlowDocument) -> str:
    document = found.document
    rows = document.provenance.rows
    body = Piece(
        "flows",
        {
            "opening": opening(document),
            "map": _map(found),
            "keys": _keys(found.most),
            "credits": credit_lines(document),
            "heading": heading(document),
            # Where nobody drives in company, nobody saves: there is nothing to list.
            "histogram": histogram_piece(found.histogram) if document.platoons else NOTHING,
            "platoons": Piece(
                "flows-list",
                {
                    "unit": document.cost_unit.label,
                    "rows": _platoons(document),
                    "unit_note": unit_note(document),
                },
            )
            if document.platoons
            else NOTHING,
            "alone": _alone(document),
            "about": about(
                document,
                tuple(Piece("about-row", {"label": label, "text": text}) for label, text in rows),
            ),
        },
    )
    # The script sorts and filters the list of platoons.
    scripts = ("elements.js", "flows.js") if document.platoons else ()
    return still_page(document.title, body, (*PAGE_STYLES, "flows.css"), scripts)


def flow_class(vehicles: int, most: int) -> int:
    """Return the class of a flow; classes are even in the square root.

    Parameters
    ----------
    vehicles : int
        How many drive there.
    most : int
        Most vehicles on one road.

    Returns
    -------
    int
        0 to `CLASSES` - 1.
    """
    share = math.sqrt(vehicles / most) if most else 0.0
    return min(CLASSES - 1, max(0, math.ceil(share * CLASSES) - 1))


def _width(vehicles: int, most: int) -> float:
    return THINNEST + (WIDEST - THINNEST) * math.sqrt(vehicles / most)


def _map(found: FlowDocument) -> Piece:
    document = found.document
    view = MapView([document])
    cover = Cover(view.width, view.height)
    casings: list[Piece] = []
    roads: list[Piece] = []
    for flow in found.flows:
        lines = [simplified(view.pixels(line)) for line in flow.lines]
        width = _width(flow.vehicles, found.most)
        for points in lines:
            cover.add_line(points, weight=2)
        # Each direction lies on its own side of the road.
        path = "".join(path_data(shifted(points, width / 2)) for points in lines)
        colour = FLOWS[flow_class(flow.vehicles, found.most)]
        text = say("totals.vehicles", n=flow.vehicles)
        casings.append(Piece("flows-casing", {"path": path, "width": f"{width + 2:.1f}"}))
        roads.append(
            Piece(
                "flows-road",
                {"path": path, "width": f"{width:.1f}", "colour": colour, "text": text},
            )
        )
    chosen = [
        Piece(
            "flows-platoon",
            {
                "number": rank,
                "path": "".join(
                    path_data(simplified(view.pixels(part.line)))
                    for piece in document.platoons
                    if piece.vehicles[0] in group.vehicles
                    for part in piece.parts
                ),
            },
        )
        for rank, group in enumerate(document.groups)
        if group.is_platoon
    ]
    known = [view.pixels(line) for line in document.basemap.known]
    beyond = _beyond(view)
    network = network_path(known, view.width, view.height, beyond=beyond)
    narrow = cover.copy()
    cover.add_box(Box(0, 0, 190, 150))
    towns = view.places(document).towns
    names = town_names(placed_names(document, towns, cover))
    large = town_names(placed_names(document, towns, narrow, NARROW), NARROW)
    return Piece(
        "flows-map",
        {
            "width": f"{view.width:g}",
            "height": f"{view.height:g}",
            "title": say("flows.map-title", what=document.subtitle),
            "ground": ground_piece(document, view, beyond),
            "towns": town_dots(document, view),
            "network": network,
            "casings": tuple(casings),
            "roads": tuple(roads),
            "chosen": tuple(chosen),
            "wide": static_texts("wide", names, NOTHING),
            "narrow": static_texts("narrow", large, NOTHING, scale=NARROW),
        },
    )


def _beyond(view: MapView) -> float:
    """Return how far beyond its edges a map is drawn, to fill a frame of another shape."""
    across = (WIDEST_FRAME * view.height - view.width) / 2
    down = (view.width / NARROWEST - view.height) / 2
    return max(across, down)


def _keys(most: int) -> Tree:
    """Return the legend: a line for each class that holds a number of vehicles."""
    rows: list[Piece] = []
    classes: dict[int, list[int]] = {}
    for vehicles in range(1, most + 1):
        classes.setdefault(flow_class(vehicles, most), []).append(vehicles)
    for rank, held in sorted(classes.items()):
        low, high = held[0], held[-1]
        rows.append(
            Piece(
                "flows-key",
                {
                    "colour": FLOWS[rank],
                    "width": f"{_width(high, most):.1f}",
                    "text": number(low)
                    if low == high
                    else say("flows.range", low=number(low), high=number(high)),
                },
            )
        )
    return tuple(rows)


def _alone(document: Document) -> Tree:
    """Return how many drive alone, and who of them is late."""
    alone = [
        document.vehicles[index]
        for group in document.groups
        if not group.is_platoon
        for index in group.vehicles
    ]
    if not alone:
        return NOTHING
    late = ", ".join(lateness(alone))
    return Piece(
        "flows-alone",
        {
            "text": say("flows.alone", n=len(alone)),
            "late": say("flows.late-alone", who=late) if late else "",
        },
    )


def _platoons(document: Document) -> Tree:
    rows: list[Piece] = []
    for rank, group in enumerate(document.groups):
        if not group.is_platoon:
            continue
        vehicles = [document.vehicles[index] for index in group.vehicles]
        before = sum(vehicle.solo_cost for vehicle in vehicles)
        saving = group.saved / before if before else 0.0
        late = sum(vehicle.is_late for vehicle in vehicles)
        members = tuple(
            Piece(
                "flows-member",
                {
                    "letter": v.letter,
                    "name": v.name,
                    "colour": v.colour,
                    "size": v.letter_size,
                    "origin": v.origin.brief,
                    "destination": v.destination.brief,
                    "saved": v.text.saved,
                    "late": late_mark(v),
                },
            )
            for v in vehicles
        )
        rows.append(
            Piece(
                "flows-row",
                {
                    "number": rank,
                    "name": group.name,
                    "late": Piece("late-by", {"text": say("flows.late", n=late)})
                    if late
                    else NOTHING,
                    "count": len(vehicles),
                    "km": number(group.road_m / 1000),
                    "km_value": f"{group.road_m:.0f}",
                    "saved": group.text.saved,
                    "saved_value": f"{group.saved:.6g}",
                    "share": group.text.share,
                    "share_value": f"{saving:.6g}",
                    "members": members,
                    "sign": "even" if late and saving > 0 else gain_or_loss(saving),
                    "first": vehicles[0].origin.brief,
                    "last": vehicles[0].destination.brief,
                },
            )
        )
    return tuple(rows)


def histogram_piece(found: Histogram) -> Piece:
    """Return how many vehicles save what share, as a drawing.

    Parameters
    ----------
    found : Histogram
        Of the document.

    Returns
    -------
    Piece
        A section of the page.
    """
    counts, step, first = found.counts, found.step, found.first
    most = max(counts)
    width = (RIGHT - LEFT) / len(counts)
    bars: list[Piece] = []
    for place, count in enumerate(counts):
        low, high = (first + place) * step, (first + place + 1) * step
        height = (BASE - TOP) * count / most
        bars.append(
            Piece(
                "flows-bar",
                {
                    "x": f"{LEFT + place * width + 1:.1f}",
                    "width": f"{width - 2:.1f}",
                    "y": f"{BASE - height:.1f}",
                    "height": f"{height:.1f}",
                    "count": count or "",
                    "middle": f"{LEFT + (place + 0.5) * width:.1f}",
                    "text_y": f"{BASE - height - 3:.1f}",
                    "colour": GAIN if low >= -1e-12 else LOSS,
                    "text": say("flows.bin", n=count, low=percent(low), high=percent(high)),
                },
            )
        )
    # Every second edge is named where all would not fit.
    every = max(1, math.ceil(len(counts) / 7))
    decimals = 0 if step >= 0.0099 else 1 if step >= 0.00099 else 2
    edges = [
        Piece(
            "flows-edge",
            {
                "x": f"{LEFT + k * width:.1f}",
                "text": true_minus(number((first + k) * step * 100, decimals)),
            },
        )
        for k in range(0, len(counts) + 1, every)
    ]
    heading_text = say("flows.median", median=percent(found.median))
    return Piece(
        "flows-histogram",
        {"bars": tuple(bars), "edges": tuple(edges), "base": BASE, "heading": heading_text},
    )
