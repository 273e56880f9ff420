"""Merges and separations in words: who joins whom, when, and after how long a way."""

from __future__ import annotations

from itertools import takewhile

from ...plans.bill import CENTS
from ...plans.chances import MeetingChance
from ...plans.clock import MENTIONED_S, duration
from ...plans.records import Event
from ...shown_text import fitted, shortened, shown
from ..language.speech import clock_time, number, say
from ..markup.quantities import carbon, kilometres
from .findings import Findings
from .model_map import EventMark
from .stop_names import brief_name
from .timeline import waits_at
from .wording import MOST_NAMED, joined

__all__ = ["event_mark", "likely", "told_events"]

ROUNDED = 0.03
"""Amounts that differ by less differ by the rounding of their terms."""

SELDOM = 0.005
"""A chance nearer than this to 0 or 1 is not told as if it were certain."""


def told_events(found: Findings) -> list[int]:
    """Return which events pages show: who drive on together to a common end do not separate.

    Parameters
    ----------
    found : Findings
        Of the plan.

    Returns
    -------
    list of int
        Positions among the plan's events, in their order.
    """
    events = found.plan.events
    return [number for number, event in enumerate(events) if not _at_common_end(found, event)]


def _at_common_end(found: Findings, event: Event) -> bool:
    return event.kind == "separation" and _end_of_all(found, event.stretch)


def _arrive_together(found: Findings, event: Event) -> bool:
    """Return whether those who join, and all who drive with them last, arrive in company."""
    ends = {found.plan.ways[mover][-1] for mover in event.movers}
    return len(ends) == 1 and _end_of_all(found, *ends)


def _end_of_all(found: Findings, stretch: int) -> bool:
    """Return whether a stretch of a platoon is the last of all who drive it."""
    company = found.plan.stretches[stretch].company
    return len(company) > 1 and all(_ends_with(found, who, stretch) for who in company)


def _ends_with(found: Findings, vehicle: int, stretch: int) -> bool:
    return found.plan.ways[vehicle][-1] == stretch


def likely(chance: float) -> str:
    """Return how likely something is, in whole percent.

    Parameters
    ----------
    chance : float
        Of 1.

    Returns
    -------
    str
        Nearer than half a percent to 0 or 1 it is told as "less than 1 %", "more than 99 %".
    """
    if chance < SELDOM:
        return say("chances.seldom", share=say("form.percent", number=number(1)))
    if chance > 1 - SELDOM:
        return say("chances.often", share=say("form.percent", number=number(99)))
    return say("form.percent", number=number(chance * 100))


def _not_there(found: Findings, event: Event, chance: MeetingChance) -> str:
    """Return how long to wait for each other, and what it costs not to meet."""
    first = event.others or event.movers
    if chance.wait_up_to_s >= MENTIONED_S:
        key, time = "chances.wait-up-to", duration(chance.wait_up_to_s)
    else:
        key, time = "chances.no-wait", ""
    parts = [say(key, n=len(first), who=joined(found.letters(first)), time=time)]
    if chance.expected_wait_s >= MENTIONED_S:
        parts.append(say("chances.expected-wait", time=duration(chance.expected_wait_s)))
    if chance.missed_cost > 0:
        parts.append(say("chances.missed", cost=found.unit.full(chance.missed_cost)))
    return ", ".join(parts)


def event_mark(found: Findings, place: int) -> EventMark:
    """Return one event of a plan.

    Parameters
    ----------
    found : Findings
        Of the plan.
    place : int
        Its position among the events.

    Returns
    -------
    EventMark
        All that pages show of it.
    """
    event, at_s = found.plan.events[place], found.moments[place]
    point = event.point
    chance = found.plan.chances.of_event(place) if found.plan.chances else None
    details = [_detail(found, event), _waiting(found, event, at_s), _saving(found, event)]
    text = _text(found, event, at_s)
    if chance is not None:
        text = say("chances.beside", what=text, chance=likely(chance.chance))
        details.append(_not_there(found, event, chance))
    return EventMark(
        kind=event.kind,
        lon=round(found.longitude(point.lon), 6),
        lat=round(point.lat, 6),
        name=fitted(point.name),
        vehicles=event.movers,
        others=event.others,
        at_m=_on_scale(found, event),
        at_s=None if at_s is None else round(at_s, 1),
        text=text,
        detail=", ".join(text for text in details if text),
    )


