"""Cut the bundled corridor San Diego to Redding out of an OpenStreetMap extract of California.

    python maps/build_california.py california.osm.pbf
    python maps/build_california.py california.osm.pbf --output elsewhere.osm.pbf

Kept are the ways of `ROADS`, the tags of `KEPT_KEYS` that a truck planner reads, the nodes on these
ways, and names, numbers and barriers of nodes; besides rest areas, parkings, fuel and charging
within a kilometre or two, where the extract has them. One of motorways alone has none. Authors,
versions and times of edits are left out; identities are kept, so that each way can be looked up on
openstreetmap.org. The same extract gives the same bytes with the same release of osmium.

The result is a derived database under the Open Database License: it must stay beside its notice,
maps/california-corridor.LICENSE.txt (maps/README.md says how to renew both).
"""

from __future__ import annotations

import argparse
import math
import re
import sys
import tempfile
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field
from itertools import pairwise
from pathlib import Path
from typing import Any

HERE = Path(__file__).resolve().parent
OUTPUT = HERE / "california-corridor.osm.pbf"

NORTH = 40.75
"""Degrees; the corridor ends where Redding ends, 18 km beyond its middle."""

Box = tuple[float, float, float, float]
"""South, west, north, east."""

WHOLE: tuple[Box, ...] = ((32.0, -125.0, NORTH, -114.0),)

ROADS: dict[str, tuple[Box, ...]] = {
    # The three roads along the state.
    "I 5": WHOLE,
    "I 5 Truck": WHOLE,  # lorries must take it past Newhall Pass
    "CA 99": ((34.0, -122.0, 38.6, -118.0),),
    # Pieces of it between are motorways too, but join nothing.
    "US 101": ((34.0, -119.97, 34.5, -118.2), (36.93, -125.0, 38.9, -121.4)),
    # What joins them, from north to south: Sacramento, the Bay, the Valley.
    "I 505": WHOLE,
    "CA 113": ((38.4, -122.0, 38.8, -121.6),),
    "I 80": ((37.7, -122.6, 38.8, -121.2),),
    "I 80 BUS": WHOLE,
    "US 50": ((38.4, -121.7, 38.8, -121.3),),
    "I 780": WHOLE,
    "I 680": WHOLE,
    "I 580": WHOLE,
    "I 880": WHOLE,
    "I 980": WHOLE,
    "I 238": WHOLE,
    "I 280": WHOLE,
    "I 380": WHOLE,
    "I 205": WHOLE,
    "CA 4": ((37.9, -121.4, 38.0, -121.2),),  # I 5 to CA 99 through Stockton
    "CA 120": ((37.7, -121.4, 37.9, -121.1),),  # I 5 to CA 99 through Manteca
    # Los Angeles and San Diego.
    "I 210": WHOLE,
    "CA 210": WHOLE,
    "I 405": WHOLE,
    "I 605": WHOLE,
    "I 710": WHOLE,
    "I 110": WHOLE,
    "I 105": WHOLE,
    "I 10": ((33.9, -118.6, 34.2, -117.2),),  # to San Bernardino
    "CA 60": ((33.9, -118.3, 34.1, -117.2),),
    "CA 57": WHOLE,
    "CA 91": WHOLE,
    "CA 55": WHOLE,
    "CA 134": WHOLE,
    "CA 170": WHOLE,
    "CA 118": WHOLE,
    "I 215": WHOLE,
    "I 15": ((32.0, -118.0, 34.6, -117.0),),  # to Victorville
    "I 805": WHOLE,
    "CA 78": ((33.0, -117.4, 33.3, -117.0),),
}

KEPT_KEYS = re.compile(
    r"highway|ref|name|oneway(:hgv)?|lanes|lanes:(forward|backward)|junction:ref"
    r"|destination(:ref)?|toll(:hgv)?|tunnel|incline|ele"
    r"|max(speed|height|width|length|weight|weightrating|axleload)"
    r"(:(hgv|truck|forward|backward|physical|advisory|type|conditional))*"
    r"|(access|vehicle|motor_vehicle|goods|hgv|hov|hazmat)(:(forward|backward|conditional))*"
    r"|hazmat:[A-E]|barrier|opening_hours"
)
"""What a planner for trucks reads, and the names by which places are found."""

STOP_KEYS = re.compile(
    r"amenity|truck|parking|fee|maxstay|capacity(:(hgv|truck))?|fuel:.*|socket:.*|hgv:(lanes|parking)"
    r"|charging_station:output"
)
"""What a planner reads besides of places where trucks stop."""

