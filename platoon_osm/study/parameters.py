"""The parameters of a study in words, with their units."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import fields

from ..report.language.speech import say
from ..shown_text import shown
from .monte_carlo import StudyResult
from .random_network import RandomNetwork
from .settings import Study
from .wording import called, figure, joined, kilometres, mixed, percent, summed

__all__ = ["parameters_in_words"]

CASES = {
    "A": "study-parameters.case-a",
    "B": "study-parameters.case-b",
    "C": "study-parameters.case-c",
}
ROADS = {
    ("shortest", "two-way"): "study-parameters.shortest-two-way",
    ("shortest", "one-way"): "study-parameters.shortest-one-way",
    ("random", "two-way"): "study-parameters.random-two-way",
    ("random", "one-way"): "study-parameters.random-one-way",
}
COSTS = {
    "fuel_saving": ("study-parameters.fuel-saving", 100, "study.percent"),
    "speed_kmh": ("study-parameters.speed", 1, "study-parameters.km-h"),
    "fuel_l_per_100km": ("study-parameters.fuel", 1, "study-parameters.l-per-100-km"),
    "rest_s": ("study-parameters.rest", 1 / 60, "study-parameters.min"),
    "driving_s": ("study-parameters.driving", 1 / 3600, "study-parameters.h"),
}


def parameters_in_words(results: Sequence[StudyResult]) -> list[tuple[str, str]]:
    """Return what a study varied and kept.

    Parameters
    ----------
    results : sequence of StudyResult
        One for each placing of the vehicles.

    Returns
    -------
    list of (str, str)
        What it is, and its value with its unit.
    """
    study = results[0].study
    return [
        *_of_networks([result.study for result in results]),
        (
            say("study-parameters.draws"),
            say("study-parameters.draws-and-seed", runs=figure(study.runs), seed=results[0].seed),
        ),
        (say("study-parameters.case"), say(CASES[study.case])),
        (say("study-parameters.methods"), "; ".join(map(called, study.methods))),
        (say("study-parameters.tau"), _axis(study.tau)),
        (say("study-parameters.xi"), _axis(study.xi)),
        *(
            (
                say("study-parameters.besides"),
                say("study-parameters.point", tau=percent(100 * tau), xi=percent(100 * xi)),
            )
            for tau, xi in study.points
        ),
        (say("study-parameters.mixings"), ", ".join(map(mixed, study.mixings))),
        (say("study-parameters.terms"), "; ".join(map(summed, study.terms))),
        *(
            (say(label), say(unit, value=_rounded(factor * getattr(study.costs, field.name))))
            for field in fields(study.costs)
            if field.name in COSTS
            for label, factor, unit in [COSTS[field.name]]
        ),
    ]


def _of_networks(studies: Sequence[Study]) -> list[tuple[str, str]]:
    network = studies[0].network
    across = dict.fromkeys(study.network.spawn_diameter_m for study in studies)
    common = [
        (say("study-parameters.vehicles"), figure(network.vehicles)),
        (
            say("study-parameters.circle"),
            say("study-parameters.across", km=", ".join(map(kilometres, across))),
        ),
        (say("study-parameters.least-length"), f"{kilometres(network.min_route_m)} km"),
    ]
    if not isinstance(network, RandomNetwork):
        drawn = (
            say("study-parameters.by-volumes", name=shown(network.flows.name))
            if network.flows
            else say("study.by-distance")
        )
        return [
            (say("study-parameters.network"), shown(network.net.source.name)),
            (say("study-parameters.drawn"), drawn),
            *common,
        ]
    spawning = dict.fromkeys(
        study.network.spawning for study in studies if isinstance(study.network, RandomNetwork)
    )
    return [
        (say("study-parameters.network"), _size(network)),
        (say("study-parameters.roads"), _roads(network)),
        (
            say("study-parameters.connected"),
            say(
                "study-parameters.connected-whole"
                if network.connected == "whole"
                else "study-parameters.connected-part"
            ),
        ),
        *common,
        (
            say("study-parameters.start"),
            joined(
                "study-parameters.or",
                (
                    say("study-parameters.any-point", n=network.access_nodes)
                    if one == "points"
                    else say("study-parameters.a-node")
                    for one in spawning
                ),
            ),
        ),
        (
            say("study-parameters.length-of"),
            say(
                "study-parameters.shortest-route"
                if network.route_length == "network"
                else "study-parameters.straight-line"
            ),
        ),
    ]


def _size(network: RandomNetwork) -> str:
    return say(
        "study-parameters.size",
        nodes=figure(network.nodes),
        width=kilometres(network.width_m),
        height=kilometres(network.height_m),
    )


def _roads(network: RandomNetwork) -> str:
    kept = "shortest" if network.pruning == "shortest" else "random"
    way = "one-way" if network.directed else "two-way"
    return say(
        ROADS[kept, way], edges=figure(network.edges), dropout=percent(100 * network.dropout)
    )


def _rounded(value: float) -> str:
    return figure(float(f"{value:.4g}"))


def _axis(values: Sequence[float]) -> str:
    if len(values) == 1:
        return percent(100 * values[0])
    return say(
        "study-parameters.axis",
        low=figure(100 * values[0]),
        high=percent(100 * values[-1]),
        count=figure(len(values)),
    )
