"""What `plan_fleet` may do: how long, on which routes, and who may drive with whom."""

from __future__ import annotations

import math
import os
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field
from types import MappingProxyType
from typing import Any, Literal, get_args

from ..errors import ScenarioError, brief
from ..kinds import is_number, is_whole, kind_of

__all__ = ["Limits", "PerTrip", "Routes"]

Routes = Literal["free", "given"]
PerTrip = Literal["many", "one"]

NOBODY: Mapping[str, str] = MappingProxyType({})


@dataclass(frozen=True, slots=True)
class Limits:
    """Limits and wishes of a fleet's plan.

    Attributes
    ----------
    time_s : float or None
        How long to search [s]; None until `rounds` are done or nothing moves any more.
    rounds : int or None
        How many rounds to search. With rounds alone the plan is the same on every machine; a limit
        of time ends at another round on a faster one.
    seed : int
        Of the draws.
    threads : int or None
        Cores to use; None for all. The plan does not depend on it.
    routes : {"free", "given"}
        Whether trucks may leave their cheapest routes alone for company.
    per_trip : {"many", "one"}
        How many platoons a trip may have, one after the other. With one, the largest platoon
        counts all that are ever in it.
    min_gain : float
        What a platoon has to save from its merging to its separation, in the unit of costs.
    apart : tuple of (str, str)
        Vehicles that must not drive together.
    together : tuple of tuple of str
        Groups of vehicles that must drive together, each vehicle in one group: all of a group in
        one platoon on one stretch at least, or, where they have one origin and one destination,
        from start to end.
    carriers : mapping of str to str
        Carriers of vehicles, by their names; vehicles of unlike carriers do not drive together,
        and those that name none drive with their like.

    Raises
    ------
    ScenarioError
        Anything that is not what it should be, in one line.
    """

    time_s: float | None = 60.0
    rounds: int | None = None
    seed: int = 0
    threads: int | None = None
    routes: Routes = "free"
    per_trip: PerTrip = "many"
    min_gain: float = 0.0
    apart: tuple[tuple[str, str], ...] = ()
    together: tuple[tuple[str, ...], ...] = ()
    carriers: Mapping[str, str] = field(default_factory=lambda: NOBODY)

    def __post_init__(self) -> None:
        if self.time_s is not None and not (is_number(self.time_s) and 0 < self.time_s < math.inf):
            raise ScenarioError(f"limits: time_s is {brief(self.time_s)}; give seconds above 0")
        for label, least in (("rounds", 1), ("threads", 1), ("seed", 0)):
            value = getattr(self, label)
            if value is None and label != "seed":
                continue
            if not (is_whole(value) and value >= least):
                raise ScenarioError(
                    f"limits: {label} is {brief(value)}; give a whole number from {least} on"
                )
        for label, allowed in (("routes", get_args(Routes)), ("per_trip", get_args(PerTrip))):
            if (value := getattr(self, label)) not in allowed:
                raise ScenarioError(
                    f"limits: {label} {brief(value)} is unknown; use {', '.join(allowed)}"
                )
        if not (is_number(self.min_gain) and 0 <= self.min_gain < math.inf):
            raise ScenarioError(f"limits: min_gain is {brief(self.min_gain)}; give 0 or more")
        object.__setattr__(self, "apart", _pairs(self.apart))
        object.__setattr__(self, "together", _groups(self.together))
        object.__setattr__(self, "carriers", _carriers(self.carriers))

    @property
    def cores(self) -> int:
        """How many threads to use."""
        return self.threads or max(1, len(os.sched_getaffinity(0)) if _HAS_AFFINITY else 1)

    def check_names(self, names: Iterable[str]) -> None:
        """Check that all vehicles it names have trips.

        Parameters
        ----------
        names : iterable of str
            Those that do.

        Raises
        ------
        ScenarioError
            One has none.
        """
        known = set(names)
        for label, named in (
            ("apart", [name for pair in self.apart for name in pair]),
            ("together", [name for group in self.together for name in group]),
            ("carriers", list(self.carriers)),
        ):
            missing = next((name for name in named if name not in known), None)
            if missing is not None:
                raise ScenarioError(
                    f"limits: {label} names {brief(missing)}, which has no trip; correct the name"
                )


_HAS_AFFINITY = hasattr(os, "sched_getaffinity")


def _pairs(given: Any) -> tuple[tuple[str, str], ...]:
    if isinstance(given, str | Mapping) or not isinstance(given, Iterable):
        raise ScenarioError(f"limits: apart is a {kind_of(given)}; give pairs of vehicle names")
    found = []
    for pair in given:
        fits = isinstance(pair, tuple | list) and len(pair) == 2
        if not fits or not all(isinstance(name, str) for name in pair) or pair[0] == pair[1]:
            raise ScenarioError(f"limits: apart holds {brief(pair)}; give pairs of vehicle names")
        found.append((pair[0], pair[1]))
    return tuple(found)


def _groups(given: Any) -> tuple[tuple[str, ...], ...]:
    if isinstance(given, str | Mapping) or not isinstance(given, Iterable):
        raise ScenarioError(f"limits: together is a {kind_of(given)}; give groups of vehicle names")
    found: list[tuple[str, ...]] = []
    known: set[str] = set()
    for group in given:
        fits = isinstance(group, tuple | list) and len(group) > 1
        if not fits or not all(isinstance(name, str) for name in group):
            raise ScenarioError(
                f"limits: together holds {brief(group)}; give groups of two and more vehicle names"
            )
        for name in group:
            if name in known:
                raise ScenarioError(
                    f"limits: together names {brief(name)} twice; put each vehicle in one group"
                )
            known.add(name)
        found.append(tuple(group))
    return tuple(found)


def _carriers(given: Any) -> Mapping[str, str]:
    if not isinstance(given, Mapping) or not all(
        isinstance(text, str) for item in given.items() for text in item
    ):
        raise ScenarioError(
            f"limits: carriers is a {kind_of(given)} that names none; give vehicle: carrier"
        )
    return MappingProxyType(dict(given))
