"""The two directions of a road: which tags hold in each, and whom its direction alone shuts out.

A road may be open one way to some and the other way to others, and change with the hour. So each
direction is read by itself: its layers (see `network.restrictions`) say whom it is closed to.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping

from ..network.restrictions import Layer
from ..vehicles.conditional_values import CONDITIONAL, rules_of

__all__ = [
    "AGAINST", "CHANGING", "FALSE", "ONLY_SOME", "SIDES", "TRUE", "Layers", "for_side", "sides_of",
]  # fmt: skip

Layers = tuple[Layer, ...]
SIDES = ("forward", "backward")

TRUE = frozenset({"yes", "true", "1"})
AGAINST = frozenset({"-1", "reverse"})
FALSE = frozenset({"no", "false", "0"})
"""Values of `oneway`, and of other tags that are or are not so."""

CHANGING = frozenset({"reversible", "alternating", "alternate"})
ONLY_SOME = ("oneway:hgv", "oneway:goods", "oneway:motor_vehicle", "oneway:vehicle")
"""Directions for some vehicles alone."""


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


def sides_of(
    tags: Mapping[str, str], one_way: int, counts: Counter[str]
) -> tuple[Layers | None, Layers | None]:
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
        possible = plain[at] or any(open_then for open_then, _ in allowed)
        if possible and any(open_then != plain[at] for open_then, _ in allowed):
            told = "; ".join(f"{'yes' if one else 'no'} @ ({text})" for one, text in allowed)
            otherwise = {} if plain[at] else {"access": "no"}
            layers.append({**otherwise, f"access{CONDITIONAL}": told})
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
