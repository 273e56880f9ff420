"""Every number the paper prints of its experiment, beside ours under each reading.

References
----------
.. [1] Adas et al., "Joint travel route optimization", IFAC 2025.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from ..planning.routers import Method
from ..shown_text import shown
from .measures import INVOLVEMENTS, TOTALS, Estimate, Measures
from .monte_carlo import StudyResult
from .random_network import RandomNetwork

__all__ = ["PRINTED", "Printed", "Row", "compare", "network_label", "plain"]


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
        return f"{shown(network.net.source.name)}, {km}, {drawn}"
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


def plain(value: float, digits: int) -> str:
    """Return a number with so many digits, never "-0.0".

    Parameters
    ----------
    value : float
        Any.
    digits : int
        After the point.

    Returns
    -------
    str
        The text.
    """
    return f"{round(value, digits) + 0.0:.{digits}f}"
