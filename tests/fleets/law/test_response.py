"""One truck's best lawful trip beside the others, against every choice of company there is.

The oracle tries each company or none on each lane, and asks `small_law.drivable` whether the way
can be driven so: every departure and every whole second of standing, under laws of few seconds.
Where standing has a price, each departure is tried with the earliest arrival that it allows.
"""

import itertools
from functools import cache

import numpy as np
import pytest
from small_law import NO_PARTS, SMALL, Way, drivable
from soak import chosen, soaked

from platoon_osm.driving.state import RESTED, DriverState
from platoon_osm.fleets.law.driven import Occupied
from platoon_osm.fleets.law.response import Truck
from platoon_osm.fleets.law.ways import LaneWay
from platoon_osm.planning.legal.driver.road import NO_LIMIT, road_of
from platoon_osm.planning.legal.platoon.star_times import Span, VehicleRules
from platoon_osm.planning.legal.way_points import WayPoint, WayPoints


class Drawn:
    """A way of two to four lanes, a law, and companies on its lanes."""

    def __init__(self, seed):
        rng = np.random.default_rng(seed)
        self.limits = (SMALL, NO_PARTS)[int(rng.integers(2))]
        lanes = int(rng.integers(2, 5))
        sizes = rng.integers(1, 3, lanes)
        self.drive = rng.integers(1, 4, sizes.sum()).tolist()
        self.stay = [
            NO_LIMIT if rng.random() < 0.6 else 0 for _ in range(int(sizes.sum()) + 1)
        ]  # fmt: skip
        state = RESTED
        if rng.random() < 0.4:
            today = int(rng.integers(0, 6))
            state = DriverState(
                driven_since_break_s=int(rng.integers(0, min(today, 4) + 1)), driven_today_s=today,
                duty_s=today + int(rng.integers(0, 3)) if rng.random() < 0.5 else None,
            )  # fmt: skip
        self.rules = VehicleRules(self.limits, state, 0)
        self.first = np.concatenate([[0], np.cumsum(sizes)])
        road = road_of(self.drive, self.stay)
        points = tuple(WayPoint(k, 0.0) for k in range(len(self.stay)))
        self.way = LaneWay(np.arange(lanes), WayPoints(road, points), self.first)
        far = Truck(0, self.way, self.rules, Span(0, 60, 120), -1000).fastest()
        self.feasible = far is not None
        if far is None:
            return
        end = int(far.leaves[-1]) + self.drive[-1]
        self.span = Span(0, int(rng.integers(0, 6)), end + int(rng.integers(0, 7)))
        alone = rng.integers(50, 100, lanes)
        member = np.array([int(rng.integers(one // 2, one)) for one in alone])
        self.occupied = Occupied(alone, member, alone - member, int(rng.choice([0, 0, 2, 3])))
        self.offers = []
        for lane in range(lanes):
            begin, after = self.first[lane : lane + 2].tolist()
            own = {}
            for _ in range(int(rng.integers(0, 4))):
                at = int(rng.integers(0, self.span.arrival_s))
                moments = []
                for hop in range(begin, after):
                    if moments and rng.random() < 0.3:
                        at += int(rng.integers(1, 4))
                    moments.append(at)
                    at += self.drive[hop]
                own[tuple(moments)] = set(range(1, 1 + int(rng.integers(1, 4))))
            self.occupied.by_lane[lane] = own
            self.offers.append([None, *own])
        self.waiting, self.stands = int(rng.integers(1, 30)), int(rng.integers(0, 8))

    @cache  # noqa: B019 - a draw lives as long as its test
    def longer(self, chosen):
        """How much longer than for nothing it stands at least with some companies."""
        span, most = self.span, []
        for departs in range(span.earliest_s, span.latest_s + 1):
            for arrives in range(departs + sum(self.drive), span.arrival_s + 1):
                if self.drives(chosen, departs, arrives):
                    most.append(arrives - departs - sum(self.drive))
                    break
        return max(0, min(most) - self.stands)

    def drives(self, chosen, departs=None, arrives=None):
        """Whether the way can be driven with some companies, at a departure, till an arrival."""
        span, leave = self.span, []
        for lane, moments in enumerate(chosen):
            hops = int(self.first[lane + 1] - self.first[lane])
            leave += [None] * hops if moments is None else list(moments)
        if departs is not None:
            if leave[0] not in (None, departs):
                return False
            leave[0], span = departs, Span(span.earliest_s, span.latest_s, arrives)
        drive = tuple(self.drive)
        way = Way(drive, drive, tuple(self.stay), (*leave, None))
        return drivable(way, self.rules, span)

    def price(self, chosen):
        """What all pay more for a truck with some companies."""
        own = self.occupied
        return sum(
            own.more_for(lane, 0 if moments is None else len(own.by_lane[lane][moments]))
            for lane, moments in enumerate(chosen)
        )


@soaked
@pytest.mark.parametrize("seed", range(chosen(120, 6000)))
def test_the_best_of_all_choices_of_company(seed):
    drawn = Drawn(seed)
    if not drawn.feasible:
        return
    least = min(
        (drawn.price(some) for some in itertools.product(*drawn.offers) if drawn.drives(some)),
        default=None,
    )
    truck = Truck(0, drawn.way, drawn.rules, drawn.span, -1000)
    found = truck.best(drawn.occupied)
    whole = truck.best(drawn.occupied, width=0, dominance=False)
    if least is None:
        assert found is None
        assert whole is None
        return
    assert found is not None
    assert drawn.occupied.price(found) == least
    assert drawn.occupied.price(whole) == drawn.occupied.price(found)
    assert drawn.drives([moments for _, moments in found.entries()])
    assert truck.best(drawn.occupied, below=least) is None


def priced(drawn, found):
    """What all pay more for a timetable, its standing among it."""
    trip = found.trip
    assert trip.paused_s == trip.arrival_s - trip.departure_s - sum(drawn.drive)
    longer = max(0, trip.paused_s - drawn.stands)
    return drawn.occupied.price(found) + drawn.waiting * longer


@soaked
@pytest.mark.parametrize("seed", range(chosen(60, 6000)))
def test_the_best_of_all_where_standing_has_a_price(seed):
    drawn = Drawn(seed)
    if not drawn.feasible:
        return
    least = min(
        (
            drawn.price(some) + drawn.waiting * drawn.longer(some)
            for some in itertools.product(*drawn.offers)
            if drawn.drives(some)
        ),
        default=None,
    )
    truck = Truck(0, drawn.way, drawn.rules, drawn.span, -1000)
    asked = {"waiting": drawn.waiting, "stands_s": drawn.stands}
    found = truck.best(drawn.occupied, **asked)
    whole = truck.best(drawn.occupied, width=0, dominance=False, **asked)
    if least is None:
        assert found is None
        assert whole is None
        return
    assert priced(drawn, found) == priced(drawn, whole) == least
    assert drawn.drives(tuple(moments for _, moments in found.entries()))
    assert truck.best(drawn.occupied, below=least, **asked) is None


def test_most_draws_have_company_to_choose():
    some = [drawn for seed in range(60) if (drawn := Drawn(seed)).feasible]
    assert len(some) > 40
    assert sum(any(len(own) > 1 for own in drawn.offers) for drawn in some) > 30
