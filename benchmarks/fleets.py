"""Whole fleets: what is saved, how much more could be, and what that takes.

A day of trips of at least 100 km, drawn by the flows of ../shared/data/etis/{DE,IT} (Speth et al.,
CC BY 4.0), every truck at 80 km/h, who follows saves 10 % of the length and who leads nothing, all
waiting free. Gaps are of savings. Each cell is a process of its own, so that memory is its own.

    python -m benchmarks.fleets                    # the table of docs/fleets.md, hours
    python -m benchmarks.fleets 1000 free 0 60     # one cell: trucks, routes, largest, seconds
"""

from __future__ import annotations

import argparse
import csv
import json
import statistics
import subprocess
import sys
from datetime import datetime, timedelta
from pathlib import Path

import numpy as np

import platoon_osm as po

SHARED = Path(__file__).resolve().parents[2] / "shared" / "data" / "etis"
DAY = datetime(2026, 3, 2)
DAY_S = 86_400
LEAST_KM = 100.0
SAVED = 0.10
CELLS = (
    (1000, "given", 0, 10), (1000, "free", 0, 60), (1000, "free", 5, 60),
    (5000, "given", 0, 60), (5000, "given", 0, 600), (5000, "free", 0, 120),
    (5000, "free", 0, 600), (5000, "free", 5, 120),
    (20000, "given", 0, 120), (20000, "given", 0, 600), (20000, "free", 0, 120),
    (20000, "free", 0, 600), (20000, "free", 5, 600),
)  # fmt: skip


def network(country: str) -> po.RoadNetwork:
    """Return the freight network of a country."""
    folder = SHARED / country
    if not folder.is_dir():
        sys.exit(f"{folder.name}: not found in ../shared/data/etis; this benchmark needs it")
    return po.load_network(folder / "graph.graphml")


def base_costs(net: po.RoadNetwork) -> po.EdgeWeights:
    """Return length as cost, of which a follower saves a tenth and a leader nothing."""
    length = net.length_m
    return po.EdgeWeights(
        solo=length, platoon=(1 - SAVED) * length, master=length, unit="m", params={}
    )


def departures(rng: np.random.Generator, number: int, day: str) -> np.ndarray:
    """Return seconds of the day: uniform, or half of all around 6 and most others around 18 h."""
    if day == "uniform":
        return rng.random(number) * DAY_S
    early = rng.normal(6 * 3600, 3600, number)
    late = rng.normal(18 * 3600, 1.5 * 3600, number)
    other = rng.random(number) * DAY_S
    pick = rng.random((2, number))
    found = np.where(pick[0] < 0.5, early, np.where(pick[1] < 0.5, late, other))
    return np.clip(found, 0, DAY_S)


def trips_of(
    net: po.RoadNetwork, country: str, number: int, seed: int, day: str, window_min: float
) -> list[po.Trip]:
    """Return a day of trips drawn by volume."""
    from scipy.sparse import csr_array
    from scipy.sparse.csgraph import dijkstra

    node = {int(one): k for k, one in enumerate(net.node_id)}
    with (SHARED / country / "traffic.csv").open(encoding="utf-8") as file:
        rows = [
            (node[int(row["origin"])], node[int(row["destination"])], float(row["volume"]))
            for row in csv.DictReader(file)
            if int(row["origin"]) in node and int(row["destination"]) in node
        ]
    ends = np.array([row[:2] for row in rows])
    weight = np.array([row[2] for row in rows])
    graph = csr_array((net.length_m, (net.tail, net.head)), shape=(net.n, net.n))
    far = dijkstra(graph)[ends[:, 0], ends[:, 1]]
    weight[~(np.isfinite(far) & (far >= LEAST_KM * 1000))] = 0.0
    rng = np.random.default_rng(seed)
    chosen = rng.choice(len(rows), number, p=weight / weight.sum())
    leaves = departures(rng, number, day)
    return [
        po.Trip(
            f"T{k}", int(ends[row, 0]), int(ends[row, 1]),
            DAY + timedelta(seconds=round(float(at))), flexibility_min=window_min,
        )
        for k, (row, at) in enumerate(zip(chosen.tolist(), leaves, strict=True))
    ]  # fmt: skip


def cell(arguments: argparse.Namespace) -> dict[str, float | str]:
    """Plan one fleet and return its figures."""
    net = network(arguments.country)
    trips = trips_of(
        net, arguments.country, arguments.trucks, arguments.seed, arguments.day, arguments.window
    )
    problem = po.Problem(net, trips, base_costs(net), max_platoon=arguments.largest or None)
    limits = po.Limits(time_s=arguments.seconds, routes=arguments.routes, seed=arguments.seed)

    def tell(now: object) -> None:
        if arguments.talk:
            print(now, file=sys.stderr, flush=True)

    plan = po.plan_fleet(problem, limits, on_progress=tell)
    fleet = plan.fleet
    assert fleet is not None
    return {
        "saving_pct": 100 * fleet.saved_share,
        "bound_pct": 100 * fleet.bound / fleet.alone_cost,
        "gap_pct": 100 * fleet.gap,
        "seconds": fleet.seconds,
        "peak_mb": fleet.peak_mb,
        "ended": fleet.ended,
    }


def apart(*words: object) -> dict[str, float]:
    """Return the figures of a cell, planned in a process of its own."""
    done = subprocess.run(
        [sys.executable, "-m", "benchmarks.fleets", *map(str, words)],
        capture_output=True, text=True, check=True,
    )  # fmt: skip
    return json.loads(done.stdout.splitlines()[-1])  # type: ignore[no-any-return]


def table(draws: int) -> None:
    """Print a row for each cell: medians over draws, and the largest gap."""
    print(
        "| trucks | routes | largest | limit [s] | saved [%] | bound [%] | gap on savings [%], "
        "median | largest gap [%] | seconds | memory [MB] |\n" + "|---" * 10 + "|"
    )
    for trucks, routes, largest, seconds in CELLS:
        found = [
            apart(trucks, routes, largest, seconds, "--seed", seed)
            for seed in range(1, (draws if trucks <= 1000 else 1) + 1)
        ]

        def middle(name: str, found: list[dict[str, float]] = found) -> float:
            return statistics.median(one[name] for one in found)

        print(
            f"| {trucks:,} | {routes} | {largest or 'any'} | {seconds} | "
            f"{middle('saving_pct'):.4f} | {middle('bound_pct'):.4f} | {middle('gap_pct'):.3f} | "
            f"{max(one['gap_pct'] for one in found):.3f} | {middle('seconds'):.0f} | "
            f"{max(one['peak_mb'] for one in found):,.0f} |",
            flush=True,
        )


def main() -> None:
    """Plan one cell, or print the whole table."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("trucks", type=int, nargs="?")
    parser.add_argument("routes", nargs="?", default="free", choices=("free", "given"))
    parser.add_argument("largest", type=int, nargs="?", default=0)
    parser.add_argument("seconds", type=float, nargs="?", default=60.0)
    parser.add_argument("--country", default="DE")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--day", default="uniform", choices=("uniform", "peaked"))
    parser.add_argument("--window", type=float, default=30.0, help="minutes")
    parser.add_argument("--draws", type=int, default=10)
    parser.add_argument("--talk", action="store_true", help="tell each round")
    arguments = parser.parse_args()
    if arguments.trucks is None:
        table(arguments.draws)
    else:
        print(json.dumps(cell(arguments)))


if __name__ == "__main__":
    main()
