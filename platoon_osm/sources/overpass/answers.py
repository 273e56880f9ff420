"""Road networks from an answer of the Overpass API, such as OSMnx keeps in its cache."""

from __future__ import annotations

import json
import math
import os
from collections.abc import Iterator, Mapping, Sequence
from itertools import pairwise
from pathlib import Path
from typing import Any

import numpy as np

from ...errors import MapDataError, NetworkError
from ...network.load_report import Source
from ...network.road_network import RoadNetwork
from ..country.roads import countries_of
from ..file_identity import osm_source, read_bytes
from ..graphs.edge_tags import class_code
from ..road_choice import RoadChoice
from ..truck import BACKWARD, BOTH, Side, TruckRules

__all__ = ["read_overpass_cache"]

Place = tuple[float, float, Mapping[str, str]]


def read_overpass_cache(
    path: str | os.PathLike[str], classes: Sequence[str], rules: TruckRules
) -> RoadNetwork:
    """Read the ways of one Overpass answer in JSON ("out" or "out body", with the ways' nodes).

    Parameters
    ----------
    path : path-like
        The file.
    classes : sequence of str
        Values of `highway` to keep.
    rules : TruckRules
        The truck and the law.

    Returns
    -------
    RoadNetwork
        The network.

    Raises
    ------
    MapDataError
        Not JSON, not an Overpass answer, coordinates that are none, or no road of these classes.
    """
    file = Path(path)
    content, digest = read_bytes(file)
    answer = _answer(file, content)
    try:
        nodes = _nodes(file, answer["elements"])
        choice = RoadChoice(classes, rules, "ways")
        ways = _with_nodes(
            [
                way
                for way in _last(answer["elements"])
                if way["type"] == "way" and "highway" in way.get("tags", {})
            ],
            nodes,
        )
        first = [next((nodes[u] for u in way["nodes"] if u in nodes), None) for way in ways]
        places = np.array([one[:2] if one else (np.nan, np.nan) for one in first], np.float64)
        where = countries_of(rules, *places.reshape(-1, 2).T)
        segments = [
            segment
            for way, country in zip(ways, where, strict=True)
            for segment in _segments(way, nodes, choice, country)
        ]
    except (KeyError, TypeError, ValueError, AttributeError, OverflowError) as error:
        raise MapDataError(
            f"{file}: an element lacks its id, type, nodes or coordinates ({error!r:.60}); "
            "fetch the answer again with out body"
        ) from error
    choice.check_any(str(file))
    if not segments:
        raise MapDataError(
            f"{file}: the nodes of its ways are missing; fetch it again with (._;>;); out body;"
        )
    base = answer.get("osm3s", {})
    extracted = str(base.get("timestamp_osm_base", "")) if isinstance(base, dict) else ""
    remarks = [f"Overpass remarked: {_one_line(answer['remark'])}"] if "remark" in answer else []
    try:
        net = _network(segments, nodes, osm_source(file.name, digest, extracted))
    except NetworkError as error:
        raise MapDataError(f"{file}: {error}") from error
    junctions = [
        nodes[node][2].get("highway") == "motorway_junction" for node in net.node_id.tolist()
    ]
    return choice.finished(net, np.array(junctions, np.bool_), *remarks)


def _answer(file: Path, content: bytes) -> dict[str, Any]:
    try:
        answer = json.loads(content)
    except (ValueError, RecursionError) as error:
        raise MapDataError(
            f"{file}: not JSON, or cut short; delete it and fetch it again"
        ) from error
    if not isinstance(answer, dict) or not isinstance(answer.get("elements"), list):
        raise MapDataError(
            f"{file}: JSON, but not an Overpass answer (no list of elements); give a file that "
            "OSMnx cached for a graph, not for a place name"
        )
    if "remark" in answer and not answer["elements"]:
        raise MapDataError(
            f"{file}: Overpass gave no data: {_one_line(answer['remark'])}; ask for a smaller area"
        )
    return answer


NOWHERE = -(10**15)
"""Ids from here down are of nodes outside of the area that was asked for: no road goes on there."""


def _last(elements: list[Any]) -> list[Any]:
    """Return elements without those that are listed again: the last counts, but for its tags.

    "out skel" lists objects without tags; they keep those they had.
    """
    found: dict[tuple[str, int], Any] = {}
    for element in elements:
        key = element["type"], _id(element)
        before = found.pop(key, None)
        if before is None or _version(element) >= _version(before) or "tags" not in before:
            kept, other = element, before
        else:
            kept, other = before, element
        found[key] = kept if other is None else {**other, **kept}
    return list(found.values())


