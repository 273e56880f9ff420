"""Fetch roads from the Overpass API through OSMnx and its cache, and save them for later."""

from __future__ import annotations

import json
import os
import re
import socket
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path
from typing import Any

from ...atomic_file import whole_file
from ...errors import MapDataError, ScenarioError
from ...network.road_network import ROAD_CLASSES
from ...network.saved.store import save_network
from ...vehicles.access import LOCKED
from ...vehicles.limits import LIMITS
from ..file_identity import ATTRIBUTION, LICENCE, osm_source
from ..graphs.osmnx_graph import network_from_osmnx
from ..restricting_tags import ALONE, LIMITED_FOR
from ..slopes import INCLINE_TAGS
from ..speeds.of_road import KIND_KEYS
from ..speeds.zones import ZONE_KEYS
from ..truck import TruckRules
from ..way_sides import ONLY_SOME

__all__ = ["SUFFIXES", "download", "osmnx_settings", "read_bounds"]

SUFFIXES = (".graphml", ".platoon")

RESTRICTIONS = (*ALONE, *(f"{limit}:{whom}" for limit in LIMITS for whom in LIMITED_FOR))
PARTS = ("", ":forward", ":backward", ":conditional")
SPEEDS = ("maxspeed", "maxspeed:hgv", "maxspeed:goods")
WAY_TAGS = (
    "highway", "ref", "name", "destination", "junction", "toll", "toll:hgv", "toll:N3",
    *sorted(INCLINE_TAGS),
    "oneway", "oneway:conditional", *ONLY_SOME, *ZONE_KEYS, *sorted(KIND_KEYS),
    *(f"{key}{part}" for key in (*SPEEDS, *sorted(RESTRICTIONS)) for part in PARTS),
)  # fmt: skip
"""What `truck.read_way` looks at, and what names a road."""
NODE_TAGS = ("highway", "ref", "name", "ele", "barrier", LOCKED, *sorted(RESTRICTIONS))

LARGEST_REQUEST_M2 = 1e11
"""About 300 km by 300 km: few roads are of the classes asked for, so one request holds many."""
BUSY = (429, 504)
RETRIES_WHEN_BUSY = 2
"""OSMnx waits a minute before each new try, and would go on for hours."""


def download(
    place: str,
    output: str | os.PathLike[str],
    *,
    classes: Sequence[str] = ("motorway", "motorway_link"),
    cache_dir: str | os.PathLike[str],
    rules: TruckRules | None = None,
    overpass_url: str | None = None,
    nominatim_url: str | None = None,
    timeout_s: int = 180,
) -> Path:
    """Fetch the roads of a place and save them; what the cache holds is not fetched again.

    Parameters
    ----------
    place : a name that Nominatim knows with its boundary ("Liguria, Italy"), or a bounding box
        "west,south,east,north" in degrees.
    output : path-like
        File to write: `.graphml` for OSMnx, or `.platoon`, the project's own form.
    classes : sequence of str
        Values of `highway` to fetch.
    cache_dir : path-like
        Folder of OSMnx's cached answers; made if it does not exist.
    rules : TruckRules or None
        The truck, for a `.platoon` file.
    overpass_url, nominatim_url : other servers than OSMnx's own; one's own Overpass is not asked
        for a free slot first.
    timeout_s : int
        Seconds that a request may take.

    Returns
    -------
    Path
        The written file; it appears whole or not at all.

    Raises
    ------
    ScenarioError
        A bounding box, class or suffix that is none.
    MapDataError
        The servers cannot be reached, refuse, answer with an error or with no road.
    """
    target = Path(output)
    bounds = read_bounds(place)
    if target.suffix.lower() not in SUFFIXES:
        raise ScenarioError(f"{target}: the file name must end in {' or '.join(SUFFIXES)}")
    # Classes go into the query as they are.
    unknown = [kind for kind in classes if not re.fullmatch("[a-z_]+", kind) or kind == "other"]
    if unknown or not classes:
        raise ScenarioError(
            f"road classes {unknown or '()'}: give values of the highway tag, such as "
            f"{', '.join(ROAD_CLASSES[:4])}"
        )
    with whole_file(target, MapDataError) as draft:
        changes: dict[str, Any] = {"requests_timeout": timeout_s}
        if overpass_url is not None:
            changes |= {"overpass_url": overpass_url, "overpass_rate_limit": False}
        if nominatim_url is not None:
            changes["nominatim_url"] = nominatim_url
        with osmnx_settings(Path(cache_dir), 0 if overpass_url else RETRIES_WHEN_BUSY, changes):
            graph = _graph(place, bounds, classes)
        _save(graph, place, draft, classes, rules or TruckRules())
    return target


def read_bounds(place: str) -> tuple[float, float, float, float] | None:
    """Read "west,south,east,north" in degrees; None if the text is a name.

    Parameters
    ----------
    place : str
        A bounding box "west,south,east,north", or a name.

    Returns
    -------
    tuple[float, float, float, float] or None
        West, south, east, north [deg].

    Raises
    ------
    ScenarioError
        Four numbers that are no bounding box.
    """
    try:
        numbers = [float(part) for part in place.split(",")]
    except ValueError:
        return None
    if len(numbers) == 4:
        west, south, east, north = numbers
        if -180 <= west < east <= 180 and -90 <= south < north <= 90:
            return west, south, east, north
    raise ScenarioError(
        f"bounding box {place!r}: give west,south,east,north in degrees, west below east and south "
        "below north"
    )


