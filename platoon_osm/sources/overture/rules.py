"""Overture's rules of access and speed as OpenStreetMap's tags, so that both mean the same here.

A rule says allowed, denied or designated, and when: for a heading, modes of travel, hours, purposes
("at_destination"), a recognized status ("as_private") and sizes of a vehicle. A later rule stands
before an earlier one, where OpenStreetMap's more specific key stands before a general one: a rule
for all therefore takes back what earlier ones said for some. But a heading that is denied to all
makes the road one-way, whatever order the rules have: nobody is sent against the traffic because a
later rule says that trucks are welcome.

Source: https://docs.overturemaps.org/schema/reference/transportation/
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Mapping, Sequence
from typing import Any, NamedTuple

from ...vehicles.access import CHAIN
from ...vehicles.conditional_values import CONDITIONAL
from ...vehicles.units import FOOT_M, INCH_M, LONG_TON_T, POUND_T, SHORT_TON_T

__all__ = ["BACKWARD", "EVERYBODY", "FORWARD", "access_tags", "keys_of", "speed_tags", "when_text"]

Rule = Mapping[str, Any]
Tags = dict[str, str]

EVERYBODY = "access"
FORWARD, BACKWARD = "forward", "backward"
ONE_WAY: Mapping[str, str] = {BACKWARD: "yes", FORWARD: "-1"}
"""The direction that is left where a heading is denied to all."""
MODES: Mapping[str, tuple[str, ...]] = {
    "vehicle": ("vehicle",),
    "motor_vehicle": ("motor_vehicle",),
    "truck": ("goods", "hgv"),
    "hgv": ("hgv",),
}
"""Keys of access that a mode of travel stands for; those of others bind no goods vehicle."""
AT_ENDS: Mapping[str, str] = {
    "at_destination": "destination",
    "to_deliver": "delivery",
    "as_customer": "customers",
    "as_permitted": "permit",
    "as_private": "private",
}
"""Purposes and statuses that a goods vehicle at the end of its trip may have."""
SIGNS: Mapping[str, str] = {
    "greater_than": ">", "greater_than_equal": ">=", "equal": "=", "less_than": "<",
    "less_than_equal": "<=",
}  # fmt: skip
DIMENSIONS: Mapping[str, str] = {
    "height": "height", "width": "width", "length": "length", "weight": "weight",
    "axle_count": "axles",
}  # fmt: skip
METRES: Mapping[str, float] = {
    "m": 1.0, "cm": 0.01, "km": 1000.0, "in": INCH_M, "ft": FOOT_M, "yd": 3 * FOOT_M,
    "mi": 5280 * FOOT_M,
}  # fmt: skip
TONNES: Mapping[str, float] = {
    "t": 1.0, "kg": 1e-3, "g": 1e-6, "lb": POUND_T, "oz": POUND_T / 16,
    "st": SHORT_TON_T, "lt": LONG_TON_T,
}  # fmt: skip


def keys_of(when: Rule) -> tuple[str, ...]:
    """Return the keys of access that a scope binds.

    Parameters
    ----------
    when : mapping
        The scope of a rule.

    Returns
    -------
    tuple of str
        None if it binds no goods vehicle.
    """
    modes = when.get("mode")
    if not modes:
        return (EVERYBODY,)
    return tuple(dict.fromkeys(key for mode in modes for key in MODES.get(mode, ())))


def when_text(when: Rule) -> str | None:
    """Return hours and sizes of a scope as a condition.

    Parameters
    ----------
    when : mapping
        The scope of a rule.

    Returns
    -------
    str or None
        As stands behind the @ of a conditional tag; empty if it names neither, None if it cannot
        be said so.
    """
    parts = [str(when["during"])] if when.get("during") else []
    for asked in when.get("vehicle") or ():
        size = _size(asked)
        if size is None:
            return None
        parts.append("".join(size))
    return " AND ".join(parts)


class _Size(NamedTuple):
    """What a size of the vehicle is compared with."""

    name: str
    sign: str
    number: str


def _size(asked: Rule) -> _Size | None:
    """Return a comparison in metres or tonnes; None if it is not known."""
    name, sign = DIMENSIONS.get(asked["dimension"]), SIGNS.get(asked["comparison"])
    unit = asked.get("unit") or ""
    factor = 1.0 if name == "axles" else (TONNES if name == "weight" else METRES).get(unit)
    if name is None or sign is None or factor is None:
        return None
    return _Size(name, sign, f"{round(float(asked['value']) * factor, 6):g}")


def access_tags(rules: Iterable[Rule], counts: Counter[str]) -> Tags:
    """Return what rules of access mean.

    Parameters
    ----------
    rules : iterable of mapping
        Those of one part of a segment, in their order.
    counts : Counter
        Counts rules that could not be read, by reason.

    Returns
    -------
    dict of str to str
        Tags of direction, access, sizes and conditions.
    """
    # Said, for a motorway without it would be one-way.
    tags: Tags = {"oneway": "no"}
    for rule in rules:
        when = rule.get("when") or {}
        keys = keys_of(when)
        if rule["access_type"] == "denied" and _names(when) == {"heading"}:
            other = ONE_WAY[BACKWARD if when["heading"] == FORWARD else FORWARD]
            if tags["oneway"] == other:
                tags[EVERYBODY] = "no"
            tags["oneway"] = ONE_WAY[when["heading"]]
            continue
        value = _value(rule["access_type"], when, counts) if keys else None
        condition = when_text(when)
        if condition is None:
            counts["access rules not read: a size that is not known"] += 1
        if value is None or condition is None:
            continue
        heading = _heading(when)
        for key in keys:
            limit = _limit(when, value, key)
            if limit:
                tags[f"{limit[0]}{heading}"] = limit[1]
            elif condition:
                name = f"{key}{heading}{CONDITIONAL}"
                told = f"{value} @ ({condition})"
                tags[name] = f"{tags[name]}; {told}" if name in tags else told
            else:
                _take_back(tags, key, heading, value)
                tags[f"{key}{heading}"] = value
    return tags


def _heading(when: Rule) -> str:
    """Return the end of a key that holds for the heading of a scope; empty for both."""
    return f":{when['heading']}" if when.get("heading") else ""


def _names(when: Rule) -> set[str]:
    """Return what a scope speaks of."""
    return {name for name, value in when.items() if value}


def _value(access: str, when: Rule, counts: Counter[str]) -> str | None:
    """Return the value of access; None if the rule says nothing to goods vehicles."""
    purposes = [*(when.get("using") or ()), *(when.get("recognized") or ())]
    if not purposes:
        return {"allowed": "yes", "denied": "no", "designated": "designated"}.get(access)
    if access == "denied":
        counts["access rules not read: denied for a purpose"] += 1
        return None
    return next((AT_ENDS[purpose] for purpose in purposes if purpose in AT_ENDS), None)


def _limit(when: Rule, value: str, key: str) -> tuple[str, str] | None:
    """Return the largest size of a rule that denies all above it and says nothing else."""
    sizes = list(when.get("vehicle") or [])
    if value != "no" or len(sizes) != 1 or when.get("during"):
        return None
    size = _size(sizes[0])
    if size is None or size.name == "axles" or size.sign != ">":
        return None
    limit = f"max{size.name}"
    return (limit if key == EVERYBODY else f"{limit}:{key}"), size.number


def _take_back(tags: Tags, key: str, heading: str, value: str) -> None:
    """Make a rule for all stand before earlier ones for some."""
    for specific in list(CHAIN)[: CHAIN.index(key) + 1]:
        for name in [name for name in tags if name.split(":")[0] == specific]:
            of_heading = name.removesuffix(CONDITIONAL).removeprefix(specific)
            if heading in ("", of_heading):
                del tags[name]
            elif not of_heading and specific != key and name == specific:
                tags[f"{specific}{heading}"] = value


def speed_tags(rules: Sequence[Rule], counts: Counter[str]) -> Tags:
    """Return what limits of speed mean.

    Parameters
    ----------
    rules : sequence of mapping
        Those of one part of a segment, in their order.
    counts : Counter
        Counts limits that could not be read, by reason.

    Returns
    -------
    dict of str to str
        Tags that begin with maxspeed.
    """
    tags: Tags = {}
    for rule in rules:
        when, speed = rule.get("when") or {}, rule.get("max_speed")
        keys = keys_of(when)
        if not speed or not keys:
            continue
        condition = when_text(when)
        if condition is None or when.get("using") or when.get("recognized"):
            counts["speed limits not read: for some purpose or size"] += 1
            continue
        heading = _heading(when)
        # A limit of trucks of any size holds for heavy ones too.
        whom = "maxspeed:hgv" if "hgv" in keys else "maxspeed"
        told = f"{speed['value']}{' mph' if speed.get('unit') == 'mph' else ''}"
        if condition:
            tags[f"{whom}{heading}{CONDITIONAL}"] = f"{told} @ ({condition})"
        else:
            tags[f"{whom}{heading}"] = told
    return tags
