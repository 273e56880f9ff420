"""A plan as tidy tables of pandas: one row for each thing, units in the names of columns."""

from __future__ import annotations

from collections.abc import Iterator
from datetime import timedelta
from typing import TYPE_CHECKING, Any

from ..errors import ScenarioError, brief
from .convoys import convoys_of
from .law_lines import place_text
from .money_frames import MONEY_FRAMES
from .paid import paid
from .pauses import Pause
from .plan import Plan
from .positions import positions_of
from .standing import standing
from .vehicles import saved_share

if TYPE_CHECKING:
    import pandas

__all__ = ["FRAMES", "to_frame"]

Row = dict[str, Any]


def to_frame(plan: Plan, what: str = "vehicles") -> pandas.DataFrame:
    """Return a plan as a table.

    Parameters
    ----------
    plan : Plan
        Any.
    what : str
        "vehicles": one row for each vehicle; "stretches": for each vehicle on each stretch of one
        company; "points": for each start, merge, separation and destination; "positions": for each
        vehicle and position in a company; "timetable": for each vehicle on each stretch, with its
        times; "pauses": for each time that a vehicle stands on its way; "platoons": for each
        platoon, from where it forms to where it parts; "bill": for each vehicle and what it pays
        for; "gain": for each vehicle and its share; "chances": for each merge.

    Returns
    -------
    pandas.DataFrame
        Columns end in their unit: `_km`, `_h`, `_l`, `_min`, `_deg`, and for costs that of the
        plan, `_m_eq` for metre-equivalents.

    Raises
    ------
    ScenarioError
        Another table, the timetable or pauses of a plan without times, or bill, gain or chances of
        a plan without.
    """
    import pandas as pd

    if not isinstance(what, str) or what not in FRAMES:
        raise ScenarioError(f"frame {brief(what)} is unknown; use one of {', '.join(FRAMES)}")
    if what in TIMED and plan.timetable is None:
        raise ScenarioError("frame: the plan has no times; give a trip earliest_departure, say")
    if what in MONEY_FRAMES and getattr(plan, what) is None:
        raise ScenarioError(f"frame: the plan has no {what}; {NEEDED[what]}")
    rows = list(FRAMES[what](plan))
    return pd.DataFrame(rows, columns=None if rows else _columns(plan, what))


def _columns(plan: Plan, what: str) -> list[str] | None:
    """Return the columns of a table that may have no rows."""
    if what != "platoons":
        return TIMED.get(what)
    times = ["forms", "parts"] if plan.timetable is not None else []
    return [*PLATOONS, *times, "road_km", "vehicle_km", f"saving_{_cost(plan)}"]


def _cost(plan: Plan) -> str:
    return "m_eq" if plan.unit == "m" else plan.unit


def _vehicles(plan: Plan) -> Iterator[Row]:
    unit = _cost(plan)
    for index, one in enumerate(plan.vehicles):
        alone, joint = paid(plan, (index,))
        yield {
            "vehicle": one.vehicle,
            "role": one.role,
            "origin": one.origin.name,
            "destination": one.destination.name,
            "length_km": one.length_m / 1000,
            "alone_length_km": one.alone.length_m / 1000,
            "platoon_km": one.platoon_m / 1000,
            "driving_h": one.time_s / 3600,
            "alone_driving_h": one.alone.time_s / 3600,
            "fuel_l": one.fuel_l,
            "alone_fuel_l": one.alone.fuel_l,
            f"cost_{unit}": joint,
            f"alone_cost_{unit}": alone,
            "saving_share": saved_share(joint, alone),
            "inferred_km": one.inferred_m / 1000,
            "reason": one.reason,
        }


def _stretches(plan: Plan) -> Iterator[Row]:
    unit = _cost(plan)
    for index, (one, way) in enumerate(zip(plan.vehicles, plan.ways, strict=True)):
        begin = 0.0
        for number, (leg, stretch) in enumerate(zip(one.legs, way, strict=True), 1):
            company = plan.stretches[stretch].vehicles
            yield {
                "vehicle": one.vehicle,
                "leg": number,
                "stretch": stretch,
                "role": leg.role,
                "position": company.index(index) + 1,
                "company_size": len(company),
                "begins_km": begin / 1000,
                "length_km": leg.length_m / 1000,
                "driving_h": leg.time_s / 3600,
                "fuel_l": leg.fuel_l,
                f"cost_{unit}": leg.cost,
                f"alone_cost_{unit}": leg.alone_cost,
                "inferred_km": leg.inferred_m / 1000,
            }
            begin += leg.length_m


def _points(plan: Plan) -> Iterator[Row]:
    for one in plan.vehicles:
        for kind, point, km in (
            ("start", one.origin, 0.0),
            ("merge", one.merge, one.merge and one.merge.km),
            ("separation", one.separation, one.separation and one.separation.km),
            ("destination", one.destination, one.length_m / 1000),
        ):
            if point is not None:
                yield {
                    "vehicle": one.vehicle,
                    "kind": kind,
                    "name": point.name,
                    "at_km": km,
                    "lon_deg": point.lon,
                    "lat_deg": point.lat,
                    "node": point.node,
                }


