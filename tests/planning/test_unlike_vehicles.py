"""Vehicles that may not drive the same roads, in one plan; against searches on cut networks."""

import networkx as nx
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from random_networks import network, road_networks

import platoon_osm as po
from platoon_osm.errors import NoRouteError, ScenarioError
from platoon_osm.planning.cases import best_pairs, running_sum
from platoon_osm.plans.trip import Trip

SOME = settings(max_examples=40)
WEST, NORTH, SOUTH, EAST = range(4)
LOW = "maxheight=3.5"


def diamond(**columns):
    """West to east by north (20 km) or by south (30 km); each road both ways."""
    roads = [(WEST, NORTH, 10), (NORTH, EAST, 10), (WEST, SOUTH, 15), (SOUTH, EAST, 15)]
    both = roads + [(b, a, km) for a, b, km in roads]
    tails, heads, km = (np.array(column) for column in zip(*both, strict=True))
    net = network(tails, heads, km * 1000.0)
    return net, {
        (int(a), int(b)): k for k, (a, b) in enumerate(zip(net.tail, net.head, strict=True))
    }


def restricted(net, texts):
    """The same network with restrictions on some edges."""
    rows = [""] * net.m
    for edge, text in texts.items():
        rows[edge] = text
    columns = {name: getattr(net, name) for name in ("tail", "head", "length_m", "lon", "lat")}
    return po.RoadNetwork.from_edges(**columns, restriction=rows)


def way(plan, index=0):
    return [edge for k in plan.ways[index] for edge in plan.stretches[k].edges]


# -- one vehicle -----------------------------------------------------------------------------------


def test_a_low_bridge_is_driven_around_by_who_does_not_fit():
    net, at = diamond()
    net = restricted(net, {at[NORTH, EAST]: LOW})
    weights = po.paper_weights(net)
    trip = Trip("A", WEST, EAST)
    assert way(po.plan_joint(net, weights, [trip])) == [at[WEST, SOUTH], at[SOUTH, EAST]]
    low = po.plan_joint(net, weights, [trip], profile={"height_m": 3.4})
    assert way(low) == [at[WEST, NORTH], at[NORTH, EAST]]
    # The other direction has no such sign.
    back = po.plan_joint(net, weights, [Trip("A", EAST, WEST)])
    assert way(back) == [at[EAST, NORTH], at[NORTH, WEST]]


def test_a_trip_says_its_own_vehicle_before_the_plan():
    net, at = diamond()
    net = restricted(net, {at[NORTH, EAST]: "hgv=no"})
    trips = [Trip("van", WEST, EAST, profile="van-3.5t"), Trip("truck", WEST, EAST)]
    plan = po.plan_joint(net, po.paper_weights(net), trips, profile="eu-25m")
    assert way(plan, 0) == [at[WEST, NORTH], at[NORTH, EAST]]
    assert way(plan, 1) == [at[WEST, SOUTH], at[SOUTH, EAST]]


def test_a_road_for_residents_is_open_to_who_ends_there_alone():
    net, at = diamond()
    zone = dict.fromkeys(
        (at[WEST, NORTH], at[NORTH, WEST], at[NORTH, EAST], at[EAST, NORTH]), "hgv=destination"
    )
    net = restricted(net, zone)
    weights = po.paper_weights(net)
    through = po.plan_joint(net, weights, [Trip("A", WEST, EAST)])
    assert way(through) == [at[WEST, SOUTH], at[SOUTH, EAST]]
    there = po.plan_joint(net, weights, [Trip("A", WEST, NORTH)])
    assert way(there) == [at[WEST, NORTH]]
    away = po.plan_joint(net, weights, [Trip("A", NORTH, EAST)])
    assert way(away) == [at[NORTH, EAST]]


def test_a_member_does_not_follow_through_its_masters_zone():
    net, at = diamond()
    zone = dict.fromkeys((at[WEST, NORTH], at[NORTH, EAST]), "access=private")
    net = restricted(net, zone)
    trips = [Trip("host", NORTH, EAST), Trip("guest", WEST, EAST)]
    plan = po.plan_joint(net, po.paper_weights(net), trips)
    assert way(plan, 1) == [at[WEST, SOUTH], at[SOUTH, EAST]]


