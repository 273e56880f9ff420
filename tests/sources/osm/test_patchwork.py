"""Files in several versions, put together from several, or without nodes of their own."""

import json

import osmium
import pytest
from osm_files import write

import platoon_osm as po
from platoon_osm.network.geodesy import distance_m

ROAD = {"highway": "motorway", "oneway": "yes", "maxspeed": "80"}
NODES = {1: (11.0, 45.0), 2: (11.1, 45.0), 3: (11.2, 45.0), 4: (11.1, 45.1)}


def node(number, at=None, version=1, visible=True):
    lon, lat = at or NODES[number]
    place = f'lon="{lon}" lat="{lat}"' if visible else ""
    # Junctions stay nodes, so that each way is an edge of its own.
    sign = '<tag k="highway" v="motorway_junction"/>'
    head = f'<node id="{number}" version="{version}" visible="{str(visible).lower()}" {place}>'
    return f"{head}{sign}</node>"


def way(number, refs, version=1, visible=True, tags=ROAD):
    inside = "".join(f'<nd ref="{ref}"/>' for ref in refs)
    inside += "".join(f'<tag k="{k}" v="{v}"/>' for k, v in tags.items())
    state = str(visible).lower()
    return f'<way id="{number}" version="{version}" visible="{state}">{inside}</way>'


def osm(*parts, head='<osm version="0.6" generator="test">', end="</osm>"):
    return "\n".join(['<?xml version="1.0" encoding="UTF-8"?>', head, *parts, end])


def load(folder, text, name="map.osm"):
    path = folder / name
    path.write_text(text, encoding="utf-8")
    return po.load_network(path, country="IT")


ALL = [node(number) for number in NODES]


def ways_of(net):
    return sorted(set(net.way_id.tolist()))


def test_nodes_behind_the_ways_that_use_them(tmp_path):
    net = load(tmp_path, osm(*ALL[:2], way(10, [1, 2, 3]), way(11, [2, 4]), *ALL[2:]))
    assert ways_of(net) == [10, 11]
    assert net.report()["nodes missing from ways"] == 0
    assert net.length_m.sum() == pytest.approx(
        distance_m(11.0, 45, 11.2, 45) + distance_m(11.1, 45, 11.1, 45.1), rel=1e-6
    )


def test_ways_first_as_overpass_turbo_has_them(tmp_path):
    net = load(tmp_path, osm(way(10, [1, 2, 3]), way(11, [2, 4]), *ALL))
    assert ways_of(net) == [10, 11]


def test_a_node_that_is_nowhere_is_still_missing(tmp_path):
    net = load(tmp_path, osm(*ALL[:2], way(10, [1, 2, 9])))
    assert net.report()["nodes missing from ways"] == 1


@pytest.mark.parametrize("name", ["map.osh", "MAP.OSH", "map.osc"])
def test_the_last_version_counts(tmp_path, name):
    parts = [
        *ALL, node(2, (11.1, 45.05), 2), way(10, [1, 2, 3]), way(10, [1, 2], 2),
        way(11, [2, 3]), way(11, [2, 3], 2, tags={"highway": "track"}),
        way(12, [2, 4]), way(12, [], 2, visible=False, tags={}), way(13, [2, 4]),
        way(14, [3, 4], 2), way(14, [3, 2], 1),
    ]  # fmt: skip
    head, end = '<osm version="0.6" generator="test">', "</osm>"
    if name.endswith("osc"):
        head, end = '<osmChange version="0.6" generator="test"><modify>', "</modify></osmChange>"
        parts = [
            part.replace(' visible="true"', "") for part in parts if 'visible="false"' not in part
        ]
        parts.append("</modify><delete>" + '<way id="12" version="2"/>' + "</delete><modify>")
    net = load(tmp_path, osm(*parts, head=head, end=end), name)
    assert ways_of(net) == [10, 13, 14]
    counts = net.report()
    assert counts["ways left out: deleted"] == 1
    assert counts["ways left out: no such road any more"] == 1
    ends = {int(w): (net.node_id[t], net.node_id[h]) for w, t, h in
            zip(net.way_id, net.tail, net.head, strict=True)}  # fmt: skip
    assert ends[10] == (1, 2)
    assert ends[14] == (3, 4)
    assert net.lat[net.node_id == 2].tolist() == pytest.approx([45.05])


