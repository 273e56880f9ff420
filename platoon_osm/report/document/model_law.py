"""What driving rules count along a vehicle's day, against what they allow."""

from __future__ import annotations

from dataclasses import dataclass, field

__all__ = ["ClockPoint", "Clocks", "DriverClocks", "Excess", "Law", "Standing"]


@dataclass(frozen=True, slots=True)
class Standing:
    """A while in which a vehicle stands on its way.

    Attributes
    ----------
    kind : str
        "rest", "break", "ban", "change", or "wait" for others.
    begin_s, end_s : float
        From when to when.
    restarts : bool
        Whether driving without a break counts from 0 after it.
    """

    kind: str
    begin_s: float
    end_s: float
    restarts: bool = False

    @property
    def lasts_s(self) -> float:
        """How long [s]."""
        return self.end_s - self.begin_s


@dataclass(frozen=True, slots=True)
class ClockPoint:
    """The clocks of a driver at a moment, each as a share of what is allowed then.

    Attributes
    ----------
    at_s : float
        When.
    spell, day, duty : float
        Driving since the last break, since the last rest, and time since that rest ended; of what
        no rule limits, 0.
    """

    at_s: float
    spell: float
    day: float
    duty: float


@dataclass(frozen=True, slots=True)
class Excess:
    """A clock that goes beyond what is allowed.

    Attributes
    ----------
    clock : str
        "spell", "day" or "duty".
    at_s : float
        When it does.
    counted_s, allowed_s : float
        What it reaches, and what it may.
    """

    clock: str
    at_s: float
    counted_s: float
    allowed_s: float


@dataclass(frozen=True, slots=True)
class DriverClocks:
    """The clocks of one driver.

    Attributes
    ----------
    driving_s : float
        Driven by this one on this trip.
    spell_s, day_s, duty_s : float
        The most that is reached of each clock; what was driven before the trip counts.
    allowed : dict of str to float or None
        What is allowed of each, as of `Excess.clock`, on the day of that most; None where nothing
        is limited.
    excess : tuple of Excess
        Of each clock, where it first goes beyond what is allowed.
    points : tuple of ClockPoint
        The clocks along the day, straight between two points.
    """

    driving_s: float
    spell_s: float
    day_s: float
    duty_s: float
    allowed: dict[str, float | None]
    excess: tuple[Excess, ...]
    points: tuple[ClockPoint, ...] = field(metadata={"json": False})

    def most(self, clock: str) -> float:
        """Return the most that is reached of a clock.

        Parameters
        ----------
        clock : str
            As of `Excess.clock`.

        Returns
        -------
        float
            Its time [s].
        """
        return {"spell": self.spell_s, "day": self.day_s, "duty": self.duty_s}[clock]


@dataclass(frozen=True, slots=True)
class Clocks:
    """The clocks of a vehicle's drivers.

    Attributes
    ----------
    drivers : int
        1, or 2 who take turns.
    driving_s : float
        Driven on this trip.
    breaks_s, rests_s : float
        Stood for breaks, and for daily and weekly rests.
    spell_s, day_s, duty_s : float
        The most that is reached of each clock, by the driver who reaches most of it.
    allowed : dict of str to float or None
        What that driver may.
    excess : tuple of Excess
        Its excess, if any.
    each : tuple of DriverClocks
        Of each driver; of one if there is one.
    """

    drivers: int
    driving_s: float
    breaks_s: float
    rests_s: float
    spell_s: float
    day_s: float
    duty_s: float
    allowed: dict[str, float | None]
    excess: tuple[Excess, ...]
    each: tuple[DriverClocks, ...]


@dataclass(frozen=True, slots=True)
class Law:
    """The driving rules of a plan.

    Attributes
    ----------
    rules : str
        Their name.
    task_relief : float
        How much a follower's clock slows, [0, 1].
    vehicles : tuple of Clocks
        In the order of the document's.
    """

    rules: str
    task_relief: float
    vehicles: tuple[Clocks, ...]

    @property
    def is_kept(self) -> bool:
        """Whether no clock goes beyond what is allowed."""
        return not any(one.excess for one in self.vehicles)
