"""Several plans side by side on one page: maps, one table, bars. Without any script."""

from __future__ import annotations

import os
from collections.abc import Sequence
from typing import NamedTuple

from ...atomic_file import whole_file
from ...network.road_network import RoadNetwork
from ...output_paths import PAGES
from ...plans.plan import Plan
from ..document.checks import check_path
from ..document.model import Document
from ..document.model_vehicle import Vehicle
from ..document.side_by_side import SIDE_BY_SIDE, Comparison, comparison_of
from ..drawing.palette import CROWD
from ..language.speech import speaking
from ..maps.static_map import small_maps
from ..markup.fragments import NOTHING, Piece, Tree
from ..markup.quantities import gain_or_loss, kilometres, litres, percent, true_minus
from ..markup.still_page import PAGE_STYLES, still_page
from .page_pieces import badge, costs_of, figures, items, status_lines

__all__ = ["write_comparison"]

MOST_BY_VEHICLE = 12
"""Vehicles in all plans together that are compared one by one; of more, only sums are."""

BARS_LEFT, BARS_RIGHT, BAR_ROW = 4.0, 480.0, 26


def write_comparison(
    plans: Sequence[Plan],
    net: RoadNetwork,
    path: str | os.PathLike[str],
    *,
    titles: Sequence[str] | None = None,
    title: str = SIDE_BY_SIDE,
    language: str | None = None,
    clock: int | None = None,
) -> None:
    """Write one page that sets plans of one network side by side; whole or not at all.

    The same plans give the same bytes. The page has no script and asks the network for nothing.

    Parameters
    ----------
    plans : sequence of Plan
        Two or more, of the same network; cases of one scenario, or other parameters.
    net : RoadNetwork
        The network they were made on.
    path : path-like
        Of the file; missing folders are made.
    titles : sequence of str, or None
        Of the plans; by default their cases.
    title : str
        Heads the page.
    language : str or None
        That the texts are in, such as "de"; by default English.
    clock : int or None
        24 or 12 hours; by default as the language has it.

    Raises
    ------
    ScenarioError
        No plans, a plan of another network, or titles of another number.
    """
    path = check_path(path)
    with speaking(language, clock):
        page = _page(comparison_of(plans, net, titles=titles, title=title))
    with whole_file(path, suffixes=PAGES) as draft:
        draft.write_text(page, encoding="utf-8", newline="\n")


def _page(comparison: Comparison) -> str:
    plans = comparison.plans
    cards = [
        Piece(
            "comparison-card",
            {
                "number": number,
                "title": plan.title,
                "map": drawing,
                "figures": figures(plan.totals.figures),
                "subtitle": plan.subtitle,
                "status": status_lines(plan.status),
            },
        )
        for number, (plan, drawing) in enumerate(zip(plans, small_maps(plans), strict=True), 1)
    ]
    unit = plans[0].cost_unit
    notes = [*comparison.remarks, *([unit.note] if unit.note else [])]
    credits = list(dict.fromkeys(line for p in plans for line in p.provenance.credits))
    body = Piece(
        "comparison",
        {
            "icons": Piece("icons"),
            "title": comparison.title,
            "subtitle": comparison.subtitle,
            "keys": _keys(plans),
            "cards": tuple(cards),
            "unit": unit.label,
            "rows": tuple(_row(plan) for plan in plans),
            "notes": items(notes),
            "bars": _bars(plans),
            "by_vehicle": _by_vehicle(plans),
            "about": tuple(
                Piece(
                    "comparison-about",
                    {
                        "title": plan.title,
                        "rows": tuple(
                            Piece("about-row", {"label": label, "text": text})
                            for label, text in plan.provenance.rows
                        ),
                    },
                )
                for plan in plans
            ),
            "credits": items(credits),
        },
    )
    return still_page(comparison.title, body, styles=(*PAGE_STYLES, "comparison.css"))


def _vehicles(plans: Sequence[Document]) -> dict[str, Vehicle]:
    """Return all vehicles of the plans by letter, each as in the first plan that has it."""
    found: dict[str, Vehicle] = {}
    for plan in plans:
        for vehicle in plan.vehicles:
            found.setdefault(vehicle.letter, vehicle)
    return found