STOPS = {
    "highway": ("services", "rest_area"),
    "amenity": ("parking", "fuel", "charging_station"),
}
CELL_DEG = 0.01
"""Stops in the cells of this size beside those of the kept nodes are kept: 1 to 2 km."""

NODE_HIGHWAYS = ("motorway_junction", "toll_gantry", "services", "rest_area")


@dataclass(slots=True)
class Cut:
    """Ways by identity, with their nodes and tags; positions and tags of nodes."""

    ways: dict[int, tuple[list[int], dict[str, str]]] = field(default_factory=dict)
    positions: dict[int, tuple[float, float]] = field(default_factory=dict)
    tags: dict[int, dict[str, str]] = field(default_factory=dict)
    areas: dict[int, tuple[list[int], dict[str, str]]] = field(default_factory=dict)


def boxes_of(ref: str) -> tuple[Box, ...]:
    """Give where the roads of a `ref` such as "I 5;CA 99" are kept."""
    return tuple(box for part in ref.split(";") for box in ROADS.get(part.strip(), ()))


def inside(boxes: Iterable[Box], places: Sequence[tuple[float, float]]) -> slice:
    """Find the first run of nodes that lies in one of the boxes, so that roads end at its edge."""
    within = [
        any(south <= lat <= north and west <= lon <= east for south, west, north, east in boxes)
        for lon, lat in places
    ]
    if not any(within):
        return slice(0)
    first = within.index(True)
    return slice(first, within.index(False, first) if False in within[first:] else None)


def kept(tags: Any) -> dict[str, str]:
    return {tag.k: tag.v for tag in tags if KEPT_KEYS.fullmatch(tag.k)}


def stop_tags(tags: Any) -> dict[str, str]:
    """Give the tags of a place where trucks may stop; none of any other."""
    if not any(tags.get(key) in values for key, values in STOPS.items()):
        return {}
    return {
        tag.k: tag.v for tag in tags if KEPT_KEYS.fullmatch(tag.k) or STOP_KEYS.fullmatch(tag.k)
    }


def read(path: Path) -> tuple[Cut, str]:
    """Read the corridor out of an extract; give it and the time the extract was made."""
    import osmium

    cut = Cut()
    node_tags: dict[int, dict[str, str]] = {}
    areas: dict[int, tuple[dict[int, tuple[float, float]], list[int], dict[str, str]]] = {}
    stops: dict[int, tuple[tuple[float, float], dict[str, str]]] = {}
    entities: Any = osmium.FileProcessor(str(path)).with_locations()
    for entity in entities:
        if entity.is_node():
            tags = kept(entity.tags)
            if tags.get("highway", "motorway_junction") not in NODE_HIGHWAYS:
                del tags["highway"]
            if "highway" in tags or "barrier" in tags:
                node_tags[entity.id] = tags
            if own := stop_tags(entity.tags):
                stops[entity.id] = (entity.location.lon, entity.location.lat), own
        elif entity.is_way() and (own := stop_tags(entity.tags)):
            places_of = {n.ref: (n.lon, n.lat) for n in entity.nodes if n.location.valid()}
            if places_of:
                refs = [n.ref for n in entity.nodes if n.ref in places_of]
                areas[entity.id] = places_of, refs, own
        elif entity.is_way() and entity.tags.get("highway") in ("motorway", "motorway_link"):
            located = [node for node in entity.nodes if node.location.valid()]
            places = [(node.lon, node.lat) for node in located]
            link = entity.tags["highway"] == "motorway_link"
            piece = inside(WHOLE if link else boxes_of(entity.tags.get("ref", "")), places)
            nodes = [node.ref for node in located[piece]]
            if len(nodes) > 1:
                cut.ways[entity.id] = nodes, kept(entity.tags)
                cut.positions.update(zip(nodes, places[piece], strict=True))
    drop_far_links(cut)
    cut.tags = {node: tags for node, tags in node_tags.items() if node in cut.positions}
    add_stops(cut, stops, areas)
    header = osmium.io.Reader(str(path)).header()
    return cut, header.get("osmosis_replication_timestamp")


