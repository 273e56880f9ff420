"""Whether a vehicle may be driven at some time: bans as intervals of time.

The clocks of the country count, so a ban that ends at 22:00 ends then in summer and in winter, and
an hour that clocks leave out is in no ban. Moments without a zone are taken to be of these clocks.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from datetime import UTC, date, datetime, time, timedelta
from zoneinfo import ZoneInfo

from ...errors import ScenarioError
from ...vehicles.profile import Vehicle
from .calendar import means
from .rules import CountryBans, Road, Rule, bans_of

__all__ = ["Ban", "banned", "driving_intervals"]

ANY_ROAD = Road()
"""A motorway without a number."""

LONGEST = timedelta(days=3660)
"""Nobody asks for the bans of more than ten years at once."""


@dataclass(frozen=True, slots=True)
class Ban:
    """A time in which a vehicle may not be driven.

    Attributes
    ----------
    country : str
        Two letters.
    name : str
        Of the rule, such as "night ban".
    begin, end : datetime
        In the zone of the country.
    source : str
        The law.
    """

    country: str
    name: str
    begin: datetime
    end: datetime
    source: str


def banned(
    country: str,
    vehicle: Vehicle,
    start: datetime,
    end: datetime,
    road: Road = ANY_ROAD,
    quiet: bool = True,
) -> list[Ban]:
    """Return the bans that a vehicle meets between two moments.

    Parameters
    ----------
    country : str
        Two letters.
    vehicle : Vehicle
        Who drives.
    start, end : datetime
        From when until when; without a zone, by the clocks of the country.
    road : Road
        Where; a motorway unless told.
    quiet : bool
        Whether the vehicle is certified as quiet, as nearly all of today are.

    Returns
    -------
    list of Ban
        Whole, also where they begin before `start` or end after `end`; by their begin. Empty for a
        country whose bans are not known here.

    Raises
    ------
    ScenarioError
        More than ten years, or moments with and without a zone.
    """
    bans = bans_of(country.upper())
    if bans is None:
        return []
    zone = ZoneInfo(bans.zone)
    if (start.tzinfo is None) != (end.tzinfo is None):
        raise ScenarioError("driving bans: give both moments with their zone, or both without")
    first, last = (_by_clocks_of(zone, at) for at in (start, end))
    if last.astimezone(UTC) - first.astimezone(UTC) > LONGEST:
        raise ScenarioError("driving bans: more than ten years are asked for; ask for fewer")
    rules = [rule for rule in bans.rules if rule.concerns(vehicle, road, quiet)]
    found = {
        ban
        for rule in rules
        for day in _days(first.date() - timedelta(days=2), last.date() + timedelta(days=2))
        if means(rule, bans, day)
        for ban in _on(rule, bans, day, zone)
        if _utc(ban.begin) < _utc(last) and _utc(first) < _utc(ban.end)
    }
    return sorted(found, key=lambda ban: (_utc(ban.begin), _utc(ban.end), ban.name))


def driving_intervals(
    country: str,
    vehicle: Vehicle,
    start: datetime,
    end: datetime,
    road: Road = ANY_ROAD,
    quiet: bool = True,
) -> list[tuple[datetime, datetime]]:
    """Return when a vehicle may be driven between two moments.

    Parameters
    ----------
    country, vehicle, start, end, road, quiet : object
        As in `banned`.

    Returns
    -------
    list of (datetime, datetime)
        In order, with the zone of the country where bans are known, else as given.
    """
    bans = bans_of(country.upper())
    if bans is not None:
        zone = ZoneInfo(bans.zone)
        start, end = (_by_clocks_of(zone, at) for at in (start, end))
    found: list[tuple[datetime, datetime]] = []
    at = start
    for ban in banned(country, vehicle, start, end, road, quiet):
        if _utc(at) < _utc(ban.begin):
            found.append((at, ban.begin))
        at = max(at, ban.end, key=_utc)
    if _utc(at) < _utc(end):
        found.append((at, end))
    return found


def _by_clocks_of(zone: ZoneInfo, at: datetime) -> datetime:
    """Return a moment with a zone; without its own it is what clocks there show."""
    return at.replace(tzinfo=zone) if at.tzinfo is None else at.astimezone(zone)


def _days(first: date, last: date) -> Iterator[date]:
    while first <= last:
        yield first
        first += timedelta(days=1)


def _on(rule: Rule, bans: CountryBans, day: date, zone: ZoneInfo) -> Iterator[Ban]:
    if rule.day_before:
        day -= timedelta(days=1)
    for hours in rule.hours:
        begin, end = (_moment(day, text, zone) for text in hours.split("-"))
        if _utc(end) <= _utc(begin):
            end = _moment(day + timedelta(days=1), hours.split("-")[1], zone)
        yield Ban(bans.country, rule.name, begin, end, rule.source)


def _moment(day: date, text: str, zone: ZoneInfo) -> datetime:
    hour, minute = map(int, text.split(":"))
    if hour == 24:
        day, hour = day + timedelta(days=1), 0
    at = datetime.combine(day, time(hour, minute), zone)
    # An hour that clocks leave out is that of the moment they jump to.
    return at.astimezone(UTC).astimezone(zone)


def _utc(at: datetime) -> datetime:
    """Return a moment that can be compared: clocks of one zone show an hour twice."""
    return at if at.tzinfo is None else at.astimezone(UTC)
