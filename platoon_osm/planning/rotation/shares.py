"""What each vehicle of a company pays in another order.

Vehicles alike pay what the one pays that was planned for their place, so the sum of the company
stays. Another vehicle pays its own cost, times the ratio of its weights at both places.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from ...costs.share import Share
from ...network.road_network import RoadNetwork
from ...plans.records import Stretch
from ..driven_pieces import DrivenPieces
from ..fleet import Fleet

__all__ = ["in_order"]


def in_order(net: RoadNetwork, fleet: Fleet, stretch: Stretch, order: Sequence[int]) -> Stretch:
    """Return a stretch driven in another order.

    Parameters
    ----------
    net : RoadNetwork
        The network with the places of the trips.
    fleet : Fleet
        What its edges cost each vehicle.
    stretch : Stretch
        Of a plan, its edges those of the network below.
    order : sequence of int
        Its vehicles, the leader first.

    Returns
    -------
    Stretch
        With what each pays in its place.
    """
    if tuple(order) == stretch.vehicles:
        return stretch
    shares = []
    for place, vehicle in enumerate(order):
        there = stretch.vehicles[place]
        if fleet.kind[vehicle] == fleet.kind[there]:
            shares.append(stretch.shares[place])
        else:
            shares.append(_own(net, fleet, stretch, vehicle, tuple(order)))
    return replace(stretch, vehicles=tuple(order), shares=tuple(shares))


def _own(
    net: RoadNetwork, fleet: Fleet, stretch: Stretch, vehicle: int, order: Sequence[int]
) -> Share:
    planned = stretch.share_of(vehicle)
    before = _weighed(net, fleet, stretch, vehicle, stretch.vehicles)
    now = _weighed(net, fleet, stretch, vehicle, order)
    terms = tuple(map(_scaled, planned.terms, now.terms, before.terms))
    return replace(
        planned,
        cost=sum(terms) if terms else _scaled(planned.cost, now.cost, before.cost),
        fuel_l=_scaled(planned.fuel_l, now.fuel_l, before.fuel_l),
        terms=terms,
    )


def _scaled(planned: float, now: float, before: float) -> float:
    return planned * now / before if before else now


def _weighed(
    net: RoadNetwork, fleet: Fleet, stretch: Stretch, vehicle: int, order: Sequence[int]
) -> Share:
    """Return what a vehicle pays for a stretch in some order, by its weights."""
    place = list(order).index(vehicle)
    ids, parts = net.attached(DrivenPieces).of(stretch)
    lengths = net.length_m[ids]
    found = fleet.share(order, place, ids, float(lengths.sum()))
    # All edges are whole but the first and the last.
    for at in (0, len(ids) - 1)[: len(ids)]:
        left = fleet.share(order, place, ids[[at]], float(lengths[at])).part(1 - float(parts[at]))
        found = replace(
            found,
            cost=found.cost - left.cost,
            fuel_l=found.fuel_l - left.fuel_l,
            terms=tuple(one - less for one, less in zip(found.terms, left.terms, strict=True)),
        )
    return found
