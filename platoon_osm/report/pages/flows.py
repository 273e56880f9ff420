"""A page for many vehicles: flows on the network, platoons as a list, savings as a histogram."""

from __future__ import annotations

import math
import os
from collections import Counter
from collections.abc import Iterator, Sequence
from typing import Any

import numpy as np

from ...atomic_file import whole_file
from ...network.road_network import RoadNetwork
from ...plans.records import JointPlan
from ..document.document import report_document
from ..drawing.basemap import BASEMAP_STEPS, ROUTE_STEPS, ROUTE_TOLERANCE_M, basemap_lines
from ..drawing.map_view import MapView, path_data, shifted
from ..drawing.placement import Box, Cover
from ..drawing.polyline import decode_lines, encode_lines
from ..drawing.static_map import NARROW, static_texts, town_names
from ..drawing.vehicle_styles import letter_size
from ..markup.fragments import NOTHING, Markup, fill, join
from ..markup.quantities import percent
from ..markup.still_page import still_page
from .page_pieces import about, credit_lines, heading, opening, unit_note

__all__ = ["flow_document", "write_flows"]

FLOWS_VERSION = 1

CLASSES = 5
THINNEST, WIDEST = 1.8, 9.0
COLOURS = ("#8fb8de", "#5b97cf", "#2f74b5", "#14528c", "#0a3157")
"""From few vehicles to many: one hue, so that it reads in grey too."""

BINS = 12
LEFT, RIGHT, TOP, BASE = 30.0, 366.0, 12.0, 150.0


def write_flows(
    plan: JointPlan, net: RoadNetwork, path: str | os.PathLike[str], *, title: str | None = None
) -> None:
    """Write the page of a plan with many vehicles; whole or not at all.

    It asks the network for nothing. Its list of platoons is complete without a script; the script
    sorts and filters it and shows a platoon's road on the map.

    Raises
    ------
    ScenarioError
        A plan of another network, or a file that cannot be written.
    """
    page = _page(flow_document(plan, net, title=title))
    with whole_file(path) as draft:
        draft.write_text(page, encoding="utf-8", newline="\n")


def flow_document(plan: JointPlan, net: RoadNetwork, *, title: str | None = None) -> dict[str, Any]:
    """Return what the page shows as plain JSON types; errors as in `report_document`."""
    document = report_document(plan, net, title=title)
    flows = list(_flows(plan, net))
    return {
        **document,
        "format": "platoon_osm flows",
        "version": FLOWS_VERSION,
        "flows": flows,
        "most": max((flow["vehicles"] for flow in flows), default=0),
        "histogram": _histogram([vehicle["saving"] for vehicle in document["vehicles"]]),
    }


def _flows(plan: JointPlan, net: RoadNetwork) -> Iterator[dict[str, Any]]:
    """Yield the roads used, for each number of vehicles that drive on them."""
    count: Counter[int] = Counter()
    for vehicle in plan.vehicles:
        count.update(set(vehicle.edges))
    edges = np.array(sorted(count), np.int64)
    used = np.array([count[int(edge)] for edge in edges], np.int64)
    for vehicles in sorted(set(used.tolist())):
        here = edges[used == vehicles]
        yield {
            "vehicles": vehicles,
            "length_m": float(net.length_m[here].sum()),
            "lines": encode_lines(
                basemap_lines(net, here, ROUTE_TOLERANCE_M, directed=True), ROUTE_STEPS
            ),
        }


def _histogram(savings: Sequence[float]) -> dict[str, Any]:
    """Return how many vehicles save what share: bins of a round width, and the middle vehicle."""
    low, high = min(0.0, *savings, 0.0), max(0.0, *savings, 0.0)
    step = _round_step((high - low) / BINS) if high > low else 0.01
    # Shares that are zero but for rounding belong to no gain and no loss.
    first = math.floor(low / step + 1e-9)
    counts: Counter[int] = Counter(math.floor(saving / step + 1e-9) for saving in savings)
    last = max(counts)
    return {
        "step": step,
        "first": first,
        "counts": [counts.get(k, 0) for k in range(first, last + 1)],
        "median": float(np.median(savings)),
    }


def _round_step(least: float) -> float:
    power = 10.0 ** math.floor(math.log10(least))
    return float(next(k * power for k in (1, 2, 5, 10) if k * power >= least * (1 - 1e-9)))


# -- the page --------------------------------------------------------------------------------------


def _page(document: dict[str, Any]) -> str:
    groups = [group for group in document["groups"] if group["kind"] == "platoon"]
    alone = sum(len(g["vehicles"]) for g in document["groups"] if g["kind"] == "alone")
    rows = document["provenance"]["rows"]
    body = fill(
        "flows",
        opening=opening(document),
        map=_map(document),
        keys=_keys(document["most"]),
        credits=credit_lines(document),
        heading=heading(document),
        histogram=_histogram_chart(document),
        unit=document["cost_unit"]["label"],
        platoons=_platoons(document, groups),
        alone=fill("flows-alone", count=alone) if alone else NOTHING,
        unit_note=unit_note(document),
        about=about(
            document, join(fill("about-row", label=label, text=text) for label, text in rows)
        ),
    )
    return still_page(document["title"], body, ("page.css", "flows.css"), ("flows.js",))


def flow_class(vehicles: int, most: int) -> int:
    """Return the class, 0 to `CLASSES` - 1, of a flow; classes are even in the square root."""
    share = math.sqrt(vehicles / most) if most else 0.0
    return min(CLASSES - 1, max(0, math.ceil(share * CLASSES) - 1))


