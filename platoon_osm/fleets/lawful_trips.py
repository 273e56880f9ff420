"""Which trips of a fleet can be driven within the law: the others are listed, with the reason."""

from __future__ import annotations

from dataclasses import replace

from ..errors import NoLegalTripError, PlatoonError, ScenarioError
from ..planning.asked import Asked
from ..planning.legal.legal_question import LegalQuestion
from ..planning.problem import Problem
from ..planning.question import Question
from ..plans.clock import late_by
from ..plans.fleet import Unserved
from ..plans.timetable import LATE_S

__all__ = ["lawful"]


def lawful(question: Question) -> tuple[LegalQuestion, list[Unserved]]:
    """Return the question of the trips that can be driven alone in time and within the law.

    Parameters
    ----------
    question : Question
        What is asked, with driving rules that have limits.

    Returns
    -------
    legal : LegalQuestion
        Of those trips, with their lawful trips alone.
    unserved : list of Unserved
        The others.

    Raises
    ------
    ScenarioError
        None can.
    """
    problem = question.problem
    vehicles = [problem.vehicle_of(trip) for trip in problem.trips]
    refused: dict[int, NoLegalTripError] = {}
    legal = LegalQuestion(question, vehicles, refused)
    reasons = {index: _plain(problem, index, error) for index, error in refused.items()}
    if not reasons:
        for index, late_s in enumerate(legal.late_s):
            if late_s > LATE_S:
                reasons[index] = (
                    f"late even alone by {late_by(late_s)} with its breaks and rests; give an "
                    "earlier departure or a later arrival"
                )
        if not reasons:
            return legal, []
    unserved = [
        Unserved(problem.trips[index].vehicle, reason) for index, reason in sorted(reasons.items())
    ]
    stay = tuple(trip for index, trip in enumerate(problem.trips) if index not in reasons)
    if not stay:
        raise ScenarioError(
            f"fleet: no trip can be driven within the law; {unserved[0].vehicle!r}: "
            f"{unserved[0].reason}"
        )
    left, others = lawful(Asked.of(replace(problem, trips=stay)).question)
    return left, [*unserved, *others]


def _plain(problem: Problem, index: int, error: PlatoonError) -> str:
    """Return a reason without the vehicle, which is told beside it."""
    return str(error).removeprefix(f"{problem.trips[index].vehicle}: ")
