"""The comparison as tables for people: the report and docs/paper.md show the same ones.

A table tells one thing under all readings: a reading a line, and side by side the methods, A* in
both readings of its closed set among them.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ..planning.routers import Method
from ..report.language.speech import say
from .comparison import PRINTED, Row, labels, placing
from .measures import COVERED, INVOLVEMENTS, RESAMPLES, TOTALS, Estimate
from .monte_carlo import StudyResult
from .wording import called, figure, joined, mixed, percent, summed, whose

__all__ = ["ShownTable", "markdown", "shown_tables"]

Floats = NDArray[np.float64]

Head = tuple[str, str]


@dataclass(frozen=True, slots=True)
class ShownTable:
    """A title, what is in it, and rows of text.

    Attributes
    ----------
    title : str
        In a few words.
    caption : str
        What is in it and what the paper prints, in sentences.
    heads : tuple of (str, str)
        Of the columns: what several have in common, or nothing, and what is its own.
    rows : tuple of tuple of str
        As many texts each as there are columns; "value [low, high]" is a number with its interval.
    labels : int
        How many columns come first that say whose numbers they are.
    """

    title: str
    caption: str
    heads: tuple[Head, ...]
    rows: tuple[tuple[str, ...], ...]
    labels: int = 1

    @property
    def header(self) -> tuple[str, ...]:
        """Head of each column in one line."""
        return tuple(f"{group}: {own}" if group else own for group, own in self.heads)


def shown_tables(results: Sequence[StudyResult], rows: Sequence[Row]) -> list[ShownTable]:
    """Return every printed number beside ours, one reading a line.

    Parameters
    ----------
    results : sequence of StudyResult
        One for each placing of the vehicles.
    rows : sequence of Row
        Of `compare`.

    Returns
    -------
    list of ShownTable
        In the order in which they are shown.
    """
    first = results[0].study.terms[0]
    at = {(r.number, r.network, r.mixing, r.counted, r.method): _shown(r)
          for r in rows if r.terms == first}  # fmt: skip
    readings = list(dict.fromkeys((r.network, r.mixing) for r in rows))
    methods = list(dict.fromkeys(r.method for r in rows))
    placed = labels(results)
    reading = ("", say("study-tables.vehicles")), ("", say("study-tables.mixing"))

    def table(
        title: str, caption: str, columns: Sequence[tuple[Head, tuple[str, str, str]]]
    ) -> ShownTable:
        lines = tuple(
            (placed[network], mixed(mixing), *(
                # A setting and a column together make a key.
                at[number, network, mixing, counted, method]  # type: ignore[index]
                for _, (number, counted, method) in columns
            ))
            for network, mixing in readings
        )  # fmt: skip
        return ShownTable(title, caption, (*reading, *(name for name, _ in columns)), lines, 2)

    tables = [
        table(
            say(title),
            say("study-tables.paper-dijkstra", share=percent(PRINTED[number].value[0])),
            [
                ((called(method), whose(total)), (number, total, method))
                for method in methods
                for total in TOTALS
            ],
        )
        for number, title in SAVINGS
    ]
    printed = joined("study-tables.and", (
        say(by, share=percent(PRINTED[number].value[0]))
        for number, by in BY.items()
        if any(_counts(method) == number for method in methods)
    ))  # fmt: skip
    tables += [
        table(
            say("study-tables.involved"),
            say("study-tables.paper-involved", shares=printed),
            [
                ((called(method), whose(name)), (_counts(method), name, method))
                for method in methods
                for name in INVOLVEMENTS
            ],
        ),
        table(
            say("study-tables.cost", method=called(methods[0])),
            say("study-tables.cost-caption", **_span()),
            [
                ((whose(total), say(name)), (number, total, methods[0]))
                for total in TOTALS
                for name, number in COSTS
            ],
        ),
    ]
    if len(results[0].study.terms) > 1:
        tables += [_sums(rows, placed), _ranges(rows)]
    return [*tables, *_draws(results)]


SAVINGS = (
    ("point", "study-tables.saving-point"),
    ("mean", "study-tables.saving-mean"),
)
COSTS = (
    ("study-tables.alone", "alone"),
    ("study-tables.joint-least", "joint low"),
    ("study-tables.joint-greatest", "joint high"),
)
BY = {"dijkstra": "study-tables.by-dijkstra", "astar": "study-tables.by-astar"}


def _span() -> dict[str, str]:
    """Return between which costs the paper's surfaces lie."""
    low, high = map(figure, PRINTED["alone"].value)
    return {"low": low, "high": high}


