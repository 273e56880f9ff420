"""The bill of a plan: what each vehicle pays in money, term by term and to the cent.

Driving is paid as the shares of the stretches tell. Waiting and delay come on top, at the
objective's prices. A vehicle waits for as long as it stands for company, and under driving rules as
much longer as it stands on its way than it would alone; its delay is how much later it arrives than
alone, leaving as early as it may. Breaks and rests that it needs alone, too, cost nothing here.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import Protocol, runtime_checkable

import numpy as np

from ..costs.cost_figure import CostFigure
from ..costs.objective import Objective
from ..costs.tolls.table import toll_of
from ..driving.rules import places_pauses
from ..network.road_network import RoadNetwork
from ..plans.bill import CENTS, Bill, VehicleBill
from ..plans.plan import Plan
from ..plans.standing import standing

__all__ = ["Billed", "with_bill"]

TIME_TERMS = ("waiting", "delay")
"""What is paid besides driving."""


@runtime_checkable
class Billed(Objective, Protocol):
    """An objective whose costs are money."""

    @property
    def currency(self) -> str:
        """ISO 4217 code."""
        ...

    @property
    def terms(self) -> tuple[str, ...]:
        """What driving is paid for, in the order of all shares."""
        ...

    @property
    def kg_per_l(self) -> tuple[float, float]:
        """CO2e of a litre of fuel, tank to wheel and well to wheel [kg/l]."""
        ...

    def figures(self) -> tuple[CostFigure, ...]:
        """Return every figure with its unit and source.

        Returns
        -------
        tuple of CostFigure
            All there are.
        """
        ...

    def delay(self, seconds: float) -> float:
        """Return what it costs to arrive later than alone.

        Parameters
        ----------
        seconds : float
            How much later.

        Returns
        -------
        float
            Its cost.
        """
        ...


def with_bill(plan: Plan, objective: object, net: RoadNetwork) -> Plan:
    """Return a plan with its bill, if its costs are money.

    Parameters
    ----------
    plan : Plan
        Finished, with its times if there are any.
    objective : object
        What it was planned by.
    net : RoadNetwork
        Its network, without places between junctions.

    Returns
    -------
    Plan
        The same plan where costs are no money.
    """
    if not isinstance(objective, Billed):
        return plan
    figures = (*objective.figures(), *_toll_figures(plan, net, objective.currency))
    bill = Bill(
        objective.currency,
        (*objective.terms, *TIME_TERMS),
        tuple(_of_vehicle(plan, index, objective) for index in range(len(plan.trips))),
        figures,
    )
    return replace(plan, bill=bill)


def _of_vehicle(plan: Plan, index: int, objective: Billed) -> VehicleBill:
    alone = plan.trips[index].alone
    shares = [plan.stretches[k].share_of(index) for k in plan.ways[index]]
    driving = [sum(column) for column in zip(*(share.terms for share in shares), strict=True)]
    joint_l = sum(share.fuel_l for share in shares)
    waits, late = _time_s(plan, index)
    time = (objective.waiting(waits), objective.delay(late))
    return VehicleBill(
        (*_cents(alone.terms), *_cents([0.0] * len(TIME_TERMS))),
        (*_cents(driving), *_cents(time)),
        alone.fuel_l,
        joint_l,
        _kg(alone.fuel_l, objective),
        _kg(joint_l, objective),
    )


def _time_s(plan: Plan, index: int) -> tuple[float, float]:
    """Return how long a vehicle waits for others, and how much later it arrives than alone."""
    times, alone = plan.times[index], plan.trips[index].alone
    if times is None:
        return 0.0, 0.0
    assert plan.timetable is not None
    pauses = standing(times)
    company = sum(pause.duration_s for pause in pauses if "company" in pause.purposes)
    stands = sum(pause.duration_s for pause in pauses)
    ruled = places_pauses(plan.timetable.rules)
    waits = max(0.0, stands - alone.paused_s) if ruled else company
    if times.earliest_departure_s is None:
        return waits, 0.0
    takes = times.arrival_s - times.earliest_departure_s
    # Whoever stands for a ban would have to alone, too.
    needed = alone.paused_s if ruled else stands - company
    return waits, max(0.0, takes - alone.time_s - needed)


def _cents(amounts: Sequence[float]) -> tuple[int, ...]:
    return tuple(round(amount * CENTS) for amount in amounts)


def _kg(fuel_l: float, objective: Billed) -> tuple[float, float]:
    to_wheel, from_well = objective.kg_per_l
    return fuel_l * to_wheel, fuel_l * from_well


def _toll_figures(plan: Plan, net: RoadNetwork, currency: str) -> list[CostFigure]:
    """Return the rates of the countries that somebody drives through."""
    driven = {
        edge
        for edges in (
            *(stretch.edges for stretch in plan.stretches),
            *(trip.alone.edges for trip in plan.trips),
        )
        for edge in edges
    }
    codes = np.unique(net.country[np.array(sorted(driven), np.int64)]).tolist()
    found = []
    for name in (str(net.texts[code]) for code in codes):
        toll = toll_of(name)
        if toll is None or toll.rate is None or toll.currency != currency:
            continue
        source = f"{toll.source}, {toll.year} ({toll.page})"
        found.append(CostFigure(f"toll_{toll.code}", toll.rate, f"{currency}/km", source))
    return found
