"""A plan as a table that can be read aloud."""

from __future__ import annotations

from .clock import MENTIONED_S, duration
from .plan import Plan
from .records import Line
from .timetable import Timetable, VehicleTimes
from .vehicles import VehiclePlan

__all__ = ["kilometre_equivalents", "summary"]

CASE_TITLES = {
    "A": "members merge and stay",
    "B": "start together, separate on the way",
    "C": "merge and separate on the way",
    "D": "two vehicles, both routes free",
}


def summary(plan: Plan) -> str:
    """Return the plan as text: one row a vehicle, then totals, points and what is proved.

    Parameters
    ----------
    plan : Plan
        Any.

    Returns
    -------
    str
        Lines of plain text.
    """
    header: tuple[str, ...] = (
        "vehicle", "from", "to", "role", "alone", "joint", "saving", "platoon",
    )  # fmt: skip
    rows: list[tuple[str, ...]] = [_row(plan, vehicle) for vehicle in plan.vehicles]
    total: tuple[str, ...] = (
        "total", "", "", "", kilometre_equivalents(plan, plan.solo_cost),
        kilometre_equivalents(plan, plan.joint_cost), f"{plan.saving:.1%}",
        f"{plan.platoon_m / 1000:,.0f} km",
    )  # fmt: skip
    if (timetable := plan.timetable) is not None:
        header += ("leaves", "arrives", "waits")
        rows = [
            row + _times(timetable, times)
            for row, times in zip(rows, timetable.vehicles, strict=True)
        ]
        total += ("", "", duration(timetable.waiting_s))
    table = [header, *rows, total]
    width = [max(len(row[k]) for row in table) for k in range(len(header))]
    right = {4, 5, 6, 7, 10}

    def line(row: tuple[str, ...]) -> str:
        cells = (
            text.rjust(width[k]) if k in right else text.ljust(width[k])
            for k, text in enumerate(row)
        )
        return "  ".join(cells).rstrip()

    rule = "-" * len(line(tuple("x" * w for w in width)))
    unit = "km-equivalents" if plan.unit == "m" else plan.unit
    lines = [
        f"Case {plan.case}: {CASE_TITLES[plan.case]}; costs in {unit}", "",
        line(header), rule, *(line(row) for row in rows), rule, line(total), "",
    ]  # fmt: skip
    if timetable is not None:
        day = timetable.clock.start.date().isoformat()
        lines.append(f"Times are of {day}, {timetable.clock.zone}.")
    for vehicle, times in zip(plan.vehicles, plan.times, strict=True):
        lines += _events(vehicle, timetable, times)
    lines += [line for vehicle in plan.vehicles for line in _access(vehicle)]
    lines.append(_proof(plan))
    lines += [f"Note: {remark}" for remark in plan.remarks]
    return "\n".join(lines)


def kilometre_equivalents(plan: Plan, cost: float) -> str:
    """Return a cost as people read it: metre-equivalents as km, money with two digits.

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
    return f"{cost / 1000:,.0f}" if plan.unit == "m" else f"{cost:,.2f}"


def _row(plan: Plan, vehicle: VehiclePlan) -> tuple[str, ...]:
    return (
        vehicle.vehicle, vehicle.origin.name, vehicle.destination.name, vehicle.role,
        kilometre_equivalents(plan, vehicle.solo_cost),
        kilometre_equivalents(plan, vehicle.joint_cost),
        f"{vehicle.saving:.1%}", f"{vehicle.platoon_m / 1000:,.0f} km",
    )  # fmt: skip


def _times(timetable: Timetable, times: VehicleTimes) -> tuple[str, ...]:
    leaves, arrives = (timetable.clock.text(at) for at in (times.departure_s, times.arrival_s))
    return leaves, arrives, duration(times.waiting_s)


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
            if times.waits[places[0]] >= MENTIONED_S:
                merges += f" after waiting {duration(times.waits[places[0]])}"
        return [
            f"{vehicle.vehicle} merges with {' and '.join(partners)} at {vehicle.merge.name} "
            f"(its km {vehicle.merge.km:,.0f}{merges}), separates at {vehicle.separation.name} "
            f"(its km {vehicle.separation.km:,.0f}{separates})"
        ]
    return [f"{vehicle.vehicle} stays alone: {vehicle.reason}"] if vehicle.role == "alone" else []


def _access(vehicle: VehiclePlan) -> list[str]:
    """Tell of the ways between the road and places beside it, if a vehicle has some."""
    ways = []
    for place, leg in enumerate(vehicle.legs):
        if leg.role == "access":
            side = "to" if place == 0 and leg.access and _starts_at(vehicle, leg.access) else "from"
            ways.append(f"{leg.length_m / 1000:,.1f} km {side} {leg.access_at}")
    if not ways:
        return []
    return [f"{vehicle.vehicle}: access {' and '.join(ways)}, a straight line with a detour"]


def _starts_at(vehicle: VehiclePlan, line: Line) -> bool:
    return line[0] == (vehicle.origin.lon, vehicle.origin.lat)


def _proof(plan: Plan) -> str:
    kind = plan.proof.get("kind")
    conditions = "; ".join(plan.proof.get("conditions", ()))
    if kind == "exact":
        return f"Proved optimal ({conditions})."
    if kind == "bound":
        return f"At most {plan.proof['gap']:.3%} above the optimum ({conditions})."
    excess = plan.proof["excess"]
    side = "above" if excess >= 0 else "below"
    return (
        f"Found by the paper's inflated A*: {abs(excess):.2%} {side} the optimum ({conditions}); "
        f"its routes alone cost {plan.proof['solo_excess']:.2%} above the least."
    )
