"""What places between junctions take, on a made network of 50,000 nodes.

Run it with `python -m benchmarks.places`.
"""

from __future__ import annotations

import statistics
import time
from dataclasses import replace

import numpy as np

import platoon_osm as po
from platoon_osm.search.hierarchy.preparing.storage import topology_of
from platoon_osm.search.hierarchy.warmth import warm_up

SIDE = 224
KEPT = 0.7
VEHICLES = 8
ROUNDS = 5


def made_network() -> po.RoadNetwork:
    """Return a grid with gaps, as wide as a country."""
    rng = np.random.default_rng(0)
    x, y = np.meshgrid(np.arange(SIDE), np.arange(SIDE))
    lon = 6 + 0.05 * x + rng.uniform(-0.01, 0.01, x.shape)
    lat = 40 + 0.04 * y + rng.uniform(-0.01, 0.01, x.shape)
    node = np.arange(SIDE * SIDE).reshape(SIDE, SIDE)
    a = np.concatenate([node[:, :-1].ravel(), node[:-1].ravel()])
    b = np.concatenate([node[:, 1:].ravel(), node[1:].ravel()])
    kept = rng.random(len(a)) < KEPT
    ends = np.concatenate([a[kept], b[kept]]), np.concatenate([b[kept], a[kept]])
    return po.RoadNetwork.from_edges(*ends, lon=lon.ravel(), lat=lat.ravel())


def median_s(net: po.RoadNetwork, trips: list[po.Trip]) -> float:
    """Return how long a plan takes once the network is prepared."""
    taken = []
    for _ in range(ROUNDS):
        begin = time.perf_counter()
        po.plan_joint(net, po.PaperCosts(tau=1.0, xi=0.18), trips, "C", engine="hierarchy")
        taken.append(time.perf_counter() - begin)
    return statistics.median(taken)


def main() -> None:
    """Measure and print a table."""
    warm_up()
    net = made_network()
    begin = time.perf_counter()
    topology_of(net)
    prepared = time.perf_counter() - begin
    rng = np.random.default_rng(1)
    main_part = np.flatnonzero(net.strong_component() == 0)
    ends = rng.choice(main_part, (VEHICLES, 2), replace=False)

    def on_road(node: int) -> tuple[float, float]:
        lon, lat = net.shape(int(net.first_out[node])).mean(axis=0)
        return float(lon), float(lat)

    nodes = [po.Trip(f"V{k}", int(a), int(b)) for k, (a, b) in enumerate(ends)]
    one = [replace(nodes[0], origin=on_road(int(ends[0, 0]))), *nodes[1:]]
    every = [po.Trip(f"V{k}", on_road(int(a)), on_road(int(b))) for k, (a, b) in enumerate(ends)]
    beside = [
        po.Trip(f"V{k}", tuple(np.add(on_road(int(a)), 0.01).tolist()), int(b))
        for k, (a, b) in enumerate(ends)
    ]
    print("| plan of 8 vehicles, 50,176 nodes | s |\n|---|---|")
    print(f"| preparing the network, once | {prepared:.2f} |")
    for label, trips in (
        ("all places at nodes", nodes), ("one between two junctions", one),
        ("all 16 between two junctions", every), ("all 8 starts beside the road", beside),
    ):  # fmt: skip
        print(f"| {label} | {median_s(net, trips):.2f} |")


if __name__ == "__main__":
    main()
