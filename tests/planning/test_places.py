"""Places between junctions and beside the road, against a graph that is split by hand.

The oracle is networkx on pieces of edges, and tries every merging and every separation point. It
shares nothing with the planner but the places on the road that `locate` found, which
`tests/network/test_road_points.py` holds to shapely.
"""

from itertools import pairwise, product

import networkx as nx
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from made_networks import both_ways
from made_networks import network as made
from placed_trips import COSTS, at, carriageways, planned, problems
from random_networks import road_networks

from platoon_osm.costs.paper import paper_weights
from platoon_osm.errors import PlatoonError, ScenarioError
from platoon_osm.network.geodesy import metres_per_degree
from platoon_osm.network.road_network import RoadNetwork
from platoon_osm.planning.joint import plan_joint
from platoon_osm.plans.plan import Plan
from platoon_osm.plans.trip import Trip

ALONE = COSTS.solo_factor()
DETOUR, ACCESS_MPS = 1.3, 50 / 3.6
MODERATE = settings(max_examples=40, deadline=None)


class Split:
    """A network with places, as a networkx graph made piece by piece."""

    def __init__(self, net, places):
        """Take locations by (vehicle, end)."""
        self.net, self.places = net, places
        self.graph = nx.MultiDiGraph()
        self.graph.add_nodes_from(range(net.n))
        cuts = {}
        for one in places.values():
            for point in (*one.on_road, *one.enters):
                if 0 < point.share < 1:
                    cuts.setdefault(point.edge, set()).add(point.share)
        weights = paper_weights(net, COSTS)
        for edge in range(net.m):
            bounds = [0.0, *sorted(cuts.get(edge, ())), 1.0]
            for begin, end in pairwise(bounds):
                self.graph.add_edge(
                    self.node(edge, begin), self.node(edge, end),
                    solo=float(weights.solo[edge]) * (end - begin),
                    platoon=float(weights.platoon[edge]) * (end - begin),
                    metres=float(net.length_m[edge]) * (end - begin),
                    seconds=float(net.length_m[edge] / net.speed_mps[edge]) * (end - begin),
                    road=True,
                )  # fmt: skip
        for (_, end), one in places.items():
            if not one.beside_road:
                continue
            stop = (end, one.lon, one.lat)
            ways = [(node, away) for node, away in one.candidates]
            ways += [(self.node(point.edge, point.share), point.distance_m) for point in one.enters]
            for node, away in ways:
                pair = (stop, node) if end == "origin" else (node, stop)
                metres = away * DETOUR
                self.graph.add_edge(
                    *pair, key=(stop, node), solo=ALONE * metres, platoon=ALONE * metres,
                    metres=metres, seconds=metres / ACCESS_MPS, road=False,
                )  # fmt: skip
        self.alone = dict(nx.all_pairs_dijkstra_path_length(self.graph, weight="solo"))

    def node(self, edge, share):
        if share <= 0:
            return int(self.net.tail[edge])
        return int(self.net.head[edge]) if share >= 1 else ("cut", edge, share)

    def cost(self, start, end):
        return self.alone[start].get(end, np.inf)

    def nodes_of(self, vehicle, end):
        """All nodes a trip may start or end at, and all that count as the place."""
        one = self.places[vehicle, end]
        if one.beside_road:
            stop = (end, one.lon, one.lat)
            near = {node for node, _ in one.candidates}
            return [stop], near | {self.node(p.edge, p.share) for p in one.enters} | {stop}
        on = [self.node(p.edge, p.share) for p in one.on_road]
        on = list(dict.fromkeys(on)) or [node for node, _ in one.candidates]
        return on, set(on)

    def ends(self, vehicle):
        """The pair with the least way alone."""
        starts, ends = (self.nodes_of(vehicle, end)[0] for end in ("origin", "destination"))
        return min(product(starts, ends), key=lambda pair: (
            pair[0] == pair[1], self.cost(*pair), starts.index(pair[0]), ends.index(pair[1])
        ))  # fmt: skip

    def route(self, vehicle):
        """The nodes of the way alone, and of each step (solo, platoon, road)."""
        nodes = nx.dijkstra_path(self.graph, *self.ends(vehicle), weight="solo")
        steps = []
        for pair in pairwise(nodes):
            best = min(self.graph.get_edge_data(*pair).values(), key=lambda data: data["solo"])
            steps.append(best)
        return nodes, steps

    def member(self, vehicle, master, case):
        """The least cost of a member, by every pair of points on the master's road."""
        start, end = self.ends(vehicle)
        nodes, steps = self.route(master)
        before = np.concatenate([[0.0], np.cumsum([step["platoon"] for step in steps])])
        road = [k for k, step in enumerate(steps) if step["road"]]
        best = self.cost(start, end)
        if not road:
            return best
        for i in range(road[0], road[-1] + 1):
            for j in range(i + 1, road[-1] + 2):
                if case == "A" and nodes[j] not in self.nodes_of(vehicle, "destination")[1]:
                    continue
                if case == "B" and nodes[i] not in self.nodes_of(vehicle, "origin")[1]:
                    continue
                way = self.cost(start, nodes[i]) + before[j] - before[i]
                best = min(best, way + self.cost(nodes[j], end))
        return best

    def pair(self, first, second):
        """The least cost of two vehicles whose routes are both free."""
        (o1, g1), (o2, g2) = self.ends(first), self.ends(second)
        both = self.graph.copy()
        for *_, data in both.edges(data=True):
            data["both"] = 2 * data["platoon"]
        together = dict(nx.all_pairs_dijkstra_path_length(both, weight="both"))
        best = self.cost(o1, g1) + self.cost(o2, g2)
        for x, row in together.items():
            for y, cost in row.items():
                before, after = (
                    self.cost(o1, x) + self.cost(o2, x), self.cost(y, g1) + self.cost(y, g2)
                )  # fmt: skip
                best = min(best, before + cost + after)
        return best


