"""The best schedule of one truck against what all others do, where waiting costs nothing.

Where a truck's pairs are one way, the labels of a node are merged into those of the next (`along`);
in a network they are taken from a heap (`across`). `waiting` does the same where waiting has a
price.
"""

from __future__ import annotations

from . import entering
from .across import across
from .along import along
from .desk import Desk, Plan, Taste, traced
from .entering import least_prices
from .entries import entries
from .heap import popped, pushed
from .occupancy import Costs, Occupancy
from .onward import least_onward
from .pairs_used import Prices, Used

__all__ = ["HELPERS", "respond"]


def respond(
    k: int,
    upper: float,
    used: Used,
    prices: Prices,
    costs: Costs,
    lanes: Occupancy,
    plan: Plan,
    taste: Taste,
    work: Desk,
) -> int:
    """Write the cheapest schedule of a truck against what others do.

    Parameters
    ----------
    k : int
        The truck, which is taken out.
    upper : float
        Only what costs less counts [grains].
    used, prices, costs, lanes, plan : Used, Prices, Costs, Occupancy, Plan
        The problem, and what others do.
    taste : Taste
        How it guesses.
    work : Desk
        With the factors of `flavoured`; gets the answer.

    Returns
    -------
    int
        How many lanes it has; -1 if nothing costs less.
    """
    least_prices(k, used, prices, lanes, taste, work)
    if used.chain[k]:
        return along(k, upper, used, prices, costs, lanes, plan, taste, work)
    return across(k, upper, used, prices, costs, lanes, plan, taste, work)


HELPERS = (
    *entering.HELPERS, entries, traced, pushed, popped, least_onward, along, across, respond,
)  # fmt: skip
