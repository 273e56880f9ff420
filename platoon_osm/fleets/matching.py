"""Who drives with whom where a trip has one platoon of two: a matching of greatest weight.

Every two trucks have one best plan (`pairs`), and no plan with one platoon of two a trip is more
than a choice of pairs that share no truck. Its greatest sum of savings is found by the blossom
method of rustworkx on whole numbers, so nothing is rounded.
"""

from __future__ import annotations

from collections.abc import Collection, Sequence

import numpy as np
from numpy.typing import NDArray

from .instance import Instance
from .labels import alone_ways
from .pairs import PairOffer, pair_offers

__all__ = ["matched", "matched_pairs"]

Ints = NDArray[np.int64]


def matched(trucks: int, offers: Sequence[PairOffer]) -> list[PairOffer]:
    """Return the offers that save most together, no truck in two of them.

    Parameters
    ----------
    trucks : int
        How many there are.
    offers : sequence of PairOffer
        Each of two trucks at most once.

    Returns
    -------
    list of PairOffer
        By their first trucks.
    """
    import rustworkx

    graph = rustworkx.PyGraph(multigraph=False)
    graph.add_nodes_from(range(trucks))
    graph.add_edges_from([(offer.first, offer.second, place) for place, offer in enumerate(offers)])
    chosen = rustworkx.max_weight_matching(graph, weight_fn=lambda place: offers[place].saving)
    places = sorted(graph.get_edge_data(*pair) for pair in chosen)
    return [offers[place] for place in places]


def matched_pairs(
    instance: Instance, least: int = 0, apart: Collection[tuple[int, int]] = ()
) -> tuple[list[Ints], list[Ints], int]:
    """Return the best plan with one platoon of two a trip.

    Parameters
    ----------
    instance : Instance
        The problem; waiting must be free.
    least : int
        What a pair has to save [grains].
    apart : collection of (int, int)
        Trucks that must not drive together, the lower number first.

    Returns
    -------
    lanes, departs : list of ndarray of int64, (N, ...)
        Lanes of each truck in driving order, and when it enters them [ticks].
    saving : int
        What it saves; no plan with one platoon of two a trip saves more [grains].
    """
    lanes, departs = alone_ways(instance)
    offers = [
        offer
        for offer in pair_offers(instance)
        if offer.saving >= least and (offer.first, offer.second) not in apart
    ]
    chosen = matched(instance.trucks, offers)
    for offer in chosen:
        for place, k in enumerate((offer.first, offer.second)):
            lanes[k], departs[k] = offer.lanes[place], offer.departs[place]
    return lanes, departs, sum(offer.saving for offer in chosen)
