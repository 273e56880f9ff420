"""Lanes: chains of edges in whole numbers, one for each kind of vehicles."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from random_networks import problems

from platoon_osm.errors import ScenarioError
from platoon_osm.fleets.company_costs import company_line
from platoon_osm.fleets.instance import Instance
from platoon_osm.fleets.lanes import ROOM, TICK_S, grains_per_unit, lanes_of
from platoon_osm.planning.fleet import Fleet


@settings(max_examples=40, deadline=None)
@given(problems(), st.integers(0, 3))
def test_every_lane_is_the_sum_of_its_edges(problem, largest):
    net, weights, trips = problem
    largest = largest if largest > 1 else 0
    fleet = Fleet.alike(net, weights, len(trips))
    ends = [0, net.n - 1]
    grains = 1e6
    lanes = lanes_of(net, fleet, [0] * len(trips), ends, largest, grains)
    member, extra = company_line(weights, largest)
    driven = []
    for lane in range(len(lanes.tail)):
        edges = lanes.edges[lanes.first_edge[lane] : lanes.first_edge[lane + 1]]
        driven += edges.tolist()
        assert lanes.nodes[lanes.tail[lane]] == net.tail[edges[0]]
        assert lanes.nodes[lanes.head[lane]] == net.head[edges[-1]]
        assert (net.head[edges[:-1]] == net.tail[edges[1:]]).all()
        seconds = fleet.drive_s((0,))[edges].sum()
        assert 0 <= lanes.drive[lane] * TICK_S - seconds + 1e-9 <= TICK_S + 1e-9
        assert abs(lanes.alone[lane] - weights.solo[edges].sum() * grains) <= 0.5
        assert 0 <= lanes.extra[lane] <= lanes.alone[lane] - lanes.member[lane]
        if (2 * member + extra < 2 * weights.solo)[edges].all():
            assert abs(lanes.member[lane] - member[edges].sum() * grains) <= 0.5
    assert len(set(driven)) == len(driven)
    # What is left out leads from a place back to it.
    assert set(ends) <= {*lanes.nodes.tolist(), 0, net.n - 1}


@settings(max_examples=30, deadline=None)
@given(problems())
def test_carriers_have_lanes_of_their_own(problem):
    net, weights, _ = problem
    fleet = Fleet.alike(net, weights, 3)
    one = lanes_of(net, fleet, [0, 0, 0], [0, 1], 0, 1e3)
    two = lanes_of(net, fleet, [0, 1, 0], [0, 1], 0, 1e3)
    assert len(two.tail) == 2 * len(one.tail)
    assert two.lane_kind.tolist() == [0] * len(one.tail) + [1] * len(one.tail)
    np.testing.assert_array_equal(two.alone, np.tile(one.alone, 2))


@pytest.mark.parametrize("total", [0.0, 0.3, 1e3, 7e8, 3e13])
def test_all_costs_stay_whole(total):
    grains = grains_per_unit(total)
    assert total * grains <= ROOM
    assert np.log10(grains) == round(np.log10(grains))


def tiny(**changed):
    ones = np.ones(1, np.int64)
    own = dict(  # noqa: C408 - as fields are named elsewhere
        nodes=2, tail=0 * ones, head=ones, drive=ones, alone=10 * ones, member=9 * ones,
        extra=ones, lane_kind=0 * ones, origin=0 * ones, destination=ones, earliest=0 * ones,
        latest_departure=5 * ones, latest=6 * ones, kind=0 * ones, largest=0, given=True,
        waiting=0, first_pair=np.array([0, 1]), pair_truck=0 * ones, pair_lane=0 * ones,
        opens=0 * ones, closes=5 * ones, on_alone=np.ones(1, bool), alone_cost=10 * ones,
    )  # fmt: skip
    return Instance(**{**own, **changed})


def test_an_instance_is_read_only_and_tells_what_a_leader_saves():
    found = tiny(extra=np.array([0]))
    assert (found.trucks, found.lanes, found.pairs) == (1, 1, 1)
    assert found.leader_saves.tolist() == [1]
    with pytest.raises(ValueError, match="read-only"):
        found.tail[0] = 1


@pytest.mark.parametrize(
    ("changed", "match"),
    [
        ({"drive": np.array([0])}, "takes no time"), ({"largest": 1}, "largest must be"),
        ({"waiting": -1}, "waiting 0 or more"), ({"extra": np.array([2])}, "costs more than"),
        ({"extra": np.array([-1])}, "costs more than"),
        ({"member": np.array([4])}, "more than half"),
        ({"head": np.array([1, 1])}, "differ in size"),
        ({"alone_cost": np.array([2**60])}, "too large"),
    ],
)  # fmt: skip
def test_what_is_not_proved_is_refused(changed, match):
    with pytest.raises(ScenarioError, match=match):
        tiny(**changed)
