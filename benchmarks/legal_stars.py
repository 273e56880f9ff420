"""Made masters and members on a straight road, as the benchmarks of platoons under the law need.

The master drives a given distance at 80 km/h past nodes at random places, and may rest every half
hour. Each member starts and ends up to 90 min beside the road; it may rest anywhere on its own
ways. Its window is such that meeting is likely, and lasts longer than its legal trip alone by a
margin that is drawn.
"""

from __future__ import annotations

import numpy as np

from platoon_osm.driving.eu561 import EU561
from platoon_osm.driving.state import DriverState
from platoon_osm.planning.legal.driver.road import NO_LIMIT, Road, road_of
from platoon_osm.planning.legal.platoon.real import RoadTrips
from platoon_osm.planning.legal.platoon.star_times import Span, StarTimes, VehicleRules

KMH = 80.0
MINUTE = 60
HOUR = 3600
SAVED = 0.10


def alone_s(drive_s: int, driven_s: int) -> int:
    """Return how long a legal trip alone takes at least, with breaks anywhere and one rest."""
    spell, day, rest = int(4.5 * HOUR), 10 * HOUR, 9 * HOUR

    def breaks(driven: int, seconds: int) -> int:
        return 45 * MINUTE * max(0, -(-(driven + seconds - spell) // spell))

    found = []
    if driven_s + drive_s <= day:
        found.append(drive_s + breaks(driven_s, drive_s))
    for before in (0, min(drive_s, spell - driven_s), min(drive_s, day - driven_s)):
        if drive_s - before <= day:
            own = breaks(driven_s, before) + rest + breaks(0, drive_s - before)
            found.append(drive_s + own)
    return min(found)


def made_star(
    seed: int,
    km: float,
    members: int,
    *,
    nodes: int = 100,
    margin_min: tuple[int, int] = (30, 120),
    standing_h: float | None = None,
    later_h: float = 3.0,
    relief: float = 0.0,
) -> StarTimes:
    """Return a star of one master and some members."""
    rng = np.random.default_rng(seed)
    total = round(km / KMH * HOUR)
    places = np.arange(30 * MINUTE, total, 30 * MINUTE)
    at = np.unique(np.concatenate([[0, total], rng.integers(1, total, nodes - 2), places]))
    node_at = np.flatnonzero(~np.isin(at, places) | (at == 0) | (at == total))
    stay = np.where(np.isin(at, places), NO_LIMIT, 0)
    tau = at[node_at]
    long = min(700 * MINUTE, total)
    begins = rng.uniform(0, max(1.0, total - 200 * MINUTE), members)
    ends = np.minimum(begins + rng.uniform(150 * MINUTE, long, members), total)
    before, after = rng.integers(0, 90 * MINUTE, members), rng.integers(0, 90 * MINUTE, members)
    approach = np.round(before[:, None] + abs(tau - begins[:, None])).astype(np.int64)
    onward = np.round(after[:, None] + abs(tau - ends[:, None])).astype(np.int64)
    drives = np.round(before + after + ends - begins).astype(np.int64)
    tired = np.where(rng.random(members) < 0.4, rng.integers(0, 200 * MINUTE, members), 0)
    tired = np.minimum(tired, np.maximum(0, 10 * HOUR - drives))
    stood = 45 * MINUTE * (begins // (270 * MINUTE)) + np.where(begins > 570 * MINUTE, 9 * HOUR, 0)
    earliest = np.round(rng.uniform(-60, 90, members) * MINUTE + begins - before + stood)
    margin = rng.integers(margin_min[0] * MINUTE, margin_min[1] * MINUTE + 1, members)
    windows = tuple(
        Span(int(begin), int(begin) + 24 * HOUR,
             int(begin) + alone_s(int(drive), int(driven)) + int(more))
        for begin, drive, driven, more in zip(earliest, drives, tired, margin, strict=True)
    )  # fmt: skip
    rules = tuple(
        VehicleRules(
            EU561,
            DriverState(driven_since_break_s=float(one), driven_today_s=float(one)),
            window.earliest_s,
        )
        for one, window in zip(tired.tolist(), windows, strict=True)
    )
    if standing_h is None:
        standing_h = 2.5 if total <= 10 * HOUR else 13.0
    window = Span(0, round(later_h * HOUR), total + round(standing_h * HOUR) + HOUR)
    return StarTimes(
        road=road_of(np.diff(at), stay), node_at=node_at, window=window,
        rules=VehicleRules(EU561, DriverState(), 0), approach_s=approach, onward_s=onward,
        entry=approach / MINUTE, leave=onward / MINUTE,
        platoon=np.array([(1 - SAVED) * (tau - tau[0]) / MINUTE] * members),
        length_m=tau * KMH / 3.6, alone=drives / MINUTE, alone_s=drives, windows=windows,
        member_rules=rules, relief=relief, master_alone=total / MINUTE,
        gain=np.zeros(len(tau) - 1), monday_s=-48 * HOUR,
    )  # fmt: skip


def made_trips(star: StarTimes) -> RoadTrips:
    """Return who answers how members of a made star really drive: places every half hour."""

    def way(seconds: int) -> Road:
        hops = [*[30 * MINUTE] * (seconds // (30 * MINUTE)), seconds % (30 * MINUTE)]
        return road_of(hops if seconds else [], [NO_LIMIT] * (len(hops) + 1 if seconds else 1))

    return RoadTrips(
        star,
        lambda member, node: way(int(star.approach_s[member, node])),
        lambda member, node: way(int(star.onward_s[member, node])),
    )
