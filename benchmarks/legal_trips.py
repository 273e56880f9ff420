"""How long legal trips take to find: `python -m benchmarks.legal_trips` prints it, after warm-up.

Roads have a place to stop every 15 to 30 min of driving, at 80 km/h. Times are the median and the
longest of some roads, of one processor.
"""

from __future__ import annotations

import argparse
import statistics
import time

import numpy as np

from platoon_osm.driving.eu561 import EU561, EU561_TEAM
from platoon_osm.driving.limits import Limits
from platoon_osm.driving.state import RESTED, DriverState
from platoon_osm.driving.us395 import US395
from platoon_osm.planning.legal.driver.one_driver import fastest
from platoon_osm.planning.legal.driver.road import NO_LIMIT, Road, road_of
from platoon_osm.planning.legal.driver.trip_question import TripQuestion
from platoon_osm.planning.legal.warmth import warm_up

SPEED_KM_H = 80.0
DAY_S = 86_400
TIRED = DriverState(driven_since_break_s=3 * 3600, driven_today_s=3 * 3600, duty_s=4 * 3600)


def road(km: float, seed: int, nights: bool = False) -> Road:
    """Return a road of about a length; `nights` closes all of it from 22:00 to 5:00."""
    rng = np.random.default_rng(seed)
    drive = []
    while sum(drive) < km / SPEED_KM_H * 3600:
        drive.append(int(rng.integers(900, 1800)))
    closed = None
    if nights:
        night = [(day * DAY_S - 2 * 3600, day * DAY_S + 5 * 3600) for day in range(12)]
        closed = [[(begin - one, end) for begin, end in night] for one in drive]
    return road_of(drive, [NO_LIMIT] * (len(drive) + 1), forbidden=closed)


CASES: tuple[tuple[str, float, Limits, DriverState, bool], ...] = (
    ("800 km", 800, EU561, RESTED, False),
    ("800 km, driver under way", 800, EU561, TIRED, False),
    ("1,600 km", 1600, EU561, RESTED, False),
    ("1,600 km, closed at night", 1600, EU561, RESTED, True),
    ("1,600 km, 395.3", 1600, US395, RESTED, False),
    ("1,600 km, two drivers", 1600, EU561_TEAM, DriverState(drivers=2), False),
    ("3,000 km", 3000, EU561, RESTED, False),
    ("a week, 4,000 km", 4000, EU561, RESTED, False),
    ("more than 56 h, 5,000 km", 5000, EU561, RESTED, False),
)


def main() -> None:
    """Print a table."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--roads", type=int, default=7)
    options = parser.parse_args()
    print(f"warm-up {warm_up():.1f} s")
    for name, km, limits, state, nights in CASES:
        spent = []
        for seed in range(options.roads):
            way = road(km, seed, nights)
            begin = time.process_time()
            fastest(TripQuestion(way, limits, state, 0, 6 * 3600))
            spent.append(1000 * (time.process_time() - begin))
        print(f"{name:28} median {statistics.median(spent):8.1f} ms, longest {max(spent):8.1f} ms")


if __name__ == "__main__":
    main()
