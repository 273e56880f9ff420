"""From the ways of an OSM file to a contracted road network for trucks."""

from __future__ import annotations

import os
from collections import Counter
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...errors import MapDataError, NetworkError
from ...network.geodesy import distance_m
from ...network.load_report import LoadReport
from ...network.preparing.simplify import merge_chains
from ...network.preparing.turning_round import no_turning_round
from ...network.preparing.turns import split_turns
from ...network.restrictions import Layer, decode, encode
from ...network.road_network import (
    POINT_KINDS,
    ROAD_CLASSES,
    STOP_KINDS,
    NamedPoints,
    RoadNetwork,
)
from ...network.texts import encode_texts
from ..road_choice import class_code
from ..truck import (
    BACKWARD,
    FORWARD,
    TruckRules,
)
from .barriers import barrier_layers
from .climbs import drawn_slopes
from .places import MapPoint, map_stops, map_tunnels
from .raw_map import RawMap, TagReader
from .raw_osm import read_raw
from .turn_relations import Segments, forbidden_turns
from .way_table import WayTable, interpreted

__all__ = ["MOTORWAY_CLASSES", "network_of", "read_osm"]

MOTORWAY_CLASSES = ("motorway", "motorway_link")
PLACE_TAGS = frozenset({"highway", "place", "name", "ref", "population", "barrier", "amenity"})
AREA_KINDS = ("services", "rest_area")
POINT_LABELS = {
    **dict.fromkeys(AREA_KINDS, "service and rest areas"),
    "parking": "truck parkings beside them",
    "fuel": "fuel stations for trucks beside them",
    "charging": "charging stations for trucks beside them",
    "tunnel": "tunnels with an ADR category",
}
SIGNED_BARRIERS = ("", "toll_booth", "border_control")
"""Barriers whose name stands on a sign at the road; "" for nodes without one."""

SIDED = [ROAD_CLASSES.index(name) for name in ("motorway", "trunk", "primary")]
"""Roads that part stops: what lies on the other side of one is another stop."""


def read_osm(
    path: str | os.PathLike[str],
    classes: Sequence[str] = MOTORWAY_CLASSES,
    rules: TruckRules | None = None,
) -> RoadNetwork:
    """Read an OSM extract (.osm.pbf, .osm, .osm.gz, .osm.bz2) into a contracted network.

    Parameters
    ----------
    path : path-like
        The file.
    classes : sequence of str
        Values of the `highway` tag to load.
    rules : TruckRules or None
        How to read tags for a truck.

    Returns
    -------
    RoadNetwork
        The network.

    Raises
    ------
    MapDataError
        Unreadable file, or no road of these classes in it.
    """
    file = Path(path)
    return network_of(read_raw(file, classes), str(file), classes, rules or TruckRules())


def network_of(raw: RawMap, what: str, classes: Sequence[str], rules: TruckRules) -> RoadNetwork:
    """Make the contracted network of a map that is ways over nodes, with tags.

    Parameters
    ----------
    raw : RawMap
        The map.
    what : str
        The file, to begin messages with.
    classes : sequence of str
        Values of the `highway` tag to load.
    rules : TruckRules
        How to read tags for a truck.

    Returns
    -------
    RoadNetwork
        The network.

    Raises
    ------
    MapDataError
        No road of these classes in it, or none with coordinates.
    """
    ways = interpreted(raw, set(classes), rules)
    ashore = ways.road_class != class_code("ferry")
    if not (ways.kept & ashore).any():
        any_road = (ways.road & ashore).any()
        found = "its ways are closed to all of them" if any_road else "it has no such way"
        raise MapDataError(
            f"{what}: no road of class {', '.join(classes)} for goods vehicles ({found}); "
            "load other classes or another area"
        )
    net = _network(what, raw, ways)
    count = net.load_report.counts
    if not net.m:
        first = raw.way_id[np.argmax(ways.kept)]
        raise MapDataError(
            f"{what}: none of {count['ways kept']} ways (first: way {first}) has two nodes with "
            "coordinates; extract the area again with complete ways"
        )
    return net


