"""What a plan says of its places: what names were taken for, and who is to be credited for them."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import replace

from ..network.location import Location
from ..network.naming import NodeNames
from ..network.road_network import RoadNetwork
from ..network.towns.surroundings import GEONAMES_CREDIT
from ..plans.plan import Plan

__all__ = ["with_place_remarks"]

MOST_NOTES = 8
"""So many names are explained one by one; hundreds of trips would bury all other remarks."""


def with_place_remarks(plan: Plan, net: RoadNetwork, places: Iterable[Sequence[Location]]) -> Plan:
    """Return a plan that says what its places were taken for.

    Parameters
    ----------
    plan : Plan
        The plan.
    net : RoadNetwork
        Its network.
    places : iterable of sequence of Location
        The ends of its trips.

    Returns
    -------
    Plan
        With further remarks and credits.
    """
    ends = [end for trip in places for end in trip]
    notes = list(dict.fromkeys(end.note for end in ends if end.note))
    remarks = notes[:MOST_NOTES]
    if len(notes) > MOST_NOTES:
        remarks.append(f"{len(notes) - MOST_NOTES} more names of places were taken for others")
    credited = any(end.from_geonames for end in ends) or _named_by_geonames(plan, net)
    return replace(
        plan,
        remarks=(*plan.remarks, *remarks),
        credits=(*plan.credits, GEONAMES_CREDIT) if credited else plan.credits,
    )


def _named_by_geonames(plan: Plan, net: RoadNetwork) -> bool:
    shown = {event.point.name for event in plan.events}
    shown |= {stretch.access_at for stretch in plan.stretches}
    return not shown.isdisjoint(net.attached(NodeNames).from_geonames())
