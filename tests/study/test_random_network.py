"""The random network obeys every row of Table 1, and each of its options."""

import numpy as np
import pytest

from platoon_osm.errors import ScenarioError
from platoon_osm.search.dijkstra import ReferenceEngine
from platoon_osm.study.random_network import RandomNetwork


def drawn(seed=0, **options):
    return RandomNetwork(**options).draw(np.random.default_rng(seed))


def junctions(draw):
    return draw.net.n - (len(draw.origins) - 1)


def test_table_1_as_printed():
    network = RandomNetwork()
    assert (network.width_m, network.height_m) == (1e6, 1e6)
    assert (network.nodes, network.edges, network.dropout) == (100, 500, 0.2)
    assert (network.spawn_diameter_m, network.min_route_m, network.vehicles) == (1e3, 5e5, 10)


@pytest.mark.parametrize("seed", range(5))
def test_a_draw_is_connected_and_every_route_long_enough(seed):
    draw = drawn(seed)
    roads = ~draw.access
    assert junctions(draw) == 100
    assert draw.access.sum() == 9 * 3
    # Every junction reaches every other by roads alone.
    weight = np.where(roads, draw.net.length_m, np.inf)
    away = ReferenceEngine(draw.net, weight).distances(np.arange(100))[:, :100]
    assert np.isfinite(away).all()
    routes = ReferenceEngine(draw.net, draw.net.length_m).distances(draw.origins)
    assert (routes[np.arange(10), draw.destinations] >= 5e5).all()
    assert (draw.destinations < 100).all()
    assert ((draw.x_m >= 0) & (draw.x_m <= 1e6) & (draw.y_m >= 0) & (draw.y_m <= 1e6)).all()


@pytest.mark.parametrize("diameter", [1e3, 4e5])
def test_members_start_within_the_circle_and_access_edges_only_lead_in(diameter):
    draw = drawn(3, spawn_diameter_m=diameter)
    centre, others = draw.origins[0], draw.origins[1:]
    away = np.hypot(draw.x_m[others] - draw.x_m[centre], draw.y_m[others] - draw.y_m[centre])
    assert (away <= diameter / 2).all()
    assert away.max() > diameter / 8
    assert np.isin(draw.net.tail[draw.access], others).all()
    assert not np.isin(draw.net.head, others).any()
    # They lead straight to the three nearest junctions.
    for vehicle in others:
        to_all = np.hypot(draw.x_m[:100] - draw.x_m[vehicle], draw.y_m[:100] - draw.y_m[vehicle])
        mine = draw.net.tail == vehicle
        assert sorted(draw.net.head[mine]) == sorted(np.argsort(to_all)[:3])
        assert np.sort(draw.net.length_m[mine]) == pytest.approx(np.sort(to_all)[:3])


def test_without_dropout_the_shortest_edges_of_the_complete_graph_remain():
    draw = drawn(1, dropout=0.0, spawning="nodes")
    net = draw.net
    assert net.m == 2 * 500
    a, b = np.triu_indices(100, 1)
    shortest = np.sort(np.hypot(draw.x_m[a] - draw.x_m[b], draw.y_m[a] - draw.y_m[b]))[:500]
    once = net.tail < net.head
    assert np.sort(net.length_m[once]) == pytest.approx(shortest)
    both_ways = {*zip(net.tail.tolist(), net.head.tolist(), strict=True)}
    assert all((head, tail) in both_ways for tail, head in both_ways)


def test_dropout_drops_its_share():
    # Dense enough to be connected always, so that redrawing does not select.
    draws = [drawn(seed, edges=2000, dropout=0.3, spawning="nodes") for seed in range(20)]
    assert all(draw.unconnected == 0 for draw in draws)
    kept = np.array([draw.net.m / 2 for draw in draws])
    # Mean of 20 binomials (2000, 0.7): 1400, standard error sqrt(2000 * 0.21 / 20) = 4.6.
    assert abs(kept.mean() - 1400) < 4 * 4.6


def test_pruning_at_random_keeps_longer_edges():
    short, any_length = drawn(2, spawning="nodes"), drawn(2, spawning="nodes", pruning="random")
    # The mean distance of two points in a square of side a is 0.521 a.
    assert any_length.net.length_m.mean() == pytest.approx(521_000, rel=0.1)
    assert short.net.length_m.mean() < 250_000