def split_of(net, trips):
    places = {
        (trip.vehicle, end): net.locate(getattr(trip, end), end)
        for trip in trips for end in ("origin", "destination")
    }  # fmt: skip
    return Split(net, places)


@MODERATE
@given(problems(), st.sampled_from(["A", "B", "C"]), st.sampled_from(["reference", "hierarchy"]))
def test_every_point_of_a_split_graph_has_been_tried(problem, case, engine):
    net, trips = problem
    plan = planned(net, trips, case, engine=engine, master="A")
    if plan is None:
        return
    split = split_of(net, trips)
    for vehicle in plan.vehicles:
        assert vehicle.solo_cost == pytest.approx(split.cost(*split.ends(vehicle.vehicle)))
        if vehicle.vehicle != "A":
            expected = split.member(vehicle.vehicle, "A", case)
            assert vehicle.joint_cost == pytest.approx(expected)


@MODERATE
@given(problems(most_trips=2), st.sampled_from(["reference", "hierarchy"]))
def test_two_free_routes_between_places(problem, engine):
    net, trips = problem
    plan = planned(net, trips, "D", engine=engine)
    if plan is not None:
        assert plan.joint_cost == pytest.approx(split_of(net, trips).pair("A", "B"))


@MODERATE
@given(problems(), st.sampled_from(["A", "B", "C"]))
def test_both_engines_give_one_plan(problem, case):
    net, trips = problem
    plan = planned(net, trips, case, engine="reference")
    if plan is not None:
        assert plan == planned(net, trips, case, engine="hierarchy")


@MODERATE
@given(problems(), st.sampled_from(["A", "B", "C", "best"]))
def test_bare_weights_are_carried_over(problem, case):
    net, trips = problem
    plan = planned(net, trips, case)
    if plan is None:
        return
    other = plan_joint(net, paper_weights(net, COSTS), trips, case)
    for mine, theirs in zip(plan.vehicles, other.vehicles, strict=True):
        assert mine.joint_cost == pytest.approx(theirs.joint_cost)
        assert mine.solo_cost == pytest.approx(theirs.solo_cost)
    assert Plan.from_dict(plan.to_dict()) == plan


