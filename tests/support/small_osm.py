"""A small made-up motorway as OSM XML and as an Overpass answer, for the tests of this folder."""

from __future__ import annotations

NODES = {
    1: (11.00, 45.00, {}),
    2: (11.01, 45.00, {}),
    3: (11.02, 45.01, {"highway": "motorway_junction", "name": "Verona Est", "ref": "12"}),
    4: (11.03, 45.01, {}),
    5: (11.04, 45.00, {}),
    6: (11.02, 45.02, {"highway": "traffic_signals", "name": "not a junction"}),
    7: (11.00, 45.001, {}),
    8: (11.04, 45.001, {}),
    9: (11.05, 45.03, {}),
    10: (11.06, 45.03, {}),
    11: (11.05, 45.0005, {}),
}
MOTORWAY = {"highway": "motorway", "ref": "A 4", "oneway": "yes"}
WAYS = {
    101: ([1, 2, 3], {**MOTORWAY, "maxspeed": "130", "toll": "yes"}),
    102: ([3, 4], {**MOTORWAY, "maxspeed": "60", "toll": "yes", "name": "Serenissima"}),
    103: ([4, 5], {**MOTORWAY, "maxspeed": "70", "toll": "yes", "name": "Serenissima"}),
    # Drawn from west to east, driven from east to west.
    104: ([7, 8], {**MOTORWAY, "oneway": "-1", "maxspeed": "none"}),
    105: ([3, 6], {"highway": "motorway_link", "oneway": "yes", "destination": "Verona"}),
    106: ([6, 9], {"highway": "primary", "maxspeed": "40", "maxspeed:backward": "50"}),
    107: ([5, 11, 8], {"highway": "motorway_link", "oneway": "yes", "motor_vehicle": "no"}),
    108: ([8, 5], {"highway": "motorway_link", "oneway": "yes"}),
    109: ([9, 10], {"highway": "residential"}),
}
ROADS = ("motorway", "motorway_link", "primary")


def as_xml() -> str:
    def tags(items):
        return "".join(f'<tag k="{key}" v="{value}"/>' for key, value in items.items())

    lines = ['<?xml version="1.0" encoding="UTF-8"?>', '<osm version="0.6" generator="test">']
    lines += [
        f'<node id="{node}" lon="{lon}" lat="{lat}">{tags(items)}</node>'
        for node, (lon, lat, items) in NODES.items()
    ]
    for way, (nodes, items) in WAYS.items():
        refs = "".join(f'<nd ref="{node}"/>' for node in nodes)
        lines.append(f'<way id="{way}">{refs}{tags(items)}</way>')
    return "\n".join([*lines, "</osm>"])


def as_overpass() -> dict[str, object]:
    nodes = [
        {"type": "node", "id": node, "lon": lon, "lat": lat, **({"tags": tags} if tags else {})}
        for node, (lon, lat, tags) in NODES.items()
    ]
    ways = [
        {"type": "way", "id": way, "nodes": list(nodes), "tags": dict(tags)}
        for way, (nodes, tags) in WAYS.items()
    ]
    return {
        "version": 0.6,
        "osm3s": {"timestamp_osm_base": "2024-05-01T12:00:00Z", "copyright": "ODbL"},
        "elements": [*ways, *nodes],
    }


def edge_between(net, tail, head):
    """The edge between two OpenStreetMap nodes."""
    ids = net.node_id
    found = [e for e in range(net.m) if (ids[net.tail[e]], ids[net.head[e]]) == (tail, head)]
    assert len(found) == 1, f"{len(found)} edges from {tail} to {head}"
    return found[0]
