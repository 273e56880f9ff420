"""What a fleet file says: the problem, shares and schedules in whole numbers, and the claims.

Here is looked at whether it says something at all: sizes, types, ranges, orders. Whether it is true
is for others.
"""

from __future__ import annotations

import json
import os
from collections.abc import Mapping
from dataclasses import dataclass
from decimal import Decimal, InvalidOperation
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...errors import ScenarioError, brief
from ...kinds import is_number
from .whole_numbers import MOST, as_column, column, flag, part, starts_of, whole

__all__ = ["Told", "read_told", "told_of"]

Ints = NDArray[np.int64]

FORMAT, VERSION = "platoon-osm fleet", 1

MOST_TRUCKS = 10_000_000
MOST_ROUNDS = 1_000


@dataclass(frozen=True, slots=True, eq=False)
class Told:
    """A fleet file, as docs/fleet.schema.json describes it.

    Attributes
    ----------
    tick_s : float
        A tick [s].
    grain : Decimal
        A grain, in the unit of the plan's costs.
    nodes : int
        Number of nodes.
    tail, head, drive, alone, member, extra, lane_kind : ndarray of int64, (L,)
        The lanes.
    origin, destination, earliest, latest_departure, latest, kind : ndarray of int64, (N,)
        The trucks.
    vehicles : tuple of str, (N,)
        Their names.
    largest : int
        Vehicles of the largest platoon; 0 for any.
    given : bool
        Whether each truck keeps its way alone.
    waiting : int
        Price of waiting on the road [grains a tick].
    rounds : int
        Rounds of dropping pairs.
    first_route, route : ndarray of int64, (N + 1,), (R,)
        Lanes of each truck's way alone.
    lane_first, starts : ndarray of int64, (L + 1,), (B,)
        Buckets of each lane [ticks].
    share_truck, share_lane, first_bucket : ndarray of int64, (K,)
        Who has shares, on which lane, and from which bucket on.
    first_share, share : ndarray of int64, (K + 1,), (S,)
        Their shares, bucket by bucket [grains].
    first, lane, depart : ndarray of int64, (N + 1,), (E,), (E,)
        Schedules: lanes and the instants at which they are entered [ticks].
    first_edge, edge : ndarray of int64, (L + 1,), (M,)
        Edges of the network that each lane is made of.
    claims : mapping of str to int
        alone, cost and bound [grains].
    plan : object
        The plan beside it.
    """

    tick_s: float
    grain: Decimal
    nodes: int
    tail: Ints
    head: Ints
    drive: Ints
    alone: Ints
    member: Ints
    extra: Ints
    lane_kind: Ints
    origin: Ints
    destination: Ints
    earliest: Ints
    latest_departure: Ints
    latest: Ints
    kind: Ints
    vehicles: tuple[str, ...]
    largest: int
    given: bool
    waiting: int
    rounds: int
    first_route: Ints
    route: Ints
    lane_first: Ints
    starts: Ints
    share_truck: Ints
    share_lane: Ints
    first_bucket: Ints
    first_share: Ints
    share: Ints
    first: Ints
    lane: Ints
    depart: Ints
    first_edge: Ints
    edge: Ints
    claims: Mapping[str, int]
    plan: Any

    @property
    def trucks(self) -> int:
        """How many trucks there are."""
        return len(self.origin)

    @property
    def lanes(self) -> int:
        """How many lanes there are."""
        return len(self.tail)

    @property
    def leader_saves(self) -> Ints:
        """What the leader of a platoon saves on each lane [grains]."""
        return self.alone - self.member - self.extra


def read_told(path: str | os.PathLike[str]) -> Told:
    """Read a fleet file.

    Parameters
    ----------
    path : str or path
        Of the file.

    Returns
    -------
    Told
        What it says.

    Raises
    ------
    ScenarioError
        It cannot be read, is no JSON, or says nothing that could be checked; in one line.
    """
    file = brief(path) if not isinstance(path, str | os.PathLike) else path
    try:
        data = json.loads(Path(path).read_bytes())
    except OSError as error:
        raise ScenarioError(f"{file}: cannot be read ({error.strerror})") from error
    except (TypeError, ValueError, RecursionError):
        raise ScenarioError(f"{file}: is no JSON file; write it with platoon-osm fleet") from None
    try:
        return told_of(data)
    except ScenarioError as error:
        raise ScenarioError(f"{file}: {error}") from None


