"""From an OSM file to a contracted network: what is kept, what it means, what is counted."""

import hashlib

import numpy as np
import pytest
from osm_files import MOTORWAY, row, write
from small_osm import NODES, ROADS, WAYS, edge_between

from platoon_osm.network.geodesy import distance_m
from platoon_osm.network.road_network import POINT_KINDS
from platoon_osm.sources.osm.extract import read_osm
from platoon_osm.sources.truck import TruckRules

KINDS = (".osm", ".osm.gz", ".osm.bz2", ".osm.pbf")
RULES = TruckRules("IT")


def read(folder, nodes, ways, classes=("motorway", "motorway_link"), suffix=".osm"):
    return read_osm(write(folder, nodes, ways, suffix), classes, RULES)


def pairs(net):
    """The edges as pairs of OpenStreetMap node ids."""
    return sorted(zip(net.node_id[net.tail].tolist(), net.node_id[net.head].tolist(), strict=True))


@pytest.mark.parametrize("suffix", KINDS)
def test_the_small_map_in_every_form(tmp_path, suffix):
    net = read(tmp_path, NODES, WAYS, ROADS, suffix)
    assert pairs(net) == [(1, 3), (3, 5), (3, 6), (6, 9), (8, 5), (8, 7), (9, 6)]
    kmh = {pair: net.speed_mps[edge_between(net, *pair)] * 3.6 for pair in pairs(net)}
    assert kmh[1, 3] == pytest.approx(80)
    assert 60 < kmh[3, 5] < 70
    assert kmh[8, 7] == pytest.approx(80)
    assert kmh[3, 6] == pytest.approx(50)
    # The primary road has a limit of its own against the way.
    assert (kmh[6, 9], kmh[9, 6]) == (pytest.approx(40), pytest.approx(50))
    node = net.node_id.tolist().index(3)
    assert (net.junction_name(node), net.texts[net.node_ref[node]]) == ("Verona Est", "12")
    east = edge_between(net, 3, 5)
    assert (net.edge_ref(east), net.edge_name(east)) == ("A 4", "Serenissima")
    assert net.edge_name(edge_between(net, 3, 6)) == "Verona"
    assert net.toll[[edge_between(net, 1, 3), east]].all()
    assert not net.toll[edge_between(net, 8, 7)]
    assert net.way_id[edge_between(net, 1, 3)] == 101
    assert net.shape(east)[:, 0].tolist() == [11.02, 11.03, 11.04]
    assert net.length_m[edge_between(net, 8, 7)] == pytest.approx(
        distance_m(11.04, 45.001, 11.00, 45.001)
    )


@pytest.mark.parametrize("suffix", KINDS)
def test_the_counts_of_the_small_map(tmp_path, suffix):
    counts = read(tmp_path, NODES, WAYS, ROADS, suffix).report().counts
    assert dict(counts) == {
        "ways of these classes": 8,
        "ways kept": 7,
        "speed capped for trucks": 2,
        "speed defaulted from road class": 2,
        "ways dropped: closed to all by motor_vehicle": 1,
        "nodes read": 9,
        "directed segments read": 9,
        "nodes after contracting chains": 7,
        "edges after contracting chains": 7,
        "named junctions": 1,
        "numbered junctions": 1,
        "service and rest areas": 0,
    }


def test_all_forms_give_the_same_network(tmp_path):
    nets = [read(tmp_path, NODES, WAYS, ROADS, suffix) for suffix in KINDS]
    assert len({net.identity() for net in nets}) == 1
    for net in nets[1:]:
        np.testing.assert_array_equal(net.shape_lon, nets[0].shape_lon)
        np.testing.assert_array_equal(net.way_id, nets[0].way_id)
        assert list(net.texts) == list(nets[0].texts)


def test_the_source_is_noted(tmp_path):
    net = read(tmp_path, row(2), {1: ([1, 2], MOTORWAY)}, suffix=".osm.pbf")
    content = (tmp_path / "made.osm.pbf").read_bytes()
    assert net.source.name == "made.osm.pbf"
    assert net.source.sha256 == hashlib.sha256(content).hexdigest()
    assert net.source.extracted == "2024-05-01T12:00:00Z"
    assert (net.source.licence, net.source.attribution) == (
        "ODbL 1.0",
        "© OpenStreetMap contributors",
    )


@pytest.mark.parametrize(
    ("oneway", "expected"),
    [("yes", [(1, 3)]), ("-1", [(3, 1)]), ("no", [(1, 3), (3, 1)])],
)
def test_directions(tmp_path, oneway, expected):
    net = read(tmp_path, row(3), {1: ([1, 2, 3], {**MOTORWAY, "oneway": oneway})})
    assert pairs(net) == expected
    for e in range(net.m):
        assert net.shape(e)[0, 0] == net.lon[net.tail[e]]
        assert len(net.shape(e)) == 3


