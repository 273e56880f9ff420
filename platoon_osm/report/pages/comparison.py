"""Several plans side by side on one page: maps, one table, bars. Without any script."""

from __future__ import annotations

import os
from collections.abc import Sequence
from typing import Any

from ...atomic_file import whole_file
from ...errors import ScenarioError
from ...network.road_network import RoadNetwork
from ...plans.records import JointPlan
from ..document.document import report_document
from ..drawing.static_map import small_maps
from ..drawing.vehicle_styles import VehicleStyle, vehicle_styles
from ..markup.fragments import NOTHING, Markup, fill, join
from ..markup.quantities import MINUS, kilometres, litres, percent
from ..markup.shown_text import fitted, shown
from ..markup.still_page import still_page
from .page_pieces import badge

__all__ = ["comparison_document", "write_comparison"]

COMPARISON_VERSION = 1

MOST_BY_VEHICLE = 12
"""Vehicles in all plans together that are compared one by one; of more, only sums are."""

BARS_LEFT, BARS_RIGHT, BAR_ROW = 4.0, 480.0, 26


def write_comparison(
    plans: Sequence[JointPlan],
    net: RoadNetwork,
    path: str | os.PathLike[str],
    *,
    titles: Sequence[str] | None = None,
    title: str = "Plans side by side",
) -> None:
    """Write one page that sets plans of one network side by side; whole or not at all.

    The same plans give the same bytes. The page has no script and asks the network for nothing.

    Parameters
    ----------
    plans : two or more, of the same network; cases of one scenario, or other parameters.
    titles : of the plans; by default their cases.
    title : heads the page.

    Raises
    ------
    ScenarioError
        No plans, a plan of another network, or titles of another number.
    """
    page = _page(comparison_document(plans, net, titles=titles, title=title))
    with whole_file(path) as draft:
        draft.write_text(page, encoding="utf-8", newline="\n")


def comparison_document(
    plans: Sequence[JointPlan],
    net: RoadNetwork,
    *,
    titles: Sequence[str] | None = None,
    title: str = "Plans side by side",
) -> dict[str, Any]:
    """Return what the page shows as plain JSON types: a report document for each plan.

    A vehicle has the same letter and colour in all of them. Errors as in `write_comparison`.
    """
    if not plans:
        raise ScenarioError("compare: no plans; give two or more of one network")
    if titles is not None and len(titles) != len(plans):
        raise ScenarioError(f"compare: {len(titles)} titles for {len(plans)} plans; give one each")
    heads = titles if titles is not None else [f"Case {plan.case}" for plan in plans]
    styles = _common_styles(plans)
    documents = [
        report_document(plan, net, title=head, styles=styles)
        for plan, head in zip(plans, heads, strict=True)
    ]
    for document, head in zip(documents, heads, strict=True):
        document["title"] = fitted(head) if shown(head) else "Plan"
    units = {document["cost_unit"]["label"] for document in documents}
    remarks = [
        f"Costs of these plans are in other units ({', '.join(sorted(units))}): compare shares."
    ] * (len(units) > 1)
    if len({tuple(sorted((k, repr(v)) for k, v in plan.params.items())) for plan in plans}) > 1:
        remarks.append(
            "These plans were made with other cost parameters: compare shares, not costs."
        )
    return {
        "format": "platoon_osm comparison",
        "version": COMPARISON_VERSION,
        "title": fitted(title) if shown(title) else "Plans side by side",
        "subtitle": f"{len(plans)} plans on {fitted(plans[0].network.name)}",
        "remarks": remarks,
        "plans": documents,
    }


def _common_styles(plans: Sequence[JointPlan]) -> dict[str, VehicleStyle]:
    names = list(dict.fromkeys(vehicle.vehicle for plan in plans for vehicle in plan.vehicles))
    return dict(zip(names, vehicle_styles(names), strict=True))


# -- the page --------------------------------------------------------------------------------------


def _page(document: dict[str, Any]) -> str:
    plans = document["plans"]
    cards = [
        fill("comparison-card", number=number, title=plan["title"], map=drawing,
             figures=join(fill("figure", **figure) for figure in plan["totals"]["figures"]),
             subtitle=plan["subtitle"])
        for number, (plan, drawing) in enumerate(zip(plans, small_maps(plans), strict=True), 1)
    ]  # fmt: skip
    unit = plans[0]["cost_unit"]
    notes = [*document["remarks"], *([unit["note"]] if unit["note"] else [])]
    credits = list(dict.fromkeys(line for p in plans for line in p["provenance"]["credits"]))
    body = fill(
        "comparison",
        icons=fill("icons"),
        title=document["title"],
        subtitle=document["subtitle"],
        keys=_keys(plans),
        cards=join(cards),
        unit=unit["label"],
        rows=join(_row(plan) for plan in plans),
        notes=join(fill("item", text=note) for note in notes),
        bars=_bars(plans),
        by_vehicle=_by_vehicle(plans),
        about=join(
            fill("comparison-about", title=plan["title"], rows=join(
                fill("about-row", label=label, text=text)
                for label, text in plan["provenance"]["rows"]
            ))
            for plan in plans
        ),
        credits=join(fill("item", text=text) for text in credits),
    )  # fmt: skip
    return still_page(document["title"], body, styles=("page.css", "comparison.css"))


