"""The bundled corridor of California: the committed extract, its use, and the script."""

from __future__ import annotations

import importlib.util
import re
import subprocess
import sys
import tomllib
from collections import Counter
from pathlib import Path

import numpy as np
import osmium
import pytest
from command_line import run
from places import ROOT

import platoon_osm as po
from platoon_osm.sources.catalog import BUNDLED_MAPS
from platoon_osm.sources.load import load_network

SCRIPT = ROOT / "maps" / "build_california.py"
MAP = ROOT / "maps" / "california-corridor.osm.pbf"
NOTICE = ROOT / "maps" / "california-corridor.LICENSE.txt"

specification = importlib.util.spec_from_file_location("build_california", SCRIPT)
build = importlib.util.module_from_spec(specification)
sys.modules["build_california"] = build
specification.loader.exec_module(build)


@pytest.fixture(scope="module")
def corridor():
    return load_network("california-corridor")


# --- the committed file -------------------------------------------------------------------


def test_it_is_small_and_its_notice_names_licence_source_and_date():
    day = osmium.io.Reader(str(MAP)).header().get("osmosis_replication_timestamp")
    assert MAP.stat().st_size < 1_000_000
    notice = NOTICE.read_text(encoding="utf-8")
    for needed in (MAP.name, "© OpenStreetMap contributors", "Open Database License (ODbL) 1.0",
                   "https://opendatacommons.org/licenses/odbl/1-0/", day):  # fmt: skip
        assert needed in notice
    readme = (ROOT / "maps" / "README.md").read_text(encoding="utf-8")
    assert day[:10] in readme
    assert day.startswith("20")


def test_only_what_a_truck_planner_reads_is_kept():
    counts = Counter()
    tagged = osmium.filter.EmptyTagFilter()
    for entity in osmium.FileProcessor(str(MAP)).with_filter(tagged):
        assert not entity.uid
        assert not entity.user
        for key in (tag.k for tag in entity.tags):
            assert not re.match(r"tiger|source|note|fixme|bicycle|foot|wikidata|created_by", key)
        if (highway := entity.tags.get("highway")) is not None:
            counts[highway] += 1
    assert counts.keys() <= {"motorway", "motorway_junction", "toll_gantry"}
    assert counts["motorway"] > 15_000
    assert counts["motorway_junction"] > 3_000


def test_wheels_hold_every_bundled_map_and_the_notice():
    hatch = tomllib.loads((ROOT / "pyproject.toml").read_text())["tool"]["hatch"]["build"]
    packed = hatch["targets"]["wheel"]["force-include"]
    for file in (*(bundled.file for bundled in BUNDLED_MAPS.values()), NOTICE.name):
        assert packed[f"maps/{file}"] == f"platoon_osm/maps/{file}"
        assert (ROOT / "maps" / file).is_file()


# --- what it is good for ------------------------------------------------------------------


def test_it_hangs_together_through_its_inferred_links(corridor):
    assert corridor.connected_share() > 0.9
    assert corridor.inferred.sum() > 1_000
    assert corridor.length_m[~corridor.inferred].sum() > 8_200e3
    assert load_network(MAP, country="US-CA").connected_share() < 0.1


def test_it_knows_its_country_licence_and_day(corridor):
    source = corridor.source
    assert source.name == "california-corridor"
    assert (source.attribution, source.licence) == ("© OpenStreetMap contributors", "ODbL 1.0")
    assert "2024-09-19" in str(source.extracted)
    # The law of the state: 55 mph for trucks; what more there is has signs for trucks.
    assert np.median(corridor.speed_mps) * 3.6 == pytest.approx(55 * 1.609344)


@pytest.mark.parametrize(
    ("one", "other", "km"),
    [
        # By the signed distances of the roads: I 5 from San Diego; I 5, I 580; I 5; CA 99.
        ("San Diego", "Redding", 1_055), ("Los Angeles", "Oakland", 600),
        ("Los Angeles", "Sacramento", 620), ("Bakersfield", "Sacramento", 452),
    ],
)  # fmt: skip
def test_distances_between_towns_are_those_on_the_signs(corridor, one, other, km):
    weights = po.paper_weights(corridor)
    for origin, destination in ((one, other), (other, one)):
        plan = po.plan_joint(corridor, weights, [po.Trip("A", origin, destination)])
        driven = sum(stretch.length_m for stretch in plan.vehicles[0].legs) / 1000
        assert driven == pytest.approx(km, rel=0.03)


