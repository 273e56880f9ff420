"""Tags that hold under conditions: `maxspeed:conditional = 60 @ (22:00-06:00 AND weight>7.5)`.

A value is a list of rules `value @ condition`, divided by semicolons; semicolons inside of brackets
belong to the times there. Conditions joined by AND must all hold. Of the rules that hold, the last
one counts; if none holds, the plain tag stands.

Each condition of a rule is one of these:

- about the vehicle ("weight>7.5", "length>12", "trailer", "hgv", "hazmat"): always decided;
- times ("Mo-Fr 07:00-19:00", "Nov-Mar", "PH", "sunset-sunrise"): decided for a moment;
- a purpose ("destination", "delivery"): who only passes has none, and who starts or ends there may
  have it. So "yes" under a purpose is that purpose as a value of access, which ends a trip;
- weather ("wet", "snow", "winter"), or a text nobody can read: undecided.

An undecided rule does not count, the plain tag stands, and the caller is told, unless the rule
would not change anything.

Source: https://wiki.openstreetmap.org/wiki/Conditional_restrictions
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from datetime import datetime, timedelta
from functools import lru_cache

from .hours import LongLat, hours_change, hours_hold, reads_as_hours
from .profile import Vehicle
from .vehicle_conditions import Asked, asked_of

__all__ = ["CONDITIONAL", "Rule", "apply", "has_conditions", "next_change", "rules_of"]

CONDITIONAL = ":conditional"

OLD_FORMS = re.compile(r"(^|:)(hour|day|date|week|month)_(on|off)$")
"""Keys for times from before there were conditions; seen, and not read."""

AND = re.compile(r"\s+AND\s+|\s*&&\s*|(?<=\))\s*AND\s*(?=\()", re.IGNORECASE)

PURPOSES = {
    "destination": "destination", "delivery": "delivery", "deliveries": "delivery",
    "customers": "customers", "customer": "customers", "permit": "permit", "private": "private",
    "loading": "delivery", "unloading": "delivery", "residents": "private",
}  # fmt: skip
"""What somebody is there for, and the value of access that says so."""

OPEN_VALUES = frozenset({"yes", "designated", "permissive", "official", "destination", "delivery"})

LIMITS = ("max", "min", "oneway", "overtaking", "restriction")
"""Beginnings of keys whose values are no values of access."""

FURTHEST = timedelta(days=366)
MOST_CHANGES = 2000
"""How far and how often `next_change` looks for a change that matters."""


@dataclass(frozen=True, slots=True)
class Rule:
    """One rule of a conditional value.

    Attributes
    ----------
    value : str
        What holds under its conditions.
    conditions : tuple of str
        All of which must hold; empty for a rule that cannot be read.
    """

    value: str
    conditions: tuple[str, ...]


@lru_cache(maxsize=20_000)
def rules_of(text: str) -> tuple[Rule, ...]:
    """Return the rules of a conditional value, in order.

    Parameters
    ----------
    text : str
        Such as "no @ (22:00-05:00); destination @ (weight>7.5)".

    Returns
    -------
    tuple of Rule
        A rule that cannot be read has no conditions.
    """
    parts: list[str] = []
    for part in _outside(text, ";"):
        if "@" not in part and parts and "@" in parts[-1]:
            # Times with semicolons whose brackets were forgotten.
            parts[-1] += ";" + part
        elif part.strip():
            parts.append(part)
    return tuple(_rule(part) for part in parts)


def has_conditions(tags: Mapping[str, str]) -> bool:
    """Tell whether any of some tags depends on conditions.

    Parameters
    ----------
    tags : mapping of str to str
        Of a road.

    Returns
    -------
    bool
        Conditions of today or of the old form.
    """
    return any(key.endswith(CONDITIONAL) or OLD_FORMS.search(key) for key in tags)


def apply(
    tags: Mapping[str, str],
    vehicle: Vehicle,
    when: datetime | None = None,
    place: LongLat | None = None,
    country: str | None = None,
) -> tuple[dict[str, str], bool]:
    """Return tags with their conditions settled for a vehicle at a moment.

    Parameters
    ----------
    tags : mapping of str to str
        Of a road.
    vehicle : Vehicle
        Who drives.
    when : datetime, optional
        What clocks on the spot show; without it, times are undecided.
    place : (float, float), optional
        Longitude and latitude, for the sun.
    country : str, optional
        Two letters, for public holidays.

    Returns
    -------
    tags : dict of str to str
        Plain tags only.
    undecided : bool
        Whether something that is not known would change them.
    """
    plain = {
        key: value
        for key, value in tags.items()
        if not key.endswith(CONDITIONAL) and not OLD_FORMS.search(key)
    }
    undecided = any(OLD_FORMS.search(key) for key in tags)
    asking = _Asking(vehicle, when, place, country)
    for key in sorted(tags):
        if not key.endswith(CONDITIONAL):
            continue
        base = key.removesuffix(CONDITIONAL)
        found = plain.get(base)
        open_questions: list[str] = []
        for rule in reversed(rules_of(tags[key])):
            holds, value = asking.settled(base, rule)
            if holds:
                found = value
                break
            if holds is None:
                open_questions.append(value)
        undecided |= any(value != found for value in open_questions)
        if base and found is not None:
            plain[base] = found
    return plain, undecided


def next_change(
    tags: Mapping[str, str],
    vehicle: Vehicle,
    when: datetime,
    place: LongLat | None = None,
    country: str | None = None,
) -> datetime | None:
    """Return when tags next say something else to a vehicle.

    Parameters
    ----------
    tags : mapping of str to str
        Of a road.
    vehicle : Vehicle
        Who drives.
    when : datetime
        What clocks on the spot show.
    place : (float, float), optional
        Longitude and latitude, for the sun.
    country : str, optional
        Two letters, for public holidays.

    Returns
    -------
    datetime or None
        After `when`, without a zone; None if nothing changes within a year.
    """
    times = {
        condition
        for key, text in tags.items()
        if key.endswith(CONDITIONAL)
        for rule in rules_of(text)
        for condition in rule.conditions
        if _is_hours(condition)
    }
    at = begin = when.replace(tzinfo=None)
    now = apply(tags, vehicle, at, place, country)
    for _ in range(MOST_CHANGES):
        try:
            changes = [
                found
                for condition in times
                if (found := hours_change(condition, at, place, country)) is not None and found > at
            ]
        except OverflowError:
            return None
        if not changes or min(changes) - begin > FURTHEST:
            return None
        at = min(changes)
        if apply(tags, vehicle, at, place, country) != now:
            return at
    return None


@dataclass(frozen=True, slots=True)
class _Asking:
    """Who asks, when and where."""

    vehicle: Vehicle
    when: datetime | None
    place: LongLat | None
    country: str | None

    def settled(self, base: str, rule: Rule) -> tuple[bool | None, str]:
        """Return whether a rule holds, None if undecided, and what it then says."""
        if not rule.conditions:
            return None, rule.value
        purpose = None
        answers = []
        for condition in rule.conditions:
            word = PURPOSES.get(condition.lower())
            if word is None:
                answers.append(self._holds(condition))
            else:
                purpose = word
        if False in answers:
            return False, rule.value
        if None in answers:
            return None, rule.value
        if purpose is None:
            return True, rule.value
        if rule.value.lower() in OPEN_VALUES and not base.startswith(LIMITS):
            return True, purpose
        return None, rule.value

    def _holds(self, condition: str) -> bool | None:
        asked = _asked(condition)
        if asked is not None:
            return asked(self.vehicle)
        if self.when is None:
            return None
        return hours_hold(condition, self.when, self.place, self.country)


@lru_cache(maxsize=20_000)
def _asked(condition: str) -> Asked | None:
    return asked_of(condition)


def _is_hours(condition: str) -> bool:
    return (
        condition.lower() not in PURPOSES
        and _asked(condition) is None
        and reads_as_hours(condition)
    )


def _rule(text: str) -> Rule:
    value, at, condition = text.partition("@")
    value, condition = value.strip(), condition.strip()
    if not at or not value or not condition:
        return Rule(value, ())
    parts = [_bare(part) for part in _joined(_bare(condition))]
    return Rule(value, tuple(parts) if all(parts) else ())


def _joined(condition: str) -> Iterator[str]:
    """Yield what AND joins outside of brackets."""
    begin = 0
    for found in AND.finditer(condition):
        if _depth(condition[: found.start()]) == 0:
            yield condition[begin : found.start()]
            begin = found.end()
    yield condition[begin:]


def _bare(text: str) -> str:
    """Return a text without the brackets around all of it."""
    text = text.strip()
    while text.startswith("(") and text.endswith(")") and _closes_at_end(text):
        text = text[1:-1].strip()
    return text


def _closes_at_end(text: str) -> bool:
    depth = 0
    for place, sign in enumerate(text):
        depth += (sign == "(") - (sign == ")")
        if depth == 0:
            return place == len(text) - 1
    return False


def _outside(text: str, divider: str) -> Iterator[str]:
    """Yield the parts of a text between dividers that stand outside of brackets."""
    depth, begin = 0, 0
    for place, sign in enumerate(text):
        depth = max(0, depth + (sign == "(") - (sign == ")"))
        if sign == divider and depth == 0:
            yield text[begin:place]
            begin = place + 1
    yield text[begin:]


def _depth(text: str) -> int:
    return text.count("(") - text.count(")")
