"""What the tags of a road mean for a heavy vehicle: direction, access, speed and toll."""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import dataclass
from numbers import Real

from ..errors import ScenarioError

__all__ = [
    "COUNTRY_LIMITS_KMH", "TruckRules", "WayReading", "is_driving_tag", "read_speed_kmh",
    "read_way",
]  # fmt: skip

COUNTRY_LIMITS_KMH: Mapping[str, float] = {
    **dict.fromkeys(("AT", "CZ", "DE", "DK", "FI", "HU", "IT"), 80.0),
    **dict.fromkeys(("BE", "EE", "FR", "HR", "IE", "SI", "SK"), 90.0),
    "NL": 80.0,
    "US-CA": 55 * 1.609344,
}
"""Motorway limits for heavy goods vehicles. Europe: European Commission, "Going abroad", and the
list in the project's sources; NL: RVV 1990 art. 22; California: Vehicle Code section 22406."""

CLASS_SPEEDS_KMH: Mapping[str, float] = {
    "motorway": 120.0, "trunk": 90.0, "primary": 70.0, "secondary": 60.0, "tertiary": 50.0,
}  # fmt: skip
LINK_SPEED_KMH = 50.0
OTHER_SPEED_KMH = 40.0

ZONE_SPEEDS_KMH: Mapping[str, float] = {
    "motorway": 130.0, "trunk": 110.0, "rural": 90.0, "urban": 50.0,
    "living_street": 20.0, "walk": 7.0,
}  # fmt: skip
"""What "IT:motorway" and its like mean before the cap for trucks, which decides in practice."""

MPH_IN_KMH = 1.609344
KNOT_IN_KMH = 1.852
FASTEST_KMH, SLOWEST_KMH = 150.0, 3.0
"""Speeds outside are slips of the pen: a "70|100" read as 70100 must not make a road fast."""

NO = frozenset({"no", "false", "0", "private", "agricultural", "forestry", "emergency", "bus"})
FORWARD, BACKWARD, BOTH = 1, -1, 0


@dataclass(frozen=True, slots=True)
class TruckRules:
    """The vehicle and the law that cap a speed.

    Attributes
    ----------
    country : str or None
        ISO code whose motorway limit for trucks applies, such as "IT", "DE" or "US-CA", in
        any case; None if not known, and then only the limiter caps.
    limiter_kmh : float
        What the vehicle's speed limiter allows (90 in the EU, Directive 92/6/EEC).
    """

    country: str | None = None
    limiter_kmh: float = 90.0

    def __post_init__(self) -> None:
        country, limiter = self.country, self.limiter_kmh
        code = country.strip().upper() if isinstance(country, str) else ""
        known = code in COUNTRY_LIMITS_KMH
        if country is not None and not known:
            raise ScenarioError(
                f"country {_shown(country)} has no truck limit here; use "
                f"{', '.join(sorted(COUNTRY_LIMITS_KMH))}"
            )
        if known:
            object.__setattr__(self, "country", code)
        # Numpy's numbers are numbers too; True is none.
        is_number = isinstance(limiter, Real) and not isinstance(limiter, bool)
        if not (is_number and SLOWEST_KMH <= limiter <= FASTEST_KMH):
            raise ScenarioError(
                f"limiter_kmh {_shown(limiter)}: a speed limiter lies between "
                f"{SLOWEST_KMH:g} and {FASTEST_KMH:g} km/h"
            )
        object.__setattr__(self, "limiter_kmh", float(limiter))

    @property
    def cap_kmh(self) -> float:
        """The lower of the country's limit and the limiter."""
        limit = COUNTRY_LIMITS_KMH[self.country] if self.country else self.limiter_kmh
        return min(limit, self.limiter_kmh)


def _shown(value: object) -> str:
    return " ".join(repr(value).split())[:80]


@dataclass(frozen=True, slots=True)
class WayReading:
    """What one combination of tags means.

    Attributes
    ----------
    direction : int
        1 along the way, -1 against it, 0 both.
    allowed : bool
        Whether a truck may drive there.
    speed_kmh : float
        Speed of a lone truck.
    toll : bool
        Whether the road costs toll for trucks.
    remarks : tuple of str
        What had to be defaulted, capped or ignored; counted by the loader.
    backward_kmh : float
        Speed against the way; that of `speed_kmh` on a one-way road.
    """

    direction: int
    allowed: bool
    speed_kmh: float
    toll: bool
    remarks: tuple[str, ...]
    backward_kmh: float = 0.0


def read_way(tags: Mapping[str, str], rules: TruckRules) -> WayReading:
    """Read the tags of a road for a heavy vehicle.

    Parameters
    ----------
    tags : mapping of str to str
        Tags of a road.
    rules : TruckRules
        The truck and the law.

    Returns
    -------
    WayReading
        What they mean.
    """
    remarks: list[str] = []
    direction = _direction(tags, remarks)
    allowed = _allowed(tags)
    speed = backward = _speed_kmh(tags, direction, rules, remarks)
    if direction == BOTH:
        noted: list[str] = []
        backward = _speed_kmh(tags, BACKWARD, rules, noted)
        # A remark counts once for a way, whichever direction it is about.
        remarks += [remark for remark in noted if remark not in remarks]
    toll = tags.get("toll:hgv", tags.get("toll:N3", tags.get("toll", "no")))
    costs_toll = toll.strip().lower() not in NO
    conditional = sum(1 for key in tags if key.endswith(":conditional"))
    remarks += ["conditional tags ignored"] * conditional
    return WayReading(direction, allowed, speed, costs_toll, tuple(remarks), backward)


