"""The answer of a study in one short paragraph: what was asked, what came out, does it agree."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Literal

from ..report.language.speech import number, say
from ..shown_text import shown
from .comparison import PRINTED, Row, labels
from .monte_carlo import StudyResult
from .random_network import RandomNetwork
from .verdict import COSTS_OF, Whole, agreement
from .wording import figure, mixed, percent, summed

__all__ = ["Answer", "Number", "answer_of"]

Standing = Literal["all", "part", "none"]

ASTAR = {"astar": "study-answer.again", "astar-closed-once": "study-answer.once"}
COUNTED = {
    "joined": "study-answer.joined",
    "merges and separates": "study-answer.merges",
    "inside the master's route": "study-answer.inside",
}


@dataclass(frozen=True, slots=True)
class Number:
    """One printed number beside ours.

    Attributes
    ----------
    label : str
        What it is.
    paper, ours, interval : str
        What the paper prints, what came out, and its 95 % interval, with their unit; of several
        readings, the least and the greatest value and no interval.
    agrees : bool
        Whether the interval holds the printed number.
    """

    label: str
    paper: str
    ours: str
    interval: str
    agrees: bool


@dataclass(frozen=True, slots=True)
class Answer:
    """What a study comes to.

    Attributes
    ----------
    asked, found, reading : str
        What was done, what came out, and under which reading, in sentences.
    verdict : str
        In a few words.
    standing : {"all", "part", "none"}
        How much of what was compared agrees.
    numbers : tuple of Number
        The main ones.
    """

    asked: str
    found: str
    reading: str
    verdict: str
    standing: Standing
    numbers: tuple[Number, ...]


def answer_of(rows: Sequence[Row], results: Sequence[StudyResult]) -> Answer:
    """Return what a study comes to.

    Parameters
    ----------
    rows : sequence of Row
        Of `compare`.
    results : sequence of StudyResult
        The studies.

    Returns
    -------
    Answer
        Its texts are plain.
    """
    ranked = agreement(rows)
    return _of_closest(ranked, results) if ranked else _of_ranges(rows, results)


def _asked(results: Sequence[StudyResult]) -> str:
    study = results[0].study
    network, vehicles, runs = study.network, figure(study.network.vehicles), figure(study.runs)
    if isinstance(network, RandomNetwork):
        nodes = figure(network.nodes)
        return say(
            "study-answer.asked-random", n=study.runs, vehicles=vehicles, runs=runs, nodes=nodes
        )
    name = shown(network.net.source.name)
    return say("study-answer.asked-real", n=study.runs, vehicles=vehicles, runs=runs, name=name)


def _of_closest(ranked: Sequence[Whole], results: Sequence[StudyResult]) -> Answer:
    best = ranked[0]
    numbers = tuple(
        Number(
            _capital(PRINTED[name].label),
            percent(PRINTED[name].value[0]),
            percent(ours.value, 1),
            _between(ours.low, ours.high),
            ours.covers(PRINTED[name].value[0]),
        )
        for name, ours in best.numbers.items()
    )
    good = sum(one.agrees for one in numbers)
    whole = sum(
        all(ours.covers(PRINTED[name].value[0]) for name, ours in one.numbers.items())
        for one in ranked
    )
    standing: Standing = "part" if good else "none"
    if whole:
        standing = "all"
        verdict = say(
            "study-answer.agrees", n=whole, whole=number(whole), readings=number(len(ranked))
        )
    elif good:
        verdict = say("study-answer.agrees-in-part", good=good)
    else:
        verdict = say("study-answer.does-not-agree")
    values = {
        name: say(
            "study-answer.value",
            ours=percent(ours.value, 1),
            paper=percent(PRINTED[name].value[0]),
        )
        for name, ours in best.numbers.items()
    }
    reading = say(
        "study-answer.reading",
        place=labels(results)[best.network],
        mixing=mixed(best.mixing),
        costs=say(COSTS_OF[best.total]),
        terms=summed(best.terms),
        counted=say(COUNTED[best.counted]),
        rule=say(ASTAR[best.astar]),
    )
    found = say("study-answer.found", readings=number(len(ranked)), **values)
    return Answer(_asked(results), found, reading, verdict, standing, numbers)


def _of_ranges(rows: Sequence[Row], results: Sequence[StudyResult]) -> Answer:
    """Return the answer where not all of the four percentages were worked out."""
    numbers = []
    for name, printed in PRINTED.items():
        of = [row for row in rows if row.number == name]
        if not of or len(printed.value) > 1:
            continue
        low, high = (end(row.ours.value for row in of) for end in (min, max))
        good = any(row.agrees() for row in of)
        numbers.append(
            Number(
                _capital(printed.label), percent(printed.value[0]), _between(low, high), "", good
            )
        )
    reached = sum(one.agrees for one in numbers)
    return Answer(
        _asked(results),
        say("study-answer.ranges"),
        say("study-answer.ranges-reading"),
        say("study-answer.reached", n=reached, reached=reached, all=len(numbers)),
        "all" if reached == len(numbers) else "part" if reached else "none",
        tuple(numbers),
    )


def _between(low: float, high: float) -> str:
    return say("study-answer.between", low=figure(low, 1), high=percent(high, 1))


def _capital(text: str) -> str:
    return text[:1].upper() + text[1:]
