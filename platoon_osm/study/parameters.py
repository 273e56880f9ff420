"""The parameters of a study in words, with their units."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import fields

from ..shown_text import shown
from .monte_carlo import StudyResult
from .random_network import RandomNetwork
from .settings import Study
from .shown_tables import CALLED, MIXED

__all__ = ["parameters_in_words"]

CASES = {
    "A": "A: members merge and stay",
    "B": "B: all start together, members separate",
    "C": "C: members merge and separate",
}
COSTS = {
    "fuel_saving": ("Fuel saved in a platoon", 100, "%"),
    "speed_kmh": ("Cruising speed", 1, "km/h"),
    "fuel_l_per_100km": ("Fuel alone", 1, "l per 100 km"),
    "rest_s": ("A rest takes", 1 / 60, "min"),
    "driving_s": ("Driving in a day", 1 / 3600, "h"),
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
        ("Draws of each placing, and their seed", f"{study.runs}, seed {results[0].seed}"),
        ("Case of the paper", CASES[study.case]),
        ("Routes are found by", "; ".join(CALLED[method] for method in study.methods)),
        ("Weight of time in a platoon, tau", _axis(study.tau)),
        ("Weight of fuel in a platoon, xi", _axis(study.xi)),
        *(
            ("Looked at besides", f"tau {100 * tau:g} %, xi {100 * xi:g} %")
            for tau, xi in study.points
        ),
        ("Tau and xi are read", ", ".join(MIXED[mixing] for mixing in study.mixings)),
        ("Costs add up", "; ".join(terms.replace("+", " + ") for terms in study.terms)),
        *(
            (label, f"{factor * getattr(study.costs, field.name):.4g} {unit}")
            for field in fields(study.costs)
            if field.name in COSTS
            for label, factor, unit in [COSTS[field.name]]
        ),
    ]


def _of_networks(studies: Sequence[Study]) -> list[tuple[str, str]]:
    network = studies[0].network
    km = ", ".join(
        f"{metres / 1000:g}"
        for metres in dict.fromkeys(study.network.spawn_diameter_m for study in studies)
    )
    common = [
        ("Vehicles, with the master", f"{network.vehicles}"),
        ("They start in a circle of", f"{km} km across"),
        ("Least length of a route", f"{network.min_route_m / 1000:g} km"),
    ]
    if not isinstance(network, RandomNetwork):
        drawn = f"by volumes of {shown(network.flows.name)}" if network.flows else "by distance"
        return [("Network", shown(network.net.source.name)), ("Trips are drawn", drawn), *common]
    spawning = dict.fromkeys(
        study.network.spawning for study in studies if isinstance(study.network, RandomNetwork)
    )
    return [
        (
            "Network",
            f"{network.nodes} nodes in {network.width_m / 1000:g} x {network.height_m / 1000:g} km",
        ),
        (
            "Roads",
            f"the {network.edges} "
            f"{'shortest' if network.pruning == 'shortest' else 'randomly chosen'} "
            f"{'one-way' if network.directed else 'two-way'} edges, each dropped with "
            f"{100 * network.dropout:g} % probability",
        ),
        (
            "Connected must be",
            "the whole network"
            if network.connected == "whole"
            else "the part that trips are drawn on",
        ),
        *common,
        (
            "They start at",
            " or ".join(
                f"any point, which leads to the {network.access_nodes} nearest nodes"
                if one == "points"
                else "a node"
                for one in spawning
            ),
        ),
        (
            "The least length is that of",
            "the shortest route" if network.route_length == "network" else "the straight line",
        ),
    ]


def _axis(values: Sequence[float]) -> str:
    if len(values) == 1:
        return f"{100 * values[0]:g} %"
    return f"{100 * values[0]:g} to {100 * values[-1]:g} %, {len(values)} values"
