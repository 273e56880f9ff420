"""Several plans on one page, those of the same trips compared: maps, tables, bars; no script."""

from __future__ import annotations

import os
from collections.abc import Sequence
from typing import NamedTuple

from ...atomic_file import whole_file
from ...network.road_network import RoadNetwork
from ...output_paths import PAGES
from ...plans.plan import Plan
from ..document.alike_trips import AlikePlans
from ..document.checks import check_path
from ..document.model import Document
from ..document.side_by_side import Comparison, comparison_of
from ..document.wording import joined
from ..drawing.palette import CROWD
from ..language.speech import say, speaking
from ..maps.pause_icons import pause_icons
from ..maps.static_map import small_maps
from ..markup.fragments import NOTHING, Piece, Tree
from ..markup.quantities import gain_or_loss, percent, true_minus
from ..markup.still_page import PAGE_STYLES, still_page
from .comparison_table import day_table, sums_table
from .cost_table import cost_table
from .page_pieces import badge, figures, items, late_mark, status_lines, unit_note

__all__ = ["write_comparison"]

MOST_BY_VEHICLE = 12
"""Vehicles in all plans together that are compared one by one; of more, only sums are."""

MOST_BACKGROUND = 16_000
"""Letters of the network under the maps of one of several sets of trips."""

BARS_LEFT, BARS_RIGHT, BAR_ROW, BAR_TITLE = 4.0, 474.0, 26, 26


def write_comparison(
    plans: Sequence[Plan],
    net: RoadNetwork,
    path: str | os.PathLike[str],
    *,
    titles: Sequence[str] | None = None,
    title: str | None = None,
    baseline: int | str = 0,
    language: str | None = None,
    clock: int | None = None,
) -> None:
    """Write one page that sets plans of one network side by side; whole or not at all.

    Plans of the same trips are compared; those of other trips stand apart, each with its own
    vehicles, which the page says. The same plans give the same bytes. The page has no script and
    asks the network for nothing.

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
    title : str or None
        Heads the page; by default the titles of all plans.
    baseline : int or str
        The position or the title of the plan that those of the same trips are set against.
    language : str or None
        That the texts are in, such as "de"; by default English.
    clock : int or None
        24 or 12 hours; by default as the language has it.

    Raises
    ------
    ScenarioError
        No plans, a plan of another network, titles of another number, or no such baseline.
    """
    path = check_path(path)
    with speaking(language, clock):
        page = _page(comparison_of(plans, net, titles=titles, title=title, baseline=baseline))
    with whole_file(path, suffixes=PAGES) as draft:
        draft.write_text(page, encoding="utf-8", newline="\n")


def _page(comparison: Comparison) -> str:
    plans = comparison.plans
    credits = list(dict.fromkeys(line for p in plans for line in p.provenance.credits))
    several = len(comparison.sets) > 1
    body = Piece(
        "comparison",
        {
            "icons": Piece("icons", {"more": pause_icons(plans)}),
            "title": comparison.title,
            "subtitle": comparison.subtitle,
            "remarks": tuple(
                Piece("status", {"kind": "apart", "text": text}) for text in comparison.remarks
            ),
            "sets": tuple(
                _set(found, plans, rank if several else 0)
                for rank, found in enumerate(comparison.sets, 1)
            ),
            "about": tuple(
                Piece(
                    "comparison-about",
                    {
                        "title": plan.title,
                        "rows": tuple(
                            Piece("about-row", {"label": label, "text": text})
                            for label, text in plan.provenance.rows
                        ),
                        "proof": plan.provenance.proof,
                    },
                )
                for plan in plans
            ),
            "credits": items(credits),
        },
    )
    return still_page(comparison.title, body, styles=(*PAGE_STYLES, "comparison.css"))


