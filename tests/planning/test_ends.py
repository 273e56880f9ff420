"""From places to nodes: which carriageway a trip takes."""

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from oracles import all_pairs
from random_networks import network, road_networks

from platoon_osm.costs.paper import paper_weights
from platoon_osm.errors import NoRouteError, ScenarioError
from platoon_osm.network.location import Location
from platoon_osm.planning.ends import ACCESS_DETOUR, resolve_trips
from platoon_osm.planning.fleet import Fleet
from platoon_osm.planning.joint import plan_joint
from platoon_osm.plans.trip import Trip
from platoon_osm.search.dijkstra import ReferenceEngine
from platoon_osm.search.trees import Trees


def place(name, *candidates):
    # Places of different names lie apart, as they do on a map.
    lon = 9.0 + sum(map(ord, name)) / 1000
    return Location(candidates[0][0], name, lon, 45.0, 0.0, tuple(candidates))


def resolve(net, *trips):
    weights = paper_weights(net)
    fleet = Fleet.alike(net, weights, len(trips))
    trees = [Trees(ReferenceEngine(net, weights.solo))] * len(trips)
    return resolve_trips(net, fleet, trees, trips)


@pytest.fixture
def two_carriageways():
    """Eastbound 0 -> 1 -> 2, westbound 5 -> 4 -> 3, and a turn from 2 to 5."""
    return network([0, 1, 2, 4, 5], [1, 2, 5, 3, 4], [10e3, 10e3, 100, 10e3, 10e3])


def test_each_direction_takes_its_own_carriageway(two_carriageways):
    west = place("West", (0, 0.0), (3, 0.0))
    middle = place("Middle", (1, 0.0), (4, 0.0))
    east = place("East", (2, 0.0), (5, 0.0))
    there, back, inner = resolve(
        two_carriageways,
        Trip("there", west, middle), Trip("back", east, west), Trip("inner", middle, west),
    )  # fmt: skip
    assert (there.origin, there.destination) == (0, 1)
    assert (back.origin, back.destination) == (5, 3)
    assert (inner.origin, inner.destination) == (4, 3)
    assert there.origins == {0, 3}
    assert there.destinations == {1, 4}
    assert (there.origin_name, there.destination_name) == ("West", "Middle")


def test_access_counts_with_a_detour(two_carriageways):
    # From 1 one saves 10 km of motorway; that pays for 7 km as the crow flies, not for 8.
    for away, origin in ((7_000.0, 1), (8_000.0, 0)):
        assert (away * ACCESS_DETOUR < 10_000) == (origin == 1)
        start = place("Start", (0, 0.0), (1, away))
        (ends,) = resolve(two_carriageways, Trip("A", start, 2))
        assert ends.origin == origin


@settings(max_examples=40, deadline=None)
@given(road_networks(), st.data())
def test_the_pair_with_the_least_way(net, data):
    weights = paper_weights(net)
    way = all_pairs(net, weights.solo)
    node, metres = st.integers(0, net.n - 1), st.floats(0, 50_000)
    candidates = st.lists(st.tuples(node, metres), min_size=1, max_size=4, unique_by=lambda c: c[0])
    start = data.draw(candidates)
    end = [(v, m) for v, m in data.draw(candidates) if v not in {u for u, _ in start}]
    if not end:
        return
    (ends,) = resolve(net, Trip("A", place("S", *start), place("E", *end)))
    per_metre = ACCESS_DETOUR * 37 / 12

    def total(origin, destination):
        access = dict(start)[origin] + dict(end)[destination]
        return way[origin][destination] + per_metre * access

    least = min(total(o, d) for o, _ in start for d, _ in end)
    assert total(ends.origin, ends.destination) == pytest.approx(least)


def test_two_places_that_share_a_node_do_not_meet_in_it(two_carriageways):
    # Node 1 is 5 km from both places; driving nowhere is no trip.
    west, east = place("West", (0, 0.0), (1, 5e3)), place("East", (2, 0.0), (1, 5e3))
    (ends,) = resolve(two_carriageways, Trip("A", west, east))
    assert ends.origin != ends.destination


def test_case_a_sees_the_other_nodes_of_a_destination():
    # 0 -> 1 -> 2 is the road; the town has the junction node 1 and a gate 3 beyond it.
    net = network([0, 1, 1], [1, 2, 3], [50e3, 50e3, 1e3])
    town = place("Town", (3, 0.0), (1, 9e3))
    plan = plan_joint(net, paper_weights(net), [Trip("A", 0, 2), Trip("B", 0, town)], "A")
    member = plan.vehicles[1]
    assert member.destination.node == 3
    assert (member.merge.node, member.separation.node) == (0, 1)


@pytest.mark.parametrize("same", [(4, 4), (place("X", (4, 0.0)), 4)])
def test_origin_equals_destination(two_carriageways, same):
    with pytest.raises(ScenarioError, match="trip 'A': origin and destination are the same place"):
        resolve(two_carriageways, Trip("A", *same))


def test_one_place_by_two_ways_of_saying_it(two_carriageways):
    trip = Trip("A", place("Town", (0, 0.0), (3, 1.0)), place("Town", (3, 0.0), (0, 1.0)))
    with pytest.raises(ScenarioError, match=r"same place \(Town\)"):
        resolve(two_carriageways, trip)


def test_no_way_names_both_ends_and_the_network(two_carriageways):
    with pytest.raises(NoRouteError, match=r"^trip 'A': no route from West to .* in memory") as e:
        resolve(two_carriageways, Trip("A", place("West", (3, 0.0)), 0))
    assert "\n" not in str(e.value)


def test_names_must_differ(two_carriageways):
    with pytest.raises(ScenarioError, match="vehicle 'B' has 2 trips; names must differ"):
        plan_joint(
            two_carriageways, paper_weights(two_carriageways),
            [Trip("A", 0, 1), Trip("B", 0, 1), Trip("B", 0, 2)],
        )  # fmt: skip


def test_one_spot_is_one_place_even_if_its_ends_snap_to_two_nodes(two_carriageways):
    start = Location(0, "exit 1", 9.0, 45.0, 10.0, ((0, 10.0),))
    end = Location(1, "exit 2", 9.0, 45.0, 10.0, ((1, 10.0),))
    with pytest.raises(ScenarioError, match="same place"):
        resolve(two_carriageways, Trip("A", start, end))
