"""What proves a fleet's plan: its problem, shares and schedules in whole numbers.

`docs/certificate.md` tells how to check it by hand, `inspection.certificate` checks it without
anything that planned it.
"""

from __future__ import annotations

import os
from collections.abc import Sequence
from decimal import Decimal
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..network.placed import PlacedNetwork
from ..plans.json_file import write_json_file
from ..plans.plan import Plan
from .bound.shares import Shares
from .lanes import TICK_S
from .model import FleetModel

__all__ = ["FORMAT", "VERSION", "certificate_of", "write_fleet"]

FORMAT, VERSION = "platoon-osm fleet", 1

Ints = NDArray[np.int64]


def certificate_of(
    model: FleetModel,
    shares: Shares,
    lanes: Sequence[Ints],
    departs: Sequence[Ints],
    cost: int,
    bound: int,
) -> dict[str, Any]:
    """Return the certificate of a plan as plain JSON types.

    Parameters
    ----------
    model : FleetModel
        The problem.
    shares : Shares
        In whole grains.
    lanes, departs : sequence of ndarray of int64, (N, ...)
        The lanes of each truck in driving order, and when it enters them [ticks].
    cost : int
        What the plan costs [grains].
    bound : int
        What no plan undercuts [grains].

    Returns
    -------
    dict
        As docs/fleet.schema.json describes it.
    """
    instance, roads = model.instance, model.lanes
    names = [trip.vehicle for trip in model.question.problem.trips]
    pairs = shares.pairs
    return {
        "tick_s": TICK_S,
        "grain": f"{1 / Decimal(roads.grains):f}",
        "nodes": instance.nodes,
        **{
            name: _list(getattr(instance, name))
            for name in (
                "tail", "head", "drive", "alone", "member", "extra", "lane_kind", "origin",
                "destination", "earliest", "latest_departure", "latest", "kind",
            )
        },
        "vehicles": names,
        "largest": instance.largest,
        "given": instance.given,
        "waiting": instance.waiting,
        "routes": [_list(route) for route in model.routes],
        "rounds": model.rounds,
        "shares": {
            "lane_first": _list(shares.lane_first),
            "starts": _list(shares.starts),
            "truck": _list(instance.pair_truck[pairs]),
            "lane": _list(instance.pair_lane[pairs]),
            "first_bucket": _list(shares.first_bucket),
            "first_share": _list(shares.first_share),
            "share": _list(shares.share),
        },
        "schedules": {
            "first": [0, *np.cumsum([len(own) for own in lanes]).tolist()],
            "lane": _list(np.concatenate(lanes)),
            "depart": _list(np.concatenate(departs)),
        },
        "lane_edges": {"first": _list(roads.first_edge), "edge": _list(_below(model, roads.edges))},
        "claims": {
            "alone": int(instance.alone_cost.sum()), "cost": int(cost), "bound": int(bound),
        },
    }  # fmt: skip


def write_fleet(plan: Plan, certificate: dict[str, Any], path: str | os.PathLike[str]) -> None:
    """Write a fleet's plan with its certificate as JSON, whole or not at all.

    Parameters
    ----------
    plan : Plan
        The plan.
    certificate : dict
        As `certificate_of` returns it.
    path : str or path
        Of the file; missing folders are made.

    Raises
    ------
    ScenarioError
        The file cannot be written.
    """
    whole = {
        "format": FORMAT, "version": VERSION, "plan": plan.to_dict(), "certificate": certificate,
    }  # fmt: skip
    write_json_file(whole, path, compact=True)


def _list(array: Ints | NDArray[np.float64]) -> list[int]:
    found: list[int] = np.asarray(array, np.int64).tolist()
    return found


def _below(model: FleetModel, edges: Ints) -> Ints:
    """Return of which edges of the network below lanes are made; -1 for ways beside the road."""
    net = model.question.net
    if isinstance(net, PlacedNetwork) and net.below is not None:
        found: Ints = net.below_edge[edges]
        return found
    return edges
