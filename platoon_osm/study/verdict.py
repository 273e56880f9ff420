"""Which reading comes closest to the paper's numbers, and what no reading reaches."""

from __future__ import annotations

import itertools
from collections.abc import Mapping, Sequence
from dataclasses import astuple, dataclass

from ..errors import ScenarioError
from ..planning.routers import Method
from .comparison import PRINTED, Row, plain
from .measures import INVOLVEMENTS, TOTALS, Estimate
from .monte_carlo import StudyResult
from .readings import alone_per_metre

__all__ = ["Whole", "agreement", "verdict"]


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
        No row at all.
    """
    if not rows:
        raise ScenarioError("comparison: no study to compare")
    ranked = agreement(rows)
    text = []
    if ranked:
        best = ranked[0]
        shown = "; ".join(
            f"{PRINTED[name].label}: {ours.value:.1f} % (paper {PRINTED[name].value[0]:g} %)"
            for name, ours in best.numbers.items()
        )
        rule = "is opened again" if best.astar == "astar" else "is explored once"
        text.append(
            f"Of {len(ranked)} readings the one closest to the four printed percentages is: "
            f"vehicles at {best.network}; {best.mixing} mixing of {best.terms}; costs of "
            f"{'the members' if best.total == 'members' else 'members and master'}; involved is "
            f"who {_who(best.counted)}; under A* a node {rule}. It gives {shown}; on "
            f"average {best.away:.1f} points away. It was picked after the fact, so it describes "
            "the paper's numbers; it does not confirm them."
        )
        every = sum(
            all(ours.covers(PRINTED[n].value[0]) for n, ours in one.numbers.items())
            for one in ranked
        )
        text.append(
            f"All four numbers lie within the 95 % intervals of {_count(every)} of these readings."
        )
    for number, printed in PRINTED.items():
        of = [row for row in rows if row.number == number]
        if number != "astar":
            # The paper's savings and surfaces are Dijkstra's.
            of = [row for row in of if row.method == "dijkstra"]
        if not of:
            continue
        good = sum(row.agrees() for row in of)
        low, high = min(r.ours.value for r in of), max(r.ours.value for r in of)
        paper = " to ".join(f"{value:g}" for value in printed.value)
        if len(printed.value) > 1:
            found = f"{_count(good)} of them in that range."
        else:
            found = f"{_count(good)} of their 95 % intervals {'holds' if good < 2 else 'hold'} it."
        text.append(
            f"{printed.label[0].upper()}{printed.label[1:]} (paper {paper} {printed.unit}): ours "
            f"{plain(low, 1)} to {plain(high, 1)} {printed.unit} over {len(of)} readings, {found}"
        )
    text += _beyond_reach(results)
    return " ".join(text)


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
                f"With {terms} (eq. 11) no draw could: a vehicle alone pays {min(least):.0f} km "
                f"for the minimum route already, more than the {most:g} km at which the paper's "
                "surfaces end."
            )
    return text


def _who(counted: str) -> str:
    return {
        "joined": "joins at all",
        "merges and separates": "truly merges and truly separates",
    }.get(counted, "truly merges and separates inside the master's route")


def _count(number: int) -> str:
    return "none" if number == 0 else str(number)
