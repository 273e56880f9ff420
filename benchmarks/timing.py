"""How long the curve of costs against a master's departure takes, with many members.

Members lie along a route of 470 junctions, each with a window, and reach every junction at a cost
and a time. Two draws: ways that grow with the distance, as on roads, and ways that are all random.
The seconds are those of this machine, one process, after warm-up. Run it with
`python -m benchmarks.timing`.
"""

from __future__ import annotations

import time

import numpy as np
from numpy.typing import NDArray

from platoon_osm.planning.timing.departure_curve import Gains
from platoon_osm.planning.timing.kernels import warm_up
from platoon_osm.planning.timing.limits import Window
from platoon_osm.planning.timing.member_ways import Ways
from platoon_osm.planning.timing.open_points import OpenPoints

JUNCTIONS, MEMBERS, ROUNDS = 470, 1_000, 5
TARGET_S = 0.1

Floats = NDArray[np.float64]


def draw(kind: str, rng: np.random.Generator) -> tuple[OpenPoints, Floats, Floats, Floats]:
    """Return ways and windows, platoon weights, costs alone, and positions along the route."""
    along = np.concatenate([[0.0], np.cumsum(rng.uniform(1.0, 2.0, JUNCTIONS))])
    shape = (MEMBERS, JUNCTIONS + 1)
    if kind == "random":
        there, onward = rng.uniform(0, 300, shape), rng.uniform(0, 300, shape)
        alone = np.full(MEMBERS, 900.0)
    else:
        starts, stops = rng.uniform(0, along[-1], (2, MEMBERS))
        off, back = rng.uniform(0, 60, (2, MEMBERS))
        there = off[:, None] + np.abs(along - starts[:, None]) * 1.05
        onward = back[:, None] + np.abs(along - stops[:, None]) * 1.05
        alone = off + back + np.abs(starts - stops)
    first = rng.uniform(0, 600, MEMBERS)
    windows = [
        Window(float(e), None, float(e + d + more))
        for e, d, more in zip(first, alone, rng.uniform(30, 120, MEMBERS), strict=True)
    ]
    cost = [
        np.where(time_s <= alone[:, None], time_s * rng.uniform(0.9, 1.1, shape), np.inf)
        for time_s in (there, onward)
    ]
    points = OpenPoints.of(
        Window(0.0, 1_200.0, None), windows, along,
        Ways.dense(cost[0], there), Ways.dense(cost[1], onward),
    )  # fmt: skip
    return points, np.tile(along * 0.9, (MEMBERS, 1)), alone, along


def main() -> None:
    """Time the curve of both draws and print a table."""
    warm_up()
    rng = np.random.default_rng(1)
    print(f"{MEMBERS:,} members, {JUNCTIONS} junctions; target {TARGET_S} s a curve\n")
    print("| ways | steps | curve, s | with what the master gains, s | with priced waiting, s |")
    print("|---|---|---|---|---|")
    for kind in ("along the road", "random"):
        points, platoon, alone, along = draw(kind, rng)
        gains = Gains(np.full(JUNCTIONS, 0.05), along)
        taken = []
        steps = 0
        for own, price in ((None, 0.0), (gains, 0.0), (None, 0.5)):
            seconds = []
            for _ in range(ROUNDS):
                begin = time.perf_counter()
                found = points.steps(platoon, alone, alone * 1e-11, own, price).curve(0.0, own)
                seconds.append(time.perf_counter() - begin)
            taken.append(min(seconds))
            steps = steps or len(found.since)
        print(f"| {kind} | {steps:,} | " + " | ".join(f"{s:.3f}" for s in taken) + " |")


if __name__ == "__main__":
    main()
