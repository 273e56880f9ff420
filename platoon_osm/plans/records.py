"""What a plan is made of: stretches driven by one company, who belongs together, and where."""

from __future__ import annotations

from dataclasses import dataclass

from ..costs.share import Share
from ..vehicles.profile import Vehicle

__all__ = [
    "WHOLE", "Event", "Leg", "Line", "MasterTried", "NetworkIdentity", "PlannedTrip", "Platoon",
    "PlatoonPoint", "SoloRoute", "Span", "Stop", "Stretch",
]  # fmt: skip

Span = tuple[float, float]
"""Where a way begins on its first edge and ends on its last, as shares of their lengths."""

WHOLE: Span = (0.0, 1.0)

Line = tuple[tuple[float, float], tuple[float, float]]
"""A straight line, from (lon, lat) to (lon, lat) [deg]."""


@dataclass(frozen=True, slots=True)
class Stop:
    """Where a trip starts or ends.

    Attributes
    ----------
    node : int
        Position in the network; -1 for a place between two junctions, or beside the road.
    lon, lat : float
        Degrees.
    name : str
        As people know it.
    edge : int or None
        The edge on which a place between two junctions lies.
    share : float or None
        How much of that edge, by length, lies before the place.
    """

    node: int
    lon: float
    lat: float
    name: str
    edge: int | None = None
    share: float | None = None


@dataclass(frozen=True, slots=True)
class PlatoonPoint:
    """A merging or separation point.

    Attributes
    ----------
    node : int
        Position in the network; -1 for a place between two junctions.
    osm_id : int
        Its OpenStreetMap id; 0 for a place between two junctions.
    lon, lat : float
        Degrees.
    name : str
        Junction name, or the nearest thing to one.
    km : float
        Distance from the start of the vehicle's own joint route [km].
    edge : int or None
        The edge on which a place between two junctions lies.
    share : float or None
        How much of that edge, by length, lies before the place.
    """

    node: int
    osm_id: int
    lon: float
    lat: float
    name: str
    km: float
    edge: int | None = None
    share: float | None = None


@dataclass(frozen=True, slots=True)
class SoloRoute:
    """What a vehicle would drive if it drove alone.

    Attributes
    ----------
    edges : tuple of int
        Edge ids in driving order.
    length_m, time_s, fuel_l, cost : float
        Totals [m, s, l, unit of the plan].
    inferred_m : float
        Length of road that the loader inferred [m].
    span : tuple of float, (2,)
        Where it begins on the first edge and ends on the last.
    access : tuple of (Line or None), (2,)
        The ways to the road before its edges, and to the destination after them; they count in all
        totals.
    terms : tuple of float
        The cost term by term, in the order of the objective's terms; empty where it does not tell
        them apart.
    paused_s : float
        How long it would stand on its way for the driving rules of the plan [s].
    """

    edges: tuple[int, ...]
    length_m: float
    time_s: float
    fuel_l: float
    cost: float
    inferred_m: float = 0.0
    span: Span = WHOLE
    access: tuple[Line | None, Line | None] = (None, None)
    terms: tuple[float, ...] = ()
    paused_s: float = 0.0


@dataclass(frozen=True, slots=True)
class PlannedTrip:
    """One vehicle's journey, and what it would be alone.

    Attributes
    ----------
    vehicle : str
        Its name; no two of a plan are alike.
    origin, destination : Stop
        Where it goes.
    alone : SoloRoute
        The route it would drive alone.
    reason : str
        Why it stays alone, or how its case was read; empty if there is nothing to say.
    profile : Vehicle or None
        Size, mass and load that it was planned with; None in plans of older versions.
    """

    vehicle: str
    origin: Stop
    destination: Stop
    alone: SoloRoute
    reason: str = ""
    profile: Vehicle | None = None