def add_stops(cut: Cut, stops: dict[int, Any], areas: dict[int, Any]) -> None:
    """Add the places where trucks may stop that lie near a kept node."""
    used = {cell(*at) for at in cut.positions.values()}
    near = {(x + i, y + j) for x, y in used for i in (-1, 0, 1) for j in (-1, 0, 1)}
    for node, (at, tags) in stops.items():
        if cell(*at) in near:
            cut.positions[node], cut.tags[node] = at, tags
    for way, (places, refs, tags) in areas.items():
        if any(cell(*at) in near for at in places.values()):
            cut.positions |= places
            cut.areas[way] = refs, tags


def cell(lon: float, lat: float) -> tuple[int, int]:
    return math.floor(lon / CELL_DEG), math.floor(lat / CELL_DEG)


def drop_far_links(cut: Cut) -> None:
    """Leave out ramps that lead to none of the roads, over other ramps or themselves."""
    links = {way: nodes for way, (nodes, tags) in cut.ways.items() if tags["highway"] != "motorway"}
    reached = {n for way, (nodes, _) in cut.ways.items() if way not in links for n in nodes}
    grown = True
    while grown:
        near = [way for way, nodes in links.items() if not reached.isdisjoint(nodes)]
        for way in near:
            reached.update(links.pop(way))
        grown = bool(near)
    for way in links:
        del cut.ways[way]
    used = {node for nodes, _ in cut.ways.values() for node in nodes}
    cut.positions = {node: at for node, at in cut.positions.items() if node in used}


def write(cut: Cut, extracted: str, output: Path) -> None:
    """Write the corridor as a PBF that appears whole or not at all."""
    import osmium
    from osmium.osm import mutable

    header = osmium.io.Header()
    header.set("generator", "platoon_osm maps/build_california.py")
    if extracted:
        header.set("osmosis_replication_timestamp", extracted)
    lons, lats = zip(*cut.positions.values(), strict=True)
    corners = (min(lons), min(lats)), (max(lons), max(lats))
    header.add_box(osmium.osm.Box(*(osmium.osm.Location(*corner) for corner in corners)))
    with tempfile.TemporaryDirectory(dir=output.parent) as folder:
        draft = Path(folder) / "draft.osm.pbf"
        file = osmium.io.File(str(draft), "pbf,add_metadata=none,pbf_compression_level=9")
        with osmium.SimpleWriter(file, header=header) as writer:
            for node in sorted(cut.positions):
                at = cut.positions[node]
                writer.add_node(mutable.Node(id=node, location=at, tags=cut.tags.get(node, {})))
            ways = {**cut.ways, **cut.areas}
            for way in sorted(ways):
                nodes, tags = ways[way]
                writer.add_way(mutable.Way(id=way, nodes=nodes, tags=tags))
        draft.replace(output)


def length_km(cut: Cut) -> dict[str, float]:
    """Sum the carriageways of each road by its first number [km]."""
    total: dict[str, float] = {}
    for nodes, tags in cut.ways.values():
        places = [cut.positions[node] for node in nodes]
        ref = tags.get("ref", "").split(";")[0] or tags["highway"]
        for (lon, lat), (lon2, lat2) in pairwise(places):
            east = (lon2 - lon) * math.cos(math.radians((lat + lat2) / 2))
            total[ref] = total.get(ref, 0.0) + math.hypot(east, lat2 - lat) * 111.195
    return total


def main(arguments: list[str] | None = None) -> int:
    parser = argparse.ArgumentParser(description=(__doc__ or "").split("\n", 1)[0])
    parser.add_argument("extract", type=Path, help="extract of California (.osm.pbf)")
    parser.add_argument("--output", type=Path, default=OUTPUT, help="file to write")
    options = parser.parse_args(arguments)
    try:
        cut, extracted = read(options.extract)
    except (OSError, RuntimeError) as error:
        print(f"{options.extract}: {error}; give an extract of California", file=sys.stderr)
        return 2
    missing = sorted(ROADS.keys() - {r.strip() for _, tags in cut.ways.values()
                                     for r in tags.get("ref", "").split(";")})  # fmt: skip
    if missing:
        print(f"{options.extract}: no way of {', '.join(missing)}; give an extract of the whole of "
              "California", file=sys.stderr)  # fmt: skip
        return 2
    write(cut, extracted, options.output)
    for ref, km in sorted(length_km(cut).items()):
        print(f"{ref:16}{km:8.1f} km")
    size = options.output.stat().st_size
    print(f"{options.output.name}: {len(cut.ways)} ways, {len(cut.positions)} nodes, {size:,} bytes"
          f", OpenStreetMap data of {extracted or 'an unknown day'}")  # fmt: skip
    return 0


if __name__ == "__main__":
    sys.exit(main())