def told_of(data: object) -> Told:
    """Return what plain JSON types say.

    Parameters
    ----------
    data : object
        As docs/fleet.schema.json describes it, or anything else.

    Returns
    -------
    Told
        What they say.

    Raises
    ------
    ScenarioError
        They say nothing that could be checked; in one line.
    """
    if not isinstance(data, dict) or data.get("format") != FORMAT:
        raise ScenarioError(f'is no fleet file; its "format" must be "{FORMAT}"')
    if data.get("version") != VERSION:
        raise ScenarioError(
            f"is of version {brief(data.get('version'))}; this platoon-osm checks {VERSION}"
        )
    told = part(data, "certificate")
    nodes = whole(told, "nodes", 0, MOST_TRUCKS)
    tail = column(told, "tail", None, 0, nodes - 1)
    lanes = len(tail)
    head = column(told, "head", lanes, 0, nodes - 1)
    origin = column(told, "origin", None, 0, nodes - 1)
    trucks = len(origin)
    if not 0 < trucks <= MOST_TRUCKS:
        raise ScenarioError("certificate: origin names no truck; there must be one at least")
    drive = column(told, "drive", lanes, 1)
    money = {name: column(told, name, lanes, 0) for name in ("alone", "member", "extra")}
    kinds = column(told, "lane_kind", lanes, 0, MOST_TRUCKS)
    _check_costs(**money)
    first_route, route = _routes(told, trucks, lanes)
    sums = (drive, money["alone"], money["alone"][route])
    if any(float(own.sum(dtype=np.float64)) > MOST for own in sums):
        raise ScenarioError(
            f"certificate: times or costs of all lanes, or of all ways alone, are above {MOST}; "
            "use coarser ticks or grains"
        )
    windows = {
        name: column(told, name, trucks) for name in ("earliest", "latest_departure", "latest")
    }
    waiting = whole(told, "waiting", 0, MOST)
    if waiting * int(windows["latest"].max() - windows["earliest"].min()) > MOST:
        raise ScenarioError(f"certificate: waiting all the time costs more than {MOST}")
    largest = whole(told, "largest", 0, MOST_TRUCKS)
    if largest == 1:
        raise ScenarioError("certificate: largest is 1; it must be 0 for any, or 2 and more")
    return Told(
        tick_s=_tick(told), grain=_grain(told), nodes=nodes, tail=tail, head=head, drive=drive,
        **money, lane_kind=kinds, origin=origin,
        destination=column(told, "destination", trucks, 0, nodes - 1),
        **windows,
        kind=column(told, "kind", trucks, 0, MOST_TRUCKS), vehicles=_names(told, trucks),
        largest=largest, given=flag(told, "given"), waiting=waiting,
        rounds=whole(told, "rounds", 0, MOST_ROUNDS), first_route=first_route, route=route,
        **_shares(told, trucks, lanes), **_schedules(told, trucks, lanes),
        **_edges(told, lanes),
        claims={name: whole(part(told, "claims"), name, 0) for name in ("alone", "cost", "bound")},
        plan=part(data, "plan"),
    )  # fmt: skip


def _check_costs(alone: Ints, member: Ints, extra: Ints) -> None:
    leader = alone - member - extra
    if (leader < 0).any() or (leader > member).any():
        lane = int(np.flatnonzero((leader < 0) | (leader > member))[0])
        raise ScenarioError(
            f"certificate: on lane {lane} a platoon costs more than driving alone, or its leader "
            "saves more than half; the bound is not proved for such costs"
        )


def _tick(told: Mapping[str, Any]) -> float:
    value = told.get("tick_s")
    if not is_number(value) or not 0 < value < 1e6:
        raise ScenarioError(f"certificate: tick_s is {brief(value)}; it must be seconds above 0")
    return float(value)


def _grain(told: Mapping[str, Any]) -> Decimal:
    value = told.get("grain")
    try:
        grain = Decimal(value) if isinstance(value, str) else Decimal(0)
    except InvalidOperation:
        grain = Decimal(0)
    if not grain.is_finite() or not Decimal("1e-30") < grain < Decimal("1e30"):
        raise ScenarioError(
            f"certificate: grain is {brief(value)}; it must be a decimal number above 0, as text"
        )
    return grain


def _names(told: Mapping[str, Any], trucks: int) -> tuple[str, ...]:
    value = told.get("vehicles")
    if not isinstance(value, list) or len(value) != trucks or set(map(type, value)) - {str}:
        raise ScenarioError(f"certificate: vehicles must be the names of all {trucks:,} trucks")
    if len(set(value)) != trucks:
        raise ScenarioError("certificate: two of vehicles have one name; each must have its own")
    return tuple(value)


def _routes(told: Mapping[str, Any], trucks: int, lanes: int) -> tuple[Ints, Ints]:
    value = told.get("routes")
    if not isinstance(value, list) or len(value) != trucks:
        raise ScenarioError(f"certificate: routes must be the ways alone of all {trucks:,} trucks")
    rows = [as_column(row, f"route {k}", None, 0, lanes - 1) for k, row in enumerate(value)]
    first = np.concatenate([[0], np.cumsum([len(row) for row in rows])]).astype(np.int64)
    return first, np.concatenate([*rows, np.zeros(0, np.int64)])


def _shares(told: Mapping[str, Any], trucks: int, lanes: int) -> dict[str, Ints]:
    own = part(told, "shares")
    starts = column(own, "starts")
    lane_first = starts_of(own, "lane_first", lanes, len(starts))
    inner = np.ones(len(starts), bool)
    inner[lane_first[:-1][lane_first[:-1] < len(starts)]] = False
    if (np.diff(starts)[inner[1:]] <= 0).any():
        raise ScenarioError("certificate: starts of a lane's buckets must rise")
    truck = column(own, "truck", None, 0, trucks - 1)
    lane = column(own, "lane", len(truck), 0, lanes - 1)
    key = truck * np.int64(lanes) + lane
    if len(np.unique(key)) < len(key):
        raise ScenarioError("certificate: some truck's shares on a lane are listed twice")
    share = column(own, "share")
    return {
        "lane_first": lane_first, "starts": starts, "share_truck": truck, "share_lane": lane,
        "first_bucket": column(own, "first_bucket", len(truck), 0, max(0, len(starts) - 1)),
        "first_share": starts_of(own, "first_share", len(truck), len(share)), "share": share,
    }  # fmt: skip


def _schedules(told: Mapping[str, Any], trucks: int, lanes: int) -> dict[str, Ints]:
    own = part(told, "schedules")
    lane = column(own, "lane", None, 0, lanes - 1)
    depart = column(own, "depart", len(lane))
    return {
        "first": starts_of(own, "first", trucks, len(lane)), "lane": lane, "depart": depart,
    }  # fmt: skip


def _edges(told: Mapping[str, Any], lanes: int) -> dict[str, Ints]:
    own = part(told, "lane_edges")
    edge = column(own, "edge", None, -1)
    return {"first_edge": starts_of(own, "first", lanes, len(edge)), "edge": edge}
