"""The comparison as tables for people: the report and docs/paper.md show the same ones.

A table tells one thing under all readings: a reading a line, and side by side the methods, A* in
both readings of its closed set among them.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ..planning.routers import Method
from .comparison import PRINTED, Row, network_label, plain
from .measures import COVERED, INVOLVEMENTS, RESAMPLES, TOTALS, Estimate
from .monte_carlo import StudyResult

__all__ = ["CALLED", "MIXED", "ShownTable", "markdown", "shown_tables"]

Floats = NDArray[np.float64]

READING = ("", "vehicles"), ("", "mixing")
NAMED = {"members": "members", "system": "with master"}
CALLED = {
    "dijkstra": "Dijkstra",
    "astar": "A*, nodes opened again",
    "astar-closed-once": "A*, each node once",
}
MIXED = {"printed": "as printed", "gain": "as gains"}

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

    def table(
        title: str, caption: str, columns: Sequence[tuple[Head, tuple[str, str, str]]]
    ) -> ShownTable:
        lines = tuple(
            (network, MIXED[mixing], *(
                at[number, network, mixing, counted, method]  # type: ignore[index]
                for _, (number, counted, method) in columns
            ))
            for network, mixing in readings
        )  # fmt: skip
        return ShownTable(title, caption, (*READING, *(name for name, _ in columns)), lines, 2)

    tables = [
        table(
            f"{title} [%]",
            f"The paper prints {PRINTED[number].value[0]:g} %, for Dijkstra.",
            [
                ((CALLED[method], NAMED[total]), (number, total, method))
                for method in methods
                for total in TOTALS
            ],
        )
        for number, title in SAVINGS
    ]
    printed = " and ".join(
        f"{PRINTED[number].value[0]:g} % by {called}"
        for number, called in (("dijkstra", "Dijkstra"), ("astar", "A*"))
        if any(_counts(method) == number for method in methods)
    )
    tables += [
        table(
            "Members involved, mean over the grid [%]",
            f"The paper prints {printed}, and does not say who counts.",
            [
                ((CALLED[method], name), (_counts(method), name, method))
                for method in methods
                for name in INVOLVEMENTS
            ],
        ),
        table(
            f"Mean cost of a vehicle, {CALLED[methods[0]]} [km]",
            "The paper's surfaces span about 1150 to 1400 km. Least and greatest are those over "
            "the grid.",
            [
                ((NAMED[total], name), (number, total, methods[0]))
                for total in TOTALS
                for name, number in COSTS
            ],
        ),
    ]
    if len(results[0].study.terms) > 1:
        tables += [_sums(rows), _ranges(rows)]
    return [*tables, *_draws(results)]


SAVINGS = (
    ("point", "Saving at tau = 100 %, xi = 18 %"),
    ("mean", "Mean saving over the grid of tau and xi"),
)
COSTS = (("alone", "alone"), ("joint, least", "joint low"), ("joint, greatest", "joint high"))


def _counts(method: str) -> str:
    """Return which printed share of involved members a method is compared with."""
    return "dijkstra" if method == "dijkstra" else "astar"


def _sums(rows: Sequence[Row]) -> ShownTable:
    """Return the printed numbers under each choice of terms, at the first placing."""
    place, method = rows[0].network, rows[0].method
    at = {(r.number, r.terms, r.mixing, r.counted): _shown(r)
          for r in rows if r.network == place and r.method == method}  # fmt: skip
    columns: list[tuple[Head, tuple[str, str]]] = [
        *((("cost of a vehicle [km]", name), (number, "members")) for name, number in COSTS),
        (("saving [%]", "at 100 %, 18 % (paper 8)"), ("point", "members")),
        (("saving [%]", "mean (paper 14)"), ("mean", "members")),
        *((("members involved [%]", name), (_counts(method), name)) for name in INVOLVEMENTS),
    ]
    lines = tuple(
        (_added(terms), MIXED[mixing], *(
            at[number, terms, mixing, counted] for _, (number, counted) in columns
        ))
        for terms, mixing in dict.fromkeys((r.terms, r.mixing) for r in rows)
    )  # fmt: skip
    return ShownTable(
        "What eq. 11 and 12 add up",
        f"{CALLED[method]}, costs of the members, vehicles at {place}. The paper's surfaces span "
        "about 1150 to 1400 km.",
        (("", "terms"), ("", "mixing"), *(name for name, _ in columns)),
        lines,
        2,
    )


def _added(terms: str) -> str:
    """Return a sum of terms with room around its signs."""
    return terms.replace("+", " + ")


def _ranges(rows: Sequence[Row]) -> ShownTable:
    """Return for each choice of terms between what values each printed number lies here."""
    names = {number: p for number, p in PRINTED.items() if any(r.number == number for r in rows)}
    lines = []
    for terms in dict.fromkeys(r.terms for r in rows):
        line = [_added(terms)]
        for number in names:
            # The paper's savings and surfaces are Dijkstra's.
            of = [r for r in rows if r.terms == terms and r.number == number
                  and (r.method == rows[0].method or number == "astar")]  # fmt: skip
            low, high = min(r.ours.value for r in of), max(r.ours.value for r in of)
            digits = 0 if names[number].unit == "km" else 1
            good = sum(r.agrees() for r in of)
            line.append(f"{plain(low, digits)} to {plain(high, digits)} ({good} of {len(of)})")
        lines.append(tuple(line))
    heads = (
        ("", f"{p.label} [{p.unit}], paper {' to '.join(f'{v:g}' for v in p.value)}")
        for p in names.values()
    )
    return ShownTable(
        "The printed numbers over all readings",
        "From the least to the greatest over all placings, mixings and ways to count, by what "
        "eq. 11 and 12 add up. In brackets how many 95 % intervals hold the printed number, or "
        "how many values lie in the printed range.",
        (("", "terms"), *heads),
        tuple(lines),
    )


def _draws(results: Sequence[StudyResult]) -> list[ShownTable]:
    """Return what was drawn, and how far A* is from the optimum on the same draws."""
    heads = [
        ("", "vehicles"), ("", "networks"), ("drawn again", "not connected"),
        ("drawn again", "no destination"), ("", "mean route [km]"),
    ]  # fmt: skip
    rows = tuple(
        (
            network_label(result), f"{len(result.master)}",
            *(f"{count}" for count in result.redraws.sum(axis=0)),
            f"{result.optimum.mean() / result.study.alone_factor / 1000:.0f}",
        )
        for result in results
    )  # fmt: skip
    drawn = ShownTable("What was drawn", "Networks and routes alone.", tuple(heads), rows)
    common = [m for m in results[0].study.methods if all(m in r.study.methods for r in results)]
    rules = [method for method in common if method != "dijkstra"]
    if not rules:
        return [drawn]
    optimum = "dijkstra" in common
    against = [("", "vehicles")]
    for method in rules:
        against += [(CALLED[method], "alone above the optimum"), (CALLED[method], "worst vehicle")]
        if optimum:
            against.append((CALLED[method], "joint plan above Dijkstra's"))
    if len(rules) == 2:
        against.append(("both", "routes alone that differ"))
    against.append(("both", "heuristic over the true cost"))
    lines = tuple((network_label(result), *_against(result, rules, optimum)) for result in results)
    return [
        drawn,
        ShownTable(
            "The inflated A* against the optimum [%]",
            "On the same draws. The heuristic is the median, with 10 % to 90 % in brackets; it may "
            "promise no more than 100.",
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
        line.append(f"{100 * (alone[method] / result.optimum - 1).max():.0f}")
        if optimum:
            line.append(_told(_excess(joint(method), joint("dijkstra")), 1))
    if len(rules) == 2:
        differ = ~np.isclose(alone[rules[0]], alone[rules[1]], rtol=1e-9, atol=0)
        line.append(f"{100 * differ.mean():.0f}")
    low, middle, high = np.percentile(result.overestimate, [10, 50, 90])
    return [*line, f"{middle:.0f} [{low:.0f}, {high:.0f}]"]


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
    value, low, high = (plain(number, digits) for number in (ours.value, ours.low, ours.high))
    return f"{value} [{low}, {high}]"


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
