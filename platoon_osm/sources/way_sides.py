"""The two directions of a road: which tags hold in each, and what they restrict there.

A road may be open one way to some and the other way to others, and change with the hour. So each
direction is read by itself: its layers (see `network.restrictions`) say whom it is closed to.
"""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterable, Mapping
from functools import lru_cache

from ..network.restrictions import Layer
from ..vehicles.access import (
    CHAIN,
    HAZARDOUS,
    LANES,
    RESERVED,
    RESERVED_FOR,
    Way,
    read_value,
)
from ..vehicles.conditions import CONDITIONAL, rules_of
from ..vehicles.judgement import TUNNEL, judge
from ..vehicles.limits import LIMITS, read_limit
from ..vehicles.profile import Vehicle

__all__ = [
    "AGAINST",
    "CHANGING",
    "FALSE",
    "TRUE",
    "Layers",
    "for_side",
    "is_restriction",
    "open_to_any",
    "restricting",
    "sides_of",
    "unread",
]

Layers = tuple[Layer, ...]
SIDES = ("forward", "backward")
MANY = 10_000
"""Keys whose reading is remembered; maps of whole countries have a few thousand."""

TRUE = frozenset({"yes", "true", "1"})
AGAINST = frozenset({"-1", "reverse"})
FALSE = frozenset({"no", "false", "0"})
"""Values of `oneway`, and of other tags that are or are not so."""

CHANGING = frozenset({"reversible", "alternating", "alternate"})
ONLY_SOME = ("oneway:hgv", "oneway:goods", "oneway:motor_vehicle", "oneway:vehicle")
"""Directions for some vehicles alone."""

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


def for_side(tags: Mapping[str, str], side: str) -> dict[str, str]:
    """Return tags as they hold in one direction.

    Parameters
    ----------
    tags : mapping of str to str
        Of a road.
    side : {"forward", "backward"}
        Along the way as it is drawn, or against it.

    Returns
    -------
    dict of str to str
        `hgv:forward` in place of `hgv`, without what is said of the other direction.
    """
    if not any(":forward" in key or ":backward" in key for key in tags):
        return dict(tags)
    own: dict[str, str] = {}
    special: dict[str, str] = {}
    for key, value in tags.items():
        parts = key.split(":")
        found = [part for part in parts if part in SIDES]
        if not found:
            own[key] = value
        elif found == [side]:
            special[":".join(part for part in parts if part not in SIDES)] = value
    return own | special


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
        return text.lower() in RESERVED_FOR.get(key, frozenset({"only", "required"}))
    if key in HAZARDOUS or key.startswith(FAMILIES) or key == "trailer":
        return read_value(text)[0] != Way.OPEN
    limit = key if key in LIMITS else key.rpartition(":")[0]
    value = read_limit(text, LIMITS[limit].unit)
    if value is None:
        counts[f"restrictions not understood: {key}"] += 1
        return False
    return value < float("inf")


def sides_of(
    tags: Mapping[str, str], one_way: int, counts: Counter[str]
) -> tuple[tuple[Layer, ...] | None, tuple[Layer, ...] | None]:
    """Return what is restricted along a road and against it by its direction alone.

    Parameters
    ----------
    tags : mapping of str to str
        Of a road.
    one_way : int
        1 along the way, -1 against it, 0 both, by its class and shape where no tag says.
    counts : Counter
        Counts what changes by the hour.

    Returns
    -------
    tuple of (tuple of Layer or None)
        Along and against; None where nobody may drive at any time.
    """
    value = tags.get("oneway", "").strip().lower()
    rules = [
        (rule.value.strip().lower(), " AND ".join(f"({part})" for part in rule.conditions))
        for rule in rules_of(tags.get("oneway:conditional", ""))
        if rule.conditions
    ]
    plain = _open(value, one_way)
    if value in CHANGING:
        counts["carriageways that change their direction, closed but at known hours"] += 1
    sides = []
    for at in (0, 1):
        layers: list[Layer] = []
        allowed = [(_open(said, one_way)[at], condition) for said, condition in rules]
        if not plain[at] and not any(open_then for open_then, _ in allowed):
            layers, possible = [], False
        else:
            possible = True
            if any(open_then != plain[at] for open_then, _ in allowed):
                told = "; ".join(f"{'yes' if one else 'no'} @ ({text})" for one, text in allowed)
                layers.append(
                    {**({} if plain[at] else {"access": "no"}), f"access{CONDITIONAL}": told}
                )
        for key in ONLY_SOME:
            if key not in tags:
                continue
            own = _open(tags[key].strip().lower(), one_way)[at]
            whom = key.partition(":")[2]
            if own and not possible:
                layers, possible = [{"access": "no", whom: "yes"}], True
            elif not own and possible:
                layers.append({whom: "no"})
        sides.append(tuple(layers) if possible else None)
    return sides[0], sides[1]


def _open(value: str, one_way: int) -> tuple[bool, bool]:
    """Return whether a road is open along and against it."""
    if value in CHANGING:
        return False, False
    if value in TRUE:
        return True, False
    if value in AGAINST:
        return False, True
    if value in FALSE:
        return True, True
    return one_way >= 0, one_way <= 0


def open_to_any(layers: tuple[Layer, ...]) -> str:
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
