"""Limits of size and mass: `maxheight`, `maxweight` and their like, in metres and tonnes.

A plain number is metres or tonnes. Read besides are "12 ft 6 in", also with quotation marks for the
words, "350 cm", "7,5 t", "3500 kg", "10 st" (short tons of 2,000 lb, as the map has it), "10 lt"
(long tons) and "20000 lbs"; of a list the least counts. "none" and "default" restrict nobody: a
vehicle that needs no permit keeps the general law by itself. "below_default" is a bridge lower than
that without a sign.

Source: https://wiki.openstreetmap.org/wiki/Key:maxheight, Key:maxweight, Key:maxweightrating,
Key:maxaxleload, Key:maxlength, Key:maxwidth.
"""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from typing import Literal

from .access import chain_of
from .profile import Vehicle
from .units import FOOT_M, INCH_M, LONG_TON_T, POUND_T, SHORT_TON_T

__all__ = ["LIMITS", "Limit", "Passed", "limits_on", "read_limit"]

Unit = Literal["m", "t"]


@dataclass(frozen=True, slots=True)
class Limit:
    """One kind of limit.

    Attributes
    ----------
    key : str
        The tag, without what it is for.
    about : str
        What it limits, in a few words.
    unit : {"m", "t"}
        Metres or tonnes.
    of : callable
        Returns what it is compared with.
    """

    key: str
    about: str
    unit: Unit
    of: Callable[[Vehicle], float]


LIMITS: Mapping[str, Limit] = {
    limit.key: limit
    for limit in (
        Limit("maxheight", "height", "m", lambda one: one.height_m),
        Limit("maxheight:physical", "height", "m", lambda one: one.height_m),
        Limit("maxwidth", "width", "m", lambda one: one.width_m),
        Limit("maxwidth:physical", "width", "m", lambda one: one.width_m),
        Limit("maxlength", "length", "m", lambda one: one.length_m),
        Limit("maxweight", "weight", "t", lambda one: one.mass_t),
        Limit("maxgcweight", "weight of the combination", "t", lambda one: one.mass_t),
        Limit("maxweightrating", "permitted mass", "t", lambda one: one.permitted_t),
        Limit(
            "maxgcweightrating", "permitted mass of the combination", "t",
            lambda one: one.permitted_t,
        ),
        Limit("maxaxleload", "axle load", "t", lambda one: one.axle_load_t),
    )
}  # fmt: skip
"""Limits that are judged; each may be said for some alone: `maxheight:hgv`, `maxweight:trailer`."""

TRAILER = ":trailer"

NO_LIMIT = frozenset(
    {
        "none", "no", "default", "unsigned", "no_sign", "nosign", "no_indications", "unlimited",
        "not_signed", "implicit", "any", "yes",
    }
)  # fmt: skip
BELOW_DEFAULT = {"m": 3.99, "t": math.inf}
"""Lower than the 4 m that roads of Europe must leave (96/53/EC): a truck of 4 m does not pass."""

UNITS: Mapping[Unit, Mapping[str, float]] = {
    "m": {
        "": 1.0, "m": 1.0, "mt": 1.0, "mts": 1.0, "meter": 1.0, "meters": 1.0, "metre": 1.0,
        "metres": 1.0, "cm": 0.01, "mm": 0.001, "ft": FOOT_M, "feet": FOOT_M, "foot": FOOT_M,
        "'": FOOT_M, "in": INCH_M, "inch": INCH_M, "inches": INCH_M, '"': INCH_M,
    },
    "t": {
        "": 1.0, "t": 1.0, "to": 1.0, "ton": 1.0, "tonne": 1.0, "tonnes": 1.0, "tonnen": 1.0,
        "mt": 1.0, "kg": 0.001, "st": SHORT_TON_T, "tons": SHORT_TON_T, "short_ton": SHORT_TON_T,
        "short_tons": SHORT_TON_T, "lt": LONG_TON_T, "lb": POUND_T, "lbs": POUND_T,
        "pounds": POUND_T, "klbs": 1000 * POUND_T, "cwt": LONG_TON_T / 20,
    },
}  # fmt: skip
"""Metres or tonnes of a unit. "tons" are American: those of Britain weigh more."""

