"""Whole fleets: what is saved, how much more could be, and what that takes.

A day of trips of at least 100 km, drawn by the flows of ../shared/data/etis/{DE,IT} (Speth et al.,
CC BY 4.0), or between the towns of the bundled map of Italy's motorways by a gravity rule; all
trucks alike, who follows saves 10 % of the length and who leads nothing, all waiting free. Gaps are
of savings. Each cell is a process of its own, so that memory is its own; what is measured stands in
a CSV file, and is not measured again.

    python -m benchmarks.fleets                    # the table of docs/fleets.md, hours
    python -m benchmarks.fleets --curves           # its curves
    python -m benchmarks.fleets --up-to 1000 -o FOLDER    # small fleets only, written elsewhere
    python -m benchmarks.fleets 1000 free 0 60     # one cell: trucks, routes, largest, seconds
"""

from __future__ import annotations

import argparse
import json
import subprocess
import sys
import time
from collections.abc import Callable, Sequence
from pathlib import Path

from benchmarks.fleet_cells import CURVES, TABLE, Cell, in_words
from benchmarks.fleet_tables import Figures, read_cells, write_all, write_cells
from benchmarks.sections import ROOT

SHARED = ROOT.parent / "shared" / "data" / "etis"
LEAST_KM = 100.0
SAVED = 0.10


def figures_of(cell: Cell, talk: bool = False) -> dict[str, float | str]:
    """Plan one fleet and return its figures."""
    import platoon_osm as po
    from platoon_osm.fleets.memory import peak_mb
    from platoon_osm.fleets.warmth import warm_up

    folder = SHARED / cell.place
    if cell.place != "map" and not folder.is_dir():
        sys.exit(f"{cell.place}: not found in ../shared/data/etis; this benchmark needs it")
    bundled = cell.place == "map"
    net = po.load_network("italy-motorways" if bundled else folder / "graph.graphml")
    trips = po.draw_trips(
        net, cell.trucks, flows=None if bundled else folder / "traffic.csv",
        day="peaked" if cell.day == "peaked" else "uniform",
        flexibility_min=cell.window_min, min_km=LEAST_KM, seed=cell.seed,
    )  # fmt: skip
    length = net.length_m
    costs = po.EdgeWeights(
        solo=length, platoon=(1 - SAVED) * length, master=length, unit="m", params={}
    )
    problem = po.Problem(net, trips, costs, max_platoon=cell.largest or None)
    limits = po.Limits(
        time_s=cell.limit_s, routes="given" if cell.routes == "given" else "free", seed=cell.seed
    )

    def tell(now: object) -> None:
        if talk:
            print(now, file=sys.stderr, flush=True)

    warm_up()
    begun = time.perf_counter()
    plan = po.plan_fleet(problem, limits, on_progress=tell)
    seconds = time.perf_counter() - begun
    fleet = plan.fleet
    assert fleet is not None
    return {
        "saving_pct": 100 * fleet.saved_share,
        "bound_pct": 100 * fleet.bound / fleet.alone_cost,
        "gap_pct": 100 * fleet.gap,
        "seconds": seconds,
        "peak_mb": peak_mb(),
        "ended": fleet.ended,
    }


def apart(cell: Cell) -> Figures:
    """Return the figures of a cell, planned in a process of its own."""
    done = subprocess.run(
        [sys.executable, "-m", "benchmarks.fleets", "--cell", *cell.key],
        capture_output=True, text=True, check=False,
    )  # fmt: skip
    if done.returncode:
        raise RuntimeError(done.stderr.strip().splitlines()[-1] if done.stderr else "it was killed")
    return Figures(**json.loads(done.stdout.splitlines()[-1]))


