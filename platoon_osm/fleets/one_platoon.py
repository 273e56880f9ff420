"""Trips with one platoon each: the best plan of pairs, a good one of larger platoons.

With a largest platoon of two a plan is a choice of pairs without a truck in common: the best is a
matching. Larger platoons are candidates grown from pairs, and a choice of them (`growing`).

Trucks that leave one place at one minute would be together by accident, beside the platoons that
were chosen. So with pairs each leaves later by some ticks of its own, a tenth of a second at most;
where two still meet by accident, other ticks are drawn. Larger platoons, and who drives alone, are
put on the roads one after another, each as few ticks later as keep it from all before.
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Sequence
from dataclasses import replace

import numpy as np

from ..errors import ScenarioError
from .companies import companies_of
from .exact import Ways
from .growing import Keeps, grown, nowhere
from .instance import Instance
from .labels import alone_ways
from .matching import matched_pairs
from .one_group import Group, Windows

__all__ = ["one_platoon"]

DRAWS = 20

MOST_TICKS = 1000
"""A tenth of a second."""

MET = ScenarioError(
    "fleet: trucks meet by accident beside their one platoon, whatever is tried; give them other "
    "departures, or let trips have many platoons"
)


def one_platoon(
    instance: Instance,
    seed: int,
    least: int = 0,
    apart: Collection[tuple[int, int]] = (),
    forced: Sequence[Group] = (),
    keeps: Keeps = nowhere,
    stop: Callable[[], bool] | None = None,
    time_s: float | None = None,
) -> tuple[Ways, int]:
    """Return a plan with one platoon a trip; the best one of pairs.

    Parameters
    ----------
    instance : Instance
        The problem.
    seed : int
        Of the ticks.
    least : int
        What a platoon has to save [grains].
    apart : collection of (int, int)
        Trucks that must not drive together, the lower number first.
    forced : sequence of Group
        Platoons of trucks that must drive together, though others may join them.
    keeps : callable
        Tells whether trucks that must drive together do so in some platoon.
    stop : callable, optional
        Asked now and then whether to take the best of the larger platoons that are found.
    time_s : float or None
        How long one choice of larger platoons may take [s]; None for a number of steps.

    Returns
    -------
    ways : Ways
        Lanes of each truck, and when it enters them [ticks].
    saving : int
        What it saves; if the largest platoon is 2 and nobody is forced, no plan with one platoon a
        trip saves more, but for that tenth of a second [grains].

    Raises
    ------
    ScenarioError
        Trucks that meet by accident whatever is tried.
    """
    forbidden = frozenset(apart)
    if instance.largest != 2 or forced:
        return _of_any_size(instance, least, forbidden, (forced, keeps), stop, time_s)
    rng = np.random.default_rng(seed)
    room = np.minimum(MOST_TICKS, _room(instance))
    for _ in range(DRAWS):
        later = rng.integers(0, room + 1)
        moved = replace(
            instance,
            earliest=instance.earliest + later,
            opens=np.minimum(instance.opens + later[instance.pair_truck], instance.closes),
        )
        lanes, departs, saving = matched_pairs(moved, least, forbidden)
        companies = companies_of(instance, lanes, departs)
        met = {company for own in companies for company in own}
        if all(map(_has_one, companies)) and forbidden.isdisjoint(met):
            return (lanes, departs), saving
    raise MET


def _of_any_size(
    instance: Instance,
    least: int,
    apart: Collection[tuple[int, int]],
    forced: tuple[Sequence[Group], Keeps],
    stop: Callable[[], bool] | None,
    time_s: float | None,
) -> tuple[Ways, int]:
    groups = grown(
        instance, least=least, apart=apart, forced=forced[0], keeps=forced[1], stop=stop,
        time_s=time_s,
    )  # fmt: skip
    lanes, departs = alone_ways(instance)
    windows = Windows(instance)
    units = [(group.trucks, group.slack) for group in groups]
    for group in groups:
        for place, k in enumerate(group.trucks):
            lanes[k], departs[k] = group.lanes[place], group.departs[place]
    busy = {k for trucks, _ in units for k in trucks}
    units += [
        ((k,), int((windows.closes(k, lanes[k]) - departs[k]).min()))
        for k in range(instance.trucks)
        if k not in busy
    ]
    # Who can wait least comes first.
    units.sort(key=lambda unit: (unit[1], unit[0]))
    taken: set[tuple[int, int]] = set()
    for trucks, slack in units:
        own = [
            entry
            for k in trucks
            for entry in zip(lanes[k].tolist(), departs[k].tolist(), strict=True)
        ]
        for later in range(min(slack, MOST_TICKS) + 1):
            if not any((lane, at + later) in taken for lane, at in own):
                break
        else:
            raise MET
        taken.update((lane, at + later) for lane, at in own)
        for k in trucks:
            departs[k] = departs[k] + later
    return (lanes, departs), sum(group.saving for group in groups)


def _room(instance: Instance) -> np.ndarray[tuple[int], np.dtype[np.int64]]:
    """Return by how many ticks each may leave later and still be in time by every way it has."""
    room = np.full(instance.trucks, MOST_TICKS, np.int64)
    np.minimum.at(room, instance.pair_truck, instance.closes - instance.opens)
    return np.maximum(room, 0)


def _has_one(companies: list[tuple[int, ...]]) -> bool:
    """Tell whether a truck drives with others once at most, and always with the same."""
    together = [len(company) > 1 for company in companies]
    begins = sum(
        now and (place == 0 or not together[place - 1]) for place, now in enumerate(together)
    )
    return begins <= 1 and len({own for own in companies if len(own) > 1}) <= 1
