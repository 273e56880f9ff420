"""Who leads a plan whose lead is handed on, in lines that can be read aloud."""

from __future__ import annotations

from collections.abc import Sequence

from .plan import Plan
from .positions import LeadRun, lead_runs
from .text_table import MOST_ROWS, named

__all__ = ["lead_lines"]


def lead_lines(plan: Plan) -> list[str]:
    """Return who leads from where to where, a line a platoon, and how even that is.

    Parameters
    ----------
    plan : Plan
        Any.

    Returns
    -------
    list of str
        Empty where leaders stay in front.
    """
    rotation = plan.rotation
    if rotation is None:
        return []
    lines = [_line(plan, runs) for runs in lead_runs(plan)]
    away = f"{rotation.worst_m / 1000:,.0f} km"
    return [
        *lines,
        f"Each leads its fair share to within {away}; nobody hands on the lead before "
        f"{rotation.least_m / 1000:,.0f} km in front.",
    ]


def _line(plan: Plan, runs: Sequence[LeadRun]) -> str:
    parts: list[str] = []
    last: LeadRun | None = None
    for run in runs[:MOST_ROWS]:
        who = named(plan.trips[run.vehicle].vehicle)
        begins = f" from {named(run.begins)}" if run.begins and _apart(last, run) else ""
        ends = f" to {named(run.ends)}" if run.ends else ""
        verb = " leads" if last is None else ""
        parts.append(f"{who}{verb}{begins}{ends} ({run.length_m / 1000:,.0f} km)")
        last = run
    more = len(runs) - MOST_ROWS
    text = ", then ".join(parts)
    return f"{text}, and {more:,} more turns." if more > 0 else f"{text}."


def _apart(last: LeadRun | None, run: LeadRun) -> bool:
    return last is None or last.ends != run.begins
