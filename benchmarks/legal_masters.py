"""How long a plan for 8 vehicles under (EC) 561/2006 takes, every vehicle tried as master.

Drawn trips on the bundled map of Italy with real ways and rest places. Seconds are of the
processor, after warm-up; run it with `python -m benchmarks.legal_masters`, or with the number of
draws of each kind. `each` after it prints every plan.
"""

from __future__ import annotations

import random
import statistics
import sys
import time
from collections.abc import Callable
from datetime import datetime, timedelta

import platoon_osm as po
from platoon_osm.planning.legal.warmth import warm_up

DRAWS = 8
VEHICLES = 8
NORTH = ("Torino", "Milano", "Genova", "Brescia", "Verona", "Venezia", "Bologna", "Parma")
SOUTH = ("Roma", "Napoli", "Bari", "Firenze", "Pescara", "Ancona")
SIX = datetime(2026, 3, 3, 6)


def close_together(rng: random.Random) -> list[po.Trip]:
    """Return trips from north to south that leave within an hour and a half."""
    return [
        po.Trip(f"V{k}", rng.choice(NORTH), rng.choice(SOUTH), _after(rng.randint(0, 90)))
        for k in range(VEHICLES)
    ]


def hours_apart(rng: random.Random) -> list[po.Trip]:
    """Return trips likewise that leave within eight hours."""
    return [
        po.Trip(f"V{k}", rng.choice(NORTH), rng.choice(SOUTH), _after(rng.randint(0, 480)))
        for k in range(VEHICLES)
    ]


def with_windows(rng: random.Random) -> list[po.Trip]:
    """Return trips likewise, within four hours, that may arrive half an hour to four hours late."""
    return [
        po.Trip(
            f"V{k}", rng.choice(NORTH), rng.choice(SOUTH), _after(rng.randint(0, 240)),
            flexibility_min=float(rng.randint(30, 240)),
        )
        for k in range(VEHICLES)
    ]  # fmt: skip


def by_arrival(rng: random.Random) -> list[po.Trip]:
    """Return trips between any two towns of which some name an arrival only."""
    found = []
    for k in range(VEHICLES):
        start, end = rng.sample((*NORTH, *SOUTH), 2)
        at = rng.randint(0, 360)
        if k % 2:
            found.append(po.Trip(f"V{k}", start, end, latest_arrival=_after(at + 12 * 60)))
        else:
            found.append(po.Trip(f"V{k}", start, end, _after(at)))
    return found


KINDS: tuple[tuple[str, int, Callable[[random.Random], list[po.Trip]]], ...] = (
    ("north to south, leaving within 90 min", 3, close_together),
    ("within 8 h", 4, hours_apart),
    ("within 4 h, windows of 30 to 240 min", 5, with_windows),
    ("any towns, departures or arrivals named", 6, by_arrival),
)
"""What is told, the seed and the trips."""


def main(draws: int = DRAWS, each: bool = False) -> None:
    """Plan trips of each kind and print a table."""
    net = po.load_network("italy-motorways")
    weights = po.paper_weights(net)
    warm_up()
    two = [po.Trip("a", "Milano", "Roma", SIX), po.Trip("b", "Torino", "Roma", SIX)]
    po.plan_joint(net, weights, two, rules="eu561")
    print("| trips | proved | median CPU s | most | saved | mean gap | largest |")
    print("|---|---|---|---|---|---|---|")
    for name, seed, drawn in KINDS:
        rng = random.Random(seed)
        seconds, saved, gaps = [], [], []
        for _ in range(draws):
            trips = drawn(rng)
            begin = time.process_time()
            plan = po.plan_joint(net, weights, trips, rules="eu561")
            seconds.append(time.process_time() - begin)
            saved.append(plan.saving)
            gaps.append(plan.proof.gap or 0.0)
            if each:
                print(
                    f"  {seconds[-1]:.2f} s, saved {plan.saving:.3%}, {plan.proof.kind}, "
                    f"gap {gaps[-1]:.2%}, {len(plan.platoons)} platoons",
                    flush=True,
                )
        print(
            f"| {name} | {sum(not gap for gap in gaps)} of {draws} "
            f"| {statistics.median(seconds):.2f} | {max(seconds):.2f} "
            f"| {statistics.mean(saved):.2%} | {statistics.mean(gaps):.2%} | {max(gaps):.1%} |",
            flush=True,
        )


def _after(minutes: int) -> datetime:
    return SIX + timedelta(minutes=minutes)


if __name__ == "__main__":
    main(int((*sys.argv, DRAWS)[1]), "each" in sys.argv)
