"""The same plan from an OSM file, from lines of a GIS, and from segments as Overture has them.

The bundled map of Italy is written as a GeoPackage, as ogr2ogr makes one of an OSM file: common
tags in columns, the others in one text. And as segments with connectors and rules. Each is loaded
and planned on. Run it with

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
    """Write the roads as segments: each node that two of them share is a connector."""
    every = [road for road in roads(path) if "highway" in road[1]]
    shared = Counter(node for _, _, nodes in every for node in {node for node, _ in nodes})
    features = []
    for number, tags, nodes in every:
        lon, lat = np.array([place for _, place in nodes]).T
        along = np.append(0.0, np.cumsum(distance_m(lon[:-1], lat[:-1], lon[1:], lat[1:])))
        share = along / along[-1]
        ends = {0, len(nodes) - 1}
        speed = tags.get("maxspeed", "")
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
            "speed_limits": [{"max_speed": {"value": int(speed), "unit": "km/h"}}]
            if speed.isdecimal()
            else None,
            "access_restrictions": [ONE_WAY] if tags.get("oneway") == "yes" else None,
            "sources": [{"property": "", "dataset": "OpenStreetMap", "record_id": f"w{number}"}],
        }
        line = {"type": "LineString", "coordinates": [place for _, place in nodes]}
        own = {"type": "Feature", "id": f"s{number}", "geometry": line}
        features.append({**own, "properties": about})
    target.write_text(json.dumps({"type": "FeatureCollection", "features": features}))


def main(page=None):
    """Plan on the three files, by coordinates, for segments have no exits."""
    _, source = bundled_path("italy-motorways")
    trips = [
        po.Trip("A", (9.1900, 45.4642), (12.4964, 41.9028)),
        po.Trip("B", (10.9916, 45.4384), (11.2558, 43.7696)),
    ]
    with tempfile.TemporaryDirectory() as folder:
        lines, segments = Path(folder) / "italy.gpkg", Path(folder) / "italy.geojson"
        write_lines(source, lines)
        write_segments(source, segments)
        nets = {
            path.name: po.load_network(path, country="IT") for path in (source, lines, segments)
        }
    plans = {}
    for name, net in nets.items():
        plans[name] = plan = po.plan_joint(net, po.PaperCosts(), trips)
        km = plan.to_frame()["length_km"].sum()
        print(f"{name}: {net.length_m.sum() / 1000:,.1f} km of road, {km:,.1f} km driven, "
              f"{net.source.attribution}")  # fmt: skip
    print(plans["italy.gpkg"].summary())
    if page:
        po.write_html(plans["italy.gpkg"], nets["italy.gpkg"], page)
        print(f"Map: {page}")


if __name__ == "__main__":
    main(*sys.argv[1:])
