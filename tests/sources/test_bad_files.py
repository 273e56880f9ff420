"""Every way a map file can be wrong: one line that names the file, the object and the remedy."""

import bz2
import gzip
from itertools import pairwise

import osmium
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from osm_files import MOTORWAY, row, write, xml
from places import SHARED as BESIDE

from platoon_osm.errors import MapDataError
from platoon_osm.sources.load import load_network

SHARED = BESIDE / "data" / "osm"
WAY = {10: ([1, 2], MOTORWAY)}


def refused(path, *said):
    with pytest.raises(MapDataError) as caught:
        load_network(path)
    message = str(caught.value)
    assert message.startswith(f"{path}: ")
    assert "\n" not in message
    assert len(message) < 400
    for part in said:
        assert part in message


@pytest.mark.parametrize(
    ("name", "content", "said"),
    [
        ("page.osm", b"<html><body>404 Not found</body></html>", "not a readable OSM file"),
        ("text.osm", b"hello", "not a readable OSM file"),
        ("empty.osm", b"", "not a readable OSM file"),
        ("binary.osm", bytes(range(256)) * 4, "not a readable OSM file"),
        ("empty.osm.pbf", b"", "OSM file"),
        ("text.osm.pbf", b"hello, this is no map" * 100, "not a readable OSM file"),
        ("zeros.osm.pbf", bytes(1000), "OSM file"),
        ("text.osm.gz", b"hello", "OSM file"),
        ("text.osm.bz2", b"hello", "download"),
        ("empty.osm.gz", b"", "OSM file"),
        ("empty.osm.bz2", b"", "download"),
        ("map.txt", b"hello", "use .osm.pbf, .osm, .osm.gz or .osm.bz2"),
        ("map", xml(row(2), WAY).encode(), ("its content is XML", "rename it to end in .osm")),
        ("MAP.OSM.PBF", xml(row(2), WAY).encode(), ("its content is XML", "to end in .osm")),
        ("map.osm.pbf", b"<osm version='0.6'></osm>", "its content is XML"),
        ("map.osm", gzip.compress(b"<osm/>", mtime=0), ("packed with gzip", "to end in .osm.gz")),
        ("map.osm", bz2.compress(b"<osm/>"), ("packed with bzip2", "to end in .osm.bz2")),
        ("map.osm", b"\0\0\0\x0d\x0a\x09OSMHeader" + bytes(50), ("PBF", "end in .osm.pbf")),
        ("map.png", b"\x89PNG", "use .osm.pbf, .osm, .osm.gz or .osm.bz2"),
        ("map.platoon", b"", "not a saved network"),
        ("map.json", b"{}", "Overpass"),
        ("map.graphml", b"<osm/>", "GraphML"),
        ("map.gpkg", b"SQLite", "GeoPackage"),
    ],
)
def test_not_osm(tmp_path, name, content, said):
    path = tmp_path / name
    path.write_bytes(content)
    refused(path, *([said] if isinstance(said, str) else said))


BOMB = "".join(f'<!ENTITY {name} "{f"&{inner};" * 10}">' for inner, name in pairwise("abcdefghij"))
READS_A_FILE = '<!ENTITY j SYSTEM "file:///etc/hostname">'


@pytest.mark.parametrize("entities", [f'<!ENTITY a "ha">{BOMB}', READS_A_FILE])
def test_xml_that_would_unpack_to_gigabytes_or_read_other_files(tmp_path, entities):
    head = f'<?xml version="1.0"?><!DOCTYPE x [{entities}]>'
    path = tmp_path / "bomb.osm"
    path.write_text(head + '<osm version="0.6"><node id="1"><tag k="a" v="&j;"/></node></osm>')
    refused(path, "not a readable OSM file")
    path = tmp_path / "bomb.graphml"
    path.write_text(
        f'{head}<graphml xmlns="http://graphml.graphdrawing.org/xmlns"><key id="d0" for="node" '
        'attr.name="x" attr.type="string"/><graph edgedefault="directed"><node id="1">'
        '<data key="d0">&j;</data></node></graph></graphml>'
    )
    refused(path, "not XML, or cut short")


