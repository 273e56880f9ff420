"""Files from an editor, from a file's history, or put together: what is new, deleted, repeated."""

import bz2
import gzip

import osmium
import pytest
from osm_files import MOTORWAY, row, write

from platoon_osm.errors import MapDataError
from platoon_osm.sources.osm.extract import read_osm

DRAFT = """<?xml version='1.0' encoding='UTF-8'?>
<osm version='0.6' generator='JOSM'>
  <node id='-1' action='modify' lat='45.0' lon='9.0'>
    <tag k='highway' v='motorway_junction'/><tag k='name' v='Lodi'/>
  </node>
  <node id='-2' action='modify' lat='45.1' lon='9.1'/>
  <node id='3' version='1' lat='45.2' lon='9.2'/>
  <node id='4' version='1' action='delete' lat='45.3' lon='9.3'/>
  <way id='-10' action='modify'>
    <nd ref='-1'/><nd ref='-2'/><nd ref='3'/>
    <tag k='highway' v='motorway'/><tag k='oneway' v='no'/>
  </way>
  <way id='11' version='2' action='delete'>
    <nd ref='3'/><nd ref='4'/><tag k='highway' v='motorway'/>
  </way>
</osm>
"""


@pytest.mark.parametrize("pack", [bytes, gzip.compress, bz2.compress])
def test_a_draft_with_new_and_deleted_roads(tmp_path, pack):
    suffix = {bytes: "", gzip.compress: ".gz", bz2.compress: ".bz2"}[pack]
    path = tmp_path / f"draft.osm{suffix}"
    path.write_bytes(pack(DRAFT.encode()))
    net = read_osm(path)
    assert sorted(net.node_id.tolist()) == [-1, 3]
    assert net.m == 2
    assert set(net.way_id.tolist()) == {-10}
    assert net.shape(0).shape == (3, 2)
    assert net.lat.max() == pytest.approx(45.2)
    assert net.junction_name(net.node_id.tolist().index(-1)) == "Lodi"
    assert net.report()["ways left out: deleted"] == 1
    assert net.report()["nodes missing from ways"] == 0


def test_a_packed_draft_with_garbage_behind_its_end(tmp_path):
    path = tmp_path / "draft.osm.gz"
    path.write_bytes(gzip.compress(DRAFT.encode()) + b"garbage")
    with pytest.raises(MapDataError, match="damaged behind its end") as caught:
        read_osm(path)
    assert "\n" not in str(caught.value)


@pytest.mark.parametrize("suffix", [".osm", ".osm.pbf"])
def test_a_map_of_negative_ids_alone(tmp_path, suffix):
    nodes = {-node: place for node, place in row(4).items()}
    net = read_osm(write(tmp_path, nodes, {-5: ([-1, -2, -3, -4, -9], MOTORWAY)}, suffix))
    assert net.node_id.tolist() == [-4, -1]
    assert net.report()["nodes missing from ways"] == 1


def test_a_new_node_off_the_globe(tmp_path):
    path = tmp_path / "draft.osm"
    path.write_text(DRAFT.replace("lon='9.1'", "lon='500'"))
    with pytest.raises(MapDataError, match="node -2 has coordinates that are no place on earth"):
        read_osm(path)


def test_ways_listed_twice_are_one_road(tmp_path):
    path = write(tmp_path, row(3), {10: ([1, 2, 3], MOTORWAY), 11: ([3, 2], MOTORWAY)})
    text = path.read_text()
    way = text[text.index('<way id="10">') : text.index('<way id="11">')]
    path.write_text(text.replace("</osm>", way.replace('v="80"', 'v="50"') + "</osm>"))
    net = read_osm(path)
    assert net.report()["ways left out: listed again further on"] == 1
    assert sorted(net.way_id.tolist()) == [10, 10, 11]
    assert net.speed_mps[net.way_id == 10] * 3.6 == pytest.approx(50)


@pytest.mark.parametrize(
    ("versions", "kept"), [("vd", 0), ("vdv", 1), ("vv", 1), ("d", 0), ("dv", 1)]
)
def test_a_file_with_history_gives_the_last_version(tmp_path, versions, kept):
    path = tmp_path / "history.osm.pbf"
    writer = osmium.SimpleWriter(str(path))
    for node, (lon, lat, _) in row(4).items():
        writer.add_node(osmium.osm.mutable.Node(id=node, version=1, location=(lon, lat)))
    for number, kind in enumerate(versions, 1):
        writer.add_way(
            osmium.osm.mutable.Way(
                id=10, version=number, visible=kind == "v",
                nodes=[1, 2] if kind == "v" else [], tags=MOTORWAY,
            )
        )  # fmt: skip
    writer.add_way(osmium.osm.mutable.Way(id=11, version=1, nodes=[3, 4], tags=MOTORWAY))
    writer.close()
    assert read_osm(path).way_id.tolist() == [10] * kept + [11]