def _version(element: Mapping[str, Any]) -> float:
    """Return the version of an element; one that tells none is as new as any."""
    return float(element.get("version", math.inf))


def _with_nodes(ways: list[Any], nodes: dict[int, Place]) -> list[Any]:
    """Return ways that name their nodes; of "out geom" the places are taken from the ways."""
    spots: dict[tuple[float, float], int] = {}
    found = []
    for way in ways:
        geometry = way.get("geometry")
        if not isinstance(geometry, list):
            found.append(way)
            continue
        own = way.get("nodes")
        # Without ids, equal places are the same node: so Overpass cuts nothing apart.
        ids = own or [
            NOWHERE - place
            if at is None
            else spots.setdefault((at["lon"], at["lat"]), -1 - len(spots))
            for place, at in enumerate(geometry)
        ]
        for number, at in zip(ids, geometry, strict=True):
            if at is not None:
                nodes.setdefault(int(number), (float(at["lon"]), float(at["lat"]), {}))
        found.append({**way, "nodes": ids})
    return found


def _one_line(text: object) -> str:
    return " ".join(str(text).split())[:200]


def _nodes(file: Path, elements: list[Any]) -> dict[int, Place]:
    nodes: dict[int, Place] = {}
    for element in elements:
        if element["type"] != "node":
            continue
        lon, lat = float(element["lon"]), float(element["lat"])
        if not (math.isfinite(lon) and math.isfinite(lat)):
            raise MapDataError(
                f"{file}: node {element['id']} lies at lon {lon}, lat {lat}; fetch the file again"
            )
        # Listed again without tags, as by "out skel", it keeps those it had.
        before = nodes.get(_id(element))
        tags = _tags(element) if "tags" in element or before is None else before[2]
        nodes[_id(element)] = (lon, lat, tags)
    return nodes


def _id(element: Mapping[str, Any]) -> int:
    """Return the id of an element, which a network keeps as 64 bits."""
    number = int(element["id"])
    if not -(2**63) <= number < 2**63:
        raise ValueError(f"id {number}")
    return number


def _tags(element: Mapping[str, Any]) -> dict[str, str]:
    return {str(key): str(value) for key, value in element.get("tags", {}).items()}


Segment = tuple[int, int, Side, Mapping[str, str], int, str]


def _segments(
    way: Mapping[str, Any], nodes: Mapping[int, Place], choice: RoadChoice, country: str
) -> Iterator[Segment]:
    """Yield the directed pieces between consecutive nodes of a way."""
    tags = _tags(way)
    reading = choice.read(tags, country)
    if reading is None:
        return
    for u, v in pairwise(way["nodes"]):
        if u not in nodes or v not in nodes:
            choice.counts["segments dropped: node not in the answer"] += 1
            continue
        if u == v:
            continue
        if reading.direction != BACKWARD:
            yield u, v, reading.along, tags, _id(way), country
        if reading.direction in (BACKWARD, BOTH):
            yield v, u, reading.against, tags, _id(way), country


def _network(segments: list[Segment], nodes: Mapping[int, Place], source: Source) -> RoadNetwork:
    used = list(dict.fromkeys(node for u, v, *_ in segments for node in (u, v)))
    position = {node: i for i, node in enumerate(used)}
    signs = [
        nodes[node][2] if nodes[node][2].get("highway") == "motorway_junction" else {}
        for node in used
    ]
    tags = [item[3] for item in segments]
    return RoadNetwork.from_edges(
        np.array([position[u] for u, *_ in segments], np.int32),
        np.array([position[v] for _, v, *_ in segments], np.int32),
        lon=np.array([nodes[node][0] for node in used]),
        lat=np.array([nodes[node][1] for node in used]),
        speed_mps=np.array([side.speed_kmh for _, _, side, *_ in segments]) / 3.6,
        posted_mps=np.array([side.posted_kmh for _, _, side, *_ in segments]) / 3.6,
        restriction=np.array([side.restriction for _, _, side, *_ in segments], object),
        node_id=np.array(used, np.int64),
        node_name=np.array([sign.get("name", "") for sign in signs], object),
        node_ref=np.array([sign.get("ref", "") for sign in signs], object),
        road_class=np.array([class_code(item["highway"]) for item in tags], np.uint8),
        ref=np.array([item.get("ref", "") for item in tags], object),
        name=np.array([item.get("name", item.get("destination", "")) for item in tags], object),
        toll=np.array([side.toll for _, _, side, *_ in segments], np.bool_),
        way_id=np.array([way for *_, way, _ in segments], np.int64),
        country=np.array([country for *_, country in segments], object),
        source=source,
    )
