"""Which things of the map are stops for trucks, and what of their tags is kept.

Rest areas and service areas are stops. A parking, a fuel station or a charging station is one where
its tags say that trucks use it. What nobody may enter from the road is none, and what speaks of
trucks in words that cannot be read is counted. docs/stops.md has the table.

Source: https://wiki.openstreetmap.org/wiki/Tag:amenity=parking, Tag:amenity=fuel,
Tag:amenity=charging_station, Key:capacity, Key:hgv, Key:access.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

from ...network.stop_tags import FUELS, NO, YES, kilowatts, stay_s
from ...vehicles.access import CHAIN, VALUES, Way, read_value
from ...vehicles.limits import LIMITS

__all__ = [
    "STOP_TAGS",
    "TRUCK_KEYS",
    "StopReading",
    "is_for_others",
    "is_stop_tag",
    "read_stop",
]

Tags = Mapping[str, str]

AREAS = {"services": "services", "rest_area": "rest_area"}
AMENITIES = {"parking": "parking", "fuel": "fuel", "charging_station": "charging"}

STOP_TAGS = (
    *(("highway", value) for value in AREAS),
    *(("amenity", value) for value in AMENITIES),
)
"""Tags of which one is on everything that may be a stop."""

CAPACITIES = ("capacity:hgv", "capacity:truck", "capacity:hgv_articulated")
PARKINGS = ("parking:hgv", "hgv:parking", "parking:truck")
TRUCK_KEYS = ("hgv", "truck", *CAPACITIES, *PARKINGS)
"""Keys of a parking that speak of trucks; one without any, or the values below, is for others."""

TRUCK_WORDS = frozenset({"hgv", "truck", "trucks", "lorry", "lorries"})
"""Values of `access` and `parking` by which a parking is for trucks alone."""

ONLY = TRUCK_WORDS | {"only"}

OTHERS = ("motorcar", "car", "motor_vehicle", "vehicle", "access", "bus", "caravan", "motorhome")
"""Where one of these is open, a parking is not for trucks alone."""

ADMITS = frozenset(
    {
        "customers", "customer", "destination", "delivery", "visitors", "guests", "business",
        "service", "local",
    }
)  # fmt: skip
"""Of the values that are open to who ends a trip there, those that admit a stranger who rests."""

NO_STOP = ("disused", "abandoned", "construction", "proposed", "razed")

KEPT = frozenset(
    {
        "hgv", "goods", "motor_vehicle", "vehicle", "access", "capacity", "fee", "maxstay",
        "maxstay:hgv", "opening_hours", "charging_station:output", "hgv:lanes", *CAPACITIES,
        *LIMITS,
    }
)  # fmt: skip
MOST_SPACES = 10_000
"""The largest truck stop of the world has 900; more than this is a mistake."""


@dataclass(frozen=True, slots=True)
class StopReading:
    """What the tags of a stop mean.

    Attributes
    ----------
    kind : str
        Of `STOP_KINDS`.
    name : str
        Its name; that of its brand where it has none.
    tags : mapping of str to str
        What is kept.
    capacity : int
        Spaces for trucks, -1 where not known.
    trucks : bool
        Whether it is a stop for trucks by itself; a fuel station that does not say so is one only
        as part of a service area.
    """

    kind: str
    name: str
    tags: Tags
    capacity: int
    trucks: bool


def is_for_others(tags: Any) -> bool:
    """Tell a parking that does not speak of trucks, for maps hold them by the hundred thousand.

    Parameters
    ----------
    tags : mapping of str to str, or osmium.osm.TagList
        Of anything.

    Returns
    -------
    bool
        Whether it is such a parking.
    """
    return (
        tags.get("amenity") == "parking"
        and "highway" not in tags
        and not any(key in tags for key in TRUCK_KEYS)
        and tags.get("access") not in TRUCK_WORDS
        and tags.get("parking") not in TRUCK_WORDS
    )


def is_stop_tag(key: str) -> bool:
    """Say whether a key is looked at on a stop.

    Parameters
    ----------
    key : str
        Of a tag.

    Returns
    -------
    bool
        Whether `read_stop` reads it.
    """
    return (
        key in KEPT
        or key in ("highway", "amenity", "name", "brand", "parking", *PARKINGS, *OTHERS, *NO_STOP)
        or key.startswith(("fuel:", "socket:"))
    )


def read_stop(tags: Tags, counts: Counter[str]) -> StopReading | None:
    """Read the tags of something that may be a stop.

    Parameters
    ----------
    tags : mapping of str to str
        Of a node, an area or a relation.
    counts : Counter
        Counts what is not a stop, and what could not be read.

    Returns
    -------
    StopReading or None
        None if it is no stop.
    """
    area = AREAS.get(tags.get("highway", ""))
    kind = area or AMENITIES.get(tags.get("amenity", ""))
    if kind is None:
        return None
    label = "service and rest areas" if area else f"{kind} places"
    if any(tags.get(key, "no").strip().lower() not in NO for key in NO_STOP):
        counts[f"{label} out of use"] += 1
        return None
    spaces, told = _spaces(tags, counts)
    trucks = True if area else _for_trucks(tags, kind, spaces, told)
    if trucks is None:
        counts[f"{label} that say nothing of trucks"] += 1
        if kind != "fuel":
            return None
    if trucks is False or not _admitted(tags, counts, area is not None):
        counts[f"{label} not open to trucks"] += 1
        return None
    if kind == "parking" and not told and "capacity" in tags and _trucks_alone(tags):
        spaces = _number(tags["capacity"], counts)
    kept = {"highway": area} if area else {"amenity": tags["amenity"]}
    kept |= {key: value for key, value in tags.items() if key in KEPT} | _access_tags(tags)
    kept |= _fuel_tags(tags, counts) | _charging_tags(tags, counts)
    for key in ("maxstay", "maxstay:hgv"):
        if key in kept and stay_s(kept[key]) is None and kept[key].strip().lower() not in NO:
            counts["longest stays not understood"] += 1
    name = tags.get("name") or ("" if area else tags.get("brand", ""))
    return StopReading(kind, name, kept, spaces, bool(trucks))


def _number(text: str, counts: Counter[str]) -> int:
    """Return a number of spaces, -1 if the text is none."""
    plain = text.strip()
    # Other digits than ours are decimals too, but nobody would look them up.
    if plain.isascii() and plain.isdecimal() and int(plain[:9]) <= MOST_SPACES and len(plain) < 9:
        return int(plain)
    counts["capacities for trucks not understood"] += 1
    return -1


def _spaces(tags: Tags, counts: Counter[str]) -> tuple[int, bool]:
    """Return the spaces for trucks, and whether the map speaks of them at all."""
    for key in CAPACITIES:
        if key in tags:
            text = tags[key].strip().lower()
            if text in NO:
                return 0, True
            if text in YES - {"1"}:
                return -1, True
            return _number(text, counts), True
    return -1, False


def _word(tags: Tags) -> str | None:
    return next((tags[key] for key in ("hgv", "truck") if key in tags), None)


def _for_trucks(tags: Tags, kind: str, spaces: int, told: bool) -> bool | None:
    """Tell whether trucks use it: True, False, or None where the map does not say."""
    word = _word(tags)
    if word is not None:
        return _opens(word)
    if told:
        return spaces != 0
    if tags.get("access", "").strip().lower() in TRUCK_WORDS:
        return True
    if kind == "parking":
        if tags.get("parking", "").strip().lower() in TRUCK_WORDS:
            return True
        values = [tags[key].strip().lower() for key in PARKINGS if key in tags]
        return (values[0] not in NO) if values else None
    if kind == "fuel":
        large = ("hgv_diesel", "lng", "biolng", "bio_lng", "lbg")
        sold = any(
            key[5:].lower() in large and value.strip().lower() in YES
            for key, value in tags.items()
            if key.startswith("fuel:")
        )
        return True if sold or "hgv:lanes" in tags else None
    return True if tags.get("socket:mcs", "no").strip().lower() not in NO else None


def _opens(value: str) -> bool:
    """Tell whether a value of an access key admits who only wants to stop there."""
    if value.strip().lower() in ONLY:
        return True
    way, _ = read_value(value)
    return way == Way.OPEN or (way == Way.ENDS and value.strip().lower() in ADMITS)


def _admitted(tags: Tags, counts: Counter[str], area: bool) -> bool:
    """Tell whether strangers may drive in; `hgv=no` on an area is kept, and judged later."""
    keys = [key for key in CHAIN if key in tags]
    if area:
        keys = [key for key in keys if key not in ("hgv", "hgv_articulated")]
        if "hgv" in tags and _opens(tags["hgv"]):
            return True
    elif _word(tags) is not None:
        return True  # it opens, or nobody would ask
    if not keys:
        return True
    value = tags[keys[0]].strip().lower()
    if value not in VALUES and value not in TRUCK_WORDS:
        counts["access of stops not understood, taken as closed"] += 1
    return _opens(value)


def _access_tags(tags: Tags) -> dict[str, str]:
    """Return access keys whose values are words of stops alone in those of roads."""
    word = _word(tags)
    if word is not None:
        return {"hgv": "designated" if word.strip().lower() in ONLY else word}
    if tags.get("access", "").strip().lower() in TRUCK_WORDS:
        return {"access": "no", "hgv": "designated"}
    return {}


def _trucks_alone(tags: Tags) -> bool:
    """Tell whether a parking is for trucks and nobody else, so that its capacity is theirs."""
    if any(tags.get(key, "").strip().lower() in TRUCK_WORDS for key in ("access", "parking")):
        return True
    word = (_word(tags) or "").strip().lower()
    if word == "only":
        return True
    others = [tags[key] for key in OTHERS if key in tags]
    if any(read_value(value)[0] != Way.CLOSED and value != "private" for value in others):
        return False
    return word == "designated" or bool(word and others)


def _fuel_tags(tags: Tags, counts: Counter[str]) -> dict[str, str]:
    kept = {}
    for key, value in tags.items():
        if not key.startswith("fuel:") or key[5:].lower() not in FUELS:
            continue
        text = value.strip().lower()
        if text in YES or (text.isascii() and text.isdecimal() and text.strip("0")):
            kept[key] = "yes"
        elif text not in NO:
            counts["fuels not understood"] += 1
    return kept


def _charging_tags(tags: Tags, counts: Counter[str]) -> dict[str, str]:
    if tags.get("amenity") != "charging_station":
        return {}
    kept = {}
    for key, value in tags.items():
        if key == "charging_station:output" or (
            key.startswith("socket:") and key.endswith(":output")
        ):
            if kilowatts(value) is None:
                counts["charging powers not understood"] += 1
            else:
                kept[key] = value
        elif key.startswith("socket:") and key.count(":") == 1 and value.strip().lower() not in NO:
            kept[key] = value
    return kept