def test_directed_edges_are_one_way_and_counted_singly():
    draw = drawn(
        0, directed=True, pruning="random", dropout=0.0, connected="part", spawning="nodes"
    )
    assert draw.net.m == 500
    both_ways = {*zip(draw.net.tail.tolist(), draw.net.head.tolist(), strict=True)}
    assert sum((head, tail) in both_ways for tail, head in both_ways) < 100
    inside = draw.net.strong_component() == 0
    assert inside[draw.origins].all()
    assert inside[draw.destinations].all()


def test_members_may_start_at_nodes_of_the_circle():
    draw = drawn(4, spawning="nodes", spawn_diameter_m=4e5)
    assert draw.net.n == 100
    assert not draw.access.any()
    away = np.hypot(
        draw.x_m[draw.origins] - draw.x_m[draw.origins[0]],
        draw.y_m[draw.origins] - draw.y_m[draw.origins[0]],
    )
    assert (away <= 2e5).all()
    assert len(set(draw.origins.tolist())) > 1


def test_route_length_may_be_the_straight_line():
    draw = drawn(5, route_length="straight")
    straight = np.hypot(
        draw.x_m[draw.origins] - draw.x_m[draw.destinations],
        draw.y_m[draw.origins] - draw.y_m[draw.destinations],
    )
    assert (straight >= 5e5).all()


def test_draws_that_cannot_be_used_are_counted():
    sparse = [drawn(seed, edges=300) for seed in range(8)]
    assert sum(draw.unconnected for draw in sparse) > 0
    assert all(
        draw.net.load_report["networks drawn again, not connected"] == draw.unconnected
        for draw in sparse
    )
    far = [drawn(seed, min_route_m=1.1e6) for seed in range(8)]
    assert sum(draw.impossible for draw in far) > 0


def test_the_first_draw_is_thrown_away_only_if_it_cannot_be_used():
    # Seeds whose draw was the first one, drawn with no redraw allowed, are the same.
    for seed in range(5):
        draw = drawn(seed)
        if draw.unconnected + draw.impossible == 0:
            again = drawn(seed, max_redraws=0)
            assert again.net.identity() == draw.net.identity()
        else:
            with pytest.raises(ScenarioError, match="none of 1 draws"):
                drawn(seed, max_redraws=0)


def test_the_same_seed_draws_the_same():
    one, two, other = drawn(6), drawn(6), drawn(7)
    assert one.net.identity() == two.net.identity() != other.net.identity()
    assert (one.destinations == two.destinations).all()


@pytest.mark.parametrize(
    ("options", "message"),
    [
        ({"nodes": 1}, "nodes"), ({"nodes": 2.5}, "nodes"), ({"edges": 0}, "edges"),
        ({"edges": 4951}, "edges"), ({"dropout": 1.0}, "dropout"), ({"dropout": -0.1}, "dropout"),
        ({"dropout": float("nan")}, "dropout"), ({"vehicles": 1}, "vehicles"),
        ({"vehicles": True}, "vehicles"), ({"spawn_diameter_m": -1.0}, "spawn_diameter_m"),
        ({"min_route_m": float("inf")}, "min_route_m"), ({"width_m": 0.0}, "width_m"),
        ({"width_m": "1e6"}, "width_m"), ({"pruning": "longest"}, "pruning"),
        ({"spawning": "air"}, "spawning"), ({"access_nodes": 0}, "access_nodes"),
        ({"connected": "maybe"}, "connected"), ({"route_length": "air"}, "route_length"),
        ({"directed": "yes"}, "directed"), ({"max_redraws": -1}, "max_redraws"),
    ],
)  # fmt: skip
def test_bad_parameters_are_refused_in_one_line(options, message):
    with pytest.raises(ScenarioError, match=message) as caught:
        RandomNetwork(**options)
    assert "\n" not in str(caught.value)


def test_what_cannot_be_drawn_is_refused_in_one_line():
    with pytest.raises(ScenarioError, match="none of 4 draws") as caught:
        drawn(edges=20, max_redraws=3)
    assert "\n" not in str(caught.value)


def test_directed_edges_between_nearest_nodes_hardly_ever_connect():
    with pytest.raises(ScenarioError, match="100 not"):
        drawn(directed=True, max_redraws=99)
