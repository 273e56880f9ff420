"""OSM files written by the tests, as XML text and through libosmium."""

import bz2
import gzip
from xml.sax.saxutils import quoteattr

import osmium


def scattered(rng, n):
    """Return n nodes of a square kilometre, as `xml` takes them."""
    return {
        k + 1: (round(11 + 0.01 * rng.random(), 7), round(45 + 0.01 * rng.random(), 7), {})
        for k in range(n)
    }


def xml(nodes, ways, head='<osm version="0.6" generator="test">', relations=None):
    """Write nodes {id: (lon, lat, tags)}, ways {id: (nodes, tags)} and relations
    {id: ([("way", 1, "from"), ...], tags)} as OSM XML."""

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
    for relation, (members, tags) in (relations or {}).items():
        inside = "".join(
            f'<member type="{kind}" ref="{ref}" role="{role}"/>' for kind, ref, role in members
        )
        lines.append(f'<relation id="{relation}">{inside}{tagged(tags)}</relation>')
    return "\n".join([*lines, "</osm>"])


def write(folder, nodes, ways, suffix=".osm", name="made", relations=None):
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
        for relation, (members, tags) in (relations or {}).items():
            own = [(kind[0], ref, role) for kind, ref, role in members]
            writer.add_relation(osmium.osm.mutable.Relation(id=relation, members=own, tags=tags))
        writer.close()
        return path
    text = xml(nodes, ways, relations=relations).encode()
    pack = {".osm.gz": gzip.compress, ".osm.bz2": bz2.compress}.get(suffix, bytes)
    path.write_bytes(pack(text))
    return path


def row(count, lat=45.0, first=1, tags=None):
    """Return nodes in a row, a hundredth of a degree apart."""
    extra = tags or {}
    return {first + i: (11 + i / 100, lat, extra.get(first + i, {})) for i in range(count)}


MOTORWAY = {"highway": "motorway", "oneway": "yes", "maxspeed": "80"}
