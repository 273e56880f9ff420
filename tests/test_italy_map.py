"""The bundled map of Italy: the tables, the script that builds it, and the committed file."""

from __future__ import annotations

import csv
import importlib.util
import io
import math
import shutil
import subprocess
import sys
import xml.etree.ElementTree as ET
from collections import defaultdict
from contextlib import redirect_stderr, redirect_stdout
from dataclasses import dataclass
from functools import cache
from itertools import pairwise
from pathlib import Path
from types import ModuleType

import networkx as nx
import pytest

import platoon_osm as po
from platoon_osm.network.road_network import ROAD_CLASSES

ROOT = Path(__file__).resolve().parents[1]
SCRIPT = ROOT / "maps" / "build_italy.py"
TABLES = ROOT / "maps" / "italy"
MAP = ROOT / "maps" / "italy-motorways.osm"
ETIS = ROOT.parent / "shared" / "data" / "etis" / "IT" / "graph.graphml"

MOTORWAYS = [f"A{i}" for i in (*range(1, 17), *range(18, 37), 52, 58, 59, 60)]  # there is no A17

CITIES = {
    "Milano": (45.464, 9.190),
    "Torino": (45.070, 7.687),
    "Genova": (44.407, 8.934),
    "Brennero": (47.002, 11.506),
    "Verona": (45.438, 10.992),
    "Venezia Mestre": (45.490, 12.238),
    "Trieste": (45.650, 13.770),
    "Bologna": (44.494, 11.343),
    "Firenze": (43.770, 11.256),
    "Roma": (41.903, 12.496),
    "Pescara": (42.462, 14.216),
    "Napoli": (40.852, 14.268),
    "Canosa": (41.223, 16.067),
    "Cosenza": (39.299, 16.254),
}

PAIRS = [
    ("Milano", "Torino"),
    ("Milano", "Genova"),
    ("Milano", "Bologna"),
    ("Milano", "Venezia Mestre"),
    ("Torino", "Genova"),
    ("Brennero", "Verona"),
    ("Venezia Mestre", "Trieste"),
    ("Bologna", "Firenze"),
    ("Roma", "Bologna"),
    ("Firenze", "Roma"),
    ("Roma", "Napoli"),
    ("Roma", "Pescara"),
    ("Pescara", "Canosa"),
    ("Napoli", "Canosa"),
    ("Napoli", "Cosenza"),
    ("Milano", "Roma"),
    ("Torino", "Trieste"),
]


@dataclass
class Parsed:
    """An OSM file: positions and tags of nodes, node lists and tags of ways."""

    places: dict[int, tuple[float, float]]
    node_tags: dict[int, dict[str, str]]
    ways: dict[int, tuple[list[int], dict[str, str]]]

    def metres(self, one: int, other: int) -> float:
        return haversine(self.places[one], self.places[other])

    def length(self, way: int) -> float:
        return sum(self.metres(a, b) for a, b in pairwise(self.ways[way][0]))

    def graph(self) -> nx.DiGraph:
        graph = nx.DiGraph()
        for nodes, tags in self.ways.values():
            assert tags.get("oneway") == "yes" or tags.get("route") == "ferry"
            for a, b in pairwise(nodes):
                graph.add_edge(a, b, km=self.metres(a, b) / 1000)
                if "oneway" not in tags:
                    graph.add_edge(b, a, km=self.metres(a, b) / 1000)
        return graph

    def motorway_ways(self, ref: str) -> list[int]:
        return [
            way
            for way, (_, tags) in self.ways.items()
            if tags.get("highway") == "motorway" and tags["ref"] == ref
        ]


def haversine(one: tuple[float, float], other: tuple[float, float]) -> float:
    (lat1, lon1), (lat2, lon2) = (map(math.radians, p) for p in (one, other))
    h = (
        math.sin((lat2 - lat1) / 2) ** 2
        + math.cos(lat1) * math.cos(lat2) * math.sin((lon2 - lon1) / 2) ** 2
    )
    return 2 * 6371008.8 * math.asin(math.sqrt(h))


