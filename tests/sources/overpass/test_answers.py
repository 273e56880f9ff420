"""Turn restrictions and barriers of Overpass answers, against the same map as OSM XML."""

import json

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from osm_files import scattered, write

from platoon_osm.errors import MapDataError
from platoon_osm.sources.osm.extract import read_osm
from platoon_osm.sources.overpass.answers import read_overpass_cache
from platoon_osm.sources.truck import TruckRules
from platoon_osm.vehicles.closures import Closures
from platoon_osm.vehicles.profile import DEFAULT_VEHICLE

ROADS = ("primary",)
RULES = TruckRules("DE")
KINDS = ("no_left_turn", "only_straight_on", "no_u_turn", "no_entry", "nonsense")


@st.composite
def maps(draw):
    """Roads between few crossings, with barriers on them and relations that forbid turns."""
    rng = np.random.default_rng(draw(st.integers(0, 2**32 - 1)))
    n = draw(st.integers(3, 7))
    nodes = scattered(rng, n)
    for node in nodes:
        if rng.random() < 0.3:
            nodes[node][2].update(ele=str(rng.choice(["120", "135 m", "400 ft", "high"])))
        if rng.random() < 0.2:
            nodes[node][2].update(barrier=str(rng.choice(["bollard", "gate", "toll_booth", "odd"])))
    ways = {}
    for way in range(10, 10 + draw(st.integers(2, 6))):
        refs = rng.choice(n, int(rng.integers(2, min(n, 4) + 1)), replace=False) + 1
        tags = {"highway": "primary", "name": 'A, "b" = 100 % @ ü'}
        if rng.random() < 0.3:
            tags["oneway"] = "yes"
        ways[way] = (refs.tolist(), tags)
    turns = {}
    for relation in range(100, 100 + draw(st.integers(0, 4))):
        start, end = rng.choice(list(ways), 2).tolist()
        via = int(rng.integers(1, n + 1))
        members = (("way", start, "from"), ("node", via, "via"), ("way", end, "to"))
        tags = {"type": "restriction", "restriction": str(rng.choice(KINDS))}
        turns[relation] = (members, tags)
    return nodes, ways, turns


def as_answer(nodes, ways, turns, form):
    """The same as Overpass has it: ways first, nodes behind them, or each way with its places."""
    found = []
    for way, (refs, tags) in ways.items():
        element = {"type": "way", "id": way, "nodes": refs, "tags": tags}
        if form == "geom":
            element["geometry"] = [{"lon": nodes[k][0], "lat": nodes[k][1]} for k in refs]
        found.append(element)
    for relation, (members, tags) in turns.items():
        told = [{"type": kind, "ref": ref, "role": role} for kind, ref, role in members]
        found.append({"type": "relation", "id": relation, "members": told, "tags": tags})
    for node, (lon, lat, tags) in nodes.items():
        if form == "body" or tags:
            found.append({"type": "node", "id": node, "lon": lon, "lat": lat, "tags": tags})
    return {"version": 0.6, "elements": found}


def read(folder, answer):
    path = folder / "answer.json"
    path.write_text(json.dumps(answer), encoding="utf-8")
    return read_overpass_cache(path, ROADS, RULES)


@settings(max_examples=60)
@given(maps(), st.sampled_from(["body", "geom"]))
def test_an_answer_is_the_network_of_the_same_osm_file(tmp_path_factory, problem, form):
    folder = tmp_path_factory.mktemp("answers")
    try:
        expected = read_osm(write(folder, *problem[:2], relations=problem[2]), ROADS, RULES)
    except MapDataError:
        with pytest.raises(MapDataError):
            read(folder, as_answer(*problem, form))
        return
    net = read(folder, as_answer(*problem, form))
    assert net.identity() == expected.identity()
    turns = {key: n for key, n in expected.report().counts.items() if "turn" in key}
    barriers = {key: n for key, n in expected.report().counts.items() if "barrier" in key}
    for key, number in {**turns, **barriers}.items():
        assert net.report()[key] == number, key


def test_a_bollard_and_a_forbidden_turn_are_obeyed(tmp_path):
    nodes = {k: (11 + 0.01 * k, 45.0, {}) for k in range(1, 5)}
    nodes[5] = (11.02, 45.01, {})
    nodes[3][2].update(barrier="bollard")
    ways = {
        10: ([1, 2], {"highway": "primary"}),
        11: ([2, 3, 4], {"highway": "primary"}),
        12: ([2, 5], {"highway": "primary"}),
    }
    members = (("way", 10, "from"), ("node", 2, "via"), ("way", 12, "to"))
    turns = {100: (members, {"type": "restriction", "restriction": "no_left_turn"})}
    net = read(tmp_path, as_answer(nodes, ways, turns, "body"))
    assert net.report()["turn restrictions obeyed"] == 1
    assert net.report()["barriers obeyed"] == 1
    assert net.attached(Closures).of(DEFAULT_VEHICLE).closed.any()
    # Node 2 has a copy for whoever comes from node 1.
    assert net.node_id.tolist().count(2) == 2
