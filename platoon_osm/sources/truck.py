"""What the tags of a road mean for a heavy vehicle: direction, access, speed and toll."""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping
from dataclasses import dataclass

from ..network.restrictions import encode
from ..vehicles.conditional_values import CONDITIONAL, has_conditions
from ..vehicles.conditions import apply
from ..vehicles.profile import DEFAULT_VEHICLE, VEHICLES
from .country.rules import TruckRules
from .restricting_tags import is_restriction, open_to_any, restricting, unread
from .speeds.of_road import car_kmh, is_speed_tag, truck_kmh
from .way_sides import AGAINST, CHANGING, FALSE, SIDES, TRUE, Layers, for_side, sides_of

__all__ = [
    "TOLL_KEYS", "Side", "TruckRules", "WayReading", "dropped", "is_driving_tag", "read_way",
]  # fmt: skip

LIGHT = VEHICLES["van-3.5t"]
"""Whose speed is that of light vehicles where it depends on mass."""

TOLL_KEYS = ("toll:hgv", "toll:N3", "toll")
"""The first that is there says whether a heavy truck pays."""

FORWARD, BACKWARD, BOTH = 1, -1, 0


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
    toll_free : bool
        Whether the map says that they do not.
    """

    speed_kmh: float
    posted_kmh: float
    restriction: str
    toll: bool
    toll_free: bool


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
    toll_free : bool
        Whether the map says that trucks pay no toll, which is more than to say nothing of it.
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
    toll_free: bool = False

    @property
    def along(self) -> Side:
        """In its only direction, else along the way as it is drawn."""
        return Side(self.speed_kmh, self.posted_kmh, self.restriction, self.toll, self.toll_free)

    @property
    def against(self) -> Side:
        """In its only direction, else against the way."""
        return Side(
            self.backward_kmh, self.backward_posted_kmh, self.backward_restriction, self.toll,
            self.toll_free,
        )  # fmt: skip


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
        for name, layers in zip(SIDES, sides_of(tags, one_way, counts), strict=True)
    ]
    usable = [text is not None and not reason for text, reason in sides]
    # A road that nobody may drive keeps its direction, for the reader of its tags.
    direction = (FORWARD if usable[0] else BACKWARD) if sum(usable) == 1 else BOTH
    if not any(usable):
        direction = one_way
    noted: list[list[str]] = [[], []]
    ways = [_speeds(tags, side, rules, own) for side, own in zip(SIDES, noted, strict=True)]
    first = int(direction == BACKWARD)
    last = first if direction != BOTH else 1
    for own in (noted[first], noted[last]):
        # A remark counts once for a way, whichever direction it is about.
        remarks += [remark for remark in own if remark not in remarks]
    toll = next((tags[key].strip().lower() for key in TOLL_KEYS if key in tags), "")
    for key in unread(tags):
        counts[f"restrictions not read: {key}"] += 1
    return WayReading(
        direction=direction,
        allowed=any(usable),
        speed_kmh=ways[first][0],
        toll=toll not in FALSE and toll != "",
        toll_free=toll in FALSE,
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
    tags: Mapping[str, str], side: str, rules: TruckRules, remarks: list[str]
) -> tuple[float, float]:
    """Return what a truck drives in a direction, and what is posted for light vehicles."""
    own = {key: value for key, value in tags.items() if not is_restriction(key)}
    if not has_conditions(own):
        return truck_kmh(own, side, rules, remarks), car_kmh(own, side, rules)
    truck, undecided = apply(own, DEFAULT_VEHICLE)
    if undecided:
        remarks.append("speed limits at some hours or in some weather, not judged")
    van, _ = apply(own, LIGHT)
    return truck_kmh(truck, side, rules, remarks), car_kmh(van, side, rules)


DRIVING_TAGS = frozenset({"highway", "oneway", "junction", *TOLL_KEYS})


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
        or key.startswith("oneway")
        or is_speed_tag(key)
        or key.endswith(CONDITIONAL)
        or is_restriction(key)
        or bool(unread([key]))
    )


def _direction(tags: Mapping[str, str], remarks: list[str]) -> int:
    value = tags.get("oneway", "").strip().lower()
    if value in TRUE:
        return FORWARD
    if value in AGAINST:
        return BACKWARD
    if value in FALSE:
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
