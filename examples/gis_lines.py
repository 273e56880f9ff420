"""One map as an OSM file, as lines of a GIS, and as segments in the manner of Overture.

The bundled extract of California is written as a GeoPackage, as ogr2ogr makes one of an OSM file:
common tags in columns, the others in one text. That gives the same network and plan. Its north is
written as segments with connectors and rules. Run it with

    python examples/gis_lines.py [page.html]
"""

import json
import sys
import tempfile
from collections import Counter
from pathlib import Path

import geopandas
import numpy as np
import osmium
import shapely

import platoon_osm as po
from platoon_osm.network.geodesy import distance_m
from platoon_osm.sources.catalog import bundled_path

COLUMNS = ("highway", "name", "ref", "oneway", "maxspeed")
NORTH_LAT = 38.0
NO_TRUCKS = {"access_type": "denied", "when": {"mode": ["hgv"]}}
ONE_WAY = {"access_type": "denied", "when": {"heading": "backward"}}


def roads(path):
    """Yield id, tags, and node ids with their places, of each road of an OSM file."""
    for way in osmium.FileProcessor(str(path)).with_locations():
        if way.is_way() and ("highway" in way.tags or way.tags.get("route") == "ferry"):
            nodes = [(node.ref, (node.lon, node.lat)) for node in way.nodes]
            yield way.id, dict(way.tags), nodes


def row(number, tags):
    """Return the columns of one thing."""
    others = {key: value for key, value in tags.items() if key not in COLUMNS}
    text = ",".join(f'"{key}"=>"{value}"' for key, value in others.items())
    return {"osm_id": str(number), **{key: tags.get(key) for key in COLUMNS}, "other_tags": text}


def write_lines(path, target):
    """Write the roads as a layer of lines, exits and rest areas as one of points."""
    rows, lines = [], []
    for number, tags, nodes in roads(path):
        rows.append(row(number, tags))
        lines.append(shapely.LineString([place for _, place in nodes]))
    geopandas.GeoDataFrame(rows, geometry=lines, crs=4326).to_file(target, layer="lines")
    nodes = [
        (row(node.id, dict(node.tags)), shapely.Point(node.lon, node.lat))
        for node in osmium.FileProcessor(str(path), osmium.osm.NODE)
        if len(node.tags)
    ]
    rows, points = zip(*nodes, strict=True)
    geopandas.GeoDataFrame(rows, geometry=list(points), crs=4326).to_file(target, layer="points")


def write_segments(path, target):
    """Write the roads of the north as segments: each node that two share is a connector."""
    every = [road for road in roads(path) if road[2][0][1][1] > NORTH_LAT]
    shared = Counter(node for _, _, nodes in every for node in {node for node, _ in nodes})
    features = []
    for number, tags, nodes in every:
        lon, lat = np.array([place for _, place in nodes]).T
        along = np.append(0.0, np.cumsum(distance_m(lon[:-1], lat[:-1], lon[1:], lat[1:])))
        share = along / along[-1]
        ends = {0, len(nodes) - 1}
        speed, _, unit = tags.get("maxspeed", "").partition(" ")
        about = {
            "subtype": "road",
            "class": tags["highway"].removesuffix("_link"),
            "subclass": "link" if tags["highway"].endswith("_link") else None,
            "names": {"primary": tags["name"]} if "name" in tags else None,
            "routes": [{"ref": tags["ref"]}] if "ref" in tags else None,
            "connectors": [
                {"connector_id": f"n{node}", "at": float(share[k])}
                for k, (node, _) in enumerate(nodes)
                if k in ends or shared[node] > 1
            ],
            "speed_limits": [{"max_speed": {"value": int(speed), "unit": unit or "km/h"}}]
            if speed.isdecimal()
            else None,
            "access_restrictions": [
                *([ONE_WAY] if tags.get("oneway") == "yes" else []),
                *([NO_TRUCKS] if tags.get("hgv") == "no" else []),
            ],
            "sources": [{"property": "", "dataset": "OpenStreetMap", "record_id": f"w{number}"}],
        }
        line = {"type": "LineString", "coordinates": [place for _, place in nodes]}
        own = {"type": "Feature", "id": f"s{number}", "geometry": line}
        features.append({**own, "properties": about})
    target.write_text(json.dumps({"type": "FeatureCollection", "features": features}))


def main(page=None):
    """Load the three files, and plan on the first two."""
    _, source = bundled_path("california-corridor")
    trips = [
        po.Trip("A", (-117.1611, 32.7157), (-122.3917, 40.5865)),
        po.Trip("B", (-119.7871, 36.7378), (-121.4944, 38.5816)),
    ]
    with tempfile.TemporaryDirectory() as folder:
        lines, segments = Path(folder) / "california.gpkg", Path(folder) / "california.geojson"
        write_lines(source, lines)
        write_segments(source, segments)
        nets = [
            po.load_network(path, country="US-CA", infer_links=True) for path in (source, lines)
        ]
        north = po.load_network(segments, country="US-CA")
    for net in (*nets, north):
        print(f"{net.source.name}: {net.length_m.sum() / 1000:,.1f} km, {net.source.attribution}")
    from_osm, from_lines = (po.plan_joint(net, po.PaperCosts(), trips) for net in nets)
    print(f"The same plan from lines: {from_lines.summary() == from_osm.summary()}\n")
    print(from_lines.summary())
    if page:
        po.write_html(from_lines, nets[1], page)
        print(f"Map: {page}")


if __name__ == "__main__":
    main(*sys.argv[1:])
