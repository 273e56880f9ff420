"""Overture's segments against the same map as OSM XML; and files that are none."""

import json

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from osm_files import scattered, write
from overture_files import (
    ACCESS,
    SIZES,
    SPEEDS,
    as_geojson,
    segment,
    write_overture,
)

from platoon_osm.errors import MapDataError
from platoon_osm.search.engine import many_to_many
from platoon_osm.sources.load import load_network
from platoon_osm.sources.osm.extract import read_osm
from platoon_osm.sources.overture.rules import access_tags, speed_tags
from platoon_osm.sources.truck import TruckRules
from platoon_osm.vehicles.closures import Closures
from platoon_osm.vehicles.profile import VEHICLES

ROADS = ("motorway", "motorway_link", "primary")
ONE_WAY = {"access_type": "denied", "when": {"heading": "backward"}}
ASKING = [VEHICLES[name] for name in ("eu-40t", "van-3.5t")]


@st.composite
def maps(draw):
    """Roads between few crossings, with rules and prohibited transitions, in both forms."""
    rng = np.random.default_rng(draw(st.integers(0, 2**32 - 1)))
    n = draw(st.integers(3, 7))
    nodes = scattered(rng, n)
    ways, segments = {}, []
    for way in range(10, 10 + draw(st.integers(1, 6))):
        refs = (rng.choice(n, int(rng.integers(2, min(n, 4) + 1)), replace=False) + 1).tolist()
        kind = str(rng.choice(["motorway", "primary", "footway"]))
        tags, more = {"highway": kind}, {}
        if kind == "motorway" and rng.random() < 0.3:
            tags["highway"], more["subclass"] = "motorway_link", "link"
        access, speed = "access_restrictions", "speed_limits"
        for table, name in ((ACCESS, access), (SIZES, access), (SPEEDS, speed)):
            said, rules = table[int(rng.integers(len(table)))]
            tags |= said
            if rules:
                more[name] = [*more.get(name, []), *rules]
        if kind == "motorway" and "oneway" not in tags:
            # What is understood there is said here, before or behind the rest.
            rules = more.setdefault(access, [])
            rules.insert(int(rng.integers(len(rules) + 1)), ONE_WAY)
        if rng.random() < 0.3:
            tags |= {"name": "Via Roma", "ref": "A 1"}
            more |= {
                "names": {"primary": "Via Roma"},
                "routes": [{"ref": "A 1", "network": "it:A"}],
            }
        ways[way] = (refs, tags)
        ends = [(place, f"c{k}") for place, k in enumerate(refs)]
        segments.append(segment(f"s{way}", [nodes[k][:2] for k in refs], kind, ends, **more))
    turns = {}
    for relation in range(100, 100 + draw(st.integers(0, 4))):
        start, end = (int(one) for one in rng.choice(list(ways), 2))
        via = int(rng.choice(ways[start][0]))
        # At an end of both roads heading and direction are one: neither need be divided there.
        if via not in (ways[start][0][-1], ways[start][0][0]) or via not in (
            ways[end][0][0], ways[end][0][-1]
        ) or start == end:  # fmt: skip
            continue
        to_heading = "forward" if ways[end][0][0] == via else "backward"
        forward = ways[start][0][-1] == via
        when = {"heading": "forward" if forward else "backward"}
        key = "restriction"
        if rng.random() < 0.4:
            when["mode"], key = ["hgv"], "restriction:hgv"
        members = (("way", start, "from"), ("node", via, "via"), ("way", end, "to"))
        turns[relation] = (members, {"type": "restriction", key: "no_straight_on"})
        rule = {
            "sequence": [{"connector_id": f"c{via}", "segment_id": f"s{end}"}],
            "final_heading": to_heading,
            "when": when,
        }
        own = next(one for one in segments if one["id"] == f"s{start}")
        own.setdefault("prohibited_transitions", []).append(rule)
    return nodes, ways, turns, segments


def told(net):
    """What a network says of its roads, and to whom, whatever its nodes are called."""
    place = list(zip(net.lon.tolist(), net.lat.tolist(), strict=True))
    judged = [net.attached(Closures).of(vehicle) for vehicle in ASKING]
    return sorted(
        (
            place[net.tail[e]], place[net.head[e]], round(float(net.length_m[e]), 6),
            round(float(net.speed_mps[e]), 9), round(float(net.posted_mps[e]), 9),
            net.texts[net.ref[e]], net.texts[net.name[e]], int(net.road_class[e]),
            [(bool(one.closed[e]), bool(one.ends[e])) for one in judged], net.shape(e).tolist(),
        )
        for e in range(net.m)
    )  # fmt: skip