def measured(
    cells: Sequence[Cell], path: Path, measure: Callable[[Cell], Figures] = apart
) -> list[str]:
    """Measure the cells that a file does not have, and add each to it at once.

    Parameters
    ----------
    cells : sequence of Cell
        What is asked.
    path : Path
        A CSV file; made if it is missing.
    measure : callable
        What measures one.

    Returns
    -------
    list of str
        Which failed, and why.
    """
    known = read_cells(path)
    left = [cell for cell in dict.fromkeys(cells) if cell not in known]
    print(
        f"{len(set(cells)) - len(left)} cells are measured; {len(left)} more take at most "
        f"{_hours(left)}",
        flush=True,
    )
    failed = []
    for count, cell in enumerate(left, 1):
        try:
            found = measure(cell)
        except RuntimeError as error:
            failed.append(f"{in_words(cell)}: {error}")
            print(failed[-1], file=sys.stderr, flush=True)
            continue
        known = read_cells(path) | {cell: found}
        write_cells(known, path)
        print(
            f"{count} of {len(left)}: {in_words(cell)}: gap {found.gap_pct:.4f} %, "
            f"{found.seconds:.0f} s, {found.peak_mb:.0f} MB; at most {_hours(left[count:])} left",
            flush=True,
        )
    return failed


def _hours(cells: Sequence[Cell]) -> str:
    minutes = round(sum(cell.most_s for cell in cells) / 60)
    return f"{minutes // 60} h {minutes % 60} min"


def main() -> None:
    """Plan one cell, or measure all that are missing and write tables and figure."""
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("trucks", type=int, nargs="?")
    parser.add_argument("routes", nargs="?", default="free", choices=("free", "given"))
    parser.add_argument("largest", type=int, nargs="?", default=0)
    parser.add_argument("seconds", type=float, nargs="?", default=60.0)
    parser.add_argument("--place", default="DE", choices=("DE", "IT", "map"), help="of one cell")
    parser.add_argument("--seed", type=int, default=1, help="of one cell")
    parser.add_argument("--day", default="uniform", choices=("uniform", "peaked"))
    parser.add_argument("--window", type=float, default=30.0, help="minutes, of one cell")
    parser.add_argument("--talk", action="store_true", help="tell each round of one cell")
    parser.add_argument("--cell", nargs=8, help=argparse.SUPPRESS)
    parser.add_argument("--curves", action="store_true", help="the curves, not the table")
    parser.add_argument("--up-to", type=int, help="fleets of at most so many trucks")
    parser.add_argument("--only", choices=("DE", "IT", "map"), help="cells of this place")
    parser.add_argument("--draw", action="store_true", help="write what is known")
    parser.add_argument("--plan", action="store_true", help="tell what is left to measure")
    parser.add_argument(
        "-o", "--out", type=Path, default=ROOT / "docs",
        help="folder of fleets.csv, images/fleets.svg and fleets.md; docs by default",
    )  # fmt: skip
    asked = parser.parse_args()
    if asked.cell or asked.trucks is not None:
        cell = (
            Cell.of_key(tuple(asked.cell))
            if asked.cell
            else Cell(
                asked.place, asked.trucks, asked.routes, asked.largest, asked.window, asked.day,
                asked.seconds, asked.seed,
            )
        )  # fmt: skip
        print(json.dumps(figures_of(cell, asked.talk)))
        return
    cells = [
        cell
        for cell in (CURVES if asked.curves else TABLE)
        if cell.trucks <= (asked.up_to or cell.trucks) and cell.place == (asked.only or cell.place)
    ]
    path = asked.out / "fleets.csv"
    if asked.plan:
        left = [cell for cell in cells if cell not in read_cells(path)]
        print("\n".join([*map(in_words, left), f"{len(left)} cells, at most {_hours(left)}"]))
        return
    try:
        failed = [] if asked.draw else measured(cells, path)
    except KeyboardInterrupt:
        failed = ["interrupted; the same command goes on from here"]
        print(failed[0], file=sys.stderr)
    write_all(asked.out)
    if failed:
        sys.exit(f"{len(failed)} failed")


if __name__ == "__main__":
    main()
