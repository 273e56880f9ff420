"""Solo routes by Dijkstra and by the paper's inflated A*."""

import numpy as np
import pytest
from hypothesis import given, settings
from oracles import all_pairs
from random_networks import network, road_networks

from platoon_osm.costs.fatigue import fatigue_heuristic
from platoon_osm.costs.paper import paper_weights
from platoon_osm.errors import ScenarioError
from platoon_osm.network.geodesy import distance_m
from platoon_osm.planning.routers import AstarRouter, DijkstraRouter
from platoon_osm.search.astar import astar
from platoon_osm.search.dijkstra import ReferenceEngine
from platoon_osm.search.trees import Trees


@settings(max_examples=25, deadline=None)
@given(road_networks())
def test_dijkstra_both_ways(net):
    weight = paper_weights(net).solo
    engine, least = ReferenceEngine(net, weight), all_pairs(net, weight)
    everywhere = np.arange(net.n)
    for backward in (False, True):
        # Known searches to the destination give the same routes as those from the origin.
        trees = Trees(engine)
        if backward:
            trees.trees(everywhere, forward=False)
        router = DijkstraRouter(trees)
        table = router.table(everywhere, everywhere)
        for origin in range(net.n):
            for destination in range(net.n):
                assert table[origin, destination] == pytest.approx(least[origin][destination])
                route = router.route(origin, destination)
                assert float(weight[route].sum()) == pytest.approx(least[origin][destination])
                if origin != destination:
                    assert net.path_nodes(route)[[0, -1]].tolist() == [origin, destination]


@pytest.mark.parametrize("method", ["astar", "astar-closed-once"])
@settings(max_examples=25, deadline=None)
@given(net=road_networks())
def test_astar_finds_drivable_routes_never_cheaper_than_the_least(net, method):
    weight = paper_weights(net).solo
    least = all_pairs(net, weight)
    router = AstarRouter(net, weight, 1e5, 110 / 3.6, method)
    for origin in range(net.n):
        for destination in range(net.n):
            cost, route = router.cost(origin, destination), router.route(origin, destination)
            assert cost == pytest.approx(float(weight[route].sum()))
            assert cost >= least[origin][destination] * (1 - 1e-12)
            if origin != destination:
                assert net.path_nodes(route)[[0, -1]].tolist() == [origin, destination]
                assert np.array_equal(net.head[route[:-1]], net.tail[route[1:]])


@pytest.mark.parametrize(("method", "reopen"), [("astar", True), ("astar-closed-once", False)])
@settings(max_examples=25, deadline=None)
@given(net=road_networks())
def test_the_router_uses_the_papers_heuristic(net, method, reopen):
    weight = paper_weights(net).solo
    away = distance_m(net.lon, net.lat, net.lon[1], net.lat[1])
    cost, route = astar(net, weight, 0, 1, fatigue_heuristic(away, 1e5, 110 / 3.6), reopen)
    router = AstarRouter(net, weight, 1e5, 110 / 3.6, method)
    assert router.cost(0, 1) == cost
    assert np.array_equal(router.route(0, 1), route)


@pytest.mark.parametrize("method", ["dijkstra", "a*", None, 1])
def test_what_is_no_astar_is_refused(method):
    net = network([0], [1], [1e3])
    with pytest.raises(ScenarioError, match="is no A\\*; use astar or astar-closed-once"):
        AstarRouter(net, net.length_m, 1e5, 110 / 3.6, method)
