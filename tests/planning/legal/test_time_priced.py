"""Prices of waiting and delay under the law: what they change, added up from the pages' times."""

import random
from datetime import datetime, timedelta

import pytest
from soak import chosen

import platoon_osm as po

NORTH = ("Milano", "Torino", "Venezia", "Brescia", "Genova", "Verona")
SOUTH = ("Roma", "Napoli", "Firenze", "Ancona")
TRUE_OF_CHOICE = "prices of waiting and delay count in the choice, not in the cost"


class Priced:
    """The paper's costs, and prices of time."""

    name, unit, params = "priced", "m", {}

    def __init__(self, waiting=0.0, delay=0.0):
        self.of, self.w, self.d = po.PaperCosts(), waiting, delay

    def weights(self, net, vehicle=None):
        return self.of.weights(net, vehicle)

    def waiting(self, seconds):
        return self.w * seconds

    def delay(self, seconds):
        return self.d * seconds


@pytest.fixture(scope="module")
def net():
    return po.load_network("italy-motorways")


def trips_of(seed):
    rng = random.Random(seed)
    first = datetime(2026, 3, 3, rng.randrange(4, 9))
    found = []
    for k in range(rng.choice([2, 3])):
        leaves = first + timedelta(minutes=rng.randrange(0, 120))
        latest = leaves if rng.random() < 0.7 else None
        ends = rng.choice(NORTH), rng.choice(SOUTH)
        found.append(po.Trip(f"v{k}", *ends, leaves, latest_departure=latest))
    return found


def times_alone(net, trips):
    """How long each stands on its legal way alone, and takes from its earliest departure [s]."""
    for trip in trips:
        own = po.plan_joint(net, Priced(), [trip], rules="eu561").timetable.vehicles[0]
        yield own.waiting_s, own.arrival_s - own.earliest_departure_s


def priced(plan, prices, alone):
    """A plan's cost with what its waiting and delay cost, from its timetable."""
    total = plan.joint_cost
    for times, (stands, takes) in zip(plan.timetable.vehicles, alone, strict=True):
        total += prices.w * max(0.0, times.waiting_s - stands)
        total += prices.d * (times.arrival_s - times.earliest_departure_s - takes)
    return total


@pytest.mark.parametrize("seed", chosen((2, 3), range(60)))
def test_no_plan_that_knows_no_prices_is_cheaper_with_them(net, seed):
    trips = trips_of(seed)
    free = po.plan_joint(net, Priced(), trips, rules="eu561")
    alone = list(times_alone(net, trips))
    solo = sum(po.plan_joint(net, Priced(), [trip], rules="eu561").joint_cost for trip in trips)
    for prices in (Priced(30.0), Priced(10.0, 200.0)):
        plan = po.plan_joint(net, prices, trips, rules="eu561")
        pays = priced(plan, prices, alone)
        assert pays <= priced(free, prices, alone) + 1.0
        assert pays <= solo + 1.0
        assert not [one for one in po.inspect_plan(plan) if one.violation.article != "window"]
        assert "waiting at merging points is free" not in plan.proof.conditions
        if TRUE_OF_CHOICE not in plan.proof.conditions:
            # Nobody pays for time, so what is proved without prices holds with them.
            assert pays == pytest.approx(plan.joint_cost, abs=1.0)
            assert plan.joint_cost == pytest.approx(free.joint_cost)
            assert plan.proof.kind == free.proof.kind
        assert plan.proof.bound is None or plan.proof.bound <= plan.joint_cost + 1e-6


def test_dear_time_ends_waiting_and_delay(net):
    six = datetime(2026, 3, 3, 6)
    starts = ("Milano", "Torino", "Venezia", "Brescia")
    trips = [po.Trip(one, one, "Napoli", six, latest_departure=six) for one in starts]
    alone = list(times_alone(net, trips))
    saved, late = [], []
    for price in (0.0, 20.0, 300.0):
        plan = po.plan_joint(net, Priced(0.0, price), trips, rules="eu561")
        saved.append(plan.saving)
        times = zip(plan.timetable.vehicles, alone, strict=True)
        late.append(
            sum(one.arrival_s - one.earliest_departure_s - takes for one, (_, takes) in times)
        )
    assert saved[0] > saved[1] > saved[2] > 0
    assert late[0] > late[1] > late[2] >= -1
