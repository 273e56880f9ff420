"""A plan as a table that can be read aloud."""

from __future__ import annotations

from collections.abc import Callable, Sequence

from ..driving.rules import places_pauses
from ..shown_text import fitted
from .bill_lines import bill_lines
from .chance_lines import chance_lines
from .clock import MENTIONED_S, duration
from .cost_decimals import cost_decimals
from .credits import credits_of
from .fleet_lines import fleet_lines
from .lateness import NOT_FEASIBLE, NOT_IN_TIME, status_lines
from .law_lines import law_lines, place_text
from .lead_lines import lead_lines
from .leading import leading_text
from .paid import paid
from .plan import Plan
from .proof_sentence import proof_sentence
from .records import Line
from .standing import rested_s, standing, waited_s
from .text_table import MOST_ROWS, listed, named, table_lines, width_of
from .timetable import Timetable, VehicleTimes
from .vehicles import VehiclePlan, by_profile, saved_share

__all__ = ["kilometre_equivalents", "summary"]

RIGHT = frozenset([*range(4, 11), 13, 14])
"""Columns of numbers."""

CASE_TITLES = {
    "A": "members merge and stay",
    "B": "start together, separate on the way",
    "C": "merge and separate on the way",
    "D": "two vehicles, both routes free",
}


def summary(plan: Plan) -> str:
    """Return the plan as text: who is late, a row a vehicle, totals, points and what is proved.

    Of a whole fleet it tells the totals and what is proved.

    Parameters
    ----------
    plan : Plan
        Any.

    Returns
    -------
    str
        Lines of plain text, however many vehicles there are not many more than a screen of them.
    """
    parts = PARTS if plan.fleet is None else FLEET_PARTS
    return "\n".join(line for part in parts for line in part(plan))


def _heading(plan: Plan) -> list[str]:
    case = f"Case {plan.case}: {CASE_TITLES.get(plan.case, 'a plan')}"
    status = [f"{line}." for line in (*map(fitted, _not_lawful(plan)), *status_lines(plan))]
    if plan.unit != "m":
        return [f"{case}; {_counted(plan)}", *status, ""]
    return [
        f"{case}; costs in km-equivalents",
        "(weighted cost: distance, time and fuel, each rescaled to km and added up)",
        *status,
        "",
    ]


def _counted(plan: Plan) -> str:
    unit = named(plan.unit)
    saving = plan.params.get("positions")
    kept = f", savings by position {named(str(saving))}" if saving else ""
    return f"costs in {unit}{kept}"


def _not_lawful(plan: Plan) -> list[str]:
    """Return the remarks on who cannot be within the law; lateness is told in figures."""
    return [
        remark
        for remark in plan.remarks
        if remark.startswith(NOT_FEASIBLE) and not remark.startswith(NOT_IN_TIME)
    ]


def _law(plan: Plan) -> list[str]:
    return _first(law_lines(plan))


def _table(plan: Plan) -> list[str]:
    header = [
        "vehicle", "from", "to", "role", "alone", "joint", "saving", "km", "litres", "hours",
        "platoon",
    ]  # fmt: skip
    every = range(len(plan.vehicles))
    rest = every[MOST_ROWS:]
    rows = [
        [named(one.vehicle), named(one.origin.name), named(one.destination.name), one.role,
         *_numbers(plan, [index])]
        for index, one in enumerate(plan.vehicles[:MOST_ROWS])
    ]  # fmt: skip
    if rest:
        rows.append([f"and {len(rest):,} more", "", "", "", *_numbers(plan, rest)])
    rows.append(["total", "", "", "", *_numbers(plan, every)])
    if (timetable := plan.timetable) is not None:
        days = timetable.vehicles
        under_rules = places_pauses(timetable.rules) or any(map(rested_s, days))
        header += ["leaves", "arrives", "waits", *(["rests"] if under_rules else [])]
        times = [_times(timetable, [one], under_rules) for one in days[:MOST_ROWS]]
        if rest:
            times.append(_times(timetable, days[MOST_ROWS:], under_rules))
        times.append(_times(timetable, days, under_rules, total=True))
        rows = [row + more for row, more in zip(rows, times, strict=True)]
    lines = table_lines([header, *rows], RIGHT)
    rule = "-" * max(map(width_of, lines))
    return [lines[0], rule, *lines[1:-1], rule, lines[-1], ""]


def _numbers(plan: Plan, some: Sequence[int]) -> list[str]:
    alone, joint = paid(plan, some)
    vehicles = [plan.vehicles[index] for index in some]
    return [
        kilometre_equivalents(plan, alone),
        kilometre_equivalents(plan, joint),
        f"{saved_share(joint, alone):.1%}",
        f"{sum(one.length_m for one in vehicles) / 1000:,.0f}",
        f"{sum(one.fuel_l for one in vehicles):,.0f}",
        f"{sum(one.time_s for one in vehicles) / 3600:,.1f}",
        f"{sum(one.platoon_m for one in vehicles) / 1000:,.0f} km",
    ]


def _alone(plan: Plan) -> list[str]:
    """Say what the same journeys take alone, for the table has them as planned."""
    alone = [one.alone for one in plan.vehicles]
    return [
        f"Alone all would drive {sum(leg.length_m for leg in alone) / 1000:,.0f} km with "
        f"{sum(leg.fuel_l for leg in alone):,.0f} litres of fuel in "
        f"{sum(leg.time_s for leg in alone) / 3600:,.1f} hours."
    ]


def _profiles(plan: Plan) -> list[str]:
    """Say what vehicles are like, as their roads were chosen for."""
    kinds = by_profile(plan.trips)
    if len(kinds) == 1:
        return [f"Vehicles: {fitted(kind.told())}." for kind in kinds]
    return _first([f"{listed(names)}: {fitted(kind.told())}." for kind, names in kinds.items()])