def _keys(plans: Sequence[Document]) -> Tree:
    vehicles = _vehicles(plans).values()
    return tuple(
        Piece(
            "comparison-key",
            {
                "badge": badge(vehicle),
                "name": vehicle.name,
                "origin": vehicle.origin.name,
                "destination": vehicle.destination.name,
            },
        )
        for vehicle in list(vehicles)[:MOST_BY_VEHICLE]
    )


def _row(plan: Document) -> Piece:
    totals = plan.totals
    extra = f"{'+' if totals.extra_m > 0 else ''}{kilometres(totals.extra_m)}"
    return Piece(
        "comparison-row",
        {
            "title": plan.title,
            "vehicles": len(plan.vehicles),
            "road": kilometres(totals.platoon_road_m),
            "extra": true_minus(extra),
            "fuel": true_minus(litres(totals.fuel_saved_l)),
            **costs_of(totals.text, totals.solo_cost - totals.joint_cost),
        },
    )


def _bars(plans: Sequence[Document]) -> Tree:
    """Return a bar per plan: the share saved, by vehicle; losses left of the line, hatched."""
    shares = [_shares(plan) for plan in plans]
    most = max(sum(max(own.share, 0.0) for own in one) for one in shares)
    least = -max(sum(max(-own.share, 0.0) for own in one) for one in shares)
    if most - least <= 0:
        return NOTHING
    scale = (BARS_RIGHT - BARS_LEFT) / (most - least)
    zero = BARS_LEFT - least * scale
    rows = []
    for place, (plan, one) in enumerate(zip(plans, shares, strict=True)):
        shapes: list[Piece] = []
        right = left = zero
        for who, colour, share in one:
            width = abs(share) * scale
            start = right if share >= 0 else left - width
            right, left = (right + width, left) if share >= 0 else (right, left - width)
            letter = who if width > 18 else ""
            shapes.append(
                Piece(
                    "comparison-bar" if share >= 0 else "comparison-loss",
                    {
                        "x": f"{start:.1f}",
                        "width": f"{width:.1f}",
                        "colour": colour,
                        "letter": letter,
                        "middle": f"{start + width / 2:.1f}",
                        "text": f"{who}: {true_minus(percent(share))}",
                    },
                )
            )
        rows.append(
            Piece(
                "comparison-bars-row",
                {
                    "y": 22 + (BAR_ROW + 18) * place,
                    "title": plan.title,
                    "shapes": tuple(shapes),
                    "zero": f"{zero:.1f}",
                    "share": plan.totals.text.share,
                },
            )
        )
    return Piece(
        "comparison-bars", {"height": 10 + (BAR_ROW + 18) * len(plans), "rows": tuple(rows)}
    )


class _Share(NamedTuple):
    """What a vehicle, or a crowd, saves."""

    who: str
    colour: str
    share: float


def _shares(plan: Document) -> list[_Share]:
    """Return what each vehicle saves, as a share of all costs alone; of a crowd, all in one."""
    alone = plan.totals.solo_cost or 1.0
    vehicles = plan.vehicles
    if len(vehicles) > MOST_BY_VEHICLE:
        return [_Share(f"{len(vehicles)}\u00d7", CROWD, plan.totals.saving)]
    return [_Share(one.letter, one.colour, one.saved / alone) for one in vehicles]


def _by_vehicle(plans: Sequence[Document]) -> Tree:
    """Return what each vehicle saves under each plan; nothing for a crowd."""
    every = _vehicles(plans)
    if len(every) > MOST_BY_VEHICLE:
        return NOTHING
    rows = []
    for letter, vehicle in every.items():
        cells = []
        for plan in plans:
            own = next((one for one in plan.vehicles if one.letter == letter), None)
            if own is None:
                cells.append(Piece("comparison-no-cell"))
                continue
            cells.append(
                Piece(
                    "comparison-cell",
                    {
                        "sign": gain_or_loss(own.saved),
                        "saved": own.text.saved,
                        "share": own.text.share,
                    },
                )
            )
        rows.append(
            Piece(
                "comparison-vehicle",
                {
                    "badge": badge(vehicle),
                    "cells": tuple(cells),
                    "origin": vehicle.origin.name,
                    "destination": vehicle.destination.name,
                },
            )
        )
    heads = tuple(Piece("comparison-head", {"title": plan.title}) for plan in plans)
    unit = plans[0].cost_unit.label
    return Piece("comparison-vehicles", {"heads": heads, "rows": tuple(rows), "unit": unit})
