"""The comparison as tables for people: the report and docs/paper.md show the same ones."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from .comparison import Row, network_label
from .measures import COVERED, INVOLVEMENTS, RESAMPLES, TOTALS, Estimate
from .monte_carlo import StudyResult

__all__ = ["ShownTable", "markdown", "shown_tables"]

Floats = NDArray[np.float64]

READING = ("vehicles", "mixing")
NAMED = {"members": "members", "system": "with master"}


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
    at = {(r.number, r.network, r.mixing, r.counted, r.method): r.ours for r in rows}
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

    tables = []
    for method in methods:
        called = {"dijkstra": "Dijkstra", "astar": "the inflated A*"}[method]
        tables.append(table(
            f"Savings by {called} [%]. The paper prints 8 % at (100 %, 18 %) and 14 % on average.",
            [
                (f"{short}: {NAMED[total]}", (number, total, method))
                for number, short in (("point", "paper 8 %"), ("mean", "paper 14 %"))
                for total in TOTALS
            ],
        ))  # fmt: skip
    tables.append(table(
        "Members involved, mean over the grid [%]. The paper prints 33 % for Dijkstra, 39 % for "
        "A*. Merging and separating truly: driving roads alone before and after.",
        [
            (f"{short}: {name}", (method, name, method))
            for method, short in (("dijkstra", "Dijkstra, paper 33 %"), ("astar", "A*, paper 39 %"))
            if method in methods
            for name in INVOLVEMENTS
        ],
    ))  # fmt: skip
    costs = (("alone", "alone"), ("joint, least", "joint low"), ("joint, greatest", "joint high"))
    tables += [
        table(
            f"Mean cost of a vehicle, {NAMED[total]}, {methods[0]} [km]. The paper's surfaces span "
            "about 1150 to 1400 km.",
            [(name, (number, total, methods[0])) for name, number in costs],
        )
        for total in TOTALS
    ]
    tables.append(_draws(results))
    return tables


def _draws(results: Sequence[StudyResult]) -> ShownTable:
    """Return what was drawn, and how far A* is from the optimum on the same draws."""
    header = [
        "vehicles", "networks", "redrawn: not connected", "redrawn: no destination",
        "mean route [km]",
    ]  # fmt: skip
    astar = all("astar" in r.study.methods for r in results)
    both = astar and all("dijkstra" in r.study.methods for r in results)
    if astar:
        header += [
            "A* alone above the optimum [%]",
            "worst vehicle [%]",
            "heuristic over the true cost, median (10 % to 90 %)",
        ]
    if both:
        header += ["A* joint plan above Dijkstra's [%]"]
    rows = []
    for result in results:
        study = result.study
        metres = result.optimum / study.costs.solo_factor()
        line = [network_label(result), f"{len(result.master)}"]
        line += [f"{count}" for count in result.redraws.sum(axis=0)]
        line.append(f"{metres.mean() / 1000:.0f}")
        if astar:
            alone = result.solo_cost[:, study.methods.index("astar")]
            excess = 100 * (alone / result.optimum - 1)
            low, middle, high = np.percentile(result.overestimate, [10, 50, 90])
            line.append(_shown(_excess(alone.sum(axis=1), result.optimum.sum(axis=1))))
            line += [f"{excess.max():.0f}", f"{middle:.0f} ({low:.0f} to {high:.0f})"]
        if both:
            grid = int(np.prod(study.grid_shape))
            joint = result.joint_cost[:, :, 0, :, :grid].sum(axis=(2, 3))
            k, d = (study.methods.index(name) for name in ("astar", "dijkstra"))
            line.append(_shown(_excess(joint[:, k], joint[:, d])))
        rows.append(tuple(line))
    return ShownTable(
        "The draws, and the inflated A* against the optimum on the same draws.",
        tuple(header),
        tuple(rows),
    )


def _excess(above: Floats, below: Floats) -> Estimate:
    """Return 100 (sum above / sum below - 1) with its bootstrap interval over networks (R,)."""
    runs = len(above)
    draws = np.random.default_rng(0).multinomial(runs, np.full(runs, 1 / runs), RESAMPLES)
    values = 100 * ((draws @ above) / (draws @ below) - 1)
    low, high = np.percentile(values, COVERED)
    return Estimate(100 * float(above.sum() / below.sum() - 1), float(low), float(high))


def _shown(ours: Estimate) -> str:
    digits = 0 if ours.value >= 200 else 1
    return f"{ours.value:.{digits}f} [{ours.low:.{digits}f}, {ours.high:.{digits}f}]"


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
