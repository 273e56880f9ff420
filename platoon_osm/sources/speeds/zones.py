"""Limits by the kind of place: "DE:urban", "GB:nsl_dual", "FR:zone30".

They are values of `maxspeed` itself and of `maxspeed:type`, `source:maxspeed`, `zone:maxspeed` and
`zone:traffic`, of which the second often says something else ("sign", "survey").
"""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import dataclass

from ..country.law import MPH_IN_KMH, law_of
from ..way_sides import AGAINST, TRUE

__all__ = ["ZONE_KEYS", "Zone", "kind_of_road", "zone_of_tags", "zone_of_text"]

ZONE_KEYS = ("maxspeed:type", "source:maxspeed", "zone:maxspeed", "zone:traffic")

KIND_OF_NAME = {
    "motorway": "motorway", "trunk": "dual", "expressway": "dual", "motorroad": "dual",
    "express": "dual", "nsl_dual": "dual", "nsl_single": "rural", "rural": "rural",
    "urban": "urban", "nsl_restricted": "urban",
}  # fmt: skip
"""What a name says of the kind of a road."""

FALLBACK_KMH = {"motorway": 130.0, "dual": 110.0, "rural": 90.0, "urban": 50.0}
"""For cars, where the table has no limit of the country: what is customary in Europe. Trucks are
capped besides."""

SLOW_KMH = {
    "living_street": 20.0, "living street": 20.0, "walk": 7.0, "pedestrian_zone": 7.0,
    "pedestrian": 7.0, "bicycle_road": 30.0, "cyclestreet": 30.0, "zone": 30.0, "school": 30.0,
}  # fmt: skip
"""Places whose limit is much the same in all countries; walking pace as German courts have it."""

SLOWEST_FIRST = ("", "urban", "rural", "dual", "motorway")

ZONE = re.compile(
    r"(?:([a-z]{2}(?:-[a-z]{2,3})?):)?(?:zone[: _]?)?([a-z_ ]+|\d{1,3})(?: mph)?(?::hgv)?"
)

UNLIMITED_KMH = 150.0
MPH_COUNTRIES = ("GB", "US")


@dataclass(frozen=True, slots=True)
class Zone:
    """A kind of place.

    Attributes
    ----------
    kmh : float or None
        Its limit for cars; None if that depends on the kind of road.
    kind : str
        One of the law's kinds of road; empty if the text does not say.
    country : str
        Two letters, and a state where it stands there; empty if none does.
    """

    kmh: float | None
    kind: str
    country: str

    def car_kmh(self, kind: str, country: str) -> float:
        """Return everybody's limit there.

        Parameters
        ----------
        kind : str
            Of the road.
        country : str
            Where it is, if the text does not say.

        Returns
        -------
        float
            km/h; 150 where there is no limit.
        """
        if self.kmh is not None:
            return self.kmh
        law = law_of(self.country or country)
        # "Rural" holds on motorways of countries that have no sign of their own for them.
        own = kind if self.kind == "rural" and kind == "motorway" else self.kind
        return min(law.cars.get(own, FALLBACK_KMH[own]), UNLIMITED_KMH)


def zone_of_text(text: str, *, strict: bool = False) -> Zone | None:
    """Read the name of a kind of place.

    Parameters
    ----------
    text : str
        Such as "DE:urban", "DE:zone:30", "motorway" or "walk".
    strict : bool
        Whether it must begin with a country.

    Returns
    -------
    Zone or None
        None if the text is something else.
    """
    found = ZONE.fullmatch(text.strip().lower())
    if not found or (strict and not found.group(1)):
        return None
    country, name = (found.group(1) or "").upper(), found.group(2).strip()
    country = "GB" + country[2:] if country.startswith("UK") else country
    if name.isdigit():
        in_miles = country[:2] in MPH_COUNTRIES
        speed = float(name) * (MPH_IN_KMH if in_miles else 1.0)
        return Zone(speed, "", country) if country and 3 <= speed <= UNLIMITED_KMH else None
    if name in SLOW_KMH and (country or name != "zone"):
        return Zone(SLOW_KMH[name], "urban", country)
    kind = KIND_OF_NAME.get(name)
    return Zone(None, kind, country) if kind else None


def zone_of_tags(tags: Mapping[str, str], side: str) -> Zone | None:
    """Return the kind of place that the tags of a road name.

    Parameters
    ----------
    tags : mapping of str to str
        Of the road.
    side : str
        "forward" or "backward".

    Returns
    -------
    Zone or None
        That of the first key that can be read, the slowest of several; None if there is none.
    """
    for key in ZONE_KEYS:
        for own in (f"{key}:{side}", key):
            text = tags.get(own)
            if not text:
                continue
            zones = [zone_of_text(part, strict=True) for part in text.split(";")]
            known = [zone for zone in zones if zone is not None]
            if known:
                return min(known, key=lambda zone: SLOWEST_FIRST.index(zone.kind))
    return None


def kind_of_road(tags: Mapping[str, str], zone: Zone | None) -> str:
    """Return the kind of a road in the sense of the law.

    Parameters
    ----------
    tags : mapping of str to str
        Of the road.
    zone : Zone or None
        What its tags say of the place.

    Returns
    -------
    str
        "motorway", "dual", "rural" or "urban". A trunk road that is one-way is one carriageway of
        two; other one-way roads may be streets, so they count as rural, where trucks are slowest.
    """
    if zone is not None and zone.kind == "urban":
        return "urban"
    highway = tags.get("highway", "")
    if highway in {"motorway", "motorway_link"} or (zone is not None and zone.kind == "motorway"):
        return "motorway"
    if any(tags.get(key) == "yes" for key in ("motorroad", "dual_carriageway", "expressway")):
        return "dual"
    if zone is not None and zone.kind == "dual":
        return "dual"
    one_way = tags.get("oneway", "").strip().lower() in TRUE | AGAINST
    one_way = one_way and tags.get("dual_carriageway") != "no"
    return "dual" if one_way and highway in {"trunk", "trunk_link"} else "rural"
