"""Roads that a plan is to do without, to see what happens if they are closed."""

from __future__ import annotations

import re
from collections.abc import Iterable, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..errors import PlatoonError, ScenarioError, brief
from ..kinds import is_whole
from ..network.coordinate_text import coordinates_in
from ..network.placed import PlacedNetwork
from ..network.road_network import RoadNetwork
from ..network.road_points import road_points

__all__ = ["closed_roads", "without_roads"]

Marks = NDArray[np.bool_]

WAY = re.compile(r"way[ :/]*(\d{1,18})", re.IGNORECASE)
EDGE = re.compile(r"edge[ :/]*(\d{1,18})", re.IGNORECASE)
NEAR_M = 500.0
"""A point farther from every road than this closes none [m]."""

OTHER_CARRIAGEWAY_M = 60.0
"""How much farther the carriageway of the other direction may be [m]."""

FORMS = 'give "way 123456", "edge 12", "lon, lat" of a point on it, or a road number as "A 22"'


def closed_roads(net: RoadNetwork, asked: Iterable[Any]) -> Marks:
    """Mark the edges that are to count as closed.

    Parameters
    ----------
    net : RoadNetwork
        The network.
    asked : iterable of str or int or tuple of float
        Roads: an edge id as a number; "way 123456", an OpenStreetMap way; "edge 12"; a point
        (lon, lat) or "lon, lat", which closes the road there in both directions; a road number,
        which closes all of it.

    Returns
    -------
    ndarray of bool, (m,)
        Whether it is closed.

    Raises
    ------
    ScenarioError
        A road that is not in the network, or a form that is none.
    """
    marked = np.zeros(net.m, bool)
    for one in asked:
        found = _found(net, one)
        if not len(found):
            raise ScenarioError(f"close: {brief(one)} is no road of {net.source.name}; {FORMS}")
        marked[found] = True
    return marked


def without_roads(net: RoadNetwork, below: Marks) -> Marks:
    """Return the marks of a network on that with places between its junctions.

    Parameters
    ----------
    net : RoadNetwork
        With places, or the network itself.
    below : ndarray of bool
        Marks of the edges of the network below.

    Returns
    -------
    ndarray of bool, (m,)
        Each piece marked as its edge; ways beside the road are not.
    """
    if not isinstance(net, PlacedNetwork) or net.below is None:
        return below
    marks: Marks = below[net.below_edge] & (net.below_edge >= 0)
    return marks


def _found(net: RoadNetwork, one: Any) -> NDArray[np.int64]:
    if is_whole(one):
        return _edge(net, int(one))
    if isinstance(one, str):
        text = one.strip()
        if way := WAY.fullmatch(text):
            return np.flatnonzero(net.way_id == int(way.group(1)))
        if edge := EDGE.fullmatch(text):
            return _edge(net, int(edge.group(1)))
        try:
            point = coordinates_in(text)
        except PlatoonError as error:
            raise ScenarioError(f"close: {error}") from error
        return _at(net, point) if point else _of_number(net, text)
    if isinstance(one, Sequence) and len(one) == 2:
        return _at(net, (float(one[0]), float(one[1])))
    raise ScenarioError(f"close: {brief(one)} names no road; {FORMS}")


def _edge(net: RoadNetwork, edge: int) -> NDArray[np.int64]:
    return np.array([edge], np.int64) if 0 <= edge < net.m else np.zeros(0, np.int64)


def _of_number(net: RoadNetwork, text: str) -> NDArray[np.int64]:
    wanted = "".join(text.split()).casefold()
    codes = [
        code
        for code in np.unique(net.ref).tolist()
        if wanted in {"".join(ref.split()).casefold() for ref in str(net.texts[code]).split(";")}
    ]
    return np.flatnonzero(np.isin(net.ref, codes)) if wanted else np.zeros(0, np.int64)


def _at(net: RoadNetwork, point: tuple[float, float]) -> NDArray[np.int64]:
    """Return the carriageways at a point: the nearest, and that of the other direction."""
    roads = road_points(net, ~net.inferred, *point)
    nearest = int(np.argmin(roads.away_m)) if len(roads.edges) else -1
    if nearest < 0 or roads.away_m[nearest] > NEAR_M:
        return np.zeros(0, np.int64)
    edge = roads.edges[nearest]
    beside = roads.away_m <= roads.away_m[nearest] + OTHER_CARRIAGEWAY_M
    alike = (net.ref[roads.edges] == net.ref[edge]) & (
        net.road_class[roads.edges] == net.road_class[edge]
    )
    # Where edges meet at the point, the one behind it is as near: only what runs past it counts.
    inner = (roads.share > 0) & (roads.share < 1)
    inner[nearest] = True
    found: NDArray[np.int64] = roads.edges[beside & alike & inner].astype(np.int64)
    return found
