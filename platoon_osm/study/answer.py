"""The answer of a study in one short paragraph: what was asked, what came out, does it agree."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Literal

from ..shown_text import shown
from .comparison import PRINTED, Row, plain
from .monte_carlo import StudyResult
from .random_network import RandomNetwork
from .shown_tables import MIXED
from .verdict import Whole, agreement

__all__ = ["Answer", "Number", "answer_of"]

Standing = Literal["all", "part", "none"]

ASTAR = {"astar": "opens nodes again", "astar-closed-once": "explores each node once"}
COUNTED = {
    "joined": "whoever joins counts as involved",
    "merges and separates": "who truly merges and separates counts as involved",
    "inside the master's route":
        "who truly merges and separates inside the master's route counts as involved",
}  # fmt: skip


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
    network, runs = study.network, study.runs
    if isinstance(network, RandomNetwork):
        where = f"on {runs} random networks of {network.nodes} nodes"
    else:
        where = f"in {runs} draws on {shown(network.net.source.name)}"
    return (
        f"{network.vehicles} vehicles were planned {where}: alone, and together with the one of "
        "the longest route, as in the paper."
    )


def _of_closest(ranked: Sequence[Whole], results: Sequence[StudyResult]) -> Answer:
    best = ranked[0]
    numbers = tuple(
        Number(
            _capital(PRINTED[name].label),
            f"{PRINTED[name].value[0]:g} %",
            f"{plain(ours.value, 1)} %",
            f"{plain(ours.low, 1)} to {plain(ours.high, 1)} %",
            ours.covers(PRINTED[name].value[0]),
        )
        for name, ours in best.numbers.items()
    )
    good = sum(number.agrees for number in numbers)
    whole = sum(
        all(ours.covers(PRINTED[name].value[0]) for name, ours in one.numbers.items())
        for one in ranked
    )
    standing: Standing = "part" if good else "none"
    if whole:
        standing = "all"
        verdict = f"Agrees: {whole} of {len(ranked):,} readings give all four numbers"
    elif good:
        verdict = f"Agrees in part: {good} of 4 numbers at the best, in no reading all four"
    else:
        verdict = "Does not agree: the closest reading gives none of the four numbers"
    values = {
        name: f"{plain(ours.value, 1)} % (paper {PRINTED[name].value[0]:g} %)"
        for name, ours in best.numbers.items()
    }
    found = (
        f"In the closest of {len(ranked):,} readings of what the paper leaves open, company saves "
        f"{values['point']} at tau = 100 % and xi = 18 %, and {values['mean']} on average over "
        f"tau and xi; {values['dijkstra']} of the members take part by Dijkstra and "
        f"{values['astar']} by A*."
    )
    reading = (
        f"That reading: vehicles at {best.network}; tau and xi {MIXED[best.mixing]}; "
        f"costs of {'the members' if best.total == 'members' else 'members and master'}, "
        f"{best.terms.replace('+', ' + ')}; {COUNTED[best.counted]}; A* {ASTAR[best.astar]}. It "
        "was picked after the fact, so it describes the paper's numbers and does not confirm them."
    )
    return Answer(_asked(results), found, reading, verdict, standing, numbers)


def _of_ranges(rows: Sequence[Row], results: Sequence[StudyResult]) -> Answer:
    """Return the answer where not all of the four percentages were worked out."""
    numbers = []
    for name, printed in PRINTED.items():
        of = [row for row in rows if row.number == name]
        if not of or len(printed.value) > 1:
            continue
        low, high = (plain(end(row.ours.value for row in of), 1) for end in (min, max))
        good = any(row.agrees() for row in of)
        numbers.append(
            Number(
                _capital(printed.label), f"{printed.value[0]:g} %", f"{low} to {high} %", "", good
            )
        )
    reached = sum(number.agrees for number in numbers)
    return Answer(
        _asked(results),
        "Below are the least and the greatest value over all readings.",
        "A reading is judged as a whole only where Dijkstra and A* both ran.",
        f"{reached} of {len(numbers)} printed numbers lie in the interval of some reading",
        "all" if reached == len(numbers) else "part" if reached else "none",
        tuple(numbers),
    )


def _capital(text: str) -> str:
    return text[:1].upper() + text[1:]
