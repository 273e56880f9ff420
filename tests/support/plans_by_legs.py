"""Plans put together from what each vehicle drives, as older versions stored them."""

from dataclasses import replace

from platoon_osm.plans.older_versions import fields_of_vehicles
from platoon_osm.plans.plan import Plan
from platoon_osm.plans.proof import Proof


def plan_of(vehicles, conditions=(), **fields):
    """A plan of some vehicles; what is not given is that of an empty, exact plan."""
    case, params = fields.get("case", "C"), fields.get("params", {})
    cost = sum(vehicle.joint_cost for vehicle in vehicles)
    values = {
        "case": case, "asked": case, "objective": "member", "method": "dijkstra", "unit": "m",
        "params": params, "proof": Proof("exact", cost, cost, tuple(conditions)),
    }  # fmt: skip
    return Plan(**{**values, **fields_of_vehicles(vehicles, case, params), **fields})


def with_vehicles(plan, vehicles):
    """The same plan for other vehicles, who may break it."""
    return replace(plan, **fields_of_vehicles(vehicles, plan.case, plan.params))


def silent_about_alone(plan):
    """The same plan, as an older version with other costs than the paper's told it."""
    stretches = tuple(
        replace(one, shares=tuple(replace(share, alone_cost=None) for share in one.shares))
        if one.together
        else one
        for one in plan.stretches
    )
    return replace(plan, stretches=stretches)