def tags_of(element: ET.Element) -> dict[str, str]:
    return {tag.attrib["k"]: tag.attrib["v"] for tag in element.iter("tag")}


def parse(path: Path) -> Parsed:
    root = ET.parse(path).getroot()
    nodes = {int(node.attrib["id"]): node for node in root.iter("node")}
    return Parsed(
        {i: (float(n.attrib["lat"]), float(n.attrib["lon"])) for i, n in nodes.items()},
        {i: tags_of(n) for i, n in nodes.items() if len(n)},
        {
            int(way.attrib["id"]): (
                [int(nd.attrib["ref"]) for nd in way.iter("nd")],
                tags_of(way),
            )
            for way in root.iter("way")
        },
    )


def typed(*arguments: str | Path) -> subprocess.CompletedProcess[str]:
    """Run the script as a process of its own."""
    command = [sys.executable, str(SCRIPT), *map(str, arguments)]
    return subprocess.run(command, capture_output=True, text=True, check=False)


@cache
def script() -> ModuleType:
    spec = importlib.util.spec_from_file_location("build_italy", SCRIPT)
    assert spec is not None
    assert spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    sys.modules[spec.name] = module  # its dataclasses look themselves up there
    sys.path.insert(0, str(SCRIPT.parent))
    try:
        spec.loader.exec_module(module)
    finally:
        sys.path.remove(str(SCRIPT.parent))
    return module


def run(*arguments: str | Path) -> subprocess.CompletedProcess[str]:
    """Run what the script does, without a process of its own."""
    out, err = io.StringIO(), io.StringIO()
    given = [str(argument) for argument in arguments]
    with redirect_stdout(out), redirect_stderr(err):
        status = script().main(given)
    return subprocess.CompletedProcess(given, status, out.getvalue(), err.getvalue())


def official_lengths() -> dict[str, float]:
    with (TABLES / "motorways.csv").open(encoding="utf-8", newline="") as table:
        return {row["ref"]: float(row["official_km"]) for row in csv.DictReader(table)}


@pytest.fixture(scope="module")
def italy() -> Parsed:
    return parse(MAP)


@pytest.fixture(scope="module")
def italy_graph(italy: Parsed) -> nx.DiGraph:
    return italy.graph()


@pytest.fixture(scope="module")
def etis() -> nx.DiGraph:
    if not ETIS.exists():
        pytest.skip(f"no ETIS network at {ETIS}: driving distances are not compared")
    return nx.read_graphml(ETIS)


# --- the committed file -------------------------------------------------------------------


def test_tables_rebuild_the_committed_file_byte_for_byte(tmp_path: Path) -> None:
    output = tmp_path / "italy.osm"
    done = typed("--output", output)
    assert done.returncode == 0, done.stderr
    assert output.read_bytes() == MAP.read_bytes()


@pytest.fixture(scope="module")
def check(tmp_path_factory: pytest.TempPathFactory) -> subprocess.CompletedProcess[str]:
    folder = tmp_path_factory.mktemp("check")
    done = run("--check", "--output", folder / "unwritten.osm")
    assert not list(folder.iterdir())
    return done


def test_check_finds_no_error_in_the_tables(check: subprocess.CompletedProcess[str]) -> None:
    assert check.returncode == 0, check.stdout
    assert check.stdout.splitlines()[-1] == "0 errors"


def test_readme_shows_the_numbers_of_check(check: subprocess.CompletedProcess[str]) -> None:
    readme = (ROOT / "maps" / "README.md").read_text(encoding="utf-8")
    table = [line for line in check.stdout.splitlines() if "%" in line or "exits" in line]
    assert len(table) > 26
    missing = [line for line in table if f"    {line}\n" not in readme]
    assert missing == [], "copy the table that `python maps/build_italy.py --check` prints"


