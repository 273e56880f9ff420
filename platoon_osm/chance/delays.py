"""How late vehicles may be: a spread for each, and how far two of them are late together.

Each vehicle has one delay, which it has where it first meets another and keeps from then on. The
spread is the standard deviation of that delay, whatever way was driven before. It is

- "normal": with mean 0, so a vehicle is as often early as late by the timetable;
- "lognormal": exp(m + q Z) with Z standard normal, so nobody is early, most are a little late and
  a few by much; q is `shape`, and m is such that the standard deviation is the spread.

Delays of two vehicles have a correlation, one for all pairs or its own for some (trucks in one jam
arrive alike): cov = correlation * spread_A * spread_B. Under "lognormal" it is that of the
logarithms. Whoever meets first in a platoon is late as the platoon from then on.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from itertools import combinations
from typing import Literal, get_args

import numpy as np
from numpy.typing import NDArray

from ..errors import ScenarioError, brief
from ..kinds import is_number, kind_of

__all__ = ["MOST_MIN", "Delays", "Kind", "factor"]

Kind = Literal["normal", "lognormal"]
Floats = NDArray[np.float64]

MOST_MIN = 24 * 60.0
"""Whose delays spread over more than a day names them in another unit by mistake [min]."""

ROUNDING = 1e-9
"""Pivots this near to 0 are 0 but for the last digits of sums."""


@dataclass(frozen=True, slots=True)
class Delays:
    """How late the vehicles of a plan may be.

    Attributes
    ----------
    spread_min : float
        Standard deviation of a vehicle's delay [min].
    own : mapping of str to float
        Those of some vehicles by name [min].
    correlation : float
        Of the delays of any two vehicles, from -1 to 1.
    pairs : mapping of (str, str) to float
        Those of some pairs by their names.
    kind : {"normal", "lognormal"}
        How delays are distributed; see the module's text.
    shape : float
        Standard deviation of the logarithm of a delay that is lognormal.

    Raises
    ------
    ScenarioError
        A spread that is negative or beyond a day, a correlation outside [-1, 1], an unknown kind.
    """

    spread_min: float
    own: Mapping[str, float] = field(default_factory=dict)
    correlation: float = 0.0
    pairs: Mapping[tuple[str, str], float] = field(default_factory=dict)
    kind: Kind = "normal"
    shape: float = 1.0

    def __post_init__(self) -> None:
        _check_spread("spread_min", self.spread_min)
        _check_correlation("correlation", self.correlation)
        if not isinstance(self.kind, str) or self.kind not in get_args(Kind):
            raise ScenarioError(
                f"delays: kind {brief(self.kind)} is unknown; use {', '.join(get_args(Kind))}"
            )
        if not (is_number(self.shape) and 0.05 <= self.shape <= 3):
            raise ScenarioError(
                f"delays: shape is {brief(self.shape)}; give a number from 0.05 to 3"
            )
        for label in ("own", "pairs"):
            if not isinstance(getattr(self, label), Mapping):
                raise ScenarioError(
                    f"delays: {label} is a {kind_of(getattr(self, label))}; give a mapping"
                )
        for name, spread in self.own.items():
            if not isinstance(name, str):
                raise ScenarioError(f"delays: own names {brief(name)}; give names of vehicles")
            _check_spread(f"spread of {brief(name)}", spread)
        settled: dict[tuple[str, str], float] = {}
        for pair, value in self.pairs.items():
            if not _is_pair(pair):
                raise ScenarioError(
                    f"delays: pairs names {brief(pair)}; give two names of vehicles"
                )
            _check_correlation(f"correlation of {pair[0]!r} and {pair[1]!r}", value)
            key = (min(pair), max(pair))
            if settled.setdefault(key, float(value)) != value:
                raise ScenarioError(
                    f"delays: pairs has two values for {pair[0]!r} and {pair[1]!r}; give one"
                )
        object.__setattr__(self, "own", {name: float(own) for name, own in self.own.items()})
        object.__setattr__(self, "pairs", settled)

    def spread_s(self, name: str) -> float:
        """Return the standard deviation of a vehicle's delay.

        Parameters
        ----------
        name : str
            Of the vehicle.

        Returns
        -------
        float
            Seconds.
        """
        return 60.0 * self.own.get(name, self.spread_min)

    def correlation_of(self, one: str, other: str) -> float:
        """Return how far two vehicles are late together.

        Parameters
        ----------
        one, other : str
            Names of two vehicles.

        Returns
        -------
        float
            From -1 to 1.
        """
        return self.pairs.get((min(one, other), max(one, other)), self.correlation)

    def correlations(self, names: Sequence[str]) -> Floats:
        """Return the correlations of some vehicles.

        Parameters
        ----------
        names : sequence of str, (N,)
            Their names, no two alike.

        Returns
        -------
        ndarray of float, (N, N)
            Symmetric, 1 on the diagonal.
        """
        found = np.full((len(names), len(names)), self.correlation)
        np.fill_diagonal(found, 1.0)
        if self.pairs:
            for (i, one), (j, other) in combinations(enumerate(names), 2):
                found[i, j] = found[j, i] = self.correlation_of(one, other)
        return found

    def median_s(self, name: str) -> float:
        """Return the median of a vehicle's delay.

        Parameters
        ----------
        name : str
            Of the vehicle.

        Returns
        -------
        float
            Seconds; 0 for a normal one.
        """
        if self.kind == "normal":
            return 0.0
        grown = math.exp(self.shape**2)
        return self.spread_s(name) / math.sqrt(grown * (grown - 1))

    def draws(self, names: Sequence[str], runs: int, seed: int) -> Floats:
        """Return delays drawn at random.

        Parameters
        ----------
        names : sequence of str, (N,)
            The vehicles.
        runs : int
            How many draws.
        seed : int
            Of numpy's generator; the same gives the same draws.

        Returns
        -------
        ndarray of float, (runs, N)
            Seconds.

        Raises
        ------
        ScenarioError
            Correlations that no delays can have together.
        """
        drawn = np.random.default_rng(seed).standard_normal((runs, len(names)))
        if self.correlation or self.pairs:
            drawn = drawn @ factor(self.correlations(names)).T
        if self.kind == "normal":
            late: Floats = drawn * np.array([self.spread_s(name) for name in names])
        else:
            late = np.exp(self.shape * drawn) * np.array([self.median_s(name) for name in names])
        return late


def factor(correlations: Floats) -> Floats:
    """Return a lower triangle L with L L' = C, by Cholesky's method; C may be singular.

    Parameters
    ----------
    correlations : ndarray of float, (N, N)
        Symmetric.

    Returns
    -------
    ndarray of float, (N, N)
        Unique but for columns of zeros.

    Raises
    ------
    ScenarioError
        C is not positive semidefinite, so nothing can have these correlations.
    """
    size = len(correlations)
    lower = np.zeros((size, size))
    for k in range(size):
        rest = correlations[k:, k] - lower[k:, :k] @ lower[k, :k]
        pivot = float(rest[0])
        if pivot > ROUNDING:
            lower[k:, k] = rest / math.sqrt(pivot)
        elif pivot < -ROUNDING or np.abs(rest).max(initial=0.0) > math.sqrt(ROUNDING):
            raise ScenarioError(
                "delays: no delays can have these correlations together (the matrix is not "
                "positive semidefinite); bring them nearer to 0"
            )
    return lower


def _check_spread(label: str, value: object) -> None:
    if not (is_number(value) and 0 <= value <= MOST_MIN):
        raise ScenarioError(
            f"delays: {label} is {brief(value)}; give minutes from 0 to {MOST_MIN:.0f}"
        )


def _check_correlation(label: str, value: object) -> None:
    if not (is_number(value) and -1 <= value <= 1):
        raise ScenarioError(f"delays: {label} is {brief(value)}; give a number from -1 to 1")


def _is_pair(pair: object) -> bool:
    return (
        isinstance(pair, tuple)
        and len(pair) == 2
        and all(isinstance(name, str) for name in pair)
        and pair[0] != pair[1]
    )
