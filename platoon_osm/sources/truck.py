"""What the tags of a road mean for a heavy vehicle: direction, access, speed and toll."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Mapping
from dataclasses import dataclass
from numbers import Real

from ..errors import ScenarioError
from ..network.restrictions import encode
from ..vehicles.conditions import apply, has_conditions
from ..vehicles.profile import DEFAULT_VEHICLE, VEHICLES
from .way_sides import (
    CHANGING,
    Layers,
    for_side,
    is_restriction,
    open_to_any,
    restricting,
    sides_of,
    unread,
)

__all__ = [
    "COUNTRY_LIMITS_KMH", "TruckRules", "WayReading", "dropped", "is_driving_tag", "read_speed_kmh",
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

LIGHT = VEHICLES["van-3.5t"]
"""Whose speed is that of light vehicles where it depends on mass."""

MPH_IN_KMH = 1.609344
KNOT_IN_KMH = 1.852
FASTEST_KMH, SLOWEST_KMH = 150.0, 3.0
"""Speeds outside are slips of the pen: a "70|100" read as 70100 must not make a road fast."""

NO = frozenset({"no", "false", "0"})
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

    def within(self, country: str) -> TruckRules:
        """Return the rules on a road of a country.

        Parameters
        ----------
        country : str
            Where it is, "IT" or "US-CA"; empty if that is not known.

        Returns
        -------
        TruckRules
            The same if they name a country themselves, or if nothing is known of that one.
        """
        if self.country or country not in COUNTRY_LIMITS_KMH:
            return self
        return TruckRules(country, self.limiter_kmh)

    @property
    def cap_kmh(self) -> float:
        """The lower of the country's limit and the limiter."""
        limit = COUNTRY_LIMITS_KMH[self.country] if self.country else self.limiter_kmh
        return min(limit, self.limiter_kmh)


def _shown(value: object) -> str:
    return " ".join(repr(value).split())[:80]


@dataclass(frozen=True, slots=True)
class Side:
    """What a road means in one direction.

    Attributes
    ----------
    speed_kmh : float
        Speed of a lone truck.
    posted_kmh : float
        What a light vehicle may drive.
    restriction : str
        Whom it is closed to, in the form of `network.restrictions`.
    toll : bool
        Whether trucks pay.
    """

    speed_kmh: float
    posted_kmh: float
    restriction: str
    toll: bool


@dataclass(frozen=True, slots=True)
class WayReading:
    """What one combination of tags means.

    Attributes
    ----------
    direction : int
        1 along the way, -1 against it, 0 both.
    allowed : bool
        Whether anybody this package plans for may drive there, be it at the ends of a trip or at
        some hours.
    speed_kmh : float
        Speed of a lone truck.
    toll : bool
        Whether the road costs toll for trucks.
    remarks : tuple of str
        What had to be defaulted, capped or ignored; counted by the loader.
    backward_kmh : float
        Speed against the way; that of `speed_kmh` on a one-way road.
    posted_kmh, backward_posted_kmh : float
        What a light vehicle may drive, likewise.
    restriction, backward_restriction : str
        Whom the road is closed to, in the form of `network.restrictions`, likewise.
    closed_by : str
        The tags that close it, if nobody may drive there.
    """

    direction: int
    allowed: bool
    speed_kmh: float
    toll: bool
    remarks: tuple[str, ...]
    backward_kmh: float = 0.0
    posted_kmh: float = 0.0
    backward_posted_kmh: float = 0.0
    restriction: str = ""
    backward_restriction: str = ""
    closed_by: str = ""

    @property
    def along(self) -> Side:
        """In its only direction, else along the way as it is drawn."""
        return Side(self.speed_kmh, self.posted_kmh, self.restriction, self.toll)

    @property
    def against(self) -> Side:
        """In its only direction, else against the way."""
        return Side(
            self.backward_kmh, self.backward_posted_kmh, self.backward_restriction, self.toll
        )


