"""What a whole fleet's plan comes to, in a few lines; a table of thousands of rows says less."""

from __future__ import annotations

from collections import Counter

from .convoys import convoys_of
from .fleet import ENDED
from .plan import Plan

__all__ = ["fleet_lines"]


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
    platoons = len(convoys_of(plan))
    largest = max((len(stretch.vehicles) for stretch in plan.stretches), default=1)
    driven = sum(stretch.length_m * len(stretch.vehicles) for stretch in plan.stretches)
    share = plan.platoon_m / driven if driven else 0.0
    lines = [
        f"{len(plan.trips):,} trips, {len(together):,} of them in "
        f"{platoons:,} platoon{'s' * (platoons != 1)} of up to {largest} for "
        f"{share:.1%} of all {driven / 1000:,.0f} km",
        f"Saves {record.saving:,.1f} {plan.unit} of {record.alone_cost:,.1f}, "
        f"{record.saved_share:.2%}; no plan saves more than {record.bound:,.1f}",
        f"Gap: {record.gap:.3%} of the savings; ended after {record.seconds:.1f} s, for "
        f"{ENDED[record.ended]}",
    ]
    if record.unserved:
        # Reasons begin with the row or the place that they are about; a few words tell them apart.
        count = Counter(one.reason.rpartition(": ")[2].partition(";")[0] for one in record.unserved)
        first, times = count.most_common(1)[0]
        lines.append(
            f"Trips that could not be planned: {len(record.unserved):,}, "
            f"{times:,} of them as: {first}"
        )
    return lines