DRIVING_TAGS = frozenset(
    {"highway", "oneway", "junction", "hgv", "motor_vehicle", "vehicle", "access"}
    | {"toll", "toll:hgv", "toll:N3"}
)


def is_driving_tag(key: str) -> bool:
    """Say whether `read_way` looks at a tag.

    Parameters
    ----------
    key : str
        Key of a tag.

    Returns
    -------
    bool
        Whether it does.
    """
    return key in DRIVING_TAGS or key.startswith("maxspeed") or key.endswith(":conditional")


def _direction(tags: Mapping[str, str], remarks: list[str]) -> int:
    value = tags.get("oneway", "").strip().lower()
    if value in {"yes", "true", "1"}:
        return FORWARD
    if value in {"-1", "reverse"}:
        return BACKWARD
    if value in {"no", "false", "0"}:
        return BOTH
    if value:
        remarks.append("oneway not understood")
    if tags.get("junction") in {"roundabout", "circular"}:
        return FORWARD
    if tags.get("highway") in {"motorway", "motorway_link"}:
        if not value:
            remarks.append("direction defaulted to one-way (motorway without oneway)")
        return FORWARD
    return BOTH


def _allowed(tags: Mapping[str, str]) -> bool:
    """Let the most specific access tag decide: hgv, then goods vehicles of any kind, then all."""
    for key in ("hgv", "motor_vehicle", "vehicle", "access"):
        if key in tags:
            return tags[key].strip().lower() not in NO
    return True


def _speed_kmh(
    tags: Mapping[str, str], direction: int, rules: TruckRules, remarks: list[str]
) -> float:
    side = "backward" if direction == BACKWARD else "forward"
    for key in (f"maxspeed:hgv:{side}", "maxspeed:hgv"):
        if key in tags:
            speed = read_speed_kmh(tags[key])
            if speed is not None:
                return _capped(speed, rules.limiter_kmh, remarks)
            remarks.append("maxspeed not understood")
    speed = None
    for key in (f"maxspeed:{side}", "maxspeed"):
        if key in tags:
            speed = read_speed_kmh(tags[key])
            if speed is not None:
                break
            remarks.append("maxspeed not understood")
    if speed is None:
        remarks.append("speed defaulted from road class")
        speed = _class_speed_kmh(tags.get("highway", ""))
    return _capped(speed, rules.cap_kmh, remarks)


def _class_speed_kmh(highway: str) -> float:
    if highway.endswith("_link"):
        return LINK_SPEED_KMH
    return CLASS_SPEEDS_KMH.get(highway, OTHER_SPEED_KMH)


def _capped(speed: float, cap: float, remarks: list[str]) -> float:
    if speed > cap:
        remarks.append("speed capped for trucks")
        return cap
    return speed


def read_speed_kmh(text: str) -> float | None:
    """Read a `maxspeed` value; None if it cannot be understood.

    Plain numbers are km/h; "65 mph" and "10 knots" are converted; of values per lane ("70|100")
    or in a list ("80;100") the lowest counts, for a truck keeps to the slow lane;
    "none" is no limit; "IT:motorway" and "walk" are the usual limits of their kind.

    Parameters
    ----------
    text : str
        Value of a tag.

    Returns
    -------
    float or None
        km/h, or None.
    """
    values = [_one_speed(part) for part in re.split(r"[|;]", text) if part.strip()]
    known = [value for value in values if value is not None]
    return min(known) if known else None


def _one_speed(text: str) -> float | None:
    text = text.strip().lower()
    if text in {"none", "unlimited"}:
        return FASTEST_KMH
    if text in {"signals", "variable", "default", "implicit"}:
        return None
    found = re.fullmatch(r"(\d{1,4}(?:\.\d+)?)\s*(km/h|kmh|kph|mph|knots?|)", text)
    if found:
        unit = found.group(2)
        factor = MPH_IN_KMH if unit == "mph" else KNOT_IN_KMH if unit.startswith("knot") else 1.0
        return _plausible(float(found.group(1)) * factor)
    zone = re.fullmatch(r"(?:[a-z]{2}(?:-[a-z]{2,3})?:)?([a-z_]+)(?::hgv)?", text)
    if zone:
        return ZONE_SPEEDS_KMH.get(zone.group(1))
    number = re.fullmatch(r"[a-z]{2}:(?:zone:?)?(\d{1,3})", text)
    return _plausible(float(number.group(1))) if number else None


def _plausible(speed_kmh: float) -> float | None:
    return speed_kmh if SLOWEST_KMH <= speed_kmh <= FASTEST_KMH else None
