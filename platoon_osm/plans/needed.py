"""What records of a plan must hold, and what is said where they do not."""

from __future__ import annotations

import math
from collections.abc import Iterable

from ..errors import ScenarioError
from ..kinds import is_number

__all__ = ["all_finite", "need"]


def all_finite(values: Iterable[float]) -> bool:
    """Tell whether all values are numbers that are finite.

    Parameters
    ----------
    values : iterable of float
        Anything at all.

    Returns
    -------
    bool
        True if there are none.
    """
    for value in values:
        if type(value) is not float and not is_number(value):
            return False
        if not math.isfinite(value):
            return False
    return True


def need(holds: bool, what: str) -> None:
    """Refuse a plan in which something does not hold.

    Parameters
    ----------
    holds : bool
        Whether it does.
    what : str
        What is wrong if not.

    Raises
    ------
    ScenarioError
        It does not.
    """
    if not holds:
        raise ScenarioError(f"plan: {what}; it is damaged, plan again")
