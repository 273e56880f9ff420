"""What is proved of a plan where a vehicle's place in its company decides what it saves.

Members choose by one weight, the dearer of a place between first and last and of the last place,
for how many will drive together is not known then. So nobody pays more than was planned. What all
really pay is told by the shares. It is at least q times what was planned, q being the least ratio
of a real weight to the planned one, so q times a bound on planned costs is a bound on real ones.
"""

from __future__ import annotations

from collections.abc import Sequence

from ..plans.proof import Proof
from ..plans.records import Stretch
from .fleet import Fleet

__all__ = ["proved_by_position"]

ANY_PLACES = "whatever the places in a company"


def proved_by_position(proof: Proof, fleet: Fleet, stretches: Sequence[Stretch]) -> Proof:
    """Return what is proved of what vehicles really pay.

    Parameters
    ----------
    proof : Proof
        Of the costs that were planned with.
    fleet : Fleet
        What edges cost each vehicle.
    stretches : sequence of Stretch
        Of the plan, with what each vehicle really pays.

    Returns
    -------
    Proof
        The same where places do not matter, or where nothing was proved.
    """
    least = fleet.least_by_position()
    if least == 1 or proof.bound is None:
        return proof
    cost = sum(share.cost for stretch in stretches for share in stretch.shares)
    any_plan = None if proof.any_plan is None else proof.any_plan * least
    return Proof.of(cost, proof.bound * least, (*proof.conditions, ANY_PLACES), any_plan)