def test_each_direction_of_a_two_way_road_keeps_its_speed_when_chains_merge(tmp_path):
    limits = {"maxspeed": "70", "maxspeed:backward": "35"}
    road = {"highway": "primary", **limits}
    net = read(tmp_path, row(4), {1: ([1, 2, 3, 4], road)}, ["primary"])
    assert pairs(net) == [(1, 4), (4, 1)]
    assert net.speed_mps[edge_between(net, 1, 4)] * 3.6 == pytest.approx(70)
    assert net.speed_mps[edge_between(net, 4, 1)] * 3.6 == pytest.approx(35)


def test_chains_are_contracted_across_ways_and_junctions_stay(tmp_path):
    signs = {3: {"highway": "motorway_junction"}, 4: {"highway": "crossing", "name": "no junction"}}
    ways = {1: ([1, 2, 3], MOTORWAY), 2: ([3, 4, 5], MOTORWAY), 3: ([5, 6], MOTORWAY)}
    net = read(tmp_path, row(6, tags=signs), ways)
    # A junction stays though it has no name; other nodes go, whatever they are called.
    assert pairs(net) == [(1, 3), (3, 6)]
    assert net.report()["named junctions"] == 0


def test_a_junction_number_without_a_name(tmp_path):
    signs = {2: {"highway": "motorway_junction", "ref": "17a"}}
    net = read(tmp_path, row(3, tags=signs), {1: ([1, 2, 3], {**MOTORWAY, "ref": "A 9"})})
    assert net.place_name(net.node_id.tolist().index(2)) == "A 9 exit 17a, Mirandola"


def test_toll_begins_at_its_node(tmp_path):
    ways = {1: ([1, 2], MOTORWAY), 2: ([2, 3], {**MOTORWAY, "toll": "yes"}), 3: ([3, 4], MOTORWAY)}
    net = read(tmp_path, row(4), ways)
    tolls = {pair: bool(net.toll[edge_between(net, *pair)]) for pair in pairs(net)}
    assert tolls == {(1, 2): False, (2, 3): True, (3, 4): False}


def test_services_rest_areas_and_towns_become_points(tmp_path):
    nodes = row(3) | {
        10: (11.5, 45.1, {"highway": "services", "name": "Arda Ovest"}),
        11: (11.6, 45.1, {"highway": "rest_area"}),
        12: (11.7, 45.1, {"place": "city", "name": "Milano", "population": "1 371 498"}),
        13: (11.8, 45.1, {"place": "town", "name": "Lodi", "population": "about 40000"}),
        14: (11.8, 45.1, {"place": "hamlet", "name": "Nowhere"}),
        20: (11.00, 45.2, {}), 21: (11.02, 45.2, {}), 22: (11.02, 45.4, {}), 23: (11.00, 45.4, {}),
    }  # fmt: skip
    ways = {
        1: ([1, 2, 3], MOTORWAY),
        2: ([20, 21, 22, 23], {"highway": "services", "name": "Arda Est"}),
        3: ([20, 21], {"highway": "rest_area"}),
        # Neither of these is a rest area, though their tags say so to a hasty reader.
        4: ([1, 2, 3], {**MOTORWAY, "disused:highway": "rest_area"}),
        5: ([20, 23], {"highway": "primary", "note": "highway=services"}),
    }
    net = read(tmp_path, nodes, ways)
    points = net.points
    rows = {
        (POINT_KINDS[kind], net.texts[name]): (round(lon, 3), round(lat, 3), population)
        for kind, name, lon, lat, population in zip(
            points.kind.tolist(), points.name.tolist(), points.lon.tolist(), points.lat.tolist(),
            points.population.tolist(), strict=True,
        )
    }  # fmt: skip
    assert rows == {
        ("services", "Arda Ovest"): (11.5, 45.1, 0),
        ("rest_area", ""): (11.01, 45.2, 0),
        ("city", "Milano"): (11.7, 45.1, 1_371_498),
        ("town", "Lodi"): (11.8, 45.1, 0),
        ("services", "Arda Est"): (11.01, 45.3, 0),
    }
    assert len(points) == 6
    assert net.report()["service and rest areas"] == 4


