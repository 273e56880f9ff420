"""The law's clocks along each vehicle's day: what its driving rules count, against what they allow.

Three clocks run. Driving since the last break stops at a break: a gap that the plan says is one, or
its second part, or any gap of the length of a whole one. Driving since the last rest, and the time
since that rest ended, stop at a daily or weekly rest, or at any gap as long as a reduced one. Where
a follower's task is relieved, its driving counts for less. On a day that needs it the longer limit
is the one that counts; how often that may be is not looked at here, nor are weeks.

This draws a plan; what proves it is the checker of plans.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, field

from ...driving.limits import Limits
from ...driving.rules import RULES
from ...plans.plan import Plan
from ...plans.timetable import VehicleTimes
from .model_law import ClockPoint, Clocks, Excess, Law
from .stands import stands_of

__all__ = ["law_of"]

CLOCKS = ("spell", "day", "duty")

SLACK_S = 1.0
"""What is beyond a limit by less is rounding."""


def law_of(plan: Plan) -> Law | None:
    """Return the driving rules of a plan, and what they count.

    Parameters
    ----------
    plan : Plan
        Whose drivers are meant.

    Returns
    -------
    Law or None
        None without times, without rules, or under rules that limit nothing or are not known here.
    """
    table = plan.timetable
    rules = RULES.get(table.rules) if table is not None else None
    if table is None or rules is None or not rules.alone.limits_driving:
        return None
    alone = rules.alone
    return Law(
        rules=table.rules,
        task_relief=table.task_relief,
        vehicles=tuple(
            _clocks(plan, index, alone, rules.team) for index in range(len(table.vehicles))
        ),
    )


def _finite(seconds: float) -> float | None:
    return seconds if math.isfinite(seconds) else None


def _clocks(plan: Plan, index: int, alone: Limits, team: Limits | None) -> Clocks:
    times = plan.times[index]
    assert times is not None
    drivers = _drivers(times)
    run = _Run(team if drivers > 1 and team is not None else alone)
    stands = stands_of(times)
    run.begin(times)
    relief = plan.timetable.task_relief if plan.timetable else 0.0
    for stretch_id, (begin, end) in zip(plan.ways[index], times.legs, strict=True):
        stretch = plan.stretches[stretch_id]
        follows = stretch.together and stretch.vehicles[0] != index
        here = [one for one in stands if run.at - SLACK_S < one.begin_s < begin]
        if begin > run.at:
            run.stand(
                begin,
                rests=any(one.kind == "rest" for one in here),
                restarts=any(one.restarts for one in here),
            )
        run.drive(end, 1.0 - relief * follows)
    run.end_day()
    lasts = {"break": 0.0, "rest": 0.0}
    for one in stands:
        if one.kind in lasts:
            lasts[one.kind] += one.lasts_s
    return Clocks(
        drivers=drivers,
        driving_s=sum(end - begin for begin, end in times.legs),
        breaks_s=lasts["break"],
        rests_s=lasts["rest"],
        spell_s=run.most["spell"],
        day_s=run.most["day"],
        duty_s=run.most["duty"],
        allowed={name: _finite(run.allowed.get(name, math.inf)) for name in CLOCKS},
        excess=tuple(run.excess.values()),
        points=tuple(run.points),
    )


def _drivers(times: VehicleTimes) -> int:
    return max([len(times.drivers), *(one.state.drivers for one in times.drivers), 1])


@dataclass(slots=True)
class _Run:
    """Clocks that run along a day; `today` holds what is drawn when its limits are known."""

    limits: Limits
    spell_s: float = 0.0
    day_s: float = 0.0
    rested_at: float = 0.0
    at: float = 0.0
    today: list[tuple[float, float, float, float]] = field(default_factory=list)
    points: list[ClockPoint] = field(default_factory=list)
    most: dict[str, float] = field(default_factory=lambda: dict.fromkeys(CLOCKS, 0.0))
    allowed: dict[str, float] = field(default_factory=dict)
    excess: dict[str, Excess] = field(default_factory=dict)

    def begin(self, times: VehicleTimes) -> None:
        """Take the driver as the trip finds it; until it leaves it stands at the origin."""
        leaves = times.departure_s
        self.at = self.rested_at = leaves
        if times.drivers:
            state, since = times.drivers[0].state, times.drivers[0].state_at_s
            self.spell_s, self.day_s = state.driven_since_break_s, state.driven_today_s
            if state.duty_s is not None:
                self.rested_at = since - state.duty_s
            parts, stood = self.limits.parts_s, leaves - since
            whole = state.first_part_taken and parts is not None and stood >= parts[1] - SLACK_S
            if stood > 0:
                self.at = since
                self.stand(leaves, restarts=whole)
                return
        self.note()

    def stand(self, until: float, *, rests: bool = False, restarts: bool = False) -> None:
        """Stand until a moment, which may be a rest or a break."""
        gap, limits = until - self.at, self.limits
        least = min(limits.rest_s, limits.reduced_rest_s) or math.inf
        if rests or gap >= least - SLACK_S:
            self.end_day(gap)
            self.spell_s = self.day_s = 0.0
            self.rested_at = until
        elif restarts or gap >= limits.break_s - SLACK_S:
            if self.today:
                self.note(until)
            self.spell_s = 0.0
        self.at = until
        self.note()

    def drive(self, until: float, counts: float) -> None:
        """Drive, of which only a part counts where the task is relieved."""
        self.spell_s += (until - self.at) * counts
        self.day_s += (until - self.at) * counts
        self.at = until
        self.note()

    def note(self, at: float | None = None) -> None:
        at = self.at if at is None else at
        self.today.append((at, self.spell_s, self.day_s, at - self.rested_at))

    def end_day(self, rests_s: float | None = None) -> None:
        """Settle which limits the day has, now that it is over."""
        limits = self.limits
        driven = max((day for _, _, day, _ in self.today), default=0.0)
        on_duty = max((duty for _, _, _, duty in self.today), default=0.0)
        day = limits.day_s if driven <= limits.day_s + SLACK_S else limits.long_day_s
        # Who knows which rest follows the last day; the one that it needs may.
        full = on_duty <= limits.window_s + SLACK_S
        if rests_s is not None:
            full = rests_s >= limits.rest_s - SLACK_S
        duty = limits.window_s if full else limits.long_window_s
        allowed = {"spell": limits.spell_s, "day": day, "duty": duty}
        for at, *counted in self.today:
            shares = []
            for (clock, most), value in zip(allowed.items(), counted, strict=True):
                shares.append(value / most if math.isfinite(most) and most > 0 else 0.0)
                if value >= self.most[clock]:
                    self.most[clock], self.allowed[clock] = value, most
                if value > most + SLACK_S and (
                    clock not in self.excess or value > self.excess[clock].counted_s
                ):
                    first = self.excess.get(clock)
                    when = at - (value - most) if first is None else first.at_s
                    self.excess[clock] = Excess(clock, when, value, most)
            self.points.append(ClockPoint(at, *shares))
        if self.points and rests_s is not None:
            # The clocks fall where the rest begins.
            self.points.append(ClockPoint(self.points[-1].at_s, 0.0, 0.0, 0.0))
        self.today.clear()
