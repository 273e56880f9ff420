"""The sets of rules that the checker knows, by the names that plans and the command use."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field

from ..errors import ScenarioError, brief
from .activities import HOUR, MINUTE, Record
from .driver_start import DriverStart
from .eu561 import eu561_violations
from .spread_rest import spread_rest_violations
from .us395 import us395_violations
from .violation import Violation

__all__ = ["RULE_SETS", "RuleSet", "rule_set"]

Check = Callable[[Record, DriverStart, int, bool], list[Violation]]


@dataclass(frozen=True, slots=True)
class RuleSet:
    """A set of rules.

    Attributes
    ----------
    name : str
        As in plans.
    title : str
        What a reader calls it.
    check : callable
        Returns what a record breaks; it takes the record, what the driver has behind it, how far
        the driver's clock is ahead of UTC [s], and whether article 12 is to be looked at.
    least_s : mapping of str to int
        How long a pause must be at least that is for a purpose [s].
    team_least_s : mapping of str to int
        The same for two drivers, where it differs [s].
    """

    name: str
    title: str
    check: Check
    least_s: Mapping[str, int] = field(default_factory=dict)
    team_least_s: Mapping[str, int] = field(default_factory=dict)


def _nothing(record: Record, start: DriverStart, clock_s: int, article_12: bool) -> list[Violation]:
    del clock_s, article_12
    return spread_rest_violations(record, start)


def _eu561(record: Record, start: DriverStart, clock_s: int, article_12: bool) -> list[Violation]:
    del clock_s
    return eu561_violations(record, start, article_12=article_12)


def _us395(record: Record, start: DriverStart, clock_s: int, article_12: bool) -> list[Violation]:
    del article_12
    return us395_violations(record, start, clock_s=clock_s)


RULE_SETS = {
    one.name: one
    for one in (
        RuleSet(
            "eu561", "(EC) 561/2006 and 2002/15/EC", _eu561,
            {
                "weekly_rest": 24 * HOUR, "daily_rest": 11 * HOUR, "reduced_daily_rest": 9 * HOUR,
                "break": 45 * MINUTE, "second_part": 30 * MINUTE, "first_part": 15 * MINUTE,
            },
            {"daily_rest": 9 * HOUR},
        ),
        RuleSet(
            "us395", "49 CFR 395.3", _us395,
            {
                "weekly_rest": 34 * HOUR, "daily_rest": 10 * HOUR, "reduced_daily_rest": 10 * HOUR,
                "break": 30 * MINUTE,
            },
        ),
        RuleSet("spread-rest", "the paper's spread rest, which forbids nothing", _nothing),
        RuleSet("none", "no driving rules", _nothing),
    )
}  # fmt: skip
"""By name."""


def rule_set(name: str) -> RuleSet:
    """Return a set of rules.

    Parameters
    ----------
    name : str
        One of `RULE_SETS`; empty for "none".

    Returns
    -------
    RuleSet
        The rules.

    Raises
    ------
    ScenarioError
        Rules that the checker does not know.
    """
    known = RULE_SETS.get(name or "none") if isinstance(name, str) else None
    if known is None:
        # Rules of somebody's own may plan, but only their author can tell what breaks them.
        raise ScenarioError(
            f"driving rules {brief(name)} have no checker; name one of {', '.join(RULE_SETS)}"
        )
    return known
