"""Who is together, and what all pay: trucks that enter a lane at one instant are a company."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from .faults import FaultError
from .told import Told
from .whole_numbers import MOST

__all__ = ["Companies", "companies_of", "cost_of"]

Ints = NDArray[np.int64]


@dataclass(frozen=True, slots=True, eq=False)
class Companies:
    """The companies of all schedules.

    Attributes
    ----------
    of_entry : ndarray of int64, (E,)
        The company of each entry of a truck into a lane.
    lane, size : ndarray of int64, (C,)
        Lane and number of trucks of each.
    first, truck : ndarray of int64, (C + 1,), (E,)
        Its trucks, ascending.
    """

    of_entry: Ints
    lane: Ints
    size: Ints
    first: Ints
    truck: Ints

    def members(self, company: int) -> list[int]:
        """Return the trucks of a company.

        Parameters
        ----------
        company : int
            Its position.

        Returns
        -------
        list of int
            Ascending.
        """
        found: list[int] = self.truck[self.first[company] : self.first[company + 1]].tolist()
        return found


def companies_of(told: Told) -> Companies:
    """Return who is together in the schedules.

    Parameters
    ----------
    told : Told
        What the file says.

    Returns
    -------
    Companies
        By lane, then by instant.
    """
    truck = np.repeat(np.arange(told.trucks), np.diff(told.first))
    order = np.lexsort((truck, told.depart, told.lane))
    lane, depart = told.lane[order], told.depart[order]
    new = np.ones(len(order), bool)
    new[1:] = (lane[1:] != lane[:-1]) | (depart[1:] != depart[:-1])
    begins = np.flatnonzero(new)
    first = np.concatenate([begins, [len(order)]])
    of_entry = np.empty(len(order), np.int64)
    of_entry[order] = np.cumsum(new) - 1
    return Companies(of_entry, lane[begins], np.diff(first), first, truck[order])


def cost_of(told: Told, companies: Companies) -> int:
    """Return what the schedules cost.

    Parameters
    ----------
    told : Told
        What the file says.
    companies : Companies
        Who is together.

    Returns
    -------
    int
        Of all, waiting on the road among it [grains].

    Raises
    ------
    FaultError
        More than any plan could cost.
    """
    lane, n = companies.lane, companies.size
    if float((told.alone[told.lane].astype(np.float64)).sum()) > 16 * MOST:
        raise FaultError("the schedules cost more than whole numbers hold")
    alone, member, extra = told.alone[lane], told.member[lane], told.extra[lane]
    platoons = np.ones(len(n), np.int64) if told.largest == 0 else -(-n // told.largest)
    together = n * member + extra * platoons
    if told.largest == 2:
        # One of an odd company drives alone.
        together = np.where(n % 2 == 1, (n - 1) * member + (n // 2) * extra + alone, together)
    cost = int(np.where(n == 1, alone, together).sum())
    return cost + told.waiting * _waited(told)


def _waited(told: Told) -> int:
    """Return how long all wait on the road [ticks]."""
    gaps = told.depart[1:] - told.depart[:-1] - told.drive[told.lane[:-1]]
    truck = np.repeat(np.arange(told.trucks), np.diff(told.first))
    return int(gaps[truck[1:] == truck[:-1]].sum())
