"""One door for all networks: a bundled map's name, a file of any supported kind, an OSMnx graph."""

from __future__ import annotations

import os
from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np

from ..errors import MapDataError, ScenarioError
from ..network.load_report import Source
from ..network.road_network import ROAD_CLASSES, RoadNetwork
from .catalog import BUNDLED_MAPS, bundled_path
from .country.roads import law_told, limiter_told
from .osm.extract import MOTORWAY_CLASSES
from .readers import reader_of
from .spellings import CLASSES, COUNTRY, INFER_LINKS
from .truck import TruckRules

__all__ = ["load_network"]

MOSTLY_CONNECTED = 0.5


def load_network(
    source: Any,
    classes: Sequence[str] = MOTORWAY_CLASSES,
    *,
    country: str | None = None,
    limiter_kmh: float | None = None,
    infer_links: bool = False,
) -> RoadNetwork:
    """Load a road network for trucks.

    Parameters
    ----------
    source : str, path-like, graph or RoadNetwork
        The name of a bundled map ("italy-motorways"); a path to an OSM extract (.osm.pbf, .osm,
        .osm.gz, .osm.bz2), to GraphML or GeoPackage saved by OSMnx, to an Overpass answer it
        cached (.json), to a network saved by `save` or `platoon-osm prepare` (.platoon), or to
        any other kind of file that stands in `platoon_osm.sources.readers.READERS`; a live OSMnx
        `MultiDiGraph`; or a network, which stays as it is.
    classes : sequence of str
        Values of `highway` to load; a saved network is opened as it is.
    country : str, optional
        ISO code whose speed limits for trucks apply ("IT", "DE", "US-CA"), on all roads; without
        it, each road has those of the country where it lies: by the map's borders or by outlines.
    limiter_kmh : float, optional
        What the trucks' speed limiter allows [km/h]; without it, what is customary in the country
        (90 in Europe and where nothing is known, none in the United States).
    infer_links : bool
        Whether to add likely connectors where carriageways meet without a common node, as in
        extracts cut to `highway=motorway`; they are marked `inferred`. A bundled map that lacks
        its ramps always has them added.

    Returns
    -------
    RoadNetwork
        With a report of what was kept, dropped, capped and defaulted.

    Raises
    ------
    MapDataError
        The file is missing, unreadable, or holds no such road.
    NetworkError
        The source is neither a name, a path nor a graph, or a graph that has no coordinates.
    ScenarioError
        The country is unknown, the limiter out of range, or another option is none.
    """
    is_list = isinstance(classes, Sequence) and not isinstance(classes, str)
    if not is_list or not all(isinstance(item, str) for item in classes):
        raise ScenarioError(
            f"classes = {_shown(classes)} must be a list of highway values, as "
            '["motorway", "trunk"]'
        )
    if not isinstance(infer_links, bool | np.bool_):
        raise ScenarioError(f"infer_links = {_shown(infer_links)} must be True or False")
    net = _read(source, tuple(classes), country, limiter_kmh)
    bundled = BUNDLED_MAPS.get(source) if isinstance(source, str) else None
    lacks_ramps = infer_links or (bundled is not None and bundled.infer_links)
    if lacks_ramps and not net.inferred.any():
        from ..network.preparing.inferred_links import infer_links as add_links

        net = add_links(net)
    return _with_connection_remark(net)


def _read(
    source: Any, classes: tuple[str, ...], country: str | None, limiter_kmh: float | None
) -> RoadNetwork:
    if isinstance(source, RoadNetwork):
        return source
    rules = TruckRules(country, limiter_kmh)
    if not isinstance(source, str | os.PathLike):
        from .graphs.osmnx_graph import network_from_osmnx

        return _with_speed_remark(network_from_osmnx(source, classes, rules), rules)
    if isinstance(source, str) and (found := bundled_path(source)):
        bundled, path = found
        own_rules = TruckRules(country or bundled.country, limiter_kmh)
        net = _read_file(path, classes, own_rules)
        read = net.source
        told = Source(
            bundled.name, read.sha256, read.extracted, bundled.licence, bundled.attribution
        )
        return replace(net, source=told)
    path = _existing(source)
    return _read_file(path, classes, rules)


def _existing(source: Any) -> Path:
    """Return the path of a file that is there."""
    try:
        path = Path(source)
        if path.is_dir():
            raise MapDataError(f"{path}: is a folder; give a file in it, or a name from `maps`")
        if path.is_file():
            return path
    except (TypeError, ValueError, OSError):
        path = Path(_shown(source))
    names = ", ".join(BUNDLED_MAPS)
    raise MapDataError(f"{path}: no such file, and no bundled map of that name ({names})")


def _read_file(path: Path, classes: tuple[str, ...], rules: TruckRules) -> RoadNetwork:
    reader = reader_of(path)
    net = reader.read(path, classes, rules)
    if not isinstance(net, RoadNetwork):
        raise MapDataError(
            f"{path}: reader {reader.name!r} returned a {type(net).__name__}; it must return a "
            "RoadNetwork"
        )
    return _with_speed_remark(net, rules) if reader.follows_rules else net


def _shown(value: object) -> str:
    return " ".join(repr(value).split())[:80]


def _with_speed_remark(net: RoadNetwork, rules: TruckRules) -> RoadNetwork:
    """Say which limit capped the speeds, so that none is guessed in silence."""
    found = [str(net.texts[code]) for code in np.unique(net.country).tolist()]
    law = law_told(rules, found, COUNTRY)
    remark = f"speeds are capped by {limiter_told(rules, found)} and {law}"
    return net.with_report(net.load_report.extended({}, remark))


def _with_connection_remark(net: RoadNetwork) -> RoadNetwork:
    """Say how much of the network hangs together, if that is less than a user would expect."""
    inside = net.connected_share()
    if inside >= MOSTLY_CONNECTED or net.inferred.any():
        return net
    ends = int((net.first_out[1:] == net.first_out[:-1]).sum())
    remark = (
        f"only {inside:.0%} of the carriageway-km hang together; {ends} carriageways end without "
        "going on: "
    )
    if (net.road_class == ROAD_CLASSES.index("motorway_link")).any():
        remark += (
            "the extract is a small piece of the network. Load a larger one, or more classes of "
            f"road ({CLASSES})"
        )
    else:
        remark += (
            "the extract seems cut to motorways without their ramps. Load one with "
            f"motorway_link, or add likely connectors ({INFER_LINKS})"
        )
    if remark in net.load_report.remarks:
        return net
    return net.with_report(
        net.load_report.extended({"carriageways that end without going on": ends}, remark)
    )