def _counts(method: str) -> str:
    """Return which printed share of involved members a method is compared with."""
    return "dijkstra" if method == "dijkstra" else "astar"


def _sums(rows: Sequence[Row], placed: Mapping[str, str]) -> ShownTable:
    """Return the printed numbers under each choice of terms, at the first placing."""
    place, method = rows[0].network, rows[0].method
    at = {(r.number, r.terms, r.mixing, r.counted): _shown(r)
          for r in rows if r.network == place and r.method == method}  # fmt: skip
    columns: list[tuple[Head, tuple[str, str]]] = [
        *(
            ((say("study-tables.of-cost"), say(name)), (number, "members"))
            for name, number in COSTS
        ),
        ((say("study-tables.of-saving"), say("study-tables.at-point")), ("point", "members")),
        ((say("study-tables.of-saving"), say("study-tables.at-all")), ("mean", "members")),
        *(
            ((say("study-tables.of-involved"), whose(name)), (_counts(method), name))
            for name in INVOLVEMENTS
        ),
    ]
    lines = tuple(
        (summed(terms), mixed(mixing), *(
            at[number, terms, mixing, counted] for _, (number, counted) in columns
        ))
        for terms, mixing in dict.fromkeys((r.terms, r.mixing) for r in rows)
    )  # fmt: skip
    return ShownTable(
        say("study-tables.sums"),
        say("study-tables.sums-caption", method=called(method), place=placed[place], **_span()),
        (
            ("", say("study-tables.terms")),
            ("", say("study-tables.mixing")),
            *(name for name, _ in columns),
        ),
        lines,
        2,
    )


def _ranges(rows: Sequence[Row]) -> ShownTable:
    """Return for each choice of terms between what values each printed number lies here."""
    names = {number: p for number, p in PRINTED.items() if any(r.number == number for r in rows)}
    lines = []
    for terms in dict.fromkeys(r.terms for r in rows):
        line = [summed(terms)]
        for number in names:
            # The paper's savings and surfaces are Dijkstra's.
            of = [r for r in rows if r.terms == terms and r.number == number
                  and (r.method == rows[0].method or number == "astar")]  # fmt: skip
            low, high = min(r.ours.value for r in of), max(r.ours.value for r in of)
            digits = 0 if names[number].unit == "km" else 1
            good = sum(r.agrees() for r in of)
            line.append(
                say(
                    "study-tables.range",
                    low=figure(low, digits),
                    high=figure(high, digits),
                    good=figure(good),
                    all=figure(len(of)),
                )
            )
        lines.append(tuple(line))
    heads = (
        (
            "",
            say(
                "study-tables.paper",
                label=p.label,
                unit=p.unit,
                value=joined("study.to", map(figure, p.value)),
            ),
        )
        for p in names.values()
    )
    return ShownTable(
        say("study-tables.ranges"),
        say("study-tables.ranges-caption"),
        (("", say("study-tables.terms")), *heads),
        tuple(lines),
    )


