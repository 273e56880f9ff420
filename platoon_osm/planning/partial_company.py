"""What vehicles pay on a stretch that not all of its planned company drive together.

A plan tells what each pays in the company as planned, and alone. Those who are left together keep
their order; each pays the share of its cost alone that its place in front, between others or at the
end has in the planned company. That is what it would pay there if vehicles are alike and a place is
worth the same in a smaller platoon.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from ..errors import ScenarioError
from ..plans.records import Stretch

__all__ = ["paid_on"]

Floats = NDArray[np.float64]
Labels = NDArray[np.int64]


def paid_on(stretch: Stretch, label: Labels) -> list[Floats | float]:
    """Return what each vehicle of a stretch pays.

    Parameters
    ----------
    stretch : Stretch
        Of a plan.
    label : ndarray of int, (k, runs)
        For each of its vehicles, in their order, with whom it drives: the same number for those who
        do so together.

    Returns
    -------
    list of (ndarray of float, (runs,)) or float, (k,)
        In the unit of the plan; one number where it is always the same.

    Raises
    ------
    ScenarioError
        A plan that does not tell what a stretch costs alone.
    """
    if not stretch.together:
        return [stretch.shares[0].cost]
    if (label == label[0]).all():
        return [share.cost for share in stretch.shares]
    size = len(stretch.vehicles)
    same = label[:, None, :] == label[None, :, :]
    count = same.sum(axis=1)
    ahead = np.stack([same[k, :k].sum(axis=0) for k in range(size)])
    ratios = _ratios(stretch)
    found: list[Floats | float] = []
    for k, share in enumerate(stretch.shares):
        alone = share.alone_cost
        assert alone is not None  # `_ratios` has seen to it
        place = np.where(ahead[k] == 0, 0, np.where(ahead[k] == count[k] - 1, 2, 1))
        paid = alone * ratios[place]
        paid = np.where(count[k] == 1, alone, paid)
        found.append(np.where(count[k] == size, share.cost, paid))
    return found


def _ratios(stretch: Stretch) -> Floats:
    """Return the share of its cost alone that who is in front, between and last pays."""
    found = []
    for share in (stretch.shares[0], stretch.shares[1], stretch.shares[-1]):
        if share.alone_cost is None:
            raise ScenarioError(
                "delays: the plan does not tell what its stretches cost alone; plan again"
            )
        found.append(share.cost / share.alone_cost if share.alone_cost else 1.0)
    return np.array(found)
