"""Road networks from an answer of the Overpass API, such as OSMnx keeps in its cache."""

from __future__ import annotations

import json
import math
import os
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

from ...errors import MapDataError
from ...network.road_network import RoadNetwork
from ..file_identity import osm_source, read_bytes
from ..osm.extract import network_of
from ..osm.tables import MapNode, MapTurn, MapWay, raw_map
from ..truck import TruckRules

__all__ = ["read_overpass_cache"]


def read_overpass_cache(
    path: str | os.PathLike[str], classes: Sequence[str], rules: TruckRules
) -> RoadNetwork:
    """Read one Overpass answer in JSON ("out" or "out body", with the ways' nodes).

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
        elements = _last(answer["elements"])
        nodes = {
            _id(element): _node(file, element) for element in elements if element["type"] == "node"
        }
        relations = [element for element in elements if element["type"] == "relation"]
        ways = [
            MapWay(_id(way), [_number(node) for node in way["nodes"]], _tags(way))
            for way in _with_nodes(_ways(elements, relations), nodes)
        ]
        turns = [_turn(relation) for relation in relations]
    except (KeyError, TypeError, ValueError, AttributeError, OverflowError) as error:
        raise MapDataError(
            f"{file}: an element lacks its id, type, nodes or coordinates ({error!r:.60}); "
            "fetch the answer again with out body"
        ) from error
    if ways and not any(node in nodes for way in ways for node in way.nodes):
        raise MapDataError(
            f"{file}: the nodes of its ways are missing; fetch it again with (._;>;); out body;"
        )
    base = answer.get("osm3s", {})
    extracted = str(base.get("timestamp_osm_base", "")) if isinstance(base, dict) else ""
    source = osm_source(file.name, digest, extracted)
    raw = raw_map(str(file), source, ways, nodes, turns, classes=classes, left_out={})
    net = network_of(raw, str(file), classes, rules)
    if "remark" not in answer:
        return net
    remark = f"Overpass remarked: {_one_line(answer['remark'])}"
    return net.with_report(net.load_report.extended({}, remark))


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


def _ways(elements: list[Any], relations: list[Any]) -> list[Any]:
    """Return the ways, with those that "out geom" tells of among the members of relations alone."""
    found = {_id(one): one for one in elements if one["type"] == "way"}
    for relation in relations:
        for member in relation.get("members", ()):
            if member["type"] == "way" and isinstance(member.get("geometry"), list):
                own = {"type": "way", "id": member["ref"], "geometry": member["geometry"]}
                found.setdefault(_number(member["ref"]), own)
    return list(found.values())


def _with_nodes(ways: list[Any], nodes: dict[int, MapNode]) -> list[Any]:
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
                nodes.setdefault(_number(number), MapNode(float(at["lon"]), float(at["lat"]), {}))
        found.append({**way, "nodes": ids})
    return found


def _one_line(text: object) -> str:
    return " ".join(str(text).split())[:200]


def _node(file: Path, element: Mapping[str, Any]) -> MapNode:
    lon, lat = float(element["lon"]), float(element["lat"])
    if not (abs(lon) <= 180 and abs(lat) <= 90):
        raise MapDataError(
            f"{file}: node {element['id']} lies at lon {lon}, lat {lat}; fetch the file again"
        )
    return MapNode(lon, lat, _tags(element))


def _turn(element: Mapping[str, Any]) -> MapTurn:
    members = tuple(
        (str(member["type"])[:1], _number(member["ref"]), str(member.get("role", "")))
        for member in element.get("members", ())
    )
    return MapTurn(_id(element), members, _tags(element))


def _id(element: Mapping[str, Any]) -> int:
    return _number(element["id"])


def _number(given: Any) -> int:
    """Return an id, which a network keeps as 64 bits."""
    number = int(given)
    if not -(2**63) <= number < 2**63:
        raise ValueError(f"id {number}")
    return number


def _tags(element: Mapping[str, Any]) -> dict[str, str]:
    return {str(key): str(value) for key, value in element.get("tags", {}).items()}
