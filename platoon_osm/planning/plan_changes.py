"""What one plan has otherwise than another of the same trips, vehicle by vehicle.

Of each vehicle the most telling is said: that it drives in company and did not, or no longer does;
with whom; where it merges and separates; else that it takes another road, or leaves at another
time.
"""

from __future__ import annotations

from collections.abc import Iterator

from ..plans.plan import Plan
from ..plans.plan_change import Change
from ..plans.vehicles import VehiclePlan

__all__ = ["changes", "in_company", "leaders"]


def changes(plan: Plan, before: Plan) -> tuple[Change, ...]:
    """Return what a plan has otherwise than another.

    Parameters
    ----------
    plan, before : Plan
        Of the same trips.

    Returns
    -------
    tuple of Change
        Empty if nobody could tell them apart.
    """
    return tuple(_changes(plan, before))


def in_company(plan: Plan) -> tuple[str, ...]:
    """Return who drives in company anywhere.

    Parameters
    ----------
    plan : Plan
        Any.

    Returns
    -------
    tuple of str
        Names, in the order of the trips.
    """
    some = {vehicle for one in plan.stretches if one.together for vehicle in one.vehicles}
    return tuple(plan.trips[vehicle].vehicle for vehicle in sorted(some))


def leaders(plan: Plan) -> tuple[str, ...]:
    """Return who leads anywhere.

    Parameters
    ----------
    plan : Plan
        Any.

    Returns
    -------
    tuple of str
        Names, in the order of the trips.
    """
    some = {one.vehicles[0] for one in plan.stretches if one.together}
    return tuple(plan.trips[vehicle].vehicle for vehicle in sorted(some))


def _changes(plan: Plan, before: Plan) -> Iterator[Change]:
    lead, led = leaders(plan), leaders(before)
    if lead and led and lead != led:
        yield Change("leads", "", lead, led)
    # Of whoever comes or goes that is said once, not again of those who drive with it.
    moved = frozenset(in_company(plan)) ^ frozenset(in_company(before))
    for index, (now, then) in enumerate(zip(plan.vehicles, before.vehicles, strict=True)):
        told = False
        for change in _of_vehicle(now, then, moved):
            told = True
            yield change
        if told:
            continue
        at, was = _leaves(plan, index), _leaves(before, index)
        if at != was:
            yield Change("leaves", now.vehicle, (at,), (was,))


def _leaves(plan: Plan, vehicle: int) -> str:
    """Return when a vehicle leaves, to the minute; empty without times."""
    times = plan.times[vehicle]
    if times is None or plan.timetable is None:
        return ""
    return plan.timetable.clock.text(times.departure_s)


def _of_vehicle(now: VehiclePlan, then: VehiclePlan, moved: frozenset[str]) -> Iterator[Change]:
    name = now.vehicle
    partners, others = _partners(now), _partners(then)
    if partners and not others:
        yield Change("joins", name, partners)
        return
    if others and not partners:
        yield Change("alone", name)
        return
    if (set(partners) ^ set(others)) - moved:
        yield Change("company", name, partners, others)
    elsewhere = False
    for kind in ("merge", "separation"):
        point, was = getattr(now, kind), getattr(then, kind)
        if point is not None and was is not None and point.name != was.name:
            elsewhere = True
            yield Change(kind, name, (point.name,), (was.name,))
    if not elsewhere and partners == others and now.edges != then.edges:
        yield Change("road", name)


def _partners(vehicle: VehiclePlan) -> tuple[str, ...]:
    return tuple(sorted({name for leg in vehicle.legs for name in leg.partners}))
