"""One text of a speed limit: "55;60 mph", "60 (hgv)", "DE:urban", and what people write besides.

A text is a list, divided by semicolons, commas or, lane by lane, bars; the lowest limit counts, for
a truck keeps to the slow lane. A unit that stands once holds for the list. Of a part that is no
limit by the rules, the lowest number in it that can be a speed is taken, and the reading is not
sure: whoever uses it must not drive faster by it than without.

Source: https://wiki.openstreetmap.org/wiki/Key:maxspeed
"""

from __future__ import annotations

import re
import unicodedata
from dataclasses import dataclass
from functools import lru_cache

from ..country.law import MPH_IN_KMH
from ..country.rules import FASTEST_KMH, SLOWEST_KMH
from .zones import Zone, zone_of_text

__all__ = ["Limit", "read_limit", "read_speed_kmh"]

KNOT_IN_KMH = 1.852

UNITS = {
    "km/h": 1.0, "kmh": 1.0, "kph": 1.0, "kmph": 1.0, "km/hr": 1.0, "km": 1.0,
    "mph": MPH_IN_KMH, "mi/h": MPH_IN_KMH, "knots": KNOT_IN_KMH, "knot": KNOT_IN_KMH,
}  # fmt: skip
UNIT = "|".join(sorted(map(re.escape, UNITS), key=len, reverse=True))
TRUCK = r"\(?\s*(?:hgvs?|trucks?|lorry|lorries|lkw|camions?|camiones|autocarri)\s*\)?"

ONE = re.compile(
    rf"(\d{{1,4}}(?:\.\d+)?)(?:\s*[-–—]\s*(\d{{1,4}}(?:\.\d+)?))?\s*({UNIT})?\s*({TRUCK})?"
)
NUMBER = re.compile(rf"(\d+(?:\.\d+)?)\s*({UNIT})?")
DECIMAL_COMMA = re.compile(r"(?<=\d),(?=\d(?!\d))")
CLOCK = re.compile(r"\d{1,2}:\d{2}")

NO_LIMIT = frozenset({"none", "unlimited", "no limit", "no_limit"})
NO_NUMBER = frozenset({"signals", "variable", "default", "implicit"})
"""Limits that the map does not tell, and says so."""


@dataclass(frozen=True, slots=True)
class Limit:
    """What a text says.

    Attributes
    ----------
    trucks, cars : float or None
        The lowest number for either [km/h]; None if there is none for them.
    zones : tuple of Zone
        Kinds of places, whose limits the law tells.
    sure : bool
        Whether all of it was understood.
    """

    trucks: float | None
    cars: float | None
    zones: tuple[Zone, ...]
    sure: bool

    def kmh(self, kind: str, country: str, *, truck: bool) -> float | None:
        """Return the lowest limit.

        Parameters
        ----------
        kind : str
            Kind of the road, in the sense of the law.
        country : str
            Where it is; empty if that is not known.
        truck : bool
            Whether what is said of trucks alone counts.

        Returns
        -------
        float or None
            km/h; 150 for no limit, None if the text tells none.
        """
        number = self.trucks if truck else self.cars
        found = [zone.car_kmh(kind, country) for zone in self.zones]
        return min([*found, *([] if number is None else [number])], default=None)


@lru_cache(maxsize=20_000)
def read_limit(text: str) -> Limit:
    """Read a speed limit.

    Parameters
    ----------
    text : str
        Value of a tag.

    Returns
    -------
    Limit
        What it says.
    """
    plain = DECIMAL_COMMA.sub(".", unicodedata.normalize("NFKC", text).lower())
    parts = [" ".join(part.split()) for part in re.split(r"[;|,]", plain)]
    parts = [part for part in parts if part]
    factor = _unit_of_all(plain)
    trucks: list[float] = []
    cars: list[float] = []
    zones: list[Zone] = []
    sure = bool(parts)
    for part in parts:
        zone = zone_of_text(part)
        found = ONE.fullmatch(part)
        if part in NO_LIMIT:
            values, own, understood = [FASTEST_KMH], False, True
        elif zone is not None:
            zones.append(zone)
            continue
        elif part in NO_NUMBER:
            continue
        elif found:
            low, high, unit, vehicle = found.groups()
            scale = UNITS[unit] if unit else factor
            values = [float(number) * scale for number in (low, high) if number]
            own = bool(vehicle)
            understood = all(map(_plausible, values))
        else:
            values, own, understood = _numbers(part, factor), False, False
        values = [value for value in values if _plausible(value)]
        sure = sure and understood
        trucks += values
        cars += [] if own else values
    return Limit(min(trucks, default=None), min(cars, default=None), tuple(zones), sure)


def _unit_of_all(text: str) -> float:
    """Return what numbers without a unit mean [km/h]: the only unit of the text, else km/h."""
    units = {UNITS[unit] for _, unit in NUMBER.findall(text) if unit}
    return units.pop() if len(units) == 1 else 1.0


def _numbers(part: str, factor: float) -> list[float]:
    """Return all numbers that may be speeds; hours and conditions are none."""
    speeds = CLOCK.sub(" ", part.partition("@")[0])
    return [
        float(number) * (UNITS[unit] if unit else factor) for number, unit in NUMBER.findall(speeds)
    ]


def _plausible(speed_kmh: float) -> bool:
    return SLOWEST_KMH <= speed_kmh <= FASTEST_KMH


def read_speed_kmh(text: str) -> float | None:
    """Read a speed limit for a truck, wherever the road is.

    Parameters
    ----------
    text : str
        Value of a tag.

    Returns
    -------
    float or None
        km/h, None if no speed can be read; 150 for no limit.
    """
    return read_limit(text).kmh("rural", "", truck=True)