def dropped(reading: WayReading, unit: str) -> str:
    """Return what to count a road as that nobody may drive.

    Parameters
    ----------
    reading : WayReading
        That of the road.
    unit : str
        What is counted, "ways" or "edges".

    Returns
    -------
    str
        With the tags that close it.
    """
    return f"{unit} dropped: closed to all by {reading.closed_by or 'oneway'}"


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
    counts: Counter[str] = Counter()
    one_way = _direction(tags, remarks)
    sides = [
        _side(tags, name, layers, counts)
        for name, layers in zip(
            ("forward", "backward"), sides_of(tags, one_way, counts), strict=True
        )
    ]
    usable = [text is not None and not reason for text, reason in sides]
    # A road that nobody may drive keeps its direction, for the reader of its tags.
    direction = (FORWARD if usable[0] else BACKWARD) if sum(usable) == 1 else BOTH
    if not any(usable):
        direction = one_way
    noted: list[list[str]] = [[], []]
    ways = [
        _speeds(tags, side, rules, own)
        for side, own in zip((FORWARD, BACKWARD), noted, strict=True)
    ]
    first = int(direction == BACKWARD)
    last = first if direction != BOTH else 1
    for own in (noted[first], noted[last]):
        # A remark counts once for a way, whichever direction it is about.
        remarks += [remark for remark in own if remark not in remarks]
    toll = tags.get("toll:hgv", tags.get("toll:N3", tags.get("toll", "no")))
    for key in unread(tags):
        counts[f"restrictions not read: {key}"] += 1
    return WayReading(
        direction=direction,
        allowed=any(usable),
        speed_kmh=ways[first][0],
        toll=toll.strip().lower() not in NO,
        remarks=(*remarks, *counts),
        backward_kmh=ways[last][0],
        posted_kmh=ways[first][1],
        backward_posted_kmh=ways[last][1],
        restriction=sides[first][0] or "",
        backward_restriction=sides[last][0] or "",
        closed_by=next((reason for _, reason in sides if reason), ""),
    )


def _side(
    tags: Mapping[str, str], name: str, layers: Layers | None, counts: Counter[str]
) -> tuple[str | None, str]:
    """Return what is restricted in one direction, and what closes it; None if nothing drives it."""
    if layers is None:
        return None, ""
    every = (*layers, restricting(for_side(tags, name), counts))
    return encode(every), open_to_any(every) if any(every) else ""


def _speeds(
    tags: Mapping[str, str], side: int, rules: TruckRules, remarks: list[str]
) -> tuple[float, float]:
    """Return what a truck drives in a direction, and what is posted for light vehicles."""
    own = {key: value for key, value in tags.items() if not is_restriction(key)}
    if not has_conditions(own):
        return _speed_kmh(own, side, rules, remarks), _posted_kmh(own, side)
    truck, undecided = apply(own, DEFAULT_VEHICLE)
    if undecided:
        remarks.append("speed limits at some hours or in some weather, not judged")
    van, _ = apply(own, LIGHT)
    return _speed_kmh(truck, side, rules, remarks), _posted_kmh(van, side)


DRIVING_TAGS = frozenset({"highway", "oneway", "junction", "toll", "toll:hgv", "toll:N3"})


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
    return (
        key in DRIVING_TAGS
        or key.startswith(("maxspeed", "oneway"))
        or key.endswith(":conditional")
        or is_restriction(key)
        or bool(unread([key]))
    )


def _direction(tags: Mapping[str, str], remarks: list[str]) -> int:
    value = tags.get("oneway", "").strip().lower()
    if value in {"yes", "true", "1"}:
        return FORWARD
    if value in {"-1", "reverse"}:
        return BACKWARD
    if value in {"no", "false", "0"}:
        return BOTH
    if value and value not in CHANGING:
        remarks.append("oneway not understood")
    if tags.get("junction") in {"roundabout", "circular"}:
        return FORWARD
    if tags.get("highway") in {"motorway", "motorway_link"}:
        if not value:
            remarks.append("direction defaulted to one-way (motorway without oneway)")
        return FORWARD
    return BOTH


def _posted_kmh(tags: Mapping[str, str], direction: int) -> float:
    """Return what a light vehicle may drive: as posted, else as on roads of the class."""
    side = "backward" if direction == BACKWARD else "forward"
    for key in (f"maxspeed:{side}", "maxspeed"):
        speed = read_speed_kmh(tags[key]) if key in tags else None
        if speed is not None:
            return speed
    return _class_speed_kmh(tags.get("highway", ""))


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
