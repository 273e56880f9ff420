"""What the vehicles of a plan are like, as its roads were chosen for: size, mass and load."""

from __future__ import annotations

from ...plans.plan import Plan
from ...plans.vehicles import by_profile
from ...vehicles.profile import Vehicle
from ..language.speech import number, say
from .wording import joined

__all__ = ["profile_rows"]


def profile_rows(plan: Plan) -> list[str]:
    """Return each kind of vehicle of a plan in a line.

    Parameters
    ----------
    plan : Plan
        Any; plans of older versions do not tell.

    Returns
    -------
    list of str
        One if all are alike, else with the names of those that are.
    """
    kinds = by_profile(plan.trips)
    if len(kinds) == 1:
        return [_told(kind) for kind in kinds]
    return [
        say("profile.who", vehicles=joined(names), profile=_told(kind))
        for kind, names in kinds.items()
    ]


def _told(vehicle: Vehicle) -> str:
    parts = [
        say(
            "profile.told",
            name=vehicle.name,
            height=_figure(vehicle.height_m),
            width=_figure(vehicle.width_m),
            length=_figure(vehicle.length_m),
            mass=_figure(vehicle.mass_t),
            axle=_figure(vehicle.axle_load_t),
        )
    ]
    if vehicle.permitted_t != vehicle.mass_t:
        parts.append(say("profile.rated", mass=_figure(vehicle.permitted_t)))
    if vehicle.hazardous:
        parts.append(say("profile.goods", code=vehicle.tunnel_code))
    if vehicle.limiter_kmh is None:
        parts.append(say("profile.no-limiter"))
    else:
        parts.append(say("profile.limiter", speed=_figure(vehicle.limiter_kmh)))
    return ", ".join(parts)


def _figure(value: float) -> str:
    """Return a size with as many decimals as it has, two at most."""
    decimals = next((k for k in (0, 1) if round(value, k) == round(value, 2)), 2)
    return number(value, decimals)