def test_at_least_300_junctions_on_both_carriageways(italy: Parsed) -> None:
    on_road: dict[tuple[str, str], set[int]] = defaultdict(set)
    for nodes, tags in italy.ways.values():
        for node in nodes:
            if italy.node_tags.get(node, {}).get("highway") == "motorway_junction":
                on_road[tags.get("ref", "link"), italy.node_tags[node]["name"]].add(node)
    junctions = {key: nodes for key, nodes in on_road.items() if key[0] != "link"}
    assert len(junctions) >= 300
    assert {len(nodes) for nodes in junctions.values()} <= {2, 4}


def test_all_motorways_are_there(italy: Parsed) -> None:
    present = {tags["ref"] for _, tags in italy.ways.values() if tags.get("highway") == "motorway"}
    assert set(MOTORWAYS) <= present
    assert len(set(MOTORWAYS)) == 39


@pytest.mark.parametrize("ref", MOTORWAYS)
def test_built_length_is_within_3_percent_of_the_official_length(italy: Parsed, ref: str) -> None:
    built = sum(italy.length(way) for way in italy.motorway_ways(ref)) / 2000
    assert built == pytest.approx(official_lengths()[ref], rel=0.03)


def test_whole_network_is_strongly_connected(italy_graph: nx.DiGraph) -> None:
    assert nx.is_strongly_connected(italy_graph)


def test_nodes_stand_close_enough_for_a_smooth_road(italy: Parsed) -> None:
    gaps = [
        italy.metres(a, b)
        for nodes, tags in italy.ways.values()
        if tags.get("highway") == "motorway"
        for a, b in pairwise(nodes)
    ]
    assert max(gaps) < 2100
    assert min(gaps) > 3


def test_links_are_short(italy: Parsed) -> None:
    links = [w for w, (_, tags) in italy.ways.items() if tags.get("highway") == "motorway_link"]
    assert max(italy.length(way) for way in links) < 2600


def test_places_and_service_areas_have_names(italy: Parsed) -> None:
    tagged = list(italy.node_tags.values())
    places = [tags for tags in tagged if "place" in tags]
    areas = [tags for tags in tagged if tags.get("highway") in ("services", "rest_area")]
    assert len(places) >= 80
    assert len(areas) >= 50
    assert all(tags["name"] for tags in places + areas)
    assert {"Torino", "Trieste", "Genova", "Belluno", "Chiasso", "Brennero", "Roma"} <= {
        tags["name"] for tags in places
    }
    assert all(int(tags["population"]) > 0 for tags in places)


def test_the_ferry_joins_sicily_to_the_mainland(italy: Parsed, italy_graph: nx.DiGraph) -> None:
    ferries = [(nodes, tags) for nodes, tags in italy.ways.values() if "highway" not in tags]
    (nodes, tags) = ferries[0]
    assert [tags] == [
        {"route": "ferry", "name": "Villa San Giovanni - Messina", "duration": "00:20",
         "hgv": "yes", "motor_vehicle": "yes"}
    ]  # fmt: skip
    assert len(ferries) == 1
    assert 6_000 < italy.metres(*nodes) < 8_000
    ashore = italy_graph.copy()
    ashore.remove_edges_from([(nodes[0], nodes[1]), (nodes[1], nodes[0])])
    parts = list(nx.strongly_connected_components(ashore))
    assert len(parts) == 2
    for part in parts:
        sicilian = {node // 10**8 in (18, 19, 20, 29, 529, 618, 629, 715) for node in part
                    if node < 8 * 10**11}  # fmt: skip
        assert len(sicilian) == 1, "one part is Sicily, the other is not"


def test_trucks_cross_the_strait_and_the_crossing_takes_its_time() -> None:
    net = po.load_network("italy-motorways")
    assert net.connected_share() == pytest.approx(1.0)
    assert net.report()["ferries taken"] == 1
    plan = po.plan_joint(net, po.paper_weights(net), [po.Trip("A", "Napoli", "Palermo")])
    driven = sum(leg.length_m for leg in plan.vehicles[0].legs) / 1000
    assert driven == pytest.approx(715, rel=0.03)  # A3, A2, the strait, A20, A19 by their posts
    ferry = net.road_class == ROAD_CLASSES.index("ferry")
    seconds = net.length_m[ferry] / net.speed_mps[ferry]
    assert len(seconds) == 2
    assert seconds == pytest.approx(20 * 60, rel=0.001)


