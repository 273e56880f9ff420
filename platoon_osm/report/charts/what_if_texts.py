"""What a study of other figures says in its charts and tables, in the language that is spoken."""

from __future__ import annotations

from collections.abc import Sequence

from ...plans.plan_change import Change
from ...plans.what_if import Value, WhatIf, WhatIfRow
from ...shown_text import shortened
from ..document.wording import joined
from ..language.speech import number, say
from ..markup.quantities import percent

__all__ = [
    "change_said",
    "figure_name",
    "figure_unit",
    "in_order",
    "new_plans",
    "proof_said",
    "value_said",
]

FIGURES = {
    "fuel_per_l": "what-if.price",
    "driver_per_h": "what-if.wage",
    "toll": "what-if.toll",
    "co2_per_t": "what-if.co2",
    "waiting_per_h": "what-if.waiting",
    "positions": "what-if.positions",
    "task_relief": "what-if.relief",
}
"""Figures that have a name in the catalogue."""

CHANGES = {
    "leads": "what-if.leads",
    "joins": "what-if.joins",
    "alone": "what-if.stays-alone",
    "company": "what-if.company",
    "merge": "what-if.merge",
    "separation": "what-if.separation",
    "road": "what-if.road",
    "leaves": "what-if.leaves",
}

NO_UNIT = ("", "share")


def figure_name(study: WhatIf) -> str:
    """Return what a figure is called.

    Parameters
    ----------
    study : WhatIf
        Of the figure.

    Returns
    -------
    str
        In words, or the name of the parameter where there are none.
    """
    key = FIGURES.get(study.figure)
    return say(key) if key else study.figure


def figure_unit(study: WhatIf) -> str:
    """Return the unit of a figure.

    Parameters
    ----------
    study : WhatIf
        Of the figure.

    Returns
    -------
    str
        Empty if it has none.
    """
    return "" if study.figure_unit in NO_UNIT else study.figure_unit


def value_said(value: Value) -> str:
    """Return a value of a figure.

    Parameters
    ----------
    value : float or str
        A number or a name.

    Returns
    -------
    str
        A number in the form of the language, with the decimals it has, six digits at most.
    """
    if isinstance(value, str):
        return shortened(value, 24)
    text = f"{value:.6g}"
    return text if "e" in text else number(value, len(text.partition(".")[2]))


def change_said(change: Change) -> str:
    """Return what is otherwise than in the plan as asked.

    Parameters
    ----------
    change : Change
        One thing.

    Returns
    -------
    str
        A part of a sentence.
    """
    fields = {
        "who": shortened(change.vehicle, 40),
        "now": joined([shortened(one, 40) for one in change.now]),
        "before": joined([shortened(one, 40) for one in change.before]),
    }
    return say(CHANGES[change.kind], **fields)


def proof_said(row: WhatIfRow) -> str:
    """Return what is proved of a plan, in short.

    Parameters
    ----------
    row : WhatIfRow
        Of the plan.

    Returns
    -------
    str
        For a cell of a table.
    """
    gap = row.proof.gap
    if row.proof.kind == "exact":
        return say("what-if.exact")
    return say("what-if.heuristic") if gap is None else say("what-if.within", share=percent(gap))


def in_order(study: WhatIf) -> list[WhatIfRow]:
    """Return the rows of a study as a chart has them.

    Parameters
    ----------
    study : WhatIf
        Of a figure.

    Returns
    -------
    list of WhatIfRow
        By value; names in the order asked for.
    """
    if isinstance(study.asked, str):
        return list(study.values)
    return sorted(study.values, key=lambda row: float(row.value))


def new_plans(rows: Sequence[WhatIfRow]) -> list[int]:
    """Return which values have another plan than the value before.

    Parameters
    ----------
    rows : sequence of WhatIfRow
        In the order of a chart.

    Returns
    -------
    list of int
        Positions; never the first.
    """
    return [at for at in range(1, len(rows)) if rows[at].changes != rows[at - 1].changes]