@settings(max_examples=80)
@given(maps(), st.sampled_from([".parquet", ".geojson", ".geojsonseq"]))
def test_segments_are_the_network_of_the_same_osm_file(tmp_path_factory, problem, suffix):
    folder = tmp_path_factory.mktemp("segments")
    nodes, ways, turns, segments = problem
    path = write_overture(folder / f"map{suffix}", segments)
    try:
        expected = read_osm(write(folder, nodes, ways, relations=turns), ROADS, TruckRules("IT"))
    except MapDataError:
        with pytest.raises(MapDataError):
            load_network(path, ROADS, country="IT")
        return
    net = load_network(path, ROADS, country="IT")
    assert told(net) == told(expected)
    obeyed = "turn restrictions obeyed"
    assert net.report()[obeyed] == expected.report()[obeyed]


def test_limits_and_works_on_a_part_of_a_segment(tmp_path):
    points = [(11.0, 45.0), (11.1, 45.0)]
    own = segment(
        "s", points, "motorway", [(0, "a"), (1, "b")],
        speed_limits=[{"max_speed": {"value": 60, "unit": "km/h"}, "between": [0.25, 0.5]}],
        access_restrictions=[{"access_type": "denied", "when": {"heading": "backward"}}],
        road_flags=[{"values": ["is_under_construction"], "between": [0.9, 1.0]}],
    )  # fmt: skip
    net = load_network(write_overture(tmp_path / "map.parquet", [own]), country="IT")
    whole = 7883.8
    assert net.m == 1
    assert net.length_m[0] == pytest.approx(0.9 * whole, rel=1e-3)
    seconds = 0.25 * whole / (60 / 3.6) + 0.65 * whole / (80 / 3.6)
    assert net.length_m[0] / net.speed_mps[0] == pytest.approx(seconds, rel=1e-3)
    assert net.report()["parts of segments left out: under construction"] == 1


def test_a_transition_over_a_segment_in_between(tmp_path):
    place = {"a": (11.0, 45.0), "b": (11.01, 45.0), "c": (11.02, 45.0), "d": (11.03, 45.0)}
    rule = {
        "sequence": [
            {"connector_id": "b", "segment_id": "bc"}, {"connector_id": "c", "segment_id": "cd"}
        ],
        "final_heading": "forward",
    }  # fmt: skip
    segments = [
        segment(one + other, [place[one], place[other]], "primary", [(0, one), (1, other)])
        for one, other in ("ab", "bc", "cd")
    ]
    segments[0]["prohibited_transitions"] = [rule]
    # A road beside, so that b and c are junctions.
    segments.append(segment("x", [place["b"], (11.01, 45.01)], "primary", [(0, "b"), (1, "e")]))
    net = load_network(write_overture(tmp_path / "map.geojson", segments), ["primary"])
    assert net.report()["turn restrictions obeyed"] == 1
    start = np.flatnonzero(net.lon == 11.0)
    ends = np.flatnonzero(net.lon == 11.03)
    # Not straight on over b and c.
    assert many_to_many(net, net.length_m, start, ends).min() > 4 * 788


def test_transitions_that_name_what_is_not_there_are_counted(tmp_path):
    own = segment("ab", [(11.0, 45.0), (11.1, 45.0)], "primary", [(0, "a"), (1, "b")])
    own["prohibited_transitions"] = [
        {
            "sequence": [{"connector_id": "b", "segment_id": "gone"}],
            "final_heading": "forward",
            "when": when,
        }
        for when in ({"heading": "forward"}, {"using": ["at_destination"]}, {"mode": ["foot"]})
    ]
    report = load_network(write_overture(tmp_path / "map.geojson", [own]), ["primary"]).report()
    assert report["turn restrictions ignored: a member is missing"] == 1
    assert report["turn restrictions ignored: not about goods vehicles"] == 1
    assert report["prohibited transitions not read: for some purpose or size"] == 1


