"""All published instances planned, in tables beside what was published."""

from __future__ import annotations

import statistics
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from pathlib import Path

from ...csv_tables import write_table
from ..exact_process import Solver
from .model import GRID_MIN
from .records import DutchData, DutchInstance, Published
from .solving import DutchResult, solved

__all__ = [
    "Cell", "Run", "cells_of", "kinds_of", "run_all", "table_of", "write_cells", "write_runs",
]  # fmt: skip

FLEXIBILITIES_MIN = (15, 30, 45)
KINDS = ((3, 0), (2, 0), (2, 1))
"""Largest platoon and platoons a trip (0 for any number), as the published tables have them."""

Ask = tuple[DutchInstance, int, int, int, float]
"""Instance, flexibility [min], largest platoon, platoons a trip, grid [min]."""


@dataclass(frozen=True, slots=True)
class Run:
    """An instance, how it was asked, and what was found.

    Attributes
    ----------
    name : str
        Of the set.
    trucks, number, flexibility_min, largest, per_trip : int
        Which one, and how.
    grid_min : float
        To what departures were rounded up [min]; 0 for exact minutes.
    result : DutchResult
        What was found.
    """

    name: str
    trucks: int
    number: int
    flexibility_min: int
    largest: int
    per_trip: int
    grid_min: float
    result: DutchResult


@dataclass(frozen=True, slots=True)
class Cell:
    """The mean over the instances of a cell, beside what was published.

    Attributes
    ----------
    name : str
        Of the set.
    trucks, flexibility_min, largest, per_trip : int
        Which one.
    grid_min : float
        To what departures were rounded up [min].
    saving_pct, platoon_km_pct, in_platoons_pct : float
        Means [%].
    worst_gap_pct, most_s : float
        The largest gap on savings [%], and the longest time [s].
    published : Published or None
        What was published, if it was.
    """

    name: str
    trucks: int
    flexibility_min: int
    largest: int
    per_trip: int
    grid_min: float
    saving_pct: float
    platoon_km_pct: float
    in_platoons_pct: float
    worst_gap_pct: float
    most_s: float
    published: Published | None


def kinds_of(data: DutchData, sets: Sequence[str], grids: Sequence[float]) -> list[Ask]:
    """Return all that is asked.

    Parameters
    ----------
    data : DutchData
        The instances.
    sets : sequence of str
        Which sets; none for all.
    grids : sequence of float
        Grids of departures [min].

    Returns
    -------
    list of tuple
        Instance by instance.
    """
    return [
        (one, flexibility, largest, per_trip, grid)
        for grid in grids
        for one in data.instances
        if not sets or one.name in sets
        for flexibility in FLEXIBILITIES_MIN
        for largest, per_trip in KINDS
    ]


def run_all(
    data: DutchData, asked: Sequence[Ask], done: Callable[[int], None] | None = None
) -> list[Run]:
    """Plan all that is asked.

    Parameters
    ----------
    data : DutchData
        The instances.
    asked : sequence of tuple
        As `kinds_of` returns it.
    done : callable, optional
        Told 1 after each.

    Returns
    -------
    list of Run
        In the order of the question.
    """
    found = []
    with Solver() as solver:
        for one, flexibility, largest, per_trip, grid in asked:
            result = solved(data, one, flexibility, largest, per_trip, grid, solver)
            found.append(
                Run(one.name, len(one.trucks), one.number, flexibility, largest, per_trip, grid,
                    result)
            )  # fmt: skip
            if done is not None:
                done(1)
    return found


def cells_of(data: DutchData, runs: Sequence[Run]) -> list[Cell]:
    """Return the means over the instances of each cell.

    Parameters
    ----------
    data : DutchData
        With what was published.
    runs : sequence of Run
        Of all instances.

    Returns
    -------
    list of Cell
        In the order of the runs.
    """
    groups: dict[tuple[str, int, int, int, int, float], list[DutchResult]] = {}
    for run in runs:
        key = (
            run.name, run.trucks, run.flexibility_min, run.largest, run.per_trip, run.grid_min,
        )  # fmt: skip
        groups.setdefault(key, []).append(run.result)
    return [
        Cell(
            *key,
            statistics.fmean(one.saving_pct for one in own),
            statistics.fmean(one.platoon_km_pct for one in own),
            statistics.fmean(one.in_platoons_pct for one in own),
            max(one.gap_pct for one in own),
            max(one.seconds for one in own),
            data.published.get(key[:5]) if key[5] == GRID_MIN else None,
        )
        for key, own in groups.items()
    ]


