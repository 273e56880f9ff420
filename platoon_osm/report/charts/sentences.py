"""What the schedule of a vehicle says to those who do not see the drawing."""

from __future__ import annotations

from collections.abc import Sequence

from ...plans.clock import MENTIONED_S
from ..document.model_vehicle import Vehicle
from ..drawing.crowd import MOST_SPOKEN
from ..language.speech import say

__all__ = ["sentence", "spoken_list"]


def sentence(vehicle: Vehicle) -> str:
    """Return when a vehicle leaves, waits and arrives.

    Parameters
    ----------
    vehicle : Vehicle
        Of a plan with times.

    Returns
    -------
    str
        Such as "B leaves 04:30, waits 1 h 41 min, arrives 11:58".
    """
    text = vehicle.day.text
    parts = [say("schedule.leaves", vehicle=vehicle.letter, time=text.departure)]
    if text.held:
        parts.append(say("schedule.held", time=text.held))
    if vehicle.day.waiting_s >= MENTIONED_S:
        parts.append(say("schedule.waits", time=text.waiting))
    parts.append(say("schedule.arrives", time=text.arrival))
    if text.late:
        parts.append(say("schedule.is-late", time=text.late))
    return ", ".join(parts)


def spoken_list(vehicles: Sequence[Vehicle]) -> str:
    """Return the sentences of some vehicles, as many as one listens to.

    Parameters
    ----------
    vehicles : sequence of Vehicle
        Of a plan with times.

    Returns
    -------
    str
        With the number of those left out.
    """
    parts = [sentence(vehicle) for vehicle in vehicles[:MOST_SPOKEN]]
    if (more := len(vehicles) - MOST_SPOKEN) > 0:
        parts.append(say("schedule.more", n=more))
    return "; ".join(parts)