def driven(net, leg):
    """Metres and seconds of a leg by its edges and its span, or by its straight line."""
    if leg.access:
        (lon, lat), (to_lon, to_lat) = leg.access
        per_lon, per_lat = metres_per_degree((lat + to_lat) / 2)
        metres = DETOUR * float(np.hypot((to_lon - lon) * per_lon, (to_lat - lat) * per_lat))
        return metres, metres / ACCESS_MPS
    part = np.ones(len(leg.edges))
    part[0] -= leg.span[0]
    part[-1] -= 1 - leg.span[1]
    metres = net.length_m[list(leg.edges)] * part
    return float(metres.sum()), float((metres / net.speed_mps[list(leg.edges)]).sum())


@MODERATE
@given(problems(), st.sampled_from(["A", "B", "C", "best"]))
def test_totals_are_those_of_the_geometry(problem, case):
    net, trips = problem
    plan = planned(net, trips, case)
    if plan is None:
        return
    for vehicle in plan.vehicles:
        for leg in vehicle.legs:
            metres, seconds = driven(net, leg)
            assert leg.length_m == pytest.approx(metres, rel=1e-3)
            assert leg.time_s == pytest.approx(seconds, rel=1e-3)
            factor = COSTS.solo_factor()
            assert leg.alone_cost == pytest.approx(leg.length_m * factor)
            if leg.role != "platoon":
                assert leg.cost == pytest.approx(leg.alone_cost)
            assert (leg.role == "access") == (not leg.edges) == (leg.access is not None)
        own = [leg for leg in vehicle.legs if leg.role != "access"]
        assert vehicle.access_m + sum(leg.length_m for leg in own) == pytest.approx(
            vehicle.length_m
        )
        follows(net, vehicle)


def follows(net, vehicle):
    """Each leg begins where the one before it ends, from the origin to the destination."""
    at = (vehicle.origin.lon, vehicle.origin.lat)
    for leg in vehicle.legs:
        if leg.access:
            begin, end = leg.access
        else:
            begin = along(net, leg.edges[0], leg.span[0])
            end = along(net, leg.edges[-1], leg.span[1])
        assert begin == pytest.approx(at, abs=1e-9)
        at = end
    assert at == pytest.approx((vehicle.destination.lon, vehicle.destination.lat), abs=1e-9)


def along(net, edge, share):
    (lon, lat), (to_lon, to_lat) = net.shape(edge)
    return lon + share * (to_lon - lon), lat + share * (to_lat - lat)


@MODERATE
@given(road_networks(most_nodes=7), st.data())
def test_a_place_at_a_node_is_the_node(net, data):
    nodes = [data.draw(st.integers(0, net.n - 1)) for _ in range(4)]
    trips = [Trip("A", nodes[0], nodes[1]), Trip("B", nodes[2], nodes[3])]
    at = [(float(net.lon[node]), float(net.lat[node])) for node in nodes]
    located = [net.locate(point) for point in at]
    if any(len(one.on_road) != 1 for one in located):
        return  # another road passes within 100 m of it
    plan = planned(net, trips, "C")
    if plan is None:
        return
    by_point = plan_joint(
        net, COSTS, [Trip("A", at[0], at[1]), Trip("B", at[2], at[3])], "C"
    )  # fmt: skip
    assert by_point == plan


# -- by hand ---------------------------------------------------------------------------------------


