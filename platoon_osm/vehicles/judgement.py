"""May this vehicle pass here? The strictest of all that the map says decides."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass
from datetime import datetime

from .access import Way, barrier_way, deciding
from .conditions import apply
from .limits import Passed, limits_on
from .profile import Vehicle

__all__ = ["CLOSE_M", "CLOSE_SHARE", "Judgement", "judge"]

CLOSE_M = 0.10
"""Who passes under a bridge or between walls with less room than this should know [m]."""

CLOSE_SHARE = 0.05
"""Likewise who weighs so nearly what a bridge bears, as a share of that."""

TUNNEL = ("hazmat:adr_tunnel_cat", "hazmat:adr_tunnel_category", "adr_tunnel_category")


@dataclass(frozen=True, slots=True)
class Judgement:
    """What a road is to a vehicle.

    Attributes
    ----------
    way : Way
        Open, open at the ends of a trip, or closed.
    reasons : tuple of str
        Why it is not open, in words; the kind of reason stands in `kinds`.
    kinds : tuple of str
        The tags that decided, as "hgv" or "maxheight".
    margins : tuple of Passed
        Limits that are passed with little room.
    undecided : bool
        Whether hours or weather decide that are not known.
    """

    way: Way = Way.OPEN
    reasons: tuple[str, ...] = ()
    kinds: tuple[str, ...] = ()
    margins: tuple[Passed, ...] = ()
    undecided: bool = False


def judge(
    layers: Iterable[Mapping[str, str]],
    vehicle: Vehicle,
    when: datetime | None = None,
    place: tuple[float, float] | None = None,
    country: str | None = None,
) -> Judgement:
    """Judge what the map restricts for a vehicle.

    Parameters
    ----------
    layers : iterable of mapping of str to str
        As `network.restrictions.decode` returns them; all of them hold.
    vehicle : Vehicle
        Who drives.
    when : datetime, optional
        What clocks on the spot show; without it, hours are undecided.
    place : (float, float), optional
        Longitude and latitude, for the sun.
    country : str, optional
        Two letters, for public holidays.

    Returns
    -------
    Judgement
        Open if nothing is restricted.
    """
    found: list[tuple[Way, str, str]] = []
    margins: list[Passed] = []
    undecided = False
    for layer in layers:
        tags, open_question = apply(layer, vehicle, when, place, country)
        undecided |= open_question
        found += _closings(tags, vehicle)
        for passed in limits_on(tags, vehicle):
            if not passed.fits:
                found.append((Way.CLOSED, passed.key, passed.told))
            elif _is_close(passed):
                margins.append(passed)
    way = max((one for one, _, _ in found), default=Way.OPEN)
    strictest = [(key, told) for one, key, told in found if one == way]
    if way == Way.OPEN:
        strictest = []
    return Judgement(
        way,
        tuple(dict.fromkeys(told for _, told in strictest)),
        tuple(dict.fromkeys(key for key, _ in strictest)),
        tuple(margins),
        undecided,
    )


def _closings(tags: Mapping[str, str], vehicle: Vehicle) -> Iterator[tuple[Way, str, str]]:
    decided = False
    for key, way in deciding(tags, vehicle):
        decided = True
        if way != Way.OPEN:
            yield way, key, _told(tags, key)
    if "barrier" in tags and not decided and (way := barrier_way(tags)) != Way.OPEN:
        yield way, "barrier", f"a {tags['barrier'].replace('_', ' ')} stands there"
    if vehicle.hazardous:
        for key in TUNNEL:
            category = tags.get(key, "").strip().upper()
            # Code C: closed are tunnels of category C, D and E (ADR 8.6.4).
            if len(category) == 1 and "B" <= category <= "E" and category >= vehicle.tunnel_code:
                yield (
                    Way.CLOSED,
                    key,
                    f"tunnel of category {category} (the load has tunnel code "
                    f"{vehicle.tunnel_code})",
                )


def _told(tags: Mapping[str, str], key: str) -> str:
    at = f" at a {tags['barrier'].replace('_', ' ')}" if "barrier" in tags else ""
    return f"{key}={tags[key]}{at}"


def _is_close(passed: Passed) -> bool:
    room = passed.limit - passed.value
    return room < CLOSE_M if passed.kind.unit == "m" else room < CLOSE_SHARE * passed.limit
