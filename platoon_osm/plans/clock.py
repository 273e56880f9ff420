"""The clock of a plan: seconds from its start, and the times of day that people read.

Where clocks change on the way, every time is read in the offset from UTC that holds then; time
spans are differences of seconds, and know nothing of it. An hour that is read twice in autumn is
told apart by its offset. A plan keeps the offsets themselves beside the name of its zone, so it can
be shown anywhere, also where no table of zones is at hand.
"""

from __future__ import annotations

import itertools
import math
from dataclasses import dataclass
from datetime import UTC, datetime, timedelta, timezone

from ..errors import ScenarioError, brief
from ..kinds import is_number

__all__ = [
    "MENTIONED_S",
    "Clock",
    "ClockFace",
    "Offsets",
    "ZoneSpell",
    "duration",
    "late_by",
    "whole_minutes",
]

Offsets = tuple[tuple[float, float], ...]

DAY_S = 86_400

MENTIONED_S = 30.0
"""A wait shorter than this is 0 min everywhere, and not worth telling."""


@dataclass(frozen=True, slots=True)
class ClockFace:
    """What clocks show at a moment.

    Attributes
    ----------
    days : int
        After the day on which the plan's clock starts.
    minute : int
        Of the day, 0 to 1439.
    twice : str
        The offset from UTC if clocks show this time twice, such as "UTC+1"; else empty.
    """

    days: int
    minute: int
    twice: str = ""

    @classmethod
    def of(cls, minutes: int, twice: str = "") -> ClockFace:
        """Return the face for a number of minutes.

        Parameters
        ----------
        minutes : int
            Since midnight of the first day; below 0 on the day before.
        twice : str
            As above.

        Returns
        -------
        ClockFace
            With whole days taken off.
        """
        days, minute = divmod(minutes, 24 * 60)
        return cls(days, minute, twice)


@dataclass(frozen=True, slots=True)
class ZoneSpell:
    """A time during which clocks do not change.

    Attributes
    ----------
    offset : str
        From UTC, such as "UTC+01:00".
    until : ClockFace or None
        What clocks show when it ends, in its own offset; None if it does not.
    """

    offset: str
    until: ClockFace | None = None