def _vehicles(plans: Sequence[dict[str, Any]]) -> dict[str, dict[str, Any]]:
    """Return all vehicles of the plans by letter, each as in the first plan that has it."""
    found: dict[str, dict[str, Any]] = {}
    for plan in plans:
        for vehicle in plan["vehicles"]:
            found.setdefault(vehicle["letter"], vehicle)
    return found


def _keys(plans: Sequence[dict[str, Any]]) -> Markup:
    vehicles = _vehicles(plans).values()
    return join(
        fill("comparison-key", badge=badge(vehicle), name=vehicle["name"],
             origin=vehicle["origin"]["name"], destination=vehicle["destination"]["name"])
        for vehicle in list(vehicles)[:MOST_BY_VEHICLE]
    )  # fmt: skip


def _row(plan: dict[str, Any]) -> Markup:
    totals = plan["totals"]
    saved = totals["solo_cost"] - totals["joint_cost"]
    extra = f"{'+' if totals['extra_m'] > 0 else ''}{kilometres(totals['extra_m'])}"
    return fill(
        "comparison-row",
        title=plan["title"],
        vehicles=len(plan["vehicles"]),
        road=kilometres(totals["platoon_road_m"]),
        extra=extra.replace("-", MINUS),
        fuel=litres(totals["fuel_saved_l"]).replace("-", MINUS),
        sign="gain" if saved > 0 else "loss" if saved < 0 else "even",
        **totals["text"],
    )


def _bars(plans: Sequence[dict[str, Any]]) -> Markup:
    """Return a bar per plan: the share saved, by vehicle; losses left of the line, hatched."""
    shares = [_shares(plan) for plan in plans]
    most = max(sum(max(share, 0.0) for _, share in one) for one in shares)
    least = -max(sum(max(-share, 0.0) for _, share in one) for one in shares)
    if most - least <= 0:
        return NOTHING
    scale = (BARS_RIGHT - BARS_LEFT) / (most - least)
    zero = BARS_LEFT - least * scale
    rows = []
    for place, (plan, one) in enumerate(zip(plans, shares, strict=True)):
        shapes: list[Markup] = []
        right = left = zero
        for vehicle, share in one:
            width = abs(share) * scale
            start = right if share >= 0 else left - width
            right, left = (right + width, left) if share >= 0 else (right, left - width)
            letter = vehicle["letter"] if width > 18 else ""
            shapes.append(
                fill("comparison-bar" if share >= 0 else "comparison-loss", x=f"{start:.1f}",
                     width=f"{width:.1f}", colour=vehicle["colour"], letter=letter,
                     middle=f"{start + width / 2:.1f}",
                     text=f"{vehicle['letter']}: {percent(share).replace('-', MINUS)}")
            )  # fmt: skip
        rows.append(
            fill("comparison-bars-row", y=22 + (BAR_ROW + 18) * place, title=plan["title"],
                 shapes=join(shapes), zero=f"{zero:.1f}", share=plan["totals"]["text"]["share"])
        )  # fmt: skip
    return fill(
        "comparison-bars", height=10 + (BAR_ROW + 18) * len(plans),
        rows=join(rows),
    )  # fmt: skip


def _shares(plan: dict[str, Any]) -> list[tuple[dict[str, Any], float]]:
    """Return what each vehicle saves, as a share of all costs alone; of a crowd, all in one."""
    alone = plan["totals"]["solo_cost"] or 1.0
    vehicles = plan["vehicles"]
    if len(vehicles) > MOST_BY_VEHICLE:
        crowd = {"letter": f"{len(vehicles)}\u00d7", "colour": "#4d5560"}
        return [(crowd, plan["totals"]["saving"])]
    return [(vehicle, vehicle["saved"] / alone) for vehicle in vehicles]


def _by_vehicle(plans: Sequence[dict[str, Any]]) -> Markup:
    """Return what each vehicle saves under each plan; nothing for a crowd."""
    every = _vehicles(plans)
    if len(every) > MOST_BY_VEHICLE:
        return NOTHING
    rows = []
    for letter, vehicle in every.items():
        cells = []
        for plan in plans:
            own = next((one for one in plan["vehicles"] if one["letter"] == letter), None)
            if own is None:
                cells.append(fill("comparison-no-cell"))
                continue
            sign = "gain" if own["saved"] > 0 else "loss" if own["saved"] < 0 else "even"
            cells.append(
                fill("comparison-cell", sign=sign, saved=own["text"]["saved"],
                     share=own["text"]["share"])
            )  # fmt: skip
        rows.append(
            fill("comparison-vehicle", badge=badge(vehicle), cells=join(cells),
                 origin=vehicle["origin"]["name"], destination=vehicle["destination"]["name"])
        )  # fmt: skip
    heads = join(fill("comparison-head", title=plan["title"]) for plan in plans)
    unit = plans[0]["cost_unit"]["label"]
    return fill("comparison-vehicles", heads=heads, rows=join(rows), unit=unit)
