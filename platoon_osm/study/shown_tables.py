"""The comparison as tables for people: the report and docs/paper.md show the same ones."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from .comparison import PRINTED, Row, network_label, plain
from .measures import COVERED, INVOLVEMENTS, RESAMPLES, TOTALS, Estimate
from .monte_carlo import StudyResult

__all__ = ["CALLED", "ShownTable", "markdown", "shown_tables"]

Floats = NDArray[np.float64]

READING = ("vehicles", "mixing")
NAMED = {"members": "members", "system": "with master"}
CALLED = {
    "dijkstra": "Dijkstra",
    "astar": "the inflated A*",
    "astar-closed-once": "the inflated A*, each node once",
}


@dataclass(frozen=True, slots=True)
class ShownTable:
    """A caption, a header, and rows of text.

    Attributes
    ----------
    caption : str
        What is in it.
    header : tuple of str
        Names of the columns.
    rows : tuple of tuple of str
        As many texts each as there are columns.
    """

    caption: str
    header: tuple[str, ...]
    rows: tuple[tuple[str, ...], ...]


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
    at = {(r.number, r.network, r.mixing, r.counted, r.method): r.ours
          for r in rows if r.terms == first}  # fmt: skip
    readings = list(dict.fromkeys((r.network, r.mixing) for r in rows))
    methods = list(dict.fromkeys(r.method for r in rows))

    def table(caption: str, columns: list[tuple[str, tuple[str, str, str]]]) -> ShownTable:
        lines = tuple(
            (network, mixing, *(
                _shown(at[number, network, mixing, counted, method])  # type: ignore[index]
                for _, (number, counted, method) in columns
            ))
            for network, mixing in readings
        )  # fmt: skip
        return ShownTable(caption, (*READING, *(name for name, _ in columns)), lines)

    tables = [
        table(
            f"Savings by {CALLED[method]} [%]. The paper prints 8 % at (100 %, 18 %) and 14 % on "
            "average.",
            [
                (f"{short}: {NAMED[total]}", (number, total, method))
                for number, short in (("point", "paper 8 %"), ("mean", "paper 14 %"))
                for total in TOTALS
            ],
        )
        for method in methods
    ]
    for method in methods:
        number = "dijkstra" if method == "dijkstra" else "astar"
        tables.append(table(
            f"Members involved by {CALLED[method]}, mean over the grid [%]. The paper prints "
            f"{PRINTED[number].value[0]:g} %. Merging and separating truly: driving roads alone "
            "before and after.",
            [(name, (number, name, method)) for name in INVOLVEMENTS],
        ))  # fmt: skip
    tables += [
        table(
            f"Mean cost of a vehicle, {NAMED[total]}, {CALLED[methods[0]]} [km]. The paper's "
            "surfaces span about 1150 to 1400 km.",
            [(name, (number, total, methods[0])) for name, number in COSTS],
        )
        for total in TOTALS
    ]
    if len(results[0].study.terms) > 1:
        tables += [_sums(rows), _ranges(rows)]
    tables.append(_draws(results))
    return tables


COSTS = (("alone", "alone"), ("joint, least", "joint low"), ("joint, greatest", "joint high"))


def _sums(rows: Sequence[Row]) -> ShownTable:
    """Return the printed numbers under each choice of terms, at the first placing."""
    place, method = rows[0].network, rows[0].method
    at = {(r.number, r.terms, r.mixing, r.counted): r.ours
          for r in rows if r.network == place and r.method == method}  # fmt: skip
    columns = [
        *((f"{name} [km]", (number, "members")) for name, number in COSTS),
        ("saving, paper 8 %", ("point", "members")), ("mean, paper 14 %", ("mean", "members")),
        *((f"{name} [%]", (method if method == "dijkstra" else "astar", name))
          for name in INVOLVEMENTS),
    ]  # fmt: skip
    lines = tuple(
        (terms, mixing, *(
            _shown(at[number, terms, mixing, counted]) for _, (number, counted) in columns
        ))
        for terms, mixing in dict.fromkeys((r.terms, r.mixing) for r in rows)
    )  # fmt: skip
    return ShownTable(
        f"What eq. 11 and 12 add up: {CALLED[method]}, costs of the members, vehicles at {place}. "
        "The paper's surfaces span about 1150 to 1400 km.",
        ("terms", "mixing", *(name for name, _ in columns)),
        lines,
    )


def _ranges(rows: Sequence[Row]) -> ShownTable:
    """Return for each choice of terms between what values each printed number lies here."""
    names = {number: p for number, p in PRINTED.items() if any(r.number == number for r in rows)}
    lines = []
    for terms in dict.fromkeys(r.terms for r in rows):
        line = [terms]
        for number in names:
            # The paper's savings and surfaces are Dijkstra's.
            of = [r for r in rows if r.terms == terms and r.number == number
                  and (r.method == rows[0].method or number == "astar")]  # fmt: skip
            low, high = min(r.ours.value for r in of), max(r.ours.value for r in of)
            digits = 0 if names[number].unit == "km" else 1
            good = sum(r.agrees() for r in of)
            line.append(f"{plain(low, digits)} to {plain(high, digits)} ({good} of {len(of)})")
        lines.append(tuple(line))
    header = (
        f"{p.label} [{p.unit}], paper {' to '.join(f'{v:g}' for v in p.value)}"
        for p in names.values()
    )
    return ShownTable(
        "The printed numbers over all placings, mixings and ways to count, by what eq. 11 and 12 "
        "add up. Brackets: how many 95 % intervals hold the printed number, or how many values "
        "lie in the printed range.",
        ("terms", *header),
        tuple(lines),
    )


def _draws(results: Sequence[StudyResult]) -> ShownTable:
    """Return what was drawn, and how far A* is from the optimum on the same draws."""
    header = [
        "vehicles", "networks", "redrawn: not connected", "redrawn: no destination",
        "mean route [km]",
    ]  # fmt: skip
    common = [m for m in results[0].study.methods if all(m in r.study.methods for r in results)]
    rules = [method for method in common if method != "dijkstra"]
    for method in rules:
        called = RULES[method]
        header += [f"{called}: alone above the optimum [%]", f"{called}: worst vehicle [%]"]
        if "dijkstra" in common:
            header.append(f"{called}: joint plan above Dijkstra's [%]")
    if len(rules) == 2:
        header.append("routes alone dearer under one rule of A* than the other [%]")
    if rules:
        header.append("heuristic over the true cost, median (10 % to 90 %)")
    rows = []
    for result in results:
        study = result.study
        metres = result.optimum / study.alone_factor
        line = [network_label(result), f"{len(result.master)}"]
        line += [f"{count}" for count in result.redraws.sum(axis=0)]
        line.append(f"{metres.mean() / 1000:.0f}")
        grid = int(np.prod(study.grid_shape))
        joint = {
            m: result.joint(study.methods.index(m), 0)[..., :grid].sum(axis=(1, 2)) for m in common
        }
        alone = {m: result.solo_cost[:, study.methods.index(m)] for m in rules}
        for method in rules:
            line.append(_shown(_excess(alone[method].sum(axis=1), result.optimum.sum(axis=1))))
            line.append(f"{100 * (alone[method] / result.optimum - 1).max():.0f}")
            if "dijkstra" in common:
                line.append(_shown(_excess(joint[method], joint["dijkstra"])))
        if len(rules) == 2:
            differ = ~np.isclose(alone[rules[0]], alone[rules[1]], rtol=1e-9, atol=0)
            line.append(f"{100 * differ.mean():.0f}")
        if rules:
            low, middle, high = np.percentile(result.overestimate, [10, 50, 90])
            line.append(f"{middle:.0f} ({low:.0f} to {high:.0f})")
        rows.append(tuple(line))
    return ShownTable(
        "The draws, and the inflated A* against the optimum on the same draws.",
        tuple(header),
        tuple(rows),
    )


RULES = {"astar": "A*", "astar-closed-once": "A* with each node once"}


def _excess(above: Floats, below: Floats) -> Estimate:
    """Return 100 (sum above / sum below - 1) with its bootstrap interval over networks (R,)."""
    runs = len(above)
    draws = np.random.default_rng(0).multinomial(runs, np.full(runs, 1 / runs), RESAMPLES)
    values = 100 * ((draws @ above) / (draws @ below) - 1)
    low, high = np.percentile(values, COVERED)
    return Estimate(100 * float(above.sum() / below.sum() - 1), float(low), float(high))


def _shown(ours: Estimate) -> str:
    digits = 0 if ours.value >= 200 else 1
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
        lines += [table.caption, ""]
        for row in (table.header, ("---",) * len(table.header), *table.rows):
            lines.append("| " + " | ".join(cell.replace("|", "\\|") for cell in row) + " |")
        lines.append("")
    return "\n".join([*lines, paragraph])