def _text(found: Findings, event: Event, at_s: float | None) -> str:
    who, others = joined(found.letters(event.movers)), found.letters(event.others)
    n = len(event.movers)
    if not others and n > 1:
        # Case D: both vehicles come to the point, and both leave it.
        what = say("events.meet" if event.kind == "merge" else "events.part", who=who)
    elif event.kind == "merge":
        if 0 < len(others) <= MOST_NAMED:
            what = say("events.joins", n=n, who=who, whom=joined(others))
        else:
            what = say("events.joins-platoon", n=n, who=who)
    elif all(_ends_with(found, one, event.stretch) for one in event.movers):
        what = say("events.arrives", n=n, who=who)
    else:
        what = say("events.leaves", n=n, who=who)
    table = found.plan.timetable
    return what if table is None or at_s is None else f"{clock_time(table.clock, at_s)}, {what}"


def _on_scale(found: Findings, event: Event) -> float | None:
    if found.scale is None:
        return None
    first = event.movers[0]
    vehicle = found.plan.vehicles[first]
    point = vehicle.merge if event.kind == "merge" else vehicle.separation
    return round(found.scale.starts_m[first] + (point.km if point else 0.0) * 1000, 1)


def _waiting(found: Findings, event: Event, at_s: float | None) -> str:
    """Return who waits there and how long: "B waits 24 min", at most a few."""
    waits = waits_at(found.plan, event, at_s)
    parts = [
        say("events.waits", who=found.styles[i].letter, time=duration(wait))
        for i, wait in waits[:MOST_NAMED]
    ]
    if len(waits) > MOST_NAMED:
        parts.append(say("events.more-wait", n=len(waits) - MOST_NAMED))
    return ", ".join(parts)


def _saving(found: Findings, event: Event) -> str:
    """Return what those who join save until they drive alone again; empty where it is no money."""
    plan = found.plan
    if plan.bill is None or event.kind != "merge":
        return ""
    money = mass_kg = 0.0
    for mover in event.movers:
        way, bill = plan.ways[mover], plan.bill.vehicles[mover]
        own = [plan.stretches[k] for k in way[way.index(event.stretch) :]]
        shares = [one.share_of(mover) for one in takewhile(lambda one: one.together, own)]
        gained = sum(share.gain or 0.0 for share in shares)
        whole = bill.saved_cents / CENTS
        # To the cent as in the table, where it is all that the vehicle saves.
        money += whole if abs(gained - whole) < ROUNDED else gained
        saved_l = sum(share.alone_fuel_l - share.fuel_l for share in shares)
        mass_kg += saved_l * bill.alone_kg[1] / bill.alone_fuel_l if bill.alone_fuel_l else 0.0
    return say(
        "events.saves", n=len(event.movers), who=joined(found.letters(event.movers)),
        cost=found.unit.full(money), kg=carbon(mass_kg),
    )  # fmt: skip


def _detail(found: Findings, event: Event) -> str:
    edges = found.plan.stretches[event.stretch].edges
    edge = edges[0] if event.kind == "merge" else edges[-1]
    road = shortened(shown(found.net.edge_ref(edge)), 40)
    first = found.plan.vehicles[event.movers[0]]
    parts = [road]
    one, at_end = len(event.movers) == 1, _ends_with(found, event.movers[0], event.stretch)
    if one and event.kind == "merge":
        km = first.merge.km if first.merge else 0.0
        origin = fitted(brief_name(first.origin.name, first.origin.lon, first.origin.lat))
        parts.append(
            say("events.from", km=kilometres(km * 1000), place=origin)
            if km >= 0.05
            else say("events.at-start")
        )
    elif one:
        parts.append(say("events.after", km=kilometres(first.platoon_m)))
        if not at_end:
            parts.append(say("events.towards", place=fitted(first.destination.name)))
    if event.kind == "merge" and _arrive_together(found, event):
        parts.append(say("events.together", place=fitted(first.destination.name)))
    return ", ".join(part for part in parts if part)