@dataclass(frozen=True, slots=True)
class Stretch:
    """A longest stretch of road driven by one unchanged company.

    Attributes
    ----------
    edges : tuple of int
        Edge ids in driving order; none of a way between the road and a place beside it.
    vehicles : tuple of int
        Positions of its vehicles in the plan, in the order in which they drive; the first leads.
    length_m, drive_s : float
        Its length [m] and how long they drive it [s].
    shares : tuple of Share
        What each of `vehicles` pays there.
    inferred_m : float
        Length of road that the loader inferred [m].
    span : tuple of float, (2,)
        Where it begins on the first edge and ends on the last, as shares of their lengths.
    access : Line or None
        The straight line of a way between the road and a place beside it, as it is driven; its
        length is that of the line with a detour. None for a stretch of road.
    access_at : str
        Where such a way meets the road, as people know it; else empty.
    """

    edges: tuple[int, ...]
    vehicles: tuple[int, ...]
    length_m: float
    drive_s: float
    shares: tuple[Share, ...]
    inferred_m: float = 0.0
    span: Span = WHOLE
    access: Line | None = None
    access_at: str = ""

    @property
    def company(self) -> tuple[int, ...]:
        """The positions of its vehicles in the plan, ascending."""
        return tuple(sorted(self.vehicles))

    @property
    def together(self) -> bool:
        """Whether several vehicles drive it as a platoon."""
        return len(self.vehicles) > 1

    def share_of(self, vehicle: int) -> Share:
        """Return what one of its vehicles pays.

        Parameters
        ----------
        vehicle : int
            Position in the plan.

        Returns
        -------
        Share
            Cost and fuel.
        """
        return self.shares[self.vehicles.index(vehicle)]


@dataclass(frozen=True, slots=True)
class Platoon:
    """Vehicles that belong together.

    Attributes
    ----------
    vehicles : tuple of int
        Positions in the plan, ascending; a master that nobody joins is a platoon of one.
    master : int or None
        The vehicle whose route the others join; None if no route is fixed (case D).
    case : str
        "A", "B", "C" or "D".
    """

    vehicles: tuple[int, ...]
    master: int | None
    case: str


@dataclass(frozen=True, slots=True)
class MasterTried:
    """What a plan would cost with one of its vehicles as master.

    Attributes
    ----------
    vehicle : int
        Its position in the plan.
    case : str
        "A", "B" or "C".
    cost : float
        Of all vehicles together, in the unit of the plan.
    """

    vehicle: int
    case: str
    cost: float


@dataclass(frozen=True, slots=True)
class Event:
    """Vehicles that join, or leave, a platoon at one node.

    Attributes
    ----------
    kind : str
        "merge" or "separation".
    point : PlatoonPoint
        Where; its `km` counts on the way of the first of `movers`.
    movers : tuple of int
        Vehicles that join or leave, positions in the plan.
    others : tuple of int
        Vehicles already together, or that go on together.
    stretch : int
        The stretch that begins with the merge, or ends with the separation.
    """

    kind: str
    point: PlatoonPoint
    movers: tuple[int, ...]
    others: tuple[int, ...]
    stretch: int


@dataclass(frozen=True, slots=True)
class Leg:
    """A stretch as one of its vehicles sees it.

    Attributes
    ----------
    role : str
        "solo", "platoon", or "access" for a way between the road and a place beside it.
    edges : tuple of int
        Edge ids in driving order.
    partners : tuple of str
        Names of the other vehicles on the leg.
    length_m, time_s, fuel_l, cost : float
        Totals of this vehicle on the leg [m, s, l, unit of the plan].
    inferred_m : float
        Length of road that the loader inferred [m].
    alone_cost : float or None
        What the leg would cost the vehicle alone; None if the plan does not tell.
    span : tuple of float, (2,)
        Where it begins on the first edge and ends on the last, as shares of their lengths.
    access : Line or None
        As in `Stretch`.
    access_at : str
        As in `Stretch`.
    """

    role: str
    edges: tuple[int, ...]
    partners: tuple[str, ...]
    length_m: float
    time_s: float
    fuel_l: float
    cost: float
    inferred_m: float = 0.0
    alone_cost: float | None = None
    span: Span = WHOLE
    access: Line | None = None
    access_at: str = ""


@dataclass(frozen=True, slots=True)
class NetworkIdentity:
    """Which network a plan belongs to.

    Attributes
    ----------
    name, sha256, extracted, licence, attribution : str
        Of its source; see `Source`.
    nodes, edges : int
        Its size.
    identity : str
        Hash of the graph itself; see `RoadNetwork.identity`.
    """

    name: str
    sha256: str
    extracted: str
    licence: str
    attribution: str
    nodes: int
    edges: int
    identity: str