def _closed(plan: Plan) -> list[str]:
    return [f"Closed for this plan: {listed(plan.closed)}."] if plan.closed else []


def _day(plan: Plan) -> list[str]:
    if plan.timetable is None:
        return []
    clock = plan.timetable.clock
    return [f"Times are of {clock.start.date().isoformat()}, {clock.zone}."]


def _points(plan: Plan) -> list[str]:
    pairs = zip(plan.vehicles, plan.times, strict=True)
    return _first([
        line for vehicle, times in pairs for line in _events(vehicle, plan.timetable, times)
    ])  # fmt: skip


def _chances(plan: Plan) -> list[str]:
    return _first(chance_lines(plan))


def _access_legs(plan: Plan) -> list[str]:
    return _first([line for vehicle in plan.vehicles for line in _access(vehicle)])


def _notes(plan: Plan) -> list[str]:
    told = {*credits_of(plan), *_not_lawful(plan)}
    return _first([f"Note: {fitted(one)}" for one in plan.remarks if one not in told])


def _credits(plan: Plan) -> list[str]:
    return [f"Credits: {'; '.join(credits_of(plan))}."]


def _first(lines: Sequence[str]) -> list[str]:
    """Return the first of many lines, and how many more there are."""
    more = len(lines) - MOST_ROWS
    return [*lines[:MOST_ROWS], *([f"... and {more:,} more such lines"] if more > 0 else [])]


def kilometre_equivalents(plan: Plan, cost: float) -> str:
    """Return a cost as people read it, metre-equivalents as km, with as many decimals as on pages.

    Parameters
    ----------
    plan : Plan
        Which names the unit.
    cost : float
        In that unit.

    Returns
    -------
    str
        Without the unit.
    """
    decimals = cost_decimals(plan.unit, plan.solo_cost)
    return f"{cost / 1000 if plan.unit == 'm' else cost:,.{decimals}f}"


def _times(
    timetable: Timetable, days: Sequence[VehicleTimes], under_rules: bool, total: bool = False
) -> list[str]:
    """Return the cells of times, those of several vehicles added up."""
    cells = ["", ""]
    if len(days) == 1 and not total:
        cells = [timetable.clock.text(at) for at in (days[0].departure_s, days[0].arrival_s)]
    cells.append(duration(sum(map(waited_s, days))))
    return [*cells, duration(sum(map(rested_s, days)))] if under_rules else cells


def _events(
    vehicle: VehiclePlan, timetable: Timetable | None, times: VehicleTimes | None
) -> list[str]:
    if vehicle.merge is not None and vehicle.separation is not None:
        # Those it meets there; others may join later, and their own line says where.
        places = [k for k, leg in enumerate(vehicle.legs) if leg.role == "platoon"]
        partners = vehicle.legs[places[0]].partners
        merges = separates = ""
        if timetable is not None and times is not None:
            clock = timetable.clock
            merges = f", {clock.text(times.legs[places[0]][0])}"
            separates = f", {clock.text(times.legs[places[-1]][1])}"
            merges += _waited(times, places[0])
        return [
            f"{named(vehicle.vehicle)} merges with {listed(partners)} at "
            f"{named(vehicle.merge.name)} "
            f"(its km {vehicle.merge.km:,.0f}{merges}), separates at "
            f"{named(vehicle.separation.name)} "
            f"(its km {vehicle.separation.km:,.0f}{separates})"
        ]
    if vehicle.role != "alone":
        return []
    return [f"{named(vehicle.vehicle)} stays alone: {fitted(vehicle.reason)}"]


def _waited(times: VehicleTimes, leg: int) -> str:
    """Tell how long a vehicle waits for those with whom it begins a leg, and where if not there."""
    waits = [one for one in standing(times) if one.before <= leg and one.purposes == ("company",)]
    if not waits or waits[-1].duration_s < MENTIONED_S:
        return ""
    place = waits[-1].place
    where = f" at {place_text(place)}" if place is not None else ""
    return f" after waiting {duration(waits[-1].duration_s)}{where}"


def _access(vehicle: VehiclePlan) -> list[str]:
    """Tell of the ways between the road and places beside it, if a vehicle has some."""
    ways = []
    for place, leg in enumerate(vehicle.legs):
        if leg.role == "access":
            side = "to" if place == 0 and leg.access and _starts_at(vehicle, leg.access) else "from"
            ways.append(f"{leg.length_m / 1000:,.1f} km {side} {named(leg.access_at)}")
    if not ways:
        return []
    return [f"{named(vehicle.vehicle)}: access {' and '.join(ways)}, a straight line with a detour"]


def _starts_at(vehicle: VehiclePlan, line: Line) -> bool:
    return line[0] == (vehicle.origin.lon, vehicle.origin.lat)


def _leading(plan: Plan) -> list[str]:
    text = leading_text(plan)
    return [text] if text else []


def _lead(plan: Plan) -> list[str]:
    return _first(lead_lines(plan))


def _proof(plan: Plan) -> list[str]:
    return [proof_sentence(plan)]


PARTS: tuple[Callable[[Plan], list[str]], ...] = (
    _heading, _table, bill_lines, _alone, _profiles, _closed, _day, _law, _points, _chances,
    _access_legs, _leading, _lead, _proof, _notes, _credits,
)  # fmt: skip
"""What a summary consists of, in the order in which it is read; each part gives its lines."""

FLEET_PARTS: tuple[Callable[[Plan], list[str]], ...] = (fleet_lines, _proof, _notes, _credits)
"""The same of a whole fleet, of which single vehicles stand in tables."""
