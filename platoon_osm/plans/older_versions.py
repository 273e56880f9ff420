"""Plans of versions 1 and 2, which held each vehicle's legs: from legs to the record.

Old legs name their partners; here it is worked out once who drives which stretch with whom. What a
leg would cost alone was not stored. Under the paper's preset it is a factor of its length, and so
told exactly; of other costs it stays unknown.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import Any

from ..costs.paper import PaperCosts
from ..costs.share import Share
from ..errors import ScenarioError
from .events import platoon_events
from .proof import Proof
from .records import Leg, PlannedTrip, Platoon, PlatoonPoint, SoloRoute, Stop, Stretch
from .stretches import Run, linked, stretched
from .vehicles import VehiclePlan

__all__ = ["OLDER_VERSIONS", "fields_of_older", "fields_of_vehicles"]

OLDER_VERSIONS = (1, 2)

AGREE = 1e-6
"""Vehicles of a platoon may differ by this share in the driving time of one stretch."""

SAME_COST = 1e-6
"""The paper's preset is believed if it gives back the costs of solo legs within this share."""


def fields_of_older(data: Mapping[str, Any]) -> dict[str, Any]:
    """Return the fields of `Plan` from a plan of an older version.

    Parameters
    ----------
    data : mapping
        Plain JSON types of version 1 or 2.

    Returns
    -------
    dict
        All that older versions tell; costs alone are None where they do not.

    Raises
    ------
    ScenarioError
        Vehicles that name each other as company but do not drive the same.
    """
    known = {name: value for name, value in data.items() if name not in ("vehicles", "proof")}
    known.pop("timetable", None)
    made = fields_of_vehicles(
        [_vehicle(item) for item in data["vehicles"]], str(data["case"]), data["params"]
    )
    return {**known, **made, "proof": _proof(data["proof"], made)}


def fields_of_vehicles(
    vehicles: Sequence[VehiclePlan], case: str, params: Mapping[str, Any] | None = None
) -> dict[str, Any]:
    """Return the fields of `Plan` that follow from each vehicle's legs.

    Parameters
    ----------
    vehicles : sequence of VehiclePlan, (N,)
        Each as it sees the plan.
    case : str
        "A", "B", "C" or "D".
    params : mapping, optional
        Parameters of the costs; those of the paper's preset tell what legs cost alone.

    Returns
    -------
    dict
        `trips`, `stretches`, `ways`, `platoons` and `events`.

    Raises
    ------
    ScenarioError
        Vehicles that name each other as company but do not drive the same.
    """
    positions = {vehicle.vehicle: index for index, vehicle in enumerate(vehicles)}
    routes = [
        [_run(vehicles, positions, index, leg) for leg in vehicle.legs]
        for index, vehicle in enumerate(vehicles)
    ]
    runs, ways = stretched(routes)
    legs: list[dict[int, Leg]] = [{} for _ in runs]
    for index, way in enumerate(ways):
        for place, stretch in enumerate(way):
            legs[stretch][index] = vehicles[index].legs[place]
    costs = _paper_costs(vehicles, params or {})
    stretches = tuple(
        _stretch(vehicles, run, own, costs) for run, own in zip(runs, legs, strict=True)
    )
    platoons = _platoons(vehicles, stretches, case)

    def point_at(index: int, kind: str, stretch: int) -> PlatoonPoint | None:
        del stretch  # older plans have one stretch in company for each vehicle
        own = vehicles[index]
        point = own.merge if kind == "merge" else own.separation
        return None if point is None else replace(point, km=0.0)

    return {
        "trips": tuple(_trip(vehicle) for vehicle in vehicles),
        "stretches": stretches,
        "ways": ways,
        "platoons": platoons,
        "events": platoon_events(stretches, ways, platoons, point_at),
    }


