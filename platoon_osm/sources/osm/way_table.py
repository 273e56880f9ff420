"""What the tags of the ways of a map mean, each distinct set of tags read once."""

from __future__ import annotations

from collections import Counter
from dataclasses import dataclass
from math import nan
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...network.geodesy import distance_m
from ..country.roads import countries_of
from ..road_choice import class_code
from ..slopes import INCLINE_TAGS, slope_along
from ..truck import FORWARD, TruckRules, WayReading, dropped, is_driving_tag, read_way
from .borders import within_borders
from .ferries import crossing_mps, duration_s, is_ferry, read_ferry
from .raw_map import RawMap, TagReader

__all__ = ["WayTable", "interpreted"]

NAME_TAGS = frozenset({"ref", "name", "destination", "route", "duration"})
NOT_A_ROAD = WayReading(FORWARD, False, 1.0, False, (), 1.0, 1.0, 1.0)


@dataclass(frozen=True, slots=True, eq=False)
class WayTable:
    """What the tags of each way mean, (w,) each; those that are texts are codes in `texts`.

    A way that is no road of the wanted classes, such as a service area, is not `road`; a road that
    nobody may drive is not `kept`. Speeds are in m/s, slopes in m of rise for each m along the way.
    """

    road: NDArray[np.bool_]
    kept: NDArray[np.bool_]
    direction: NDArray[np.int8]
    speed_mps: NDArray[np.float64]
    backward_mps: NDArray[np.float64]
    posted_mps: NDArray[np.float64]
    backward_posted_mps: NDArray[np.float64]
    restriction: NDArray[np.int64]
    backward_restriction: NDArray[np.int64]
    road_class: NDArray[np.uint8]
    country: NDArray[np.int64]
    toll: NDArray[np.bool_]
    toll_free: NDArray[np.bool_]
    slope: NDArray[np.float64]
    ref: NDArray[np.int64]
    name: NDArray[np.int64]
    texts: tuple[str, ...]
    counts: dict[str, int]


