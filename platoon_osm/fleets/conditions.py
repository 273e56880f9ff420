"""For which plans a fleet's bound holds, in plain words."""

from __future__ import annotations

import numpy as np

from ..costs.time_prices import TimePrices
from .lanes import TICK_S
from .limits import Limits
from .model import FleetModel

__all__ = ["conditions_of"]


def conditions_of(model: FleetModel, limits: Limits) -> tuple[str, ...]:
    """Return the conditions under which no plan saves more than the bound.

    Parameters
    ----------
    model : FleetModel
        The problem.
    limits : Limits
        What was allowed.

    Returns
    -------
    tuple of str
        One sentence each, without full stops.
    """
    instance = model.instance
    waiting = "waiting is free"
    if instance.waiting > 0:
        waiting = "waiting on the road has its price, and waiting before leaving has none"
    elif TimePrices.of(model.question.problem.objective).waiting > 0:
        waiting = "standing longer than alone has its price, and the bound takes it as free"
    found = [
        "each truck keeps its cheapest route alone"
        if instance.given
        else "all routes within the windows count, for every truck",
        "trucks are together on a road if they enter it at one instant",
        "all drive at their own speed, and nobody slows down for company",
        waiting,
    ]
    if instance.largest:
        found.append(f"no platoon has more than {instance.largest} vehicles")
    if len(np.unique(instance.kind)) > 1:
        found.append("only vehicles of one kind, and of one carrier if it is named, drive together")
    if limits.per_trip == "one":
        found.append("each trip joins one platoon at most, once, and a platoon does not stop")
        found.append("the certificate's bound is that of trips with many platoons")
    if model.legal is not None:
        found.append("the bound knows no breaks and rests: they are waits, and may be had anywhere")
    if limits.apart:
        found.append("the bound lets all drive together, also those that must not")
    if limits.together:
        found.append("the bound lets all drive alone, also those that must drive together")
    if limits.min_gain:
        found.append("the bound asks no least gain of a platoon")
    found.append(f"costs are rounded to {1 / model.lanes.grains:g}, and times to {TICK_S:g} s")
    return tuple(found)
