"""Conditions about the vehicle itself: "weight>7.5", "length>=12 m", "trailer", "hgv", "wet".

A comparison is with what the vehicle is: weight with its mass as it drives, rating with its
permitted mass. Masses without a unit are tonnes, lengths metres, as everywhere on the map. What our
vehicles do not tell (the number of axles, the weather) is neither true nor false.
"""

from __future__ import annotations

import operator
import re
from collections.abc import Callable

from .profile import Vehicle
from .units import FOOT_M, INCH_M, LONG_TON_T, POUND_T, SHORT_TON_T

__all__ = ["Asked", "asked_of"]

Asked = Callable[[Vehicle], bool | None]
"""A question: true, false, or None if the vehicle does not tell."""


def _always(answer: bool | None) -> Asked:
    def of(vehicle: Vehicle) -> bool | None:
        del vehicle
        return answer

    return of


SIZES: dict[str, tuple[str, Callable[[Vehicle], float]]] = {
    "weight": ("t", lambda vehicle: vehicle.mass_t),
    "maxweight": ("t", lambda vehicle: vehicle.mass_t),
    "weightrating": ("t", lambda vehicle: vehicle.permitted_t),
    "weight_rating": ("t", lambda vehicle: vehicle.permitted_t),
    "maxweightrating": ("t", lambda vehicle: vehicle.permitted_t),
    "gvwr": ("t", lambda vehicle: vehicle.permitted_t),
    "axleload": ("t", lambda vehicle: vehicle.axle_load_t),
    "axle_load": ("t", lambda vehicle: vehicle.axle_load_t),
    "maxaxleload": ("t", lambda vehicle: vehicle.axle_load_t),
    "length": ("m", lambda vehicle: vehicle.length_m),
    "maxlength": ("m", lambda vehicle: vehicle.length_m),
    "width": ("m", lambda vehicle: vehicle.width_m),
    "maxwidth": ("m", lambda vehicle: vehicle.width_m),
    "height": ("m", lambda vehicle: vehicle.height_m),
    "maxheight": ("m", lambda vehicle: vehicle.height_m),
    "trailers": ("", lambda vehicle: float(vehicle.trailer)),
}
"""What is compared, in which unit, and where a vehicle tells it."""

UNITS = {
    "t": 1.0, "mt": 1.0, "kg": 1e-3, "st": SHORT_TON_T, "lt": LONG_TON_T,
    "lb": POUND_T, "lbs": POUND_T,
    "m": 1.0, "cm": 0.01, "ft": FOOT_M, "in": INCH_M,
}  # fmt: skip
"""Tonnes or metres of a unit."""

MASSES = frozenset({"t", "mt", "kg", "st", "lt", "lb", "lbs"})

SIGNS: dict[str, Callable[[float, float], bool]] = {
    "<": operator.lt, "<=": operator.le, ">": operator.gt, ">=": operator.ge,
    "=": operator.eq, "==": operator.eq, "≤": operator.le, "≥": operator.ge,
}  # fmt: skip

COMPARED = re.compile(r"([a-z_]+)\s*(<=|>=|==|<|>|=|≤|≥)\s*(.+)")
NUMBER = re.compile(r"(\d+(?:[.,]\d+)?)\s*([a-z]*)")
FEET = re.compile(r"(\d+(?:\.\d+)?)\s*(?:'|ft)\s*(?:(\d+(?:\.\d+)?)\s*(?:\"|''|in)?)?")

NEVER = frozenset({
    "bus", "buses", "psv", "taxi", "tourist_bus", "coach", "share_taxi", "minibus", "motorcar",
    "car", "motorcycle", "moped", "mofa", "bicycle", "foot", "horse", "motorhome", "caravan",
    "hov", "emergency", "agricultural", "forestry", "disabled", "military", "car_sharing",
    "public_transport", "trolleybus", "tram", "school_bus", "golf_cart", "atv", "snowmobile",
    "official", "employees", "staff", "residential_permit", "carpool",
})  # fmt: skip
"""Kinds of users that a goods vehicle is not."""

ALWAYS = frozenset({"motor_vehicle", "vehicle", "motorized", "access"})

WEATHER = frozenset({
    "wet", "snow", "ice", "icy", "winter", "summer", "fog", "rain", "raining", "flood", "flooding",
    "high_water", "high_tide", "low_tide", "smoke", "dry", "wind", "storm", "avalanche", "frost",
    "snowfall", "children", "school", "event", "events", "smog", "ozone", "traffic_jam",
})  # fmt: skip
"""What nobody knows when planning."""


def asked_of(condition: str) -> Asked | None:
    """Return what a condition asks of a vehicle.

    Parameters
    ----------
    condition : str
        Without brackets around it.

    Returns
    -------
    callable or None
        Answers for a vehicle; None for a condition that asks neither about vehicles nor weather.
    """
    text = condition.strip().lower()
    if text in NEVER:
        return _always(False)
    if text in ALWAYS:
        return _always(True)
    if text in WEATHER:
        return _always(None)
    if text in ("hgv", "heavy_goods", "hgv_articulated"):
        articulated = text == "hgv_articulated"
        return lambda vehicle: vehicle.heavy and (vehicle.trailer or not articulated)
    if text == "goods":
        return lambda vehicle: not vehicle.heavy
    if text in ("trailer", "hgv:trailer", "trailer=yes"):
        return lambda vehicle: vehicle.trailer
    if text in ("!trailer", "trailer=no"):
        return lambda vehicle: not vehicle.trailer
    if text in ("hazmat", "hazmat=yes", "dangerous_goods"):
        return lambda vehicle: vehicle.hazardous
    found = COMPARED.fullmatch(text)
    return None if found is None else _comparison(*found.groups())


def _comparison(name: str, sign: str, number: str) -> Asked | None:
    if name == "occupants":
        # Lanes for shared rides ask for two or three; a driver may be alone.
        return _always(False)
    if name not in SIZES:
        return _always(None) if name == "axles" else None
    unit, size = SIZES[name]
    limit = _number(number, unit)
    if limit is None:
        return None
    compare = SIGNS[sign]

    return lambda vehicle: compare(size(vehicle), limit)


def _number(text: str, unit: str) -> float | None:
    """Return a number in tonnes or metres; None if it is none of them."""
    text = text.strip()
    if unit == "m" and (feet := FEET.fullmatch(text)):
        return float(feet[1]) * FOOT_M + float(feet[2] or 0) * INCH_M
    found = NUMBER.fullmatch(text)
    if found is None:
        return None
    own = found[2] or unit
    if own and (own not in UNITS or not unit or (own in MASSES) != (unit == "t")):
        return None
    return float(found[1].replace(",", ".")) * UNITS.get(own, 1.0)
