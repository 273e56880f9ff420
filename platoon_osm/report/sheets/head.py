"""What a driver's sheet says beside the steps: alerts, figures, the law's clocks, notes."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from ...plans.clock import MENTIONED_S, duration
from ...plans.standing import waited_s
from ...plans.timetable import LATE_S, VehicleTimes
from ...shown_text import fitted, shortened
from ..document.findings import Findings
from ..document.model import Document
from ..language.speech import late_by, say
from ..maps.background import Background
from ..markup.fragments import Piece, Tree
from ..markup.quantities import carbon, cost_unit, kilometres, litres, true_minus
from .steps import Step
from .words import StepWords, Teller

__all__ = ["Journey", "alerts_of", "counted_of", "facts_of", "notes_of", "saved_of"]

LONGEST_NOTE = 260

BREAK_AFTER_S, BREAK_S = 4.5 * 3600, 45 * 60.0
"""Driving beyond the first without the second is said, whatever the law of the land."""


CLOCKS = {
    "spell": ("sheet.law-spell", "sheet.law-spell-of"),
    "day": ("sheet.law-day", "sheet.law-day-of"),
    "duty": ("sheet.law-duty", "sheet.law-duty-of"),
}
"""What rules count, in words, without a limit and with one."""


@dataclass(frozen=True, slots=True)
class Journey:
    """All that a sheet tells of one vehicle.

    Attributes
    ----------
    found : Findings
        Of the plan.
    document : Document
        Of the plan.
    index : int
        Position of the vehicle.
    steps : tuple of Step
        Of it.
    words : tuple of StepWords
        The same in words.
    background : Background
        The network behind the maps of all sheets.
    """

    found: Findings
    document: Document
    index: int
    steps: tuple[Step, ...]
    words: tuple[StepWords, ...]
    background: Background

    @property
    def times(self) -> VehicleTimes | None:
        """When it drives."""
        return self.found.plan.times[self.index]


def alerts_of(journey: Journey) -> list[str]:
    """Return what a driver has to know before all else: being late, and hours without a break.

    Parameters
    ----------
    journey : Journey
        Of the vehicle.

    Returns
    -------
    list of str
        Sentences.
    """
    found: list[str] = []
    plan, times = journey.found.plan, journey.times
    teller = Teller(journey.found, journey.index)
    if times is not None and times.late_s:
        first, latest = times.earliest_departure_s, times.latest_arrival_s
        assert latest is not None
        alone_s = plan.trips[journey.index].alone.time_s
        even_alone = first is not None and times.late_s <= first + alone_s - latest + LATE_S
        key = "sheet.late-alone" if even_alone else "sheet.late"
        found.append(say(key, by=late_by(times.late_s), latest=teller.time(latest)))
    if journey.document.law is not None:
        return found  # its clocks are told below, against what it allows
    longest = _longest_drive_s(journey.steps)
    if longest > BREAK_AFTER_S + MENTIONED_S:
        found.append(say("sheet.no-break", drive=duration(longest)))
    return found


def counted_of(journey: Journey) -> str:
    """Return what driving rules count of the journey, and what they allow.

    Parameters
    ----------
    journey : Journey
        Of the vehicle.

    Returns
    -------
    str
        A sentence; empty without rules.
    """
    law = journey.document.law
    if law is None:
        return ""
    own = law.vehicles[journey.index]
    parts = [say("sheet.law-driving", time=duration(own.driving_s))]
    counted = {"spell": own.spell_s, "day": own.day_s, "duty": own.duty_s}
    for clock, (free, limited) in CLOCKS.items():
        allowed_s, time = own.allowed[clock], duration(counted[clock])
        if allowed_s is None:
            parts.append(say(free, time=time))
        else:
            parts.append(say(limited, time=time, allowed=duration(allowed_s)))
    if own.breaks_s >= MENTIONED_S:
        parts.append(say("sheet.law-breaks", time=duration(own.breaks_s)))
    if own.rests_s >= MENTIONED_S:
        parts.append(say("sheet.law-rests", time=duration(own.rests_s)))
    if own.drivers > 1:
        parts.append(say("law.two-drivers"))
    rules = say(f"law.{law.rules}") if law.rules in ("eu561", "us395") else fitted(law.rules)
    return say("sheet.law", rules=rules, counted="; ".join(parts))


def saved_of(journey: Journey) -> str:
    """Return what the trip saves in money, fuel and CO2e, and the vehicle's share of the gain.

    Parameters
    ----------
    journey : Journey
        Of the vehicle.

    Returns
    -------
    str
        Sentences; empty of a vehicle alone, and where costs are no money.
    """
    plan = journey.found.plan
    bill, gain = plan.bill, plan.gain
    if bill is None or not plan.vehicles[journey.index].platoon_m:
        return ""
    own = bill.vehicles[journey.index]
    unit = cost_unit(fitted(bill.currency), to_the_cent=True)
    told = say(
        "sheet.saves" if own.saved_cents >= 0 else "sheet.costs-more",
        cost=unit.full(abs(own.saved_cents) / 100),
        fuel=true_minus(litres(own.alone_fuel_l - own.joint_fuel_l)),
        mass=true_minus(carbon(own.alone_kg[1] - own.joint_kg[1])),
    )
    if gain is None:
        return told
    part = gain.vehicles[journey.index]
    key = "sheet.share-receives" if part.payment_cents >= 0 else "sheet.share-pays"
    share, payment = unit.full(part.share_cents / 100), unit.full(abs(part.payment_cents) / 100)
    return f"{told} {say(key, share=share, payment=payment)}"


def _longest_drive_s(steps: Sequence[Step]) -> float:
    longest = run = 0.0
    for step in steps:
        run = 0.0 if step.wait_s >= BREAK_S else run
        run += step.way.drive_s if step.way else 0.0
        longest = max(longest, run)
    return longest


def notes_of(journey: Journey) -> list[str]:
    """Return what is said last: why the vehicle is alone, and what the map does not hold.

    Parameters
    ----------
    journey : Journey
        Of the vehicle.

    Returns
    -------
    list of str
        Sentences.
    """
    vehicle = journey.document.vehicles[journey.index]
    found: list[str] = []
    if vehicle.role == "alone":
        reason = shortened(vehicle.reason, LONGEST_NOTE)
        found.append(say("sheet.alone-for", reason=reason) if reason else say("sheet.alone"))
    if vehicle.inferred_text:
        found.append(say("sheet.inferred", km=vehicle.inferred_text))
    if vehicle.access_m:
        found.append(say("sheet.access"))
    return found


def facts_of(journey: Journey) -> Tree:
    """Return the figures of the journey.

    Parameters
    ----------
    journey : Journey
        Of the vehicle.

    Returns
    -------
    Tree
        Pieces of a list.
    """
    teller = Teller(journey.found, journey.index)
    own = journey.found.plan.vehicles[journey.index]
    times = journey.times
    told: list[tuple[str, str]] = []
    if times is not None:
        told.append((say("sheet.departure"), teller.time(times.departure_s)))
        told.append((say("sheet.arrival"), teller.time(times.arrival_s)))
        if times.latest_arrival_s is not None:
            told.append((say("sheet.latest"), teller.time(times.latest_arrival_s)))
    told.append((say("sheet.distance"), kilometres(own.length_m)))
    told.append((say("sheet.driving"), duration(own.time_s)))
    if own.platoon_m:
        told.append((say("sheet.together"), kilometres(own.platoon_m)))
    if times is not None and waited_s(times) >= MENTIONED_S:
        told.append((say("sheet.waits"), duration(waited_s(times))))
    return tuple(Piece("sheet-fact", {"label": label, "text": text}) for label, text in told)
