"""A plan as one vehicle sees it: its role, its legs and its points, read off the plan's record."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

from ..vehicles.profile import Vehicle
from .records import Event, Leg, PlannedTrip, Platoon, PlatoonPoint, Stop, Stretch

__all__ = ["VehiclePlan", "by_profile", "saved_share", "vehicles_of"]

SAME_SHARE = 1e-9
"""Costs of a way that is cut into stretches differ in their last digits."""


def saved_share(cost: float, alone: float) -> float:
    """Return by what share a cost is below that of driving alone.

    Parameters
    ----------
    cost : float
        As planned.
    alone : float
        Of driving alone.

    Returns
    -------
    float
        1 - cost / alone; 0 where they differ by the last digits of sums alone.
    """
    share = 1 - cost / alone if alone else 0.0
    return share if abs(share) > SAME_SHARE else 0.0


@dataclass(frozen=True, slots=True)
class VehiclePlan:
    """One vehicle's part of a plan.

    Attributes
    ----------
    vehicle : str
        Its name.
    origin, destination : Stop
        Where it goes.
    role : str
        "master", "member" or "alone".
    legs : tuple of Leg
        The joint route, in order; one for each stretch of its way.
    alone : Leg
        The route it would drive alone.
    merge, separation : PlatoonPoint or None
        Its first merging and its last separation point; None for the master or if it stays alone.
    reason : str
        Why it stays alone, or how its case was read; empty if there is nothing to say.
    """

    vehicle: str
    origin: Stop
    destination: Stop
    role: str
    legs: tuple[Leg, ...]
    alone: Leg
    merge: PlatoonPoint | None = None
    separation: PlatoonPoint | None = None
    reason: str = ""

    @property
    def solo_cost(self) -> float:
        """Cost of driving alone."""
        return self.alone.cost

    @property
    def joint_cost(self) -> float:
        """Cost of driving as planned."""
        return sum(leg.cost for leg in self.legs)

    @property
    def saving(self) -> float:
        """Share of the cost alone that the plan saves."""
        return saved_share(self.joint_cost, self.solo_cost)

    @property
    def length_m(self) -> float:
        """Length of the joint route."""
        return sum(leg.length_m for leg in self.legs)

    @property
    def time_s(self) -> float:
        """Driving time of the joint route."""
        return sum(leg.time_s for leg in self.legs)

    @property
    def fuel_l(self) -> float:
        """Fuel of the joint route."""
        return sum(leg.fuel_l for leg in self.legs)

    @property
    def platoon_m(self) -> float:
        """Length driven in the platoon."""
        return sum(leg.length_m for leg in self.legs if leg.role == "platoon")

    @property
    def access_m(self) -> float:
        """Length of the ways between the road and places beside it."""
        return sum(leg.length_m for leg in self.legs if leg.role == "access")

    @property
    def inferred_m(self) -> float:
        """Length of road on the joint route that the loader inferred."""
        return sum(leg.inferred_m for leg in self.legs)

    @property
    def edges(self) -> tuple[int, ...]:
        """All edges of the joint route in driving order."""
        return tuple(edge for leg in self.legs for edge in leg.edges)


def vehicles_of(
    trips: Sequence[PlannedTrip],
    stretches: Sequence[Stretch],
    ways: Sequence[Sequence[int]],
    platoons: Sequence[Platoon],
    events: Sequence[Event],
) -> tuple[VehiclePlan, ...]:
    """Return each vehicle's part of a plan, from the plan's record.

    Parameters
    ----------
    trips, stretches, ways, platoons, events : sequence
        Fields of `Plan`.

    Returns
    -------
    tuple of VehiclePlan
        In the order of the trips.
    """
    names = [trip.vehicle for trip in trips]
    roles = ["alone"] * len(trips)
    for platoon in platoons:
        for index in platoon.vehicles:
            roles[index] = "master" if index == platoon.master else "member"
    found = []
    for index, trip in enumerate(trips):
        alone = trip.alone
        found.append(
            VehiclePlan(
                vehicle=trip.vehicle,
                origin=trip.origin,
                destination=trip.destination,
                role=roles[index],
                legs=tuple(_leg(stretches[k], index, names) for k in ways[index]),
                alone=Leg(
                    "solo", alone.edges, (), alone.length_m, alone.time_s, alone.fuel_l,
                    alone.cost, alone.inferred_m, alone.cost, alone.span,
                ),
                merge=_point(index, "merge", stretches, ways[index], events),
                separation=_point(index, "separation", stretches, ways[index], events),
                reason=trip.reason,
            )
        )  # fmt: skip
    return tuple(found)


def by_profile(trips: Sequence[PlannedTrip]) -> dict[Vehicle, list[str]]:
    """Return the names of vehicles by what they are like.

    Parameters
    ----------
    trips : sequence of PlannedTrip
        Of a plan.

    Returns
    -------
    dict of Vehicle to list of str
        In the order of their first; without those of plans that do not tell.
    """
    found: dict[Vehicle, list[str]] = {}
    for trip in trips:
        if trip.profile is not None:
            found.setdefault(trip.profile, []).append(trip.vehicle)
    return found


def _leg(stretch: Stretch, index: int, names: Sequence[str]) -> Leg:
    share = stretch.share_of(index)
    return Leg(
        role="access" if stretch.access else "platoon" if stretch.together else "solo",
        edges=stretch.edges,
        partners=tuple(sorted(names[other] for other in stretch.vehicles if other != index)),
        length_m=stretch.length_m,
        time_s=stretch.drive_s,
        fuel_l=share.fuel_l,
        cost=share.cost,
        inferred_m=stretch.inferred_m,
        alone_cost=share.alone_cost,
        span=stretch.span,
        access=stretch.access,
        access_at=stretch.access_at,
    )


def _point(
    index: int,
    kind: str,
    stretches: Sequence[Stretch],
    way: Sequence[int],
    events: Sequence[Event],
) -> PlatoonPoint | None:
    """Return a vehicle's first merging or last separation point, on its own kilometres."""
    own = {event.stretch: event for event in events if event.kind == kind and index in event.movers}
    places = [place for place, stretch in enumerate(way) if stretch in own]
    if not places:
        return None
    place = places[0] if kind == "merge" else places[-1]
    driven = way[:place] if kind == "merge" else way[: place + 1]
    km = sum(stretches[k].length_m for k in driven) / 1000
    return replace(own[way[place]].point, km=km)
