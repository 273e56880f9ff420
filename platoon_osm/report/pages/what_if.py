"""What if a figure were another, on one page without a script: charts, tables and sources."""

from __future__ import annotations

import os

from ...atomic_file import whole_file
from ...errors import ScenarioError, brief
from ...output_paths import PAGES
from ...plans.credits import credits_of
from ...plans.what_if import WhatIf, WhatIfRow, WhatIfs
from ...shown_text import fitted
from ..charts.paper import METADATA, drawing
from ..charts.what_if_chart import what_if_chart
from ..charts.what_if_figure import what_if_figure
from ..charts.what_if_texts import change_said, figure_name, figure_unit, proof_said, value_said
from ..document.checks import check_path
from ..document.wording import joined, plan_unit
from ..language.speech import number, say, speaking
from ..markup.fragments import NOTHING, Piece, Tree
from ..markup.quantities import CostUnit, kilometres, litres, percent, true_minus
from ..markup.still_page import PAGE_STYLES, still_page
from .page_pieces import items

__all__ = ["write_what_if"]

MOST_CHANGES = 8
"""Changes of one plan that a cell tells."""


def write_what_if(
    found: WhatIf | WhatIfs,
    path: str | os.PathLike[str],
    *,
    title: str | None = None,
    language: str | None = None,
    clock: int | None = None,
) -> None:
    """Write the figure or the page of other values of a figure, or of several.

    Parameters
    ----------
    found : WhatIf or WhatIfs
        What is shown.
    path : path-like
        Of the file: .png (300 dpi), .svg or .pdf is the figure, .html the page, which has no script
        and asks for nothing.
    title : str or None
        Heads the page.
    language : str or None
        That the texts are in, such as "de"; by default English.
    clock : int or None
        24 or 12 hours; no time of day but those in changes is shown.

    Raises
    ------
    ScenarioError
        Nothing to show, another kind of file, or one that cannot be written.
    """
    studies = (found,) if isinstance(found, WhatIf) else getattr(found, "studies", ())
    if not isinstance(found, WhatIf | WhatIfs) or not studies or not all(map(len, studies)):
        raise ScenarioError(f"what if: {brief(found)} has nothing to show; give one from what_if")
    place = check_path(path)
    kind = place.suffix.lower()
    if kind[1:] not in METADATA and kind not in PAGES:
        raise ScenarioError(f"what if: {place.name}: use .html, .png, .svg or .pdf")
    with speaking(language, clock):
        if kind in PAGES:
            text = _page(studies, title)
            with whole_file(place, suffixes=PAGES) as draft:
                draft.write_text(text, encoding="utf-8", newline="\n")
            return
        with drawing(), whole_file(place, suffixes=(place.suffix,)) as draft:
            figure = what_if_figure(studies)
            figure.savefig(draft, format=kind[1:], dpi=300, metadata=METADATA[kind[1:]])


def _page(studies: tuple[WhatIf, ...], title: str | None) -> str:
    plan = studies[0].plan
    heading = say("what-if.title", titles=fitted(title)) if title else say("what-if.heading")
    body = Piece(
        "what-if",
        {
            "title": heading,
            "subtitle": " \u00b7 ".join(figure_name(one) for one in studies),
            "studies": tuple(_study(one, f"figure-{k}") for k, one in enumerate(studies, 1)),
            "proof": "; ".join(map(fitted, plan.proof.conditions)),
            "figures": _figures(studies[0]),
            "credits": items(credits_of(plan)),
        },
    )
    return still_page(heading, body, styles=(*PAGE_STYLES, "comparison.css", "what_if.css"))


def _study(study: WhatIf, key: str) -> Piece:
    unit = plan_unit(study.plan)
    has_kg = any(row.saved_kg is not None for row in study.values)
    heads = (
        say("what-if.value"), say("what-if.alone"), say("what-if.planned"), say("what-if.saved"),
        say("what-if.share"), say("what-if.together"), say("what-if.fuel"),
        *([say("what-if.co2-saved")] if has_kg else []), say("what-if.worth"),
        say("what-if.proved"),
    )  # fmt: skip
    value = " ".join(filter(None, [value_said(study.asked), figure_unit(study)]))
    return Piece(
        "what-if-study",
        {
            "key": key,
            "name": ", ".join(filter(None, [figure_name(study), figure_unit(study)])),
            "asked": say("what-if.asked", value=value, unit=unit.label),
            "threshold": _threshold(study),
            "chart": what_if_chart(study, key),
            "heads": (
                *(Piece("what-if-head", {"text": text}) for text in heads),
                Piece("what-if-words", {"text": say("what-if.plan")}),
            ),
            "rows": tuple(_row(row, unit, has_kg) for row in study.values),
        },
    )


def _row(row: WhatIfRow, unit: CostUnit, has_kg: bool) -> Piece:
    small = max(unit.decimals, 2)

    def cost(amount: float) -> str:
        return true_minus(number(amount * unit.scale + 0.0, small))

    texts = [
        unit.bare(row.alone), unit.bare(row.joint), cost(row.saved), percent(row.saved_share),
        kilometres(row.platoon_m), litres(row.saved_l),
    ]  # fmt: skip
    if has_kg:
        texts.append(f"{number(row.saved_kg[0], 1)}\u00a0kg" if row.saved_kg else "")
    texts += ["\u2013" if row.worth is None else cost(row.worth), proof_said(row)]
    return Piece(
        "what-if-row",
        {
            "value": value_said(row.value),
            "cells": tuple(Piece("what-if-cell", {"text": text}) for text in texts),
            "told": _told(row),
        },
    )


def _told(row: WhatIfRow) -> str:
    said = [
        say("what-if.lead", who=joined(row.leads), all=joined(row.company))
        if row.company
        else say("what-if.all-alone")
    ]
    if row.changes:
        told = [change_said(one) for one in row.changes[:MOST_CHANGES]]
        rest = ["\u2026"] * (len(row.changes) > MOST_CHANGES)
        said.append(say("what-if.changed", what="; ".join([*told, *rest])))
    else:
        said.append(say("what-if.as-asked"))
    if row.kept_note:
        said.append(say("what-if.not-compared"))
    return " ".join(said)


def _threshold(study: WhatIf) -> str:
    found = study.threshold
    if found is None:
        return ""
    low, high = (
        " ".join(filter(None, [value_said(value), figure_unit(study)]))
        for value in (found.below, found.above)
    )
    if found.is_proved:
        return say("what-if.from-on", value=high) if found.from_above else say(
            "what-if.up-to", value=low
        )  # fmt: skip
    key = "what-if.begins" if found.from_above else "what-if.ceases"
    return say(key, low=low, high=high)


def _figures(study: WhatIf) -> Tree:
    bill = study.plan.bill
    if bill is None:
        return NOTHING
    rows = tuple(
        Piece(
            "about-row",
            {"label": one.name, "text": f"{one.value:.6g} {one.unit} ({fitted(one.source)})"},
        )
        for one in bill.figures
    )
    return Piece("what-if-figures", {"rows": rows})
