"""In words: what would have to give for those who cannot be in time within the law."""

from __future__ import annotations

from collections.abc import Iterator

from ...driving.rules import team_of
from ...plans.clock import late_by
from ...plans.lateness import WAY_OUT
from .driver.why_not import why_not
from .legal_question import LegalQuestion

__all__ = ["what_would_do"]

MOST = 5
"""Of more vehicles that are late only so many are told what would do."""

REMEDIES = {
    "second_driver": "with a second driver",
    "rested": "with a driver who has rested before",
    "long_day": "if its driver had one more day of longer driving left",
    "reduced_rest": "if its driver had one more reduced daily rest left",
}


def what_would_do(legal: LegalQuestion) -> Iterator[str]:
    """Yield what would have to give, for vehicles that cannot keep their times alone.

    Parameters
    ----------
    legal : LegalQuestion
        What is asked, with its law.

    Yields
    ------
    str
        A remark for each way out, vehicle by vehicle.
    """
    late = [
        index
        for index, (asked, own) in enumerate(zip(legal.asked, legal.alone, strict=True))
        if own.after_latest_s or (asked.arrival is not None and own.trip.arrival_s > asked.arrival)
    ]
    problem = legal.question.problem
    for index in late[:MOST]:
        asked, own, rules = legal.asked[index], legal.alone[index], legal.rules[index]
        team = team_of(problem.rules, rules.state)
        earliest, latest, arrival = (
            None if at is None else int(at) for at in (asked.earliest, asked.latest, asked.arrival)
        )
        found = why_not(
            own.way.road, rules.limits, team, rules.state, rules.state_at_s,
            earliest, latest, arrival, legal.monday_s,
        )  # fmt: skip
        if found is None:
            continue
        name = legal.question.ends[index].vehicle
        if found.earlier_s:
            yield f"{name} {WAY_OUT} if it might leave earlier by {late_by(found.earlier_s)}"
        if found.later_s:
            yield f"{name} {WAY_OUT} if it might leave later by {late_by(found.later_s)}"
        for remedy in found.remedies:
            yield f"{name} {WAY_OUT} {REMEDIES[remedy]}"