def _positions(plan: Plan) -> Iterator[Row]:
    clock = plan.timetable.clock.start if plan.timetable is not None else None
    for span in positions_of(plan):
        row: Row = {
            "vehicle": plan.trips[span.vehicle].vehicle,
            "position": span.position,
            "company_size": span.size,
            "from_km": span.from_m / 1000,
            "to_km": span.to_m / 1000,
            "place": span.place,
        }
        if clock is not None and span.start_s is not None and span.end_s is not None:
            row["start"] = clock + timedelta(seconds=span.start_s)
            row["end"] = clock + timedelta(seconds=span.end_s)
        yield row


def _timetable(plan: Plan) -> Iterator[Row]:
    assert plan.timetable is not None
    # Seconds count from a moment with a fixed offset, so sums of them never pass a clock change.
    start = plan.timetable.clock.start
    for one, times, way in zip(plan.vehicles, plan.timetable.vehicles, plan.ways, strict=True):
        spans = zip(one.legs, times.legs, times.waits, way, strict=True)
        stands = standing(times)
        for number, (leg, (begin, end), wait, stretch) in enumerate(spans, 1):
            before = [pause for pause in stands if pause.before == number - 1]
            places = (place_text(pause.place) for pause in before if pause.place)
            yield {
                "vehicle": one.vehicle,
                "leg": number,
                "stretch": stretch,
                "role": leg.role,
                "wait_before_min": wait / 60,
                "pause_purposes": ", ".join(dict.fromkeys(map(_purposes, before))),
                "pause_place": ", ".join(dict.fromkeys(places)),
                "start": start + timedelta(seconds=begin),
                "end": start + timedelta(seconds=end),
                "late_min": times.late_s / 60 if number == len(way) else 0.0,
            }


def _purposes(pause: Pause) -> str:
    return ", ".join(pause.purposes)


def _pauses(plan: Plan) -> Iterator[Row]:
    assert plan.timetable is not None
    start = plan.timetable.clock.start
    for one, times in zip(plan.vehicles, plan.timetable.vehicles, strict=True):
        for pause in standing(times):
            place = pause.place
            yield {
                "vehicle": one.vehicle,
                "before_leg": pause.before + 1,
                "purpose": pause.purposes[0],
                "purposes": _purposes(pause),
                "start": start + timedelta(seconds=pause.start_s),
                "end": start + timedelta(seconds=pause.end_s),
                "lasts_min": pause.duration_s / 60,
                "at_km": sum(leg.length_m for leg in one.legs[: pause.before]) / 1000,
                "place": place.name if place else "",
                "place_kind": place.kind if place else "",
                "lon_deg": place.lon if place else None,
                "lat_deg": place.lat if place else None,
                "beside_km": place.beside_m / 1000 if place else None,
                "capacity": place.capacity if place else None,
            }


def _platoons(plan: Plan) -> Iterator[Row]:
    unit = _cost(plan)
    clock = plan.timetable.clock.start if plan.timetable is not None else None
    for number, one in enumerate(convoys_of(plan), 1):
        row: Row = {
            "platoon": number,
            "vehicles": ", ".join(plan.trips[vehicle].vehicle for vehicle in one.vehicles),
            "size": len(one.vehicles),
            "largest_company": one.largest,
            "forms_at": one.forms,
            "parts_at": one.parts,
        }
        if clock is not None and one.begins_s is not None and one.ends_s is not None:
            row["forms"] = clock + timedelta(seconds=one.begins_s)
            row["parts"] = clock + timedelta(seconds=one.ends_s)
        yield {
            **row,
            "road_km": one.road_m / 1000,
            "vehicle_km": one.vehicle_m / 1000,
            f"saving_{unit}": one.saving,
        }


PLATOONS = ("platoon", "vehicles", "size", "largest_company", "forms_at", "parts_at")

TIMED = {
    "timetable": None,
    "pauses": [
        "vehicle", "before_leg", "purpose", "purposes", "start", "end", "lasts_min", "at_km",
        "place", "place_kind", "lon_deg", "lat_deg", "beside_km", "capacity",
    ],
}  # fmt: skip
"""Tables of plans with times, and the columns of those that may have no rows."""

NEEDED = {
    "bill": 'plan with costs in money, as money_costs("eu")',
    "gain": "plan with costs in money and share it, as share_gain does",
    "chances": "plan with times and delays",
}
"""What a plan needs to have a table."""

FRAMES = {
    "vehicles": _vehicles,
    "stretches": _stretches,
    "points": _points,
    "positions": _positions,
    "timetable": _timetable,
    "pauses": _pauses,
    "platoons": _platoons,
    **MONEY_FRAMES,
}
"""What a plan can be shown as, by name."""
