"""How long it takes to prove the best stops and departure of a platoon under (EC) 561/2006.

Made stars on a straight road (`legal_stars.py`), whose members may rest every half hour on their
own ways too. Seconds are of the processor, after warm-up; run it with
`python -m benchmarks.legal_platoons`.
"""

from __future__ import annotations

import statistics
import sys
import time

from benchmarks.legal_stars import made_star, made_trips
from platoon_osm.planning.legal.platoon.search import search_platoon
from platoon_osm.planning.legal.warmth import warm_up

CASES = (
    ("7 members, 400 km", 400.0, 7, 1, True),
    ("7 members, 800 km", 800.0, 7, 1, True),
    ("7 members, 1,500 km with a night", 1500.0, 7, 1, True),
    ("7 members, 1,500 km, no stop more than needed", 1500.0, 7, 0, True),
    ("100 members, 800 km, no stop more than needed", 800.0, 100, 0, True),
    ("1,000 members, 800 km, likewise, rest anywhere", 800.0, 1000, 0, False),
    ("1,000 members, 800 km, likewise, real places", 800.0, 1000, 0, True),
)
"""What is told, km, members, stops more than needed, and whether own ways have places."""

LIMIT_S = 120.0


def main(draws: int = 10) -> None:
    """Search stars of each kind and print a table."""
    warm_up()
    print("| case | proven | median CPU s | most | saved | largest gap on it | trips asked |")
    print("|---|---|---|---|---|---|---|")
    for name, km, members, extra, places in CASES:
        times, saved, gaps, asked, proved = [], [], [], [], 0
        some = draws if members < 100 else max(1, draws // 5)
        for seed in range(some):
            star = made_star(seed, km, members)
            trips = made_trips(star)
            begin = time.process_time()
            real, roads = (trips, trips) if places else (None, None)
            found = search_platoon(star, real, LIMIT_S, roads=roads, extra_stops=extra)
            times.append(time.process_time() - begin)
            saved.append(1 - found.cost / found.alone_cost)
            gaps.append(found.gap)
            asked.append(found.asked)
            proved += found.proved
        print(
            f"| {name} | {proved} of {some} | {statistics.median(times):.2f} | {max(times):.2f} "
            f"| {statistics.mean(saved):.1%} | {max(gaps):.1%} "
            f"| {statistics.median(asked):.0f} |",
            flush=True,
        )


if __name__ == "__main__":
    main(*map(int, sys.argv[1:]))
