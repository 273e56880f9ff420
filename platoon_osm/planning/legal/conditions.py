"""Sentences on what a result under driving rules holds for."""

from __future__ import annotations

from ..best import WAITING_FREE
from ..question import Question

__all__ = [
    "ALL_TOGETHER", "MEMBERS", "STANDS_FOR_LAW", "STANDS_LONGER", "STOPPED", "of_every_curve",
    "of_every_plan",
]  # fmt: skip

STANDS_FOR_LAW = "which stands for its breaks and rests alone, once more than it needs at most"
STANDS_LONGER = (
    "which stands for its breaks and rests, once more than it needs at most, as long as it likes"
)
WHOLE_SECONDS = "times in whole seconds"
MEMBERS = "members pay least in all, and what masters gain is counted then"
ALL_TOGETHER = "members and master pay least in all"
NOT_PRICED = "waiting and delay cost nothing here"
STOPPED = "the search ended before all was compared"


def of_every_plan(question: Question) -> tuple[str, ...]:
    """Return what every result under a question's driving rules holds for.

    Parameters
    ----------
    question : Question
        What is asked.

    Returns
    -------
    tuple of str
        Sentences.
    """
    prices = question.time_prices
    rules = f"driving rules {question.problem.rules.name}"
    free = () if prices.waiting else (WAITING_FREE,)
    return (rules, WHOLE_SECONDS, *free)


def of_every_curve(question: Question) -> tuple[str, ...]:
    """Return what curves and frontiers under a question's driving rules hold for.

    Parameters
    ----------
    question : Question
        What is asked.

    Returns
    -------
    tuple of str
        Sentences; curves know no prices of time.
    """
    priced = () if question.time_prices.are_free else (NOT_PRICED,)
    return (*of_every_plan(question), *priced)
