"""A plan laid out for drawing: whole edges, on a network cut where its ways begin and end."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from placed_trips import COSTS, at, carriageways, planned, problems

from platoon_osm.network.geodesy import distance_m
from platoon_osm.planning.joint import plan_joint
from platoon_osm.plans.laid_out import laid_out
from platoon_osm.plans.plan import Plan
from platoon_osm.plans.trip import Trip


@settings(max_examples=60, deadline=None)
@given(problems(), st.sampled_from(["A", "B", "C", "best"]))
def test_stretches_are_whole_edges_that_follow_each_other(problem, case):
    net, trips = problem
    plan = planned(net, trips, case)
    if plan is None:
        return
    plan = Plan.from_dict(plan.to_dict())
    laid, cut = laid_out(plan, net)
    for vehicle, was in zip(laid.vehicles, plan.vehicles, strict=True):
        edges = list(vehicle.edges)
        assert np.array_equal(cut.head[edges[:-1]], cut.tail[edges[1:]])
        alone = list(vehicle.alone.edges)
        assert np.array_equal(cut.head[alone[:-1]], cut.tail[alone[1:]])
        for route, length in ((edges, was.length_m), (alone, was.alone.length_m)):
            assert cut.length_m[route].sum() == pytest.approx(length, rel=1e-3)
            start, end = cut.tail[route[0]], cut.head[route[-1]]
            for node, stop in ((start, was.origin), (end, was.destination)):
                assert distance_m(cut.lon[node], cut.lat[node], stop.lon, stop.lat) < 1.0
        for leg, leg_was in zip(vehicle.legs, was.legs, strict=True):
            assert (leg.role, leg.length_m, leg.cost) == (
                leg_was.role, leg_was.length_m, leg_was.cost
            )  # fmt: skip
            assert leg.span == (0.0, 1.0)
            assert cut.length_m[list(leg.edges)].sum() == pytest.approx(leg.length_m, rel=1e-3)
    assert laid.network == plan.network
    assert laid.events == plan.events


def test_a_plan_between_nodes_is_laid_out_already():
    net = carriageways()
    plan = plan_joint(net, COSTS, [Trip("A", 0, 2), Trip("B", 1, 3)])
    assert laid_out(plan, net) == (plan, net)


def test_a_line_is_trimmed_to_its_place():
    net = carriageways()
    plan = plan_joint(net, COSTS, [Trip("A", at(30_000), at(150_000, -4_000))])
    laid, cut = laid_out(plan, net)
    road, way = laid.stretches
    line = cut.path_shape(road.edges)
    assert line[0] == pytest.approx(at(30_000), abs=1e-6)
    assert cut.path_shape(way.edges)[-1] == pytest.approx(at(150_000, -4_000), abs=1e-6)
    assert cut.path_shape(way.edges)[0] == pytest.approx(line[-1], abs=1e-9)
