"""Bill, shares and chances of a plan in rows: what is paid for what, who gets what, what may fail.

Amounts are in the bill's currency, which ends the names of their columns.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

from .bill import CENTS
from .plan import Plan

__all__ = ["MONEY_FRAMES", "bill_rows", "physical_rows"]

Row = dict[str, Any]


def bill_rows(plan: Plan) -> Iterator[tuple[str, str, int, int]]:
    """Yield what each vehicle pays for each term.

    Parameters
    ----------
    plan : Plan
        With a bill.

    Yields
    ------
    tuple of str, str, int and int
        Vehicle and term; cents alone and as planned.
    """
    assert plan.bill is not None
    for trip, one in zip(plan.trips, plan.bill.vehicles, strict=True):
        for term, alone, joint in zip(
            plan.bill.terms, one.alone_cents, one.joint_cents, strict=True
        ):
            yield trip.vehicle, term, alone, joint


def physical_rows(plan: Plan) -> Iterator[tuple[str, str, str, float, float]]:
    """Yield what each vehicle burns and emits.

    Parameters
    ----------
    plan : Plan
        With a bill.

    Yields
    ------
    tuple of str, str, str, float and float
        Vehicle, what and its unit; how much alone and as planned.
    """
    assert plan.bill is not None
    for trip, one in zip(plan.trips, plan.bill.vehicles, strict=True):
        who = trip.vehicle
        yield who, "fuel", "l", one.alone_fuel_l, one.joint_fuel_l
        for kind, name in enumerate(("CO2e tank to wheel", "CO2e well to wheel")):
            yield who, name, "kg", one.alone_kg[kind], one.joint_kg[kind]


def _bill(plan: Plan) -> Iterator[Row]:
    assert plan.bill is not None
    unit = plan.bill.currency
    for vehicle, term, alone, joint in bill_rows(plan):
        yield {
            "vehicle": vehicle,
            "term": term,
            f"alone_{unit}": alone / CENTS,
            f"joint_{unit}": joint / CENTS,
            f"saved_{unit}": (alone - joint) / CENTS,
        }


def _gain(plan: Plan) -> Iterator[Row]:
    assert plan.gain is not None
    unit = plan.gain.currency
    for trip, one in zip(plan.trips, plan.gain.vehicles, strict=True):
        yield {
            "vehicle": trip.vehicle,
            f"saved_{unit}": one.saved_cents / CENTS,
            f"receives_{unit}": one.payment_cents / CENTS,
            f"share_{unit}": one.share_cents / CENTS,
        }


def _chances(plan: Plan) -> Iterator[Row]:
    assert plan.chances is not None
    unit = "m_eq" if plan.unit == "m" else plan.unit
    for one in plan.chances.meetings:
        event = plan.events[one.event]
        movers, others = (
            ", ".join(plan.trips[who].vehicle for who in some)
            for some in (event.movers, event.others)
        )
        yield {
            "event": one.event,
            "point": event.point.name,
            "movers": movers,
            "others": others,
            "chance": one.chance,
            "mean_min": one.mean_s / 60,
            "spread_min": one.spread_s / 60,
            "expected_wait_min": one.expected_wait_s / 60,
            "wait_up_to_min": one.wait_up_to_s / 60,
            "movers_wait_up_to_min": one.movers_wait_up_to_s / 60,
            f"gain_{unit}": one.gain,
            f"missed_cost_{unit}": one.missed_cost,
            "missed_late_min": one.missed_late_s / 60,
        }


MONEY_FRAMES = {"bill": _bill, "gain": _gain, "chances": _chances}
"""By the field of a plan that each tells of."""