def test_rules_that_say_nothing_to_a_truck_are_counted_or_bind_nobody():
    from collections import Counter

    counts = Counter()
    denied = {"access_type": "denied"}
    odd = {"dimension": "horns", "comparison": "greater_than", "value": 2}
    rules = [
        {**denied, "when": {"using": ["at_destination"]}},
        {**denied, "when": {"vehicle": [odd]}},
        {"access_type": "allowed", "when": {"recognized": ["as_student"]}},
        {**denied, "when": {"mode": ["foot", "bicycle", "car", "bus", "hov", "emergency"]}},
    ]
    assert access_tags(rules, counts) == {"oneway": "no"}
    assert sum(counts.values()) == 2
    assert speed_tags([{"min_speed": {"value": 60, "unit": "km/h"}}], counts) == {}


def test_whose_data_it_is(tmp_path):
    own = segment("ab", [(11.0, 45.0), (11.1, 45.0)], "motorway", [(0, "a"), (1, "b")])
    net = load_network(write_overture(tmp_path / "map.geojson", [own]))
    assert net.source.attribution == "Overture Maps Foundation"
    own["sources"] = [{"property": "", "dataset": "OpenStreetMap", "record_id": "w1@2"}]
    net = load_network(write_overture(tmp_path / "map.parquet", [own]))
    assert net.source.attribution == "© OpenStreetMap contributors, Overture Maps Foundation"
    assert net.source.licence == "ODbL 1.0"


def test_numbers_of_routes_are_told_as_on_signs(tmp_path):
    own = segment(
        "ab", [(-120.0, 37.0), (-120.1, 37.0)], "motorway", [(0, "a"), (1, "b")],
        routes=[{"network": "US:I", "ref": "5"}, {"network": "US:CA", "ref": "99"}, {"ref": None}],
    )  # fmt: skip
    net = load_network(write_overture(tmp_path / "map.parquet", [own]))
    assert net.texts[net.ref[0]] == "I 5;CA 99"


GOOD = segment("ab", [(11.0, 45.0), (11.1, 45.0)], "motorway", [(0, "a"), (1, "b")])


@pytest.mark.parametrize(
    ("change", "said"),
    [
        ({"geometry": [(11, 45), (11, 95)]}, "segment ab has a point that is off the earth"),
        ({"connectors": [{"connector_id": "a", "at": 2.0}]}, "has a connector off its line"),
        ({"connectors": None}, "not a file of Overture segments, or damaged"),
        ({"class": "footway"}, r"found: footway \(1\)"),
        ({"subtype": "rail"}, "found: no road at all"),
        ({"access_restrictions": [{"when": 3}]}, "not a file of Overture segments, or damaged"),
        ({"speed_limits": 80}, "not a file of Overture segments, or damaged"),
    ],
)
def test_broken_segments_say_what_and_where_in_one_line(tmp_path, change, said):
    path = write_overture(tmp_path / "map.geojson", [{**GOOD, **change}])
    with pytest.raises(MapDataError, match=said) as caught:
        load_network(path)
    assert str(path) in str(caught.value)
    assert "\n" not in str(caught.value)


def test_files_that_are_cut_short(tmp_path):
    text = json.dumps(as_geojson([GOOD]))
    path = tmp_path / "map.geojson"
    for end in range(0, len(text) - 1, 7):
        path.write_text(text[:end], encoding="utf-8")
        with pytest.raises(MapDataError) as caught:
            load_network(path)
        assert "\n" not in str(caught.value)
    whole = write_overture(tmp_path / "map.parquet", [GOOD]).read_bytes()
    for end in range(0, len(whole) - 1, 97):
        (tmp_path / "map.parquet").write_bytes(whole[:end])
        with pytest.raises(MapDataError):
            load_network(tmp_path / "map.parquet")


def test_a_segment_is_cut_where_it_crosses_the_antimeridian(tmp_path):
    own = segment(
        "s", [(179.95, -17.0), (-179.95, -17.0)], "motorway", [(0, "a"), (1, "b")],
        speed_limits=[{"max_speed": {"value": 60, "unit": "km/h"}, "between": [0.75, 1.0]}],
        access_restrictions=[{"access_type": "denied", "when": {"heading": "backward"}}],
        road_flags=[{"values": ["is_under_construction"], "between": [0.9, 1.0]}],
    )  # fmt: skip
    net = load_network(write_overture(tmp_path / "map.parquet", [own]), country="NZ")
    assert net.length_m.sum() == pytest.approx(0.9 * 10_647, rel=1e-3)
    assert sorted(net.lon.round(6).tolist())[0] == pytest.approx(-179.96)
    assert np.abs(net.shape_lon).min() > 179.9
