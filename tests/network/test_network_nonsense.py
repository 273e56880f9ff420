"""Nonsense given to public functions of networks ends in one line that says what is wrong."""

import math
from functools import partial
from pathlib import Path

import numpy as np
import pytest
from made_networks import small_italy

from platoon_osm.errors import NetworkError, PlatoonError
from platoon_osm.network.locate import locate
from platoon_osm.network.preparing.inferred_links import infer_links
from platoon_osm.network.preparing.simplify import merge_chains
from platoon_osm.network.preparing.split import split_edges
from platoon_osm.network.road_network import NamedPoints, RoadNetwork
from platoon_osm.network.saved.store import open_network, save_network
from platoon_osm.sources.graphs.exchange import from_networkx, to_networkx
from platoon_osm.sources.graphs.geodataframes import to_geodataframes

NET = small_italy()
EDGES = {"tail": [0, 1], "head": [1, 0], "lon": [9.0, 9.1], "lat": [45.0, 45.1]}

NONSENSE = {
    "None": None, "text": "x", "number": 3.5, "minus one": -1, "huge": 10**30, "NaN": math.nan,
    "dict": {"a": 1}, "object": object(), "list": [1, "a", None], "ragged": [[1], [2, 3]],
    "set": {9.0, 45.0}, "complex": 1j, "bytes": b"\x01\x02", "date": np.datetime64("NaT"),
    "matrix": np.zeros((2, 2)), "NaNs": np.full(2, np.nan), "texts": ["a", "b"],
    "function": len, "lines": "a\nb", "infinite": [math.inf, -math.inf],
    "wide": np.zeros(99), "none": np.array([None, None]),
}  # fmt: skip


def refused(call, *arguments, **options):
    """Call with nonsense, which must end in a PlatoonError of one line."""
    with pytest.raises(PlatoonError) as caught:
        call(*arguments, **options)
    message = str(caught.value)
    assert message
    assert "\n" not in message
    assert len(message) < 700


def may_refuse(call, *arguments, **options):
    """Call with what may make sense by chance; if it does not, as above."""
    try:
        call(*arguments, **options)
    except PlatoonError as error:
        assert "\n" not in str(error)  # noqa: PT017 (the error is one of several kinds)


def some(*without):
    return pytest.mark.parametrize(
        "value", [NONSENSE[key] for key in NONSENSE if key not in without],
        ids=[key for key in NONSENSE if key not in without],
    )  # fmt: skip


@pytest.mark.parametrize("name", ["tail", "head", "lon", "lat"])
@some()
def test_needed_columns(name, value):
    refused(RoadNetwork.from_edges, **{**EDGES, name: value})


@pytest.mark.parametrize(
    "name",
    ["length_m", "speed_mps", "node_id", "road_class", "toll", "inferred", "way_id", "node_name",
     "node_ref", "ref", "name", "shape_first", "shape_lon", "shape_lat"],
)  # fmt: skip
@some()
def test_other_columns(name, value):
    may_refuse(RoadNetwork.from_edges, **EDGES, **{name: value})
    may_refuse(RoadNetwork.from_edges, **EDGES, **{name: value}, texts=NET.texts)
    if value is not None:
        may_refuse(NET.with_columns, **{name: value})
        may_refuse(NET.take, [0, 1], **{name: value})


@pytest.mark.parametrize("name", ["texts", "points", "source", "report"])
@some("None")
def test_what_comes_with_the_columns(name, value):
    refused(RoadNetwork.from_edges, **EDGES, **{name: value})


def test_the_message_says_what_is_held():
    with pytest.raises(NetworkError, match="toll holds 2; give True or False"):
        RoadNetwork.from_edges(**EDGES, toll=[2, 0])
    with pytest.raises(NetworkError, match=r"tail holds 0.5; give whole numbers"):
        RoadNetwork.from_edges(**{**EDGES, "tail": [0.5, 1]})
    with pytest.raises(NetworkError, match=r"speed_mps holds .*'fast'.*; give numbers \[m/s\]"):
        RoadNetwork.from_edges(**EDGES, speed_mps=["fast", "slow"])
    with pytest.raises(NetworkError, match="name of edge 1 is 99; codes run from 0 to 9"):
        RoadNetwork.from_edges(**EDGES, name=[0, 99], texts=NET.texts)
    with pytest.raises(NetworkError, match="first_out follows from tail"):
        RoadNetwork.from_edges(**EDGES, first_out=[0, 1, 2])


@some("texts", "wide")
def test_named_points(value):
    refused(NamedPoints, value, value, value, value, value)


@some("lines", "text")
def test_places(value):
    refused(NET.locate, value)
    refused(locate, NET, value)


@pytest.mark.parametrize("place", ["", "\n", "x" * 5_000, "()", "(A4)", "a\nb", "\0"])
def test_names_that_are_none(place):
    refused(NET.locate, place)


@some()
def test_roles_and_edges(value):
    refused(NET.locate, 0, value)
    refused(NET.take, value)


def test_a_place_found_on_a_larger_network():
    far = small_italy().locate(7)
    single = RoadNetwork.from_edges(**EDGES)
    refused(single.locate, far)


@some()
def test_networks_that_are_none(value, tmp_path):
    for call in (
        locate, to_networkx, to_geodataframes, merge_chains, infer_links,
        partial(save_network, path=tmp_path / "a"), partial(split_edges, edges=[], along_m=[]),
    ):  # fmt: skip
        refused(partial(call, place=0) if call is locate else call, value)


@some()
def test_files_to_open_and_save(value):
    refused(open_network, value)


@some("text", "lines")
def test_files_to_save(value):
    refused(NET.save, value)


def test_files_that_cannot_be(tmp_path):
    for path in (tmp_path, Path(__file__) / "file", "x" * 300, "a\0b", "\udcff", ""):
        refused(open_network, path)
        refused(NET.save, path)


@some()
def test_graphs(value):
    refused(RoadNetwork.from_networkx, value)
    refused(from_networkx, value)


@some()
def test_cuts_chains_and_links(value):
    refused(split_edges, NET, value, [1.0])
    refused(split_edges, NET, [0], value)
    if value is not None:
        refused(merge_chains, NET, value)
    if not isinstance(value, float) or math.isnan(value):
        refused(infer_links, NET, value)