def _width(vehicles: int, most: int) -> float:
    return THINNEST + (WIDEST - THINNEST) * math.sqrt(vehicles / most)


def _map(document: dict[str, Any]) -> Markup:
    view = MapView(document)
    cover = Cover(view.width, view.height)
    casings: list[Markup] = []
    roads: list[Markup] = []
    for flow in document["flows"]:
        lines = [view.pixels(line) for line in decode_lines(flow["lines"], ROUTE_STEPS)]
        width = _width(flow["vehicles"], document["most"])
        for points in lines:
            cover.add_line(points, weight=2)
        # Each direction lies on its own side of the road.
        path = "".join(path_data(shifted(points, width / 2)) for points in lines)
        colour = COLOURS[flow_class(flow["vehicles"], document["most"])]
        number = flow["vehicles"]
        text = f"{number} vehicle{'s' if number > 1 else ''}"
        casings.append(fill("flows-casing", path=path, width=f"{width + 2:.1f}"))
        roads.append(
            fill("flows-road", path=path, width=f"{width:.1f}", colour=colour, text=text)
        )  # fmt: skip
    chosen = [
        fill("flows-platoon", number=number, path="".join(
            path_data(view.route(part["line"]))
            for piece in document["platoons"]
            if piece["vehicles"][0] in group["vehicles"]
            for part in piece["parts"]
        ))
        for number, group in enumerate(document["groups"])
        if group["kind"] == "platoon"
    ]  # fmt: skip
    network = view.network_path(decode_lines(document["basemap"]["known"], BASEMAP_STEPS))
    narrow = cover.copy()
    cover.add_box(Box(0, 0, 190, 150))
    names = join(town_names(document, view, cover))
    large = join(town_names(document, view, narrow, NARROW))
    return fill(
        "flows-map",
        width=f"{view.width:g}",
        height=f"{view.height:g}",
        title=f"Vehicles per road: {document['subtitle']}",
        network=network,
        casings=join(casings),
        roads=join(roads),
        chosen=join(chosen),
        wide=static_texts("wide", names, NOTHING),
        narrow=static_texts("narrow", large, NOTHING, scale=NARROW),
    )


def _keys(most: int) -> Markup:
    """Return the legend: a line for each class that holds a number of vehicles."""
    rows: list[Markup] = []
    classes: dict[int, list[int]] = {}
    for vehicles in range(1, most + 1):
        classes.setdefault(flow_class(vehicles, most), []).append(vehicles)
    for number, held in sorted(classes.items()):
        low, high = held[0], held[-1]
        rows.append(
            fill("flows-key", colour=COLOURS[number], width=f"{_width(high, most):.1f}",
                 text=f"{low}" if low == high else f"{low} to {high}")
        )  # fmt: skip
    return join(rows)


def _platoons(document: dict[str, Any], groups: Sequence[dict[str, Any]]) -> Markup:
    rows: list[Markup] = []
    for number, group in enumerate(document["groups"]):
        if group not in groups:
            continue
        vehicles = [document["vehicles"][index] for index in group["vehicles"]]
        before = sum(vehicle["solo_cost"] for vehicle in vehicles)
        saving = group["saved"] / before if before else 0.0
        members = join(
            fill("flows-member", letter=v["letter"], name=v["name"], colour=v["colour"],
                 size=letter_size(v["letter"]),
                 origin=v["origin"]["name"], destination=v["destination"]["name"],
                 saved=v["text"]["saved"])
            for v in vehicles
        )  # fmt: skip
        rows.append(
            fill(
                "flows-row", number=number, name=group["name"], count=len(vehicles),
                km=f"{group['road_m'] / 1000:,.0f}", km_value=f"{group['road_m']:.0f}",
                saved=group["text"]["saved"], saved_value=f"{group['saved']:.6g}",
                share=group["text"]["share"], share_value=f"{saving:.6g}", members=members,
                sign="gain" if saving > 0 else "loss" if saving < 0 else "even",
                first=vehicles[0]["origin"]["name"], last=vehicles[0]["destination"]["name"],
            )
        )  # fmt: skip
    return join(rows)


def _histogram_chart(document: dict[str, Any]) -> Markup:
    found = document["histogram"]
    counts, step, first = found["counts"], found["step"], found["first"]
    most = max(counts)
    width = (RIGHT - LEFT) / len(counts)
    bars: list[Markup] = []
    for place, count in enumerate(counts):
        low, high = (first + place) * step, (first + place + 1) * step
        height = (BASE - TOP) * count / most
        bars.append(
            fill(
                "flows-bar", x=f"{LEFT + place * width + 1:.1f}", width=f"{width - 2:.1f}",
                y=f"{BASE - height:.1f}", height=f"{height:.1f}", count=count or "",
                middle=f"{LEFT + (place + 0.5) * width:.1f}", text_y=f"{BASE - height - 3:.1f}",
                colour="#0072b2" if low >= -1e-12 else "#a3260a",
                text=f"{percent(low)} to {percent(high)}: {count} vehicles",
            )
        )  # fmt: skip
    # Every second edge is named where all would not fit.
    every = max(1, math.ceil(len(counts) / 7))
    decimals = 0 if step >= 0.0099 else 1 if step >= 0.00099 else 2
    edges = [
        fill("flows-edge", x=f"{LEFT + k * width:.1f}",
             text=f"{(first + k) * step * 100:.{decimals}f}".replace("-", "\u2212"))
        for k in range(0, len(counts) + 1, every)
    ]  # fmt: skip
    return fill(
        "flows-histogram", bars=join(bars), edges=join(edges), base=BASE,
        median=percent(found["median"]),
    )  # fmt: skip
