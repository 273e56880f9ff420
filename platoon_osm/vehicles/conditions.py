"""Tags that hold under conditions: `maxspeed:conditional = 60 @ (22:00-06:00 AND weight>7.5)`.

Of the rules that hold, the last one counts; if none holds, the plain tag stands.

Each condition of a rule is one of these:

- about the vehicle ("weight>7.5", "length>12", "trailer", "hgv", "hazmat"): always decided;
- times ("Mo-Fr 07:00-19:00", "Nov-Mar", "PH", "sunset-sunrise"): decided for a moment;
- a purpose ("destination", "delivery"): who only passes has none, and who starts or ends there may
  have it. So "yes" under a purpose is that purpose as a value of access, which ends a trip;
- weather ("wet", "snow", "winter"), or a text nobody can read: undecided.

An undecided rule does not count, the plain tag stands, and the caller is told, unless the rule
would not change anything.

Source: https://wiki.openstreetmap.org/wiki/Conditional_restrictions
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from datetime import datetime, timedelta
from functools import lru_cache

from .conditional_values import CONDITIONAL, OLD_FORMS, Rule, rules_of
from .hours import LongLat, hours_change, hours_hold, reads_as_hours
from .profile import Vehicle
from .vehicle_conditions import Asked, asked_of

__all__ = ["apply", "next_change"]

PURPOSES = {
    "destination": "destination", "delivery": "delivery", "deliveries": "delivery",
    "customers": "customers", "customer": "customers", "permit": "permit", "private": "private",
    "loading": "delivery", "unloading": "delivery", "residents": "private",
}  # fmt: skip
"""What somebody is there for, and the value of access that says so."""

OPEN_VALUES = frozenset({"yes", "designated", "permissive", "official", "destination", "delivery"})

LIMITS = ("max", "min", "oneway", "overtaking", "restriction")
"""Beginnings of keys whose values are no values of access."""

FURTHEST = timedelta(days=366)
MOST_CHANGES = 2000
"""How far and how often `next_change` looks for a change that matters."""


def apply(
    tags: Mapping[str, str],
    vehicle: Vehicle,
    when: datetime | None = None,
    place: LongLat | None = None,
    country: str | None = None,
) -> tuple[dict[str, str], bool]:
    """Return tags with their conditions settled for a vehicle at a moment.

    Parameters
    ----------
    tags : mapping of str to str
        Of a road.
    vehicle : Vehicle
        Who drives.
    when : datetime, optional
        What clocks on the spot show; without it, times are undecided.
    place : (float, float), optional
        Longitude and latitude, for the sun.
    country : str, optional
        Two letters, for public holidays.

    Returns
    -------
    tags : dict of str to str
        Plain tags only.
    undecided : bool
        Whether something that is not known would change them.
    """
    plain = {
        key: value
        for key, value in tags.items()
        if not key.endswith(CONDITIONAL) and not OLD_FORMS.search(key)
    }
    undecided = any(OLD_FORMS.search(key) for key in tags)
    asking = _Asking(vehicle, when, place, country)
    for key in sorted(tags):
        if not key.endswith(CONDITIONAL):
            continue
        base = key.removesuffix(CONDITIONAL)
        found = plain.get(base)
        open_questions: list[str] = []
        for rule in reversed(rules_of(tags[key])):
            holds, value = asking.settled(base, rule)
            if holds:
                found = value
                break
            if holds is None:
                open_questions.append(value)
        undecided |= any(value != found for value in open_questions)
        if base and found is not None:
            plain[base] = found
    return plain, undecided


def next_change(
    tags: Mapping[str, str],
    vehicle: Vehicle,
    when: datetime,
    place: LongLat | None = None,
    country: str | None = None,
) -> datetime | None:
    """Return when tags next say something else to a vehicle.

    Parameters
    ----------
    tags : mapping of str to str
        Of a road.
    vehicle : Vehicle
        Who drives.
    when : datetime
        What clocks on the spot show.
    place : (float, float), optional
        Longitude and latitude, for the sun.
    country : str, optional
        Two letters, for public holidays.

    Returns
    -------
    datetime or None
        After `when`, without a zone; None if nothing changes within a year.
    """
    times = {
        condition
        for key, text in tags.items()
        if key.endswith(CONDITIONAL)
        for rule in rules_of(text)
        for condition in rule.conditions
        if _is_hours(condition)
    }
    at = begin = when.replace(tzinfo=None)
    now = apply(tags, vehicle, at, place, country)
    for _ in range(MOST_CHANGES):
        try:
            changes = [
                found
                for condition in times
                if (found := hours_change(condition, at, place, country)) is not None and found > at
            ]
        except OverflowError:
            return None
        if not changes or min(changes) - begin > FURTHEST:
            return None
        at = min(changes)
        if apply(tags, vehicle, at, place, country) != now:
            return at
    return None


@dataclass(frozen=True, slots=True)
class _Asking:
    """Who asks, when and where."""

    vehicle: Vehicle
    when: datetime | None
    place: LongLat | None
    country: str | None

    def settled(self, base: str, rule: Rule) -> tuple[bool | None, str]:
        """Return whether a rule holds, None if undecided, and what it then says."""
        if not rule.conditions:
            return None, rule.value
        purpose = None
        answers = []
        for condition in rule.conditions:
            word = PURPOSES.get(condition.lower())
            if word is None:
                answers.append(self._holds(condition))
            else:
                purpose = word
        if False in answers:
            return False, rule.value
        if None in answers:
            return None, rule.value
        if purpose is None:
            return True, rule.value
        if rule.value.lower() in OPEN_VALUES and not base.startswith(LIMITS):
            return True, purpose
        return None, rule.value

    def _holds(self, condition: str) -> bool | None:
        asked = _asked(condition)
        if asked is not None:
            return asked(self.vehicle)
        if self.when is None:
            return None
        return hours_hold(condition, self.when, self.place, self.country)


@lru_cache(maxsize=20_000)
def _asked(condition: str) -> Asked | None:
    return asked_of(condition)


def _is_hours(condition: str) -> bool:
    return (
        condition.lower() not in PURPOSES
        and _asked(condition) is None
        and reads_as_hours(condition)
    )