@dataclass(frozen=True, slots=True)
class Clock:
    """Times of day from seconds.

    Attributes
    ----------
    start : datetime
        When the seconds begin, with a fixed offset from UTC or without any zone.
    name : str
        Of the zone, such as "Europe/Rome"; empty if it has none.
    offsets : tuple of (float, float)
        From when on [s] clocks go by which offset from UTC [s], in order, the first also before;
        empty if that of the start holds throughout.

    Raises
    ------
    ScenarioError
        Offsets that cannot be, or another one at the start than the start's own.
    """

    start: datetime
    name: str = ""
    offsets: Offsets = ()

    def __post_init__(self) -> None:
        if not isinstance(self.name, str):
            raise ScenarioError(f"plan: zone {brief(self.name)} is no name; plan again")
        numbers = [value for pair in self.offsets for value in pair]
        fits = all(is_number(value) and math.isfinite(value) for value in numbers)
        moments = [at for at, _ in self.offsets]
        if not (fits and moments == sorted(set(moments))):
            raise ScenarioError("plan: offsets are not moments in order with numbers; plan again")
        if any(abs(offset) >= DAY_S for _, offset in self.offsets):
            raise ScenarioError("plan: an offset from UTC is a day or more; plan again")
        if self.offsets and self._offset(0.0) != self._own_offset:
            raise ScenarioError("plan: offsets do not fit the start of its times; plan again")

    @classmethod
    def from_text(cls, start: str, name: str = "", offsets: Offsets = ()) -> Clock:
        """Return the clock that starts at an ISO 8601 moment.

        Parameters
        ----------
        start : str
            In ISO 8601.
        name : str
            Of the zone.
        offsets : tuple of (float, float)
            As above.

        Returns
        -------
        Clock
            Whose seconds begin then.

        Raises
        ------
        ScenarioError
            Not such a moment.
        """
        try:
            moment = datetime.fromisoformat(start)
        except (TypeError, ValueError):
            raise ScenarioError(
                f"plan: start {brief(start)} is no ISO 8601 moment; plan again"
            ) from None
        return cls(moment, name, offsets)

    @classmethod
    def at(cls, moment: datetime) -> Clock:
        """Return the clock that starts at a moment.

        Its offset from UTC stays that of the moment; `zones.clock_of` knows when clocks change.

        Parameters
        ----------
        moment : datetime
            With or without a zone.

        Returns
        -------
        Clock
            Whose seconds begin then.
        """
        offset = moment.utcoffset()
        return cls(moment if offset is None else moment.astimezone(timezone(offset)))

    def seconds(self, moment: datetime) -> float:
        """Return how long after the start a moment is.

        Parameters
        ----------
        moment : datetime
            With a zone if the start has one.

        Returns
        -------
        float
            Seconds; below 0 before the start.
        """
        if self.start.utcoffset() is not None:
            # Moments of one zone are subtracted by the face of the clock unless both are in UTC.
            return (moment.astimezone(UTC) - self.start.astimezone(UTC)).total_seconds()
        return (moment - self.start).total_seconds()

    def moment(self, seconds: float) -> datetime:
        """Return the moment so many seconds after the start.

        Parameters
        ----------
        seconds : float
            After the start.

        Returns
        -------
        datetime
            With the offset from UTC that holds then, if the start has one.
        """
        moment = self.start + timedelta(seconds=seconds)
        if not self.offsets:
            return moment
        return moment.astimezone(timezone(timedelta(seconds=self._offset(seconds))))

    @property
    def zone(self) -> str:
        """The zone of all times and its offset, when it changes; "local time" if none was named."""
        if not (spells := self.zone_spells):
            return "local time"
        text = spells[0].offset
        for before, after in itertools.pairwise(spells):
            text += f" until {_of_day(before.until)}, then {after.offset}"
        return text if self.name in ("", text) else f"{self.name} ({text})"

    @property
    def zone_spells(self) -> tuple[ZoneSpell, ...]:
        """The offsets from UTC by which clocks go, in order; empty if no zone was named."""
        if self.start.utcoffset() is None:
            return ()
        if not self.offsets:
            return (ZoneSpell(_utc(self._own_offset)),)
        spells = []
        for (_, offset), (at, _) in itertools.pairwise(self.offsets):
            minutes = whole_minutes(self.since_midnight_s + at + offset - self._own_offset)
            spells.append(ZoneSpell(_utc(offset), ClockFace.of(minutes)))
        return (*spells, ZoneSpell(_utc(self.offsets[-1][1])))

    @property
    def _own_offset(self) -> float:
        offset = self.start.utcoffset()
        return 0.0 if offset is None else offset.total_seconds()

    def _offset(self, seconds: float) -> float:
        """Return the offset from UTC that holds at a moment [s]."""
        if not self.offsets:
            return self._own_offset
        held = [offset for at, offset in self.offsets if at <= seconds]
        return held[-1] if held else self.offsets[0][1]

    def spells(self, begin_s: float, end_s: float) -> list[tuple[float, float, float]]:
        """Return the parts of a span in which clocks do not change.

        Parameters
        ----------
        begin_s, end_s : float
            The span.

        Returns
        -------
        list of tuple of float
            Begin and end of each part, and by how much clocks are then ahead of the start's [s].
        """
        changes = [at for at, _ in self.offsets[1:] if begin_s < at < end_s]
        cuts = [begin_s, *changes, end_s]
        return [(a, b, self._offset(a) - self._own_offset) for a, b in itertools.pairwise(cuts)]

    @property
    def since_midnight_s(self) -> float:
        """The seconds from midnight to the start."""
        midnight = self.start.replace(hour=0, minute=0, second=0, microsecond=0)
        return (self.start - midnight).total_seconds()

    def text(self, seconds: float) -> str:
        """Return the time to the minute: "08:21", "00:10 +1 d" a day later, "02:30 UTC+1".

        Parameters
        ----------
        seconds : float
            After the start.

        Returns
        -------
        str
            Hours and minutes, with the number of days if it is another day, and with the offset if
            clocks show this time twice.
        """
        face = self.face(seconds)
        return f"{_of_day(face)} {face.twice}" if face.twice else _of_day(face)

    def face(self, seconds: float) -> ClockFace:
        """Return what clocks show at a moment, to the minute.

        Parameters
        ----------
        seconds : float
            After the start.

        Returns
        -------
        ClockFace
            In the offset from UTC that holds then.
        """
        minutes = whole_minutes(self.since_midnight_s + seconds)
        at = minutes * 60 - self.since_midnight_s
        offset = self._offset(at)
        twice = any(
            other != offset and self._offset(at + offset - other) == other
            for _, other in self.offsets
        )
        shift = round((offset - self._own_offset) / 60)
        return ClockFace.of(minutes + shift, _short(offset) if twice else "")

    def iso(self, seconds: float) -> str:
        """Return the moment to the second in ISO 8601.

        Parameters
        ----------
        seconds : float
            After the start.

        Returns
        -------
        str
            With the offset from UTC if the start has one.
        """
        return self.moment(round(seconds)).isoformat(timespec="seconds")


def _of_day(face: ClockFace | None) -> str:
    """Return a time of day; a spell that never ends has none."""
    if face is None:
        return ""
    hours, minutes = divmod(face.minute, 60)
    return f"{hours:02d}:{minutes:02d}" + (f" {face.days:+d} d" if face.days else "")


def _utc(offset_s: float) -> str:
    """Return "UTC+01:00" for 3600, "UTC" for 0."""
    minutes = round(abs(offset_s) / 60)
    sign = "-" if offset_s < 0 else "+"
    return f"UTC{sign}{minutes // 60:02d}:{minutes % 60:02d}" if offset_s else "UTC"


def _short(offset_s: float) -> str:
    """Return "UTC+1" for 3600, "UTC+5:30" for 19800."""
    hours, minutes = divmod(round(abs(offset_s) / 60), 60)
    sign = "-" if offset_s < 0 else "+"
    return f"UTC{sign}{hours}" + (f":{minutes:02d}" if minutes else "")


def whole_minutes(seconds: float) -> int:
    """Return a time to the minute; halves go up, as in the script of the page.

    Parameters
    ----------
    seconds : float
        A moment or a time span [s].

    Returns
    -------
    int
        In minutes.
    """
    return math.floor(seconds / 60 + 0.5)


def duration(seconds: float) -> str:
    """Return a time span to the minute: "24 min", "1 h 05 min".

    Parameters
    ----------
    seconds : float
        The span [s].

    Returns
    -------
    str
        Hours only where there are any.
    """
    hours, rest = divmod(whole_minutes(seconds), 60)
    return f"{hours} h {rest:02d} min" if hours else f"{rest} min"


def late_by(seconds: float) -> str:
    """Return a lateness to the minute, never 0.

    Parameters
    ----------
    seconds : float
        How late [s].

    Returns
    -------
    str
        As `duration`, or "less than a minute".
    """
    return duration(seconds) if seconds >= MENTIONED_S else "less than a minute"
