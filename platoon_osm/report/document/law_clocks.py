"""The law's clocks along each vehicle's day: what its driving rules count, against what they allow.

Three clocks run. Driving since the last break stops at a break: a gap that the plan says is one, or
its second part, or any gap of the length of a whole one. Driving since the last rest, and the time
since that rest ended, stop at a daily or weekly rest, or at any gap as long as a reduced one. Where
a follower's task is relieved, its driving counts for less. Of two drivers each has clocks of its
own: sitting beside the other, with the standing around it, is a break once it has lasted as long as
one; both rest where the vehicle does. On a day that needs it the longer limit is the one that
counts; how often that may be is not looked at here, nor are weeks.

This draws a plan; what proves it is the checker of plans.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, field, replace

from ...driving.limits import Limits
from ...driving.rules import RULES
from ...plans.pauses import DriverDay
from ...plans.plan import Plan
from ...plans.timetable import VehicleTimes
from .model_law import ClockPoint, Clocks, DriverClocks, Excess, Law, Standing
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
    limits = _each_of(team) if drivers > 1 and team is not None else alone
    stands = stands_of(times)
    relief = plan.timetable.task_relief if plan.timetable else 0.0
    ways = [plan.stretches[stretch] for stretch in plan.ways[index]]
    counts = [1.0 - relief * (one.together and one.vehicles[0] != index) for one in ways]
    each = tuple(_driver(times, stands, counts, limits, day) for day in times.drivers or (None,))
    lasts = {"break": 0.0, "rest": 0.0}
    for one in stands:
        if one.kind in lasts:
            lasts[one.kind] += one.lasts_s
    worst = {clock: max(each, key=lambda own: _worth(own, clock)) for clock in CLOCKS}
    return Clocks(
        drivers=drivers,
        driving_s=sum(end - begin for begin, end in times.legs),
        breaks_s=lasts["break"],
        rests_s=lasts["rest"],
        spell_s=worst["spell"].spell_s,
        day_s=worst["day"].day_s,
        duty_s=worst["duty"].duty_s,
        allowed={clock: own.allowed[clock] for clock, own in worst.items()},
        excess=tuple(
            found for clock, own in worst.items() for found in own.excess if found.clock == clock
        ),
        each=each,
    )


def _worth(own: DriverClocks, clock: str) -> tuple[float, float]:
    """Return by how much a driver goes beyond what is allowed, and the most of its clock."""
    beyond = [one.counted_s - one.allowed_s for one in own.excess if one.clock == clock]
    return max(beyond, default=0.0), own.most(clock)


def _each_of(team: Limits) -> Limits:
    """Return what each of two drivers may, where the limits are those of the vehicle."""
    if not team.change_s:
        return team
    return replace(
        team, day_s=team.day_s / 2, long_day_s=team.long_day_s / 2, break_s=team.beside_s
    )


def _driver(
    times: VehicleTimes,
    stands: Sequence[Standing],
    counts: Sequence[float],
    limits: Limits,
    day: DriverDay | None,
) -> DriverClocks:
    """Return the clocks of a driver, who sits beside another on legs that are not its own."""
    run = _Run(limits)
    run.begin(times, day)
    driving_s = 0.0
    for leg, (begin, end) in enumerate(times.legs):
        here = [one for one in stands if run.at - SLACK_S < one.begin_s < begin]
        if begin > run.at:
            run.stand(
                begin,
                rests=any(one.kind == "rest" for one in here),
                restarts=any(one.restarts for one in here) and not limits.change_s,
            )
        if day is None or day.drives is None or leg in day.drives:
            driving_s += end - begin
            run.drive(end, counts[leg])
        else:
            run.sit(end)
    run.end_day()
    return DriverClocks(
        driving_s=driving_s,
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
    drove_at: float = 0.0
    today: list[tuple[float, float, float, float]] = field(default_factory=list)
    points: list[ClockPoint] = field(default_factory=list)
    most: dict[str, float] = field(default_factory=lambda: dict.fromkeys(CLOCKS, 0.0))
    allowed: dict[str, float] = field(default_factory=dict)
    excess: dict[str, Excess] = field(default_factory=dict)

    def begin(self, times: VehicleTimes, day: DriverDay | None) -> None:
        """Take the driver as the trip finds it; until it leaves it stands at the origin."""
        leaves = times.departure_s
        self.at = self.rested_at = self.drove_at = leaves
        if day is not None:
            state, since = day.state, day.state_at_s
            self.spell_s, self.day_s = state.driven_since_break_s, state.driven_today_s
            if state.duty_s is not None:
                self.rested_at = since - state.duty_s
            parts, stood = self.limits.parts_s, leaves - since
            whole = state.first_part_taken and parts is not None and stood >= parts[1] - SLACK_S
            if stood > 0:
                self.at = self.drove_at = since
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
        elif restarts:
            self._end_spell(until)
        self._idle(until)

    def sit(self, until: float) -> None:
        """Sit beside the one who drives."""
        self._idle(until)

    def _idle(self, until: float) -> None:
        """Go on without driving; long enough, it is a break."""
        ends = self.drove_at + self.limits.break_s
        if self.spell_s and until >= ends - SLACK_S:
            self._end_spell(min(max(self.at, ends), until))
        self.at = until
        self.note()

    def _end_spell(self, at: float) -> None:
        if self.today:
            self.note(at)
        self.spell_s = 0.0
        self.note(at)

    def drive(self, until: float, counts: float) -> None:
        """Drive, of which only a part counts where the task is relieved."""
        self.spell_s += (until - self.at) * counts
        self.day_s += (until - self.at) * counts
        self.at = self.drove_at = until
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
