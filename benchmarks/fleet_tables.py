"""What was measured of fleets: the file, and tables and figure that are made from it alone.

A row of the table is of all draws that differ in their seed only: medians of them, the largest gap,
and the most memory.
"""

from __future__ import annotations

import csv
import statistics
from collections.abc import Mapping, Sequence
from dataclasses import astuple, dataclass, fields, replace
from pathlib import Path

from benchmarks.fleet_cells import (
    CURVES,
    LARGEST,
    SIZES_OF_CURVES,
    TABLE,
    TRUCKS,
    Cell,
    of_curve,
)
from benchmarks.sections import markdown_table, write_section

__all__ = ["Figures", "curves_of", "read_cells", "table_of", "write_all", "write_cells"]

CELL_COLUMNS = tuple(field.name for field in fields(Cell))
LEAST_GAP_PCT = 1e-4
"""No smaller gap is drawn: the axis is logarithmic, and some gaps are none."""

PLACES = {"DE": "Germany", "IT": "Italy", "map": "bundled map"}


@dataclass(frozen=True, slots=True)
class Figures:
    """What was measured of a cell.

    Attributes
    ----------
    saving_pct, bound_pct : float
        What is saved, and what no plan can save more than, of what all cost alone [%].
    gap_pct : float
        What may be missing, of the bound on savings [%].
    seconds : float
        Of the whole call, compiling left out [s].
    peak_mb : float
        The most memory that its process held [MB].
    ended : str
        Why the search ended.
    """

    saving_pct: float
    bound_pct: float
    gap_pct: float
    seconds: float
    peak_mb: float
    ended: str


FIGURE_COLUMNS = tuple(field.name for field in fields(Figures))


def read_cells(path: Path) -> dict[Cell, Figures]:
    """Return what a file has; nothing where there is none."""
    if not path.is_file():
        return {}
    with path.open(encoding="utf-8", newline="") as handle:
        return {
            Cell.of_key(tuple(row[name] for name in CELL_COLUMNS)): Figures(
                float(row["saving_pct"]),
                float(row["bound_pct"]),
                float(row["gap_pct"]),
                float(row["seconds"]),
                float(row["peak_mb"]),
                row["ended"],
            )
            for row in csv.DictReader(handle)
        }


def write_cells(known: Mapping[Cell, Figures], path: Path) -> None:
    """Write a file whole, in the order in which cells were measured."""
    path.parent.mkdir(parents=True, exist_ok=True)
    half = path.with_suffix(".half")
    with half.open("w", encoding="utf-8", newline="") as handle:
        rows = csv.writer(handle, lineterminator="\n")
        rows.writerow(CELL_COLUMNS + FIGURE_COLUMNS)
        for cell, found in known.items():
            *numbers, ended = astuple(found)
            rows.writerow([*cell.key, *(f"{value:.6g}" for value in numbers), ended])
    half.replace(path)


def table_of(known: Mapping[Cell, Figures], wanted: Sequence[Cell] = TABLE) -> str:
    """Return the table of the wanted cells that are known, a row for all draws of one kind."""
    rows = []
    for kind in dict.fromkeys(replace(cell, seed=1) for cell in wanted):
        draws = [known[cell] for cell in wanted if replace(cell, seed=1) == kind and cell in known]
        if draws:
            rows.append(_row(kind, draws))
    header = (
        "roads", "trucks", "routes", "largest", "day", "window [min]", "limit [s]", "draws",
        "saved [%]", "bound [%]", "gap on savings [%], median", "largest gap [%]", "seconds",
        "memory [MB]",
    )  # fmt: skip
    return markdown_table(header, rows)


def _row(kind: Cell, draws: Sequence[Figures]) -> list[str]:
    saving, bound, gap, seconds = (
        statistics.median(getattr(one, name) for one in draws)
        for name in ("saving_pct", "bound_pct", "gap_pct", "seconds")
    )
    return [
        PLACES[kind.place], f"{kind.trucks:,}", kind.routes, str(kind.largest or "any"), kind.day,
        f"{kind.window_min:g}", f"{kind.limit_s:g}", str(len(draws)), f"{saving:.4f}",
        f"{bound:.4f}", f"{gap:.4f}", f"{max(one.gap_pct for one in draws):.4f}", f"{seconds:.0f}",
        f"{max(one.peak_mb for one in draws):,.0f}",
    ]  # fmt: skip


