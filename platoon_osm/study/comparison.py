"""Every number the paper prints of its experiment, beside ours under each reading.

References
----------
.. [1] Adas et al., "Joint travel route optimization", IFAC 2025.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from ..planning.routers import Method
from ..report.language.speech import say, speaking
from ..shown_text import shown
from .measures import INVOLVEMENTS, TOTALS, Estimate, Measures
from .monte_carlo import StudyResult
from .random_network import RandomNetwork
from .wording import kilometres

__all__ = ["PRINTED", "Printed", "Row", "compare", "labels", "network_label", "placing"]


@dataclass(frozen=True, slots=True)
class Printed:
    """A number of [1]_.

    Attributes
    ----------
    key : str
        Of the catalogue: what it is.
    value : tuple of float
        In `unit`; a range for the axis of the cost surfaces.
    unit : {"%", "km"}
        Of `value`.
    """

    key: str
    value: tuple[float, ...]
    unit: str

    @property
    def label(self) -> str:
        """What it is, in the language that is spoken."""
        return say(self.key)


PRINTED: Mapping[str, Printed] = {
    "point": Printed("study.point", (8.0,), "%"),
    "mean": Printed("study.mean", (14.0,), "%"),
    "dijkstra": Printed("study.involved-dijkstra", (33.0,), "%"),
    "astar": Printed("study.involved-astar", (39.0,), "%"),
    "alone": Printed("study.cost-alone", (1150.0, 1400.0), "km"),
    "joint low": Printed("study.cost-least", (1150.0, 1400.0), "km"),
    "joint high": Printed("study.cost-greatest", (1150.0, 1400.0), "km"),
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
        Reading of tau and xi in eq. 12.
    terms : str
        Which terms eq. 11 and 12 add up.
    counted : str
        Whose cost, or who counts as taking part.
    method : {"dijkstra", "astar", "astar-closed-once"}
        How routes are found.
    ours : Estimate
        In the unit of the printed number.
    """

    number: str
    network: str
    mixing: str
    terms: str
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
    """Return how a study's vehicles are placed, in English: as tables of data name it.

    Parameters
    ----------
    result : StudyResult
        Of any study.

    Returns
    -------
    str
        Such as "200 km, points in the circle".
    """
    with speaking("en"):
        return placing(result)


def placing(result: StudyResult, *, short: bool = False) -> str:
    """Return how a study's vehicles are placed, in the language that is spoken.

    Parameters
    ----------
    result : StudyResult
        Of any study.
    short : bool
        Whether it stands in lines above each other, over a narrow panel.

    Returns
    -------
    str
        Such as "200 km, points in the circle".
    """
    network = result.study.network
    km = f"{kilometres(network.spawn_diameter_m)} km"
    if isinstance(network, RandomNetwork):
        start = say("study.points" if network.spawning == "points" else "study.nodes")
        return f"{km}\n{start}" if short else say("study.circle", km=km, start=start)
    drawn = say("study.by-flows" if network.flows else "study.by-distance")
    label = f"{shown(network.net.source.name)}, {km}, {drawn}"
    return label.replace(", ", "\n") if short else label


def labels(results: Sequence[StudyResult]) -> dict[str, str]:
    """Return what to call the placings in the language that is spoken.

    Parameters
    ----------
    results : sequence of StudyResult
        One for each placing of the vehicles.

    Returns
    -------
    dict of str to str
        By `Row.network`.
    """
    return {network_label(result): placing(result) for result in results}


def compare(results: Sequence[StudyResult]) -> list[Row]:
    """Return all printed numbers under all readings of some studies, in a fixed order.

    Parameters
    ----------
    results : sequence of StudyResult
        One for each placing of the vehicles.

    Returns
    -------
    list of Row
        Study by study, method by method, reading by reading.
    """
    rows: list[Row] = []
    for result in results:
        label, study = network_label(result), result.study
        for k, method in enumerate(study.methods):
            for x, (mixing, terms) in enumerate((r.mixing, r.terms) for r in study.readings):
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
                        Row(number, label, mixing, terms, total, method, ours)
                        for number, ours in numbers.items()
                    ]
                rows += [
                    Row(
                        "dijkstra" if method == "dijkstra" else "astar", label, mixing, terms,
                        name, method, _times(found.mean_involvement(name), 100),
                    )
                    for name in INVOLVEMENTS
                ]  # fmt: skip
    return rows


def _times(estimate: Estimate, factor: float) -> Estimate:
    return Estimate(estimate.value * factor, estimate.low * factor, estimate.high * factor)
