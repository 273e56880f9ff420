"""What plans are set side by side by besides costs: hours, breaks and rests, the law, the proof.

Hours count from door to door, of all vehicles together: driving, breaks, rests and waits. A plan
under driving rules keeps them, or cannot be as it was asked for within them: somebody is late, or
leaves later than it was to; or its clocks go beyond what is allowed.
"""

from __future__ import annotations

from dataclasses import dataclass

from ...plans.plan import Plan
from ...plans.standing import standing
from ...plans.timetable import LATE_S, Timetable
from .model_law import Law

__all__ = ["SideSums", "side_sums"]

KEPT, LATE, HELD, BEYOND = "kept", "late", "leaves late", "beyond"


@dataclass(frozen=True, slots=True)
class SideSums:
    """The day of a plan in sums over all vehicles.

    Attributes
    ----------
    rules : str
        The driving rules by which breaks and rests are placed; empty without any.
    breaks, rests : int
        How often a vehicle takes a break, a part of one counting as one, and a daily or weekly
        rest.
    breaks_s, rests_s : float
        How long those last [s].
    under_way_s : float
        From each departure to the arrival [s].
    law : str
        "kept"; "late" or "leaves late", which is not feasible within the law; "beyond" what is
        allowed; empty without rules that ask for breaks.
    by_s : float
        Of the latter three, by how much at most [s]; else 0.
    """

    rules: str
    breaks: int
    rests: int
    breaks_s: float
    rests_s: float
    under_way_s: float
    law: str
    by_s: float


def side_sums(plan: Plan, law: Law | None) -> SideSums | None:
    """Return the sums of a plan's day.

    Parameters
    ----------
    plan : Plan
        Of any kind.
    law : Law or None
        Its driving rules, as its document has them.

    Returns
    -------
    SideSums or None
        None without times.
    """
    table = plan.timetable
    if table is None:
        return None
    pauses = [pause for times in table.vehicles for pause in standing(times) if pause.is_break]
    rests = [pause.duration_s for pause in pauses if pause.is_rest]
    breaks = [pause.duration_s for pause in pauses if not pause.is_rest]
    told, by_s = ("", 0.0) if law is None else _law(table, law)
    return SideSums(
        rules=table.rules,
        breaks=len(breaks),
        rests=len(rests),
        breaks_s=sum(breaks),
        rests_s=sum(rests),
        under_way_s=sum(times.arrival_s - times.departure_s for times in table.vehicles),
        law=told,
        by_s=by_s,
    )


def _law(table: Timetable, law: Law) -> tuple[str, float]:
    """Return whether driving rules are kept, and by how much a plan fails; what is worst first."""
    beyond = [one.counted_s - one.allowed_s for own in law.vehicles for one in own.excess]
    late = [times.late_s for times in table.vehicles]
    held = [
        times.departure_s - times.latest_departure_s
        for times in table.vehicles
        if times.latest_departure_s is not None
    ]
    for told, by in ((BEYOND, beyond), (LATE, late), (HELD, held)):
        if (most := max(by, default=0.0)) > LATE_S:
            return told, most
    return KEPT, 0.0
