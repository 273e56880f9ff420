"""Which tags of a road or a barrier restrict somebody, and which only sound like it."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterable, Mapping
from functools import lru_cache

from ..network.restrictions import Layer
from ..vehicles.access import CHAIN, HAZARDOUS, LANES, RESERVED, RESERVED_FOR, Way, read_value
from ..vehicles.conditional_values import CONDITIONAL
from ..vehicles.judgement import TUNNEL, judge
from ..vehicles.limits import LIMITS, read_limit
from ..vehicles.profile import Vehicle
from .way_sides import ONLY_SOME, SIDES, Layers

__all__ = ["ALONE", "LIMITED_FOR", "is_restriction", "open_to_any", "restricting", "unread"]

MANY = 10_000
"""Keys whose reading is remembered; maps of whole countries have a few thousand."""

ALONE = frozenset({*CHAIN, *HAZARDOUS, *RESERVED, "trailer", *TUNNEL, *LIMITS})
FAMILIES = ("hazmat:",)
LIMITED_FOR = frozenset({*CHAIN, "trailer"})

NOT_JUDGED = frozenset(
    {
        "maxbogieweight", "maxtandemaxleload", "maxtridemaxleload", "maxaxles", "maxdraught",
        "maxspan", "maxheight:legal",
    }
)  # fmt: skip
"""Restrictions that ask what our vehicles do not tell; they are counted."""

ABOUT_OTHERS = re.compile(
    r"^(maxspeed|maxstay|max_age|maxtents|max_level|maxcapacity|maxspeed_)|"
    r":(advisory|practical|variable|source|note|type|signed|url|website|description|date)\b|"
    r"^(access|hgv|vehicle|motor_vehicle|goods|maxheight|maxweight|maxlength|maxwidth)(:|_)"
    r"(source|note|reason|disabled|ref|date|url|description|fixme|national_network|state_network)"
)
"""Keys that begin like a restriction and are none: speeds, which are read elsewhere, and notes."""

LIKE_ACCESS = re.compile(
    r"^(hgv|goods|motor_vehicle|vehicle|access|hazmat|trailer|max[a-z]+|oneway)(:|$|_)"
)

SMALL = (
    Vehicle("any truck", 0.5, 0.5, 1.0, 3.6, 3.6, 0.1, False),
    Vehicle("any van", 0.5, 0.5, 1.0, 0.1, 0.1, 0.1, False),
)
"""If a road is closed to both of them, it is to everything the package plans for."""


@lru_cache(maxsize=MANY)
def is_restriction(key: str) -> bool:
    """Say whether a key may close a road to somebody.

    Parameters
    ----------
    key : str
        Of a tag, whichever direction or lanes it is for.

    Returns
    -------
    bool
        Whether this package reads it as such.
    """
    base = _base(key)
    if base in ALONE or base.startswith(FAMILIES):
        return True
    limit, _, whom = base.rpartition(":")
    return limit in LIMITS and whom in LIMITED_FOR


def _base(key: str) -> str:
    """Return a key without condition, direction and lanes."""
    first, *parts = key.removesuffix(CONDITIONAL).split(":")
    return ":".join([first, *(part for part in parts if part not in (*SIDES, LANES[1:]))])


def unread(tags: Iterable[str]) -> list[str]:
    """Return the keys that sound like restrictions and are not read.

    Parameters
    ----------
    tags : iterable of str
        Keys of a road.

    Returns
    -------
    list of str
        Without condition, direction and lanes.
    """
    return [_base(key) for key in tags if _is_unread(key)]


@lru_cache(maxsize=MANY)
def _is_unread(key: str) -> bool:
    base = _base(key)
    if base in NOT_JUDGED:
        return True
    return bool(
        LIKE_ACCESS.match(base)
        and not is_restriction(key)
        and not ABOUT_OTHERS.search(key)
        and base not in ("oneway", *ONLY_SOME)
        and not base.startswith(("oneway:bicycle", "oneway:bus", "oneway:psv", "oneway:foot"))
    )


def restricting(tags: Mapping[str, str], counts: Counter[str]) -> Layer:
    """Return of the tags of one direction those that restrict somebody.

    Parameters
    ----------
    tags : mapping of str to str
        As they hold in one direction; of a road or a barrier.
    counts : Counter
        Counts what was read, by key, and what was not understood.

    Returns
    -------
    mapping of str to str
        Empty if anybody may pass at any time.
    """
    own = _of_lanes({key: value for key, value in tags.items() if is_restriction(key)})
    chain, rest = {}, {}
    for key, value in own.items():
        base = key.removesuffix(CONDITIONAL)
        text = " ".join(value.split())
        if base in CHAIN:
            chain[key] = text
        elif key != base or _restricts(base, text, counts):
            rest[key] = text
    for key, value in chain.items():
        if key.endswith(CONDITIONAL):
            continue
        for unknown in read_value(value)[1]:
            counts["access values not in the table, taken as closed"] += bool(unknown)
    if not any(key.endswith(CONDITIONAL) or read_value(text)[0] for key, text in chain.items()):
        chain = {}
    for key in (*chain, *rest):
        counts[f"restrictions read: {key}"] += 1
    # Named trucks may drive on a carriageway that is reserved for others.
    if any(key in RESERVED for key in rest):
        chain = {**{key: text for key, text in own.items() if key in CHAIN[:3]}, **chain}
    return {**chain, **rest}


def _of_lanes(tags: dict[str, str]) -> dict[str, str]:
    """Return tags in which what is said lane by lane stands for the road: as its best lane."""
    found = {key: value for key, value in tags.items() if LANES not in key}
    for key, value in tags.items():
        if LANES not in key:
            continue
        plain = key.replace(LANES, "")
        if plain in found:
            continue
        lanes = [lane.strip().lower() for lane in value.split("|")]
        if plain.removesuffix(CONDITIONAL) in RESERVED:
            # `hov:lanes=designated||` leaves two lanes to all others.
            if all(lane in (*RESERVED_FOR["hov"], "designated") for lane in lanes):
                found[plain] = "only"
            continue
        if plain.removesuffix(CONDITIONAL) not in LIMITS:
            found[plain] = min(lanes, key=lambda lane: read_value(lane)[0])
        elif all(lanes):
            unit = LIMITS[plain.removesuffix(CONDITIONAL)].unit
            found[plain] = max(lanes, key=lambda lane: read_limit(lane, unit) or 0.0)
    return found


def _restricts(key: str, text: str, counts: Counter[str]) -> bool:
    """Tell whether a plain tag other than the chain of access keys restricts anybody."""
    if key in TUNNEL:
        return text.strip().upper() not in ("", "A", "NONE", "NO")
    if key in RESERVED:
        return text.lower() in RESERVED_FOR[key]
    if key in HAZARDOUS or key.startswith(FAMILIES) or key == "trailer":
        return read_value(text)[0] != Way.OPEN
    limit = key if key in LIMITS else key.rpartition(":")[0]
    value = read_limit(text, LIMITS[limit].unit)
    if value is None:
        counts[f"restrictions not understood: {key}"] += 1
        return False
    return value < float("inf")


def open_to_any(layers: Layers) -> str:
    """Return why a road is closed to all vehicles of the package at all times.

    Parameters
    ----------
    layers : tuple of Layer
        Of one direction.

    Returns
    -------
    str
        The tags that close it; empty if somebody may drive there, be it at some hours or at the
        ends of a trip.
    """
    kinds: list[str] = []
    if any(key.endswith(CONDITIONAL) for layer in layers for key in layer):
        return ""  # to whom and when depends on more than these two
    for vehicle in SMALL:
        judged = judge(layers, vehicle)
        if judged.way != Way.CLOSED or judged.undecided:
            return ""
        kinds += judged.kinds
    return ", ".join(dict.fromkeys(kinds))
