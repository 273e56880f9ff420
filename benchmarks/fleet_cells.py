"""Which fleets are measured for docs/fleets.md: those of its table, and those of its curves."""

from __future__ import annotations

from dataclasses import dataclass, fields, replace

__all__ = [
    "CURVES",
    "LARGEST",
    "SIZES_OF_CURVES",
    "TABLE",
    "TRUCKS",
    "Cell",
    "in_words",
    "of_curve",
]

TRUCKS = (100, 200, 500, 1000, 2000, 5000, 10_000, 20_000)
WINDOWS_MIN = (0.0, 10.0, 30.0, 60.0, 120.0)
LARGEST = (2, 3, 5, 0)
SIZES_OF_CURVES = (1000, 5000)
"""Windows and largest platoons are tried with fleets of these sizes."""

SMALL = 2000
"""Fleets of the curves up to this size are searched for a minute, larger ones for two."""

DRAWS, DRAWS_ASKED = 3, 10
"""Of days of 1,000 trucks; ten where routes are free and platoons of any size."""

BEFORE_S, BEFORE_A_TRUCK_S = 10.0, 0.003
"""What starting, drawing and writing may take beyond the limit of the search."""


@dataclass(frozen=True, slots=True)
class Cell:
    """One fleet that is planned once.

    Attributes
    ----------
    place : str
        A folder of ../shared/data/etis, or "map" for the bundled map of Italy's motorways.
    trucks : int
        How many leave on the day.
    routes : str
        "given" or "free".
    largest : int
        Vehicles of the largest platoon; 0 for any.
    window_min : float
        How much longer than alone each may take [min].
    day : str
        "uniform" or "peaked".
    limit_s : float
        How long is searched [s].
    seed : int
        Of the day and of the search.
    """

    place: str = "DE"
    trucks: int = 1000
    routes: str = "free"
    largest: int = 0
    window_min: float = 30.0
    day: str = "uniform"
    limit_s: float = 60.0
    seed: int = 1

    @property
    def most_s(self) -> float:
        """How long it may take in all [s]."""
        return self.limit_s + BEFORE_S + BEFORE_A_TRUCK_S * self.trucks

    @property
    def key(self) -> tuple[str, ...]:
        """As it stands in a file."""
        return tuple(
            f"{value:g}" if isinstance(value, float) else str(value)
            for value in (getattr(self, field.name) for field in fields(self))
        )

    @classmethod
    def of_key(cls, key: tuple[str, ...]) -> Cell:
        """Return the cell that stands so in a file."""
        place, trucks, routes, largest, window, day, limit, seed = key
        return cls(
            place, int(trucks), routes, int(largest), float(window), day, float(limit), int(seed)
        )


def in_words(cell: Cell) -> str:
    """Return a cell as one line."""
    return (
        f"{cell.place}, {cell.trucks:,} trucks, routes {cell.routes}, largest "
        f"{cell.largest or 'any'}, window {cell.window_min:g} min, {cell.day}, "
        f"{cell.limit_s:g} s, seed {cell.seed}"
    )


def _drawn(cell: Cell, draws: int) -> list[Cell]:
    """Return a cell for each draw."""
    return [replace(cell, seed=seed) for seed in range(1, draws + 1)]


def of_curve(trucks: int) -> Cell:
    """Return the fleet of so many trucks that curves go through."""
    return Cell(trucks=trucks, limit_s=60.0 if trucks <= SMALL else 120.0)


def _table() -> list[Cell]:
    """Return the cells of the table, row by row."""
    rows = []
    for place, asked_draws in (("DE", DRAWS_ASKED), ("IT", DRAWS_ASKED), ("map", DRAWS)):
        for routes, largest, limit_s, draws in (
            ("given", 0, 10.0, DRAWS), ("free", 0, 60.0, asked_draws), ("free", 5, 60.0, DRAWS),
        ):  # fmt: skip
            rows += _drawn(Cell(place, 1000, routes, largest, limit_s=limit_s), draws)
    for place, largest_fleet in (("DE", 20_000), ("IT", 20_000), ("map", 5000)):
        long = place == "DE"
        for trucks, routes, largest, limits_s in (
            (5000, "given", 0, (60, 600)), (5000, "free", 0, (120, 600)), (5000, "free", 5, (120,)),
            (20_000, "given", 0, (120, 600)), (20_000, "free", 0, (120, 600)),
            (20_000, "free", 5, (600,)),
        ):  # fmt: skip
            if trucks <= largest_fleet:
                asked = limits_s if long else limits_s[:1]
                rows += [Cell(place, trucks, routes, largest, limit_s=float(s)) for s in asked]
    for trucks, limit_s, draws in ((1000, 60.0, DRAWS), (5000, 120.0, 1)):
        usual = Cell("DE", trucks, limit_s=limit_s)
        rows += _drawn(replace(usual, day="peaked"), draws)
        for window_min in (10.0, 60.0):
            rows += _drawn(replace(usual, window_min=window_min), draws)
    return rows


def _curves() -> list[Cell]:
    """Return the cells of the curves, each once."""
    cells = [of_curve(trucks) for trucks in TRUCKS]
    for trucks in SIZES_OF_CURVES:
        cells += [replace(of_curve(trucks), window_min=window) for window in WINDOWS_MIN]
        cells += [replace(of_curve(trucks), largest=largest) for largest in LARGEST]
    return list(dict.fromkeys(cells))


TABLE = tuple(_table())
CURVES = tuple(_curves())
