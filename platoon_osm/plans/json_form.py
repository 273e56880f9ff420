"""A plan as plain JSON types, and back; docs/plan.schema.json describes the form.

Version 8 is the record itself. Version 7 knew no fleets, version 6 no bill, no shares of the gain,
no chances and no rotation of the lead, version 5 no pauses and no drivers, version 4 did not tell
what vehicles are like, version 3 knew no places between junctions or beside the road; all are read
as they stand.
Versions 1 and 2 held each vehicle's legs, and version 1 no times; both are read by
`older_versions`.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any, TypeVar

from ..costs.share import Share
from ..errors import ScenarioError, brief
from ..vehicles.profile import Vehicle
from .bill import Bill
from .chances import Chances
from .fleet import FleetRecord
from .gain import GainSharing
from .older_versions import OLDER_VERSIONS, fields_of_older
from .proof import Proof
from .records import (
    WHOLE,
    Event,
    Line,
    MasterTried,
    NetworkIdentity,
    PlannedTrip,
    Platoon,
    PlatoonPoint,
    SoloRoute,
    Span,
    Stop,
    Stretch,
)
from .rotation import Rotation
from .timetable import Timetable

__all__ = ["PLAN_VERSION", "plan_from_dict"]

PLAN_VERSION = 8

RECORDS = (3, 4, 5, 6, 7, PLAN_VERSION)
"""Versions that are the record itself; what a later one added has a default."""

Made = TypeVar("Made")


def plan_from_dict(make: Callable[..., Made], data: Mapping[str, Any]) -> Made:
    """Return the plan that plain JSON types describe.

    Parameters
    ----------
    make : callable
        `Plan`, or whatever takes its fields by name.
    data : mapping
        Of this version or an older one.

    Returns
    -------
    Plan
        What `make` made.

    Raises
    ------
    ScenarioError
        Another version of the format, not a plan at all, or one whose parts do not fit.
    """
    found = data.get("plan_version") if isinstance(data, Mapping) else None
    if isinstance(found, bool) or found not in (*OLDER_VERSIONS, *RECORDS):
        raise ScenarioError(
            f"plan: format version {brief(found)}, this version reads up to "
            f"{PLAN_VERSION}; plan again"
        )
    try:
        own = {name: value for name, value in data.items() if name != "plan_version"}
        fields = _fields(own) if found in RECORDS else fields_of_older(own)
        return make(
            **{
                **fields,
                "network": NetworkIdentity(**own["network"]),
                "remarks": tuple(own["remarks"]),
                "credits": tuple(own.get("credits", ())),
                "closed": tuple(own.get("closed", ())),
                "timetable": _part(Timetable.from_dict, own.get("timetable")),
                "bill": _part(Bill.from_dict, own.get("bill")),
                "gain": _part(GainSharing.from_dict, own.get("gain")),
                "chances": _part(Chances.from_dict, own.get("chances")),
                "rotation": _part(Rotation.from_dict, own.get("rotation")),
                "fleet": _part(FleetRecord.from_dict, own.get("fleet")),
            }
        )
    except (KeyError, TypeError, ValueError, AttributeError, IndexError) as error:
        raise ScenarioError(f"plan: {error} does not fit; it is damaged, plan again") from error


def _part(make: Callable[[Mapping[str, Any]], Made], data: Any) -> Made | None:
    return None if data is None else make(data)


def _fields(data: Mapping[str, Any]) -> dict[str, Any]:
    return {
        **data,
        "trips": tuple(_trip(item) for item in data["trips"]),
        "stretches": tuple(_stretch(item) for item in data["stretches"]),
        "ways": tuple(tuple(way) for way in data["ways"]),
        "platoons": tuple(
            Platoon(**{**item, "vehicles": tuple(item["vehicles"])}) for item in data["platoons"]
        ),
        "events": tuple(_event(item) for item in data["events"]),
        "masters": tuple(MasterTried(**item) for item in data.get("masters", ())),
        "proof": Proof(**{**data["proof"], "conditions": tuple(data["proof"]["conditions"])}),
    }


def _trip(data: Mapping[str, Any]) -> PlannedTrip:
    return PlannedTrip(
        **{
            **data,
            "origin": Stop(**data["origin"]),
            "destination": Stop(**data["destination"]),
            "profile": _profile(data.get("profile")),
            "alone": SoloRoute(
                **{
                    **data["alone"],
                    "edges": tuple(data["alone"]["edges"]),
                    "span": _span(data["alone"]),
                    "access": tuple(map(_line, data["alone"].get("access", (None, None)))),
                    "terms": tuple(data["alone"].get("terms", ())),
                }
            ),
        }
    )


def _profile(data: Any) -> Vehicle | None:
    return None if data is None else Vehicle(**data)


def _stretch(data: Mapping[str, Any]) -> Stretch:
    return Stretch(
        **{
            **data,
            "edges": tuple(data["edges"]),
            "vehicles": tuple(data["vehicles"]),
            "shares": tuple(_share(item) for item in data["shares"]),
            "span": _span(data),
            "access": _line(data.get("access")),
        }
    )


def _share(data: Mapping[str, Any]) -> Share:
    terms = {name: tuple(data.get(name, ())) for name in ("terms", "alone_terms")}
    return Share(**{**data, **terms})


def _span(data: Mapping[str, Any]) -> Span:
    begin, end = data.get("span", WHOLE)
    return begin, end


def _line(data: Any) -> Line | None:
    if data is None:
        return None
    (lon, lat), (to_lon, to_lat) = data
    return (lon, lat), (to_lon, to_lat)


def _event(data: Mapping[str, Any]) -> Event:
    return Event(
        **{
            **data,
            "point": PlatoonPoint(**data["point"]),
            "movers": tuple(data["movers"]),
            "others": tuple(data["others"]),
        }
    )