def test_a_place_half_way_between_two_junctions_stays_there():
    net = carriageways()
    plan = plan_joint(net, COSTS, [Trip("A", 0, 2), Trip("B", at(50_000), 2)], "C")
    a, b = plan.vehicles
    assert b.length_m == pytest.approx(150_000, rel=1e-4)
    assert (b.origin.node, b.origin.edge) == (-1, 0)
    assert b.origin.share == pytest.approx(0.5)
    assert [leg.edges for leg in a.legs] == [(0,), (0, 1)]
    assert a.legs[0].span == (0.0, b.origin.share)
    assert a.legs[1].span == b.legs[0].span == (b.origin.share, 1.0)
    assert (b.merge.node, b.merge.osm_id, b.merge.edge, b.merge.km) == (-1, 0, 0, 0.0)
    assert b.merge.name == b.origin.name
    assert a.length_m == pytest.approx(net.length_m[:2].sum())


def test_a_trip_takes_the_carriageway_that_suits():
    net = carriageways()
    east, west = (
        plan_joint(net, COSTS, [Trip("A", at(50_000, 20), goal)]).vehicles[0]
        for goal in (2, 5)
    )  # fmt: skip
    assert (east.origin.edge, west.origin.edge) == (0, 4)
    assert east.length_m == pytest.approx(150_000, rel=1e-4)
    assert west.length_m == pytest.approx(50_000, rel=1e-4)


def test_carriageways_far_apart_are_two_roads():
    net = carriageways(gap=400)
    plan = plan_joint(net, COSTS, [Trip("A", at(50_000, 20), 5)])
    assert plan.vehicles[0].origin.edge == 0
    assert plan.vehicles[0].length_m > 300_000


def test_two_places_on_one_edge_in_either_order():
    net = carriageways(gap=400)
    first, second = at(30_000), at(70_000)
    there, back = (
        plan_joint(net, COSTS, [Trip("A", *ends)]).vehicles[0]
        for ends in ((first, second), (second, first))
    )
    assert there.legs[0].edges == (0,)
    assert there.length_m == pytest.approx(40_000, rel=1e-4)
    assert there.legs[0].span == pytest.approx((0.3, 0.7))
    # Backwards it has to drive round: both edges of the way round, and the edge itself twice.
    assert back.legs[0].edges == (0, 1, 2, 3, 4, 5, 0)
    assert back.legs[0].span == pytest.approx((0.7, 0.3))
    assert back.length_m == pytest.approx(net.length_m.sum() - 40_000, rel=1e-4)


def test_two_trips_from_one_place_start_together():
    net = carriageways()
    for place in (at(50_000), at(48_000, -3_000)):
        trips = [Trip("A", place, 3), Trip("B", place, 2)]
        plan = plan_joint(net, COSTS, trips, "B", master="A")
        b = plan.vehicles[1]
        assert b.merge is not None
        assert b.platoon_m > 100_000
        roles = [leg.role for leg in b.legs]
        assert roles == (["platoon"] if place[1] == 45.0 else ["access", "platoon"])


def test_a_depot_beside_the_road_drives_to_a_junction():
    net = carriageways()
    plan = plan_joint(net, COSTS, [Trip("A", at(95_000, -3_000), 2)])
    (a,) = plan.vehicles
    way, road = a.legs
    assert (way.role, way.edges, road.edges) == ("access", (), (1,))
    assert way.access == (at(95_000, -3_000), (net.lon[1], net.lat[1]))
    assert way.length_m == pytest.approx(1.3 * np.hypot(5_000, 3_000), rel=1e-3)
    assert way.time_s == pytest.approx(way.length_m / ACCESS_MPS)
    assert way.fuel_l == pytest.approx(way.length_m * COSTS.fuel_alone())
    assert (a.origin.node, a.origin.edge) == (-1, None)
    assert (a.origin.lon, a.origin.lat) == at(95_000, -3_000)
    assert a.length_m == a.alone.length_m == way.length_m + road.length_m
    assert plan.remarks == ()


