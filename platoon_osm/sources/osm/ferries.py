"""Ferries that carry trucks: ways of `route=ferry`, as slow as their crossing is long.

A ferry is a road of its own class, on which no trip starts or ends. It is taken only where the map
says that trucks or motor vehicles are carried, for many ferries carry people alone. Its speed is
its length by its `duration`; waiting for it to sail is in no tag, and so in no plan.

Source: https://wiki.openstreetmap.org/wiki/Tag:route=ferry and Key:duration.
"""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import replace
from math import isnan, nan

from ..truck import TruckRules, WayReading, read_way

__all__ = ["CARRIED", "FERRY_KMH", "crossing_mps", "duration_s", "is_ferry", "read_ferry"]

CARRIED = frozenset({"yes", "designated", "permissive", "official"})
"""Values of one of `CARRYING` that say so. Whom it refuses is kept like a road's restriction."""

CARRYING = ("hgv", "goods", "motor_vehicle")

FERRY_KMH = 15.0
"""Where there is no duration: a ferry with its landing, over a strait of a few kilometres."""

SLOWEST_MPS, FASTEST_MPS = 1 / 3.6, 80 / 3.6
"""Bounds of a crossing; fast ferries reach 70 km/h, and beyond them the duration is a slip."""

CLOCK = re.compile(r"(\d{1,3}):([0-5]\d)(?::([0-5]\d))?")
ISO = re.compile(r"P(?:(\d+)D)?(?:T(?:(\d+)H)?(?:(\d+)M)?(?:(\d+)S)?)?")


def is_ferry(tags: Mapping[str, str]) -> bool:
    """Say whether a way is a ferry and no road.

    Parameters
    ----------
    tags : mapping of str to str
        Tags of a way.

    Returns
    -------
    bool
        Whether it is.
    """
    return tags.get("route") == "ferry" and "highway" not in tags


def read_ferry(tags: Mapping[str, str], rules: TruckRules) -> WayReading:
    """Read the tags of a ferry.

    Parameters
    ----------
    tags : mapping of str to str
        Tags of a ferry.
    rules : TruckRules
        The truck and the law.

    Returns
    -------
    WayReading
        Its direction and whom it carries; its speeds are those without a duration.
    """
    reading = read_way(tags, rules)
    carries = any(tags.get(key, "").strip().lower() in CARRIED for key in CARRYING)
    remarks = ["ferries taken", *(told for told in reading.remarks if not told.startswith("speed"))]
    if isnan(duration_s(tags.get("duration", ""))):
        remarks.append("speed of a ferry defaulted (no duration that can be read)")
    return replace(
        reading,
        allowed=reading.allowed and carries,
        remarks=tuple(remarks),
        speed_kmh=FERRY_KMH,
        backward_kmh=FERRY_KMH,
        posted_kmh=FERRY_KMH,
        backward_posted_kmh=FERRY_KMH,
        closed_by=reading.closed_by or "route=ferry without hgv or motor_vehicle",
    )


def duration_s(text: str) -> float:
    """Read a duration.

    Parameters
    ----------
    text : str
        Hours and minutes ("01:20", with seconds "01:20:30"), minutes ("20"), or as in ISO 8601
        ("PT1H20M").

    Returns
    -------
    float
        Seconds [s]; NaN where it is none, or no time at all.
    """
    text = text.strip().upper()
    if found := CLOCK.fullmatch(text):
        hours, minutes, seconds = (int(part or 0) for part in found.groups())
        total = 3600 * hours + 60 * minutes + seconds
    elif text.isascii() and text.isdecimal() and len(text) < 5:
        total = 60 * int(text)
    elif found := ISO.fullmatch(text):
        days, hours, minutes, seconds = (int(part or 0) for part in found.groups())
        total = 86_400 * days + 3600 * hours + 60 * minutes + seconds
    else:
        return nan
    return float(total) or nan


def crossing_mps(length_m: float, crossing_s: float) -> float:
    """Work out the speed of a crossing, within the bounds of ferries.

    Parameters
    ----------
    length_m : float
        Of the way [m].
    crossing_s : float
        How long it takes [s].

    Returns
    -------
    float
        Speed [m/s].
    """
    return min(max(length_m / crossing_s, SLOWEST_MPS), FASTEST_MPS)
