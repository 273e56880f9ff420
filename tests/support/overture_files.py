"""Maps of the tests as Overture has them: segments with connectors and rules."""

import json

import numpy as np
import pyarrow
import pyarrow.parquet
import shapely

from platoon_osm.network.geodesy import distance_m

HGV = {"mode": ["hgv"]}
DENIED = {"access_type": "denied"}


def height(metres):
    return {
        "dimension": "height", "comparison": "greater_than", "value": metres, "unit": "m",
    }  # fmt: skip


ACCESS = (
    ({}, []),
    ({"oneway": "yes"}, [{**DENIED, "when": {"heading": "backward"}}]),
    ({"oneway": "-1"}, [{**DENIED, "when": {"heading": "forward"}}]),
    ({"hgv": "no"}, [{**DENIED, "when": HGV}]),
    ({"hgv:forward": "no"}, [{**DENIED, "when": {"heading": "forward", **HGV}}]),
    ({"goods": "no", "hgv": "no"}, [{**DENIED, "when": {"mode": ["truck"]}}]),
    ({"access": "no", "hgv": "designated"}, [DENIED, {"access_type": "designated", "when": HGV}]),
    (
        {"access": "private"},
        [DENIED, {"access_type": "allowed", "when": {"recognized": ["as_private"]}}],
    ),
    (
        {"motor_vehicle": "destination"},
        [
            {**DENIED, "when": {"mode": ["motor_vehicle"]}},
            {
                "access_type": "allowed",
                "when": {"mode": ["motor_vehicle"], "using": ["at_destination"]},
            },
        ],
    ),
    (
        {"hgv:conditional": "no @ (Mo-Fr 06:00-09:00)"},
        [{**DENIED, "when": {"during": "Mo-Fr 06:00-09:00", **HGV}}],
    ),
    # A later rule for all takes back what an earlier one says for some.
    ({"access": "no"}, [{"access_type": "allowed", "when": HGV}, DENIED]),
    ({"motor_vehicle": "no"}, [{**DENIED, "when": {"mode": ["motor_vehicle", "foot"]}}]),
    ({}, [{**DENIED, "when": {"mode": ["bicycle"]}}]),
)  # fmt: skip
SIZES = (
    ({}, []),
    ({"maxheight": "3.8"}, [{**DENIED, "when": {"vehicle": [height(3.8)]}}]),
    (
        {"maxweight:hgv": "7.5"},
        [{**DENIED, "when": {**HGV, "vehicle": [{
            "dimension": "weight", "comparison": "greater_than", "value": 7500, "unit": "kg",
        }]}}],
    ),
    (
        {"access:conditional": "no @ (width>2 AND length>=12)"},
        [{**DENIED, "when": {"vehicle": [
            {"dimension": "width", "comparison": "greater_than", "value": 200, "unit": "cm"},
            {"dimension": "length", "comparison": "greater_than_equal", "value": 12, "unit": "m"},
        ]}}],
    ),
)  # fmt: skip
SPEEDS = (
    ({}, []),
    ({"maxspeed": "60"}, [{"max_speed": {"value": 60, "unit": "km/h"}}]),
    ({"maxspeed": "40 mph"}, [{"max_speed": {"value": 40, "unit": "mph"}}]),
    (
        {"maxspeed": "90", "maxspeed:hgv": "70"},
        [
            {"max_speed": {"value": 90, "unit": "km/h"}},
            {"max_speed": {"value": 70, "unit": "km/h"}, "when": HGV},
        ],
    ),
    (
        {"maxspeed:forward": "50"},
        [{"max_speed": {"value": 50, "unit": "km/h"}, "when": {"heading": "forward"}}],
    ),
)  # fmt: skip
"""OpenStreetMap's tags, and the rules that say the same."""


def shares(points):
    """Where each point lies along its line, 0 to 1."""
    lon, lat = np.array(points, float).T
    along = np.concatenate([[0.0], np.cumsum(distance_m(lon[:-1], lat[:-1], lon[1:], lat[1:]))])
    return (along / along[-1]).tolist()


def segment(name, points, kind="primary", connectors=(), **more):
    """A segment; `connectors` are positions in `points` and names."""
    at = shares(points)
    return {
        "id": name, "geometry": points, "subtype": "road", "class": kind,
        "connectors": [{"connector_id": one, "at": at[place]} for place, one in connectors],
        **more,
    }  # fmt: skip


def as_geojson(segments):
    features = [
        {
            "type": "Feature",
            "id": one["id"],
            "geometry": {"type": "LineString", "coordinates": one["geometry"]},
            "properties": {
                "theme": "transportation", "type": "segment", "version": 1,
                **{key: value for key, value in one.items() if key not in ("id", "geometry")},
            },
        }
        for one in segments
    ]  # fmt: skip
    return {"type": "FeatureCollection", "features": features}


def write_overture(path, segments):
    """Write segments as GeoJSON, GeoJSON line by line, or GeoParquet, by the name."""
    if path.suffix == ".parquet":
        # A table has the columns of its first row.
        names = dict.fromkeys(name for one in segments for name in one)
        rows = [
            {**dict.fromkeys(names), **one, "geometry": shapely.LineString(one["geometry"]).wkb}
            for one in segments
        ]
        pyarrow.parquet.write_table(pyarrow.Table.from_pylist(rows), path)
    elif path.suffix == ".geojson":
        path.write_text(json.dumps(as_geojson(segments)), encoding="utf-8")
    else:
        lines = [json.dumps(one) for one in as_geojson(segments)["features"]]
        path.write_text("".join(f"\x1e{line}\n" for line in lines), encoding="utf-8")
    return path
