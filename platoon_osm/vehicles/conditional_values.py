"""The form of tags that hold under conditions: "no @ (22:00-05:00); destination @ (weight>7.5)".

A value is a list of rules `value @ condition`, divided by semicolons; semicolons inside of brackets
belong to the times there. Conditions joined by AND must all hold.

Source: https://wiki.openstreetmap.org/wiki/Conditional_restrictions
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from functools import lru_cache

__all__ = ["CONDITIONAL", "OLD_FORMS", "Rule", "has_conditions", "rules_of"]

CONDITIONAL = ":conditional"

OLD_FORMS = re.compile(r"(^|:)(hour|day|date|week|month)_(on|off)$")
"""Keys for times from before there were conditions; seen, and not read."""

AND = re.compile(r"\s+AND\s+|\s*&&\s*|(?<=\))\s*AND\s*(?=\()", re.IGNORECASE)


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
