"""One vehicle of a document, and costs as they are printed."""

from __future__ import annotations

from dataclasses import dataclass

from ...shown_text import shortened
from ..drawing.vehicle_styles import letter_size
from .model_day import Fatigue, VehicleDay
from .stop_names import brief_name

__all__ = ["CostTexts", "Stop", "Vehicle", "VehicleTexts", "called"]

LONGEST_CALLED = 28
"""Letters of a name that a sentence bears."""


def called(letter: str, name: str) -> str:
    """Return what texts call a vehicle, the same everywhere: "A (Torino 1)".

    Parameters
    ----------
    letter : str
        Which pictures bear.
    name : str
        Its own, fit to be shown; empty if that is the letter.

    Returns
    -------
    str
        Letter and name; a name in letters that may run from right to left stands between isolates.
    """
    short = shortened(name, LONGEST_CALLED)
    own = short if short.isascii() else f"\u2068{short}\u2069"
    return f"{letter} ({own})" if name else letter


@dataclass(frozen=True, slots=True)
class CostTexts:
    """Costs as they are printed, without their unit.

    Attributes
    ----------
    alone, joint : str
        Of driving alone and as planned.
    saved : str
        The difference, with its sign.
    share : str
        The share saved, with its sign.
    """

    alone: str
    joint: str
    saved: str
    share: str


@dataclass(frozen=True, slots=True)
class VehicleTexts(CostTexts):
    """Costs of a vehicle as they are printed.

    Attributes
    ----------
    gain : str
        What driving in platoon gains it on its way; empty if not known.
    detour : str
        What that way costs more than its own; empty if not known.
    """

    gain: str
    detour: str


@dataclass(frozen=True, slots=True)
class Stop:
    """Where a vehicle starts or ends.

    Attributes
    ----------
    lon, lat : float
        Degrees, to 1e-6.
    name : str
        Of the place.
    """

    lon: float
    lat: float
    name: str

    @property
    def brief(self) -> str:
        """Name without coordinates."""
        return brief_name(self.name, self.lon, self.lat)


@dataclass(frozen=True, slots=True)
class Vehicle:
    """One vehicle: what it is called, where it drives, what that costs.

    Attributes
    ----------
    name : str
        Its own name; empty if that is its letter.
    letter, colour, dash, cap : str
        How it looks in every picture, as in `VehicleStyle`.
    role, role_text : str
        "master", "member" or "alone", and the same for reading.
    origin, destination : Stop
        Where it starts and ends.
    length_m : float
        Of its joint route.
    length_text : str
        The same for reading.
    alone_length_m : float
        Of the route it would drive alone.
    platoon_m : float
        Driven in platoon.
    inferred_m : float
        Of road that the loader inferred.
    inferred_text : str
        The same for reading; empty if there is none.
    access_m : float
        Of ways between the road and places beside it.
    access_text : str
        Those for reading: how long, and where they meet the road; empty if there are none.
    fuel_l, alone_fuel_l : float
        As planned and alone.
    solo_cost, joint_cost, saved : float
        In the plan's unit.
    saving : float
        Share of the cost alone.
    platoon_gain, detour : float or None
        What `saved` is the difference of; None where the cost of the way driven is not known.
    reason : str
        Why it stays alone, or how its case was read.
    way : tuple of tuple of str and int
        Its pieces in driving order: "solo" or "platoon", and the position there.
    text : VehicleTexts
        Its costs as they are printed.
    fatigue : Fatigue
        Of its driver.
    times : VehicleDay or None
        When it drives; None if the plan has no times.
    """

    name: str
    letter: str
    colour: str
    dash: str
    cap: str
    role: str
    role_text: str
    origin: Stop
    destination: Stop
    length_m: float
    length_text: str
    alone_length_m: float
    platoon_m: float
    inferred_m: float
    inferred_text: str
    access_m: float
    access_text: str
    fuel_l: float
    alone_fuel_l: float
    solo_cost: float
    joint_cost: float
    saved: float
    saving: float
    platoon_gain: float | None
    detour: float | None
    reason: str
    way: tuple[tuple[str, int], ...]
    text: VehicleTexts
    fatigue: Fatigue
    times: VehicleDay | None

    @property
    def called(self) -> str:
        """What texts call it: its letter, which pictures bear, and its own name if it has one."""
        return called(self.letter, self.name)

    @property
    def is_late(self) -> bool:
        """Whether it arrives too late by as much as is told."""
        return self.times is not None and self.times.is_late

    @property
    def day(self) -> VehicleDay:
        """When it drives, in a plan that has times."""
        if self.times is None:
            raise LookupError(f"vehicle {self.letter} has no times")
        return self.times

    @property
    def letter_size(self) -> str:
        """The type size at which its letter fits its disc."""
        return f"{letter_size(self.letter):g}"

    @property
    def stroke(self) -> str:
        """The SVG dash array of its line, "none" if that is solid."""
        return self.dash or "none"