def _network(what: str, raw: RawMap, ways: WayTable) -> RoadNetwork:
    counts = {**ways.counts, **raw.left_out}
    way = np.repeat(np.arange(len(raw.way_id)), np.diff(raw.first))
    present = ~np.isnan(raw.lon)
    on_road = ways.kept[way]
    counts["nodes missing from ways"] = int((on_road & ~present).sum())
    counts["ways of fewer than two nodes"] = int((np.diff(raw.first)[ways.kept] < 2).sum())
    # A segment joins two nodes that follow each other on a way and that the file both has.
    start = np.flatnonzero(on_road[:-1] & (way[:-1] == way[1:]) & present[:-1] & present[1:])
    told: Counter[str] = Counter()
    climbs = drawn_slopes(raw, start, way[start], ways.slope, told)
    repeated = raw.ref[start] == raw.ref[start + 1]
    counts["repeated nodes skipped"] = int(repeated.sum())
    start = start[~repeated]
    counts = {name: number for name, number in counts.items() if number or name == "ways kept"}
    ids, place, node = np.unique(
        raw.ref[np.concatenate([start, start + 1])], return_index=True, return_inverse=True
    )
    at = np.concatenate([start, start + 1])[place]
    tail, head = node[: len(start)], node[len(start) :]
    of = way[start]
    forward, backward = ways.direction[of] != BACKWARD, ways.direction[of] != FORWARD
    tails = np.concatenate([tail[forward], head[backward]])
    heads = np.concatenate([head[forward], tail[backward]])
    source_way = np.concatenate([of[forward], of[backward]])

    def both(along: NDArray[Any], against: NDArray[Any]) -> NDArray[Any]:
        return np.concatenate([along[of[forward]], against[of[backward]]])

    barriers = barrier_layers(raw, ids, tails, heads, told)
    drawn = Segments(
        tails, heads, source_way, np.concatenate([start[forward], start[backward]]),
        np.repeat([True, False], [int(forward.sum()), int(backward.sum())]),
    )  # fmt: skip
    summed = {} if climbs is None else climbs.of(~repeated).columns(forward, backward)
    turns = forbidden_turns(raw, drawn, ids, told)
    turns += no_turning_round(tails, heads, len(ids), turns)
    split = split_turns(tails, heads, len(ids), turns)
    own, spot = split.origin, split.node_origin
    base = both(ways.restriction, ways.backward_restriction)[own]
    at_nodes = {node: (layer,) for node, layer in barriers.items()}
    passed = {
        segment: encode(
            (
                *decode(ways.texts[base[segment]]),
                *at_nodes.get(node, ()),
                *split.layers.get(segment, ()),
            )
        )
        for segment, node in _restricted(tails[own], at_nodes, split.layers)
    }

    summed = {name: values[own] for name, values in summed.items()}
    free = np.flatnonzero(ways.toll_free[source_way[own]])
    if len(free):
        ends = at[spot][np.stack([split.tail[free], split.head[free]])]
        summed["toll_free_m"] = np.zeros(len(own))
        summed["toll_free_m"][free] = distance_m(
            raw.lon[ends[0]], raw.lat[ends[0]], raw.lon[ends[1]], raw.lat[ends[1]]
        )

    junctions, towns = _named_nodes(raw, ids)
    sided = start[np.isin(ways.road_class[of], SIDED)]
    lines = np.column_stack(
        [raw.lon[sided], raw.lat[sided], raw.lon[sided + 1], raw.lat[sided + 1]]
    )
    points = [
        *map_stops(raw, np.flatnonzero(~ways.road), lines, told),
        *map_tunnels(raw, np.flatnonzero(ways.kept), told),
        *towns,
    ]
    texts, codes = encode_texts(
        ways.texts, [row[1] for row in junctions], [row[2] for row in junctions],
        [row.name for row in points], list(passed.values()), [row.tags for row in points],
    )  # fmt: skip
    restriction = codes[0][base]
    restriction[list(passed)] = codes[4]
    position = [row[0] for row in junctions]
    node_name, node_ref = np.zeros(len(ids), np.int32), np.zeros(len(ids), np.int32)
    node_name[position], node_ref[position] = codes[1], codes[2]
    keep = np.zeros(len(ids), bool)
    keep[position] = [row[3] for row in junctions]
    # A quay stays, so that a crossing is an edge of its own.
    afloat = ways.road_class[of] == class_code("ferry")
    if afloat.any():
        keep[np.intersect1d(node[np.tile(afloat, 2)], node[np.tile(~afloat, 2)])] = True
    report = LoadReport(counts | dict(sorted(told.items())))
    try:
        net = RoadNetwork.from_edges(
            split.tail, split.head,
            lon=raw.lon[at][spot], lat=raw.lat[at][spot],
            speed_mps=both(ways.speed_mps, ways.backward_mps)[own],
            posted_mps=both(ways.posted_mps, ways.backward_posted_mps)[own],
            restriction=restriction,
            node_id=ids[spot], node_name=node_name[spot], node_ref=node_ref[spot],
            road_class=ways.road_class[source_way[own]], ref=codes[0][ways.ref[source_way[own]]],
            name=codes[0][ways.name[source_way[own]]],
            country=codes[0][ways.country[source_way[own]]], toll=ways.toll[source_way[own]],
            way_id=raw.way_id[source_way[own]],
            **summed, texts=texts, points=_points(points, codes[3], codes[5]),
            source=raw.source, report=report,
        )  # fmt: skip
    except NetworkError as error:
        raise MapDataError(f"{what}: {error}") from error
    merged = merge_chains(net, keep[spot])
    if merged.graded_m.any():
        report = report.extended({"km of known grade": round(merged.graded_m.sum() / 1000)})
    sizes = {
        "nodes read": net.n, "directed segments read": net.m,
        "nodes after contracting chains": merged.n, "edges after contracting chains": merged.m,
        "named junctions": int((merged.node_name > 0).sum()),
        "numbered junctions": int((merged.node_ref > 0).sum()),
    }  # fmt: skip
    sizes["service and rest areas"] = 0
    for code, kind in enumerate(POINT_KINDS[: POINT_KINDS.index("city")]):
        number = int((merged.points.kind == code).sum())
        label = POINT_LABELS[kind]
        if number or kind in AREA_KINDS:
            sizes[label] = sizes.get(label, 0) + number
    return merged.with_report(report.extended(sizes))


