"""Heights and grades of OSMnx graphs, and of our own network on its way through a graph."""

import networkx as nx
import osmnx
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from platoon_osm.network.grades import grade, graded_share
from platoon_osm.network.road_network import RoadNetwork
from platoon_osm.sources.graphs.exchange import from_networkx, to_networkx
from platoon_osm.sources.graphs.osmnx_graph import network_from_osmnx
from platoon_osm.sources.truck import TruckRules

RULES = TruckRules("IT")


def graph(heights, **data):
    """Return a two-way road over nodes a kilometre apart, as OSMnx has it."""
    g = nx.MultiDiGraph(crs="epsg:4326")
    for node, told in enumerate(heights, 1):
        g.add_node(node, x=9 + 0.01 * node, y=45.0, **told)
    for u in range(1, len(heights)):
        for v, w, backwards in ((u, u + 1, False), (u + 1, u, True)):
            g.add_edge(v, w, osmid=u, highway="primary", oneway=False, reversed=backwards,
                       length=1000.0, **data)  # fmt: skip
    return g


def load(g):
    return network_from_osmnx(g, ["primary"], RULES)


def told(net, start, end):
    ids = net.node_id
    (e,) = [e for e in range(net.m) if (ids[net.tail[e]], ids[net.head[e]]) == (start, end)]
    return pytest.approx((float(net.climb_m[e]), float(net.descent_m[e]),
                          float(graded_share(net)[e])), abs=1e-3)  # fmt: skip


def test_heights_of_nodes():
    net = load(graph([{"elevation": 200.0}, {"elevation": 230.0}, {"elevation": 210}]))
    assert told(net, 1, 3) == (30, 20, 1)
    assert told(net, 3, 1) == (20, 30, 1)
    assert net.report().counts["nodes with a height"] == 3
    assert net.report().counts["km of known grade"] == 4


def test_the_tag_ele_where_there_is_no_elevation():
    net = load(graph([{"ele": "200 m"}, {"ele": "1148 ft", "elevation": None}, {"ele": "high"}]))
    assert told(net, 1, 3) == (pytest.approx(149.91, abs=0.01), 0, 0.5)
    assert net.report().counts["heights of nodes not understood, or of no road"] == 1


def test_a_height_of_nought_is_a_height():
    assert told(load(graph([{"elevation": 0}, {"elevation": 50}])), 1, 2) == (50, 0, 1)


def test_what_osmnx_works_out_itself():
    g = osmnx.elevation.add_edge_grades(graph([{"elevation": 200}, {"elevation": 240}]))
    for node in g:
        del g.nodes[node]["elevation"]
    net = load(g)
    assert told(net, 1, 2) == (40, 0, 1)
    assert told(net, 2, 1) == (0, 40, 1)


def test_inclines_are_turned_for_the_other_direction():
    net = load(graph([{}, {}], incline="4%"))
    assert told(net, 1, 2) == (40, 0, 1)
    assert told(net, 2, 1) == (0, 40, 1)
    assert grade(net).tolist() == pytest.approx([0.04, -0.04])


@pytest.mark.parametrize(
    ("data", "count"),
    [
        ({"incline": "up"}, "incline without a size (up, down)"),
        ({"incline": ["4%", "6%"]}, "edges with several inclines or grades, not read"),
        ({"grade": [0.1, 0.2]}, "edges with several inclines or grades, not read"),
        ({"incline": "90%"}, "incline of more than 30 %, ignored"),
    ],
)
def test_what_says_nothing_is_counted(data, count):
    net = load(graph([{}, {}], **data))
    assert net.report().counts[count] == 2
    assert not net.graded_m.any()


def test_slips_are_counted_and_the_grade_holds():
    g = graph([{"elevation": 200}, {"elevation": 900}], grade=0.01)
    net = load(g)
    assert net.report().counts["edges of more than 30 % by heights or grade, ignored"] == 2
    assert told(net, 1, 2) == (10, 0, 1)
    alone = load(graph([{}, {}], grade=0.7))
    assert not alone.graded_m.any()
    assert alone.report().counts["edges of more than 30 % by heights or grade, ignored"] == 2


def test_an_edge_of_ways_drawn_against_each_other():
    g = graph([{}, {}], incline="4%")
    for *_, data in g.edges(data=True):
        data["reversed"] = [True, False]
    assert not load(g).graded_m.any()


@settings(max_examples=25, deadline=None)
@given(st.lists(st.tuples(st.floats(0, 50), st.floats(0, 50), st.floats(0, 1000),
                          st.floats(0, 1000)), min_size=1, max_size=5))  # fmt: skip
def test_our_own_columns_survive_a_graph(rows):
    count = len(rows)
    climb, descent, graded, free = zip(*rows, strict=True)
    net = RoadNetwork.from_edges(
        range(count), range(1, count + 1), [1000.0] * count, climb_m=climb, descent_m=descent,
        graded_m=graded, toll_free_m=free, road_class=4, country=["IT"] * count,
        lon=[9 + 0.01 * k for k in range(count + 1)], lat=[45.0] * (count + 1),
    )  # fmt: skip
    again = from_networkx(to_networkx(net))
    read = load(to_networkx(net))
    for name in ("climb_m", "descent_m", "graded_m", "toll_free_m"):
        assert getattr(again, name).tolist() == getattr(net, name).tolist()
        assert getattr(read, name).sum() == pytest.approx(getattr(net, name).sum(), rel=1e-5)