def _set(found: AlikePlans, plans: tuple[Document, ...], rank: int) -> Piece:
    """Return plans of the same trips; of one alone its vehicles, for it is compared with none."""
    shown = tuple(plans[place] for place in found.plans)
    key = f"-{rank}" if rank else ""
    # Each set of trips has a background of its own, so their sizes add up.
    maps = small_maps(shown, key, MOST_BACKGROUND if rank else None)
    cards = tuple(
        Piece(
            "comparison-card",
            {
                "number": place + 1,
                "title": plan.title,
                "map": drawing,
                "figures": figures(plan.totals.figures),
                "subtitle": plan.subtitle,
                "status": status_lines(plan.status),
            },
        )
        for place, plan, drawing in zip(found.plans, shown, maps, strict=True)
    )
    titles = joined([plan.title for plan in shown])
    heading = say("compare.set", number=rank, titles=titles) if rank else say("compare.plans")
    unit = shown[0].cost_unit
    alone = len(shown) == 1
    return Piece(
        "comparison-set",
        {
            "key": key,
            "heading": heading,
            "unseen": "" if rank else " unseen",
            "keys": NOTHING if alone else _keys(shown[0]),
            "cards": cards,
            "single": " single" if alone else "",
            "vehicles": _own_vehicles(shown[0], key) if alone else NOTHING,
            "compared": NOTHING
            if alone
            else Piece(
                "comparison-compared",
                {
                    "sums": sums_table(found, plans, key),
                    "day": day_table(found, plans, key),
                    "notes": items([*found.remarks, *([unit.note] if unit.note else [])]),
                    "bars": _bars(shown, key),
                    "by_vehicle": _by_vehicle(shown, key),
                },
            ),
        },
    )


def _own_vehicles(plan: Document, key: str) -> Piece:
    """Return what the vehicles of a plan cost that is compared with none."""
    every = range(len(plan.vehicles))
    table = cost_table(plan, every, say("table.all"), plan.totals.text, say("table.costs"))
    return Piece(
        "comparison-own",
        {"key": key, "unit": plan.cost_unit.label, "table": table, "unit_note": unit_note(plan)},
    )


def _keys(plan: Document) -> Tree:
    """Return the legend of plans of the same trips: the vehicles, unless they are a crowd."""
    if len(plan.vehicles) > MOST_BY_VEHICLE:
        return NOTHING
    keys = tuple(
        Piece(
            "comparison-key",
            {
                "badge": badge(vehicle),
                "name": vehicle.name,
                "origin": vehicle.origin.brief,
                "destination": vehicle.destination.brief,
            },
        )
        for vehicle in plan.vehicles
    )
    return Piece("comparison-keys", {"keys": keys})


def _bars(plans: Sequence[Document], key: str) -> Tree:
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
                    "y": 22 + (BAR_ROW + BAR_TITLE) * place,
                    "title": plan.title,
                    "shapes": tuple(shapes),
                    "zero": f"{zero:.1f}",
                    "share": plan.totals.text.share,
                },
            )
        )
    return Piece(
        "comparison-bars",
        {"key": key, "height": 6 + (BAR_ROW + BAR_TITLE) * len(plans), "rows": tuple(rows)},
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


def _by_vehicle(plans: Sequence[Document], key: str) -> Tree:
    """Return what each vehicle saves under each plan; nothing for a crowd."""
    if len(plans[0].vehicles) > MOST_BY_VEHICLE:
        return NOTHING
    titles = _what_differs([plan.title for plan in plans])
    rows = []
    for vehicle in plans[0].vehicles:
        cells = []
        for plan, title in zip(plans, titles, strict=True):
            own = next(one for one in plan.vehicles if one.letter == vehicle.letter)
            cells.append(
                Piece(
                    "comparison-saved",
                    {
                        "sign": "even"
                        if own.is_late and own.saved > 0
                        else gain_or_loss(own.saved),
                        "saved": own.text.saved,
                        "share": own.text.share,
                        "late": late_mark(own),
                        "label": title,
                    },
                )
            )
        rows.append(
            Piece(
                "comparison-vehicle",
                {
                    "badge": badge(vehicle),
                    "cells": tuple(cells),
                    "name": vehicle.name,
                    "origin": vehicle.origin.brief,
                    "destination": vehicle.destination.brief,
                },
            )
        )
    heads = tuple(Piece("comparison-head", {"title": title}) for title in titles)
    unit = plans[0].cost_unit.label
    return Piece(
        "comparison-vehicles", {"key": key, "heads": heads, "rows": tuple(rows), "unit": unit}
    )


def _what_differs(titles: Sequence[str]) -> list[str]:
    """Return titles without the words before a comma with which all begin, or as they are."""
    parts = [title.split(", ") for title in titles]
    same = 0
    while all(len(own) > same + 1 and own[same] == parts[0][same] for own in parts):
        same += 1
    return [", ".join(own[same:]) for own in parts]
