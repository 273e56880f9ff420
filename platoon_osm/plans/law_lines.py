"""A plan under driving rules as text: for each vehicle its driving, breaks and rests."""

from __future__ import annotations

from ..driving.rules import RULES, places_pauses
from ..shown_text import fitted
from .clock import MENTIONED_S, Clock, duration
from .pauses import Pause, PausePlace
from .plan import Plan
from .standing import asked_by_rules, day_ends_s, driven_s, standing
from .text_table import MOST_NAMES, named
from .timetable import Timetable, VehicleTimes

__all__ = ["law_lines", "pause_text", "place_text", "rules_text"]

PURPOSES = {
    "weekly_rest": "weekly rest",
    "daily_rest": "daily rest",
    "reduced_daily_rest": "reduced daily rest",
    "break": "break",
    "second_part": "second part of a break",
    "first_part": "first part of a break",
    "change": "change of drivers",
    "ban": "driving ban",
    "company": "wait for company",
}

KINDS = {
    "rest_area": "rest area",
    "truck_parking": "truck parking",
    "fuel": "fuel station",
    "junction": "junction, no parking known",
}


def law_lines(plan: Plan) -> list[str]:
    """Return what driving rules make of a plan, a vehicle a line.

    Parameters
    ----------
    plan : Plan
        Any.

    Returns
    -------
    list of str
        First the rules, which are all there is to say of rest that is spread over the driving;
        empty for a plan without rules and without planned pauses.
    """
    table = plan.timetable
    if table is None:
        return []
    if not places_pauses(table.rules) and not any(map(_is_planned, table.vehicles)):
        return rules_text(table)
    lines = [_vehicle(times, table.clock, table.rules) for times in table.vehicles]
    return [*rules_text(table), *lines]


def _is_planned(times: VehicleTimes) -> bool:
    """Return whether a vehicle stands for more than its company."""
    return any(one.purposes != ("company",) for one in times.pauses)


def rules_text(table: Timetable) -> list[str]:
    """Return by which driving rules a timetable was made.

    Parameters
    ----------
    table : Timetable
        Of a plan.

    Returns
    -------
    list of str
        One sentence; none without rules.
    """
    if not table.rules:
        return []
    known = RULES.get(table.rules)
    text = f"Driving rules: {fitted(known.about if known else table.rules)}"
    if table.task_relief:
        text += f"; a follower's clock slows by {table.task_relief:.0%}"
    return [f"{text}."]


def _vehicle(times: VehicleTimes, clock: Clock, rules: str) -> str:
    ends = " and ".join(clock.text(at) for at in day_ends_s(times))
    driven = driven_s(times)
    text = f"{named(times.vehicle)} drives {duration(sum(driven))} until {ends}"
    if len(driven) > 1:
        text += f", its drivers {' and '.join(map(duration, driven))}"
    if at_origin := _before_leaving(times, clock):
        text += f"; {at_origin}"
    told = [one for one in standing(times) if asked_by_rules(one) or one in times.pauses]
    parts = [pause_text(one, clock) for one in told[:MOST_NAMES]]
    if len(told) > MOST_NAMES:
        parts.append(f"{len(told) - MOST_NAMES} more pauses")
    if not told and places_pauses(rules):
        parts = ["no break"]
    return "; ".join([text, *parts])


def _before_leaving(times: VehicleTimes, clock: Clock) -> str:
    """Tell of rest at the origin, which may be a break or a part of one for who drove before."""
    begin_s = min((one.state_at_s for one in times.drivers), default=times.departure_s)
    tired = any(one.state.driven_since_break_s or one.state.duty_s for one in times.drivers)
    if not tired or times.departure_s - begin_s < MENTIONED_S:
        return ""
    return f"at rest {clock.text(begin_s)} to {clock.text(times.departure_s)} before it leaves"


def pause_text(pause: Pause, clock: Clock) -> str:
    """Return a pause in a few words.

    Parameters
    ----------
    pause : Pause
        Of a plan.
    clock : Clock
        Of its timetable.

    Returns
    -------
    str
        Such as "break 10:15 to 11:00 at Secchia Ovest (services)".
    """
    what = " and ".join(PURPOSES[purpose] for purpose in pause.purposes)
    when = f"{clock.text(pause.start_s)} to {clock.text(pause.end_s)}"
    where = f" at {place_text(pause.place)}" if pause.place else ""
    return f"{what} {when}{where}"


def place_text(place: PausePlace) -> str:
    """Return where a vehicle stands, by name and kind.

    Parameters
    ----------
    place : PausePlace
        Of a pause.

    Returns
    -------
    str
        Such as "Secchia Ovest (services)"; the kind alone of a place without a name.
    """
    kind = KINDS.get(place.kind, fitted(place.kind).replace("_", " "))
    return f"{named(place.name)} ({kind})" if place.name else kind
