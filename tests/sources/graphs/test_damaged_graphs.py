"""Damaged GraphML, GeoPackages and Overpass answers are read, or refused in one line."""

import copy
import json
import re

import osmnx
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from small_osm import as_overpass, as_xml

from platoon_osm.errors import MapDataError
from platoon_osm.sources.load import load_network

ODD = [
    None, [], {}, "x", -1, 1e400, float("nan"), 10**30, 2**63, True, 1.5, [1], {"a": 1}, "\ud800",
]  # fmt: skip
once_each = settings(
    max_examples=80, deadline=None, suppress_health_check=[HealthCheck.function_scoped_fixture]
)


def read_or_refused(path):
    """Load a file and look at all of it; what is refused must be refused in one line."""
    message = refusal(path)
    if message is not None:
        assert message.startswith(f"{path}: ")
        assert "\n" not in message
        assert len(message) < 500


def refusal(path):
    try:
        net = load_network(path)
    except MapDataError as error:
        return str(error)
    assert len(list(net.texts)) > 0
    assert net.path_shape(range(net.m)).shape[1] == 2
    return None


@pytest.fixture(scope="module")
def graphml(tmp_path_factory):
    folder = tmp_path_factory.mktemp("graph")
    (folder / "small.osm").write_text(as_xml())
    graph = osmnx.graph.graph_from_xml(folder / "small.osm", simplify=False, retain_all=True)
    osmnx.io.save_graphml(graph, folder / "small.graphml")
    osmnx.io.save_graph_geopackage(graph, folder / "small.gpkg")
    return folder / "small.graphml"


@st.composite
def damaged(draw, content):
    content = bytearray(content)
    for _ in range(draw(st.integers(1, 4))):
        at = draw(st.integers(0, len(content) - 1))
        content[at : at + draw(st.integers(0, 9))] = draw(st.binary(max_size=9))
    return bytes(content)


@once_each
@given(st.data())
@pytest.mark.parametrize("suffix", [".graphml", ".gpkg"])
def test_damaged_bytes(tmp_path, graphml, suffix, data):
    path = tmp_path / f"damaged{suffix}"
    path.write_bytes(data.draw(damaged(graphml.with_suffix(suffix).read_bytes())))
    read_or_refused(path)


def places_in(value, path=()):
    """Yield the way to every value inside a JSON document."""
    if path:
        yield path
    if isinstance(value, dict | list):
        for key in value if isinstance(value, dict) else range(len(value)):
            yield from places_in(value[key], (*path, key))


@once_each
@given(st.sampled_from(list(places_in(as_overpass()))), st.sampled_from([*ODD, "gone"]))
def test_an_answer_with_one_value_of_another_kind(tmp_path, place, odd):
    answer = copy.deepcopy(as_overpass())
    inner = answer
    for key in place[:-1]:
        inner = inner[key]
    if odd == "gone":
        del inner[place[-1]]
    else:
        inner[place[-1]] = odd
    path = tmp_path / "answer.json"
    path.write_text(json.dumps(answer))
    read_or_refused(path)


@pytest.mark.parametrize("number", [10**30, 2**63, -(2**63) - 1])
def test_the_number_of_a_node_that_no_computer_holds(tmp_path, number):
    answer = as_overpass()
    way = next(one for one in answer["elements"] if one["type"] == "way")
    way["nodes"][1] = number
    path = tmp_path / "answer.json"
    path.write_text(json.dumps(answer))
    assert "an element lacks its id, type, nodes or coordinates" in refusal(path)


@pytest.mark.parametrize("wrong", [b"utf-99", b"x"])
def test_an_unknown_encoding(tmp_path, graphml, wrong):
    path = tmp_path / "a.graphml"
    path.write_bytes(graphml.read_bytes().replace(b"utf-8", wrong, 1))
    assert "not a GraphML graph" in refusal(path)


def test_a_way_id_too_large_for_any_computer_is_no_id(tmp_path, graphml):
    path = tmp_path / "a.graphml"
    path.write_bytes(graphml.read_bytes().replace(b">101<", b">" + b"9" * 40 + b"<"))
    net = load_network(path)
    assert 0 in net.way_id
    assert 103 in net.way_id


def test_a_length_that_is_no_number(tmp_path, graphml):
    import networkx

    graph = networkx.read_graphml(graphml, force_multigraph=True)
    next(iter(graph.edges(data=True)))[2]["length"] = "far"
    path = tmp_path / "a.graphml"
    networkx.write_graphml(graph, path)
    assert "has length 'far'; a length must be metres" in refusal(path)


def test_what_the_reader_of_a_file_warns_of_is_in_the_report(tmp_path, graphml):
    path = tmp_path / "a.graphml"
    text = graphml.read_text()
    key = re.search(r'<key id="(d\d+)" for="edge" attr.name="ref" attr.type="string" ?/>', text)
    path.write_text(text.replace(key.group(), key.group().replace(' attr.type="string"', "")))
    report = load_network(path).report()
    said = f"reading the file: No key type for id {key.group(1)}. Using string"
    assert said in report.remarks
