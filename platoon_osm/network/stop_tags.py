"""What a stop offers to trucks, read from the tags that a network keeps of it.

The text of a stop has one layer for each thing there: the area itself, its parkings, pumps and
chargers, in the form of `network.restrictions`. Loaders keep only tags that are read here or by
whoever judges a stop for a vehicle.

Source: https://wiki.openstreetmap.org/wiki/Tag:highway=services, Tag:highway=rest_area,
Tag:amenity=parking, Tag:amenity=fuel, Key:fuel, Tag:amenity=charging_station, Key:socket,
Key:maxstay.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping

__all__ = [
    "FUELS",
    "NO",
    "OFFERS",
    "YES",
    "fee_of",
    "fuels_of",
    "kilowatts",
    "max_stay_s",
    "offers_of",
    "power_kw_of",
    "stay_s",
]

Layer = Mapping[str, str]

OFFERS = ("parking", "fuel", "charging")

YES = frozenset({"yes", "true", "1", "only", "limited", "customers", "designated"})
NO = frozenset({"no", "false", "0", "none"})

FUELS: Mapping[str, str] = {
    **dict.fromkeys(
        ("diesel", "hgv_diesel", "gtl_diesel", "diesel_b0", "diesel_b7", "diesel_b10",
         "diesel_s10", "diesel_s500", "diesel_class2", "cold_weather_diesel"),
        "diesel",
    ),
    **dict.fromkeys(("biodiesel", "diesel_b20", "diesel_b30", "diesel_b100"), "biodiesel"),
    **dict.fromkeys(("hvo", "hvo100", "hvo_100", "hvo_diesel", "diesel_hvo", "xtl"), "hvo"),
    **dict.fromkeys(("lng", "biolng", "bio_lng", "lbg"), "lng"),
    **dict.fromkeys(("cng", "biogas", "biomethane", "bio_cng"), "cng"),
    "lpg": "lpg",
    **dict.fromkeys(("h35", "h70", "lh2", "hydrogen"), "hydrogen"),
    "adblue": "adblue",
}  # fmt: skip
"""Keys behind `fuel:`, in small letters, and what a truck gets there."""

OUTPUT = re.compile(r"socket:[^:]+:output")
STATION = "charging_station:output"
POWER = re.compile(r"(\d{1,7}(?:[.,]\d{1,3})?)\s*(kw|mw|w|kva)?", re.IGNORECASE)
KILO = {"": 1.0, "kw": 1.0, "kva": 1.0, "mw": 1000.0, "w": 0.001}
"""A plain number is kW."""
MOST_KW = 10_000.0
"""Megawatt charging ends at 3.75 MW (SAE J3271); more than this is a mistake."""

STAY = re.compile(r"(\d{1,4}(?:[.,]\d{1,2})?)\s*([a-z]+)", re.IGNORECASE)
CLOCK = re.compile(r"(\d{1,3}):([0-5]\d)")
SECONDS = {
    **dict.fromkeys(("min", "mins", "minute", "minutes", "m"), 60.0),
    **dict.fromkeys(("h", "hr", "hrs", "hour", "hours"), 3600.0),
    **dict.fromkeys(("d", "day", "days"), 86_400.0),
    **dict.fromkeys(("week", "weeks"), 604_800.0),
}  # fmt: skip
NO_LIMIT = frozenset({"no", "none", "unlimited", "unknown"})


def offers_of(layers: Iterable[Layer]) -> tuple[str, ...]:
    """Return what a stop offers.

    Parameters
    ----------
    layers : iterable of mapping of str to str
        As `network.restrictions.decode` returns them.

    Returns
    -------
    tuple of str
        Of "parking", "fuel" and "charging", in this order. On rest areas and service areas a
        truck may park unless their tags say `hgv=no`.
    """
    found = set()
    for layer in layers:
        if "highway" in layer and layer.get("hgv", "").strip().lower() not in NO:
            found.add("parking")
        kind = layer.get("amenity", "")
        found |= {"parking"} & {kind}
        if kind == "fuel" or _fuels(layer):
            found.add("fuel")
        if kind == "charging_station":
            found.add("charging")
    return tuple(offer for offer in OFFERS if offer in found)


def fuels_of(layers: Iterable[Layer]) -> tuple[str, ...]:
    """Return what the map says is sold there.

    Parameters
    ----------
    layers : iterable of mapping of str to str
        Of a stop.

    Returns
    -------
    tuple of str
        Names of `FUELS`, in alphabetical order; none where the map does not say.
    """
    return tuple(sorted({fuel for layer in layers for fuel in _fuels(layer)}))


def _fuels(layer: Layer) -> set[str]:
    return {
        FUELS[key[5:].lower()]
        for key, value in layer.items()
        if key.startswith("fuel:") and key[5:].lower() in FUELS and _is_yes(value)
    }


def _is_yes(value: str) -> bool:
    text = value.strip().lower()
    return text in YES or (text.isdecimal() and int(text[:9]) > 0)


def power_kw_of(layers: Iterable[Layer]) -> float | None:
    """Return what the strongest charger of a stop gives.

    Parameters
    ----------
    layers : iterable of mapping of str to str
        Of a stop.

    Returns
    -------
    float or None
        Of one socket [kW]; where no socket says it, of the whole station; None if not known.
    """
    chargers = [layer for layer in layers if layer.get("amenity") == "charging_station"]
    for wanted in (OUTPUT.fullmatch, STATION.__eq__):
        found = [
            power
            for layer in chargers
            for key, value in layer.items()
            if wanted(key) and (power := kilowatts(value)) is not None
        ]
        if found:
            return max(found)
    return None


def kilowatts(text: str) -> float | None:
    """Read a power as maps have it: "150 kW", "1 MW", "22000 W", "150;350".

    Parameters
    ----------
    text : str
        One power, or a list of them.

    Returns
    -------
    float or None
        The greatest [kW]; None if one of them is none.
    """
    found = [POWER.fullmatch(part.strip()) for part in text.split(";")]
    if not all(found):
        return None
    power = max(
        float(one[1].replace(",", ".")) * KILO[(one[2] or "").lower()] for one in found if one
    )
    return power if 0 < power <= MOST_KW else None


def fee_of(layers: Iterable[Layer]) -> bool | None:
    """Say whether parking costs money.

    Parameters
    ----------
    layers : iterable of mapping of str to str
        Of a stop.

    Returns
    -------
    bool or None
        True if any part of it does; None if the map does not say.
    """
    told = [
        layer["fee"].strip().lower()
        for layer in layers
        if "fee" in layer and layer.get("amenity", "parking") == "parking"
    ]
    if not told:
        return None
    return any(text not in NO for text in told)


def max_stay_s(layers: Iterable[Layer]) -> float | None:
    """Return how long a truck may stay.

    Parameters
    ----------
    layers : iterable of mapping of str to str
        Of a stop.

    Returns
    -------
    float or None
        Where it may stay longest [s]; None where nothing limits it or the limit cannot be read.
    """
    found: list[float] = []
    for layer in layers:
        if layer.get("amenity", "parking") != "parking" or "maxstay" not in layer:
            continue
        limit = stay_s(layer["maxstay"])
        if limit is None:
            return None
        found.append(limit)
    return max(found, default=None)


def stay_s(text: str) -> float | None:
    """Read a time as `maxstay` has it: "2 h", "45 minutes", "02:00".

    Parameters
    ----------
    text : str
        The value of a tag.

    Returns
    -------
    float or None
        Seconds; None for no limit, or one that cannot be read.
    """
    plain = text.strip()
    if clock := CLOCK.fullmatch(plain):
        return 3600.0 * int(clock[1]) + 60.0 * int(clock[2])
    told = STAY.fullmatch(plain)
    unit = SECONDS.get(told[2].lower()) if told else None
    return float(told[1].replace(",", ".")) * unit if told and unit else None
