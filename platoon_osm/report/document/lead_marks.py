"""Who leads from where on, in words, and the position of each vehicle on the clock.

Both are told of plans whose lead is handed on; in others a position is that of the order in which
the plan names its vehicles.
"""

from __future__ import annotations

from ...plans.clock import MENTIONED_S
from ...plans.plan import Plan
from ...plans.positions import LeadRun, PositionSpan, lead_runs, positions_of
from ...shown_text import fitted
from ..language.speech import clock_time, say
from ..markup.quantities import kilometres
from .findings import Findings
from .model_lead import LeadTurn, PositionMark

__all__ = ["lead_turns", "position_marks"]


def lead_turns(found: Findings) -> tuple[LeadTurn, ...]:
    """Return who leads from where on.

    Parameters
    ----------
    found : Findings
        Of the plan.

    Returns
    -------
    tuple of LeadTurn
        Platoon by platoon in driving order; none where the leaders stay in front.
    """
    if found.plan.rotation is None:
        return ()
    return tuple(_turn(found, run) for group in lead_runs(found.plan) for run in group)


def _turn(found: Findings, run: LeadRun) -> LeadTurn:
    table = found.plan.timetable
    what = say("lead.leads", who=found.styles[run.vehicle].letter)
    if table is not None and run.start_s is not None:
        what = f"{clock_time(table.clock, run.start_s)}, {what}"
    km = kilometres(run.length_m)
    return LeadTurn(
        vehicle=run.vehicle,
        name=fitted(run.begins),
        text=what,
        detail=say("lead.to", km=km, place=fitted(run.ends)) if run.ends else km,
    )


def position_marks(plan: Plan) -> tuple[tuple[PositionMark, ...], ...]:
    """Return the positions of each vehicle in company.

    Parameters
    ----------
    plan : Plan
        Any.

    Returns
    -------
    tuple of tuple of PositionMark, (N, ...)
        In driving order; none where the leaders stay in front, or without times.
    """
    marks: list[list[PositionMark]] = [[] for _ in plan.trips]
    if plan.rotation is not None and plan.timetable is not None:
        for span in positions_of(plan):
            if span.size > 1:
                marks[span.vehicle].append(_mark(plan, span))
    return tuple(map(tuple, marks))


def _mark(plan: Plan, span: PositionSpan) -> PositionMark:
    times = plan.times[span.vehicle]
    assert times is not None
    pieces: list[tuple[float, float]] = []
    for begin, end in times.legs[span.first : span.last + 1]:
        if pieces and begin - pieces[-1][1] < MENTIONED_S:
            pieces[-1] = pieces[-1][0], end
        else:
            pieces.append((begin, end))
    begin, end = max(pieces, key=lambda piece: piece[1] - piece[0])
    return PositionMark(span.position, span.size, round(begin, 1), round(end, 1))