def test_a_place_without_coordinates_is_left_out(tmp_path):
    path = write(tmp_path, row(2), {1: ([1, 2], MOTORWAY)})
    nameless = '<node id="99"><tag k="highway" v="services"/></node></osm>'
    path.write_text(path.read_text().replace("</osm>", nameless))
    assert len(read_osm(path, ["motorway"], RULES).points) == 0


STRANGE = [
    "Corso Unità, d'Italia", "A=B", "100 % uphill", "%20%", "😀 Rast😀platz", "  two  spaces ",
    "tab\tin it", "line\nbreak", '<b>"quoted" & \'single\'</b>', "x,y=z n1x7y45", "Nord/Süd\\",
    "@#!;|", "中文 العربية", "nan", "w1 Thighway=motorway",
]  # fmt: skip


@pytest.mark.parametrize("text", STRANGE)
def test_strange_names_come_back_as_they_are(tmp_path, text):
    signs = {2: {"highway": "motorway_junction", "name": text, "ref": text}}
    nodes = row(3, tags=signs) | {9: (11.5, 45.1, {"place": "town", "name": text})}
    ways = {1: ([1, 2, 3], {**MOTORWAY, "name": text, "ref": text, text: text})}
    net = read(tmp_path, nodes, ways, suffix=".osm.pbf")
    node = net.node_id.tolist().index(2)
    assert pairs(net) == [(1, 2), (2, 3)]
    assert net.junction_name(node) == text
    assert net.texts[net.node_ref[node]] == text
    assert (net.edge_name(0), net.edge_ref(0)) == (text, text)
    assert net.texts[net.points.name[0]] == text


def test_every_remark_is_counted_by_ways(tmp_path):
    plain = {"highway": "motorway"}
    ways = {
        1: ([1, 2], plain),
        2: ([2, 3], plain),
        3: ([3, 4], {**MOTORWAY, "maxspeed": "130"}),
        4: ([4, 5], {**MOTORWAY, "maxspeed": "fast"}),
        5: ([5, 6], {**MOTORWAY, "maxspeed:conditional": "60 @ wet", "hgv:conditional": "no @ Su"}),
        6: ([6, 7], {**MOTORWAY, "motor_vehicle": "no"}),
        7: ([7, 7, 8], MOTORWAY),
        8: ([8, 999, 9], MOTORWAY),
        9: ([9], MOTORWAY),
        10: ([9, 10], {"highway": "primary"}),
    }
    report = read(tmp_path, row(10), ways).report()
    assert dict(report.counts) == {
        "ways of these classes": 9,
        "ways kept": 8,
        "speed limits at some hours or in some weather, not judged": 1,
        "restrictions read: hgv:conditional": 1,
        "direction defaulted to one-way (motorway without oneway)": 2,
        "maxspeed not understood": 1,
        "speed capped for trucks": 4,
        "speed defaulted from road class": 3,
        "ways dropped: closed to all by motor_vehicle": 1,
        "nodes missing from ways": 1,
        "ways of fewer than two nodes": 1,
        "repeated nodes skipped": 1,
        "nodes read": 8,
        "directed segments read": 6,
        # One more node, for a restriction by the hour begins there.
        "nodes after contracting chains": 5,
        "edges after contracting chains": 3,
        "named junctions": 0,
        "numbered junctions": 0,
        "service and rest areas": 0,
    }
    assert "8  ways kept" in str(report)


def test_a_node_missing_from_a_way_leaves_a_gap_not_a_shortcut(tmp_path):
    net = read(tmp_path, row(6), {1: ([1, 2, 77, 5, 6], MOTORWAY)})
    assert pairs(net) == [(1, 2), (5, 6)]


def test_only_the_classes_asked_for(tmp_path):
    ways = {1: ([1, 2], MOTORWAY), 2: ([2, 3], {"highway": "trunk", "oneway": "yes"})}
    assert pairs(read(tmp_path, row(3), ways)) == [(1, 2)]
    assert pairs(read(tmp_path, row(3), ways, ["trunk"])) == [(2, 3)]
    both = read(tmp_path, row(3), ways, ["motorway", "trunk"])
    assert pairs(both) == [(1, 3)]


def test_a_ring_is_kept(tmp_path):
    net = read(tmp_path, row(3), {1: ([1, 2, 3, 1], MOTORWAY)})
    assert pairs(net) == [(1, 1)]
    assert len(net.shape(0)) == 4


def test_big_ids(tmp_path):
    big = 2**40 + 1
    nodes = {big: (11.0, 45.0, {}), big + 1: (11.1, 45.0, {})}
    net = read(tmp_path, nodes, {2**41: ([big, big + 1], MOTORWAY)})
    assert pairs(net) == [(big, big + 1)]
    assert net.way_id.tolist() == [2**41]
