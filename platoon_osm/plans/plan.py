"""What is answered: one immutable record of a plan, for a pair, a master with members, a fleet."""

from __future__ import annotations

import json
import os
from collections.abc import Mapping
from dataclasses import dataclass, field, fields
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING, Any

from ..errors import ScenarioError, brief
from ..offers import offered
from .bill import Bill
from .chances import Chances
from .checker import check_parts, check_times
from .fleet import FleetRecord
from .gain import GainSharing
from .json_file import write_json_file
from .json_form import PLAN_VERSION, plan_from_dict
from .money_checks import check_money
from .plain import plain
from .proof import Proof
from .records import Event, MasterTried, NetworkIdentity, PlannedTrip, Platoon, Stretch
from .rotation import Rotation
from .rotation_checks import check_rotation
from .text_table import named
from .timetable import Timetable, VehicleTimes
from .vehicles import VehiclePlan, saved_share, vehicles_of

if TYPE_CHECKING:
    import folium
    import geopandas
    import pandas

    from ..network.road_network import RoadNetwork

__all__ = ["JointPlan", "Plan"]


@dataclass(frozen=True, repr=False)
class Plan:
    """A plan for several vehicles: who drives which stretch with whom, and what each pays.

    `vehicles` shows it as each vehicle sees it; it is read off the record when asked for.

    Attributes
    ----------
    trips : tuple of PlannedTrip, (N,)
        The vehicles and where they go, in the order of the trips asked for.
    stretches : tuple of Stretch
        Every stretch driven by one company, vehicle by vehicle in driving order, each once.
    ways : tuple of tuple of int, (N, ...)
        The stretches that each vehicle drives, in driving order.
    platoons : tuple of Platoon
        Who belongs together.
    events : tuple of Event
        Merges and separations, platoon by platoon in driving order.
    case : str
        "A", "B", "C" or "D".
    asked : str
        What was asked for ("best" among them).
    objective : str
        "member": each member pays least itself; "system": all together do.
    method : str
        "dijkstra", "astar" or "astar-closed-once".
    unit : str
        Unit of all costs.
    params : mapping of str to object
        Parameters of the costs.
    network : NetworkIdentity
        The network it was made on.
    proof : Proof
        How good the plan is known to be, and under which conditions.
    remarks : tuple of str
        What a reader should know.
    version : str
        Of the package that made it.
    timetable : Timetable or None
        When each vehicle is where; None if no trip named a time.
    credits : tuple of str
        Whom to name besides the makers of the map, as for the names of towns.
    masters : tuple of MasterTried
        What the plan would cost with each master that was tried, the cheapest first; one if the
        master was given.
    closed : tuple of str
        Roads that were to count as closed, in the words of whoever asked.
    bill : Bill or None
        What it costs in money, waiting and delay included; None where costs are no money.
    gain : GainSharing or None
        How what it saves is shared; None where nobody worked it out.
    chances : Chances or None
        How likely its merges are if vehicles run late; None where no delays were given.
    rotation : Rotation or None
        Where the lead is handed on; None where the leaders stay in front, and where it makes no
        sense.
    fleet : FleetRecord or None
        What is known of the plan of a whole fleet: its saving, the bound on it, and who could not
        be planned. None for a plan that was not made by `plan_fleet`.

    Raises
    ------
    ScenarioError
        Parts that do not fit each other.
    """

    trips: tuple[PlannedTrip, ...]
    stretches: tuple[Stretch, ...]
    ways: tuple[tuple[int, ...], ...]
    platoons: tuple[Platoon, ...]
    events: tuple[Event, ...]
    case: str
    asked: str
    objective: str
    method: str
    unit: str
    params: Mapping[str, Any]
    network: NetworkIdentity
    proof: Proof
    remarks: tuple[str, ...] = ()
    version: str = ""
    timetable: Timetable | None = None
    credits: tuple[str, ...] = ()
    masters: tuple[MasterTried, ...] = ()
    closed: tuple[str, ...] = ()
    bill: Bill | None = None
    gain: GainSharing | None = None
    chances: Chances | None = None
    rotation: Rotation | None = None
    fleet: FleetRecord | None = None
    plan_version: int = field(default=PLAN_VERSION, init=False)

    def __post_init__(self) -> None:
        check_parts(
            self.trips, self.stretches, self.ways, self.platoons, self.events, self.timetable
        )
        check_money(self.trips, self.events, self.bill, self.gain, self.chances)
        check_rotation(self.trips, self.stretches, self.rotation)

    def told(
        self,
        *,
        proof: Proof | None = None,
        timetable: Timetable | None = None,
        fleet: FleetRecord | None = None,
    ) -> Plan:
        """Return the plan with more told of it; its parts, which were checked, are not again.

        Parameters
        ----------
        proof : Proof, optional
            What is proved of it.
        timetable : Timetable, optional
            Its times.
        fleet : FleetRecord, optional
            What is known of the fleet.

        Returns
        -------
        Plan
            What is not given is as it was.

        Raises
        ------
        ScenarioError
            Times of other vehicles.
        """
        if timetable is not None:
            check_times(self.trips, self.ways, timetable)
        plan = object.__new__(type(self))
        for one in fields(self):
            object.__setattr__(plan, one.name, getattr(self, one.name))
        for name, value in (("proof", proof), ("timetable", timetable), ("fleet", fleet)):
            if value is not None:
                object.__setattr__(plan, name, value)
        return plan

    @cached_property
    def vehicles(self) -> tuple[VehiclePlan, ...]:
        """The plan as each vehicle sees it, in the order of the trips."""
        return vehicles_of(self.trips, self.stretches, self.ways, self.platoons, self.events)

    @property
    def times(self) -> tuple[VehicleTimes | None, ...]:
        """The times of each vehicle, all None if the plan has no timetable."""
        return self.timetable.vehicles if self.timetable else (None,) * len(self.trips)

    @property
    def solo_cost(self) -> float:
        """Cost if everyone drove alone."""
        return sum(trip.alone.cost for trip in self.trips)

    @property
    def joint_cost(self) -> float:
        """Cost as planned."""
        return sum(vehicle.joint_cost for vehicle in self.vehicles)

    @property
    def saving(self) -> float:
        """Share of the total cost saved."""
        return saved_share(self.joint_cost, self.solo_cost)

    @property
    def platoon_m(self) -> float:
        """The vehicle-metres driven in the platoon."""
        return sum(vehicle.platoon_m for vehicle in self.vehicles)

    @property
    def platoon_road_m(self) -> float:
        """Road driven in platoons; the vehicles of one share it, so its length counts once."""
        return sum(stretch.length_m for stretch in self.stretches if stretch.together)

    @property
    def members(self) -> tuple[VehiclePlan, ...]:
        """The vehicles that merge with another."""
        return tuple(vehicle for vehicle in self.vehicles if vehicle.role == "member")

    def summary(self) -> str:
        """Return the plan as a table for reading.

        Returns
        -------
        str
            One row a vehicle, then totals, points and what is proved.
        """
        return offered("summary")(self)  # type: ignore[no-any-return]  # offered by name

    def to_frame(self, what: str = "vehicles") -> pandas.DataFrame:
        """Return the plan as a tidy table; see `platoon_osm.plans.frames.to_frame`.

        Parameters
        ----------
        what : {"vehicles", "stretches", "points", "positions", "timetable", "pauses"}
            What a row is.

        Returns
        -------
        pandas.DataFrame
            Units stand in the names of its columns.
        """
        return offered("to_frame")(self, what)  # type: ignore[no-any-return]  # offered by name

    def to_geodataframe(self, net: RoadNetwork, what: str = "legs") -> geopandas.GeoDataFrame:
        """Return legs as lines, or pauses as points; as `platoon_osm.to_geodataframe`.

        Parameters
        ----------
        net : RoadNetwork
            The network the plan was made on.
        what : {"legs", "pauses"}
            One row for each.

        Returns
        -------
        geopandas.GeoDataFrame
            In EPSG:4326.
        """
        return offered("to_geodataframe")(self, net, what)

    def __repr__(self) -> str:
        """Return the plan in one line, however many vehicles there are."""
        if (fleet := self.fleet) is not None:
            most = fleet.most / fleet.alone_cost if fleet.alone_cost else 0.0
            return (
                f"<Plan of a fleet: {len(self.trips):,} vehicles, {fleet.saved_share:.2%} saved, "
                f"{most:.2%} can be at most (gap {fleet.gap:.3%} of that), "
                f"{self.platoon_m / 1000:,.0f} vehicle-km in platoons, "
                f"on {named(self.network.name)}>"
            )
        return (
            f"<Plan case {self.case}: {len(self.trips):,} vehicles, {self.saving:.1%} saved, "
            f"{self.platoon_m / 1000:,.0f} vehicle-km in platoons, on {named(self.network.name)}>"
        )

    def explore(self, net: RoadNetwork, **options: Any) -> folium.Map:
        """Return the plan's map and figures for a notebook; as `platoon_osm.explore`.

        Parameters
        ----------
        net : RoadNetwork
            The network the plan was made on.
        **options : object
            Such as `height`, `title`, `tiles`.

        Returns
        -------
        folium.Map
            Its page is that of `write_html`.
        """
        return offered("explore")(self, net, **options)  # type: ignore[no-any-return]  # offered by name

    def _repr_html_(self) -> str:
        """Return the table that a notebook shows of the plan."""
        return offered("plan_table")(self)  # type: ignore[no-any-return]  # offered by name

    def to_dict(self) -> dict[str, Any]:
        """Return plain JSON types; `from_dict` gives the plan back.

        Returns
        -------
        dict
            As docs/plan.schema.json describes it.
        """
        found: dict[str, Any] = plain(self)
        return found

    @classmethod
    def from_dict(cls, data: Mapping[str, Any]) -> Plan:
        """Rebuild a plan from `to_dict`; plans of versions 1 to 3 open too.

        Parameters
        ----------
        data : mapping
            Plain JSON types.

        Returns
        -------
        Plan
            Of the current version, whatever the file's.

        Raises
        ------
        ScenarioError
            Another version of the format, or not a plan at all.
        """
        return plan_from_dict(cls, data)

    def write_json(self, path: str | os.PathLike[str]) -> None:
        """Write the plan as JSON in UTF-8, whole or not at all.

        Halves of characters in names, which UTF-8 has no bytes for, become U+FFFD.

        Parameters
        ----------
        path : str or path
            Of the file; missing folders are made.

        Raises
        ------
        ScenarioError
            The file cannot be written.
        """
        write_json_file(self.to_dict(), path)

    @classmethod
    def read_json(cls, path: str | os.PathLike[str]) -> Plan:
        """Read a plan from a file that `write_json` wrote, of this version or an older one.

        Parameters
        ----------
        path : str or path
            Of the file; or of a fleet's, which holds a plan beside its certificate.

        Returns
        -------
        Plan
            The plan.

        Raises
        ------
        ScenarioError
            A file that cannot be read, is no JSON, or holds no plan.
        """
        file = brief(path) if not isinstance(path, str | os.PathLike) else path
        try:
            data = json.loads(Path(path).read_bytes())  # in any Unicode, with or without a mark
        except OSError as error:
            raise ScenarioError(f"{file}: cannot be read ({error.strerror})") from error
        except (TypeError, ValueError, RecursionError):
            raise ScenarioError(f"{file}: is no JSON file; plan again with --json") from None
        if isinstance(data, dict) and data.get("format") == FLEET_FILE:
            data = data.get("plan")
        try:
            return cls.from_dict(data)
        except ScenarioError as error:
            raise ScenarioError(f"{file}: {error}") from error


FLEET_FILE = "platoon-osm fleet"
"""The format of files that hold a fleet's plan with what proves it."""

JointPlan = Plan
"""What a plan was called when it had one master; the same class."""
