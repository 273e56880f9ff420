"""A plan to begin with for few trucks: the best one by merge trees."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from ..instance import Instance
from .group import MOST_TRUCKS
from .merge_trees import merge_tree

__all__ = ["tree_start"]

Ints = NDArray[np.int64]


def tree_start(instance: Instance) -> tuple[list[Ints], list[Ints]] | None:
    """Return the best plan of a small fleet by merge trees.

    Parameters
    ----------
    instance : Instance
        The problem.

    Returns
    -------
    lanes, departs : list of ndarray of int64, (N, ...)
        Lanes of each truck in driving order, and when it enters them [ticks]; None in their place
        where there are too many trucks, or waiting has a price.
    """
    if instance.waiting or not 1 <= instance.trucks <= MOST_TRUCKS:
        return None
    tree = merge_tree(instance, range(instance.trucks))
    return list(tree.lanes), list(tree.departs)
