"""What vehicles pay, alone and as planned: by the plan's bill where it has one, else its costs.

A bill is whole cents, so what is printed adds up, and has waiting and delay in it.
"""

from __future__ import annotations

from collections.abc import Iterable

from .bill import CENTS
from .plan import Plan
from .vehicles import saved_share

__all__ = ["paid", "saved", "saved_part"]


def paid(plan: Plan, vehicles: Iterable[int] | None = None) -> tuple[float, float]:
    """Return what some vehicles pay.

    Parameters
    ----------
    plan : Plan
        Any.
    vehicles : iterable of int, optional
        Positions in the plan; by default all.

    Returns
    -------
    alone, joint : float
        Driving alone and as planned, in the plan's unit.
    """
    some = list(range(len(plan.trips)) if vehicles is None else vehicles)
    if plan.bill is None:
        own = [plan.vehicles[index] for index in some]
        return sum(one.solo_cost for one in own), sum(one.joint_cost for one in own)
    bills = [plan.bill.vehicles[index] for index in some]
    return (
        sum(sum(one.alone_cents) for one in bills) / CENTS,
        sum(sum(one.joint_cents) for one in bills) / CENTS,
    )


def saved(plan: Plan, vehicles: Iterable[int] | None = None) -> float:
    """Return what some vehicles save.

    Parameters
    ----------
    plan : Plan
        Any.
    vehicles : iterable of int, optional
        Positions in the plan; by default all.

    Returns
    -------
    float
        In the plan's unit; below 0 if they pay more.
    """
    alone, joint = paid(plan, vehicles)
    return alone - joint


def saved_part(plan: Plan, vehicles: Iterable[int] | None = None) -> float:
    """Return which share of what some vehicles pay alone they save.

    Parameters
    ----------
    plan : Plan
        Any.
    vehicles : iterable of int, optional
        Positions in the plan; by default all.

    Returns
    -------
    float
        0 if they pay nothing alone.
    """
    alone, joint = paid(plan, vehicles)
    return saved_share(joint, alone)