def _run(
    vehicles: Sequence[VehiclePlan], positions: Mapping[str, int], index: int, leg: Leg
) -> Run:
    own = vehicles[index].vehicle
    if not leg.edges:
        raise ScenarioError(f"plan: {own!r} has a leg without edges; plan again")
    partners = leg.partners if leg.role == "platoon" else ()
    for name in partners:
        if name not in positions:
            raise ScenarioError(
                f"plan: {own!r} drives with {name!r}, which is not in the plan; plan again"
            )
    everyone = sorted({index, *(positions[name] for name in partners)})
    # The record says who leads; older plans tell it by the role alone.
    everyone.sort(key=lambda one: vehicles[one].role != "master")
    return Run(tuple(leg.edges), tuple(everyone))


def _stretch(
    vehicles: Sequence[VehiclePlan], run: Run, legs: Mapping[int, Leg], costs: PaperCosts | None
) -> Stretch:
    first = vehicles[min(legs)].vehicle
    if missing := set(run.company) - set(legs):
        raise ScenarioError(
            f"plan: {first!r} drives with {vehicles[min(missing)].vehicle!r}, which drives no such "
            "leg; plan again"
        )
    times = [leg.time_s for leg in legs.values()]
    if max(times) - min(times) > AGREE * max(times):
        raise ScenarioError(
            f"plan: vehicles of the platoon of {first!r} need from {min(times):.0f} to "
            f"{max(times):.0f} s for one stretch; plan again"
        )
    some = legs[run.company[0]]
    return Stretch(
        edges=run.edges,
        vehicles=run.company,
        length_m=some.length_m,
        drive_s=max(times),
        shares=tuple(_share(legs[index], len(run.company), costs) for index in run.company),
        inferred_m=some.inferred_m,
    )


def _share(leg: Leg, size: int, costs: PaperCosts | None) -> Share:
    if size == 1:
        return Share(leg.cost, leg.cost, leg.fuel_l, leg.fuel_l)
    alone = leg.alone_cost
    fuel = leg.fuel_l
    if costs is not None:
        fuel = leg.length_m * costs.fuel_alone()
        alone = leg.length_m * costs.solo_factor() if alone is None else alone
    return Share(leg.cost, alone, leg.fuel_l, fuel)


def _paper_costs(vehicles: Sequence[VehiclePlan], params: Mapping[str, Any]) -> PaperCosts | None:
    """Return the paper's costs if the plan was made with them; None if that cannot be told."""
    own = dict(params)
    if own.pop("preset", None) != "paper":
        return None
    try:
        costs = PaperCosts(**own)
    except (ScenarioError, TypeError):
        return None
    solos = [leg for v in vehicles for leg in (v.alone, *v.legs) if leg.role != "platoon"]
    given = all(
        math.isclose(leg.length_m * costs.solo_factor(), leg.cost, rel_tol=SAME_COST, abs_tol=1e-9)
        for leg in solos
    )
    return costs if given else None


def _platoons(
    vehicles: Sequence[VehiclePlan], stretches: Sequence[Stretch], case: str
) -> tuple[Platoon, ...]:
    companies = [stretch.company for stretch in stretches]
    found = []
    for group in linked(companies, len(vehicles)):
        masters = [index for index in group if vehicles[index].role == "master"]
        if len(group) > 1 or masters:
            found.append(Platoon(group, masters[0] if masters else None, case))
    return tuple(found)


def _trip(vehicle: VehiclePlan) -> PlannedTrip:
    alone = vehicle.alone
    return PlannedTrip(
        vehicle.vehicle,
        vehicle.origin,
        vehicle.destination,
        SoloRoute(
            alone.edges, alone.length_m, alone.time_s, alone.fuel_l, alone.cost, alone.inferred_m
        ),
        vehicle.reason,
    )


def _proof(told: Mapping[str, Any], made: Mapping[str, Any]) -> Proof:
    cost = sum(share.cost for stretch in made["stretches"] for share in stretch.shares)
    kind = str(told["kind"])
    return Proof(
        kind,
        cost,
        cost if kind == "exact" else told.get("bound"),
        tuple(str(item) for item in told.get("conditions", ())),
        told.get("optimum"),
        told.get("solo_excess"),
    )


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
