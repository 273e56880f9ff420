"""The best schedule of a truck on its one way.

The labels of a node, sorted by time, are merged into those of the next. Those that cannot beat the
truck's present schedule are left out, by the least that the way onward could cost.
"""

from __future__ import annotations

from .desk import Desk, Plan, Taste, traced
from .entries import entries
from .occupancy import Costs, Occupancy
from .pairs_used import Prices, Used

__all__ = ["along"]


def along(
    k: int, upper: float, used: Used, prices: Prices, costs: Costs, lanes: Occupancy, plan: Plan,
    taste: Taste, work: Desk,
) -> int:  # fmt: skip
    """Write the response of a truck whose pairs are one way.

    Parameters
    ----------
    k, upper, used, prices, costs, lanes, plan, taste, work : int, float, tuples of arrays
        As of `respond`.

    Returns
    -------
    int
        How many lanes it has; -1 if nothing costs less.
    """
    first, count = used.first[k], used.first[k + 1] - used.first[k]
    rest = work.rest
    # Pairs lie in reverse order in `onward`: rest[i] is the least behind the i-th of them.
    rest[0] = 0.0
    for i in range(count):
        rest[i + 1] = rest[i] + work.low[used.onward[first + i] - first]
    if rest[count] >= upper:
        return -1
    work.time[0], work.cost[0], work.parent[0] = used.earliest[k], 0.0, -1
    begin, end = 0, 1
    for i in range(count - 1, -1, -1):
        made = entries(
            k, used.onward[first + i], begin, end, end, rest[i], upper, used, prices, costs,
            lanes, plan, taste, work,
        )  # fmt: skip
        if made == end:
            return -1
        begin, end = end, made
    return traced(end - 1, used, work)