def test_without_any_open_road_the_reason_is_told():
    net, at = diamond()
    net = restricted(net, {at[NORTH, EAST]: LOW, at[SOUTH, EAST]: "maxweight=7.5"})
    with pytest.raises(NoRouteError) as caught:
        po.plan_joint(net, po.paper_weights(net), [Trip("A", WEST, EAST)])
    said = str(caught.value)
    assert "max. height 3.5 m" in said or "max. weight 7.5 t" in said
    assert "\n" not in said


def test_a_road_may_be_closed_to_see_what_happens():
    net, at = diamond()
    weights = po.paper_weights(net)
    trip = Trip("A", WEST, EAST)
    plan = po.plan_joint(net, weights, [trip], close=[at[NORTH, EAST]])
    assert way(plan) == [at[WEST, SOUTH], at[SOUTH, EAST]]
    for wrong in ("way 17", "edge 99", "A 99", "0, 0", 99, None, 1.5):
        with pytest.raises(ScenarioError, match="close"):
            po.plan_joint(net, weights, [trip], close=[wrong])


# -- several ---------------------------------------------------------------------------------------


@st.composite
def unlike(draw):
    """A network, three trips, and edges closed to each; every trip still has a route."""
    net = draw(road_networks(8))
    rng = np.random.default_rng(draw(st.integers(0, 2**32 - 1)))
    texts = {}
    for edge in range(net.m):
        if rng.random() < 0.35:
            texts[edge] = str(rng.choice(["maxheight=3.5", "maxweight=20", "hgv=no"]))
    net = restricted(net, texts)
    trips, shut = [], []
    for k, kind in enumerate(
        ({"height_m": 3.0, "mass_t": 40}, {"height_m": 4, "mass_t": 15}, "van-3.5t")
    ):
        allowed = {
            0: ("maxheight=3.5",),
            1: ("maxweight=20",),
            2: ("hgv=no", "maxheight=3.5", "maxweight=20"),
        }[k]
        closed = np.array([edge in texts and texts[edge] not in allowed for edge in range(net.m)])
        graph = nx.DiGraph(
            (int(a), int(b))
            for a, b, no in zip(net.tail, net.head, closed, strict=True)
            if not no and a != b
        )
        pairs = [(a, b) for a in graph for b in nx.descendants(graph, a)]
        if not pairs:
            continue
        a, b = pairs[int(rng.integers(len(pairs)))]
        trips.append(Trip(f"V{k}", a, b, profile=kind))
        shut.append(closed)
    return net, trips, shut


def least(net, weight, closed, source, target):
    graph = nx.DiGraph()
    graph.add_nodes_from(range(net.n))
    for e in np.flatnonzero(~closed).tolist():
        a, b, cost = int(net.tail[e]), int(net.head[e]), float(weight[e])
        if cost < graph.get_edge_data(a, b, {"w": np.inf})["w"]:
            graph.add_edge(a, b, w=cost)
    try:
        return nx.dijkstra_path_length(graph, source, target, "w")
    except nx.NetworkXNoPath:
        return np.inf


@SOME
@given(unlike(), st.sampled_from(["C", "best"]))
def test_nobody_drives_what_is_closed_to_it_and_nobody_pays_more_than_alone(problem, case):
    net, trips, shut = problem
    if not trips:
        return
    weights = po.paper_weights(net)
    plan = po.plan_joint(net, weights, trips, case)
    for index, (trip, closed) in enumerate(zip(trips, shut, strict=True)):
        edges = np.array(way(plan, index), int)
        assert not closed[edges].any()
        assert net.tail[edges[0]] == trip.origin
        assert net.head[edges[-1]] == trip.destination
        assert (net.tail[edges[1:]] == net.head[edges[:-1]]).all()
        alone = least(net, weights.solo, closed, trip.origin, trip.destination)
        assert plan.vehicles[index].solo_cost == pytest.approx(alone)
        assert plan.vehicles[index].joint_cost <= alone * (1 + 1e-9)
    assert plan.proof.any_plan <= plan.joint_cost * (1 + 1e-9)


