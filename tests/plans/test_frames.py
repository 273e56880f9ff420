"""Plans as frames: what the record says, with units, for every kind of plan."""

from datetime import datetime

import pytest
from hypothesis import given, settings
from random_networks import network, problems

import platoon_osm as po
from platoon_osm.plans.frames import FRAMES, TIMED
from platoon_osm.plans.money_frames import MONEY_FRAMES

TRIPS = [po.Trip("A", 0, 3, datetime(2026, 3, 2, 6)), po.Trip("B", 4, 5)]


@pytest.fixture(scope="module")
def plan():
    net = network([0, 1, 2, 2, 4], [1, 2, 3, 5, 1], [10e3] * 5)
    return po.plan_joint(net, po.paper_weights(net), TRIPS, "C", master="A")


def test_vehicles_add_up_to_the_plan(plan):
    frame = plan.to_frame()
    assert list(frame["vehicle"]) == ["A", "B"]
    assert frame["cost_m_eq"].sum() == pytest.approx(plan.joint_cost)
    assert frame["alone_cost_m_eq"].sum() == pytest.approx(plan.solo_cost)
    assert frame["length_km"].tolist() == pytest.approx([30, 30])
    assert frame["platoon_km"].tolist() == pytest.approx([10, 10])
    assert frame["driving_h"].tolist() == pytest.approx([0.375, 0.375])


def test_stretches_are_the_legs_of_vehicles(plan):
    frame = plan.to_frame("stretches")
    assert len(frame) == sum(len(way) for way in plan.ways)
    together = frame[frame["role"] == "platoon"]
    assert together["stretch"].nunique() == 1
    assert sorted(together["position"]) == [1, 2]
    assert (together["company_size"] == 2).all()
    for vehicle in plan.vehicles:
        own = frame[frame["vehicle"] == vehicle.vehicle]
        assert own["cost_m_eq"].sum() == pytest.approx(vehicle.joint_cost)
        assert (own["begins_km"] + own["length_km"]).iloc[-1] == pytest.approx(30)


def test_points_and_times(plan):
    points = plan.to_frame("points")
    assert list(points["kind"]) == ["start", "destination", "start", "merge", "separation",
                                    "destination"]  # fmt: skip
    assert points["at_km"].tolist() == pytest.approx([0, 30, 0, 10, 20, 30])
    times = plan.to_frame("timetable")
    assert times["start"].iloc[0] == datetime(2026, 3, 2, 6)
    assert (times["end"] > times["start"]).all()
    assert len(times) == len(plan.to_frame("stretches"))


def test_what_a_plan_cannot_be_shown_as(plan):
    with pytest.raises(po.ScenarioError, match="use one of vehicles"):
        plan.to_frame("trucks")
    net = network([0], [1], [10e3])
    untimed = po.plan_joint(net, po.paper_weights(net), [po.Trip("A", 0, 1)], "C")
    for what in ("timetable", "pauses"):
        with pytest.raises(po.ScenarioError, match="no times"):
            untimed.to_frame(what)


@settings(max_examples=25, deadline=None)
@given(problems())
def test_frames_of_any_plan(problem):
    net, weights, trips, *_ = problem
    try:
        plan = po.plan_joint(net, weights, trips)
    except po.PlatoonError:
        return
    for what in FRAMES:
        if what in MONEY_FRAMES and getattr(plan, what) is None:
            continue
        if what not in TIMED or plan.timetable is not None:
            least = 0 if what in ("pauses", "platoons") else len(trips)
            assert len(plan.to_frame(what)) >= least
    assert plan.to_frame()[f"cost_{plan.unit.replace('m', 'm_eq')}"].sum() == pytest.approx(
        plan.joint_cost
    )


def test_reprs_are_short(plan):
    net = network([0, 1], [1, 0], [10e3, 10e3])
    trips = [po.Trip(f"v{k}" * 40, 0, 1) for k in range(60)]
    weights = po.paper_weights(net)
    many = po.plan_joint(net, weights, trips, "C")
    problem = po.Problem(net, trips, weights)
    for thing in (many, problem, weights, net.locate(0), net, trips[0], plan):
        assert len(repr(thing)) < 400
        assert "\n" not in repr(thing)
