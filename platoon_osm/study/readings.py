"""Readings of what an edge costs: how tau and xi mix, and which terms are added up.

Eq. 11 and 12 of the paper add distance, time and fuel; its conclusion says that it "evaluated
different cost formulations individually", and its surfaces end below what three terms allow. So a
reading is a mixing with a choice of terms. All of them are lengths times a factor: alone one metre
costs w, in a platoon p. Who joins whom where depends on p / w alone, for routes alone are the
shortest ones under every reading. So a draw is planned once for each different p / w, in units of
the study's first choice of terms, and what that costs under a reading is a multiple of it.
"""

from __future__ import annotations

import itertools
from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from ..costs.paper import Mixing, PaperCosts
from ..errors import ScenarioError, brief

__all__ = [
    "ALL_TERMS", "TERM_SUMS", "Factors", "Reading", "alone_per_metre", "check_terms",
    "factors_of",
]  # fmt: skip

Floats = NDArray[np.float64]
Index = NDArray[np.int64]

NAMES = ("distance", "time", "fuel")

ALL_TERMS = "+".join(NAMES)
"""The sum of eq. 11 and 12 as printed."""

TERM_SUMS = (ALL_TERMS, "distance+time", "distance+fuel", "distance", "time", "fuel")
"""What is compared: all terms, distance with one other, and each by itself."""

_KNOWN = tuple(
    "+".join(chosen) for size in (3, 2, 1) for chosen in itertools.combinations(NAMES, size)
)


@dataclass(frozen=True, slots=True)
class Reading:
    """One way to read eq. 11 and 12.

    Attributes
    ----------
    terms : str
        Which terms are added up, such as "distance+time".
    mixing : {"printed", "gain"}
        What tau and xi do.
    """

    terms: str
    mixing: Mixing


@dataclass(frozen=True, slots=True, eq=False)
class Factors:
    """What one metre costs in a platoon, X readings at P points: F different values in all.

    Attributes
    ----------
    different : ndarray of float, (F,)
        Platoon cost of one metre where alone it costs as much as under the first reading.
    at : ndarray of int, (X, P)
        Which of them belongs to a reading and a point.
    scale : ndarray of float, (X,)
        Cost alone of one metre over that of the first reading.
    """

    different: Floats
    at: Index
    scale: Floats


def check_terms(terms: object) -> None:
    """Check that a text names terms to add up.

    Parameters
    ----------
    terms : object
        Anything.

    Raises
    ------
    ScenarioError
        No such text.
    """
    if not isinstance(terms, str) or terms not in _KNOWN:
        raise ScenarioError(f"terms = {brief(terms)} must be one of {', '.join(_KNOWN)}")


def alone_per_metre(costs: PaperCosts, terms: str) -> float:
    """Return what a metre costs a vehicle alone.

    Parameters
    ----------
    costs : PaperCosts
        All parameters.
    terms : str
        Which terms are added up.

    Returns
    -------
    float
        Metre equivalents.
    """
    return sum(term.per_metre["alone"] for term in costs.terms() if term.name in terms.split("+"))


def factors_of(costs: PaperCosts, readings: Sequence[Reading], points: Floats) -> Factors:
    """Return what one metre costs under some readings at some points.

    Parameters
    ----------
    costs : PaperCosts
        All parameters but tau, xi and mixing.
    readings : sequence of Reading
        X of them.
    points : ndarray of float, (P, 2)
        tau and xi.

    Returns
    -------
    Factors
        For X readings and P points.
    """
    alone = np.array([alone_per_metre(costs, reading.terms) for reading in readings])
    together = np.empty((len(readings), len(points)))
    for mixing in {reading.mixing for reading in readings}:
        for p, (tau, xi) in enumerate(points):
            terms = replace(costs, tau=float(tau), xi=float(xi), mixing=mixing).terms()
            for x, reading in enumerate(readings):
                if reading.mixing == mixing:
                    chosen = reading.terms.split("+")
                    together[x, p] = sum(t.per_metre["member"] for t in terms if t.name in chosen)
    scale = alone / alone[0]
    different, at = np.unique(together / scale[:, None], return_inverse=True)
    return Factors(different, at.reshape(together.shape), scale)