@SOME
@given(unlike())
def test_the_points_of_unlike_members_are_the_best_on_the_cut_network(problem):
    net, trips, shut = problem
    if len(trips) < 2:
        return
    weights = po.paper_weights(net)
    plan = po.plan_joint(net, weights, trips, "C", master=trips[0].vehicle, company="master")
    route = np.array(way(po.plan_joint(net, weights, trips[:1])), int)
    nodes = net.path_nodes(route)
    for index, trip in enumerate(trips[1:], 1):
        closed = shut[index]
        entry = [least(net, weights.solo, closed, trip.origin, int(v)) for v in nodes]
        leave = [least(net, weights.solo, closed, int(v), trip.destination) for v in nodes]
        best = least(net, weights.solo, closed, trip.origin, trip.destination)
        for i in range(len(route)):
            for j in range(i + 1, len(route) + 1):
                if not closed[route[i:j]].any():
                    together = entry[i] + weights.platoon[route[i:j]].sum() + leave[j]
                    best = min(best, together)
        assert plan.vehicles[index].joint_cost == pytest.approx(best)


@SOME
@given(unlike())
def test_a_pair_of_unlike_vehicles_finds_the_best_shared_stretch(problem):
    net, trips, shut = problem
    if len(trips) < 2:
        return
    weights = po.paper_weights(net)
    two, (no, none) = trips[:2], shut[:2]
    plan = po.plan_joint(net, weights, two, "D", objective="system")
    ends = [(trip.origin, trip.destination) for trip in two]
    every = range(net.n)
    there = [
        [least(net, weights.solo, c, o, v) for v in every]
        for c, (o, _) in zip((no, none), ends, strict=True)
    ]
    onward = [
        [least(net, weights.solo, c, v, d) for v in every]
        for c, (_, d) in zip((no, none), ends, strict=True)
    ]
    best = there[0][ends[0][1]] + there[1][ends[1][1]]
    both = no | none
    for x in every:
        for y in every:
            shared = least(net, weights.platoon + weights.master, both, x, y)
            best = min(best, there[0][x] + there[1][x] + shared + onward[0][y] + onward[1][y])
    assert plan.joint_cost == pytest.approx(best)
    if not np.array_equal(no, none):
        assert "vehicles are alike" not in plan.proof.conditions


def test_the_slowest_decides_how_fast_a_platoon_is():
    net, _ = diamond()
    weights = po.paper_weights(net)
    slow = {"limiter_kmh": 60}
    trips = [Trip("A", WEST, EAST), Trip("B", WEST, EAST, profile=slow)]
    plan = po.plan_joint(net, weights, trips)
    alone = [trip.alone.time_s for trip in plan.trips]
    assert alone == pytest.approx([20_000 / (80 / 3.6), 20_000 / (60 / 3.6)])
    (stretch,) = plan.stretches
    assert len(stretch.vehicles) == 2
    assert stretch.drive_s == pytest.approx(alone[1])


def test_a_van_drives_as_posted_and_a_truck_as_trucks_may():
    net = po.RoadNetwork.from_edges(
        [0], [1], [30_000.0], lon=[9, 9.4], lat=[45, 45], speed_mps=[80 / 3.6],
        posted_mps=[130 / 3.6],
    )  # fmt: skip
    weights = po.paper_weights(net)
    times = [
        po.plan_joint(net, weights, [Trip("A", 0, 1)], profile=kind).trips[0].alone.time_s
        for kind in ("eu-40t", "van-3.5t", {"base": "van-3.5t", "limiter_kmh": 100})
    ]
    assert times == pytest.approx([30_000 / (v / 3.6) for v in (80, 130, 100)])


def test_the_kernel_and_the_barred_route_agree():
    # A road closed in the middle of the master's route: join before or after it, never across.
    platoon = running_sum(np.array([2.0, 2.0, 2.0]))
    bar = np.concatenate([[0.0], np.cumsum([0.0, 100.0, 0.0])])
    entry, leave = np.array([[0.0, 3, 6, 9]]), np.array([[9.0, 6, 3, 0]])
    i, j, _ = best_pairs(entry, leave, platoon + bar, running_sum(np.ones(3)), np.array([9.0]))
    assert (int(i[0]), int(j[0])) in {(0, 1), (2, 3)}


