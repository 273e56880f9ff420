"""What must hold in how the lead of a plan is handed on, whoever made it."""

from __future__ import annotations

from collections.abc import Sequence

from .needed import all_finite, need
from .records import PlannedTrip, Stretch
from .rotation import Rotation

__all__ = ["check_rotation"]


def check_rotation(
    trips: Sequence[PlannedTrip], stretches: Sequence[Stretch], rotation: Rotation | None
) -> None:
    """Check that changes of the lead are those of the plan's companies.

    Parameters
    ----------
    trips, stretches : sequence
        Fields of `Plan`.
    rotation : Rotation or None
        How its lead is handed on.

    Raises
    ------
    ScenarioError
        In one line: what does not fit.
    """
    if rotation is None:
        return
    need(
        len(rotation.fair_m) == len(rotation.led_m) == len(trips),
        "its lead is shared by other vehicles",
    )
    numbers = (rotation.least_m, *rotation.fair_m, *rotation.led_m)
    need(all_finite(numbers), "its lead has a number that is not finite")
    need(all(0 <= one < len(trips) for one in rotation.spared), "it spares nobody that is in it")
    for change in rotation.changes:
        need(0 <= change.stretch < len(stretches), "its lead is handed on at no stretch")
        order = stretches[change.stretch].vehicles
        need(change.former in order[1:], "its lead is handed on by nobody who falls back")
