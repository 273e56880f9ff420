"""One vehicle as pages show it: what it is called, where it drives, what that costs and when."""

from __future__ import annotations

from ...plans.paid import paid
from ...plans.records import Stop as PlannedStop
from ...plans.vehicles import VehiclePlan, saved_share
from ...shown_text import fitted
from ..language.plan_sentences import in_language
from ..language.speech import say
from ..markup.quantities import kilometres
from .bill_parts import stood_cents
from .driver_fatigue import fatigue_along
from .findings import Findings
from .model_vehicle import Stop, Vehicle, VehicleTexts
from .timeline import vehicle_day
from .wording import cost_texts, joined

__all__ = ["role_text", "vehicle"]

LAST_DIGITS = 1e-9
"""Share of a cost to which sums of the same roads agree, whatever their order."""

ROLES = {"master": "vehicle.master", "member": "vehicle.member", "alone": "vehicle.alone"}


def role_text(role: str) -> str:
    """Return what a vehicle of a plan does, in words.

    Parameters
    ----------
    role : str
        Of the plan.

    Returns
    -------
    str
        In the language that is spoken; a role that has no text is told as it is.
    """
    return say(ROLES[role]) if role in ROLES else fitted(role)


def vehicle(found: Findings, index: int) -> Vehicle:
    """Return one vehicle of a plan.

    Parameters
    ----------
    found : Findings
        Of the plan.
    index : int
        Its position in the plan.

    Returns
    -------
    Vehicle
        All that pages show of it.
    """
    plan, unit, own = found.plan, found.unit, found.plan.vehicles[index]
    style = found.styles[index]
    solo_cost, joint_cost = paid(plan, (index,))
    saved = solo_cost - joint_cost
    detour = platoon_gain = None
    alone = [leg.alone_cost for leg in own.legs if leg.alone_cost is not None]
    if len(alone) == len(own.legs):
        # saved = gain of the platoon on the way driven - what that way costs more alone
        detour = sum(alone) - own.solo_cost
        # The last digits of two sums of the same roads are no detour.
        detour = detour if detour > LAST_DIGITS * own.solo_cost else 0.0
        if plan.bill is not None:
            # To the cent, as all that is printed; standing for company costs as a longer way does.
            detour = round(detour, 2) + max(stood_cents(plan.bill, index), 0) / 100
        platoon_gain = saved + detour
    name = fitted(own.vehicle)
    # Whose route nobody joins is no master.
    role = own.role if any(leg.role == "platoon" for leg in own.legs) else "alone"
    costs = cost_texts(solo_cost, joint_cost, unit)
    inferred_m = own.inferred_m
    return Vehicle(
        name=name if name != style.letter else "",
        letter=style.letter,
        colour=style.colour,
        dash=style.dash,
        cap=style.cap,
        role=role,
        role_text=role_text(role),
        origin=_stop(found, own.origin),
        destination=_stop(found, own.destination),
        length_m=own.length_m,
        length_text=kilometres(own.length_m),
        alone_length_m=own.alone.length_m,
        platoon_m=own.platoon_m,
        inferred_m=inferred_m,
        inferred_text=kilometres(inferred_m) if inferred_m > 0 else "",
        access_m=own.access_m,
        access_text=_access(own),
        fuel_l=own.fuel_l,
        alone_fuel_l=own.alone.fuel_l,
        solo_cost=solo_cost,
        joint_cost=joint_cost,
        saved=saved,
        saving=saved_share(joint_cost, solo_cost),
        platoon_gain=platoon_gain,
        detour=detour,
        reason=fitted(in_language(own.reason)),
        way=found.ways[index],
        text=VehicleTexts(
            costs.alone,
            costs.joint,
            costs.saved,
            costs.share,
            gain="" if platoon_gain is None else unit.bare(platoon_gain),
            detour="" if detour is None else unit.bare(detour),
        ),
        fatigue=fatigue_along(own, plan.times[index]),
        times=vehicle_day(plan, index),
    )


def _access(own: VehiclePlan) -> str:
    """Return the ways between the road and places beside it: "4.2 km to A 4 exit Novara Est"."""
    return joined(
        [
            say(
                "vehicle.to-road" if place == 0 else "vehicle.from-road",
                km=kilometres(leg.length_m),
                place=fitted(leg.access_at),
            )
            for place, leg in enumerate(own.legs)
            if leg.role == "access"
        ]
    )


def _stop(found: Findings, stop: PlannedStop) -> Stop:
    return Stop(round(found.longitude(stop.lon), 6), round(stop.lat, 6), fitted(stop.name))