SICILY = [("Palermo", "Catania", 205), ("Messina", "Catania", 97), ("Palermo", "Trapani", 100)]


@pytest.mark.parametrize(("origin", "destination", "km"), SICILY)
def test_distances_in_sicily_are_those_on_the_signs(origin: str, destination: str, km: int) -> None:
    net = po.load_network("italy-motorways")
    plan = po.plan_joint(net, po.paper_weights(net), [po.Trip("A", origin, destination)])
    driven = sum(leg.length_m for leg in plan.vehicles[0].legs) / 1000
    assert driven == pytest.approx(km, abs=12)


def test_areas_are_open_to_trucks_and_some_say_for_how_many(italy: Parsed) -> None:
    areas = [
        tags for tags in italy.node_tags.values()
        if tags.get("highway") in ("services", "rest_area")
    ]  # fmt: skip
    assert all(tags["hgv"] == "yes" for tags in areas)
    spaces = {tags["name"]: tags["capacity:hgv"] for tags in areas if "capacity:hgv" in tags}
    assert spaces["Autoparco Rovereto Sud"] == "96"
    assert len(spaces) == len((TABLES / "truck_parkings.csv").read_text().splitlines()) - 1


def test_interchanges_lie_where_the_etis_network_has_its_nodes(etis: nx.DiGraph) -> None:
    """ETIS is independent of the tables: of its nodes beside an interchange, most are within 2 km.

    Not all: where a motorway begins, ETIS has the junction of the town's streets beside it.
    """
    gaps = []
    interchanges = {}
    for path in TABLES.glob("[ADR]*.csv"):
        with path.open(encoding="utf-8", newline="") as table:
            for row in csv.DictReader(table):
                if row["kind"] == "interchange":
                    interchanges[path.stem, row["name"]] = float(row["lat"]), float(row["lon"])
    for _, data in etis.nodes(data=True):
        where = data["position_y"], data["position_x"]
        gaps.append(haversine(where, interchanges[nearest(where, interchanges)]) / 1000)
    beside = [gap for gap in gaps if gap < 4]
    assert len(beside) > 60
    assert sum(gap < 2 for gap in beside) > 0.93 * len(beside)