@pytest.mark.parametrize("node", [2**63 - 1, 2**63, -(2**63) - 1])
def test_an_id_that_no_computer_holds(tmp_path, node):
    path = write(tmp_path, row(1) | {node: (11.5, 45.0, {})}, {10: ([1, node], MOTORWAY)})
    refused(path, "illegal id")


@settings(
    max_examples=60, deadline=None, suppress_health_check=[HealthCheck.function_scoped_fixture]
)
@given(st.sampled_from([".osm", ".osm.gz", ".osm.bz2", ".osm.pbf"]), st.data())
def test_a_damaged_file_is_read_or_refused_in_one_line(tmp_path, suffix, data):
    content = bytearray(
        write(tmp_path, row(30), {10: (list(range(1, 31)), MOTORWAY)}, suffix).read_bytes()
    )
    for _ in range(data.draw(st.integers(1, 4))):
        at = data.draw(st.integers(0, len(content) - 1))
        part = data.draw(st.binary(max_size=9))
        content[at : at + data.draw(st.integers(0, 9))] = part
    path = tmp_path / f"damaged{suffix}"
    path.write_bytes(content)
    message = refusal(path)
    if message is not None:
        assert message.startswith(f"{path}: ")
        assert "\n" not in message
        assert len(message) < 500


def refusal(path):
    """Return what is said of a file that is refused, None if it is read."""
    try:
        load_network(path)
    except MapDataError as error:
        return str(error)
    return None


@pytest.mark.parametrize("share", [0.02, 0.3, 0.6, 0.9, 0.99])
def test_a_pbf_that_is_cut_short(tmp_path, share):
    nodes = {i: (11 + i * 0.000123 % 1, 45 + i * 0.000321 % 1, {}) for i in range(1, 9_000)}
    path = write(tmp_path, nodes, {10: (list(range(1, 2_000)), MOTORWAY)}, ".osm.pbf")
    content = path.read_bytes()
    path.write_bytes(content[: int(share * len(content))])
    refused(path, "cut short or damaged", "download it again")


def test_a_real_pbf_that_is_cut_short(tmp_path):
    source = SHARED / "harrisburg.osm.pbf"
    if not source.is_file():
        pytest.skip(f"{source} is not here")
    path = tmp_path / "harrisburg.osm.pbf"
    path.write_bytes(source.read_bytes()[:200_000])
    refused(path, "cut short or damaged", "download it again")


@pytest.mark.parametrize("suffix", [".osm.gz", ".osm.bz2"])
@pytest.mark.parametrize("keep", [0.3, 0.7, 0.98])
def test_a_packed_file_that_is_cut_short(tmp_path, suffix, keep):
    path = write(tmp_path, row(500), {10: (list(range(1, 500)), MOTORWAY)}, suffix)
    content = path.read_bytes()
    path.write_bytes(content[: int(keep * len(content))])
    refused(path, "cut short or damaged", "download it again")


@pytest.mark.parametrize("pack", [bytes, gzip.compress, bz2.compress])
def test_xml_that_is_cut_short(tmp_path, pack):
    suffix = {bytes: "", gzip.compress: ".gz", bz2.compress: ".bz2"}[pack]
    path = tmp_path / f"cut.osm{suffix}"
    path.write_bytes(pack(xml(row(9), WAY).encode()[:-30]))
    refused(path, "line", "download the extract again")


def test_bytes_that_are_no_text(tmp_path):
    path = tmp_path / "odd.osm.pbf"
    writer = osmium.SimpleWriter(osmium.io.File(str(path), "pbf,pbf_compression=none"))
    for node, (lon, lat, _) in row(2).items():
        writer.add_node(osmium.osm.mutable.Node(id=node, location=(lon, lat)))
    writer.add_way(osmium.osm.mutable.Way(id=10, nodes=[1, 2], tags={**MOTORWAY, "name": "QQQQ"}))
    writer.close()
    path.write_bytes(path.read_bytes().replace(b"QQQQ", b"Q\xff\xfeQ"))
    refused(path, "invalid Unicode", "download the extract again")


