"""Which reading comes closest to the paper's numbers, and what no reading reaches."""

from __future__ import annotations

import itertools
from collections.abc import Mapping, Sequence
from dataclasses import astuple, dataclass

from ..errors import ScenarioError
from ..planning.routers import Method
from ..report.language.speech import say
from .comparison import PRINTED, Printed, Row, labels
from .measures import INVOLVEMENTS, TOTALS, Estimate
from .monte_carlo import StudyResult
from .readings import alone_per_metre
from .wording import figure, joined, percent, summed

__all__ = ["COSTS_OF", "Whole", "agreement", "conclusions", "verdict"]

COSTS_OF = {"members": "study.costs-members", "system": "study.costs-system"}
MIXING = {"printed": "study-verdict.printed", "gain": "study-verdict.gain"}
RULES = {"astar": "study-verdict.again", "astar-closed-once": "study-verdict.once"}
WHO = {
    "joined": "study-verdict.joins",
    "merges and separates": "study-verdict.merges",
    "inside the master's route": "study-verdict.inside",
}


@dataclass(frozen=True, slots=True)
class Whole:
    """A whole reading, and how far its numbers are from the four printed percentages.

    Attributes
    ----------
    away : float
        Mean distance in percentage points.
    network, mixing, terms : str
        As in `Row`.
    total : {"members", "system"}
        Whose cost.
    counted : str
        Who counts as taking part.
    astar : {"astar", "astar-closed-once"}
        Which A*.
    numbers : mapping of str to Estimate
        By key of `PRINTED`.
    """

    away: float
    network: str
    mixing: str
    terms: str
    total: str
    counted: str
    astar: Method
    numbers: Mapping[str, Estimate]


def agreement(rows: Sequence[Row]) -> list[Whole]:
    """Rank whole readings by their mean distance from the four printed percentages.

    A reading is a placing of vehicles, a mixing, terms, a total, a way to count who takes part and
    a rule of A*; its savings are Dijkstra's, as in the paper. Readings for which a number is
    missing are left out.

    Parameters
    ----------
    rows : sequence of Row
        Of `compare`.

    Returns
    -------
    list of Whole
        Best first.
    """
    at = {(r.number, r.network, r.mixing, r.terms, r.counted, r.method): r.ours for r in rows}
    placed = dict.fromkeys((r.network, r.mixing, r.terms) for r in rows)
    rules = dict.fromkeys(r.method for r in rows if r.method != "dijkstra")
    ranked = []
    for place, total, counted, rule in itertools.product(placed, TOTALS, INVOLVEMENTS, rules):
        numbers = {
            "point": at.get(("point", *place, total, "dijkstra")),
            "mean": at.get(("mean", *place, total, "dijkstra")),
            "dijkstra": at.get(("dijkstra", *place, counted, "dijkstra")),
            "astar": at.get(("astar", *place, counted, rule)),
        }
        known = {name: ours for name, ours in numbers.items() if ours is not None}
        if len(known) == len(numbers):
            away = sum(abs(v.value - PRINTED[n].value[0]) for n, v in known.items()) / 4
            network, mixing, terms = place
            ranked.append(Whole(away, network, mixing, terms, total, counted, rule, known))
    return sorted(ranked, key=lambda one: astuple(one)[:-1])


def verdict(rows: Sequence[Row], results: Sequence[StudyResult] = ()) -> str:
    """Say in one paragraph which reading agrees best and what cannot be reproduced.

    Parameters
    ----------
    rows : sequence of Row
        Of `compare`.
    results : sequence of StudyResult
        The studies, to say what no draw of theirs could give.

    Returns
    -------
    str
        Plain text.

    Raises
    ------
    ScenarioError
        As in `conclusions`.
    """
    return " ".join(conclusions(rows, results))


def conclusions(rows: Sequence[Row], results: Sequence[StudyResult] = ()) -> list[str]:
    """Return what `verdict` says, sentence by sentence.

    Parameters
    ----------
    rows : sequence of Row
        Of `compare`.
    results : sequence of StudyResult
        The studies.

    Returns
    -------
    list of str
        In the language that is spoken.

    Raises
    ------
    ScenarioError
        No row at all.
    """
    if not rows:
        raise ScenarioError("comparison: no study to compare")
    ranked = agreement(rows)
    text = _closest(ranked, labels(results)) if ranked else []
    for number, printed in PRINTED.items():
        of = [row for row in rows if row.number == number]
        if number != "astar":
            # The paper's savings and surfaces are Dijkstra's.
            of = [row for row in of if row.method == "dijkstra"]
        if of:
            text.append(_over_all(printed, of))
    return text + _beyond_reach(results)


def _closest(ranked: Sequence[Whole], placed: Mapping[str, str]) -> list[str]:
    """Say which reading comes closest, and how many give all four numbers."""
    best = ranked[0]
    shown = "; ".join(
        say(
            "study-verdict.number",
            label=PRINTED[name].label,
            ours=percent(ours.value, 1),
            paper=percent(PRINTED[name].value[0]),
        )
        for name, ours in best.numbers.items()
    )
    every = sum(
        all(ours.covers(PRINTED[n].value[0]) for n, ours in one.numbers.items()) for one in ranked
    )
    return [
        say(
            "study-verdict.closest",
            readings=figure(len(ranked)),
            place=placed.get(best.network, best.network),
            mixing=say(MIXING[best.mixing], terms=summed(best.terms, "study-verdict.plus")),
            costs=say(COSTS_OF[best.total]),
            who=say(WHO[best.counted]),
            rule=say(RULES[best.astar]),
        ),
        say("study-verdict.gives", numbers=shown, away=figure(best.away, 1)),
        say("study-verdict.after-the-fact"),
        say("study-verdict.all-four", count=_count(every)),
    ]


def _over_all(printed: Printed, of: Sequence[Row]) -> str:
    """Say between what values a printed number lies over all readings, and how many agree."""
    good = sum(row.agrees() for row in of)
    if len(printed.value) > 1:
        found = say("study-verdict.in-range", count=_count(good))
    elif good < 2:
        found = say("study-verdict.holds", count=_count(good))
    else:
        found = say("study-verdict.hold", count=_count(good))
    return say(
        "study-verdict.number-over-all",
        label=printed.label[0].upper() + printed.label[1:],
        paper=_in_unit(joined("study.to", map(figure, printed.value)), printed.unit),
        low=figure(min(row.ours.value for row in of), 1),
        high=_in_unit(figure(max(row.ours.value for row in of), 1), printed.unit),
        readings=figure(len(of)),
        found=found,
    )


def _in_unit(value: str, unit: str) -> str:
    return say("study.percent", value=value) if unit == "%" else f"{value} {unit}"


def _beyond_reach(results: Sequence[StudyResult]) -> list[str]:
    """Say under which sums of terms no draw could stay below the end of the paper's surfaces."""
    most = PRINTED["alone"].value[1]
    text = []
    for terms in dict.fromkeys(terms for r in results for terms in r.study.terms):
        least = [
            alone_per_metre(r.study.costs, terms) * r.study.network.min_route_m / 1000
            for r in results
            if getattr(r.study.network, "route_length", "network") == "network"
        ]
        if least and len(least) == len(results) and min(least) > most:
            text.append(
                say(
                    "study-verdict.beyond",
                    terms=summed(terms, "study-verdict.plus"),
                    least=figure(min(least), 0),
                    most=figure(most),
                )
            )
    return text


def _count(number: int) -> str:
    return say("study-verdict.none") if number == 0 else figure(number)
