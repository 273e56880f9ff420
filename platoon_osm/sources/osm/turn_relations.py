"""Turn restrictions of OpenStreetMap as sequences of segments that may not be driven.

A relation names the ways from which and to which a turn leads, and the node or the ways between. It
is obeyed where its members say exactly one sequence, or for `no_u_turn`, `no_entry` and `no_exit`
the several they mean; a relation that is broken or ambiguous is counted by what is wrong with it,
and never guessed.

Source: https://wiki.openstreetmap.org/wiki/Relation:restriction
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from ...network.preparing.turns import ForbiddenTurn
from ...network.restrictions import Layer
from ...vehicles.access import CHAIN
from ...vehicles.conditional_values import CONDITIONAL
from .raw_map import RawMap, TagReader

__all__ = ["Segments", "forbidden_turns"]

Index = NDArray[np.int64]

OLD = ("day_on", "day_off", "hour_on", "hour_off", "date_on", "date_off")
OTHERS = frozenset(
    {"psv", "bus", "bicycle", "motorcar", "taxi", "emergency", "motorcycle", "moped", "caravan",
     "foot", "tourist_bus", "coach", "tram", "hov", "none", "trailer", "agricultural", "mofa"}
)  # fmt: skip
"""Whom a restriction may be for, or except, without binding or freeing a goods vehicle."""


@dataclass(frozen=True, slots=True, eq=False)
class Segments:
    """Directed segments of the kept ways.

    Attributes
    ----------
    tail, head : ndarray of int64, (s,)
        Node positions.
    way : ndarray of int64, (s,)
        Which way of the raw map each is on.
    start : ndarray of int64, (s,)
        Where on it, as a position in the raw map's nodes; that of the first node as it is drawn.
    forward : ndarray of bool, (s,)
        Whether it is driven as it is drawn.
    """

    tail: Index
    head: Index
    way: Index
    start: Index
    forward: NDArray[np.bool_]


class _BrokenError(Exception):
    """A relation that cannot be obeyed, with the reason as it is counted."""


def forbidden_turns(
    raw: RawMap, segments: Segments, node_ids: Index, counts: Counter[str]
) -> list[ForbiddenTurn]:
    """Return the sequences that turn restrictions forbid.

    Parameters
    ----------
    raw : RawMap
        The file.
    segments : Segments
        Of the roads that are kept.
    node_ids : ndarray of int64, (n,)
        OpenStreetMap ids of the nodes, rising.
    counts : Counter
        Counts relations read, obeyed and ignored, the last by reason.

    Returns
    -------
    list of ForbiddenTurn
        In the order of the file.
    """
    if not raw.turns:
        return []
    roads = _Roads(raw, segments, node_ids)
    read_tags = TagReader(bool)
    found: list[ForbiddenTurn] = []
    last = {relation: place for place, (relation, _, _) in enumerate(raw.turns)}
    for place, (relation, text, members) in enumerate(raw.turns):
        if last[relation] != place:
            continue
        counts["turn restrictions read"] += 1
        try:
            own = list(_turns(read_tags(text), members, roads))
            counts["turn restrictions obeyed"] += 1
            found += own
        except _BrokenError as broken:
            counts[f"turn restrictions ignored: {broken}"] += 1
    return found


class _Roads:
    """Segments by way and node."""

    def __init__(self, raw: RawMap, segments: Segments, node_ids: Index) -> None:
        self.segments, self.node_ids = segments, node_ids
        self._order = np.argsort(segments.way, kind="stable")
        self._ways = segments.way[self._order]
        self._position = {way: place for place, way in enumerate(raw.way_id.tolist())}

    def of(self, way: int) -> Index:
        """Return the segments of a way; none if it is not kept."""
        if way not in self._position:
            return self._order[:0]
        low, high = (
            np.searchsorted(self._ways, self._position[way], "left"),
            np.searchsorted(self._ways, self._position[way], "right"),
        )
        return self._order[low:high]

    def node(self, node: int) -> int:
        """Return the position of a node; -1 if no kept road passes it."""
        at = int(np.searchsorted(self.node_ids, node))
        return at if at < len(self.node_ids) and self.node_ids[at] == node else -1

    def arriving(self, way: int, node: int) -> list[int]:
        own = self.of(way)
        return [int(one) for one in own[self.segments.head[own] == node]]

    def leaving(self, way: int, node: int) -> list[int]:
        own = self.of(way)
        return [int(one) for one in own[self.segments.tail[own] == node]]

    def nodes(self, way: int) -> set[int]:
        own = self.of(way)
        return {*self.segments.tail[own].tolist(), *self.segments.head[own].tolist()}

    def along(self, way: int, begin: int, end: int) -> list[int] | None:
        """Return the segments of a way from one node to another; None if it is not driven so."""
        own = self.of(way)
        onward: dict[int, list[int]] = {}
        for one in own.tolist():
            onward.setdefault(int(self.segments.tail[one]), []).append(one)
        # In either direction along the way: never turning round on it.
        for step in (1, -1):
            path: list[int] = []
            node, place = begin, -1
            while node != end or not path:
                going = [
                    one
                    for one in onward.get(node, [])
                    if self._step(one) == step
                    and (place < 0 or self.segments.start[one] - place == step)
                ]
                if len(going) != 1:
                    break
                path.append(going[0])
                node, place = int(self.segments.head[going[0]]), int(self.segments.start[going[0]])
            if path and node == end:
                return path
        return None

    def _step(self, segment: int) -> int:
        return 1 if self.segments.forward[segment] else -1


def _turns(
    tags: Mapping[str, str], members: tuple[tuple[str, int, str], ...], roads: _Roads
) -> Iterator[ForbiddenTurn]:
    wanted = list(_asked(tags))
    if not wanted:
        raise _BrokenError("not about goods vehicles")
    for kind, layer in wanted:
        for path in _sequences(kind, members, roads):
            yield ForbiddenTurn(tuple(path), layer)


def _asked(tags: Mapping[str, str]) -> Iterator[tuple[str, Layer | None]]:
    """Yield each kind of turn that is forbidden or demanded, and whom it binds."""
    excepted = {
        part.strip().lower() for part in tags.get("except", "").replace(",", ";").split(";")
    }
    free = {key: "yes" for key in CHAIN if key in excepted}
    if any(key in tags for key in OLD):
        raise _BrokenError("hours of the old form")
    of_type = tags.get("type", "").partition(":")[2]
    for key, value in tags.items():
        head, *rest = key.split(":")
        if head != "restriction":
            continue
        conditional = bool(rest) and rest[-1] == CONDITIONAL[1:]
        whom = [part for part in rest if part != CONDITIONAL[1:]] or ([of_type] if of_type else [])
        if len(whom) > 1 or (whom and whom[0] in OTHERS):
            continue
        key_of = whom[0] if whom else "access"
        if key_of not in CHAIN:
            raise _BrokenError(f"for {key_of}")
        own = free if key_of == "access" else {}
        if conditional:
            turn, at, condition = value.partition("@")
            if not at or not condition.strip():
                raise _BrokenError("a condition that cannot be read")
            yield _kind(turn), {f"{key_of}{CONDITIONAL}": f"no @ {condition.strip()}", **own}
        else:
            binds_all = key_of in ("access", "vehicle", "motor_vehicle") and not own
            yield _kind(value), None if binds_all else {key_of: "no", **own}


def _kind(value: str) -> str:
    kind = value.strip().lower()
    if not kind.startswith(("no_", "only_")):
        raise _BrokenError(f"unknown kind {kind[:30]!r}")
    return kind


def _sequences(
    kind: str, members: tuple[tuple[str, int, str], ...], roads: _Roads
) -> Iterator[list[int]]:
    from_ways = [ref for what, ref, role in members if role == "from" and what == "w"]
    to_ways = [ref for what, ref, role in members if role == "to" and what == "w"]
    via = [(what, ref) for what, ref, role in members if role == "via"]
    if not from_ways or not to_ways or not via:
        raise _BrokenError("a member is missing")
    many = (kind == "no_entry", kind == "no_exit")
    if (len(from_ways) > 1 and not many[0]) or (len(to_ways) > 1 and not many[1]):
        raise _BrokenError("several members where one is allowed")
    ways = {*from_ways, *to_ways, *(ref for what, ref in via if what == "w")}
    if any(not len(roads.of(way)) for way in ways):
        raise _BrokenError("on roads that are not loaded")
    if all(what == "w" for what, _ in via):
        between = [ref for _, ref in via]
    elif len(via) == 1 and via[0][0] == "n":
        between = []
    else:
        raise _BrokenError("via is neither one node nor ways")
    for start in from_ways:
        for end in to_ways:
            if between:
                yield from _by_ways(kind, start, between, end, roads)
            else:
                yield from _by_node(kind, start, via[0][1], end, roads)


def _by_node(kind: str, start: int, via: int, end: int, roads: _Roads) -> Iterator[list[int]]:
    node = roads.node(via)
    arriving, leaving = roads.arriving(start, node), roads.leaving(end, node)
    if node < 0 or not arriving or not leaving:
        # One-way roads may make a turn impossible anyhow: then there is nothing to forbid.
        if node >= 0 and node in roads.nodes(start) and node in roads.nodes(end):
            return
        raise _BrokenError("its members do not touch")
    head, tail = roads.segments.head, roads.segments.tail
    if kind == "no_u_turn" and start == end:
        for one in arriving:
            for other in leaving:
                if head[other] == tail[one]:
                    yield [one, other]
        return
    if len(arriving) > 1 or len(leaving) > 1:
        raise _BrokenError("a way is not divided at the node")
    if kind.startswith("no_"):
        yield [arriving[0], leaving[0]]
        return
    for other in np.flatnonzero(tail == node).tolist():
        if other != leaving[0]:
            yield [arriving[0], other]


def _by_ways(
    kind: str, start: int, between: list[int], end: int, roads: _Roads
) -> Iterator[list[int]]:
    chain = [start, *between, end]
    joints = []
    for one, other in pairwise(chain):
        shared = roads.nodes(one) & roads.nodes(other)
        if not shared:
            raise _BrokenError("its members do not touch")
        joints.append(shared)
    found = [path for first in joints[0] for path in _walks(first, between, joints[1:], roads)]
    sequences = [
        [one, *path, other]
        for path in found
        for one in roads.arriving(start, int(roads.segments.tail[path[0]]))
        for other in roads.leaving(end, int(roads.segments.head[path[-1]]))
    ]
    if not sequences:
        return  # one-way roads make it impossible
    if len(sequences) > 1:
        raise _BrokenError("its members can be driven in several ways")
    (path,) = sequences
    if kind.startswith("no_"):
        yield path
        return
    tail, head = roads.segments.tail, roads.segments.head
    for place in range(1, len(path) - 1):
        # Who has begun it must go on to its end.
        for other in np.flatnonzero(tail == head[path[place]]).tolist():
            if other != path[place + 1]:
                yield [*path[: place + 1], other]


def _walks(
    node: int, ways: list[int], joints: list[set[int]], roads: _Roads
) -> Iterator[list[int]]:
    for end in joints[0]:
        path = roads.along(ways[0], node, end) if end != node else None
        if path is None:
            continue
        if len(ways) == 1:
            yield path
        else:
            for rest in _walks(end, ways[1:], joints[1:], roads):
                yield [*path, *rest]