def curves_of(known: Mapping[Cell, Figures]) -> str:
    """Return the table of the curves, cell by cell."""
    return table_of(known, CURVES)


def write_all(folder: Path) -> None:
    """Write tables and figure of what is known, between their markers of the page."""
    known, page = read_cells(folder / "fleets.csv"), folder / "fleets.md"
    if any(cell in known for cell in TABLE):
        write_section("fleets", table_of(known), page)
    if any(cell in known for cell in CURVES):
        picture = folder / "images" / "fleets.svg"
        draw(known, picture)
        text = (
            "![Saving and bound, gap, seconds and memory against trucks, window and largest "
            f"platoon](images/{picture.name})\n\n{curves_of(known)}"
        )
        write_section("fleet-curves", text, page)


def draw(known: Mapping[Cell, Figures], path: Path) -> None:
    """Draw the curves: a column for what is varied, a row for what is measured."""
    import matplotlib as mpl

    mpl.use("svg")
    mpl.rcParams["svg.hashsalt"] = "platoon_osm"
    from matplotlib import pyplot as plt

    figure, axes = plt.subplots(
        4, 3, figsize=(10, 9.5), sharex="col", sharey="row", layout="constrained"
    )
    for column, (name, label, sizes) in enumerate(
        (
            ("trucks", "trucks", (None,)),
            ("window_min", "window [min]", SIZES_OF_CURVES),
            ("largest", "largest platoon", SIZES_OF_CURVES),
        )
    ):
        axes[-1][column].set_xlabel(label)
        for size in sizes:
            line = _line(name, size, known)
            x, figures = [place for place, _ in line], [one for _, one in line]
            of = f"{size:,} trucks, " if size else ""
            color = f"C{sizes.index(size)}"
            for row, what, mark, text in (
                (0, "saving_pct", "o-", "saved"), (0, "bound_pct", "v--", "bound"),
                (1, "gap_pct", "o-", ""), (2, "seconds", "o-", ""), (3, "peak_mb", "o-", ""),
            ):  # fmt: skip
                values = [getattr(one, what) for one in figures]
                if row == 1:
                    values = [max(value, LEAST_GAP_PCT) for value in values]
                axes[row][column].plot(x, values, mark, color=color, label=of + text)
        axes[0][column].legend(fontsize="small")
    for row, label in enumerate(
        ("of the cost alone [%]", "gap on savings [%]", "seconds", "memory [MB]")
    ):
        axes[row][0].set_ylabel(label)
    for row in axes[1:]:
        row[0].set_yscale("log")
    axes[-1][0].set_xscale("log")
    axes[-1][0].set_xlim(0.8 * TRUCKS[0], 1.25 * TRUCKS[-1])
    axes[-1][2].set_xticks(range(len(LARGEST)), [str(size or "any") for size in LARGEST])
    for one in axes.flat:
        one.grid(alpha=0.3)
    figure.align_ylabels()
    path.parent.mkdir(parents=True, exist_ok=True)
    figure.savefig(path, metadata={"Date": None})
    plt.close(figure)


def _line(
    name: str, size: int | None, known: Mapping[Cell, Figures]
) -> list[tuple[float, Figures]]:
    """Return the points of a curve over one field of a cell, of fleets of a size if given."""
    found = [
        (_place(cell, name), known[cell])
        for cell in CURVES
        if cell in known
        and cell.trucks == (size or cell.trucks)
        and cell == replace(of_curve(cell.trucks), **{name: getattr(cell, name)})
    ]
    return sorted(found, key=lambda point: point[0])


def _place(cell: Cell, name: str) -> float:
    """Return where a cell stands on an axis; largest platoons stand side by side."""
    if name == "largest":
        return float(LARGEST.index(cell.largest))
    return float(cell.trucks if name == "trucks" else cell.window_min)
