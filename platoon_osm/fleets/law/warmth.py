"""The searches within the law, compiled before anybody waits for them."""

from __future__ import annotations

import numpy as np

from ...driving.eu561 import EU561
from ...driving.state import RESTED
from ...planning.legal.driver.kernel import LABELS
from ...planning.legal.driver.road import NO_LIMIT, road_of
from ...planning.legal.platoon.star_times import Span, VehicleRules
from ...planning.legal.way_points import WayPoint, WayPoints
from .compiled import JOINING
from .driven import Occupied
from .response import Truck
from .ways import LaneWay

__all__ = ["warm_up"]


def warm_up() -> None:
    """Have all compiled from now on, by letting one truck join another on a road of two lanes."""
    LABELS.now()
    JOINING.now()
    points = WayPoints(
        road_of([3600] * 4, [NO_LIMIT] * 5), tuple(WayPoint(at, 0.0) for at in range(5))
    )
    way = LaneWay(np.arange(2), points, np.array([0, 2, 4]))
    truck = Truck(0, way, VehicleRules(EU561, RESTED, 0), Span(0, 3600, 86_400), 0)
    cost = np.array([100, 100])
    occupied = Occupied(cost, cost - 10, 0 * cost + 10, 0)
    alone = truck.fastest()
    assert alone is not None
    occupied.enter(1, alone)
    truck.best(occupied)