def table_of(cells: Sequence[Cell], runs: Sequence[Run]) -> str:
    """Return the cells as a table for reading, and what they come to.

    Parameters
    ----------
    cells : sequence of Cell
        Of one grid.
    runs : sequence of Run
        What they were made from.

    Returns
    -------
    str
        A row for each set, trucks and flexibility; for each kind of platoons savings, those that
        were published, kilometres in platoons, and the largest gap.
    """
    lines = [
        "| set | trucks | flexibility | "
        + " | ".join(f"{_named(*kind)} | published | platoon km | gap" for kind in KINDS)
        + " |",
        "|" + "---|" * (3 + 4 * len(KINDS)),
    ]
    rows: dict[tuple[str, int, int], dict[tuple[int, int], Cell]] = {}
    for cell in cells:
        key = (cell.name, cell.trucks, cell.flexibility_min)
        rows.setdefault(key, {})[cell.largest, cell.per_trip] = cell
    for (name, trucks, flexibility), own in rows.items():
        parts = [name, f"{trucks}", f"{flexibility} min"]
        for kind in KINDS:
            found = own.get(kind)
            parts += ["", "", "", ""] if found is None else [
                f"{found.saving_pct:.2f} %",
                "" if found.published is None else f"{found.published.saving_pct:g} %",
                f"{found.platoon_km_pct:.0f} %",
                f"{found.worst_gap_pct:.2f} %",
            ]  # fmt: skip
        lines.append("| " + " | ".join(parts) + " |")
    return "\n".join([*lines, "", *_sums(cells, runs)])


def _named(largest: int, per_trip: int) -> str:
    return f"up to {largest}, " + ("one platoon a trip" if per_trip else "any number")


def _sums(cells: Sequence[Cell], runs: Sequence[Run]) -> list[str]:
    lines = []
    for kind in KINDS:
        apart = [
            cell.saving_pct - cell.published.saving_pct
            for cell in cells
            if (cell.largest, cell.per_trip) == kind and cell.published is not None
        ]
        if apart:
            lines.append(
                f"{_named(*kind)}: {statistics.fmean(apart):+.3f} points against the published on "
                f"average ({statistics.fmean(map(abs, apart)):.3f} in absolute terms), at least "
                f"{min(apart):+.2f}"
            )
    seconds = [run.result.seconds for run in runs]
    gaps = [run.result.gap_pct for run in runs]
    lines.append(
        f"{len(runs):,} plans: gap on savings at most {max(gaps):.2f} %, "
        f"{sum(gap < 1e-4 for gap in gaps):,} proved optimal; seconds each: median "
        f"{statistics.median(seconds):.3f}, at most {max(seconds):.1f}"
    )
    return lines


def write_runs(runs: Sequence[Run], path: Path) -> None:
    """Write a row for each run as CSV.

    Parameters
    ----------
    runs : sequence of Run
        What was found.
    path : Path
        Of the file.

    Raises
    ------
    ScenarioError
        It cannot be written.
    """
    header = (
        "set", "n_trucks", "instance", "flexibility_min", "max_trucks_per_platoon",
        "platoons_per_trip", "grid_min", "fuel_savings_pct", "bound_pct", "gap_on_savings_pct",
        "platoon_km_pct", "trucks_in_platoon_pct", "seconds",
    )  # fmt: skip
    rows = [
        (
            run.name, run.trucks, run.number, run.flexibility_min, run.largest,
            run.per_trip or "inf", run.grid_min, run.result.saving_pct, run.result.bound_pct,
            run.result.gap_pct, run.result.platoon_km_pct, run.result.in_platoons_pct,
            run.result.seconds,
        )
        for run in runs
    ]  # fmt: skip
    write_table(path, header, rows, 6)


def write_cells(cells: Sequence[Cell], path: Path) -> None:
    """Write a row for each cell as CSV, beside what was published.

    Parameters
    ----------
    cells : sequence of Cell
        Means over instances.
    path : Path
        Of the file.

    Raises
    ------
    ScenarioError
        It cannot be written.
    """
    header = (
        "set", "n_trucks", "flexibility_min", "max_trucks_per_platoon", "platoons_per_trip",
        "grid_min", "fuel_savings_pct", "published_fuel_savings_pct", "platoon_km_pct",
        "published_platoon_km_pct", "trucks_in_platoon_pct", "published_trucks_in_platoon_pct",
        "worst_gap_on_savings_pct", "most_seconds",
    )  # fmt: skip
    rows = []
    for cell in cells:
        told = cell.published
        rows.append(
            (
                cell.name, cell.trucks, cell.flexibility_min, cell.largest,
                cell.per_trip or "inf", cell.grid_min, cell.saving_pct,
                "" if told is None else told.saving_pct, cell.platoon_km_pct,
                "" if told is None else told.platoon_km_pct, cell.in_platoons_pct,
                "" if told is None else told.in_platoons_pct, cell.worst_gap_pct, cell.most_s,
            )
        )  # fmt: skip
    write_table(path, header, rows, 6)
