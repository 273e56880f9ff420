"""The searches under driving rules, compiled before anybody waits for them."""

from __future__ import annotations

import time

import numpy as np

from ...driving.eu561 import EU561
from ...driving.state import RESTED
from .driver.kernel import LABELS
from .driver.one_driver import fastest
from .driver.road import NO_LIMIT, Road, road_of
from .driver.trip_question import TripQuestion
from .platoon.again import Again
from .platoon.compiled import KERNELS
from .platoon.real import RoadTrips
from .platoon.search import search_platoon
from .platoon.star_times import Span, StarTimes, VehicleRules

__all__ = ["warm_up"]

COMPILED_BY_S = 600.0
"""A search that ends while its kernels are compiled would leave some to the next [s]."""


def warm_up() -> float:
    """Run the compiled searches once, on a road of three hops.

    Returns
    -------
    float
        Seconds that took.
    """
    begin = time.perf_counter()
    for kernel in (LABELS, *KERNELS):
        kernel.now()
    road = road_of([3600] * 3, [NO_LIMIT] * 4)
    fastest(TripQuestion(road, EU561, RESTED, 0, 0))
    rules = VehicleRules(EU561, RESTED, 0)
    drive_s = np.arange(4) * 3600
    cost = drive_s.astype(np.float64)
    star = StarTimes(
        road=road,
        node_at=np.arange(4),
        window=Span(0, 3600, 86_400),
        rules=rules,
        approach_s=drive_s[None, :],
        onward_s=drive_s[None, ::-1],
        entry=cost[None, :],
        leave=cost[None, ::-1],
        platoon=0.9 * cost[None, :],
        length_m=20.0 * cost,
        alone=cost[-1:],
        alone_s=drive_s[-1:],
        windows=(Span(0, 3600, 86_400),),
        member_rules=(rules,),
        relief=0.0,
        master_alone=float(cost[-1]),
        gain=np.full(3, 360.0),
    )
    ways = RoadTrips(star, lambda _, node: _first(road, node), lambda _, node: _last(road, node))
    search_platoon(star, ways, COMPILED_BY_S, roads=ways, again=Again(star.entry, ways.trip))
    return time.perf_counter() - begin


def _first(road: Road, hops: int) -> Road:
    return road_of(road.drive_s[:hops], road.stay_s[: hops + 1])


def _last(road: Road, begin: int) -> Road:
    return road_of(road.drive_s[begin:], road.stay_s[begin:])