def test_exits_are_compared_with_the_towns_they_are_named_after(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.syspath_prepend(str(ROOT / "maps"))
    import italy_towns

    towns = {"chieti": [(42.35, 14.17)], "ortona": [(42.36, 14.40)], "pistoia": [(43.93, 10.92)]}
    monkeypatch.setattr(italy_towns, "italian_towns", lambda: towns)
    lines = italy_towns.compare([
        italy_towns.Exit("A14", "Chieti Nord-Ortona", 42.36, 14.38),
        italy_towns.Exit("A11", "A11/D11 Pistoia", 43.93, 11.05),
        italy_towns.Exit("A1", "Nessuno", 43.0, 12.0),
    ])  # fmt: skip
    assert lines == [
        "2 of 3 exits bear the name of a town: 50% within 2 km, 50% within 5 km, 50% within 8 km, "
        "100% within 12 km",
        "look:  A11 A11/D11 Pistoia: 10.4 km",
    ]


def test_exits_are_compared_with_waypoints(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    monkeypatch.syspath_prepend(str(ROOT / "maps"))
    from italy_towns import Exit
    from italy_waypoints import compare_waypoints

    url = "http://www.example.org/?"
    (tmp_path / "ita.a099.wpt").write_text(
        f"SS1 +Old {url}lat=45.000000&lon=9.000000\n+X1 {url}lat=45.1&lon=9.1\n\n"
        f"*SP2 {url}lat=45.018000&lon=9.0\nno waypoint\nFar {url}lat=45.05&lon=9.0",
        encoding="utf-8",
    )
    exits = [Exit("A1", "Uno", 45.001, 9.0), Exit("A2", "Due", 46.0, 9.0)]
    assert compare_waypoints(exits, tmp_path) == [
        "2 of 3 waypoints (66.7%) have an exit within 2 km",
        "look:  ita.a099 Far: 5.4 km from A1 Uno",
    ]
    (empty := tmp_path / "none").mkdir()
    assert compare_waypoints(exits, empty)[0].startswith(f"{empty}: holds no waypoints; give ")


def test_pyosmium_reads_the_file(italy: Parsed) -> None:
    osmium = pytest.importorskip("osmium")
    counts = {"n": 0, "w": 0}
    for entity in osmium.FileProcessor(str(MAP)):
        counts[entity.type_str()] += 1
    assert counts == {"n": len(italy.places), "w": len(italy.ways)}


def nearest(where: tuple[float, float], places: dict[object, tuple[float, float]]) -> object:
    return min(places, key=lambda key: haversine(where, places[key]))


def road_nodes_at(
    where: tuple[float, float], places: dict[int, tuple[float, float]]
) -> tuple[set[int], float]:
    """Nodes of all carriageways at a place, and how far away from it they may be in km."""
    gaps = {node: haversine(where, place) / 1000 for node, place in places.items()}
    reach = min(gaps.values()) + 1.0
    return {node for node, gap in gaps.items() if gap <= reach}, reach


@pytest.mark.parametrize(("origin", "destination"), PAIRS)
def test_driving_distance_agrees_with_the_etis_network(
    italy: Parsed, italy_graph: nx.DiGraph, etis: nx.DiGraph, origin: str, destination: str
) -> None:
    """Both networks are coarse: 7 % and the distance between their end points is allowed."""
    etis_places = {
        node: (data["position_y"], data["position_x"]) for node, data in etis.nodes(data=True)
    }
    road_places = {node: italy.places[node] for node in italy_graph}
    start, end = (nearest(CITIES[city], etis_places) for city in (origin, destination))
    assert haversine(CITIES[origin], etis_places[start]) < 8000
    assert haversine(CITIES[destination], etis_places[end]) < 8000
    starts, start_reach = road_nodes_at(etis_places[start], road_places)
    ends, end_reach = road_nodes_at(etis_places[end], road_places)
    assert max(start_reach, end_reach) < 7, "no motorway passes near the ETIS node"
    expected = nx.shortest_path_length(etis, start, end, weight="distance")
    reached = nx.multi_source_dijkstra_path_length(italy_graph, starts, weight="km")
    driven = min(reached[node] for node in ends)
    assert driven == pytest.approx(expected, abs=0.07 * expected + start_reach + end_reach)


# --- the script on small tables -----------------------------------------------------------

SMALL = {
    "motorways.csv": """\
        ref,name,official_km,toll,maxspeed,source
        A1,Prima,40.0,yes,130,example
        A2,Seconda,20.0,no,110,example
        """,
    "A1.csv": """\
        km,kind,name,ref,lat,lon
        0.0,end,Ovest,,45.0000,9.0000
        10.0,service,Area,,,
        21.0,interchange,A1/A2 Centro,,45.0000,9.2500
        30.0,junction,Uscita,7,45.0100,9.3600
        40.0,end,Est,,45.0000,9.4800
        """,
    "A2.csv": """\
        km,kind,name,ref,lat,lon
        0.0,interchange,A1/A2 Centro,,44.9990,9.2510
        9.0,shape,,,44.9200,9.2400
        20.0,end,Sud,,44.8300,9.2500
        """,
    "places.csv": """\
        name,kind,lat,lon,population
        Centro,city,45.0200,9.2500,100000
        """,
}


def small_tables(folder: Path, **changes: tuple[str, str]) -> Path:
    """Write the small tables, with one text replaced per file where asked for."""
    folder.mkdir(exist_ok=True)
    for name, text in SMALL.items():
        lines = "".join(line.strip() + "\n" for line in text.splitlines() if line.strip())
        old, new = changes.get(name.removesuffix(".csv"), ("", ""))
        assert old in lines
        changed = lines.replace(old, new) if old else lines
        (folder / name).write_text(changed, encoding="utf-8", newline="\n")
    return folder


@pytest.fixture
def small(tmp_path: Path) -> Parsed:
    output = tmp_path / "small.osm"
    done = run("--tables", small_tables(tmp_path / "tables"), "--output", output)
    assert done.returncode == 0, done.stderr
    return parse(output)


def test_bends_make_the_road_as_long_as_its_posts(small: Parsed) -> None:
    straight = haversine((45.0, 9.0), (45.0, 9.25)) + haversine((45.0, 9.25), (45.01, 9.36))
    assert straight < 29_000  # the posts say 30 km, so the line must bend
    for ref, km in (("A1", 40.0), ("A2", 20.0)):
        built = sum(small.length(way) for way in small.motorway_ways(ref)) / 2000
        assert built == pytest.approx(km, rel=0.01)


def test_traffic_keeps_to_the_right(small: Parsed) -> None:
    """At every junction the carriageway to the east runs south of the one to the west."""
    heads: dict[str, list[tuple[float, float]]] = defaultdict(list)
    for way in small.motorway_ways("A1"):
        nodes = small.ways[way][0]
        (lat, lon), (_, next_lon) = small.places[nodes[0]], small.places[nodes[-1]]
        heads[small.node_tags[nodes[0]]["name"]].append((next_lon - lon, lat))
    for name in ("A1/A2 Centro", "Uscita"):
        eastbound = next(lat for step, lat in heads[name] if step > 0)
        westbound = next(lat for step, lat in heads[name] if step < 0)
        assert 15e-5 < westbound - eastbound < 30e-5  # 24 m


def test_every_exit_lets_vehicles_leave_enter_and_turn(small: Parsed) -> None:
    graph = small.graph()
    gates = [node for node, tags in small.node_tags.items() if "barrier" in tags]
    assert {small.node_tags[gate]["name"] for gate in gates} == {"Ovest", "Uscita", "Est"}
    through = next(gate for gate in gates if small.node_tags[gate]["name"] == "Uscita")
    assert (graph.in_degree(through), graph.out_degree(through)) == (2, 2)
    end = next(gate for gate in gates if small.node_tags[gate]["name"] == "Est")
    assert (graph.in_degree(end), graph.out_degree(end)) == (1, 1)
    assert nx.is_strongly_connected(graph)


def test_interchange_joins_every_carriageway(small: Parsed) -> None:
    ramps = [
        tags
        for _, tags in small.ways.values()
        if tags.get("highway") == "motorway_link" and tags["maxspeed"] == "60"
    ]
    assert len(ramps) == 4  # A2 ends here: two carriageways in, two out
    assert {tags["destination"] for tags in ramps} == {"A1 Prima", "A2 Seconda"}


def test_a_corrected_exit_changes_only_its_neighbourhood(tmp_path: Path) -> None:
    tables = tmp_path / "tables"
    shutil.copytree(TABLES, tables)
    rows = (tables / "A22.csv").read_text(encoding="utf-8").splitlines()
    inner = [i for i, row in enumerate(rows) if row.split(",")[1] == "junction"]
    target = inner[len(inner) // 2]
    cells = rows[target].split(",")
    cells[-2] = f"{float(cells[-2]) + 0.0005:.4f}"
    rows[target] = ",".join(cells)
    (tables / "A22.csv").write_text("\n".join(rows) + "\n", encoding="utf-8", newline="\n")
    output = tmp_path / "italy.osm"
    assert run("--tables", tables, "--output", output).returncode == 0
    before, after = parse(MAP), parse(output)
    changed = {
        node
        for node in before.places.keys() | after.places.keys()
        if before.places.get(node) != after.places.get(node)
    }
    assert changed
    assert len(changed) < 0.02 * len(before.places)
    kilometre = float(cells[0])
    away = [abs(node // 100 % 10**6 / 1000 - kilometre) for node in changed]
    assert {node // 10**8 for node in changed} == {22}
    assert max(away) < 60


BROKEN = [
    ("A1", ("junction,Uscita", "exit,Uscita"), "A1.csv row 5: kind 'exit' is unknown"),
    ("A1", ("30.0,", "3o.0,"), "A1.csv row 5: km '3o.0' is not a number"),
    ("A1", ("30.0,", "20.0,"), "A1.csv row 5: km 20.0 after km 21.0; sort"),
    ("A1", ("30.0,", "21.0,"), "A1.csv row 5: km 21.0 twice; move"),
    ("A1", ("Uscita,7", ",7"), "A1.csv row 5: junction without a name"),
    ("A1", ("Uscita,7,45.0100,9.3600", "Uscita,7,,"), "A1.csv row 5: junction without position"),
    ("A1", ("45.0100", "54.0100"), "A1.csv row 5: lat 54.0100 is not between 35 and 47.5"),
    ("A1", ("45.0100,9.3600", "45.0000,9.2500"), "A1.csv row 5: same position as A1.csv row 4"),
    ("A1", ("Uscita,7", "Uscita, 7, Nord"), "A1.csv row 5: 7 fields instead of 6; put names"),
    ("A1", ("end,Est", "shape,Est"), "A1.csv row 6: the road ends at a shape row; make it"),
    ("A1", ("km,kind", "chilometri,kind"), "A1.csv row 1: no column 'km'; begin the table"),
    ("A1", ("10.0,service,Area", "10.0,service,"), "A1.csv row 3: service without a name"),
    ("A2", ("A1/A2 Centro", "A1/A2 Altro"), "interchange 'A1/A2 Centro' is in no other table"),
    ("A2", ("A1/A2 Centro", "A1/A4 Centro"), "A2.csv row 2: interchange 'A1/A4 Centro' does not"),
    ("A2", ("44.9990", "44.9700"), "A2.csv row 2: interchange 'A1/A2 Centro' is 3.3 km from A1"),
    ("motorways", ("A2,Seconda", "A3,Seconda"), "A2.csv: not listed in motorways.csv; add a row"),
    ("motorways", ("A2,Seconda", "A1,Seconda"), "motorways.csv row 3: A1 is listed twice"),
    ("motorways", (",no,", ",maybe,"), "motorways.csv row 3: toll 'maybe' is unknown; use one"),
    ("places", ("city", "village"), "places.csv row 2: kind 'village' is unknown; use one of city"),
    ("places", ("100000", "many"), "places.csv row 2: population 'many' is not a number"),
]


@pytest.mark.parametrize(("table", "change", "message"), BROKEN)
def test_a_broken_table_gives_one_line_that_names_file_and_remedy(
    tmp_path: Path, table: str, change: tuple[str, str], message: str
) -> None:
    tables = small_tables(tmp_path / "tables", **{table: change})
    done = run("--tables", tables, "--output", tmp_path / "none.osm")
    assert done.returncode == 2
    assert len(done.stderr.splitlines()) == 1
    assert message in done.stderr
    assert ";" in done.stderr
    assert not (tmp_path / "none.osm").exists()


FERRY = """\
name,minutes,motorway,exit,lat,lon,source
Nave,90,A1,Est,45.0060,9.4900,example
Nave,90,A2,Sud,44.8250,9.2600,example
"""
PARKING = "motorway,km,name,spaces,source\nA1,10.0,Area,80,example\n"


def test_a_ferry_and_spaces_for_trucks_come_from_tables_of_their_own(tmp_path: Path) -> None:
    tables = small_tables(tmp_path / "tables")
    (tables / "ferries.csv").write_text(FERRY)
    (tables / "truck_parkings.csv").write_text(PARKING)
    output = tmp_path / "small.osm"
    done = run("--tables", tables, "--output", output)
    assert done.returncode == 0, done.stderr
    small = parse(output)
    (ferry,) = [tags for _, tags in small.ways.values() if tags.get("route") == "ferry"]
    assert ferry["duration"] == "01:30"
    assert nx.is_strongly_connected(small.graph())
    areas = [tags for tags in small.node_tags.values() if tags.get("highway") == "services"]
    assert [tags["capacity:hgv"] for tags in areas] == ["80"]


@pytest.mark.parametrize(
    ("table", "old", "new", "message"),
    [
        ("ferries", "A1,Est", "A1,Ovest 2", "ferries.csv row 2: A1 has no exit 'Ovest 2'; name"),
        ("ferries", "A1,Est", "A9,Est", "ferries.csv row 2: A9 has no exit 'Est'; name"),
        ("ferries", "Nave,90,A2", "Nave,80,A2", "ferries.csv row 2: ferry 'Nave' needs two rows"),
        ("ferries", "Nave,90,A2", "Barca,90,A2", "ferries.csv row 2: ferry 'Nave' needs two rows"),
        ("ferries", "Nave,90", "Nave,0", "ferries.csv row 2: minutes 0 is not between 1 and"),
        ("ferries", "45.0060", "45.0600", "ferries.csv row 2: the quay is more than 2.5 km from"),
        ("truck_parkings", "10.0", "11.0", "truck_parkings.csv row 2: A1 has no area 'Area' at"),
        ("truck_parkings", "80", "many", "truck_parkings.csv row 2: spaces 'many' is not a number"),
    ],
)
def test_a_broken_table_of_ferries_or_spaces_is_told(
    tmp_path: Path, table: str, old: str, new: str, message: str
) -> None:
    tables = small_tables(tmp_path / "tables")
    text = {"ferries": FERRY, "truck_parkings": PARKING}[table]
    assert old in text
    (tables / f"{table}.csv").write_text(text.replace(old, new, 1))
    done = run("--tables", tables, "--output", tmp_path / "none.osm")
    assert done.returncode == 2
    assert len(done.stderr.splitlines()) == 1
    assert message in done.stderr
    assert ";" in done.stderr


def test_a_missing_table_is_named(tmp_path: Path) -> None:
    tables = small_tables(tmp_path / "tables")
    (tables / "A2.csv").unlink()
    done = run("--tables", tables, "--output", tmp_path / "none.osm")
    assert (done.returncode, done.stderr) == (
        2,
        "A2.csv: missing; add the table (see maps/README.md)\n",
    )


def test_check_reports_posts_closer_than_the_straight_line(tmp_path: Path) -> None:
    tables = small_tables(tmp_path / "tables", A1=("30.0,junction", "27.0,junction"))
    done = run("--tables", tables, "--check")
    assert done.returncode == 1
    assert "error: A1 A1/A2 Centro - Uscita: posts 6.0 km, straight 8.7 km" in done.stdout


def test_check_reports_a_motorway_off_its_official_length(tmp_path: Path) -> None:
    tables = small_tables(tmp_path / "tables", motorways=("Seconda,20.0", "Seconda,21.0"))
    done = run("--tables", tables, "--check")
    assert done.returncode == 1
    assert "error: A2 is -4.8% off its official length" in done.stdout


def test_a_break_leaves_a_gap_in_the_road(tmp_path: Path) -> None:
    gap = "30.0,junction,Uscita,7,45.0100,9.3600\n30.0,break,,,,\n35.0,end,Ripresa,,45.0050,9.4300"
    tables = small_tables(tmp_path / "tables", A1=("30.0,junction,Uscita,7,45.0100,9.3600", gap))
    output = tmp_path / "gap.osm"
    done = run("--tables", tables, "--output", output)
    assert done.returncode == 0, done.stderr
    graph = parse(output).graph()
    assert nx.number_strongly_connected_components(graph) == 2
