"""What a reader should know of a plan first: who is late or beyond the law, or that all is well.

Who is, is told with what would have to give: earlier departures, later arrivals, other company; or
what the planner itself remarks of a plan that no rules allow.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from ...driving.rules import RULES
from ...plans.clock import duration
from ...plans.lateness import NOT_FEASIBLE, NOT_IN_TIME, WAY_OUT, Lateness, who_is_late
from ...shown_text import fitted
from ..language.plan_sentences import in_language
from ..language.speech import late_by, number, say
from .model import Status
from .model_day import VehicleDay
from .model_law import Law
from .model_vehicle import Vehicle
from .wording import MOST_NAMED, joined

__all__ = ["lateness", "law_name", "status", "ways_out"]

BEYOND = {"spell": "status.spell", "day": "status.day", "duty": "status.duty"}
NAMES = {"eu561": "law.eu561", "us395": "law.us395", "spread-rest": "law.spread-rest"}


def status(
    called: Sequence[str],
    days: Sequence[VehicleDay | None],
    platoon: bool,
    law: Law | None = None,
    remarks: Sequence[str] = (),
    rules: str = "",
) -> Iterator[Status]:
    """Yield what heads the page, in a line each.

    Parameters
    ----------
    called : sequence of str
        What each vehicle is called.
    days : sequence of VehicleDay or None
        When each drives; None without times.
    platoon : bool
        Whether anybody drives in company.
    law : Law or None
        The driving rules of the plan.
    remarks : sequence of str
        Of the plan.
    rules : str
        Name of its rules, which is told where `law` has nothing to count.

    Yields
    ------
    Status
        Lateness and what would do, or that all are in time where latest arrivals were named;
        likewise of the law; and that nobody drives in platoon, if so.
    """
    found = who_is_late(days)
    if found.late:
        parts = (_late(found, len(called)), *_alone(found, called), *_gives(found, remarks))
        yield Status("bad", "; ".join(parts))
    elif found.asked:
        yield Status("good", say("status.in-time", n=len(called)))
    for remark in remarks:
        # Who is late has been told.
        told = found.late and remark.startswith(NOT_IN_TIME)
        if remark.startswith(NOT_FEASIBLE) and not told:
            text = fitted(in_language(remark))
            yield Status("bad", text[:1].upper() + text[1:])
    for remark in ways_out(remarks):
        yield Status("plain", fitted(in_language(remark)))
    if law is not None:
        beyond = list(_beyond(law, called))
        if beyond:
            yield Status("bad", "; ".join(beyond))
        else:
            yield Status("good", say("status.legal", rules=law_name(law.rules)))
    elif rules:
        yield Status("plain", say("law.rules", rules=law_name(rules)))
    if not platoon:
        yield Status("plain", say("status.no-platoon", n=len(called)))


def ways_out(remarks: Sequence[str]) -> list[str]:
    """Return the remarks on what would do for those who cannot be in time, as far as they head it.

    Parameters
    ----------
    remarks : sequence of str
        Of a plan.

    Returns
    -------
    list of str
        The first few.
    """
    return [remark for remark in remarks if f" {WAY_OUT} " in remark][:MOST_NAMED]


def _late(found: Lateness, every: int) -> str:
    """Return how many are late, and by how much at most."""
    most = late_by(found.most_s)
    return say("status.late", n=len(found.late), all=number(every), most=most)


def _alone(found: Lateness, called: Sequence[str]) -> Iterator[str]:
    """Yield who would be late even alone; if nobody would, that."""
    if len(found.even_alone) == len(found.late):
        yield say("status.all-even-alone", n=len(found.late))
    elif found.even_alone:
        names = [called[place] for place in found.even_alone]
        yield say("status.even-alone", n=len(names), who=joined(names))
    elif found.in_time_alone:
        yield say("status.in-time-alone", n=len(found.late))


def _gives(found: Lateness, remarks: Sequence[str]) -> Iterator[str]:
    """Yield what would have to give, where the planner has said so."""
    if any(one.startswith(NOT_IN_TIME) for one in remarks):
        alone = len(found.even_alone) == len(found.late)
        yield say("status.give-other-times" if alone else "status.give-other-company")


def _beyond(law: Law, called: Sequence[str]) -> Iterator[str]:
    """Yield who goes beyond what is allowed, by how much; of many, how many more."""
    found = [
        say(
            BEYOND[one.clock],
            who=who,
            time=duration(one.counted_s),
            allowed=duration(one.allowed_s),
        )
        for who, clocks in zip(called, law.vehicles, strict=True)
        for one in clocks.excess
    ]
    yield from found[:MOST_NAMED]
    if len(found) > MOST_NAMED:
        yield say("status.more-beyond", n=len(found) - MOST_NAMED)


def law_name(rules: str) -> str:
    """Return what driving rules are called where they are told.

    Parameters
    ----------
    rules : str
        Their name.

    Returns
    -------
    str
        In the language that is spoken, as far as it is known.
    """
    if rules in NAMES:
        return say(NAMES[rules])
    known = RULES.get(rules)
    return known.about if known else fitted(rules)


def lateness(vehicles: Sequence[Vehicle]) -> Iterator[str]:
    """Yield who of some vehicles that end at one place is late, and by how much.

    Parameters
    ----------
    vehicles : sequence of Vehicle
        Of the document.

    Yields
    ------
    str
        Of a lone vehicle how late it is; of several also who; of many, how many more are late.
    """
    late = [vehicle for vehicle in vehicles if vehicle.is_late]
    for vehicle in late[:MOST_NAMED]:
        text = say("script.mark-late", time=vehicle.day.text.late)
        yield f"{vehicle.called}: {text}" if len(vehicles) > 1 else text
    if len(late) > MOST_NAMED:
        yield say("status.more-late", n=len(late) - MOST_NAMED)
