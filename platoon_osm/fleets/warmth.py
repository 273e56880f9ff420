"""The kernels of fleets, compiled before a search begins to count its time."""

from __future__ import annotations

import numpy as np

from .bound import warmth as bound
from .joining import Joining
from .lanes import Lanes
from .law import warmth as law_warmth
from .matching import matched_pairs
from .one_group import group_of
from .pairs import pair_offers
from .plan import warmth as plan
from .shifting import shifted
from .windows import Wanted, paired

__all__ = ["warm_up"]


def warm_up(law: bool = False, waits: bool = False) -> None:
    """Compile what is not compiled yet, by planning two trucks with a choice of roads.

    Parameters
    ----------
    law : bool
        Whether the searches within the law of driving hours are wanted, too.
    waits : bool
        Whether the bound's search for a price of waiting is wanted, too.
    """
    if law:
        law_warmth.warm_up()
    bound.warm_up()
    if waits:
        bound.warm_up(waiting=1)
    plan.warm_up()
    length, none = np.array([10, 10, 25]), np.zeros(2, np.int64)
    lanes = Lanes(
        nodes=np.arange(3), tail=np.array([0, 1, 0]), head=np.array([1, 2, 2]), drive=length,
        alone=10 * length, member=9 * length, extra=length, lane_kind=0 * length,
        first_edge=np.arange(4), edges=np.arange(3), kind=none, grains=1.0,
    )  # fmt: skip
    route = np.array([0, 1])
    wanted = Wanted(
        origin=none, destination=none + 2, earliest=np.arange(2),
        latest_departure=np.array([9, 10]), latest=np.array([40, 41]), alone=[route, route],
    )  # fmt: skip
    instance, _ = paired(lanes, wanted, given=False, largest=2)
    ways, departs, _ = matched_pairs(instance)
    shifted(instance, ways, departs)
    joining, offers = Joining(instance), pair_offers(instance)
    for one in offers:
        pair = (one.first, one.second)
        group = group_of(instance, joining.windows, pair, one.lanes, one.departs)
        if group is not None:
            joining.gains(group, [])
