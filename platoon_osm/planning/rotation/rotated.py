"""A finished plan in which the lead is handed on at junctions, so that each leads its fair share.

Who drives what with whom, all moments and all meetings stay; only the order changes in which the
vehicles of a company drive, and stretches are cut where it does. Vehicles alike share among them
what their company saves, so its sum does not depend on who leads, and what was proved of the plan
stands. Where each member pays least itself, nobody is made to pay more than alone by it: such a
vehicle is willing to lead a smaller part of its share, in the end nothing.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from ...network.placed import network_below
from ...network.road_network import RoadNetwork
from ...network.road_points import points_along
from ...plans.plan import Plan
from ...plans.records import PlatoonPoint
from ...plans.rotation import LeadChange, Rotation
from ...plans.standing import standing
from ...plans.text_table import listed
from ..fleet import Fleet
from ..timing.stops import Place
from .companies import companies_of
from .cutting import cut_with_times, pieces_of_cuts
from .order import Led, led_evenly
from .shares import in_order

__all__ = ["BEFORE_CHANGES", "LEAST_M", "LONGER_M", "with_rotated_lead"]

LEAST_M = 40_000.0
"""Nobody leads less before it hands on the lead, unless told otherwise: about half an hour [m]."""

LONGER_M = 20_000.0
"""The lead changes within an edge only if that is longer by this than a share [m]."""

BEFORE_CHANGES = "before the lead changes"

SAME = 1e-9
"""Sums of costs that differ by this share differ in their last digits."""

SPARED = 6
"""After so many steps towards leading less, a vehicle that still pays more than alone leads
nothing of its own will."""


def with_rotated_lead(
    plan: Plan,
    net: RoadNetwork,
    fleet: Fleet,
    least_m: float = LEAST_M,
    longer_m: float = LONGER_M,
) -> Plan:
    """Return a plan whose lead is handed on.

    Parameters
    ----------
    plan : Plan
        Any, with or without times.
    net : RoadNetwork
        The network with the places of its trips.
    fleet : Fleet
        What its edges cost each vehicle.
    least_m : float
        Nobody leads less before it hands on the lead [m].
    longer_m : float
        By how much an edge has to be longer than a share for a change within it [m].

    Returns
    -------
    Plan
        The same if nobody drives with anybody.
    """
    companies = companies_of(plan.stretches, plan.ways)
    if not companies:
        return plan
    below = network_below(net)
    willing = [1.0] * len(plan.trips)
    steps = [0] * len(plan.trips)
    before = [one.joint_cost for one in plan.vehicles]
    while True:
        led = led_evenly(below, plan.stretches, companies, willing, least_m, longer_m)
        found = _cut(plan, net, fleet, led)
        more = _made_to_pay(found, before) if plan.objective == "member" else {}
        again = {k: part for k, part in more.items() if willing[k] > 0}
        if not again:
            break
        for k, part in again.items():
            steps[k] += 1
            willing[k] = 0.0 if steps[k] > SPARED else willing[k] * part
    if more:
        # Whoever would have to lead against its will: better the order that was planned.
        return _told(plan, found, (), "the lead is not handed on")
    spared = tuple(k for k, part in enumerate(willing) if part < 1)
    rotation = Rotation(least_m, _changes(plan, found, below, led), led.fair_m, led.led_m, spared)
    return _told(plan, replace(found, rotation=rotation), spared, "lead less than their share")


def _made_to_pay(plan: Plan, before: Sequence[float]) -> dict[int, float]:
    """Return who pays more than alone, but did not, and what part of its leading is to stay."""
    found: dict[int, float] = {}
    for k, one in enumerate(plan.vehicles):
        slack = SAME * one.solo_cost
        if one.joint_cost > one.solo_cost + slack and before[k] <= one.solo_cost + slack:
            added = one.joint_cost - before[k]
            room = max(0.0, one.solo_cost - before[k])
            found[k] = min(0.95, room / added)
    return found


def _told(plan: Plan, found: Plan, spared: Sequence[int], what: str) -> Plan:
    """Return the rotated plan with what a reader should know of it."""
    if found.rotation is None:
        remark = f"{what}: somebody would pay more than alone, whoever leads less"
        return replace(plan, remarks=(*plan.remarks, remark))
    if spared:
        names = listed([plan.trips[k].vehicle for k in spared])
        remark = f"{what}, or they would pay more than alone: {names}"
        found = replace(found, remarks=(*found.remarks, remark))
    if abs(found.joint_cost - plan.joint_cost) > SAME * plan.joint_cost:
        conditions = (*found.proof.conditions, BEFORE_CHANGES)
        found = replace(found, proof=replace(found.proof, conditions=conditions))
    return found


def _cut(plan: Plan, net: RoadNetwork, fleet: Fleet, led: Led) -> Plan:
    cuts = _cuts(led)
    cut = cut_with_times(network_below(net), plan, cuts)
    orders = {
        piece: part.order
        for number, pieces in enumerate(pieces_of_cuts(len(plan.stretches), cuts))
        for piece, part in zip(pieces, led.parts.get(number, ()), strict=False)
    }
    stretches = tuple(
        in_order(net, fleet, stretch, orders[k]) if k in orders else stretch
        for k, stretch in enumerate(cut.stretches)
    )
    return replace(cut, stretches=stretches)


def _cuts(led: Led) -> dict[int, list[Place]]:
    cuts = {
        number: [part.cut for part in parts if part.cut is not None]
        for number, parts in led.parts.items()
    }
    return {number: own for number, own in cuts.items() if own}


def _changes(plan: Plan, found: Plan, net: RoadNetwork, led: Led) -> tuple[LeadChange, ...]:
    """Return where the lead is handed on, of a plan that is cut there."""
    pieces = pieces_of_cuts(len(plan.stretches), _cuts(led))
    changes = []
    for number, parts in sorted(led.parts.items()):
        for piece, part in zip(pieces[number], parts, strict=True):
            if part.former is not None:
                point = _point(found, net, piece)
                changes.append(LeadChange(piece, part.former, point))
    return tuple(changes)


def _point(plan: Plan, net: RoadNetwork, number: int) -> PlatoonPoint:
    """Return where a stretch begins, on the kilometres of who leads it."""
    stretch = plan.stretches[number]
    leader = stretch.vehicles[0]
    way = plan.ways[leader]
    leg = way.index(number)
    km = sum(plan.stretches[k].length_m for k in way[:leg]) / 1000
    edge, share = stretch.edges[0], stretch.span[0]
    node = int(net.tail[edge])
    name = _pause_there(plan, leader, leg) or net.place_name(node)
    if share == 0:
        lon, lat = float(net.lon[node]), float(net.lat[node])
        return PlatoonPoint(node, int(net.node_id[node]), lon, lat, name, km)
    (at,), _ = points_along(net.shape(edge), np.array([share]))
    return PlatoonPoint(-1, 0, float(at[0]), float(at[1]), name, km, edge, share)


def _pause_there(plan: Plan, vehicle: int, leg: int) -> str:
    """Return what people call the place where a vehicle stands before a leg; empty if nowhere."""
    times = plan.times[vehicle]
    if times is None:
        return ""
    places = [one.place for one in standing(times) if one.before == leg and one.place is not None]
    return next((place.name for place in places if place.name), "")