def test_its_demo_plans_three_trucks_and_writes_the_page(capsys, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    assert run("demo", "--map", "california-corridor", "-o", "shown") == 0
    out = capsys.readouterr().out
    assert re.search(r"^B merges with A at I 5 near", out, re.MULTILINE)
    assert re.search(r"^B .*separates at I 5 / I 580 exit 446, Tracy", out, re.MULTILINE)
    assert re.search(r"^Saved: \d+\.\d\d USD", out, re.MULTILINE)
    assert "© OpenStreetMap contributors, ODbL 1.0" in out
    page = Path("shown/demo.html").read_text(encoding="utf-8")
    for needed in ("San Diego to Redding with company", "© OpenStreetMap contributors", "ODbL 1.0"):
        assert needed in page


# --- the script on a made extract ---------------------------------------------------------


def made_extract(path, without=""):
    """Write an extract with a short way of each road, a ramp beyond it, and one far off."""
    nodes, ways = {}, []
    for number, (ref, boxes) in enumerate(build.ROADS.items()):
        south, west, north, east = boxes[0]
        lat, lon = (south + north) / 2, (west + east) / 2
        # The last node lies beyond the box.
        for i, place in enumerate([(lat, lon), (lat, lon + 0.01), (lat + 40, lon)]):
            nodes[number * 10 + i + 1] = place
        if ref != without:
            tags = {"highway": "motorway", "ref": f"X 1; {ref}", "tiger:county": "Y",
                    "maxspeed:hgv": "55 mph", "hgv:conditional": "no @ (22:00-05:00)"}  # fmt: skip
            ways.append(([number * 10 + i for i in (1, 2, 3)], tags))
    link = {"highway": "motorway_link", "note": "long", "destination": "Elsewhere"}
    for node in range(9001, 9006):
        nodes[node] = (36.0, -120.0 + node / 1e5)
    ways += [([9002, 9001], link), ([9001, 1], link), ([9004, 9005], link)]
    ways.append(([9001, 9002], {"highway": "motorway", "ref": "I 999"}))
    lines = []
    for node, (lat, lon) in nodes.items():
        junction = '<tag k="highway" v="motorway_junction"/><tag k="ref" v="7"/>' * (node == 1)
        lines.append(f'<node id="{node}" lat="{lat}" lon="{lon}">{junction}</node>')
    for way, (refs, tags) in enumerate(ways, 1):
        inside = "".join(f'<nd ref="{ref}"/>' for ref in refs)
        inside += "".join(f'<tag k="{key}" v="{value}"/>' for key, value in tags.items())
        lines.append(f'<way id="{way}">{inside}</way>')
    path.write_text(f'<osm version="0.6">{"".join(lines)}</osm>')
    return path


def called(*arguments):
    command = [sys.executable, str(SCRIPT), *map(str, arguments)]
    return subprocess.run(command, capture_output=True, text=True, check=False)


def test_ramps_come_along_roads_end_at_their_edge_and_other_tags_go(tmp_path):
    output = tmp_path / "cut.osm.pbf"
    done = called(made_extract(tmp_path / "made.osm"), "--output", output)
    assert done.returncode == 0, done.stderr
    cut, _ = build.read(output)
    count = len(build.ROADS)
    assert sorted(cut.ways) == [*range(1, count + 1), count + 1, count + 2]
    assert cut.ways[1] == ([1, 2], {
        "highway": "motorway", "ref": f"X 1; {next(iter(build.ROADS))}", "maxspeed:hgv": "55 mph",
        "hgv:conditional": "no @ (22:00-05:00)",
    })  # fmt: skip
    assert cut.ways[count + 1][1] == {"highway": "motorway_link", "destination": "Elsewhere"}
    assert cut.tags == {1: {"highway": "motorway_junction", "ref": "7"}}
    assert set(cut.positions) == {node for nodes, _ in cut.ways.values() for node in nodes}
    again = tmp_path / "again.osm.pbf"
    assert called(output, "--output", again).returncode == 0
    assert again.read_bytes() == output.read_bytes()
    assert {path.name for path in tmp_path.iterdir()} == {"made.osm", output.name, again.name}


def test_stops_for_trucks_near_its_roads_come_along(tmp_path):
    path = made_extract(tmp_path / "made.osm")
    south, west, north, east = next(iter(build.ROADS.values()))[0]
    lat, lon = (south + north) / 2, (west + east) / 2

    def node(number, east, **tags):
        inside = "".join(f'<tag k="{key}" v="{value}"/>' for key, value in tags.items())
        return f'<node id="{number}" lat="{lat + 0.001}" lon="{lon + east}">{inside}</node>'

    nodes = [
        node(8001, 0.001, highway="rest_area", name="Near", note="x"),
        node(8002, 0.9, highway="rest_area", name="Far"),
        node(8003, 0.002, amenity="restaurant"),
        node(8004, 0.003), node(8005, 0.004), node(8006, 0.0035),
    ]  # fmt: skip
    refs = "".join(f'<nd ref="{number}"/>' for number in (8004, 8005, 8006, 8004))
    tags = '<tag k="amenity" v="parking"/><tag k="hgv" v="yes"/><tag k="surface" v="y"/>'
    area = f'<way id="7000">{refs}{tags}<tag k="capacity:hgv" v="30"/></way>'
    text = path.read_text().replace("<way", "".join(nodes) + "<way", 1)
    path.write_text(text.replace("</osm>", area + "</osm>"))
    output = tmp_path / "cut.osm.pbf"
    assert called(path, "--output", output).returncode == 0
    cut, _ = build.read(output)
    assert cut.tags[8001] == {"highway": "rest_area", "name": "Near"}
    assert not {8002, 8003} & cut.positions.keys()
    assert cut.areas == {
        7000: ([8004, 8005, 8006, 8004],
               {"amenity": "parking", "hgv": "yes", "capacity:hgv": "30"}),
    }  # fmt: skip


def test_an_extract_of_elsewhere_is_refused_in_one_line(tmp_path):
    made = made_extract(tmp_path / "made.osm", without="I 5")
    for path, said in ((made, "no way of I 5; give"), (tmp_path / "none.osm.pbf", "give an")):
        done = called(path, "--output", tmp_path / "cut.osm.pbf")
        assert done.returncode == 2
        assert len(done.stderr.splitlines()) == 1
        assert str(path) in done.stderr
        assert said in done.stderr
        assert not (tmp_path / "cut.osm.pbf").exists()
