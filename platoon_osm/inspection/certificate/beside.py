"""Whether the plan beside a certificate is the one that it speaks of.

The same vehicles, on the edges of the network that their lanes are made of, with the same
companions, at the same instants. What the plan says of saving and bound may be no better than what
is proved, but for rounding to grains.
"""

from __future__ import annotations

import itertools
from collections.abc import Sequence

import numpy as np

from ...errors import ScenarioError
from ...plans.plan import Plan
from ...plans.records import Stretch
from .companies import Companies
from .faults import FaultError
from .told import Told

__all__ = ["check_plan"]

NEAR_S = 2e-3
"""Instants of plan and schedules may differ by this: drives are rounded up to ticks."""


def check_plan(told: Told, companies: Companies, alone: int, cost: int, least: int) -> Plan:
    """Check that the plan is that of the schedules, and claims no more than is proved.

    Parameters
    ----------
    told : Told
        What the file says.
    companies : Companies
        Who is together in the schedules.
    alone, cost, least : int
        What all ways alone cost, what the plan costs, and what no plan undercuts [grains].

    Returns
    -------
    Plan
        The plan.

    Raises
    ------
    ScenarioError
        What stands there is no plan.
    FaultError
        It is the plan of something else, or claims more.
    """
    plan = Plan.from_dict(told.plan)
    names = tuple(trip.vehicle for trip in plan.trips)
    if names != told.vehicles:
        raise FaultError("the plan is one of other vehicles than the certificate's")
    if plan.timetable is None:
        raise FaultError("the plan has no timetable")
    shift_s = _shift(told, plan)
    for k in range(told.trucks):
        _check_edges(told, plan, k)
        _check_window(told, plan, k, shift_s)
        _check_times(told, plan, companies, k, shift_s)
    _check_claims(told, plan, alone, cost, least)
    return plan


def _shift(told: Told, plan: Plan) -> float:
    """Return by how much the timetable's clock is ahead: what most say of their first departure."""
    assert plan.timetable is not None
    starts = [
        int(told.depart[told.first[k]]) * told.tick_s - times.legs[0][0]
        for k, times in enumerate(plan.timetable.vehicles)
        if told.first[k] < told.first[k + 1]
    ]
    return float(np.median(starts)) if starts else 0.0


def _check_edges(told: Told, plan: Plan, k: int) -> None:
    """Check which roads a truck drives, as planned and alone."""
    planned: list[int] = []
    for stretch in (plan.stretches[one] for one in plan.ways[k]):
        planned += [-1] if stretch.access is not None else stretch.edges
    solo = plan.trips[k].alone
    to_road, from_road = ([-1] if line is not None else [] for line in solo.access)
    for what, lanes, edges in (
        ("its way", told.lane[told.first[k] : told.first[k + 1]], planned),
        (
            "its way alone", told.route[told.first_route[k] : told.first_route[k + 1]],
            [*to_road, *solo.edges, *from_road],
        ),
    ):  # fmt: skip
        if _joined(edges) != _joined(_edges_of(told, lanes.tolist())):
            raise FaultError(
                f"the plan has vehicle {told.vehicles[k]!r} drive other roads on {what}"
            )


def _edges_of(told: Told, lanes: Sequence[int]) -> list[int]:
    first = told.first_edge
    return [edge for one in lanes for edge in told.edge[first[one] : first[one + 1]].tolist()]


def _check_window(told: Told, plan: Plan, k: int, shift_s: float) -> None:
    """Check that a truck's window holds what its trip asked for: else the bound is too tight."""
    assert plan.timetable is not None
    times = plan.timetable.vehicles[k]
    earliest, departs, latest = (
        int(column[k]) * told.tick_s - shift_s
        for column in (told.earliest, told.latest_departure, told.latest)
    )
    for value, asked, sign in (
        (earliest, times.earliest_departure_s, 1),
        (departs, times.latest_departure_s, -1),
        (latest, times.latest_arrival_s, -1),
    ):
        if asked is not None and sign * (value - asked) > NEAR_S:
            raise FaultError(f"the window of vehicle {told.vehicles[k]!r} is tighter than asked")


