"""What must hold in what a plan says of money and chances before anybody relies on it."""

from __future__ import annotations

from collections.abc import Sequence

from ..kinds import is_number, is_whole
from .bill import Bill
from .chances import Chances, MeetingChance
from .gain import GainSharing
from .needed import all_finite, need
from .records import Event, PlannedTrip

__all__ = ["check_money"]


def check_money(
    trips: Sequence[PlannedTrip],
    events: Sequence[Event],
    bill: Bill | None,
    gain: GainSharing | None,
    chances: Chances | None,
) -> None:
    """Check that bill, shares and chances are those of the plan's vehicles and merges.

    Parameters
    ----------
    trips, events : sequence
        Fields of `Plan`.
    bill : Bill or None
        What it costs.
    gain : GainSharing or None
        Who gets what it saves.
    chances : Chances or None
        How likely its merges are.

    Raises
    ------
    ScenarioError
        In one line: what does not fit.
    """
    count = len(trips)
    if bill is not None:
        need(len(bill.vehicles) == count, f"its bill is that of {len(bill.vehicles)} vehicles")
        for one in bill.vehicles:
            cents = (*one.alone_cents, *one.joint_cents)
            need(all(map(is_whole, cents)), "its bill has an amount that is no whole cents")
            kg = (*one.alone_kg, *one.joint_kg, one.alone_fuel_l, one.joint_fuel_l)
            need(all_finite(kg), "its bill has a number that is not finite")
        values = [figure.value for figure in bill.figures]
        need(all_finite(values), "its bill has a figure that is not finite")
    if gain is not None:
        need(len(gain.vehicles) == count, f"its gain is shared by {len(gain.vehicles)} vehicles")
        parts = [cents for one in gain.vehicles for cents in (one.saved_cents, one.share_cents)]
        need(all(map(is_whole, parts)), "its gain has an amount that is no whole cents")
        need(
            sum(one.payment_cents for one in gain.vehicles) == 0,
            "what is paid for its gain is not what is received",
        )
    if chances is None:
        return
    need(
        all_finite(
            value
            for value in (
                chances.planned_saving,
                chances.expected_saving,
                chances.saving_error,
                chances.closed_form_saving,
            )
            if value is not None
        ),
        "its chances have a number that is not finite",
    )
    for meeting in chances.meetings:
        _check_meeting(meeting, events)


def _check_meeting(one: MeetingChance, events: Sequence[Event]) -> None:
    fits = is_whole(one.event) and 0 <= one.event < len(events)
    need(fits and events[one.event].kind == "merge", "it has a chance of no merge")
    need(is_number(one.chance) and 0 <= one.chance <= 1, "a merge has a chance beyond 1")
    numbers = (
        one.mean_s, one.spread_s, one.expected_wait_s, one.window_s, one.wait_up_to_s,
        one.gain, one.missed_cost, one.movers_wait_up_to_s, one.missed_late_s,
    )  # fmt: skip
    need(all_finite(numbers), "a merge has a number that is not finite")
