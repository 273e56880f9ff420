"""Barriers on nodes of OSMnx's graphs, against the same map as an OSM file."""

from collections import Counter
from itertools import pairwise

import numpy as np
import osmnx
from hypothesis import given, settings
from hypothesis import strategies as st
from osm_files import write

from platoon_osm.network.restrictions import decode
from platoon_osm.sources.graphs.exchange import to_networkx
from platoon_osm.sources.graphs.node_barriers import behind_barriers
from platoon_osm.sources.graphs.osmnx_graph import (
    network_from_osmnx,
    read_geopackage,
    read_graphml,
)
from platoon_osm.sources.osm.extract import read_osm
from platoon_osm.sources.overpass.download import osmnx_settings
from platoon_osm.sources.truck import TruckRules

RULES = TruckRules("IT")
NODE_TAGS = ["highway", "barrier", "access", "hgv", "motor_vehicle", "locked", "maxheight",
             "access:conditional"]  # fmt: skip
ROAD = {"highway": "primary", "maxspeed": "70"}
ACCESS = st.sampled_from(["no", "yes", "private", "destination", "no such value"])
BARRIERS = st.fixed_dictionaries({}, optional={
    "barrier": st.sampled_from(["gate", "bollard", "height_restrictor", "toll_booth", "yes"]),
    "access": ACCESS, "hgv": ACCESS, "motor_vehicle": ACCESS, "locked": ACCESS,
    "maxheight": st.sampled_from(["3.8", "none"]),
    "access:conditional": st.just("no @ (22:00-06:00)"),
})  # fmt: skip


def crossroads(barriers):
    """Return a road along 1 to 5, and one off it at 3 to 6 and 7, with tags on its nodes."""
    places = [(0, 0), (1, 0), (2, 0), (3, 0), (4, 0), (2, 1), (2, 2)]
    nodes = {
        k + 1: (11 + x / 100, 45 + y / 100, tags)
        for k, ((x, y), tags) in enumerate(zip(places, barriers, strict=True))
    }
    return nodes, {1: ([1, 2, 3, 4, 5], ROAD), 2: ([3, 6, 7], ROAD)}


def graph_of(folder, barriers, simplify=False):
    file = write(folder, *crossroads(barriers))
    with osmnx_settings(folder / "cache", 0, {"useful_tags_node": NODE_TAGS}):
        return file, osmnx.graph_from_xml(file, simplify=simplify, retain_all=True)


def told(net):
    """Return what each point of each road says, for the direction it is driven in."""
    found = {}
    for edge in range(net.m):
        layers = sorted(map(sorted, map(dict.items, decode(net.texts[net.restriction[edge]]))))
        shape = net.shape(edge).round(6).tolist()
        for start, stop in pairwise(shape):
            found[*start, *stop] = layers
    return found


COUNTED = (
    "barriers on roads read", "barriers obeyed", "barriers that close nothing",
    "barriers where roads meet, not obeyed", "barriers of a kind not in the table, taken as open",
)  # fmt: skip


@settings(max_examples=25, deadline=None)
@given(st.lists(BARRIERS, min_size=7, max_size=7))
def test_barriers_are_those_of_the_same_osm_file(tmp_path_factory, barriers):
    file, graph = graph_of(tmp_path_factory.mktemp("map"), barriers)
    expected = read_osm(file, ("primary",), RULES)
    net = network_from_osmnx(graph, ("primary",), RULES)
    assert told(net) == told(expected)
    for name in COUNTED:
        assert net.report()[name] == expected.report()[name], name


def test_files_of_osmnx_tell_of_barriers_too(tmp_path):
    barriers = [{}, {"barrier": "gate", "hgv": "no", "maxheight": "3.8"}, *({},) * 5]
    _, graph = graph_of(tmp_path, barriers)
    osmnx.save_graphml(graph, tmp_path / "map.graphml")
    osmnx.save_graph_geopackage(graph, tmp_path / "map.gpkg", directed=True)
    expected = told(network_from_osmnx(graph, ("primary",), RULES))
    assert sum(map(bool, expected.values())) == 2
    assert told(read_graphml(tmp_path / "map.graphml", ("primary",), RULES)) == expected
    assert told(read_geopackage(tmp_path / "map.gpkg", ("primary",), RULES)) == expected


def test_a_simplified_graph_has_barriers_if_its_nodes_were_kept(tmp_path):
    barriers = [{}, {"barrier": "bollard"}, *({},) * 5]
    _, graph = graph_of(tmp_path, barriers)
    lost = network_from_osmnx(osmnx.simplify_graph(graph), ("primary",), RULES)
    kept = osmnx.simplify_graph(graph, node_attrs_include=["barrier"])
    net = network_from_osmnx(kept, ("primary",), RULES)
    assert "barriers obeyed" not in lost.report()
    assert not any(told(lost).values())
    assert net.report()["barriers obeyed"] == 1
    assert sum(map(bool, told(net).values())) == 2


def test_two_edges_of_one_direction_are_two_roads():
    nodes = [("a", {}), ("b", {"barrier": "bollard"})]
    counts, tail = Counter(), np.array([1, 1, 1])
    assert behind_barriers(nodes, tail, 1 - tail, [""] * 3, counts) == [""] * 3
    assert counts["barriers where roads meet, not obeyed"] == 1


def test_the_report_says_that_there_are_no_turn_restrictions(tmp_path):
    _, graph = graph_of(tmp_path, [{}] * 7)
    net = network_from_osmnx(graph, ("primary",), RULES)
    (remark,) = net.report().remarks
    assert remark.startswith("turn restrictions: not in this kind of file")
    # A graph that was made of a network has its turns.
    again = network_from_osmnx(to_networkx(net), ("primary",), RULES)
    assert not again.report().remarks
