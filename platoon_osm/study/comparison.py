"""Every number the paper prints of its experiment, beside ours under each reading.

References
----------
.. [1] Adas et al., "Joint travel route optimization", IFAC 2025.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from ..errors import ScenarioError
from ..planning.routers import Method
from .measures import INVOLVEMENTS, TOTALS, Estimate, Measures
from .monte_carlo import StudyResult
from .random_network import RandomNetwork

__all__ = ["PRINTED", "Printed", "Row", "agreement", "compare", "network_label", "verdict"]


@dataclass(frozen=True, slots=True)
class Printed:
    """A number of [1]_.

    Attributes
    ----------
    label : str
        What it is.
    value : tuple of float
        In `unit`; a range for the axis of the cost surfaces.
    unit : {"%", "km"}
        Of `value`.
    """

    label: str
    value: tuple[float, ...]
    unit: str


PRINTED: Mapping[str, Printed] = {
    "point": Printed("saving at tau = 100 %, xi = 18 %", (8.0,), "%"),
    "mean": Printed("mean saving", (14.0,), "%"),
    "dijkstra": Printed("mean involvement, Dijkstra", (33.0,), "%"),
    "astar": Printed("mean involvement, A*", (39.0,), "%"),
    "alone": Printed("cost of a vehicle alone", (1150.0, 1400.0), "km"),
    "joint low": Printed("joint cost, least over the grid", (1150.0, 1400.0), "km"),
    "joint high": Printed("joint cost, greatest over the grid", (1150.0, 1400.0), "km"),
}


@dataclass(frozen=True, slots=True)
class Row:
    """One printed number under one reading.

    Attributes
    ----------
    number : str
        Key of `PRINTED`.
    network : str
        How vehicles are placed; see `network_label`.
    mixing : {"printed", "gain"}
        Reading of eq. 13.
    counted : str
        Whose cost, or who counts as taking part.
    method : {"dijkstra", "astar"}
        How routes are found.
    ours : Estimate
        In the unit of the printed number.
    """

    number: str
    network: str
    mixing: str
    counted: str
    method: Method
    ours: Estimate

    def agrees(self) -> bool:
        """Tell whether the interval holds the printed number, or lies in the printed range.

        Returns
        -------
        bool
            For a range our value decides, without its interval.
        """
        printed = PRINTED[self.number].value
        if len(printed) == 1:
            return self.ours.covers(printed[0])
        return printed[0] <= self.ours.value <= printed[1]


def network_label(result: StudyResult) -> str:
    """Return how a study's vehicles are placed, in a few words.

    Parameters
    ----------
    result : StudyResult
        Of any study.

    Returns
    -------
    str
        Such as "200 km, points in the circle".
    """
    network = result.study.network
    km = f"{network.spawn_diameter_m / 1000:g} km"
    if not isinstance(network, RandomNetwork):
        drawn = "by flows" if network.flows else "by distance"
        return f"{network.net.source.name}, {km}, {drawn}"
    return f"{km}, {'points' if network.spawning == 'points' else 'nodes'} in the circle"


def compare(results: Sequence[StudyResult]) -> list[Row]:
    """Return all printed numbers under all readings of some studies, in a fixed order.

    Parameters
    ----------
    results : sequence of StudyResult
        One for each placing of the vehicles.

    Returns
    -------
    list of Row
        Study by study, method by method, mixing by mixing.
    """
    rows: list[Row] = []
    for result in results:
        label, study = network_label(result), result.study
        for k, method in enumerate(study.methods):
            for x, mixing in enumerate(study.mixings):
                found = Measures(result, k, x)
                for total in TOTALS:
                    least, most = found.joint_range(total)
                    numbers = {
                        "point": _times(found.saving_at(total, 1.0, 0.18), 100),
                        "mean": _times(found.mean_saving(total), 100),
                        "alone": _times(found.cost_alone(total), 1e-3),
                        "joint low": _times(least, 1e-3),
                        "joint high": _times(most, 1e-3),
                    }
                    rows += [
                        Row(number, label, mixing, total, method, ours)
                        for number, ours in numbers.items()
                    ]
                rows += [
                    Row(method, label, mixing, name, method,
                        _times(found.mean_involvement(name), 100))
                    for name in INVOLVEMENTS
                ]  # fmt: skip
    return rows


def _times(estimate: Estimate, factor: float) -> Estimate:
    return Estimate(estimate.value * factor, estimate.low * factor, estimate.high * factor)


def agreement(rows: Sequence[Row]) -> list[tuple[float, str, str, str, str, dict[str, Estimate]]]:
    """Rank whole readings by their mean distance from the four printed percentages.

    A reading is a placing of vehicles, a mixing, a total and a way to count who takes part; its
    savings are Dijkstra's, as in the paper. Readings for which a number is missing are left out.

    Parameters
    ----------
    rows : sequence of Row
        Of `compare`.

    Returns
    -------
    list of tuple
        (mean distance in percentage points, network, mixing, total, involvement, numbers), best
        first.
    """
    at = {(r.number, r.network, r.mixing, r.counted, r.method): r.ours for r in rows}
    ranked = []
    placed = dict.fromkeys((r.network, r.mixing) for r in rows)
    for network, mixing in placed:
        for total in TOTALS:
            for counted in INVOLVEMENTS:
                numbers = {
                    "point": at.get(("point", network, mixing, total, "dijkstra")),
                    "mean": at.get(("mean", network, mixing, total, "dijkstra")),
                    "dijkstra": at.get(("dijkstra", network, mixing, counted, "dijkstra")),
                    "astar": at.get(("astar", network, mixing, counted, "astar")),
                }
                known = {name: ours for name, ours in numbers.items() if ours is not None}
                if len(known) < len(numbers):
                    continue
                away = sum(abs(v.value - PRINTED[n].value[0]) for n, v in known.items()) / 4
                ranked.append((away, network, mixing, total, counted, known))
    return sorted(ranked, key=lambda item: item[:5])


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
        away, network, mixing, total, counted, numbers = ranked[0]
        shown = ", ".join(
            f"{PRINTED[name].label} {ours.value:.1f} % (paper {PRINTED[name].value[0]:g} %)"
            for name, ours in numbers.items()
        )
        text.append(
            f"Of {len(ranked)} readings the one closest to the four printed percentages is: "
            f"vehicles at {network}; {mixing} mixing; costs of "
            f"{'the members' if total == 'members' else 'members and master'}; involved is who "
            f"{_who(counted)}. It gives {shown}, on average {away:.1f} points away. It was picked "
            "after the fact, so it describes the paper's numbers; it does not confirm them."
        )
        both = sum(
            all(ours.covers(PRINTED[n].value[0]) for n, ours in item[5].items()) for item in ranked
        )
        text.append(
            f"All four numbers lie within the 95 % intervals of {_count(both)} of these readings."
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
            f"{low:.1f} to {high:.1f} {printed.unit} over {len(of)} readings, {found}"
        )
    least = [
        r.study.costs.solo_factor() * r.study.network.min_route_m / 1000
        for r in results
        if getattr(r.study.network, "route_length", "network") == "network"
    ]
    most = PRINTED["alone"].value[1]
    if least and len(least) == len(results) and min(least) > most:
        text.append(
            f"No draw could: by eq. 12 a vehicle alone pays {min(least):.0f} km for the minimum "
            f"route already, more than the {most:g} km at which the paper's surfaces end."
        )
    return " ".join(text)


def _who(counted: str) -> str:
    return {
        "joined": "joins at all",
        "merges and separates": "truly merges and truly separates",
    }.get(counted, "truly merges and separates inside the master's route")


def _count(number: int) -> str:
    return "none" if number == 0 else str(number)