def test_the_newer_of_two_extracts_counts_wherever_it_stands(tmp_path):
    net = load(tmp_path, osm(*ALL, way(10, [1, 2], 3), way(11, [2, 3]), way(10, [1, 4], 2)))
    assert net.node_id[net.head[net.way_id == 10]].tolist() == [2]
    assert net.report()["ways left out: listed again further on"] == 1


def test_ways_that_tell_their_places_themselves(tmp_path):
    source = write(tmp_path, {k: (*at, {}) for k, at in NODES.items()}, {10: ([1, 2, 3], ROAD)})
    target = tmp_path / "located.osm.pbf"
    index = osmium.index.create_map("flex_mem")
    writer = osmium.SimpleWriter(osmium.io.File(str(target), "pbf,locations_on_ways=true"))
    handler = osmium.NodeLocationsForWays(index)
    reader = osmium.io.Reader(str(source))

    class Ways(osmium.SimpleHandler):
        def way(self, one):
            writer.add_way(one)

    osmium.apply(reader, handler, Ways())
    writer.close()
    reader.close()
    net = po.load_network(target, country="IT")
    assert net.m == 1
    assert net.length_m[0] == pytest.approx(distance_m(11.0, 45, 11.2, 45), rel=1e-6)


def test_overpass_lists_nodes_again_without_their_tags(tmp_path):
    named = {"type": "node", "id": 2, "lon": 11.1, "lat": 45.0,
             "tags": {"highway": "motorway_junction", "name": "Mitte"}}  # fmt: skip
    bare = [{"type": "node", "id": k, "lon": lon, "lat": lat} for k, (lon, lat) in NODES.items()]
    ways = [{"type": "way", "id": 10, "nodes": [1, 2, 3], "tags": ROAD}]
    path = tmp_path / "answer.json"
    path.write_text(json.dumps({"version": 0.6, "elements": [named, *ways, *bare]}))
    assert po.load_network(path, country="IT").report()["named junctions"] == 1


def answer(folder, *elements):
    path = folder / "answer.json"
    path.write_text(json.dumps({"version": 0.6, "elements": list(elements)}))
    return po.load_network(path, country="IT")


def line(number, refs, **more):
    geometry = [dict(zip(("lon", "lat"), NODES[ref], strict=True)) for ref in refs]
    return {"type": "way", "id": number, "tags": ROAD, "geometry": geometry, **more}


@pytest.mark.parametrize("named", [True, False])
def test_overpass_ways_with_their_own_geometry(tmp_path, named):
    parts = [line(10, [1, 2, 3], **({"nodes": [1, 2, 3]} if named else {})),
             line(11, [2, 4], **({"nodes": [2, 4]} if named else {}))]  # fmt: skip
    net = answer(tmp_path, *parts)
    assert net.m == 3
    assert net.length_m.sum() == pytest.approx(
        distance_m(11.0, 45, 11.2, 45) + distance_m(11.1, 45, 11.1, 45.1), rel=1e-6
    )
    assert (net.node_id > 0).all() == named


def test_no_road_is_made_across_what_lies_outside_the_area(tmp_path):
    cut = line(10, [1, 2, 3, 4])
    cut["geometry"][1] = None
    net = answer(tmp_path, cut)
    assert (net.m, net.report()["nodes missing from ways"]) == (1, 1)


def test_overpass_ways_listed_again(tmp_path):
    bare = {"type": "way", "id": 10, "nodes": [1, 2, 3]}
    nodes = [{"type": "node", "id": k, "lon": x, "lat": y} for k, (x, y) in NODES.items()]
    net = answer(tmp_path, {**bare, "tags": ROAD}, bare, *nodes)
    assert (net.m, net.report()["ways kept"]) == (1, 1)
    older = {**bare, "nodes": [1, 4], "version": 1, "tags": ROAD}
    newer = {**bare, "version": 2, "tags": ROAD}
    net = answer(tmp_path, newer, older, *nodes)
    assert net.lat.max() == 45.0
