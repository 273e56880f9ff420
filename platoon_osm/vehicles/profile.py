"""What a road asks of a vehicle: how large and heavy it is, what it carries, how fast it may be.

Usual vehicles are found by name in `VEHICLES`; a user adds one without touching the package:

    from platoon_osm.vehicles.profile import VEHICLES, Vehicle
    VEHICLES.add(Vehicle("our-milk-truck", mass_t=26, length_m=12, trailer=False))
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import asdict, dataclass, fields, replace
from types import MappingProxyType
from typing import Any

from ..errors import ScenarioError, brief
from ..kinds import is_number
from ..registry import Registry, looked_up
from .units import FOOT_M, POUND_T

__all__ = [
    "DEFAULT_VEHICLE", "LIGHT_T", "NO_VEHICLES", "TUNNEL_CODES", "VEHICLES", "Vehicle",
    "vehicle_of",
]  # fmt: skip

LIGHT_T = 3.5
"""Permitted mass up to which a goods vehicle is no heavy one (N1, Regulation (EU) 2018/858)."""

TUNNEL_CODES = ("", "B", "C", "D", "E")
"""Tunnel restriction codes of ADR, chapter 8.6; empty for a load that no tunnel is closed to."""

RANGES = {
    "height_m": (0.5, 10.0, "m"),
    "width_m": (0.5, 10.0, "m"),
    "length_m": (1.0, 60.0, "m"),
    "mass_t": (0.1, 500.0, "t"),
    "rating_t": (0.1, 500.0, "t"),
    "axle_load_t": (0.1, 50.0, "t"),
    "limiter_kmh": (3.0, 150.0, "km/h"),
}
"""Least and most that is no slip of the pen, and the unit."""


@dataclass(frozen=True, slots=True)
class Vehicle:
    """A vehicle with its load.

    Attributes
    ----------
    name : str
        What it is called.
    height_m, width_m, length_m : float
        Outer size, mirrors left out [m].
    mass_t : float
        What it weighs as it drives, load and trailer included [t].
    rating_t : float or None
        What it may weigh at most by its papers, trailer included [t]; by default what it weighs.
    axle_load_t : float
        Load of the heaviest single axle [t].
    trailer : bool
        Whether it is articulated or draws a trailer.
    tunnel_code : str
        Tunnel restriction code of dangerous goods on board, "B" to "E"; empty without such goods.
    limiter_kmh : float or None
        What its speed limiter allows [km/h]; None without one.
    emission_class : str
        Such as "euro6"; for tolls and zones.

    Raises
    ------
    ScenarioError
        A value that is none, or out of its range.

    Notes
    -----
    The sizes of the default are the largest that need no permit in the EU: Council Directive
    96/53/EC, Annex I (4.00 m, 2.55 m, 16.50 m, 40 t, 11.5 t on the driving axle). Its limiter is
    that of Directive 92/6/EEC.
    """

    name: str
    height_m: float = 4.0
    width_m: float = 2.55
    length_m: float = 16.5
    mass_t: float = 40.0
    rating_t: float | None = None
    axle_load_t: float = 11.5
    trailer: bool = True
    tunnel_code: str = ""
    limiter_kmh: float | None = 90.0
    emission_class: str = "euro6"

    def __post_init__(self) -> None:
        if not isinstance(self.name, str) or not self.name.strip():
            raise ScenarioError(f"vehicle name {brief(self.name)} must be a non-empty text")
        where = f"vehicle {self.name!r}"
        for label, (least, most, unit) in RANGES.items():
            value = getattr(self, label)
            if value is None and label in ("rating_t", "limiter_kmh"):
                continue
            if not (is_number(value) and math.isfinite(value) and least <= value <= most):
                raise ScenarioError(
                    f"{where}: {label} is {brief(value)}; give {least:g} to {most:g} {unit}"
                )
            object.__setattr__(self, label, float(value))
        if not isinstance(self.trailer, bool):
            raise ScenarioError(f"{where}: trailer is {brief(self.trailer)}; give true or false")
        code = self.tunnel_code.strip().upper() if isinstance(self.tunnel_code, str) else None
        if code not in TUNNEL_CODES:
            raise ScenarioError(
                f"{where}: tunnel_code is {brief(self.tunnel_code)}; give B, C, D or E, or nothing"
            )
        object.__setattr__(self, "tunnel_code", code)
        if not isinstance(self.emission_class, str):
            raise ScenarioError(
                f"{where}: emission_class is {brief(self.emission_class)}; give a text as 'euro6'"
            )
        if self.rating_t is not None and self.rating_t < self.mass_t:
            raise ScenarioError(
                f"{where}: it weighs {self.mass_t:g} t and may weigh {self.rating_t:g} t; "
                "give a larger rating_t or a smaller mass_t"
            )

    @property
    def permitted_t(self) -> float:
        """What it may weigh at most by its papers [t]."""
        return self.mass_t if self.rating_t is None else self.rating_t

    @property
    def heavy(self) -> bool:
        """Whether signs for heavy goods vehicles are meant for it."""
        return self.permitted_t > LIGHT_T

    @property
    def hazardous(self) -> bool:
        """Whether it carries dangerous goods."""
        return bool(self.tunnel_code)

    def told(self) -> str:
        """Return it in one line for people.

        Returns
        -------
        str
            Name, size, mass, and what is special.
        """
        parts = [
            f"{_figure(self.height_m)} m high, {_figure(self.width_m)} m wide, "
            f"{_figure(self.length_m)} m long",
            f"{_figure(self.mass_t)} t, {_figure(self.axle_load_t)} t an axle",
        ]
        if self.rating_t is not None and self.rating_t != self.mass_t:
            parts.append(f"rated {_figure(self.rating_t)} t")
        if self.tunnel_code:
            parts.append(f"dangerous goods, tunnel code {self.tunnel_code}")
        limiter = self.limiter_kmh
        parts.append("no speed limiter" if limiter is None else f"limiter {_figure(limiter)} km/h")
        return f"{self.name}, {', '.join(parts)}"

    def to_dict(self) -> dict[str, Any]:
        """Plain JSON form.

        Returns
        -------
        dict of str to object
            Every field by name.
        """
        return asdict(self)


def _figure(value: float) -> str:
    """Return a size to the centimetre, a mass to ten kilogrammes."""
    return f"{round(value, 2):g}"


KEYS = tuple(item.name for item in fields(Vehicle))

VEHICLES: Registry[Vehicle] = Registry(
    "vehicle",
    (
        # Council Directive 96/53/EC, Annex I; Directive 92/6/EEC.
        Vehicle("eu-40t"),
        # Driven by liquefied natural gas: one tonne more for its tanks (96/53/EC, article 10b, by
        # Directive (EU) 2015/719). Fuel in a vehicle's own tank is no dangerous load (ADR 1.1.3.2).
        Vehicle("eu-lng", mass_t=41.0),
        # The European modular system, neither heavier nor higher (96/53/EC, article 4(4)); mass as
        # Germany allows it (LKWUeberlStVAusnV).
        Vehicle("eu-25m", length_m=25.25),
        # 23 CFR 658.15 and .17: 102 in wide, 80,000 lb, 20,000 lb an axle; 13 ft 6 in is the usual
        # limit of the states; a tractor with a 53 ft trailer is some 72 ft long.
        Vehicle(
            "us-80k-lb",
            height_m=13.5 * FOOT_M,
            width_m=8.5 * FOOT_M,
            length_m=72 * FOOT_M,
            mass_t=80_000 * POUND_T,
            axle_load_t=20_000 * POUND_T,
            limiter_kmh=None,
            emission_class="epa2010",
        ),
        # A panel van with a high roof, at the limit of its class.
        Vehicle(
            "van-3.5t",
            height_m=2.8,
            width_m=2.1,
            length_m=7.0,
            mass_t=3.5,
            axle_load_t=2.25,
            trailer=False,
            limiter_kmh=None,
        ),
    ),
)
"""Usual vehicles by name."""

DEFAULT_VEHICLE = VEHICLES["eu-40t"]
"""What drives where nothing else is said."""

NO_VEHICLES: Mapping[str, Vehicle] = MappingProxyType({})


def vehicle_of(
    value: Any, where: str = "vehicle", own: Mapping[str, Vehicle] = NO_VEHICLES
) -> Vehicle:
    """Return a vehicle from what a user gives.

    Parameters
    ----------
    value : str, Vehicle, mapping or None
        A name of `VEHICLES` or of `own`; a vehicle; fields by name, `base` being the name of the
        vehicle that has the others; or None for the default.
    where : str
        Whose it is, for messages.
    own : mapping of str to Vehicle
        Vehicles by names that mean them here, before those of `VEHICLES`.

    Returns
    -------
    Vehicle
        The one meant.

    Raises
    ------
    ScenarioError
        An unknown name or field, or a value that is none.
    """
    if value is None:
        return DEFAULT_VEHICLE
    if isinstance(value, Vehicle):
        return value
    known = {**VEHICLES, **own}
    try:
        if isinstance(value, str):
            return looked_up(VEHICLES.kind, value, known)
        if not isinstance(value, Mapping):
            raise ScenarioError(
                f"{brief(value)} is no vehicle; give a name ({', '.join(known)}) or a table"
            )
        given = dict(value)
        base = DEFAULT_VEHICLE
        if "base" in given:
            base = looked_up(VEHICLES.kind, given.pop("base"), known)
        for key in given:
            if key not in KEYS:
                raise ScenarioError(f"a vehicle has no {brief(key)}; use base, {', '.join(KEYS)}")
        if "mass_t" in given and "rating_t" not in given:
            given["rating_t"] = None
        name = given.pop("name", _own_name(base, given))
        return replace(base, name=name, **given)
    except ScenarioError as error:
        raise ScenarioError(f"{where}: {error}") from error


def _own_name(base: Vehicle, changed: Mapping[str, Any]) -> str:
    return f"like {base.name}" if changed else base.name
