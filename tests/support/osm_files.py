"""OSM files written by the tests, as XML text and through libosmium."""

import bz2
import gzip
from xml.sax.saxutils import quoteattr

import osmium


def xml(nodes, ways, head='<osm version="0.6" generator="test">'):
    """Write nodes {id: (lon, lat, tags)} and ways {id: (nodes, tags)} as OSM XML."""

    def tagged(tags):
        return "".join(f"<tag k={quoteattr(k)} v={quoteattr(v)}/>" for k, v in tags.items())

    lines = ['<?xml version="1.0" encoding="UTF-8"?>', head]
    lines += [
        f'<node id="{node}" lon="{lon}" lat="{lat}">{tagged(tags)}</node>'
        for node, (lon, lat, tags) in nodes.items()
    ]
    for way, (refs, tags) in ways.items():
        members = "".join(f'<nd ref="{node}"/>' for node in refs)
        lines.append(f'<way id="{way}">{members}{tagged(tags)}</way>')
    return "\n".join([*lines, "</osm>"])


def write(folder, nodes, ways, suffix=".osm", name="made"):
    """Write a file of any supported kind and return its path."""
    path = folder / f"{name}{suffix}"
    if suffix == ".osm.pbf":
        header = osmium.io.Header()
        header.set("osmosis_replication_timestamp", "2024-05-01T12:00:00Z")
        writer = osmium.SimpleWriter(str(path), header=header, overwrite=True)
        for node, (lon, lat, tags) in nodes.items():
            writer.add_node(osmium.osm.mutable.Node(id=node, location=(lon, lat), tags=tags))
        for way, (refs, tags) in ways.items():
            writer.add_way(osmium.osm.mutable.Way(id=way, nodes=refs, tags=tags))
        writer.close()
        return path
    text = xml(nodes, ways).encode()
    pack = {".osm.gz": gzip.compress, ".osm.bz2": bz2.compress}.get(suffix, bytes)
    path.write_bytes(pack(text))
    return path


def row(count, lat=45.0, first=1, tags=None):
    """Return nodes in a row, a hundredth of a degree apart."""
    extra = tags or {}
    return {first + i: (11 + i / 100, lat, extra.get(first + i, {})) for i in range(count)}


MOTORWAY = {"highway": "motorway", "oneway": "yes", "maxspeed": "80"}