PLAUSIBLE = {"m": (0.5, 100.0), "t": (0.1, 500.0)}
"""Beyond these a number is a slip of the pen, such as 44 for 4.4 is not, but 0 or 4000 is."""

FEET = re.compile(
    r"(\d+(?:\.\d+)?)\s*(?:'|ft|feet|foot)\s*-?\s*(\d+(?:\.\d+)?)\s*(?:\"|''|in|inch|inches|)"
)
NUMBER = re.compile(r"(\d+(?:\.\d+)?)\s*_?([a-z'\"_]*)\.?")
THOUSANDS = re.compile(r"(?<=\d),(?=\d{3}(?:\D|$))")
QUOTES = str.maketrans({"’": "'", "′": "'", "`": "'", "”": '"', "″": '"', "“": '"'})


@dataclass(frozen=True, slots=True)
class Passed:
    """A limit on a road, beside a vehicle.

    Attributes
    ----------
    kind : Limit
        What is limited.
    key : str
        The tag that says so.
    limit, value : float
        What is allowed, and what the vehicle has [m] or [t].
    """

    kind: Limit
    key: str
    limit: float
    value: float

    @property
    def fits(self) -> bool:
        """Whether the vehicle may pass."""
        return self.value <= self.limit + 1e-9

    @property
    def told(self) -> str:
        """The limit and the vehicle in words."""
        limit, value = (f"{round(one, 2):g}" for one in (self.limit, self.value))
        unit = self.kind.unit
        return f"max. {self.kind.about} {limit} {unit} (the vehicle has {value} {unit})"


def read_limit(text: str, unit: Unit) -> float | None:
    """Read the value of a limit.

    Parameters
    ----------
    text : str
        Of a tag.
    unit : {"m", "t"}
        What it is in.

    Returns
    -------
    float or None
        Metres or tonnes; inf for none, None where it cannot be read.
    """
    text = text.translate(QUOTES).lower()
    masses = unit == "t" and re.search(r"lb|kg|pound", text)
    text = THOUSANDS.sub("", text) if masses else text
    values = [_one(part.strip(), unit) for part in re.split(r"[;|]", text) if part.strip()]
    known = [value for value in values if value is not None]
    return min(known) if known else None


def _one(text: str, unit: Unit) -> float | None:
    text = text.replace(",", ".")
    if text.replace(" ", "_") in NO_LIMIT:
        return math.inf
    if text.replace(" ", "_") == "below_default":
        return BELOW_DEFAULT[unit]
    value = None
    if unit == "m" and (feet := FEET.fullmatch(text)):
        value = float(feet.group(1)) * FOOT_M + float(feet.group(2)) * INCH_M
    elif found := NUMBER.fullmatch(text):
        factor = UNITS[unit].get(found.group(2).strip("_"))
        value = None if factor is None else float(found.group(1)) * factor
    low, high = PLAUSIBLE[unit]
    return value if value is not None and low <= value <= high else None


def limits_on(tags: Mapping[str, str], vehicle: Vehicle) -> Iterator[Passed]:
    """Return the limits on a road that hold for a vehicle.

    Parameters
    ----------
    tags : mapping of str to str
        Of a road or a barrier, conditions settled.
    vehicle : Vehicle
        Who drives.

    Yields
    ------
    Passed
        Each limit that can be read, whether the vehicle fits or not.
    """
    own = list(chain_of(vehicle))
    for base, kind in LIMITS.items():
        # What is said for trucks stands in place of what is said for all; what is said for
        # trailers holds besides.
        keys = [next((key for name in own if (key := f"{base}:{name}") in tags), base)]
        if vehicle.trailer:
            keys.append(base + TRAILER)
        for key in keys:
            limit = read_limit(tags[key], kind.unit) if key in tags else None
            if limit is not None and limit < math.inf:
                yield Passed(kind, key, limit, kind.of(vehicle))
