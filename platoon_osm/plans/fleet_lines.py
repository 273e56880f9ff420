"""What a whole fleet's plan comes to, in a few lines; a table of thousands of rows says less."""

from __future__ import annotations

from collections import Counter

from ..shown_text import fitted
from .convoys import Convoy, convoys_of
from .cost_decimals import cost_decimals
from .fleet import ENDED
from .plan import Plan
from .text_table import listed

__all__ = ["fleet_lines"]

UNITS = {"m": "km-equivalents"}
"""Units of plans that are printed otherwise."""

MOST_CONVOYS = 3
"""Platoons that are told one by one."""


def fleet_lines(plan: Plan) -> list[str]:
    """Return what a fleet's plan saves, how much more could be saved, and how it was found.

    Parameters
    ----------
    plan : Plan
        One with a `fleet`.

    Returns
    -------
    list of str
        A line each.
    """
    record = plan.fleet
    assert record is not None
    together = {one for stretch in plan.stretches if stretch.together for one in stretch.vehicles}
    convoys = convoys_of(plan)
    platoons = len(convoys)
    largest = max((len(stretch.vehicles) for stretch in plan.stretches), default=1)
    driven = sum(stretch.length_m * len(stretch.vehicles) for stretch in plan.stretches)
    share = plan.platoon_m / driven if driven else 0.0
    lines = [
        f"{len(plan.trips):,} trips, {len(together):,} of them in "
        f"{platoons:,} platoon{'s' * (platoons != 1)} of up to {largest} for "
        f"{share:.1%} of all {driven / 1000:,.0f} km",
        f"Saves {_cost(plan, record.saving)} {UNITS.get(plan.unit, fitted(plan.unit))} of "
        f"{_cost(plan, record.alone_cost)}, {record.saved_share:.2%}; "
        f"no plan saves more than {_cost(plan, record.most)}",
        f"Gap: {record.gap:.3%} of the savings; ended after {record.seconds:.1f} s, for "
        f"{ENDED[record.ended]}",
    ]
    if platoons > MOST_CONVOYS:
        # Two vehicles that meet once are many; what is told is where most is driven in company.
        longest = sorted(convoys, key=lambda one: (-one.vehicle_m, one.vehicles))[:MOST_CONVOYS]
        lines.append("Platoons with most vehicle-km:")
        lines += [f"  {_convoy(plan, one)}" for one in longest]
    if record.unserved:
        # Reasons begin with the row or the place that they are about; a few words tell them apart.
        count = Counter(one.reason.rpartition(": ")[2].partition(";")[0] for one in record.unserved)
        first, times = count.most_common(1)[0]
        lines.append(
            f"Trips that could not be planned: {len(record.unserved):,}, "
            f"{times:,} of them as: {first}"
        )
    return lines


def _cost(plan: Plan, cost: float) -> str:
    """Return a cost as other texts print it: metre-equivalents as km, one decimal of small sums."""
    assert plan.fleet is not None
    if plan.unit == "m":
        return f"{cost / 1000:,.{cost_decimals('m', plan.fleet.alone_cost)}f}"
    return f"{cost:,.1f}"


def _convoy(plan: Plan, one: Convoy) -> str:
    told = f"{one.vehicle_m / 1000:,.0f} vehicle-km"
    if one.forms and one.parts:
        told += f" from {fitted(one.forms)} to {fitted(one.parts)}"
    if plan.timetable is not None and one.begins_s is not None and one.ends_s is not None:
        clock = plan.timetable.clock
        told += f", {clock.text(one.begins_s)} to {clock.text(one.ends_s)}"
    return f"{told}: {listed([plan.trips[vehicle].vehicle for vehicle in one.vehicles])}"
