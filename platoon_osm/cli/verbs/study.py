"""`platoon-osm study`: the paper's experiment repeated, beside its numbers."""

from __future__ import annotations

from functools import partial
from typing import Any

import click

from ...errors import ScenarioError
from ...study.options import StudyOptions
from ..language import language_option
from ..options import FILE, SectionOption, Sections, was_given
from ..progress import counted

__all__ = ["verb"]

RUNS, RANDOM, REAL = "Options", "Random networks (Table 1)", "Real networks"


def _option(section: str, name: str, about: str, *short: str, kind: Any = None) -> click.Option:
    """Make an option of the study, whose default stands in `StudyOptions`."""
    default = getattr(StudyOptions(), name)
    names = (*short, f"--{name.replace('_', '-')}")
    return SectionOption(
        names, section, type=kind, default=default, is_flag=default is False, help=about
    )


def _one_of(*words: str) -> click.Choice[str]:
    return click.Choice(words)


@click.command(
    "study",
    cls=Sections,
    short_help="repeat the paper's experiment, beside its numbers",
    params=[
        _option(RUNS, "output", "Folder to write into.", "-o", kind=FILE),
        _option(RUNS, "runs", "Networks drawn for each reading."),
        _option(RUNS, "seed", "Of all draws."),
        _option(RUNS, "workers", "Processes; one for each core unless given.", kind=int),
        _option(RUNS, "method", "Any of dijkstra, astar, astar-closed-once."),
        _option(RUNS, "mixing", "printed, gain or both."),
        _option(RUNS, "terms", "What eq. 11 and 12 add up; figures show the first."),
        _option(RUNS, "case", "A, B or C."),
        _option(
            RUNS, "diameter_km", "Spawn circles; 1,200,400,600 unless given, 200 on a real network."
        ),
        _option(RUNS, "spawning", "points, nodes or both."),
        _option(RUNS, "vehicles", "N_v, with the master."),
        _option(RUNS, "min_route_km", "Minimum route."),
        _option(RUNS, "grid", "Values of tau and of xi in 0 to 1."),
        _option(
            RUNS,
            "table",
            kind=FILE,
            about="Markdown file in which to renew the table between <!-- study:begin --> and end.",
        ),
        _option(RANDOM, "nodes", "Nodes of a network."),
        _option(RANDOM, "edges", "Edges of a network."),
        _option(RANDOM, "dropout", "Probability with which each edge is dropped."),
        _option(RANDOM, "area_km", "Side of the square area."),
        _option(RANDOM, "pruning", "Which edges are kept.", kind=_one_of("shortest", "random")),
        _option(RANDOM, "directed", "One-way edges."),
        _option(RANDOM, "connected", "What must be connected.", kind=_one_of("whole", "part")),
        _option(RANDOM, "access_nodes", "Nodes a spawn point leads to."),
        _option(
            RANDOM,
            "route_length",
            "How a route's length is measured.",
            kind=_one_of("network", "straight"),
        ),
        _option(REAL, "network", "A bundled map's name or a file; trips are drawn on it instead."),
        _option(
            REAL, "flows", "traffic.csv of truck volumes, with segments.csv beside it.", kind=FILE
        ),
        _option(REAL, "classes", "Highway values to load, with commas."),
        _option(REAL, "country", "Whose truck speed limit applies."),
        _option(REAL, "infer_links", "Add likely connectors the map lacks."),
    ],
    epilog="""\b
Examples:
  platoon-osm study --runs 100 --seed 0 -o out/study
  platoon-osm study --method dijkstra --diameter-km 1 --spawning points -o out/quick
  platoon-osm study --network italy-motorways --diameter-km 200 --min-route-km 400 -o out/italy
  platoon-osm study --network italy-motorways --flows IT/traffic.csv -o out/italy-flows
  platoon-osm study --network NL/graph.graphml --flows NL/traffic.csv --min-route-km 150 -o out/nl
""",
)
@language_option
def verb(**chosen: Any) -> None:
    """Repeat the paper's Monte Carlo and put every number it prints beside ours.

    It does so under each reading of what the paper leaves open. Writes five figures (PNG, SVG,
    CSV), results.parquet, comparison.csv and report.html. A study that was interrupted goes on
    where it stopped.
    """
    from ...study.command import run_command

    _check_that_options_apply(click.get_current_context())
    run_command(StudyOptions(**chosen), click.echo, partial(counted, "networks"))


def _check_that_options_apply(ctx: click.Context) -> None:
    """Refuse options of random networks beside a real one, and the other way round."""
    real = bool(ctx.params["network"])
    for option in ctx.command.params:
        section = getattr(option, "section", None)
        on_random = section == RANDOM or option.name == "spawning"
        if option.name is None or option.name == "network" or not was_given(ctx, option.name):
            continue
        if real and on_random:
            raise ScenarioError(
                f"{option.opts[-1]}: is for random networks, and --network names a real one; "
                "leave one out"
            )
        if not real and section == REAL:
            raise ScenarioError(
                f"{option.opts[-1]}: is for a real network; name one with --network, or leave "
                "it out"
            )
