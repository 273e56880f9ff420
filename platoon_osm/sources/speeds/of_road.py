"""Which tag of a road decides how fast it is driven, and what caps that.

For trucks the order is: a sign for them (`maxspeed:hgv`), which only the limiter caps; a sign for
everybody (`maxspeed`, else `maxspeed:lanes`) and one for goods vehicles (`maxspeed:goods`); the
kind of place that the tags name (`maxspeed:type` and its like); what is usual on roads of the
class. All but the first are capped by the country's limit for trucks on such a road, and by the
limiter. `:forward` and `:backward` come before the plain keys. `maxspeed:advisory` is no limit.

A limit that is not understood makes no road faster than its lowest number, nor faster than the
road would be without the tag.
"""

from __future__ import annotations

from collections.abc import Mapping
from math import inf

from ..country.rules import FASTEST_KMH, TruckRules
from .texts import Limit, read_limit
from .zones import ZONE_KEYS, Zone, kind_of_road, zone_of_tags

__all__ = ["car_kmh", "is_speed_tag", "truck_kmh"]

CLASS_SPEEDS_KMH: Mapping[str, float] = {
    "motorway": 120.0, "trunk": 90.0, "primary": 70.0, "secondary": 60.0, "tertiary": 50.0,
}  # fmt: skip
LINK_SPEED_KMH = 50.0
OTHER_SPEED_KMH = 40.0

KIND_KEYS = frozenset({"motorroad", "dual_carriageway", "expressway"})
EVERYBODY = ("maxspeed", "maxspeed:lanes")

ODD = "maxspeed not understood"
LOWEST = "maxspeed not understood, its lowest number taken"
DEFAULTED = "speed defaulted from road class"
BY_LAW = "speed by the kind of place, as the law has it"
CAPPED = "speed capped for trucks"


def is_speed_tag(key: str) -> bool:
    """Say whether speeds depend on a tag.

    Parameters
    ----------
    key : str
        Key of a tag.

    Returns
    -------
    bool
        Whether they do.
    """
    return key.startswith(("maxspeed", *ZONE_KEYS)) or key in KIND_KEYS


def truck_kmh(tags: Mapping[str, str], side: str, rules: TruckRules, remarks: list[str]) -> float:
    """Return what a lone truck drives.

    Parameters
    ----------
    tags : mapping of str to str
        Of the road, without conditions.
    side : str
        "forward" or "backward".
    rules : TruckRules
        The truck and the law.
    remarks : list of str
        What was assumed or not understood is added to it.

    Returns
    -------
    float
        km/h.
    """
    road = _Road(tags, side, rules)
    kind = road.kind
    own = rules.law.truck_kmh(kind)
    if rules.law.code and kind not in rules.law.trucks:
        remarks.append(f"no truck limit in the table: {rules.law.code}, {kind} roads")
    cap = min(own, rules.limiter)
    sign, sure = road.sign(("maxspeed:hgv",), remarks, truck=True)
    if sign is not None and sure and not road.by_law(("maxspeed:hgv",)):
        return _capped(sign, rules.limiter, remarks)
    if sign is not None:
        cap = min(cap, sign)
    return _capped(road.general(remarks, truck=True), cap, remarks)


def car_kmh(tags: Mapping[str, str], side: str, rules: TruckRules) -> float:
    """Return what a light vehicle may drive: as posted, else as on roads of the class.

    Parameters
    ----------
    tags : mapping of str to str
        Of the road, without conditions.
    side : str
        "forward" or "backward".
    rules : TruckRules
        The country counts.

    Returns
    -------
    float
        km/h; 150 where there is no limit.
    """
    return _Road(tags, side, rules).general([], truck=False)


class _Road:
    """The tags of a road in one direction."""

    def __init__(self, tags: Mapping[str, str], side: str, rules: TruckRules) -> None:
        self.tags, self.side, self.rules = tags, side, rules
        self.country = rules.country or ""
        self.zone = zone_of_tags(tags, side)
        self.kind = kind_of_road(tags, self.zone or self._zone_of_limit())

    def _zone_of_limit(self) -> Zone | None:
        for _, limit in self._limits(("maxspeed",)):
            if limit.zones:
                return limit.zones[0]
        return None

    def _limits(self, keys: tuple[str, ...]) -> list[tuple[str, Limit]]:
        every = [own for key in keys for own in (f"{key}:{self.side}", key)]
        return [(key, read_limit(self.tags[key])) for key in every if key in self.tags]

    def by_law(self, keys: tuple[str, ...]) -> bool:
        """Say whether any of some limits names a kind of place, so that it is the law's."""
        return any(limit.zones for _, limit in self._limits(keys))

    def sign(
        self, keys: tuple[str, ...], remarks: list[str], *, truck: bool
    ) -> tuple[float | None, bool]:
        """Return the first limit that has a number, and whether all up to it was understood."""
        sure = True
        for _, limit in self._limits(keys):
            value = limit.kmh(self.kind, self.country, truck=truck)
            if value is None or not limit.sure:
                sure = sure and limit.sure and limit.trucks is not None
                remarks.append(ODD if value is None else LOWEST)
            if value is not None:
                return value, sure
        return None, sure

    def general(self, remarks: list[str], *, truck: bool) -> float:
        """Return the limit for everybody, and for goods vehicles."""
        sign, sure = self.sign(EVERYBODY, remarks, truck=truck)
        goods, goods_sure = self.sign(("maxspeed:goods",), remarks, truck=truck)
        lowest = min((value for value in (sign, goods) if value is not None), default=None)
        if lowest is not None and sure and goods_sure:
            return lowest
        noted: list[str] = []
        without = self._without_sign(noted)
        if lowest is None:
            remarks += noted
        return min(without, inf if lowest is None else lowest)

    def _without_sign(self, remarks: list[str]) -> float:
        if self.zone is not None:
            remarks.append(BY_LAW)
            return self.zone.car_kmh(self.kind, self.country)
        remarks.append(DEFAULTED)
        highway = self.tags.get("highway", "")
        usual = (
            LINK_SPEED_KMH
            if highway.endswith("_link")
            else CLASS_SPEEDS_KMH.get(highway, OTHER_SPEED_KMH)
        )
        return min(usual, self.rules.law.car_kmh(self.kind), FASTEST_KMH)


def _capped(speed: float, cap: float, remarks: list[str]) -> float:
    if speed > cap:
        remarks.append(CAPPED)
        return cap
    return speed
