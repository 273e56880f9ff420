"""What a driver does if those who are to be met do not come: until when to wait, and what then.

With R the driving time of the rest of the way [s], its planned breaks and rests among it, and a the
latest arrival asked for, a vehicle that leaves a meeting point by a - R is there in time. For a
trip without a latest arrival, a is as late as the planner's patience let company make it. A plan
with delays says how long waiting is worth it at each merge, counted from when the vehicle is there
by the timetable; the sooner of these moments is told, but none before the planned one. What is not
in the plan is not made up: if that is not known either there is no such moment, unless the caller
names a patience.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

from ...network.road_network import RoadNetwork
from ...plans.plan import Plan
from ...plans.standing import asked_by_rules, standing
from ...plans.timetable import VehicleTimes
from ..document.roads import roads_of

__all__ = ["GoingOn", "going_on"]


@dataclass(frozen=True, slots=True)
class GoingOn:
    """How a vehicle goes on without those it was to meet.

    Attributes
    ----------
    until_s : float or None
        When it leaves at the latest; None if neither a latest arrival nor a patience is known.
    by_patience : bool
        Whether that is as long as a patience goes, the caller's or the planner's, or as waiting is
        worth it; else it is as long as the latest arrival allows.
    arrives_s : float or None
        When it is there if it leaves then, or else as planned; None without times.
    roads : str
        Road numbers to the destination.
    length_m, drive_s : float
        From here to the destination.
    with_others : bool
        Whether some of its company are with it already.
    """

    until_s: float | None
    by_patience: bool
    arrives_s: float | None
    roads: str
    length_m: float
    drive_s: float
    with_others: bool


def going_on(
    plan: Plan, net: RoadNetwork, index: int, number: int, patience_s: float | None
) -> GoingOn:
    """Return how a vehicle goes on from where one of its stretches begins.

    Its way is the planned one, for the plan holds no other from there; at the origin it is the
    route that it would drive alone.

    Parameters
    ----------
    plan : Plan
        Laid out in whole edges.
    net : RoadNetwork
        The network it is laid out on.
    index : int
        Position of the vehicle in the plan.
    number : int
        Of the stretch in its way, from 0.
    patience_s : float or None
        How long after the planned moment to wait at most [s].

    Returns
    -------
    GoingOn
        Until when it waits, and how it drives then.
    """
    way = plan.ways[index]
    with_others = number > 0 and plan.stretches[way[number - 1]].together
    rest = [plan.stretches[k] for k in way[number:]]
    if number == 0:
        alone = plan.trips[index].alone
        edges, length_m, drive_s = list(alone.edges), alone.length_m, alone.time_s
    else:
        edges = [edge for one in rest if one.access is None for edge in one.edges]
        length_m, drive_s = sum(one.length_m for one in rest), sum(one.drive_s for one in rest)
    times = plan.times[index]
    if times is None:
        return GoingOn(None, False, None, roads_of(net, edges), length_m, drive_s, with_others)
    planned, latest = times.legs[number][0], times.latest_arrival_s
    # What driving rules ask for on the way on is taken in any case.
    later = (one for one in times.pauses if one.before > number and asked_by_rules(one))
    rest_s = drive_s + sum(one.duration_s for one in later)
    in_time = None if latest is None else latest - rest_s
    patient = None if patience_s is None else planned + patience_s
    if latest is None and plan.timetable is not None:
        alone_s = plan.trips[index].alone.time_s
        allowed = plan.timetable.patient_until_s(index, alone_s)
        if allowed is not None:
            patient = min(allowed - rest_s, math.inf if patient is None else patient)
    gives_up = _gives_up_s(plan, index, number, planned)
    if gives_up is not None:
        patient = gives_up if patient is None else min(patient, gives_up)
    limits = [limit for limit in (in_time, patient) if limit is not None]
    # Who would be late anyway waits no longer than planned.
    until = max(min(limits), planned) if limits else None
    leaves = planned if until is None else until
    return GoingOn(
        until_s=until,
        by_patience=until is not None and until == patient,
        arrives_s=max(leaves + rest_s, _after_bans_s(times, number) if number else 0.0),
        roads=roads_of(net, edges),
        length_m=length_m,
        drive_s=drive_s,
        with_others=with_others,
    )


def _gives_up_s(plan: Plan, index: int, number: int, planned_s: float) -> float | None:
    """Return until when waiting is worth it by the plan's chances; None where they do not say."""
    times = plan.times[index]
    if plan.chances is None or times is None:
        return None
    waits = (one for one in standing(times) if one.before == number)
    there_s = planned_s - sum(one.duration_s for one in waits if one.purposes == ("company",))
    for meeting in plan.chances.meetings:
        event = plan.events[meeting.event]
        if event.stretch == plan.ways[index][number]:
            moves = index in event.movers and bool(event.others)
            return there_s + (meeting.movers_wait_up_to_s if moves else meeting.wait_up_to_s)
    return None


def _after_bans_s(times: VehicleTimes, number: int) -> float:
    """Return before when no vehicle is there that goes on with a leg, for bans on its way [s].

    From the end of a ban on it drives and rests as planned.
    """
    found = -math.inf
    for leg in range(number, len(times.legs)):
        for pause in times.pauses:
            if pause.before == leg > number:
                found += pause.duration_s if asked_by_rules(pause) else 0.0
                found = max(found, pause.end_s if "ban" in pause.purposes else found)
        found += times.legs[leg][1] - times.legs[leg][0]
    return found
