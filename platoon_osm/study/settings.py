"""What a study varies and what it keeps."""

from __future__ import annotations

import hashlib
import json
import math
from collections.abc import Callable
from dataclasses import asdict, dataclass, field
from typing import Any, Literal, get_args

import numpy as np
from numpy.typing import NDArray

from .._version import __version__
from ..costs.paper import Mixing, PaperCosts
from ..errors import ScenarioError, brief
from ..kinds import is_number, is_whole
from ..planning.cases import Case
from ..planning.routers import Method
from .random_network import RandomNetwork
from .readings import (
    ALL_TERMS,
    TERM_SUMS,
    Factors,
    Reading,
    alone_per_metre,
    check_terms,
    factors_of,
)
from .road_trips import RoadTrips

__all__ = ["PAPER_STUDY", "Study", "Total"]

Total = Literal["members", "system"]

TENTHS = tuple(k / 10 for k in range(11))


@dataclass(frozen=True, slots=True)
class Study:
    """A Monte Carlo over networks and over the (tau, xi) grid.

    Attributes
    ----------
    network : RandomNetwork or RoadTrips
        Where networks and trips come from.
    runs : int
        Networks drawn.
    case : {"A", "B", "C"}
        Which case of the paper the members follow.
    methods : tuple of {"dijkstra", "astar", "astar-closed-once"}
        Ways to search, on the same draws.
    mixings : tuple of {"printed", "gain"}
        Readings of tau and xi in eq. 12.
    terms : tuple of str
        Which terms eq. 11 and 12 add up, such as "distance+time+fuel" and "time"; the first is
        what figures show.
    tau, xi : tuple of float
        The grid's axes, in [0, 1].
    points : tuple of (float, float)
        (tau, xi) looked at besides, such as the one the paper prints a number for.
    costs : PaperCosts
        All other cost parameters; its own tau, xi and mixing are not used.
    """

    network: RandomNetwork | RoadTrips = field(default_factory=RandomNetwork)
    runs: int = 100
    case: Case = "C"
    methods: tuple[Method, ...] = ("dijkstra",)
    mixings: tuple[Mixing, ...] = ("printed", "gain")
    terms: tuple[str, ...] = (ALL_TERMS,)
    tau: tuple[float, ...] = TENTHS
    xi: tuple[float, ...] = TENTHS
    points: tuple[tuple[float, float], ...] = ((1.0, 0.18),)
    costs: PaperCosts = field(default_factory=PaperCosts)

    def __post_init__(self) -> None:
        if not is_whole(self.runs) or self.runs < 1:
            raise ScenarioError(f"runs = {brief(self.runs)} must be a whole number, 1 or more")
        if not isinstance(self.network, RandomNetwork | RoadTrips):
            raise ScenarioError(
                f"network = {brief(self.network)} must be a RandomNetwork or RoadTrips in a study"
            )
        if not isinstance(self.costs, PaperCosts):
            raise ScenarioError(f"costs = {brief(self.costs)} must be PaperCosts in a study")
        if not isinstance(self.case, str) or self.case not in ("A", "B", "C"):
            raise ScenarioError(f'case = {brief(self.case)} must be "A", "B" or "C" in a study')
        if self.costs.positions is not None:
            raise ScenarioError(
                f"costs: positions = {brief(self.costs.positions)}; in a study the lead is "
                "rotated, as in the paper: leave positions out"
            )
        for name, allowed in (
            ("methods", get_args(Method)),
            ("mixings", ("printed", "gain")),
        ):
            chosen = getattr(self, name)
            known = _each(chosen, _is_text) and not set(chosen) - set(allowed)
            if not known or len(set(chosen)) < len(chosen):
                raise ScenarioError(
                    f"{name} = {brief(chosen)} must be one or more of {', '.join(allowed)}"
                )
        if not _each(self.terms, _is_text) or len(set(self.terms)) < len(self.terms):
            raise ScenarioError(
                f"terms = {brief(self.terms)} must be one or more sums, such as {ALL_TERMS}"
            )
        for terms in self.terms:
            check_terms(terms)
        for name in ("tau", "xi"):
            values = getattr(self, name)
            if not _each(values, is_number) or list(values) != sorted(set(values)):
                raise ScenarioError(f"{name} = {brief(values)} must be numbers in rising order")
        if not isinstance(self.points, tuple | list):
            raise ScenarioError(f"points = {brief(self.points)} must be pairs (tau, xi)")
        for pair in (*((t, self.xi[0]) for t in self.tau), *((self.tau[0], x) for x in self.xi),
                     *self.points):  # fmt: skip
            numbers = _each(pair, is_number) and len(pair) == 2
            if not (numbers and all(math.isfinite(v) and 0 <= v <= 1 for v in pair)):
                raise ScenarioError(f"grid point (tau, xi) = {brief(pair)} must lie in [0, 1]")

    @property
    def grid_shape(self) -> tuple[int, int]:
        """How many values of tau and of xi."""
        return len(self.tau), len(self.xi)

    def grid_points(self) -> NDArray[np.float64]:
        """Return (tau, xi) of all points: the grid row by row, then the further points.

        Returns
        -------
        ndarray of float, (P, 2)
            A point a row.
        """
        grid = [(tau, xi) for tau in self.tau for xi in self.xi]
        return np.array([*grid, *self.points], np.float64)

    @property
    def readings(self) -> tuple[Reading, ...]:
        """All readings, each choice of terms under each mixing."""
        return tuple(Reading(terms, mixing) for terms in self.terms for mixing in self.mixings)

    @property
    def alone_factor(self) -> float:
        """Cost alone of one metre under the first choice of terms [m]."""
        return alone_per_metre(self.costs, self.terms[0])

    def factors(self) -> Factors:
        """Return what one metre costs in a platoon, for each reading and point.

        Returns
        -------
        Factors
            In units of the first choice of terms.
        """
        return factors_of(self.costs, self.readings, self.grid_points())

    def to_dict(self) -> dict[str, Any]:
        """Return the plain JSON form; enough to repeat the study, with its seed.

        Returns
        -------
        dict
            Text, numbers, lists and dicts only.
        """
        net = self.network
        shown = net.to_dict() if isinstance(net, RoadTrips) else {"kind": "random", **asdict(net)}
        costs = {k: v for k, v in asdict(self.costs).items() if k not in ("tau", "xi", "mixing")}
        return {
            "network": shown, "runs": self.runs, "case": self.case, "methods": list(self.methods),
            "mixings": list(self.mixings), "terms": list(self.terms),
            "tau": list(self.tau), "xi": list(self.xi),
            "points": [list(pair) for pair in self.points], "costs": costs,
        }  # fmt: skip

    def key(self, seed: int) -> str:
        """Return a hash of all that a run's answer depends on; how many runs is not part of it.

        Parameters
        ----------
        seed : int
            Of all draws.

        Returns
        -------
        str
            Twenty hexadecimal digits.
        """
        told = {**self.to_dict(), "seed": seed, "version": __version__}
        del told["runs"]
        return hashlib.sha256(json.dumps(told, sort_keys=True).encode()).hexdigest()[:20]


def _each(values: object, check: Callable[[object], bool]) -> bool:
    """Whether it is a list or tuple of at least one value that all pass a check."""
    return isinstance(values, tuple | list) and len(values) > 0 and all(map(check, values))


def _is_text(value: object) -> bool:
    return isinstance(value, str)


PAPER_STUDY = Study(methods=get_args(Method), terms=TERM_SUMS)
"""Table 1 as printed: by Dijkstra and by A* in both readings, with both readings of the mixing
rates and all readings of what is added up."""