@contextmanager
def osmnx_settings(cache_dir: Path, busy_retries: int, changes: dict[str, Any]) -> Iterator[None]:
    """Set OSMnx up for a download, and leave it as it was.

    Parameters
    ----------
    cache_dir : Path
        Folder of cached answers.
    busy_retries : int
        How often a busy server is asked again.
    changes : mapping of str to Any
        Further settings by name.
    """
    from osmnx import settings

    wanted = {
        "use_cache": True,
        "cache_folder": cache_dir,
        "cache_only_mode": False,
        "all_oneway": False,
        "default_crs": "epsg:4326",
        # OSMnx would else ask a third party for the address of a host that cannot be resolved.
        "doh_url_template": None,
        "max_query_area_size": LARGEST_REQUEST_M2,
        "useful_tags_way": list(WAY_TAGS),
        "useful_tags_node": list(NODE_TAGS),
        "requests_kwargs": {
            **settings.requests_kwargs,
            "hooks": {"response": _refusing(busy_retries, settings.requests_kwargs)},
        },
        **changes,
    }
    before = {name: getattr(settings, name) for name in wanted}
    # OSMnx pins the server's address by replacing this function of the standard library.
    getaddrinfo = socket.getaddrinfo
    try:
        for name, value in wanted.items():
            setattr(settings, name, value)
        yield
    finally:
        for name, value in before.items():
            setattr(settings, name, value)
        socket.getaddrinfo = getaddrinfo


def _refusing(busy_retries: int, requests_kwargs: dict[str, Any]) -> list[Any]:
    """Return the hooks that look at each answer before OSMnx does, the user's own included."""
    given = requests_kwargs.get("hooks", {}).get("response", [])
    seen_busy = 0

    def refuse(response: Any, **_: Any) -> None:
        nonlocal seen_busy
        if response.url.split("?")[0].endswith("/status"):
            return  # whether a slot is free; OSMnx copes without the answer
        if response.status_code in BUSY and seen_busy < busy_retries:
            seen_busy += 1
            return
        if not response.ok:
            response.close()
            response.raise_for_status()
        # Overpass ends a query that ran out of time or memory with a remark and what it has: OSMnx
        # would take the part for the whole.
        if b'"remark"' in response.content[-5000:]:
            answer = json.loads(response.content)
            if isinstance(answer, dict) and "remark" in answer:
                raise MapDataError(
                    f"Overpass gave up: {_one_line(answer['remark'])}; ask for a smaller area or "
                    "fewer classes"
                )

    return [refuse, *(given if isinstance(given, Sequence) else [given])]


def _graph(
    place: str, bounds: tuple[float, float, float, float] | None, classes: Sequence[str]
) -> Any:
    import osmnx
    import requests

    # Unsimplified: each edge keeps the tags of its own way, and chains are contracted later.
    options: dict[str, Any] = {
        "simplify": False,
        "retain_all": True,
        "truncate_by_edge": True,
        "custom_filter": f'["highway"~"^({"|".join(classes)})$"]',
    }
    try:
        if bounds is not None:
            graph = osmnx.graph.graph_from_bbox(bounds, **options)
        else:
            graph = osmnx.graph.graph_from_place(place, **options)
    except requests.exceptions.HTTPError as error:
        status = getattr(error.response, "status_code", "an error")
        raise MapDataError(
            f"download of {place!r}: the server answered {status}; try again later or give another "
            "overpass_url"
        ) from error
    except requests.exceptions.RequestException as error:
        raise MapDataError(
            f"download of {place!r}: no answer from the server ({type(error).__name__}); check the "
            "connection and overpass_url"
        ) from error
    except TypeError as error:
        raise MapDataError(
            f"download of {place!r}: the place has no boundary; name a region or give "
            "west,south,east,north"
        ) from error
    except (ValueError, KeyError) as error:
        raise MapDataError(
            f"download of {place!r}: the answer holds no usable road ({_one_line(error)}); check "
            "the name or the box, the classes, and that the cache is not damaged"
        ) from error
    if not graph.number_of_edges():
        raise MapDataError(
            f"download of {place!r}: no road of class {', '.join(classes)} there; choose other "
            "classes or a larger area"
        )
    return graph


def _save(graph: Any, place: str, file: Path, classes: Sequence[str], rules: TruckRules) -> None:
    source = osm_source(f"OpenStreetMap, {place}")
    if file.suffix.lower() == ".platoon":
        save_network(network_from_osmnx(graph, classes, rules, source), file)
        return
    import osmnx

    graph.graph |= {"licence": LICENCE, "attribution": ATTRIBUTION}
    osmnx.io.save_graphml(graph, file)


def _one_line(text: object) -> str:
    return " ".join(str(text).split())[:200]
