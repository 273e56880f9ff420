"""What driving rules are to a planner, and which there are.

A set of rules is a name and its limits. A new one needs no base class; any object with these
members will do, and `RULES.add` makes it known to scenarios and to the command.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Protocol

from ..errors import ScenarioError
from ..kinds import kind_of
from ..registry import Registry
from .eu561 import EU561, EU561_TEAM
from .limits import UNLIMITED, Limits
from .state import DriverState
from .us395 import US395

__all__ = [
    "NO_RULES", "RULES", "Drive", "DrivingRules", "Rules", "Violation", "limits_of",
    "places_pauses", "rules_of", "spread_of", "team_of",
]  # fmt: skip

SPREAD = 2700.0 / 32400.0
"""The paper's rest: 45 min for every 9 h of driving."""


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
    """The law, or a carrier's own rules, on driving times and breaks.

    Rules by which breaks and rests are to be planned have a method `limits(drivers)`, as `Rules`
    has; those without it only remark. `spread`, likewise, is 0 where there is none.
    """

    @property
    def name(self) -> str:
        """What a plan calls them."""
        ...

    def violations(self, day: Sequence[Drive]) -> list[Violation]:
        """Return what a day breaks beyond the limits, for the plan to remark.

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
class Rules:
    """A set of rules that is nothing but its limits.

    Attributes
    ----------
    name : str
        What it is called in scenarios and plans.
    about : str
        One line for lists.
    alone : Limits
        Of one driver.
    team : Limits or None
        Of two in one vehicle; None if the rules are not planned for two.
    spread : float
        Rest that is spread over the driving, as a share of it.
    """

    name: str
    about: str
    alone: Limits = UNLIMITED
    team: Limits | None = None
    spread: float = 0.0

    def limits(self, drivers: int) -> Limits:
        """Return what is allowed to a vehicle.

        Parameters
        ----------
        drivers : int
            1 or 2.

        Returns
        -------
        Limits
            Theirs.

        Raises
        ------
        ScenarioError
            Two drivers, under rules that are not planned for two.
        """
        if drivers == 1 or self.alone == UNLIMITED:
            return self.alone
        if self.team is None:
            raise ScenarioError(
                f"driving rules {self.name!r} are not planned for two drivers; give one"
            )
        return self.team

    def violations(self, day: Sequence[Drive]) -> list[Violation]:
        """Return nothing: a plan under limits keeps them.

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


RULES: Registry[Rules] = Registry("driving rules")
RULES.add(Rules("none", "no rules: any day is allowed"))
RULES.add(Rules("eu561", "Regulation (EC) 561/2006 and Directive 2002/15/EC", EU561, EU561_TEAM))
RULES.add(Rules("us395", "49 CFR 395.3, drivers who carry property", US395))
RULES.add(
    Rules("spread-rest", "the paper's: 45 min of rest for 9 h, spread over the way", spread=SPREAD)
)

NO_RULES = RULES.find("none")
"""Any day is allowed."""


def rules_of(given: object) -> DrivingRules:
    """Return driving rules from what was given.

    Parameters
    ----------
    given : str or DrivingRules
        A name of `RULES`, or rules.

    Returns
    -------
    DrivingRules
        The rules.

    Raises
    ------
    ScenarioError
        An unknown name, or an object that answers none of what rules are asked.
    """
    if isinstance(given, str):
        return RULES.find(given)
    if isinstance(given, type) or not callable(getattr(given, "violations", None)):
        raise ScenarioError(
            f"plan: rules is a {kind_of(given)}; give driving rules, such as NO_RULES, or one of "
            f"{', '.join(RULES)}"
        )
    return given  # type: ignore[return-value]  # it was looked at just above


def limits_of(rules: DrivingRules, drivers: int = 1) -> Limits:
    """Return what rules allow to a vehicle.

    Parameters
    ----------
    rules : DrivingRules
        Of a problem.
    drivers : int
        1, or 2 who take turns.

    Returns
    -------
    Limits
        By which breaks and rests are planned; `UNLIMITED` for rules that only remark.

    Raises
    ------
    ScenarioError
        Two drivers, under rules that are not planned for two.
    """
    ask = getattr(rules, "limits", None)
    return UNLIMITED if ask is None else ask(drivers)


def team_of(rules: DrivingRules, state: DriverState) -> Limits | None:
    """Return what a second driver would make of a vehicle.

    Parameters
    ----------
    rules : DrivingRules
        Of a problem.
    state : DriverState
        Of who drives it now.

    Returns
    -------
    Limits or None
        Of two drivers; None if there are two, or under rules that are not planned for two.
    """
    if state.drivers == 2:
        return None
    try:
        return limits_of(rules, 2)
    except ScenarioError:
        return None


def spread_of(rules: DrivingRules) -> float:
    """Return the rest that rules spread over the driving.

    Parameters
    ----------
    rules : DrivingRules
        Of a problem.

    Returns
    -------
    float
        As a share of the driving time; 0 under any law.
    """
    return float(getattr(rules, "spread", 0.0))


def places_pauses(name: str) -> bool:
    """Return whether plans under rules of a name have breaks and rests at places and moments.

    Parameters
    ----------
    name : str
        As plans have it; empty without rules.

    Returns
    -------
    bool
        True for rules with limits, and for those not known here; False without any, and where rest
        is spread over the driving alone.
    """
    known = RULES.get(name) if name else NO_RULES
    return known is None or known.alone.limits_driving
