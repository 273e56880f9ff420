"""What is answered: immutable records of a joint plan, with a JSON round trip."""

from __future__ import annotations

import json
import os
from collections.abc import Mapping
from dataclasses import asdict, dataclass, field
from typing import TYPE_CHECKING, Any

from ..atomic_file import whole_file
from ..errors import ScenarioError
from ..offers import offered
from .timetable import Timetable, VehicleTimes

if TYPE_CHECKING:
    import folium

    from ..network.road_network import RoadNetwork

__all__ = ["PLAN_VERSION", "JointPlan", "Leg", "NetworkIdentity", "PlatoonPoint", "Stop",
           "VehiclePlan"]  # fmt: skip

PLAN_VERSION = 2
OLDER_VERSIONS = (1,)
"""Version 1 had no timetable."""


@dataclass(frozen=True, slots=True)
class Stop:
    """Where a trip starts or ends: node, coordinates [deg] and name."""

    node: int
    lon: float
    lat: float
    name: str


@dataclass(frozen=True, slots=True)
class PlatoonPoint:
    """A merging or separation point.

    Attributes
    ----------
    node : position in the network; `osm_id` its OpenStreetMap id.
    lon, lat : degrees.
    name : junction name, or the nearest thing to one.
    km : distance from the start of the vehicle's own joint route.
    """

    node: int
    osm_id: int
    lon: float
    lat: float
    name: str
    km: float


@dataclass(frozen=True, slots=True)
class Leg:
    """A stretch driven in one role.

    Attributes
    ----------
    role : "solo", or "platoon" (the lead is rotated).
    edges : edge ids in driving order.
    partners : names of the other vehicles on the leg.
    length_m, time_s, fuel_l, cost : totals of this vehicle on the leg.
    inferred_m : length of road that the loader inferred.
    """

    role: str
    edges: tuple[int, ...]
    partners: tuple[str, ...]
    length_m: float
    time_s: float
    fuel_l: float
    cost: float
    inferred_m: float = 0.0


