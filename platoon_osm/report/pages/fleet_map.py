"""The map of a fleet's page: width is the number of vehicles, colour how many drive in company."""

from __future__ import annotations

from ..document.fleet import SHARES, WIDTHS, FleetDocument, Traffic
from ..drawing.palette import FLOWS
from ..language.speech import number, say
from ..maps.beside import shifted, simplified
from ..maps.ground_paths import EDGE, ground_piece, town_dots
from ..maps.map_texts import placed_names
from ..maps.map_view import MapView
from ..maps.pixels import network_path, path_data
from ..maps.placement import Cover
from ..maps.static_map import NARROW, static_texts, town_names
from ..markup.fragments import NOTHING, Piece, Tree

__all__ = ["fleet_map", "share_keys", "width_keys"]

THINNEST, WIDEST = 1.6, 8.4


def fleet_map(found: FleetDocument) -> Piece:
    """Return the map.

    Parameters
    ----------
    found : FleetDocument
        Whose flows are drawn.

    Returns
    -------
    Piece
        An SVG.
    """
    ends = [
        (stop.lon, stop.lat) for one in found.plan.trips for stop in (one.origin, one.destination)
    ]
    view = MapView.around(found.points or ends, margin=34.0)
    cover = Cover(view.width, view.height)
    casings: list[Piece] = []
    roads: list[Piece] = []
    for one in found.traffic:
        width = _width(one.width)
        lines = [simplified(view.pixels(line)) for line in one.lines]
        for points in lines:
            cover.add_line(points, weight=2)
        # Each direction lies on its own side of the road.
        path = "".join(path_data(shifted(points, width / 2)) for points in lines)
        casings.append(Piece("flows-casing", {"path": path, "width": f"{width + 1.4:.1f}"}))
        roads.append(
            Piece(
                "flows-road",
                {
                    "path": path,
                    "width": f"{width:.1f}",
                    "colour": FLOWS[one.share],
                    "text": f"{_vehicles(one)}; {say('fleet.share-key')}: {_share(one.share)}",
                },
            )
        )
    chosen = tuple(
        Piece(
            "flows-platoon",
            {
                "number": rank,
                "path": "".join(
                    path_data(simplified(view.pixels(line)))
                    for line in listed.lines
                    if len(line.points)
                ),
            },
        )
        for rank, listed in enumerate(found.platoons)
        if listed.lines
    )
    network = [view.pixels(line) for line in found.network]
    narrow = cover.copy()
    towns = view.towns(found.around)
    names = town_names(placed_names(found.around, towns, cover))
    large = town_names(placed_names(found.around, towns, narrow, NARROW), NARROW)
    return Piece(
        "flows-map",
        {
            "width": f"{view.width:g}",
            "height": f"{view.height:g}",
            "title": say("fleet.map-title", n=len(found.plan.trips), most=number(found.most)),
            "ground": ground_piece(found.around, view, EDGE),
            "towns": town_dots(found.around, view),
            "network": network_path(network, view.width, view.height),
            "casings": tuple(casings),
            "roads": tuple(roads),
            "chosen": chosen,
            "wide": static_texts("wide", names, NOTHING),
            "narrow": static_texts("narrow", large, NOTHING, scale=NARROW),
        },
    )


def width_keys(found: FleetDocument) -> Tree:
    """Return the legend of widths.

    Parameters
    ----------
    found : FleetDocument
        Whose classes are told.

    Returns
    -------
    Tree
        A line for each that is on the map.
    """
    rows = []
    for width in range(WIDTHS):
        own = [one for one in found.traffic if one.width == width]
        if own:
            low, high = min(one.low for one in own), max(one.high for one in own)
            text = _range(low, high)
            rows.append(Piece("fleet-width", {"width": f"{_width(width):.1f}", "text": text}))
    return tuple(rows)


def share_keys(found: FleetDocument) -> Tree:
    """Return the legend of colours.

    Parameters
    ----------
    found : FleetDocument
        Whose classes are told.

    Returns
    -------
    Tree
        A line for each that is on the map.
    """
    seen = sorted({one.share for one in found.traffic})
    return tuple(
        Piece("fleet-key", {"colour": FLOWS[share], "width": "6", "text": _share(share)})
        for share in seen
    )


def _width(rank: int) -> float:
    return THINNEST + (WIDEST - THINNEST) * rank / (WIDTHS - 1)


def _range(low: int, high: int) -> str:
    if low == high:
        return number(low)
    return say("flows.range", low=number(low), high=number(high))


def _vehicles(one: Traffic) -> str:
    return say("fleet.road-vehicles", n=one.high, range=_range(one.low, one.high))


def _share(rank: int) -> str:
    if not rank:
        return say("fleet.share-none")
    low, high = (f"{100 * SHARES[k]:g}" for k in (rank - 1, rank))
    return say("form.percent", number=f"{low}\u2013{high}")
