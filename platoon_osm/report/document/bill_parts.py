"""What of a bill is told by itself: amounts of some terms, and texts fit to be shown."""

from __future__ import annotations

import re
from dataclasses import replace

from ...plans.bill import Bill
from ...plans.chances import Chances
from ...plans.gain import GainSharing
from ...plans.plan import Plan
from ...shown_text import fitted
from ..language.plan_sentences import in_language
from ..language.speech import say

__all__ = ["bill_of", "chances_of", "gain_of", "stood_cents", "term_name"]

STANDING = ("waiting", "delay")
"""Terms that are paid for time, not for driving."""


TERMS = {
    "fuel": "money.term-fuel",
    "driver": "money.term-driver",
    "toll": "money.term-toll",
    "co2": "money.term-co2",
    "waiting": "money.term-waiting",
    "delay": "money.term-delay",
}
"""Those that have a name in each language."""


NEXT_REMARK = re.compile(
    "; (?=by the rule alone|all together lose|[0-9,]+ linked|what groups of|a bound covers"
    "|planned apart)"
)
"""Where one remark on shares ends and another begins; some hold a semicolon themselves."""


def term_name(term: str) -> str:
    """Return what a term of a bill is called.

    Parameters
    ----------
    term : str
        Of it.

    Returns
    -------
    str
        In the language that is spoken; a term that has no name there as it is.
    """
    return say(TERMS[term]) if term in TERMS else term


def stood_cents(bill: Bill, vehicle: int) -> int:
    """Return what waiting and being later than alone costs a vehicle.

    Parameters
    ----------
    bill : Bill
        Of its plan.
    vehicle : int
        Its position.

    Returns
    -------
    int
        Cents more than alone.
    """
    own = bill.vehicles[vehicle]
    places = [place for place, term in enumerate(bill.terms) if term in STANDING]
    return sum(own.joint_cents[place] - own.alone_cents[place] for place in places)


def bill_of(plan: Plan) -> Bill | None:
    """Return the bill of a plan, its texts fit to be shown.

    Parameters
    ----------
    plan : Plan
        Any.

    Returns
    -------
    Bill or None
        None where costs are no money.
    """
    if plan.bill is None:
        return None
    figures = tuple(
        replace(one, name=fitted(one.name), unit=fitted(one.unit), source=fitted(one.source))
        for one in plan.bill.figures
    )
    terms = tuple(map(fitted, plan.bill.terms))
    return replace(plan.bill, currency=fitted(plan.bill.currency), terms=terms, figures=figures)


def gain_of(plan: Plan) -> GainSharing | None:
    """Return how a plan's gain is shared, its texts fit to be shown.

    Parameters
    ----------
    plan : Plan
        Any.

    Returns
    -------
    GainSharing or None
        None where it is not shared, or there is none.
    """
    gain = plan.gain
    if gain is None or not gain.is_told:
        return None
    return replace(
        gain,
        rule=fitted(gain.rule),
        currency=fitted(gain.currency),
        manner=fitted(gain.manner),
        remark=fitted("; ".join(map(in_language, NEXT_REMARK.split(gain.remark)))),
    )


def chances_of(plan: Plan, told: list[int]) -> Chances | None:
    """Return how likely the merges are that a page shows.

    Parameters
    ----------
    plan : Plan
        Any.
    told : list of int
        Positions of the plan's events in the order of the document's, -1 for one of its own.

    Returns
    -------
    Chances or None
        Its meetings name events of the document; None of a plan without delays.
    """
    found = plan.chances
    if found is None:
        return None
    places = {event: place for place, event in enumerate(told) if event >= 0}
    meetings = tuple(
        replace(one, event=places[one.event]) for one in found.meetings if one.event in places
    )
    return replace(found, kind=fitted(found.kind), meetings=meetings)
