"""A map as ways over nodes with tags, before anyone interprets them: what every reader makes."""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from itertools import compress

import numpy as np
from numpy.typing import NDArray

from ...network.load_report import Source
from ...vehicles.access import BARRIERS, CHAIN
from ..stops.features import STOP_TAGS
from .borders import Border

__all__ = ["NODE_TAGS", "TURN", "TURN_TAGS", "RawMap", "TagReader", "unescaped", "without_ways"]

NODE_TAGS = (
    ("highway", "motorway_junction"), *STOP_TAGS, ("place", "city"), ("place", "town"),
    *(("barrier", kind) for kind in (*BARRIERS, "yes") if kind),
)  # fmt: skip

TURN_TAGS = tuple(
    ("type", kind)
    for kind in ("restriction", *(f"restriction:{whom}" for whom in (*CHAIN, "conditional")))
)
"""Relations that forbid turns, to all or to some."""
TURN = "type=restriction"
"""What the tags of such a relation have, as OPL writes them."""

ESCAPE = re.compile(r"%([0-9a-f]{1,6})%")


@dataclass(frozen=True, slots=True, eq=False)
class RawMap:
    """Ways and named nodes as they stand in the file.

    Attributes
    ----------
    way_id : ndarray of int64, (w,)
        Ids of the ways.
    way_tags : tuple of str, (w,)
        Each way's tags, still as OPL text; equal tags are equal texts.
    first : ndarray of int64, (w + 1,)
        Where each way's nodes begin.
    ref : ndarray of int64, (k,)
        Node ids along the ways.
    lon, lat : ndarray of float, (k,)
        Degrees; NaN where the file lacks the node.
    nodes : tuple[tuple[int, str, float, float], ...]
        Id, tags as OPL text, lon and lat of each tagged node.
    turns : tuple[tuple[int, str, tuple[tuple[str, int, str], ...]], ...]
        Id, tags as OPL text and members (kind, id, role) of each relation that forbids turns.
    areas : tuple[tuple[int, str, ndarray], ...]
        Id, tags as OPL text and outline (k, 2) of each relation that is an area where trucks stop.
    borders : tuple of Border
        Areas of countries and states whose border is whole.
    left_out : mapping of str to int
        How many ways were left out, by reason.
    height_of : ndarray of int64, (h,)
        Ids of the nodes that have an `ele`, rising.
    heights : tuple of str, (h,)
        What it says.
    """

    source: Source
    way_id: NDArray[np.int64]
    way_tags: tuple[str, ...]
    first: NDArray[np.int64]
    ref: NDArray[np.int64]
    lon: NDArray[np.float64]
    lat: NDArray[np.float64]
    nodes: tuple[tuple[int, str, float, float], ...]
    turns: tuple[tuple[int, str, tuple[tuple[str, int, str], ...]], ...]
    areas: tuple[tuple[int, str, NDArray[np.float64]], ...]
    borders: tuple[Border, ...]
    left_out: Mapping[str, int]
    height_of: NDArray[np.int64]
    heights: tuple[str, ...]


def without_ways(raw: RawMap, gone: NDArray[np.bool_], reason: str) -> RawMap:
    """Return the map without some ways, and their number among `left_out`.

    Parameters
    ----------
    raw : RawMap
        The map.
    gone : ndarray of bool, (w,)
        The ways to leave out.
    reason : str
        Under which they are counted.

    Returns
    -------
    RawMap
        The same map if none is gone.
    """
    if not gone.any():
        return raw
    size = np.diff(raw.first)
    points = np.repeat(~gone, size)
    return replace(
        raw,
        way_id=raw.way_id[~gone],
        way_tags=tuple(compress(raw.way_tags, (~gone).tolist())),
        first=np.concatenate([[0], np.cumsum(size[~gone])]).astype(np.int64),
        ref=raw.ref[points],
        lon=raw.lon[points],
        lat=raw.lat[points],
        left_out={**raw.left_out, reason: int(gone.sum())},
    )


class TagReader:
    """Reads the tags of OPL lines, `key=value` pairs with special characters as %hex%.

    Most pairs of a map are repeated thousands of times and most keys say nothing about driving, so
    each distinct pair is decoded once, and only if its key is wanted.

    Parameters
    ----------
    wanted : callable
        Says whether a key is wanted.
    """

    def __init__(self, wanted: Callable[[str], bool]) -> None:
        self._wanted = wanted
        self._pairs: dict[str, tuple[str, str] | None] = {}

    def __call__(self, text: str) -> dict[str, str]:
        """Return the wanted tags of one object."""
        known = self._pairs
        tags = {}
        for part in text.split(","):
            try:
                pair = known[part]
            except KeyError:
                pair = known[part] = self._decode(part)
            if pair is not None:
                tags[pair[0]] = pair[1]
        return tags

    def _decode(self, part: str) -> tuple[str, str] | None:
        key, _, value = part.partition("=")
        if not self._wanted(unescaped(key)):
            return None
        return unescaped(key), unescaped(value)


def unescaped(text: str) -> str:
    """Return a text of OPL with its special characters, which stand there as %hex%.

    Parameters
    ----------
    text : str
        As it stands in the line.

    Returns
    -------
    str
        As it stands in the map.
    """
    return ESCAPE.sub(lambda found: chr(int(found.group(1), 16)), text)
