"""What is lost on the bundled map of Italy where points are chosen blind to clock or law.

As `blind.py`, on real ways with real rest places: drawn trips from the north to the south, each
with the window that flexibility gives it, under (EC) 561/2006; the master is the one of the longest
route. Points are chosen seeing nothing, windows only, the law only, or both; then the best legal
timetable is found in which members keep to them or stay alone. Run it with
`python -m benchmarks.blind_italy`.
"""

from __future__ import annotations

import sys
from datetime import datetime, timedelta

import numpy as np

from benchmarks.blind import (
    Points,
    blindly,
    kept_to,
    points_of,
    with_law_alone,
    with_windows_alone,
)
from platoon_osm import Trip, load_network, paper_weights
from platoon_osm.planning.asked import Asked
from platoon_osm.planning.legal.legal_question import LegalQuestion
from platoon_osm.planning.legal.member_ways import MemberWays
from platoon_osm.planning.legal.platoon.record import PlatoonTiming
from platoon_osm.planning.legal.platoon.search import search_platoon
from platoon_osm.planning.legal.platoon.star_times import StarTimes
from platoon_osm.planning.legal.star_input import star_way
from platoon_osm.planning.legal.warmth import warm_up
from platoon_osm.planning.problem import Problem

DRAWS = 40
VEHICLES = 5
MARGINS_MIN = (30, 60, 120, 240)
SPANS = 6_000
NORTH = ("Milano", "Torino", "Venezia", "Brescia", "Genova", "Trieste", "Verona", "Bologna")
SOUTH = ("Firenze", "Roma", "Napoli", "Bari")
SIX = datetime(2026, 3, 2, 6)


def drawn_trips(seed: int, margin_min: int) -> list[Trip]:
    """Return trips from north to south that leave within two hours."""
    rng = np.random.default_rng(seed)
    found = []
    for k in range(VEHICLES):
        start, end = rng.choice(NORTH), rng.choice(SOUTH)
        leaves = SIX + timedelta(minutes=int(rng.integers(0, 120)))
        found.append(Trip(f"v{k}", str(start), str(end), leaves, flexibility_min=float(margin_min)))
    return found


def main(draws: int = DRAWS) -> None:
    """Plan all draws in all ways and print a table."""
    warm_up()
    net = load_network("italy-motorways")
    weights = paper_weights(net)
    print("| windows longer than the trip alone by | seen | meetings kept | saved | lost |")
    print("|---|---|---|---|---|")
    for margin in MARGINS_MIN:
        saved: dict[str, float] = {}
        met: dict[str, list[int]] = {}
        alone, unproved = 0.0, 0
        for seed in range(draws):
            trips = drawn_trips(seed, margin)
            problem = Problem(net, tuple(trips), weights, rules="eu561", case="C")
            question = Asked.of(problem).question
            vehicles = [problem.vehicle_of(trip) for trip in problem.trips]
            legal = LegalQuestion(question, vehicles)
            own = star_way(legal, question.star(question.by_length[0]), "C")
            ways = MemberWays(legal, own)

            def best(star: StarTimes, real: bool = True, ways: MemberWays = ways) -> PlatoonTiming:
                return search_platoon(
                    star, ways.trips if real else None, 60.0, most_spans=SPANS, roads=ways.trips,
                    waits=False,
                )  # fmt: skip

            exact = best(own.times)
            unproved += not exact.proved
            alone += exact.alone_cost
            seen: dict[str, Points] = {
                "nothing (blind)": blindly(own.times),
                "windows only": points_of(best(with_windows_alone(own.times), False), own.times),
                "law only": points_of(best(with_law_alone(own.times), False), own.times),
                "both": points_of(exact, own.times),
            }
            for name, points in seen.items():
                found = exact if name == "both" else best(kept_to(own.times, points))
                saved[name] = saved.get(name, 0.0) + found.alone_cost - found.cost
                kept = points_of(found, own.times)
                wanted = [k for k, (i, _) in enumerate(points) if i >= 0]
                count = met.setdefault(name, [0, 0])
                count[0] += sum(kept[k] == points[k] for k in wanted)
                count[1] += len(wanted)
        for name, value in saved.items():
            lost = 1 - value / saved["both"] if saved["both"] else 0.0
            print(
                f"| {margin} min | {name} | {met[name][0]} of {met[name][1]} | {value / alone:.2%} "
                f"| {lost:.1%} |",
                flush=True,
            )
        print(f"({unproved} of {draws} searches ended before all was compared)", file=sys.stderr)


if __name__ == "__main__":
    main(*map(int, sys.argv[1:]))