def _draws(results: Sequence[StudyResult]) -> list[ShownTable]:
    """Return what was drawn, and how far A* is from the optimum on the same draws."""
    heads = [
        ("", say("study-tables.vehicles")), ("", say("study-tables.networks")),
        (say("study-tables.again"), say("study-tables.not-connected")),
        (say("study-tables.again"), say("study-tables.no-destination")),
        ("", say("study-tables.mean-route")),
    ]  # fmt: skip
    rows = tuple(
        (
            placing(result), figure(len(result.master)),
            *(figure(int(count)) for count in result.redraws.sum(axis=0)),
            figure(result.optimum.mean() / result.study.alone_factor / 1000, 0),
        )
        for result in results
    )  # fmt: skip
    drawn = ShownTable(
        say("study-tables.drawn"), say("study-tables.drawn-caption"), tuple(heads), rows
    )
    common = [m for m in results[0].study.methods if all(m in r.study.methods for r in results)]
    rules = [method for method in common if method != "dijkstra"]
    if not rules:
        return [drawn]
    optimum = "dijkstra" in common
    against = [("", say("study-tables.vehicles"))]
    for method in rules:
        against += [
            (called(method), say("study-tables.above")),
            (called(method), say("study-tables.worst")),
        ]
        if optimum:
            against.append((called(method), say("study-tables.joint-above")))
    if len(rules) == 2:
        against.append((say("study-tables.both"), say("study-tables.differ")))
    against.append((say("study-tables.both"), say("study-tables.heuristic")))
    lines = tuple((placing(result), *_against(result, rules, optimum)) for result in results)
    return [
        drawn,
        ShownTable(
            say("study-tables.inflated"),
            say("study-tables.inflated-caption"),
            tuple(against),
            lines,
        ),
    ]


def _against(result: StudyResult, rules: Sequence[Method], optimum: bool) -> list[str]:
    """Return how much dearer A* is than the optimum, by each of its rules [%]."""
    grid = int(np.prod(result.study.grid_shape))

    def joint(method: Method) -> Floats:
        k = result.study.methods.index(method)
        total: Floats = result.joint(k, 0)[..., :grid].sum(axis=(1, 2))
        return total

    alone = {m: result.solo_cost[:, k] for k, m in enumerate(result.study.methods) if m in rules}
    line = []
    for method in rules:
        line.append(_told(_excess(alone[method].sum(axis=1), result.optimum.sum(axis=1)), 1))
        line.append(figure(100 * (alone[method] / result.optimum - 1).max(), 0))
        if optimum:
            line.append(_told(_excess(joint(method), joint("dijkstra")), 1))
    if len(rules) == 2:
        differ = ~np.isclose(alone[rules[0]], alone[rules[1]], rtol=1e-9, atol=0)
        line.append(figure(100 * differ.mean(), 0))
    low, middle, high = np.percentile(result.overestimate, [10, 50, 90])
    return [*line, _told(Estimate(middle, low, high), 0)]


def _excess(above: Floats, below: Floats) -> Estimate:
    """Return 100 (sum above / sum below - 1) with its bootstrap interval over networks (R,)."""
    runs = len(above)
    draws = np.random.default_rng(0).multinomial(runs, np.full(runs, 1 / runs), RESAMPLES)
    values = 100 * ((draws @ above) / (draws @ below) - 1)
    low, high = np.percentile(values, COVERED)
    return Estimate(100 * float(above.sum() / below.sum() - 1), float(low), float(high))


def _shown(row: Row) -> str:
    """Return a number with its interval; all of one unit have as many decimals."""
    return _told(row.ours, 0 if PRINTED[row.number].unit == "km" else 1)


def _told(ours: Estimate, digits: int) -> str:
    value, low, high = (figure(number, digits) for number in (ours.value, ours.low, ours.high))
    return say("study-tables.interval", value=value, low=low, high=high)


def markdown(tables: Sequence[ShownTable], paragraph: str, how: str) -> str:
    """Return the tables and the paragraph as Markdown.

    Parameters
    ----------
    tables : sequence of ShownTable
        Of `shown_tables`.
    paragraph : str
        What they come to.
    how : str
        How they were made, for the first line.

    Returns
    -------
    str
        Without a line break at its end.
    """
    lines = [how, ""]
    for table in tables:
        lines += [f"**{table.title}.** {table.caption}", ""]
        ruled = tuple("---" if k < table.labels else "--:" for k in range(len(table.heads)))
        for row in (table.header, ruled, *table.rows):
            lines.append("| " + " | ".join(cell.replace("|", "\\|") for cell in row) + " |")
        lines.append("")
    return "\n".join([*lines, paragraph])
