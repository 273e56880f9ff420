"""A plan as plain JSON types, and back; docs/plan.schema.json describes the form.

Version 3 is the record itself. Versions 1 and 2 held each vehicle's legs, and version 1 no times;
both are read by `older_versions`.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any, TypeVar

from ..costs.share import Share
from ..errors import ScenarioError, brief
from .older_versions import OLDER_VERSIONS, fields_of_older
from .proof import Proof
from .records import (
    Event,
    NetworkIdentity,
    PlannedTrip,
    Platoon,
    PlatoonPoint,
    SoloRoute,
    Stop,
    Stretch,
)
from .timetable import Timetable

__all__ = ["PLAN_VERSION", "plan_from_dict"]

PLAN_VERSION = 3

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
    if isinstance(found, bool) or found not in (*OLDER_VERSIONS, PLAN_VERSION):
        raise ScenarioError(
            f"plan: format version {brief(found)}, this version reads up to "
            f"{PLAN_VERSION}; plan again"
        )
    try:
        own = {name: value for name, value in data.items() if name != "plan_version"}
        fields = _fields(own) if found == PLAN_VERSION else fields_of_older(own)
        table = own.get("timetable")
        return make(
            **{
                **fields,
                "network": NetworkIdentity(**own["network"]),
                "remarks": tuple(own["remarks"]),
                "timetable": None if table is None else Timetable.from_dict(table),
            }
        )
    except (KeyError, TypeError, ValueError, AttributeError, IndexError) as error:
        raise ScenarioError(f"plan: {error} does not fit; it is damaged, plan again") from error


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
        "proof": Proof(**{**data["proof"], "conditions": tuple(data["proof"]["conditions"])}),
    }


def _trip(data: Mapping[str, Any]) -> PlannedTrip:
    return PlannedTrip(
        **{
            **data,
            "origin": Stop(**data["origin"]),
            "destination": Stop(**data["destination"]),
            "alone": SoloRoute(**{**data["alone"], "edges": tuple(data["alone"]["edges"])}),
        }
    )


def _stretch(data: Mapping[str, Any]) -> Stretch:
    return Stretch(
        **{
            **data,
            "edges": tuple(data["edges"]),
            "vehicles": tuple(data["vehicles"]),
            "shares": tuple(Share(**item) for item in data["shares"]),
        }
    )


def _event(data: Mapping[str, Any]) -> Event:
    return Event(
        **{
            **data,
            "point": PlatoonPoint(**data["point"]),
            "movers": tuple(data["movers"]),
            "others": tuple(data["others"]),
        }
    )
