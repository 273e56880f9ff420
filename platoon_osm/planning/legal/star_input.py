"""A star in whole seconds: the driving times and costs of its members, and the master's way."""

from __future__ import annotations

from collections.abc import Collection
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ...network.placed import access_of
from ..cases import Case, running_sum, within_case
from ..star import Star
from ..timing.approach_times import times_along
from .legal_question import LegalQuestion
from .platoon.star_times import NEVER_S, StarTimes
from .way_points import WayPoints

__all__ = ["StarWay", "star_way"]

Floats = NDArray[np.float64]
Seconds = NDArray[np.int64]

HAIR_S = 1e-6


@dataclass(frozen=True, slots=True, eq=False)
class StarWay:
    """A star, its master's way, and both in whole seconds.

    Attributes
    ----------
    star : Star
        The master and its members.
    way : WayPoints
        The master's, at the pace of the slowest of all.
    first : int
        How many edges of the way lie before the star's route.
    times : StarTimes
        What the search needs.
    """

    star: Star
    way: WayPoints
    first: int
    times: StarTimes


def star_way(
    legal: LegalQuestion,
    star: Star,
    case: Case,
    among: Collection[int] | None = None,
    price: Floats | None = None,
) -> StarWay:
    """Return a star in whole seconds.

    Parameters
    ----------
    legal : LegalQuestion
        What is asked, with its law.
    star : Star
        A master and its members.
    case : {"A", "B", "C"}
        Which points are free.
    among : collection of int, optional
        The vehicles that may join; by default all.
    price : ndarray of float, (K,), optional
        What members are paid for company on each edge of the route, in place of what the master
        gains there, which then counts nothing.

    Returns
    -------
    StarWay
        Times that company has on the master's way are those of the slowest of all.
    """
    question = legal.question
    whole = star.alone[star.master]
    ways = access_of(question.net, whole)
    first = int(np.argmin(ways)) if len(star.route) else 0
    nodes_at = [first + k for k in range(len(star.route) + 1)]
    everyone = range(len(question.ends))
    way = legal.way(star.master, whole, everyone, nodes_at)
    node_at = np.array([way.index_of(at) for at in nodes_at], np.int64)
    entry, leave, solo = star.costs
    own = [question.ends[k] for k in star.members]
    entry, leave, _ = within_case(
        star.nodes, case, (entry, leave),
        np.array([item.origin for item in own], np.int64),
        np.array([item.destination for item in own], np.int64),
        [item.origins for item in own], [item.destinations for item in own],
    )  # fmt: skip
    # Dearer than alone, even if everything shared were free, is of no interest.
    paid = 0.0 if price is None else float(price.sum())
    entry = np.where(entry <= solo[:, None] + paid, entry, np.inf)
    leave = np.where(leave <= solo[:, None] + paid, leave, np.inf)
    if among is not None:
        entry[[member not in among for member in star.members]] = np.inf
    times = StarTimes(
        road=way.road,
        node_at=node_at,
        window=legal.spans[star.master],
        rules=legal.rules[star.master],
        approach_s=_times(legal, star, entry, forward=True),
        onward_s=_times(legal, star, leave, forward=False),
        entry=entry,
        leave=leave,
        platoon=_platoon(star, solo) - (0.0 if price is None else running_sum(price)),
        length_m=running_sum(question.net.length_m[star.route]),
        alone=solo,
        alone_s=np.array([int(legal.alone[k].way.road.drive_s.sum()) for k in star.members]),
        windows=tuple(legal.spans[k] for k in star.members),
        member_rules=tuple(legal.rules[k] for k in star.members),
        relief=question.problem.task_relief,
        master_alone=float(question.fleet[star.master].solo[whole].sum()),
        gain=star.gain if price is None else np.zeros(len(star.route)),
        monday_s=legal.monday_s,
    )
    return StarWay(star, way, first, times)


def _times(legal: LegalQuestion, star: Star, costs: Floats, forward: bool) -> Seconds:
    question = legal.question
    found = np.full(costs.shape, NEVER_S, np.int64)
    for row, member in enumerate(star.members):
        ends = question.ends[member]
        root = ends.origin if forward else ends.destination
        tree = question.trees[member].tree(root, forward)
        seconds = times_along(tree, question.fleet.drive_s((member,)))[star.nodes]
        open_at = np.isfinite(costs[row]) & np.isfinite(seconds)
        found[row, open_at] = np.ceil(seconds[open_at] - HAIR_S).astype(np.int64)
    return found


def _platoon(star: Star, solo: Floats) -> Floats:
    """Return what each member pays along the route; much where it is closed to it."""
    rows: list[Floats] = []
    known: dict[int, Floats] = {}
    for row, member in enumerate(star.members):
        closed = star.fleet.closed_on(member, star.route)
        kind = star.fleet.kind[member]
        if closed is not None:
            weight = star.fleet[member].platoon[star.route] + np.where(
                closed, 2 * solo[row] + 1.0, 0.0
            )
            rows.append(running_sum(weight))
            continue
        if kind not in known:
            known[kind] = running_sum(star.fleet[member].platoon[star.route])
        rows.append(known[kind])
    return np.array(rows).reshape(len(star.members), len(star.route) + 1)