def test_a_plan_says_what_its_vehicles_are_like_and_what_they_pass_with_little_room():
    net, at = diamond()
    net = restricted(net, {at[NORTH, EAST]: "maxheight=4.05 maxweight=41"})
    weights = po.paper_weights(net)
    trips = [Trip("A", WEST, EAST), Trip("B", WEST, EAST, profile={"height_m": 3.4, "mass_t": 20})]
    plan = po.plan_joint(net, weights, trips)
    assert [trip.profile.height_m for trip in plan.trips] == [4.0, 3.4]
    tight = [remark for remark in plan.remarks if "of room" in remark]
    assert len(tight) == 2
    assert tight[0].startswith("A passes maxheight 4.05 m with 5 cm of room (a road, ")
    assert tight[1].startswith("A passes maxweight 41 t with 1.0 t of room (a road, ")
    text = plan.summary()
    assert "A: eu-40t, 4 m high, 2.55 m wide, 16.5 m long, 40 t, 11.5 t an axle, limiter" in text
    assert "B: like eu-40t, 3.4 m high" in text
    one = po.plan_joint(net, weights, trips[:1], close=[at[WEST, SOUTH]])
    assert "Vehicles: eu-40t, 4 m high" in one.summary()
    assert f"Closed for this plan: {at[WEST, SOUTH]}." in one.summary()


YARD, DEPOT = 4, 5


def with_yard(gate):
    """A ring road west-north-east-south, a gate from north to a yard, and open road to a depot."""
    roads = [(WEST, NORTH, 10), (NORTH, EAST, 10), (EAST, SOUTH, 15), (SOUTH, WEST, 15),
             (NORTH, YARD, 1), (YARD, DEPOT, 1)]  # fmt: skip
    both = roads + [(b, a, km) for a, b, km in roads]
    tails, heads, km = (np.array(column) for column in zip(*both, strict=True))
    net = network(tails, heads, km * 1000.0)
    at = {(int(a), int(b)): k for k, (a, b) in enumerate(zip(net.tail, net.head, strict=True))}
    return restricted(net, {at[NORTH, YARD]: gate, at[YARD, NORTH]: gate}), at


def test_a_yard_behind_a_private_gate_is_reached_by_its_own_trips():
    net, at = with_yard("access=private barrier=gate")
    weights = po.paper_weights(net)
    there = po.plan_joint(net, weights, [Trip("A", WEST, DEPOT)])
    assert way(there) == [at[WEST, NORTH], at[NORTH, YARD], at[YARD, DEPOT]]
    away = po.plan_joint(net, weights, [Trip("A", DEPOT, EAST)])
    assert way(away) == [at[DEPOT, YARD], at[YARD, NORTH], at[NORTH, EAST]]
    # Two of them meet behind the gate; who only passes by does not turn in.
    both = po.plan_joint(net, weights, [Trip("A", DEPOT, EAST), Trip("B", WEST, EAST)])
    assert way(both, 1) == [at[WEST, NORTH], at[NORTH, EAST]]


def test_a_gate_that_is_closed_stays_closed():
    net, _ = with_yard("access=no barrier=gate")
    with pytest.raises(NoRouteError, match="access=no at a gate"):
        po.plan_joint(net, po.paper_weights(net), [Trip("A", WEST, DEPOT)])


def test_a_place_is_looked_for_on_roads_that_are_open_to_the_vehicle():
    # Two parallel streets 2 km apart; the nearer one to the depot is closed to trucks.
    lon, lat = [9.0, 9.2, 9.0, 9.2], [45.0, 45.0, 45.018, 45.018]
    roads = [(0, 1), (1, 0), (2, 3), (3, 2), (0, 2), (2, 0), (1, 3), (3, 1)]
    net = po.RoadNetwork.from_edges(
        *zip(*roads, strict=True), lon=lon, lat=lat,
        restriction=["", "", "hgv=no", "hgv=no", "", "", "", ""], road_class=[4] * 8,
    )  # fmt: skip
    weights = po.paper_weights(net)
    depot = (9.1, 45.0181)
    truck = po.plan_joint(net, weights, [Trip("A", depot, 1)])
    van = po.plan_joint(net, weights, [Trip("A", depot, 1)], profile="van-3.5t")
    street = set(np.flatnonzero(net.restriction).tolist())
    assert not street & set(way(truck))
    assert street & set(way(van))
    assert van.trips[0].origin.edge in street