def test_far_from_every_junction_one_gets_onto_the_road_between_them():
    net = carriageways()
    plan = plan_joint(net, COSTS, [Trip("A", at(50_000, -3_000), 2)])
    way, road = plan.vehicles[0].legs
    assert way.length_m == pytest.approx(3_900, rel=1e-3)
    assert road.span[0] == pytest.approx(0.5, abs=1e-6)
    assert "A gets onto the road between two junctions" in plan.remarks[0]
    back = plan_joint(net, COSTS, [Trip("A", 0, at(50_000, -3_000))])
    assert "A leaves the road between two junctions" in back.remarks[0]


def test_other_roads_are_entered_anywhere():
    nodes = [(0, 0), (20_000, 0), (40_000, 0)]
    net = made(nodes, both_ways([(0, 1), (1, 2)]), road_class=[4] * 4)
    plan = plan_joint(net, COSTS, [Trip("A", at(13_000, 300), 2)])
    way, road = plan.vehicles[0].legs
    assert way.length_m == pytest.approx(390, rel=1e-3)
    assert road.span[0] == pytest.approx(0.65, abs=1e-6)
    assert plan.remarks == ()


def test_beyond_the_limit_it_is_refused_with_the_distance():
    net = carriageways()
    with pytest.raises(PlatoonError, match=r"trip 'A', origin: .*: 60 km .* more than 50 km"):
        plan_joint(net, COSTS, [Trip("A", at(50_000, -60_000), 2)])


def test_half_a_metre_from_a_node_is_the_node():
    net = carriageways()
    plan = plan_joint(net, COSTS, [Trip("A", at(100_000.5), 2)])
    assert plan.vehicles[0].origin.node == 1
    assert plan.vehicles[0].alone.span == (0.0, 1.0)


def test_nobody_stands_on_a_connector_that_was_inferred():
    nodes = [(0, 0), (10_000, 0), (10_000, 3_000), (20_000, 3_000)]
    net = made(nodes, both_ways([(0, 1), (1, 2), (2, 3)]), inferred=[False, False, True] * 2)
    inferred = np.flatnonzero(net.inferred)
    assert len(inferred) == 2
    edge = int(inferred[0])
    middle = net.shape(edge).mean(axis=0)
    found = net.locate((float(middle[0]), float(middle[1])))
    assert all(not net.inferred[point.edge] for point in found.on_road)


def test_a_member_starts_where_the_master_passes():
    """Both at places between junctions: the member waits at its own for the master."""
    net = carriageways()
    trips = [Trip("A", at(10_000), at(190_000)), Trip("B", at(50_000), at(150_000))]
    plan = plan_joint(net, COSTS, trips, "C")
    b = plan.vehicles[1]
    assert [leg.role for leg in b.legs] == ["platoon"]
    assert (b.merge.edge, b.separation.edge) == (0, 1)
    assert b.separation.km == pytest.approx(100, rel=1e-4)
    assert [event.kind for event in plan.events] == ["merge", "separation"]


def test_the_same_place_twice():
    net = carriageways()
    with pytest.raises(ScenarioError, match="same place"):
        plan_joint(net, COSTS, [Trip("A", at(50_000), at(50_000.4))])
    with pytest.raises(ScenarioError, match="same place"):
        plan_joint(net, COSTS, [Trip("A", at(50_000, 3_000), at(50_000, 3_000))])


def test_places_across_the_date_line():
    lon = [179.0, -179.0, 179.0]
    lat = [-17.0, -17.0, -17.5]
    net = RoadNetwork.from_edges(
        [0, 1, 1, 2], [1, 0, 2, 1], lon=lon, lat=lat, speed_mps=[20.0] * 4,
        length_m=[213_000.0] * 4,
    )  # fmt: skip
    plan = plan_joint(net, COSTS, [Trip("A", (-179.99, -17.0), 0), Trip("B", 1, (179.99, -17.0))])
    a, b = plan.vehicles
    assert a.length_m == pytest.approx(213_000 * 1.01 / 2, rel=1e-6)
    assert b.length_m == pytest.approx(213_000 * 1.01 / 2, rel=1e-6)
    assert a.origin.lon == pytest.approx(-179.99)
    assert b.destination.lon == pytest.approx(179.99)
