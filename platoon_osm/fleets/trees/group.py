"""A few trucks of a fleet, with lanes and nodes numbered on their own.

What the others of the fleet do may be told: then a company that enters a lane when some of them do
pays what theirs costs more with it.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from ...errors import ScenarioError
from ..instance import Instance

__all__ = ["MOST_TRUCKS", "Group", "grouped"]

Ints = NDArray[np.int64]

MOST_TRUCKS = 8
"""Trucks of one tree at most; each more takes three times as long."""


class Group(NamedTuple):
    """Some k trucks, V nodes and L lanes that any of them may drive.

    Attributes
    ----------
    origin, destination, earliest, latest, alone_cost : ndarray of int64, (k,)
        Of each truck: nodes, window [ticks], and what it pays alone [grains].
    tail, head, drive, alone, member, extra : ndarray of int64, (L,)
        As of `Instance`, with nodes of the group.
    largest : int
        Vehicles of the largest platoon; 0 for any.
    opens, closes : ndarray of int64, (k, L)
        When each truck may enter each lane [ticks]; closes before it opens if never.
    out_first, out_lane, in_first, in_lane : ndarray of int64
        Lanes out of each node and into it.
    at_first, at, others : ndarray of int64
        When others enter each lane, ascending, and how many they are.
    """

    origin: Ints
    destination: Ints
    earliest: Ints
    latest: Ints
    alone_cost: Ints
    tail: Ints
    head: Ints
    drive: Ints
    alone: Ints
    member: Ints
    extra: Ints
    largest: int
    opens: Ints
    closes: Ints
    out_first: Ints
    out_lane: Ints
    in_first: Ints
    in_lane: Ints
    at_first: Ints
    at: Ints
    others: Ints


def grouped(
    instance: Instance,
    trucks: Sequence[int],
    companies: tuple[Ints, Ints, Ints] | None = None,
    most: int = MOST_TRUCKS,
) -> tuple[Group, Ints]:
    """Return some trucks of a fleet as a group.

    Parameters
    ----------
    instance : Instance
        The problem; waiting must be free.
    trucks : sequence of int
        Some of its trucks, each once.
    companies : tuple of ndarray of int64, optional
        Lane, instant and size of the companies of all other trucks, sorted by lane, then instant.
    most : int
        How many trucks there may be.

    Returns
    -------
    group : Group
        They.
    lanes : ndarray of int64, (L,)
        The instance's lane of each.

    Raises
    ------
    ScenarioError
        Too many trucks, none, one twice, or a price of waiting.
    """
    own = np.array(trucks, np.int64)
    if not 1 <= len(own) <= most or len(np.unique(own)) < len(own):
        raise ScenarioError(
            f"fleet: 1 to {most} trucks are planned as one group, each named once; {len(own)} are "
            "named"
        )
    if own.min() < 0 or own.max() >= instance.trucks:
        raise ScenarioError(
            f"fleet: a group names a truck that is none of the {instance.trucks}; name those only"
        )
    if instance.waiting:
        raise ScenarioError(
            "fleet: merge trees are planned with free waiting; give waiting no price"
        )
    pairs = [np.arange(*instance.first_pair[k : k + 2]) for k in own.tolist()]
    lanes = np.unique(np.concatenate([instance.pair_lane[some] for some in pairs]))
    nodes = np.unique(
        np.concatenate(
            [instance.tail[lanes], instance.head[lanes], instance.origin[own],
             instance.destination[own]]
        )
    )  # fmt: skip
    opens = np.zeros((len(own), len(lanes)), np.int64)
    closes = np.full((len(own), len(lanes)), -1, np.int64)
    for row, some in enumerate(pairs):
        place = np.searchsorted(lanes, instance.pair_lane[some])
        opens[row, place], closes[row, place] = instance.opens[some], instance.closes[some]
    # A window that never was must stay closed where instants are below zero too.
    opens[closes < opens] = 0
    closes[closes < opens] = -1
    tail = np.searchsorted(nodes, instance.tail[lanes])
    head = np.searchsorted(nodes, instance.head[lanes])
    every = np.arange(len(nodes) + 1)
    out_lane, in_lane = np.argsort(tail, kind="stable"), np.argsort(head, kind="stable")
    at_first, at, others = _beside(lanes, companies)
    group = Group(
        origin=np.searchsorted(nodes, instance.origin[own]),
        destination=np.searchsorted(nodes, instance.destination[own]),
        earliest=instance.earliest[own], latest=instance.latest[own],
        alone_cost=instance.alone_cost[own],
        tail=tail, head=head, drive=instance.drive[lanes], alone=instance.alone[lanes],
        member=instance.member[lanes], extra=instance.extra[lanes], largest=instance.largest,
        opens=opens, closes=closes,
        out_first=np.searchsorted(tail[out_lane], every), out_lane=out_lane,
        in_first=np.searchsorted(head[in_lane], every), in_lane=in_lane,
        at_first=at_first, at=at, others=others,
    )  # fmt: skip
    return group, lanes


def _beside(lanes: Ints, companies: tuple[Ints, Ints, Ints] | None) -> tuple[Ints, Ints, Ints]:
    """Return when others enter some lanes."""
    if companies is None:
        none = np.zeros(0, np.int64)
        return np.zeros(len(lanes) + 1, np.int64), none, none
    lane, at, size = companies
    begin = np.searchsorted(lane, lanes)
    end = np.searchsorted(lane, lanes, side="right")
    first = np.concatenate([[0], np.cumsum(end - begin)]).astype(np.int64)
    pick = np.repeat(begin - first[:-1], end - begin) + np.arange(first[-1])
    return first, at[pick], size[pick]
