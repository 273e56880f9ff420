"""The ETISplus form of GraphML: places and distances without road tags."""

import networkx
import numpy as np
import pytest
from places import SHARED as BESIDE

from platoon_osm.errors import MapDataError
from platoon_osm.search.dijkstra import ReferenceEngine
from platoon_osm.sources.load import load_network
from platoon_osm.study.road_trips import RoadTrips, read_flows

SHARED = BESIDE / "data" / "etis"


def made(**edge):
    graph = networkx.DiGraph()
    for node, (x, y) in {"7": (9.0, 45.0), "8": (10.0, 45.0), "9": (11.0, 45.0)}.items():
        graph.add_node(node, position_x=x, position_y=y)
    for u, v in (("7", "8"), ("8", "9"), ("9", "8"), ("8", "7")):
        graph.add_edge(u, v, id=1, **{"distance": 85.5, **edge})
    return graph


def write(folder, graph):
    path = folder / "graph.graphml"
    networkx.write_graphml(graph, path)
    return path


def test_every_place_stays_and_distances_are_kilometres(tmp_path):
    folder = tmp_path / "IT"
    folder.mkdir()
    net = load_network(write(folder, made()), country="IT")
    assert net.node_id.tolist() == [7, 8, 9]
    assert net.length_m.tolist() == [85_500] * 4
    assert net.speed_mps * 3.6 == pytest.approx([80] * 4)
    assert net.source.name == "IT/graph.graphml"
    assert net.source.licence == "CC BY 4.0"
    assert net.report()["speed defaulted from road class"] == 4
    assert "no road tags" in net.report().remarks[0]


@pytest.mark.parametrize("distance", ["far", "nan", "-1.0", "inf"])
def test_a_distance_that_is_none(tmp_path, distance):
    path = write(tmp_path, made(distance=distance))
    with pytest.raises(MapDataError, match=r"edge '?7'? -> '?8'? has (distance|length)") as caught:
        load_network(path)
    assert str(caught.value).startswith(f"{path}: ")
    assert "\n" not in str(caught.value)


def test_a_place_without_coordinates(tmp_path):
    graph = made()
    del graph.nodes["9"]["position_y"]
    with pytest.raises(MapDataError, match="node 9 lies at"):
        load_network(write(tmp_path, graph))


@pytest.mark.parametrize(
    ("country", "nodes", "edges"), [("DE", 419, 1090), ("IT", 178, 450), ("NL", 125, 314)]
)
def test_the_real_networks_and_their_flows(country, nodes, edges):
    folder = SHARED / country
    if not folder.is_dir():
        pytest.skip(f"{folder} is not here")
    net = load_network(folder / "graph.graphml", country=country)
    assert (net.n, net.m) == (nodes, edges)
    flows = read_flows(folder / "traffic.csv", net)
    assert flows.left_out < 0.1 * flows.volume.sum()
    draw = RoadTrips(net, vehicles=4, min_route_m=1e5, flows=flows).draw(np.random.default_rng(0))
    lengths = ReferenceEngine(net, net.length_m).distances(draw.origins)
    assert (lengths[range(4), draw.destinations] >= 1e5).all()