@dataclass(frozen=True, slots=True)
class VehiclePlan:
    """One vehicle's part of a plan.

    Attributes
    ----------
    vehicle : its name; `origin`, `destination` where it goes.
    role : "master", "member" or "alone".
    legs : the joint route, in order.
    alone : the route it would drive alone.
    merge, separation : its merging and separation point; None for the master or if it stays alone.
    reason : why it stays alone, or how its case was read; empty if there is nothing to say.
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
        return 1 - self.joint_cost / self.solo_cost if self.solo_cost else 0.0

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
    def edges(self) -> tuple[int, ...]:
        """All edges of the joint route in driving order."""
        return tuple(edge for leg in self.legs for edge in leg.edges)


@dataclass(frozen=True, slots=True)
class NetworkIdentity:
    """Which network a plan belongs to: its source, size and hash."""

    name: str
    sha256: str
    extracted: str
    licence: str
    attribution: str
    nodes: int
    edges: int
    identity: str


@dataclass(frozen=True, slots=True)
class JointPlan:
    """A plan for several vehicles.

    Attributes
    ----------
    vehicles : in the order of the trips.
    case : "A", "B", "C" or "D"; `asked` what was asked for ("best" among them).
    objective : "member" or "system".
    method : "dijkstra" or "astar".
    unit : of all costs.
    params : of the costs.
    network : identity of the network.
    proof : how good the plan is known to be: `kind` "exact" with its conditions, or `bound`, `gap`.
    remarks : what a reader should know.
    version : of the package that made it.
    timetable : when each vehicle is where; None if no trip named a time.
    """

    vehicles: tuple[VehiclePlan, ...]
    case: str
    asked: str
    objective: str
    method: str
    unit: str
    params: Mapping[str, Any]
    network: NetworkIdentity
    proof: Mapping[str, Any]
    remarks: tuple[str, ...] = ()
    version: str = ""
    plan_version: int = field(default=PLAN_VERSION)
    timetable: Timetable | None = None

    @property
    def times(self) -> tuple[VehicleTimes | None, ...]:
        """The times of each vehicle, all None if the plan has no timetable."""
        return self.timetable.vehicles if self.timetable else (None,) * len(self.vehicles)

    @property
    def solo_cost(self) -> float:
        """Cost if everyone drove alone."""
        return sum(vehicle.solo_cost for vehicle in self.vehicles)

    @property
    def joint_cost(self) -> float:
        """Cost as planned."""
        return sum(vehicle.joint_cost for vehicle in self.vehicles)

    @property
    def saving(self) -> float:
        """Share of the total cost saved."""
        return 1 - self.joint_cost / self.solo_cost if self.solo_cost else 0.0

    @property
    def platoon_m(self) -> float:
        """Vehicle-metres driven in the platoon."""
        return sum(vehicle.platoon_m for vehicle in self.vehicles)

    @property
    def members(self) -> tuple[VehiclePlan, ...]:
        """Vehicles that merge with another."""
        return tuple(vehicle for vehicle in self.vehicles if vehicle.role == "member")

    def summary(self) -> str:
        """Return the plan as a table for reading."""
        return offered("summary")(self)  # type: ignore[no-any-return]

    def explore(self, net: RoadNetwork, **options: Any) -> folium.Map:
        """Return the plan's map and figures for a notebook; as `platoon_osm.explore`.

        Parameters
        ----------
        net : the network the plan was made on.
        options : such as `height`, `title`, `tiles`.
        """
        return offered("explore")(self, net, **options)  # type: ignore[no-any-return]

    def _repr_html_(self) -> str:
        """Return the table that a notebook shows of the plan."""
        return offered("plan_table")(self)  # type: ignore[no-any-return]

    def to_dict(self) -> dict[str, Any]:
        """Return plain JSON types; `from_dict` gives the plan back."""
        return json.loads(json.dumps(asdict(self)))  # type: ignore[no-any-return]

    @classmethod
    def from_dict(cls, data: Mapping[str, Any]) -> JointPlan:
        """Rebuild a plan from `to_dict`.

        Raises
        ------
        ScenarioError
            Another version of the format, or not a plan at all.
        """
        found = data.get("plan_version") if isinstance(data, Mapping) else None
        if isinstance(found, bool) or found not in (*OLDER_VERSIONS, PLAN_VERSION):
            raise ScenarioError(
                f"plan: format version {found!r}, this version reads up to {PLAN_VERSION}; "
                "plan again"
            )
        times = data.get("timetable")
        try:
            plan = cls(
                **{
                    **data,
                    "vehicles": tuple(_vehicle(item) for item in data["vehicles"]),
                    "network": NetworkIdentity(**data["network"]),
                    "remarks": tuple(data["remarks"]),
                    "plan_version": PLAN_VERSION,
                    "timetable": None if times is None else Timetable.from_dict(times),
                }
            )
            plan.check_timetable()
        except (KeyError, TypeError, ValueError, AttributeError) as error:
            raise ScenarioError(f"plan: {error} does not fit; it is damaged, plan again") from error
        return plan

    def check_timetable(self) -> None:
        """Raise `ScenarioError` if there are times that belong to other vehicles or legs."""
        own = [(vehicle.vehicle, len(vehicle.legs)) for vehicle in self.vehicles]
        if self.timetable and own != [(t.vehicle, len(t.legs)) for t in self.timetable.vehicles]:
            raise ScenarioError("plan: its timetable is that of other vehicles; plan again")

    def write_json(self, path: str | os.PathLike[str]) -> None:
        """Write the plan as JSON, whole or not at all."""
        text = json.dumps(self.to_dict(), indent=1, ensure_ascii=False) + "\n"
        with whole_file(path) as draft:
            draft.write_text(text, encoding="utf-8")


def _vehicle(data: Mapping[str, Any]) -> VehiclePlan:
    def point(item: Mapping[str, Any] | None) -> PlatoonPoint | None:
        return None if item is None else PlatoonPoint(**item)

    def leg(item: Mapping[str, Any]) -> Leg:
        return Leg(**{**item, "edges": tuple(item["edges"]), "partners": tuple(item["partners"])})

    return VehiclePlan(
        **{
            **data,
            "origin": Stop(**data["origin"]),
            "destination": Stop(**data["destination"]),
            "legs": tuple(leg(item) for item in data["legs"]),
            "alone": leg(data["alone"]),
            "merge": point(data["merge"]),
            "separation": point(data["separation"]),
        }
    )
