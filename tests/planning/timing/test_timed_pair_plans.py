"""Plans of two vehicles with free routes and times: in time, proven, and no dearer than others."""

from dataclasses import replace
from datetime import datetime, timedelta

from hypothesis import given, settings
from hypothesis import strategies as st
from random_networks import network, road_networks

import platoon_osm as po
from platoon_osm.planning.answers import IN_TIME, ONE_LEADER

FIRST = datetime(2026, 3, 2, 6)


def leaving(trip, minutes, flexible):
    return replace(
        trip, earliest_departure=FIRST + timedelta(minutes=minutes), flexibility_min=flexible
    )


@st.composite
def timed_pairs(draw):
    net = draw(road_networks())
    trips = []
    for name in "AB":
        origin = draw(st.integers(0, net.n - 1))
        trip = po.Trip(name, origin, (origin + draw(st.integers(1, net.n - 1))) % net.n)
        if draw(st.integers(0, 5)):
            trip = leaving(trip, draw(st.integers(0, 90)), draw(st.integers(0, 60)))
        trips.append(trip)
    return net, po.paper_weights(net, tau=1.0, xi=0.18, fuel_saving=0.18), trips


def cost_in_time(plan):
    times = plan.timetable
    assert times is None or times.feasible
    return plan.joint_cost


@settings(max_examples=60, deadline=None)
@given(timed_pairs())
def test_pairs_are_in_time_and_no_master_does_better(case):
    net, weights, trips = case
    plan = po.plan_joint(net, weights, trips, "D", objective="system")
    cost = cost_in_time(plan)
    assert plan.proof.kind == "exact"
    assert cost <= cost_in_time(po.plan_joint(net, weights, trips, "C")) * (1 + 1e-9)
    assert cost <= plan.solo_cost * (1 + 1e-9)
    free = [po.Trip(trip.vehicle, trip.origin, trip.destination) for trip in trips]
    blind = po.plan_joint(net, weights, free, "D", objective="system")
    assert cost >= blind.joint_cost * (1 - 1e-9)
    assert (IN_TIME in plan.proof.conditions) == (cost > blind.joint_cost * (1 + 1e-9))


def detour():
    """A quick and dear road between two junctions beside a slow and cheap one, and both trips."""
    net = network([0, 0, 1, 1], [1, 1, 2, 2], [60e3, 66e3, 50e3, 50e3])
    net = net.with_columns(speed_mps=[10.0, 20.0, 20.0, 20.0])
    return net, [po.Trip("A", 0, 2), po.Trip("B", 0, 2)]


def roads(plan):
    return [edge for k in plan.ways[0] for edge in plan.stretches[k].edges]


def test_together_they_take_the_quick_road_where_the_cheap_one_is_too_slow():
    net, trips = detour()
    weights = po.EdgeWeights(
        *(net.length_m * share for share in (1.0, 0.8, 0.8)), unit="m", params={}
    )
    for late, first in ((0, 0), (30, 0), (31, 1)):
        given = [leaving(trips[0], 0, 30), leaving(trips[1], late, 60)]
        plan = po.plan_joint(net, weights, given, "D")
        assert plan.proof.kind == "exact"
        assert plan.timetable.feasible
        assert roads(plan)[0] == first
        assert len(plan.stretches) == 1, late


class PricedWaiting(po.PaperCosts):
    """The paper's costs, and a price of waiting."""

    def waiting(self, seconds):
        return 0.5 * seconds


def test_a_price_of_waiting_decides_who_is_waited_for():
    net, trips = detour()
    must = replace(
        trips[0], earliest_departure=FIRST, latest_departure=FIRST,
        latest_arrival=FIRST + timedelta(hours=9),
    )  # fmt: skip
    costs = PricedWaiting(tau=1.0, xi=0.18)
    for minutes, together in ((0, True), (1, True), (600, False)):
        given = [must, leaving(trips[1], minutes, 600)]
        plan = po.plan_joint(po.Problem(net, given, costs, case="D"))
        assert (plan.joint_cost < plan.solo_cost) == together
        assert sum(plan.timetable.vehicles[0].waits) == (60 * minutes if together else 0)
        assert "waiting at merging points is free" not in plan.proof.conditions


def test_vehicles_of_two_kinds_meet_behind_the_bridge_and_one_leads():
    # Only the van fits under the bridge between 1 and 2; the road around it takes it too long.
    net = network([0, 1, 1, 2, 3], [1, 2, 3, 3, 4], [40e3, 40e3, 200e3, 40e3, 40e3])
    columns = {name: getattr(net, name) for name in ("tail", "head", "length_m", "lon", "lat")}
    net = po.RoadNetwork.from_edges(**columns, restriction=["", "maxheight=3.5", "", "", ""])
    trips = [po.Trip("van", 0, 4, profile="van-3.5t"), po.Trip("truck", 1, 4)]
    costs = po.paper_weights(net, tau=1.0, xi=0.18, positions="nacfe")
    saved = set()
    for late in range(0, 480, 60):
        given = [leaving(trips[0], 0, 240), leaving(trips[1], late, 60)]
        plan = po.plan_joint(net, costs, given, "D", objective="system")
        assert plan.timetable.feasible
        assert plan.proof.kind == "exact"
        if IN_TIME in plan.proof.conditions:
            assert ONE_LEADER in plan.proof.conditions
        saved.add(plan.joint_cost < plan.solo_cost)
    assert saved == {True, False}
