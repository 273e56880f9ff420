"""The best schedule of a truck through its network.

Labels are taken from a heap in order of time, so of those at a node a later one counts only if it
is cheaper than all before. Those that cannot beat the truck's present schedule are left out, by the
least that the way onward could cost.
"""

from __future__ import annotations

from .desk import Desk, Plan, Taste, traced
from .entering import FAR
from .entries import TIE, entries
from .heap import popped, pushed
from .occupancy import Costs, Occupancy
from .onward import UNREACHED, least_onward
from .pairs_used import Prices, Used

__all__ = ["across"]


def across(
    k: int, upper: float, used: Used, prices: Prices, costs: Costs, lanes: Occupancy, plan: Plan,
    taste: Taste, work: Desk,
) -> int:  # fmt: skip
    """Write the response of a truck with a choice of ways.

    Parameters
    ----------
    k, upper, used, prices, costs, lanes, plan, taste, work : int, float, tuples of arrays
        As of `respond`.

    Returns
    -------
    int
        How many lanes it has; -1 if nothing costs less.
    """
    first, spot0 = used.first[k], used.first_spot[k]
    rest, cheapest = work.rest, work.popped
    least_onward(k, used, work)
    for s in range(used.first_spot[k + 1] - spot0):
        cheapest[s] = FAR
    goal, start = used.to_spot[k] - spot0, used.from_spot[k] - spot0
    if rest[start] >= upper:
        return -1
    work.time[0], work.cost[0], work.parent[0] = used.earliest[k], 0.0, -1
    work.spot[0] = start
    made, best = 1, -1
    size = pushed(work.heap_time, work.heap, 0, work.time[0], 0)
    while size > 0:
        x = work.heap[0]
        size = popped(work.heap_time, work.heap, size)
        s, cost = work.spot[x], work.cost[x]
        if cost >= cheapest[s] - TIE:
            continue
        cheapest[s] = cost
        if s == goal:
            if cost < upper:
                upper, best = cost, x
            continue
        if cost + rest[s] >= upper:
            continue
        for p in range(used.spot_first[s + spot0], used.spot_first[s + spot0 + 1]):
            v = used.head[p] - spot0
            if cost + work.low[p - first] + rest[v] >= upper or rest[v] >= UNREACHED:
                continue
            end = entries(
                k, p, x, x + 1, made, rest[v], min(upper, cheapest[v] + rest[v]), used, prices,
                costs, lanes, plan, taste, work,
            )  # fmt: skip
            for y in range(made, end):
                work.spot[y] = v
                size = pushed(work.heap_time, work.heap, size, work.time[y], y)
            made = end
    return traced(best, used, work) if best >= 0 else -1
