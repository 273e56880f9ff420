"""What is lost by choosing merging and separation points without the clock or without the law.

Made stars of 8 members over 800 km (`legal_stars.py`) under (EC) 561/2006. Points are chosen in
four ways, and then the best legal timetable is made in which every member keeps its points or
drives alone:

- blind: each member takes its cheapest points;
- windows only: the best points and departure in time, but nobody needs a break;
- law only: the best points, departure and stops within the law, but nobody has to be in time;
- exact: both.

Members may rest anywhere on their own ways, so that the rows differ in what was seen alone. Run it
with `python -m benchmarks.blind`.
"""

from __future__ import annotations

import sys
from dataclasses import replace

import numpy as np

from benchmarks.legal_stars import HOUR, made_star
from platoon_osm.driving.limits import UNLIMITED
from platoon_osm.planning.legal.platoon.record import PlatoonTiming
from platoon_osm.planning.legal.platoon.search import search_platoon
from platoon_osm.planning.legal.platoon.star_times import Span, StarTimes
from platoon_osm.planning.legal.warmth import warm_up

DRAWS = 200
MEMBERS = 8
KM = 800.0
MARGINS_MIN = ((30, 30), (30, 120), (120, 240))
FAR_S = 48 * HOUR

Points = list[tuple[int, int]]
"""Where each member merges and separates; -1 for one that stays alone."""


def best(star: StarTimes) -> PlatoonTiming:
    found = search_platoon(star, None, 120.0, extra_stops=0, waits=False)
    assert found.proved
    return found


def points_of(found: PlatoonTiming, star: StarTimes) -> Points:
    some = [(one.merge, one.separate) for one in found.members]
    return some or [(-1, -1)] * len(star.alone)


def blindly(star: StarTimes) -> Points:
    found: Points = []
    nodes = len(star.node_at)
    for m in range(len(star.alone)):
        cost = (star.entry[m] - star.platoon[m])[:, None] + (star.leave[m] + star.platoon[m])
        cost[np.tril_indices(nodes)] = np.inf
        i, j = np.unravel_index(int(cost.argmin()), cost.shape)
        found.append((int(i), int(j)) if cost[i, j] < star.alone[m] else (-1, -1))
    return found


def with_windows_alone(star: StarTimes) -> StarTimes:
    return replace(
        star,
        rules=replace(star.rules, limits=UNLIMITED),
        member_rules=tuple(replace(one, limits=UNLIMITED) for one in star.member_rules),
    )


def with_law_alone(star: StarTimes) -> StarTimes:
    return replace(
        star,
        windows=tuple(
            Span(one.earliest_s - FAR_S, one.latest_s + FAR_S, one.arrival_s + FAR_S)
            for one in star.windows
        ),
        member_rules=tuple(replace(one, state_at_s=None) for one in star.member_rules),
    )


def kept_to(star: StarTimes, points: Points) -> StarTimes:
    entry, leave = np.full_like(star.entry, np.inf), np.full_like(star.leave, np.inf)
    for m, (i, j) in enumerate(points):
        if i >= 0:
            entry[m, i], leave[m, j] = star.entry[m, i], star.leave[m, j]
    return replace(star, entry=entry, leave=leave)


def main(draws: int = DRAWS) -> None:
    """Plan all draws in all ways and print a table."""
    warm_up()
    print("| windows longer than the trip alone by | seen | all meetings kept | saved | lost |")
    print("|---|---|---|---|---|")
    for margin in MARGINS_MIN:
        saved: dict[str, list[float]] = {}
        kept: dict[str, int] = {}
        alone = 0.0
        for seed in range(draws):
            star = made_star(1000 + seed, KM, MEMBERS, margin_min=margin)
            alone += float(star.alone.sum()) + star.master_alone
            exact = best(star)
            ways = {
                "nothing (blind)": blindly(star),
                "windows only": points_of(best(with_windows_alone(star)), star),
                "law only": points_of(best(with_law_alone(star)), star),
                "both (exact)": points_of(exact, star),
            }
            for name, points in ways.items():
                found = exact if name == "both (exact)" else best(kept_to(star, points))
                saved.setdefault(name, []).append(found.alone_cost - found.cost)
                kept[name] = kept.get(name, 0) + (points_of(found, star) == points)
        most = sum(saved["both (exact)"])
        low, high = margin
        told = f"{low} min" if low == high else f"{low} to {high} min"
        for name, some in saved.items():
            print(
                f"| {told} | {name} | {kept[name]} of {draws} | {sum(some) / alone:.2%} "
                f"| {1 - sum(some) / most:.1%} |",
                flush=True,
            )


if __name__ == "__main__":
    main(*map(int, sys.argv[1:]))
