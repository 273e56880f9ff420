"""The clock of a plan: seconds from its start, and the times of day that people read."""

from __future__ import annotations

import math
from dataclasses import dataclass
from datetime import UTC, datetime, timedelta, timezone

from ..errors import ScenarioError, brief

__all__ = ["MENTIONED_S", "Clock", "duration", "late_by", "whole_minutes"]

MENTIONED_S = 30.0
"""A wait shorter than this is 0 min everywhere, and not worth telling."""


@dataclass(frozen=True, slots=True)
class Clock:
    """Times of day from seconds.

    Attributes
    ----------
    start : datetime
        When the seconds begin, with a fixed offset from UTC or without any zone.
    """

    start: datetime

    @classmethod
    def from_text(cls, start: str) -> Clock:
        """Return the clock that starts at an ISO 8601 moment.

        Parameters
        ----------
        start : str
            In ISO 8601.

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
            return cls(datetime.fromisoformat(start))
        except (TypeError, ValueError):
            raise ScenarioError(
                f"plan: start {brief(start)} is no ISO 8601 moment; plan again"
            ) from None

    @classmethod
    def at(cls, moment: datetime) -> Clock:
        """Return the clock that starts at a moment.

        Its offset from UTC stays that of the moment: no hour is lost or read twice where clocks
        change on the way.

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
            In the zone of the start.
        """
        return self.start + timedelta(seconds=seconds)

    @property
    def zone(self) -> str:
        """The zone of all times, "local time" if none was named."""
        offset = self.start.utcoffset()
        if offset is None:
            return "local time"
        return "UTC" if not offset else f"UTC{self.start.isoformat()[-6:]}"

    @property
    def since_midnight_s(self) -> float:
        """The seconds from midnight to the start."""
        midnight = self.start.replace(hour=0, minute=0, second=0, microsecond=0)
        return (self.start - midnight).total_seconds()

    def text(self, seconds: float) -> str:
        """Return the time to the minute: "08:21", "00:10 +1 d" a day later.

        Parameters
        ----------
        seconds : float
            After the start.

        Returns
        -------
        str
            Hours and minutes, with the number of days if it is another day.
        """
        minutes = whole_minutes(self.since_midnight_s + seconds)
        days, minute = divmod(minutes, 24 * 60)
        return f"{minute // 60:02d}:{minute % 60:02d}" + (f" {days:+d} d" if days else "")

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
