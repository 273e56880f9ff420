"""What a reader should know of a plan first: who is late, or that all are in time, or alone."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from ...plans.lateness import Lateness, who_is_late
from ..language.speech import late_by, number, say
from .model import Status
from .model_day import VehicleDay
from .model_vehicle import Vehicle
from .wording import MOST_NAMED, joined

__all__ = ["lateness", "status"]


def status(
    called: Sequence[str], days: Sequence[VehicleDay | None], platoon: bool
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

    Yields
    ------
    Status
        Lateness, or that all are in time where latest arrivals were named; and that nobody drives
        in platoon, if so.
    """
    found = who_is_late(days)
    if found.late:
        yield Status("bad", "; ".join((_late(found, len(called)), *_alone(found, called))))
    elif found.asked:
        yield Status("good", say("status.in-time", n=len(called)))
    if not platoon:
        yield Status("plain", say("status.no-platoon", n=len(called)))


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
