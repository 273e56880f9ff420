"""What driving rules are to a planner: who looks at a vehicle's day and says what is not allowed.

A new set of rules needs no base class; any object with these members will do.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Protocol

__all__ = ["NO_RULES", "Drive", "DrivingRules", "NoRules", "Violation"]


@dataclass(frozen=True, slots=True)
class Drive:
    """One stretch of a vehicle's day.

    Attributes
    ----------
    drive_s : float
        How long it drives [s].
    leads : bool
        Whether it drives alone or in front; a follower may be relieved of some of its task.
    rests_before_s : float
        How long it stands before the stretch [s].
    """

    drive_s: float
    leads: bool = True
    rests_before_s: float = 0.0


@dataclass(frozen=True, slots=True)
class Violation:
    """Something that the rules forbid.

    Attributes
    ----------
    after_s : float
        When it happens, counted from the departure [s].
    text : str
        What is wrong and what would mend it, in a few words.
    """

    after_s: float
    text: str


class DrivingRules(Protocol):
    """The law, or a carrier's own rules, on driving times and breaks."""

    @property
    def name(self) -> str:
        """What a plan calls them."""
        ...

    def violations(self, day: Sequence[Drive]) -> list[Violation]:
        """Return what a day breaks.

        Parameters
        ----------
        day : sequence of Drive
            A vehicle's stretches in order.

        Returns
        -------
        list of Violation
            In order of time; empty for a day that is allowed.
        """
        ...


@dataclass(frozen=True, slots=True)
class NoRules:
    """No rules at all: any day is allowed."""

    name: str = "none"

    def violations(self, day: Sequence[Drive]) -> list[Violation]:
        """Return nothing, whatever the day.

        Parameters
        ----------
        day : sequence of Drive
            Not looked at.

        Returns
        -------
        list of Violation
            Empty.
        """
        del day
        return []


NO_RULES = NoRules()
