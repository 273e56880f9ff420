"""A day of trips: who goes where by chance in proportion to volume, and when by the hour of day.

Trips are independent draws. On a uniform day a truck leaves at any second of the day with the same
chance. On a peaked one half of them leave around 06:00 (normal, 1 h), a quarter around 18:00
(normal, 1.5 h), each cut at midnight, and a quarter at any time.
"""

from __future__ import annotations

import math
import os
from datetime import date, datetime, time, timedelta
from pathlib import Path
from typing import Any, Literal, get_args

import numpy as np
from numpy.typing import NDArray

from ...errors import ScenarioError, brief
from ...kinds import is_number, is_whole, kind_of
from ...network.road_network import RoadNetwork
from ...plans.trip import LONGEST_MIN, Trip
from .demand import Demand, demand_in, gravity_demand

__all__ = ["Day", "draw_trips"]

Day = Literal["uniform", "peaked"]

DAY_S = 86_400
PEAKS_S = ((0.5, 6 * 3600, 3600), (0.25, 18 * 3600, 5400))
"""Share of all, middle and standard deviation of each peak [s]; the others are spread evenly."""

MOST = 1_000_000


def draw_trips(
    net: RoadNetwork,
    number: int = 1000,
    *,
    flows: str | os.PathLike[str] | None = None,
    day: Day = "uniform",
    flexibility_min: float = 30.0,
    min_km: float = 100.0,
    on: date | None = None,
    seed: int = 0,
) -> tuple[Trip, ...]:
    """Draw a day of trips.

    Parameters
    ----------
    net : RoadNetwork
        Where they drive.
    number : int
        How many.
    flows : str or path-like, optional
        CSV of truck volumes with `origin`, `destination`, `volume`; places are ids of the
        network's nodes, ids that stand in `segments.csv` beside the file, or names. Without flows
        trucks go between the towns of the map by the gravity rule of `demand`.
    day : {"uniform", "peaked"}
        When they leave.
    flexibility_min : float
        How much longer than alone each may take [min].
    min_km : float
        Shorter ways are not drawn [km].
    on : date, optional
        The day; by default 2026-03-02, a Monday.
    seed : int
        Of the draws.

    Returns
    -------
    tuple of Trip
        By departure, with names in that order; each has a route.

    Raises
    ------
    PlatoonError
        A number that is none, flows that cannot be read, or no way that is long enough.
    """
    begin = _checked(net, number, day, flexibility_min, min_km, on, seed)
    demand = gravity_demand(net) if flows is None else demand_in(_path(flows), net)
    row = _rows(demand, number, min_km, seed)
    leaves = _departures(number, day, seed)
    digits = len(str(number))
    order = np.argsort(leaves, kind="stable")
    return tuple(
        Trip(
            f"truck {place:0{digits}d}",
            demand.places[demand.origin[row[k]]],
            demand.places[demand.destination[row[k]]],
            earliest_departure=begin + timedelta(seconds=int(leaves[k])),
            flexibility_min=float(flexibility_min),
        )
        for place, k in enumerate(order.tolist(), 1)
    )


def _rows(demand: Demand, number: int, min_km: float, seed: int) -> NDArray[np.int64]:
    """Draw the flow of each trip."""
    far = np.flatnonzero(demand.length_m >= min_km * 1000)
    if not len(far):
        most = float(demand.length_m.max()) / 1000
        raise ScenarioError(
            f"trips: no way is {min_km:g} km long, the longest {most:.0f} km; take a shorter min_km"
        )
    weight = demand.weight[far]
    chosen = np.random.default_rng([seed, 0]).choice(len(far), number, p=weight / weight.sum())
    return far[chosen]


def _departures(number: int, day: Day, seed: int) -> NDArray[np.int64]:
    """Draw when each leaves [s of the day]."""
    rng = np.random.default_rng([seed, 1])
    leaves = rng.random(number) * DAY_S
    if day == "peaked":
        which = rng.random(number)
        spread = rng.standard_normal(number)
        begin = 0.0
        for share, middle, deviation in PEAKS_S:
            own = (which >= begin) & (which < begin + share)
            leaves[own] = middle + deviation * spread[own]
            begin += share
    found: NDArray[np.int64] = np.clip(leaves, 0, DAY_S - 1).astype(np.int64)
    return found


def _path(flows: Any) -> Path:
    if not isinstance(flows, str | os.PathLike):
        raise ScenarioError(f"trips: flows are {kind_of(flows)}; give the name of a CSV file")
    return Path(flows)


def _checked(
    net: Any, number: Any, day: Any, flexibility_min: Any, min_km: Any, on: Any, seed: Any
) -> datetime:
    """Check what was given and return when the day begins."""
    if not isinstance(net, RoadNetwork):
        raise ScenarioError(f"trips: net is a {kind_of(net)}; give a network, from load_network")
    if not (is_whole(number) and 1 <= number <= MOST):
        raise ScenarioError(
            f"trips: number is {brief(number)}; give a whole number from 1 to {MOST:,}"
        )
    if day not in get_args(Day):
        raise ScenarioError(f"trips: day {brief(day)} is unknown; use {', '.join(get_args(Day))}")
    for label, value, most in (
        ("flexibility_min", flexibility_min, LONGEST_MIN), ("min_km", min_km, math.inf),
    ):  # fmt: skip
        if not (is_number(value) and 0 <= value <= most and math.isfinite(value)):
            raise ScenarioError(f"trips: {label} is {brief(value)}; give a number, 0 or more")
    if not (is_whole(seed) and seed >= 0):
        raise ScenarioError(f"trips: seed is {brief(seed)}; give a whole number, 0 or more")
    if on is None:
        return datetime(2026, 3, 2)
    if not isinstance(on, date) or on.year >= 9000:
        raise ScenarioError(f"trips: on is {brief(on)}; give a date, such as date(2026, 3, 2)")
    return datetime.combine(on, time())
