"""Trips with one platoon each, of two trucks: the best plan there is.

Trucks that leave one place at one minute would be together by accident, beside the pairs that were
chosen. So each leaves later by some ticks of its own, a tenth of a second at most; where two still
meet by accident, other ticks are drawn.
"""

from __future__ import annotations

from collections.abc import Collection
from dataclasses import replace

import numpy as np

from ..errors import ScenarioError
from .companies import companies_of
from .exact import Ways
from .instance import Instance
from .matching import matched_pairs

__all__ = ["one_platoon"]

DRAWS = 20

MOST_TICKS = 1000
"""A tenth of a second."""


def one_platoon(
    instance: Instance, seed: int, least: int = 0, apart: Collection[tuple[int, int]] = ()
) -> tuple[Ways, int]:
    """Return the best plan with one platoon of two a trip.

    Parameters
    ----------
    instance : Instance
        The problem; its largest platoon is 2.
    seed : int
        Of the ticks.
    least : int
        What a pair has to save [grains].
    apart : collection of (int, int)
        Trucks that must not drive together, the lower number first.

    Returns
    -------
    ways : Ways
        Lanes of each truck, and when it enters them [ticks].
    saving : int
        What it saves; no plan with one platoon of two a trip saves more, but for that tenth of a
        second [grains].

    Raises
    ------
    ScenarioError
        Larger platoons, or trucks that meet by accident whatever is drawn.
    """
    if instance.largest != 2:
        raise ScenarioError(
            "fleet: one platoon a trip is planned for platoons of two; give max_platoon 2, or let "
            "trips have many"
        )
    rng = np.random.default_rng(seed)
    forbidden = frozenset(apart)
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
    raise ScenarioError(
        "fleet: trucks meet by accident beside their one platoon, whatever is drawn; give them "
        "other departures, or let trips have many platoons"
    )


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