def interpreted(raw: RawMap, classes: set[str], rules: TruckRules) -> WayTable:
    """Read each distinct set of tags once, and count what had to be assumed by ways.

    Ways share tags, tags share readings and names: each level is a table, and ways are looked up
    in it by number, for that is what keeps loading near the speed of the file itself.

    Parameters
    ----------
    raw : RawMap
        The map.
    classes : set of str
        Values of the `highway` tag to load.
    rules : TruckRules
        How to read tags for a truck.

    Returns
    -------
    WayTable
        A row for each way.
    """
    read_tags = TagReader(
        lambda key: key in NAME_TAGS or key in INCLINE_TAGS or is_driving_tag(key)
    )
    readings: list[WayReading] = [NOT_A_ROAD]
    known: dict[tuple[tuple[tuple[str, str], ...], str | None], int] = {}
    names: dict[str, int] = {"": 0}
    sets: dict[tuple[str, str], int] = {}
    where = _countries(raw, rules)
    own_rules = {code: rules.within(code) for code in set(where)}
    way_set = np.fromiter(
        (sets.setdefault(pair, len(sets)) for pair in zip(raw.way_tags, where, strict=True)),
        np.int64,
        len(raw.way_tags),
    )
    rows = np.zeros((len(sets), 6), np.int64)
    slopes: dict[tuple[float, str], int] = {(nan, ""): 0}
    for number, (text, country) in enumerate(sets):
        tags = read_tags(text)
        ref, destination = tags.pop("ref", ""), tags.pop("destination", "")
        name = tags.pop("name", destination)
        inclines = {key: tags.pop(key) for key in INCLINE_TAGS & tags.keys()}
        highway = tags.get("highway", "")
        ferry = is_ferry(tags)
        if highway not in classes and not ferry:
            continue
        own = own_rules[country]
        key = tuple(tags.items()), own.country
        reading = known.get(key)
        if reading is None:
            reading = known[key] = len(readings)
            readings.append(read_ferry(tags, own) if ferry else read_way(tags, own))
        rows[number] = (
            reading, class_code("ferry" if ferry else highway),
            names.setdefault(ref, len(names)), names.setdefault(name, len(names)),
            names.setdefault(country, len(names)),
            slopes.setdefault(slope_along(inclines), len(slopes)) if inclines else 0,
        )  # fmt: skip
    reading_of, road_class, ref_of, name_of, country_of_way, slope_of = rows[way_set].T

    def looked_up(values: list[Any], dtype: type) -> NDArray[Any]:
        by_way: NDArray[Any] = np.array(values, dtype)[reading_of]
        return by_way

    def mps(kmh: list[float]) -> NDArray[np.float64]:
        return looked_up(kmh, np.float64) / 3.6

    def coded(texts: list[str]) -> NDArray[np.int64]:
        return looked_up([names.setdefault(text, len(names)) for text in texts], np.int64)

    kept = looked_up([reading.allowed for reading in readings], bool)
    speed = mps([reading.speed_kmh for reading in readings])
    backward = mps([reading.backward_kmh for reading in readings])
    posted = mps([reading.posted_kmh for reading in readings])
    backward_posted = mps([reading.backward_posted_kmh for reading in readings])
    for way in np.flatnonzero(kept & (road_class == class_code("ferry"))).tolist():
        crossing = _crossing_mps(raw, way, read_tags, speed[way])
        for column in (speed, backward, posted, backward_posted):
            column[way] = crossing
    counts = _counts(readings, np.bincount(reading_of, minlength=len(readings)).tolist())
    inclined = np.bincount(slope_of[kept], minlength=len(slopes)).tolist()
    for (_, remark), number in zip(slopes, inclined, strict=True):
        if remark and number:
            counts[remark] = counts.get(remark, 0) + number
    return WayTable(
        road=reading_of > 0,
        kept=kept,
        direction=looked_up([reading.direction for reading in readings], np.int8),
        speed_mps=speed,
        backward_mps=backward,
        posted_mps=posted,
        backward_posted_mps=backward_posted,
        restriction=coded([reading.restriction for reading in readings]),
        backward_restriction=coded([reading.backward_restriction for reading in readings]),
        road_class=road_class.astype(np.uint8),
        country=country_of_way,
        toll=looked_up([reading.toll for reading in readings], bool),
        toll_free=looked_up([reading.toll_free for reading in readings], bool),
        slope=np.array([slope for slope, _ in slopes])[slope_of],
        ref=ref_of,
        name=name_of,
        texts=tuple(names),
        counts=counts,
    )


def _countries(raw: RawMap, rules: TruckRules) -> list[str]:
    """Return the country of each way: that asked for, else where its first known node lies."""
    known = np.flatnonzero(np.isfinite(raw.lon))
    at = np.append(known, len(raw.lon))[np.searchsorted(known, raw.first[:-1])]
    own = at < raw.first[1:]
    lon, lat = (
        np.where(own, np.append(values, np.nan)[at], np.nan) for values in (raw.lon, raw.lat)
    )
    found = countries_of(rules, lon, lat)
    return found if rules.country else within_borders(raw.borders, lon, lat, found)


def _crossing_mps(raw: RawMap, way: int, read_tags: TagReader, default: float) -> float:
    """Give the speed of a ferry by its length and duration, the default where one is missing."""
    part = slice(raw.first[way], raw.first[way + 1])
    lon, lat = raw.lon[part], raw.lat[part]
    length = float(np.nansum(distance_m(lon[:-1], lat[:-1], lon[1:], lat[1:])))
    crossing = duration_s(read_tags(raw.way_tags[way]).get("duration", ""))
    return default if np.isnan(crossing) else crossing_mps(length, crossing)


def _counts(readings: list[WayReading], ways: list[int]) -> dict[str, int]:
    """Count by ways what was read, dropped and assumed."""
    counts: Counter[str] = Counter()
    kept = 0
    for reading, number in zip(readings[1:], ways[1:], strict=True):
        if not reading.allowed:
            counts[dropped(reading, "ways")] += number
            continue
        kept += number
        for remark in reading.remarks:
            counts[remark] += number
    first = {"ways of these classes": sum(ways[1:]), "ways kept": kept}
    return first | dict(sorted(counts.items()))
