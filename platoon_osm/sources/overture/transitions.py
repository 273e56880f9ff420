"""Prohibited transitions as the turn restrictions of OpenStreetMap."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from typing import Any

from ...vehicles.conditional_values import CONDITIONAL
from ..osm.tables import MapTurn
from .parts import Part, Parts
from .rules import BACKWARD, EVERYBODY, FORWARD, keys_of, when_text
from .segments import Segment

__all__ = ["turns_of"]

FORBIDDEN = "no_straight_on"
OTHERS = "motorcar"
"""Stands for modes that no goods vehicle has, so that they are counted as such."""

Way = tuple[str, int, str]


def turns_of(segments: Sequence[Segment], parts: Parts) -> list[MapTurn]:
    """Return the turns that segments prohibit.

    Parameters
    ----------
    segments : sequence of Segment
        Of one file.
    parts : Parts
        The ways that they are cut into; rules that cannot be read are counted there.

    Returns
    -------
    list of MapTurn
        A relation for each rule and heading.
    """
    found: list[MapTurn] = []
    for segment in segments:
        for rule in segment.about.get("prohibited_transitions") or ():
            tags = _tags(rule.get("when") or {}, parts.counts)
            if tags is None:
                continue
            for members in _members(segment, rule, parts):
                found.append(MapTurn(-1 - len(found), members, tags))
    return found


def _tags(when: Mapping[str, Any], counts: Counter[str]) -> dict[str, str] | None:
    condition = when_text(when)
    if condition is None or when.get("using") or when.get("recognized"):
        counts["prohibited transitions not read: for some purpose or size"] += 1
        return None
    tags = {"type": "restriction"}
    for key in keys_of(when) or (OTHERS,):
        name = "restriction" if key == EVERYBODY else f"restriction:{key}"
        tags[f"{name}{CONDITIONAL}" if condition else name] = (
            f"{FORBIDDEN} @ ({condition})" if condition else FORBIDDEN
        )
    return tags


def _members(segment: Segment, rule: Mapping[str, Any], parts: Parts) -> Iterator[tuple[Way, ...]]:
    """Yield the members of the relations that a rule stands for; those of none if it is broken."""
    steps = [(str(one["connector_id"]), str(one["segment_id"])) for one in rule["sequence"]]
    nodes = [parts.connector.get(name) for name, _ in steps]
    heading = (rule.get("when") or {}).get("heading")
    last = parts.of.get(steps[-1][1], [])
    onward = _beginning(last, nodes[-1], str(rule["final_heading"]))
    between = [
        way
        for (_, name), start, end in zip(steps, nodes, nodes[1:], strict=False)
        for way in _between(parts.of.get(name, []), start, end)
    ]
    complete = onward and (len(steps) == 1 or between) and None not in nodes
    via: list[Way] = [("w", way, "via") for way in between] or [("n", nodes[0] or 0, "via")]
    for one in (heading,) if heading else (FORWARD, BACKWARD):
        arriving = _ending(parts.of.get(segment.name, []), nodes[0], one)
        if arriving and complete and onward:
            yield (("w", arriving.way, "from"), *via, ("w", onward.way, "to"))
        elif heading or not complete:
            # Told so that the relation is counted as broken, by what is missing.
            yield (("w", arriving.way, "from"),) if arriving else ()
            return


def _ending(parts: Sequence[Part], node: int | None, heading: str) -> Part | None:
    """Return the part by which one arrives at a node."""
    return next((one for one in parts if node == _ends(one)[heading == FORWARD]), None)


def _beginning(parts: Sequence[Part], node: int | None, heading: str) -> Part | None:
    """Return the part by which one leaves a node."""
    return next((one for one in parts if node == _ends(one)[heading != FORWARD]), None)


def _ends(part: Part) -> tuple[int, int]:
    return part.first, part.last


def _between(parts: Sequence[Part], start: int | None, end: int | None) -> list[int]:
    """Return the ways of a segment from one of its nodes to another, in driving order."""
    places = {
        node: at for part in parts for node, at in ((part.first, part.low), (part.last, part.high))
    }
    if start not in places or end not in places:
        return []
    low, high = sorted((places[start], places[end]))
    ways = [part.way for part in parts if low <= part.low and part.high <= high]
    return ways if places[start] < places[end] else ways[::-1]