def _joined(edges: Sequence[int]) -> list[int]:
    """Return edges with pieces of one, one after the other, told once."""
    return [edge for edge, _ in itertools.groupby(edges)]


def _check_times(told: Told, plan: Plan, companies: Companies, k: int, shift_s: float) -> None:
    """Check instants and companies of a truck, at the beginning of every lane and stretch."""
    assert plan.timetable is not None
    legs = plan.timetable.vehicles[k].legs
    stretches = [plan.stretches[one] for one in plan.ways[k]]
    entries = range(int(told.first[k]), int(told.first[k + 1]))
    if not entries or len(legs) != len(stretches):
        raise FaultError(f"the plan has no times of vehicle {told.vehicles[k]!r}")
    within_law = plan.timetable.rules not in ("", "none")
    # Each lane's drive was rounded up to a tick.
    slack_s = NEAR_S + told.tick_s * len(entries)
    ready = None
    stretch = 0
    begun = [leg[0] for leg in legs]
    for i in entries:
        lane, depart = int(told.lane[i]), int(told.depart[i])
        at_s = depart * told.tick_s - shift_s
        until_s = at_s + int(told.drive[lane]) * told.tick_s
        while stretch + 1 < len(legs) and begun[stretch + 1] <= at_s + NEAR_S:
            stretch += 1
        starts_here = abs(begun[stretch] - at_s) <= NEAR_S
        inside = begun[stretch] <= at_s + NEAR_S and depart == ready
        if not starts_here and not (inside and at_s <= legs[stretch][1] + NEAR_S):
            raise FaultError(f"the plan has vehicle {told.vehicles[k]!r} drive at other times")
        members = companies.members(int(companies.of_entry[i]))
        here = stretch
        while True:
            _check_company(told, stretches[here], members, k)
            if here + 1 == len(legs):
                break
            stands_s = begun[here + 1] - legs[here][1]
            unfinished = legs[here][1] < until_s - slack_s
            if unfinished and within_law:
                # Who stands at a parking within a lane waits, as if that was where the lane ends.
                until_s += stands_s
            elif not unfinished and begun[here + 1] >= until_s - NEAR_S:
                break
            elif stands_s > NEAR_S:
                raise FaultError(f"the plan has vehicle {told.vehicles[k]!r} wait within a lane")
            here += 1
        ready = depart + int(told.drive[lane])
    if stretch != len(legs) - 1 and here != len(legs) - 1:
        raise FaultError(f"the plan has vehicle {told.vehicles[k]!r} drive on after its schedule")
    if abs(legs[-1][1] - until_s) > slack_s:
        raise FaultError(f"the plan has vehicle {told.vehicles[k]!r} arrive at another time")


def _check_company(told: Told, stretch: Stretch, members: list[int], k: int) -> None:
    """Check who drives a stretch with a truck; a way beside the road is driven alone."""
    planned = stretch.company
    if stretch.access is not None:
        fits = planned == (k,)
    elif told.largest == 0 or len(members) <= told.largest:
        fits = planned == tuple(members)
    else:
        fits = len(planned) <= told.largest and set(planned) <= set(members) and k in planned
    if not fits:
        raise FaultError(f"the plan has vehicle {told.vehicles[k]!r} drive with others")


def _check_claims(told: Told, plan: Plan, alone: int, cost: int, least: int) -> None:
    """Check that the plan's own figures are no better than what is proved."""
    fleet = plan.fleet
    if fleet is None:
        raise ScenarioError("certificate: the plan says nothing of its fleet; plan it again")
    unit = float(told.grain)
    # Each lane's cost was rounded to a grain, of the plan's ways and of those alone.
    room = unit * (len(told.lane) + len(told.route) + 1) + 1e-9 * alone * unit
    if abs(fleet.alone_cost - alone * unit) > room:
        raise FaultError("the plan claims another cost of driving alone")
    if fleet.saving > (alone - cost) * unit + room:
        raise FaultError("the plan claims to save more than its schedules do")
    if fleet.bound < (alone - least) * unit - room:
        raise FaultError("the plan claims a bound that is not proved")
    if (fleet.max_platoon or 0) != told.largest or (fleet.routes == "given") != told.given:
        raise FaultError("the plan is one of other platoons or routes than the certificate")
