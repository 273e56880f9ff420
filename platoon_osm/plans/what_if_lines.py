"""What another figure changes, as lines of text that can be read aloud."""

from __future__ import annotations

import textwrap
from collections.abc import Iterator, Sequence
from itertools import groupby

from .cost_decimals import METRES, cost_decimals
from .text_table import listed, named, table_lines
from .what_if import Threshold, Value, WhatIf, WhatIfRow

__all__ = ["threshold_text", "value_text", "what_if_lines"]

WIDTH = 100
"""Columns of a line."""

MOST_CHANGES = 6
"""Changes of one plan that a text tells."""

NO_UNIT = ("", "share")

HEADER = ("value", "alone", "planned", "saved", "share", "km", "litres", "kg", "worth", "proof")


def value_text(value: Value) -> str:
    """Return a value of a figure as it is read.

    Parameters
    ----------
    value : float or str
        A number or a name.

    Returns
    -------
    str
        A number with the decimals it has, six digits at most.
    """
    return named(value) if isinstance(value, str) else f"{value:.6g}"


def threshold_text(study: WhatIf) -> str:
    """Return where company begins to pay.

    Parameters
    ----------
    study : WhatIf
        Plans for values of a figure.

    Returns
    -------
    str
        "from ... on" only where that is proved, else "between".
    """
    found = study.threshold
    if found is None:
        paying = [bool(row.company) for row in study.values]
        if all(paying):
            return "Company pays at every value."
        if not any(paying):
            return "Company pays at none of these values."
        return ""
    unit = f" {study.figure_unit}" if study.figure_unit not in NO_UNIT else ""
    if found.is_proved:
        way = f"from {_near(found)}{unit} on" if found.from_above else f"up to {_near(found)}{unit}"
        return f"Company pays {way}."
    low, high = value_text(found.below), value_text(found.above)
    verb = "begins" if found.from_above else "ceases"
    return f"Company {verb} to pay between {low} and {high}{unit}."


def _near(found: Threshold) -> str:
    return value_text(found.pays_at)


def what_if_lines(study: WhatIf) -> list[str]:
    """Return a study as a table and sentences.

    Parameters
    ----------
    study : WhatIf
        Plans for values of a figure.

    Returns
    -------
    list of str
        Lines of at most 100 columns, unless names are long.
    """
    unit = f" [{study.figure_unit}]" if study.figure_unit not in NO_UNIT else ""
    money = "km-equivalents" if study.unit == "m" else named(study.unit)
    return [
        f"What if {study.figure}{unit} were another? As asked it is {value_text(study.asked)}.",
        f"Costs in {money}; km in company, litres and kg CO2e (tank to wheel) saved;",
        "worth: what the plan as asked would cost at the value, less the plan made for it.",
        "",
        *table_lines([HEADER, *_cells(study)], range(1, len(HEADER) - 1)),
        "",
        *(
            line
            for text in (*_sentences(study), threshold_text(study), _below(study, money))
            for line in textwrap.wrap(text, WIDTH, subsequent_indent="  ")
        ),
    ]


def _cells(study: WhatIf) -> Iterator[list[str]]:
    scale = METRES if study.unit == "m" else 1.0
    most = max((abs(row.alone) for row in study.values), default=0.0)
    places = cost_decimals(study.unit, most)
    small = max(places, 2)
    for row in study.values:
        saved_kg = "" if row.saved_kg is None else f"{row.saved_kg[0]:,.1f}"
        yield [
            value_text(row.value),
            f"{row.alone / scale:,.{places}f}",
            f"{row.joint / scale:,.{places}f}",
            f"{row.saved / scale:,.{small}f}",
            f"{row.saved_share:.2%}",
            f"{row.platoon_m / 1000:,.0f}",
            f"{row.saved_l:,.1f}",
            saved_kg,
            "?" if row.worth is None else f"{row.worth / scale + 0.0:,.{small}f}",
            _proved(row),
        ]


def _proved(row: WhatIfRow) -> str:
    gap = row.proof.gap
    if row.proof.kind == "bound" and gap is not None:
        return f"within {gap:.2%}"
    return row.proof.kind


def _sentences(study: WhatIf) -> Iterator[str]:
    """Tell who drives with whom, values of one plan together."""
    for _, group in groupby(study.values, _told):
        rows = list(group)
        yield f"{_span(rows)}: {_told(rows[0])}."
    for note in dict.fromkeys(row.kept_note for row in study.values if row.kept_note):
        values = [value_text(row.value) for row in study.values if row.kept_note == note]
        yield f"At {listed(values)} the plan as asked is not compared: {note}."


def _span(rows: Sequence[WhatIfRow]) -> str:
    values = [row.value for row in rows]
    if len(values) == 1:
        return f"At {value_text(values[0])}"
    if isinstance(values[0], str):
        return f"With {listed([value_text(one) for one in values])}"
    return f"From {value_text(values[0])} to {value_text(values[-1])}"


def _told(row: WhatIfRow) -> str:
    followers = [name for name in row.company if name not in row.leads]
    who = "all drive alone"
    if row.company:
        who = f"{listed(row.leads)} lead{'s' if len(row.leads) == 1 else ''}"
        who += f", with {listed(followers)}" if followers else ""
    if not row.changes:
        return f"{who}, as asked"
    told = [one.text for one in row.changes[:MOST_CHANGES]]
    more = len(row.changes) - len(told)
    changed = "; ".join([*told, *([f"and {more} more changes"] if more else [])])
    return f"{who}; otherwise than asked: {changed}"


def _below(study: WhatIf, money: str) -> str:
    """Say why a kept plan may cost less than a new one."""
    least = min((row.worth for row in study.values if row.worth is not None), default=0.0)
    if least >= -0.005 * max(1, len(study.plan.trips)):
        return ""
    why = "each member pays least itself" if study.plan.objective == "member" else "of its bound"
    return f"Where worth is below 0, the plan as asked costs less {money} in all, for {why}."