def _restricted(
    tails: NDArray[np.int64],
    at_nodes: Mapping[int, tuple[Layer, ...]],
    turns: Mapping[int, tuple[Layer, ...]],
) -> list[tuple[int, int]]:
    """Return the segments that a barrier or a turn restricts, each with the node it leaves."""
    if not at_nodes and not turns:
        return []
    leaving = np.flatnonzero(np.isin(tails, list(at_nodes)))
    some = sorted({*leaving.tolist(), *turns})
    return [(segment, int(tails[segment])) for segment in some]


def _named_nodes(
    raw: RawMap, ids: NDArray[np.int64]
) -> tuple[list[tuple[int, str, str, bool]], list[MapPoint]]:
    """Sort tagged nodes into junctions on the roads, and towns beside them."""
    junctions, towns = [], []
    read_tags = TagReader(PLACE_TAGS.__contains__)
    wanted = np.array([row[0] for row in raw.nodes], np.int64)
    position = np.searchsorted(ids, wanted)
    for (node, text, lon, lat), at in zip(raw.nodes, position.tolist(), strict=True):
        tags = read_tags(text)
        name = tags.get("name", "")
        kind = tags.get("highway") or tags.get("place") or ""
        if kind in STOP_KINDS or "amenity" in tags:
            continue
        if kind in POINT_KINDS:
            if np.isfinite(lon):
                towns.append(MapPoint(kind, lon, lat, name, _whole(tags, "population")))
        elif at < len(ids) and ids[at] == node and tags.get("barrier", "") in SIGNED_BARRIERS:
            is_junction = kind == "motorway_junction"
            junctions.append((at, name, tags.get("ref", "") if is_junction else "", is_junction))
    return junctions, towns


def _whole(tags: dict[str, str], key: str) -> int:
    digits = tags.get(key, "").replace(" ", "").replace(".", "").replace(",", "")
    return int(digits) if digits.isdecimal() and len(digits) < 12 else 0


def _points(rows: list[MapPoint], name: NDArray[np.int32], tags: NDArray[np.int32]) -> NamedPoints:
    return NamedPoints(
        np.array([row.lon for row in rows], np.float64),
        np.array([row.lat for row in rows], np.float64),
        np.array([POINT_KINDS.index(row.kind) for row in rows], np.uint8),
        name,
        np.array([row.population for row in rows], np.int64),
        np.array([row.capacity for row in rows], np.int32),
        tags,
    )