@pytest.mark.parametrize("suffix", [".osm", ".osm.gz", ".osm.bz2", ".osm.pbf"])
def test_an_empty_area(tmp_path, suffix):
    refused(write(tmp_path, {}, {}, suffix), "no such way", "load other classes or another area")


@pytest.mark.parametrize("suffix", [".osm", ".osm.pbf"])
def test_no_motorway_in_it(tmp_path, suffix):
    path = write(tmp_path, row(2), {10: ([1, 2], {"highway": "primary"})}, suffix)
    refused(path, "no road of class motorway, motorway_link", "load other classes or another area")


def test_no_road_that_trucks_may_use(tmp_path):
    path = write(tmp_path, row(2), {10: ([1, 2], {**MOTORWAY, "motor_vehicle": "no"})})
    refused(path, "closed to all of them", "load other classes or another area")


@pytest.mark.parametrize("suffix", [".osm", ".osm.pbf"])
def test_nodes_missing_from_all_ways(tmp_path, suffix):
    path = write(tmp_path, {}, {10: ([1, 2, 3], MOTORWAY), 11: ([4, 5], MOTORWAY)}, suffix)
    refused(path, "none of 2 ways (first: way 10)", "extract the area again with complete ways")


def test_ways_before_their_nodes(tmp_path):
    path = tmp_path / "order.osm"
    head, *lines = xml(row(2), WAY).splitlines()
    path.write_text("\n".join([head, lines[0], lines[3], *lines[1:3], lines[4]]))
    assert load_network(path).m == 1


@pytest.mark.parametrize("nodes", [[], [1], [1, 1], [1, 77]])
def test_a_way_of_one_node(tmp_path, nodes):
    refused(
        write(tmp_path, row(2), {10: (nodes, MOTORWAY)}), "way 10", "two nodes", "complete ways"
    )


@pytest.mark.parametrize("lon", ["nan", "NaN", "inf", "1e9", "abc", "200", "-180.5", "7,5"])
@pytest.mark.parametrize("suffix", [".osm", ".osm.gz", ".osm.bz2"])
def test_absurd_coordinates(tmp_path, lon, suffix):
    nodes = {7: (lon, 45.0, {}), **row(2, first=8)}
    path = write(tmp_path, nodes, {10: ([8, 7, 9], MOTORWAY)}, suffix)
    refused(path, "node 7", "no place on earth", "correct or remove it")


@pytest.mark.parametrize("tags", [{}, {"highway": "services"}, {"highway": "motorway_junction"}])
@pytest.mark.parametrize("suffix", [".osm", ".osm.pbf"])
def test_a_latitude_beyond_the_pole(tmp_path, tags, suffix):
    nodes = {**row(2), 7: (11.0, 95.0, tags)}
    path = write(tmp_path, nodes, {10: ([1, 7, 2], MOTORWAY)}, suffix)
    refused(path, "node 7", "no place on earth", "correct or remove it")


def test_a_folder(tmp_path):
    refused(tmp_path, "is a folder; give a file in it")


def test_a_missing_file(tmp_path):
    refused(tmp_path / "gone.osm.pbf", "no such file", "italy-motorways")


def test_a_misspelt_bundled_map():
    refused("italy-motorway", "no such file, and no bundled map of that name (italy-motorways,")


def test_a_failed_load_leaves_no_temporary_files(tmp_path, monkeypatch):
    scratch = tmp_path / "scratch"
    scratch.mkdir()
    monkeypatch.setattr("tempfile.tempdir", str(scratch))
    refused(write(tmp_path, {}, {}, ".osm"), "no such way")
    path = tmp_path / "cut.osm.pbf"
    path.write_bytes(b"hello")
    refused(path)
    assert list(scratch.iterdir()) == []
