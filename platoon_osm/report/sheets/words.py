"""What a sheet and a calendar say of each step, in the language that is spoken."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

from ...network.antimeridian import wrapped_deg
from ...plans.clock import Clock, duration
from ...plans.plan import Plan
from ...shown_text import fitted, shortened
from ..document.findings import Findings
from ..document.wording import joined
from ..language.speech import clock_time, say
from ..markup.quantities import kilometres
from .going_on import GoingOn
from .pause_words import from_to, pause_at, pause_called, pause_remarks, unnamed_place
from .steps import Step, Way

__all__ = ["StepWords", "Teller", "coordinates"]

LONGEST_NAME = 44
"""Of a vehicle among others, in characters; its own heading has it whole."""

LONGEST_ROADS = 60

FEW = 4
"""Vehicles that are told by letter and name; of more, the letters."""


@dataclass(frozen=True, slots=True)
class StepWords:
    """One step in words; empty where there is nothing to say.

    Attributes
    ----------
    kind : str
        "start", "merge", "separation", "road" or "end", or "rest", "break", "ban" or "change" where
        the vehicle does nothing else: what its mark is.
    time, km : str
        When the vehicle goes on from there, or at a pause when it stops; how far it has come.
    what : str
        What the driver does there.
    place, at : str
        Name and coordinates.
    wait, without, way : str
        How long to stand and why, what to do if others do not come, and how to drive on.
    until : str
        Until when to wait for others at the latest, or until when to pause, as a time of day.
    """

    kind: str
    time: str
    km: str
    what: str
    place: str
    at: str
    wait: str
    without: str
    way: str
    until: str


def coordinates(lon: float, lat: float) -> str:
    """Return a place as navigation systems take it: latitude first, about a metre fine.

    Parameters
    ----------
    lon, lat : float
        Degrees.

    Returns
    -------
    str
        Such as "45.47120, 8.65430", in every language.
    """
    return f"{lat:.5f}, {float(wrapped_deg(lon)):.5f}"


class Teller:
    """Puts the steps of one vehicle into words.

    Parameters
    ----------
    found : Findings
        Of the plan.
    index : int
        Position of the vehicle in it.
    """

    def __init__(self, found: Findings, index: int) -> None:
        self.found = found
        self.index = index
        table = found.plan.timetable
        self.clock: Clock | None = None if table is None else table.clock

    @property
    def plan(self) -> Plan:
        """The plan."""
        return self.found.plan

    def name(self, vehicle: int) -> str:
        """Return a vehicle's letter and its name, if that is another.

        Parameters
        ----------
        vehicle : int
            Its position.

        Returns
        -------
        str
            Such as "B (Torino 2)".
        """
        letter = self.found.styles[vehicle].letter
        name = shortened(fitted(self.plan.trips[vehicle].vehicle), LONGEST_NAME)
        return letter if name == letter else say("sheet.named", letter=letter, name=name)

    def names(self, vehicles: Sequence[int]) -> str:
        """Return some vehicles in a row.

        Parameters
        ----------
        vehicles : sequence of int
            Their positions.

        Returns
        -------
        str
            With their names if they are few, else their letters.
        """
        if len(vehicles) <= FEW:
            return joined([self.name(one) for one in vehicles])
        return joined(self.found.letters(vehicles), 8)

    def time(self, seconds: float | None) -> str:
        """Return a time of day.

        Parameters
        ----------
        seconds : float or None
            From the start of the plan's times.

        Returns
        -------
        str
            Empty for None.
        """
        return "" if seconds is None or self.clock is None else clock_time(self.clock, seconds)

    def words(self, step: Step, number: int) -> StepWords:
        """Return one step in words.

        Parameters
        ----------
        step : Step
            Of the vehicle.
        number : int
            Its place among the steps, from 0.

        Returns
        -------
        StepWords
            All that is said of it.
        """
        lon, lat = step.place.lon, step.place.lat
        going = step.without
        return StepWords(
            kind=_kind(step, number),
            time=self.time(step.reached_s if _stops(step, number) else step.leaves_s),
            km=kilometres(step.at_m),
            what=self._what(step, number),
            place=fitted(step.place.name) or _unnamed(step),
            at=coordinates(lon, lat),
            wait=" ".join(filter(None, [self._wait(step), *self._stands(step, number)])),
            without="" if going is None else self._without(step, going),
            way="" if step.way is None else self._way(step.way),
            until=self._until(step),
        )

    def _what(self, step: Step, number: int) -> str:
        if step.way is None:
            return self._arrival(step)
        parts = []
        if step.left:
            parts.append(self._parting(step))
        if step.joined:
            parts.append(self._meeting(step))
        if number == 0:
            parts.insert(0, say("sheet.depart"))
        elif step.is_pause:
            parts += [pause_called(one, self.names) for one in step.pauses]
        elif not parts and step.turn is None and step.lead is None:
            access = step.way.is_access
            parts.append(say("sheet.leave-road" if access else "sheet.enter-road"))
        if step.lead is not None:
            parts.append(self._lead(*step.lead, step.way.order))
        if step.turn is not None:
            parts.append(say("sheet.turn", driver=step.turn))
        return " ".join(parts)

    def _lead(self, taker: int, former: int, order: Sequence[int]) -> str:
        if taker == self.index:
            return say("sheet.take-lead")
        if former == self.index:
            last = order[-1] == self.index
            return say("sheet.fall-back" if last else "sheet.hand-on", who=self.name(taker))
        return say("sheet.lead-changes", who=self.name(taker))

    def _stands(self, step: Step, number: int) -> Iterator[str]:
        aside = step.is_pause and number > 0
        if aside and step.leaves_s is not None:
            yield say("sheet.go-on", time=self.time(step.leaves_s))
        for halt in step.pauses:
            assert self.clock is not None
            if not aside:
                yield pause_at(halt, self.names)
            if not aside or halt.what == "rest" or len(step.pauses) > 1:
                yield from_to(halt, self.clock)
            yield from pause_remarks(halt)

    def _until(self, step: Step) -> str:
        if step.without is not None:
            return self.time(step.without.until_s)
        return self.time(step.leaves_s) if step.is_pause else ""

    def _arrival(self, step: Step) -> str:
        if not step.left:
            return say("sheet.arrive")
        return say("sheet.arrive-with", who=self.names(step.left))

    def _meeting(self, step: Step) -> str:
        who = self.names(step.joined)
        if step.moves:
            return say("sheet.join", who=who)
        return say("sheet.meet", who=who, n=len(step.joined))

    def _parting(self, step: Step) -> str:
        if step.moves:
            return say("sheet.leave", who=self.names(step.left), n=len(step.left))
        return say("sheet.part", who=self.names(step.left), n=len(step.left))

    def _wait(self, step: Step) -> str:
        if step.wait_s:
            begin_s, end_s = step.reached_s, step.leaves_s
            if step.pauses:
                waits = [one for one in step.halts if one.what == "wait"]
                begin_s, end_s = waits[0].begin_s, waits[-1].end_s
            span = {"begin": self.time(begin_s), "end": self.time(end_s)}
            return say("sheet.wait", span=duration(step.wait_s), **span)
        if step.waited_for:
            return say("sheet.waited-for", time=self.time(step.leaves_s))
        return ""

    def _way(self, way: Way) -> str:
        told = self._drive(way.roads, way.length_m, way.drive_s)
        if way.is_access:
            return say("sheet.way-access", way=told)
        if way.together:
            return say("sheet.way-together", way=told, n=len(way.order))
        return say("sheet.way-alone", way=told)

    def _drive(self, roads: str, length_m: float, drive_s: float) -> str:
        parts = (shortened(roads, LONGEST_ROADS), kilometres(length_m), duration(drive_s))
        return ", ".join(part for part in parts if part)

    def _without(self, step: Step, going: GoingOn) -> str:
        way = self._drive(going.roads, going.length_m, going.drive_s)
        on = say("sheet.on-with" if going.with_others else "sheet.on-alone", way=way)
        if step.leaves_s is None:
            return say("sheet.without-times", on=on)
        planned, arrives = self.time(step.leaves_s), self.time(going.arrives_s)
        if going.until_s is None:
            return say("sheet.without-limit", planned=planned, on=on, arrives=arrives)
        if going.until_s - step.leaves_s < 60:
            return say("sheet.without-waiting", planned=planned, on=on, arrives=arrives)
        until = self.time(going.until_s)
        key = "sheet.without" if going.by_patience else "sheet.without-in-time"
        return say(key, planned=planned, until=until, on=on, arrives=arrives)


def _kind(step: Step, number: int) -> str:
    if number == 0:
        return "start"
    if step.way is None:
        return "end"
    if step.joined:
        return "merge"
    if step.left:
        return "separation"
    return step.pauses[0].what if step.pauses else "road"


def _stops(step: Step, number: int) -> bool:
    """Return whether a step is told by when the vehicle comes there."""
    return step.leaves_s is None or bool(number and step.is_pause)


def _unnamed(step: Step) -> str:
    return unnamed_place(step.pauses[0].kind) if step.is_pause else ""
