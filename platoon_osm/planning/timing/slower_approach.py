"""Who has to leave early and waits at its merging point may as well drive there slower.

Departures are shifted first, and who has to leave by some time waits where it merges. The way there
can be driven slower within the range of trucks instead: fuel follows speed (`costs/speed_fuel.py`).
The plan's times and costs stay as they are, for paper costs know no speeds; a remark tells what is
saved.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace

import numpy as np

from ...costs.speed_fuel import SpeedFuel
from ...network.road_network import RoadNetwork
from ...plans.clock import MENTIONED_S
from ...plans.plan import Plan
from ...vehicles.profile import Vehicle

__all__ = ["SlowerApproach", "slower_approaches", "with_slower_approaches"]

LEAST_L = 0.1
"""Less fuel than this is not worth a remark [l]."""


@dataclass(frozen=True, slots=True)
class SlowerApproach:
    """A way alone that may be driven slower, for its end is a wait for company.

    Attributes
    ----------
    vehicle : int
        Position in the plan.
    leg : int
        Position in its way.
    speed_kmh, usual_kmh : float
        The highest speeds driven [km/h].
    wait_s, longer_s : float
        How long it would wait, and how much longer it drives instead [s].
    saved_l : float
        Fuel saved [l].
    """

    vehicle: int
    leg: int
    speed_kmh: float
    usual_kmh: float
    wait_s: float
    longer_s: float
    saved_l: float


def slower_approaches(
    plan: Plan, net: RoadNetwork, vehicles: Sequence[Vehicle], fuel: SpeedFuel | None = None
) -> Iterator[SlowerApproach]:
    """Yield the ways alone that may be driven slower, each at the speed that saves most.

    Parameters
    ----------
    plan : Plan
        Nothing is yielded for one without times.
    net : RoadNetwork
        The network whose edges it names.
    vehicles : sequence of Vehicle, (N,)
        What drives each trip.
    fuel : SpeedFuel, optional
        How fuel follows speed.

    Yields
    ------
    SlowerApproach
        Exact on whole km/h: the most fuel saved, and still there in time.
    """
    known = fuel or SpeedFuel()
    for index, (one, times) in enumerate(zip(plan.vehicles, plan.times, strict=True)):
        if times is None:
            continue
        for leg in range(1, len(one.legs)):
            before, wait = plan.stretches[plan.ways[index][leg - 1]], times.waits[leg]
            after = plan.stretches[plan.ways[index][leg]]
            alone = len(before.vehicles) == 1 and len(after.vehicles) > 1
            if not alone or not before.edges or wait < MENTIONED_S or times.pauses:
                continue
            edges = np.asarray(before.edges, np.int64)
            length, speed = net.length_m[edges], net.speed_mps[edges]
            # Cut edges and the vehicle's own pace: the stretch has its own length and time.
            length = length * (one.legs[leg - 1].length_m / float(length.sum()))
            speed = speed * (float((length / speed).sum()) / before.drive_s)
            kmh, longer, saved = known.slowest_in_time(length, speed, wait, vehicles[index])
            litres = saved * one.legs[leg - 1].fuel_l
            if litres >= LEAST_L:
                yield SlowerApproach(
                    index, leg - 1, kmh, float(speed.max()) * 3.6, wait, longer, litres
                )


def with_slower_approaches(plan: Plan, net: RoadNetwork, vehicles: Sequence[Vehicle]) -> Plan:
    """Return a plan that remarks who may drive slower in place of waiting.

    Parameters
    ----------
    plan : Plan
        Any.
    net : RoadNetwork
        The network whose edges it names.
    vehicles : sequence of Vehicle, (N,)
        What drives each trip.

    Returns
    -------
    Plan
        The same routes, times and costs.
    """
    remarks = []
    for found in slower_approaches(plan, net, vehicles):
        one = plan.vehicles[found.vehicle]
        where = one.merge.name if one.merge is not None else "where it merges"
        remarks.append(
            f"{one.vehicle} may drive at {found.speed_kmh:.0f} km/h instead of "
            f"{found.usual_kmh:.0f} to {where}: it then waits "
            f"{(found.wait_s - found.longer_s) / 60:.0f} min instead of {found.wait_s / 60:.0f} "
            f"and saves {found.saved_l:.1f} litres, which the "
            "plan's cost does not count"
        )
    return replace(plan, remarks=(*plan.remarks, *remarks)) if remarks else plan
